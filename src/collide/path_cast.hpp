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

/// A bound of the second derivative of a path by theta: that at its inner places, and how far it may grow up to the
/// ends.
template <class Path>
[[nodiscard]] double bend_of(const Path& path) {
  constexpr int kPlaces = 5;
  constexpr double kWidth = 1.0 / (kPlaces - 1);
  Vec3d x[kPlaces];
  for (int i = 0; i < kPlaces; ++i) x[i] = path(i * kWidth);
  Vec3d bend[kPlaces - 2];
  double most = 0, change = 0;
  for (int i = 0; i < kPlaces - 2; ++i) {
    bend[i] = (x[i] - x[i + 1] * 2.0 + x[i + 2]) * (1 / (kWidth * kWidth));
    most = std::max(most, length(bend[i]));
    if (i > 0) change = std::max(change, length(bend[i] - bend[i - 1]));
  }
  return 1.25 * (most + change);
}

/// The first meeting of a path with a scene, up to `end`. `path(theta)` gives places in W, off by up to `rounding` [m].
/// All casts are made among what is near the path; those that follow a meeting may go on with it.
template <class Path>
[[nodiscard]] std::optional<PathHit> first_meeting(TubeCasts& casts, double radius, const Path& path,
                                                   const PathTime& time, double end = 1, double rounding = 0) {
  PHYSIM_ASSERT(end >= 0 && end <= 1 && radius >= 0 && rounding >= 0);
  constexpr int kMostCasts = 1000;
  const double bend = bend_of(path);
  const Scene& scene = casts.scene();
  Vec3d from = path(0.0);
  const Vec3d last = path(end);
  // Places have sixteen digits; a tenth of a nanometre is nothing, and half of a skin.
  const double fine = std::max({1e-10, 4e-16 * length(from), 0.5 * scene.skin(), rounding});
  // Engines need not tell what a sphere touches where it starts: theirs are no larger than what flies.
  const bool asks_engine = scene.skin() > 0;
  const double widest = asks_engine && bend > 0 ? std::max(std::sqrt(8 * fine / bend), 1.0 / kMostCasts) : 1;
  // The path is within `off` of its chord, and so is each chord that is cast.
  const double off = 0.125 * bend * end * end + rounding + fine;
  if (!casts.find(time.chord(from, last, radius + 2 * off, 0, end))) return std::nullopt;
  double at = 0, width = end;
  for (int cast = 0; at < end; ++cast) {
    width = std::min({width, end - at, widest});
    const double to = width == end - at ? end : at + width;
    const Vec3d there = to == end ? last : path(to);
    const double delta = 0.125 * bend * width * width;
    const bool is_fine = asks_engine || delta <= fine || cast >= kMostCasts;
    const double wide = is_fine ? radius : radius + delta + rounding;
    const SceneHit hit = casts.first_hit(time.chord(from, there, wide, at, to), !is_fine);
    if (!hit) {
      at = to;
      from = there;
      width *= 2;
      continue;
    }
    const double met = at + hit.part * (to - at);
    if (is_fine) return PathHit{std::min(met, end), hit};
    // The gap that is left is about 2 delta: as long as it takes to close it, and a quarter at most.
    const Vec3d towards = (there - from) - hit.velocity * ((to - at) * time.span);
    const double closing = std::abs(dot(hit.normal, towards)) / (to - at);
    if (met > at) {
      at = met;
      from = path(at);
    }
    width = std::min(0.25 * width, closing > 0 ? 4 * delta / closing : width);
    width = std::max(width, std::sqrt(8 * 0.5 * fine / bend));
  }
  return std::nullopt;
}

}  // namespace physim::collide
