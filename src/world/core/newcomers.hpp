// Things of a scene that rows have not noticed yet.
#pragma once

#include <cstdint>

#include "world/core/box_groups.hpp"

namespace physim {

class SceneByMotion;

/// Things that came to where they rest since rows found out what is clear about them, by index.
class Newcomers {
 public:
  static constexpr std::size_t kMost = 1024;
  static constexpr std::uint64_t kQuiet = 256;  // after this number of steps without a new thing all rows look again

  /// One came, before a step; false where there are too many.
  [[nodiscard]] bool add(std::uint32_t thing, std::uint64_t step);
  void clear() { *this = {}; }
  [[nodiscard]] bool are_settled(std::uint64_t step) const { return !things_.empty() && step >= last_ + kQuiet; }
  /// Boxes that hold those of them that are still there.
  [[nodiscard]] const BoxGroups& boxes(const SceneByMotion& scene);

 private:
  std::vector<std::uint32_t> things_;  // in order
  std::uint64_t last_ = 0;             // step before which one came
  bool is_known_ = true;               // where they are
  BoxGroups boxes_;
};

}  // namespace physim
