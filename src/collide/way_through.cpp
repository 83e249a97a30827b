#include "collide/way_through.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "collide/path_cast.hpp"

namespace physim::collide {

std::optional<WayThrough> way_through(const Scene& scene, const SceneFilter& solids, const SceneHit& hit,
                                      const WayIn& in) {
  PHYSIM_ASSERT(std::abs(length(in.direction) - 1) < 1e-6);
  constexpr double kDeepest = 1000;  // [m]
  constexpr double kOne = 1e-9;      // thinner is nothing, and nearer is one [m]
  const WayThrough endless{0, in.touched, -hit.normal};
  if (!hit.entering) return endless;  // the back of a sheet
  const double back = kOne + 8 * spacing_at<double>(in.touched), far = kDeepest + back;
  // Behind that it is another part that is met [m]. From a skin it is farther to the surface where the way is flat.
  const double flat = std::max(-dot(in.direction, hit.normal), 0.02);
  const double latest = 1e-5 + 2 * in.radius + 2 * scene.skin() / flat;
  std::optional<double> begin;
  WayThrough through;
  int depth = 0;
  const SceneSegment line{in.touched - in.direction * back, in.touched + in.direction * kDeepest, 0, in.time, 0};
  for (const SceneHit& each : scene.all_hits(line, solids)) {
    if (each.instance != hit.instance) continue;
    PHYSIM_ASSERT(each.part >= 0 && each.part <= 1);
    const double at = std::max(each.part * far - back, 0.0);
    if (depth == 0 && (begin ? at > *begin + through.thickness + kOne : at > latest)) break;
    if (!begin && !each.entering && in.radius > 0) return endless;  // the back of a sheet that the ball's front passed
    if (!begin) begin = at, depth = each.entering ? 0 : 1;
    if (each.entering) {
      ++depth;
    } else if (depth > 0 && --depth == 0) {
      through = {std::max(at - *begin, kOne), each.position, each.normal};
    }
  }
  if (!begin) return std::nullopt;
  PHYSIM_ASSERT(depth > 0 || through.thickness >= kOne);
  return depth == 0 ? through : endless;
}

}  // namespace physim::collide
