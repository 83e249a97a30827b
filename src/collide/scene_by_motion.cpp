#include "collide/scene_by_motion.hpp"

#include <algorithm>

namespace physim {

bool SceneByMotion::has_boundless_movers() const {
  return std::ranges::any_of(content_.unbounded,
                             [&](std::uint32_t index) { return content_.instances[index].path != nullptr; });
}

void SceneByMotion::add_boxes_of_movers(std::vector<collide::Bounds>& boxes) const {
  for (const std::uint32_t index : content_.movers)
    boxes.push_back(content_.moving.box(content_.instances[index].leaf));
}

bool SceneByMotion::rests(std::uint32_t index) const {
  return index < content_.instances.size() && content_.instances[index].alive && !content_.instances[index].path;
}

std::optional<collide::Bounds> SceneByMotion::box_at_rest(std::uint32_t index) const {
  if (!rests(index)) return std::nullopt;
  const collide::Bounds own = collide::bounds_of(*content_.instances[index].shape);
  if (own.low.x > own.high.x) return std::nullopt;
  return content_.resting.box(index);
}

}  // namespace physim
