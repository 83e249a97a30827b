// Checker: refuses bad input with a place, a message and a hint.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "base/enumerators.hpp"
#include "base/text.hpp"
#include "physim/math.hpp"
#include "physim/result.hpp"

namespace physim {

inline bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Where input stands: a text, or an item of a list, with a text that is composed on demand.
class InputPlace {
 public:
  using Text = std::string_view;

  InputPlace(const char* whole) : whole_(whole) {}         // NOLINT: a text is a place
  InputPlace(Text whole) : whole_(whole) {}                // NOLINT
  InputPlace(const std::string& whole) : whole_(whole) {}  // NOLINT: must outlive this
  /// A member of it, as ".kind".
  InputPlace(Text whole, Text member) : whole_(whole), member_(member) {}
  /// list[item], or a member of it.
  InputPlace(Text list, std::size_t item, Text member = "") : whole_(list), item_(item), member_(member) {}

  [[nodiscard]] bool empty() const { return whole_.empty(); }
  [[nodiscard]] std::string text() const {
    std::string text(whole_);
    if (item_ != kNoItem) text.append("[").append(std::to_string(item_)).append("]");
    return text.append(member_);
  }

 private:
  static constexpr std::size_t kNoItem = std::numeric_limits<std::size_t>::max();
  Text whole_;
  std::size_t item_ = kNoItem;
  Text member_{};
};

/// Runs its checks in order and keeps the first that fails; all of them in a list where there is one for them. Places
/// and texts are put together only then, out of line: checks run for every flight and every shot of a batch.
class Checker {
 public:
  using Text = std::string_view;

  Checker() = default;
  explicit Checker(std::vector<Error>* all) : all_(all) {}

  PHYSIM_INLINE Checker& require(bool good, const auto& place, Text message, Text hint = "") {
    if (!good) fail(place, std::string(message), hint);
    return *this;
  }
  PHYSIM_INLINE Checker& positive(double x, const auto& place, Text hint = "") {
    if (!(x > 0 && x < kInfinity)) fail(place, "must be a positive number, not " + short_text(x), hint);
    return *this;
  }
  PHYSIM_INLINE Checker& not_negative(double x, const auto& place, Text hint = "") {
    if (!(x >= 0 && x < kInfinity)) fail(place, "must be zero or positive, not " + short_text(x), hint);
    return *this;
  }
  PHYSIM_INLINE Checker& is_number(double x, const auto& place) {
    if (!std::isfinite(x)) fail(place, "must be a finite number, not " + short_text(x), "");
    return *this;
  }
  PHYSIM_INLINE Checker& is_vector(const Vec3d& v, const auto& place) {
    return require(finite(v), place, "must have three finite components");
  }
  /// An enumerator: a cast can make other values, which tables must not be read by.
  template <class Enum>
  PHYSIM_INLINE Checker& named(Enum value, const auto& place) {
    return require(static_cast<std::size_t>(value) < kEnumerators<Enum>, place, "is none of the named values");
  }
  /// What another check said.
  Checker& also(Status other) {
    if (!other && all_ != nullptr) all_->push_back(other.error());
    if (status_) status_ = std::move(other);
    return *this;
  }
  [[nodiscard]] const Status& status_so_far() const { return status_; }
  [[nodiscard]] Status status() { return std::move(status_); }

 private:
  [[gnu::noinline]] void fail(const InputPlace& place, const std::string& message, Text hint) {
    PHYSIM_ASSERT(!place.empty());
    constexpr std::size_t kMost = 100;  // a report shows 20
    if (all_ != nullptr && all_->size() < kMost) all_->push_back({message, place.text(), std::string(hint)});
    if (status_) status_ = Error{message, place.text(), std::string(hint)};
  }
  std::vector<Error>* all_ = nullptr;
  Status status_;
};

}  // namespace physim
