// Checker: refuses bad input with a place, a message and a hint.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "physim/infinity.hpp"
#include "physim/result.hpp"
#include "physim/vec3.hpp"

namespace physim {

inline bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Runs its checks in order and keeps the first that fails. Texts are put together only then, out of line: checks run
/// for every shot of a batch.
class Checker {
 public:
  using Text = std::string_view;

  PHYSIM_INLINE Checker& require(bool good, Text place, Text message, Text hint = "") {
    if (!good) fail(place, std::string(message), hint);
    return *this;
  }
  PHYSIM_INLINE Checker& positive(double x, Text place, Text hint = "") {
    if (!(x > 0 && x < kInfinity)) fail(place, "must be a positive number, not " + short_text(x), hint);
    return *this;
  }
  PHYSIM_INLINE Checker& not_negative(double x, Text place, Text hint = "") {
    if (!(x >= 0 && x < kInfinity)) fail(place, "must be zero or positive, not " + short_text(x), hint);
    return *this;
  }
  PHYSIM_INLINE Checker& is_number(double x, Text place) {
    if (!std::isfinite(x)) fail(place, "must be a finite number, not " + short_text(x), "");
    return *this;
  }
  PHYSIM_INLINE Checker& is_vector(const Vec3d& v, Text place) {
    return require(finite(v), place, "must have three finite components");
  }
  /// An enumerator: a cast can make other values, which tables must not be read by. `last` is the last one.
  template <class Enum>
  PHYSIM_INLINE Checker& named(Enum value, Enum last, Text place) {
    return require(static_cast<unsigned>(value) <= static_cast<unsigned>(last), place, "is none of the named values");
  }
  /// What another check said.
  Checker& also(Status other) {
    if (status_) status_ = std::move(other);
    return *this;
  }
  [[nodiscard]] const Status& status_so_far() const { return status_; }
  [[nodiscard]] Status status() { return std::move(status_); }

 private:
  [[gnu::noinline]] void fail(Text place, const std::string& message, Text hint) {
    PHYSIM_ASSERT(!place.empty());
    if (status_) status_ = Error{message, std::string(place), std::string(hint)};
  }
  Status status_;
};

}  // namespace physim
