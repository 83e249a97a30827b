#include "world/core/box_groups.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace physim {

using collide::Bounds;

BoxGroups::BoxGroups(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {
  if (boxes_.empty()) return;
  groups_.push_back(group_of(0, boxes_.size()));
  std::vector<bool> is_whole{false};  // those that cannot be parted
  while (groups_.size() < kMost) {
    std::size_t largest = kMost;
    for (std::size_t i = 0; i < groups_.size(); ++i)
      if (!is_whole[i] && (largest == kMost || groups_[i].about.area() > groups_[largest].about.area())) largest = i;
    if (largest == kMost) return;
    if (part(largest))
      is_whole.push_back(false);
    else
      is_whole[largest] = true;
  }
}

BoxGroups::Group BoxGroups::group_of(std::size_t first, std::size_t end) const {
  PHYSIM_ASSERT(first < end && end <= boxes_.size());
  Group group{first, end};
  for (std::size_t i = first; i < end; ++i) group.about.take(boxes_[i]);
  return group;
}

/// Where it is longest, by the middles of its boxes.
bool BoxGroups::part(std::size_t index) {
  const auto [first, end, about] = groups_[index];
  Bounds middles;
  for (std::size_t i = first; i < end; ++i) middles.take(boxes_[i].middle());
  const Vec3d size = middles.high - middles.low, at = middles.middle();
  const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = boxes_.begin();
  const auto parted =
      std::partition(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                     [&](const Bounds& box) { return box.middle()[axis] < at[axis]; });
  const auto middle = static_cast<std::size_t>(parted - begin);
  if (middle == first || middle == end) return false;
  groups_[index] = group_of(first, middle);
  groups_.push_back(group_of(middle, end));
  return true;
}

bool BoxGroups::meets(const Bounds& box) const {
  return std::ranges::any_of(groups_, [&](const Group& group) {
    if (!group.about.meets(box)) return false;
    const auto begin = boxes_.begin();
    return std::any_of(begin + static_cast<std::ptrdiff_t>(group.first), begin + static_cast<std::ptrdiff_t>(group.end),
                       [&](const Bounds& own) { return own.meets(box); });
  });
}

}  // namespace physim
