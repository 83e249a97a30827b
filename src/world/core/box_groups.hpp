// Many boxes in a few groups, those of each near to each other, so that few comparisons show which rows avoid all.
#pragma once

#include <cstddef>
#include <vector>

#include "collide/bvh.hpp"

namespace physim {

class BoxGroups {
 public:
  static constexpr std::size_t kMost = 16;  // groups
  /// Boxes side by side in the list, and one about them.
  struct Group {
    std::size_t first = 0, end = 0;
    collide::Bounds about{};
  };

  BoxGroups() = default;
  /// Each box is in one group; their order follows from it.
  explicit BoxGroups(std::vector<collide::Bounds> boxes);

  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  /// Whether one of the boxes meets another one.
  [[nodiscard]] bool meets(const collide::Bounds& box) const;

 private:
  [[nodiscard]] Group group_of(std::size_t first, std::size_t end) const;
  /// Parts a group in two; false if it stays unchanged.
  bool part(std::size_t group);

  std::vector<collide::Bounds> boxes_;
  std::vector<Group> groups_;
};

}  // namespace physim
