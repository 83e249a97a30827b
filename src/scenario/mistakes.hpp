// Mistakes: the errors of a file, reported together.
#pragma once

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>
#include <vector>

#include "physim/result.hpp"

namespace physim {

/// Errors of a file, in the order of their places, each on its own line.
class Mistakes {
 public:
  static constexpr std::size_t kMost = 20;  // errors in the report

  /// `needs_all`: keys that tables lack are mistakes.
  explicit Mistakes(bool needs_all = true) : needs_all_(needs_all) {}
  [[nodiscard]] bool needs_all() const { return needs_all_; }

  /// Whether there was none. An error that is there already, as of a setting of several shots, is one.
  bool take(const Status& status) {
    if (status) return true;
    if (is_full()) return false;  // its report has no room
    const Error& error = status.error();
    const auto is_same = [&](const Error& other) {
      return other.place == error.place && other.message == error.message && other.hint == error.hint;
    };
    if (std::ranges::none_of(all_, is_same)) all_.push_back(error);
    return false;
  }
  /// True if there is a mistake at a place already.
  [[nodiscard]] bool has(const std::string& place) const {
    return std::ranges::find(all_, place, &Error::place) != all_.end();
  }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::size_t count() const { return all_.size(); }
  /// True if there are more errors than the report shows.
  [[nodiscard]] bool is_full() const { return all_.size() > kMost; }

  /// All as one error: the first, with the others on lines behind it.
  [[nodiscard]] Status status() const {
    if (all_.empty()) return {};
    std::vector<Error> sorted = all_;
    std::ranges::stable_sort(sorted, {}, [](const Error& error) { return place_in_file(error.place); });
    Error first = sorted.front();
    std::string& end = first.hint.empty() ? first.message : first.hint;
    for (std::size_t i = 1; i < std::min(sorted.size(), kMost); ++i) end += "\n" + sorted[i].text();
    if (is_full()) end += "\nerror: there are more mistakes";
    return first;
  }

 private:
  /// Line and column of "file:12:3"; other places come last.
  [[nodiscard]] static std::pair<long, long> place_in_file(const std::string& place) {
    constexpr std::pair<long, long> kLast = {1L << 30, 0};
    const std::size_t second = place.rfind(':');
    const std::size_t first = second == std::string::npos || second == 0 ? second : place.rfind(':', second - 1);
    if (second == std::string::npos || first == std::string::npos) return kLast;
    std::pair<long, long> at;
    const char *const begin = place.data(), *const end = begin + place.size();
    const auto line = std::from_chars(begin + first + 1, begin + second, at.first);
    const auto column = std::from_chars(begin + second + 1, end, at.second);
    const bool is_read = line.ec == std::errc() && line.ptr == begin + second && column.ec == std::errc();
    return is_read ? at : kLast;
  }

  bool needs_all_;
  std::vector<Error> all_;
};

}  // namespace physim
