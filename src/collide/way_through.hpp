// The straight way of a projectile through a thing of a scene: how thick that is there, and where it comes out.
#pragma once

#include <optional>

#include "physim/scene.hpp"

namespace physim::collide {

struct WayThrough {
  double thickness = 0;  // 0: a sheet, or it does not come out within the deepest that is looked at [m]
  Vec3d out, normal;     // where it comes out, and of the surface there
};

/// Something that begins to go into a thing.
struct WayIn {
  Vec3d touched;      // where it touches the thing [m]
  Vec3d direction;    // of length one
  double radius = 0;  // of a ball; 0: a point [m]
  double time = 0;    // of the scene [s]
};

/// Nothing where a ball only grazes an edge. Parts of a thing that touch or overlap are one where they are of one
/// material; else the way ends where the next one begins. `hit`: what it met.
[[nodiscard]] std::optional<WayThrough> way_through(const Scene& scene, const SceneFilter& solids, const SceneHit& hit,
                                                    const WayIn& in);

}  // namespace physim::collide
