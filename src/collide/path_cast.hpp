// Where a curved path first meets a scene.
//
// What it models: a point or a sphere that moves along a path x(theta), 0 <= theta <= 1, and the first theta at which
// it
//   touches something.
// How: a path bends away from the chord of a part of it by no more than delta = M w^2 / 8, w the part's width in theta
//   and M a bound of |x''|. A sphere that is larger by delta, cast along the chord, meets nothing before the path does:
//   so far the path is clear, and there a shorter part begins, whose delta is smaller by the square. Where delta is
//   below what places are known to, the chord is the path.
// When it is wrong: M comes from five places of the path and is exact for cubics; a path that wriggles more than once
//   within them may touch something that is nearer than the wriggle is wide.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/assert.hpp"
#include "base/function_ref.hpp"
#include "collide/tube_casts.hpp"
#include "math/vec3.hpp"
#include "physim/scene.hpp"

namespace physim {

/// What the numbers of a type are apart at a place [m].
template <class S>
[[nodiscard]] double spacing_at(const Vec3d& x) {
  const double largest = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  return largest * static_cast<double>(std::numeric_limits<S>::epsilon());
}

/// So far outside of a surface something is put that goes on [m].
template <class S>
[[nodiscard]] double gap_at(const Vec3d& x) {
  return 1e-10 + 2 * spacing_at<S>(x);
}
/// Nearer to a surface, a contact with it lasts [m].
template <class S>
[[nodiscard]] double touch_at(const Vec3d& x) {
  return 4 * gap_at<S>(x);
}

}  // namespace physim

namespace physim::collide {

/// Where a path meets something.
struct PathHit {
  double theta = 0;
  SceneHit hit;
};

/// When a path is where: theta 0 at `start`, 1 after `span` [s].
struct PathTime {
  double start = 0;
  double span = 0;

  [[nodiscard]] SceneSegment chord(const Vec3d& from, const Vec3d& to, double radius, double at, double end) const {
    return {from, to, radius, start + at * span, (end - at) * span};
  }
};

/// A path by its places: theta gives one in W [m].
using PathPlaces = FunctionRef<Vec3d(double)>;

/// A bound of the second derivative of a path by theta: that at its inner places, and how far it may grow up to the
/// ends.
[[nodiscard]] double bend_of(const PathPlaces& path);

/// The first meeting of a path with a scene, up to `end`. `path(theta)` gives places in W, off by up to `rounding` [m].
/// All casts are made among what is near the path; those that follow a meeting may go on with it.
[[nodiscard]] std::optional<PathHit> first_meeting(TubeCasts& casts, double radius, const PathPlaces& path,
                                                   const PathTime& time, double end = 1, double rounding = 0);

}  // namespace physim::collide
