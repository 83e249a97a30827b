#include "collide/scene_by_motion.hpp"

#include <algorithm>
#include <vector>

#include "collide/cast.hpp"

namespace physim {

bool SceneByMotion::has_boundless_movers() const {
  return std::ranges::any_of(content_.unbounded,
                             [&](std::uint32_t index) { return content_.instances[index].path != nullptr; });
}

void SceneByMotion::add_boxes_of_movers(std::vector<collide::Bounds>& boxes) const {
  for (const std::uint32_t index : content_.movers)
    boxes.push_back(content_.moving.box(content_.instances[index].leaf));
}

void SceneByMotion::each_beside(const Vec3d& point, double within, const SceneFilter& filter, double time,
                                FunctionRef<void(const SceneNearest&)> f) const {
  if (!collide::is_near(point) || !(within >= 0) || !collide::is_soon(time)) return;
  std::vector<SceneNearest> found;
  const auto look_at = [&](std::uint32_t index, double&) {
    if (const SceneNearest near = collide::nearest_thing(content_, index, point, within, filter, time))
      found.push_back(near);
  };
  double reach = within;
  for (const std::uint32_t index : content_.unbounded) look_at(index, reach);
  content_.resting.around(point, reach, look_at);
  collide::for_movers(
      content_, time, time, [&](const collide::Tree& tree) { tree.around(point, reach, look_at); },
      [&](std::uint32_t index) { look_at(index, reach); });
  std::ranges::sort(found, {}, [](const SceneNearest& near) { return near.instance.index; });
  for (const SceneNearest& near : found) f(near);
}

SceneByMotion::Ride SceneByMotion::ride(std::uint32_t index, double time) const {
  if (index >= content_.instances.size() || !content_.instances[index].path) return {};
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();  // steps end beside a key, not on it
  Ride ride;
  const collide::Path& path = *content_.instances[index].path;
  path.pieces(time + kRounding * std::abs(time), kInfinity, [&](const collide::Path::Piece& piece, double, double to) {
    ride = {path.carriage(), &piece, to - time};
    return false;
  });
  PHYSIM_ASSERT(ride.piece && ride.lasts > 0);
  return ride;
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
