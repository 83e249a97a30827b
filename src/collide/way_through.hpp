// The straight way of a projectile through a thing of a scene: how thick that is there, and where it comes out. What a
// point goes through on its way: sensors, and whatever it passes.
//
// A way is looked at chord by chord, step by step. A surface that lies where two chords meet belongs to one of them,
// and to no other: each chord is cast a little longer than it is, and which of the two a surface there belongs to is a
// question to the place where they meet, which both ask alike.
#pragma once

#include <optional>
#include <vector>

#include "collide/path_cast.hpp"
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

/// The surfaces that a point goes through along a chord, in order; `SceneHit::part` is of the chord. Parts of a
/// compound that touch or overlap and have one material are one body, whose inner surfaces do not count.
[[nodiscard]] std::vector<SceneHit> passages(const Scene& scene, const SceneFilter& filter, const SceneSegment& chord);

/// A path, and what is called with each surface that it goes through. Pointers, since the code behind them is in every
/// program that flies.
struct PassagesOfPath {
  const void* both;  // handed to the functions
  Vec3d (*place)(const void* both, double theta);
  void (*tell)(const void* both, double theta, const SceneHit& hit);

  [[nodiscard]] Vec3d operator()(double theta) const { return place(both, theta); }
};
void each_passage(const Scene& scene, const SceneFilter& filter, const PassagesOfPath& of, const PathTime& time,
                  double end);

/// Calls tell(theta, hit) for every surface that a path goes through behind its start and up to `end`, in and out: its
/// points, without a radius, along chords that stay within a micrometre of it. `path(theta)` gives places in W.
template <class Path, class Tell>
void each_passage(const Scene& scene, const SceneFilter& filter, const Path& path, const PathTime& time, double end,
                  const Tell& tell) {
  struct Both {
    const Path& path;
    const Tell& tell;
  };
  const Both both{path, tell};
  const auto place = [](const void* of, double theta) { return static_cast<const Both*>(of)->path(theta); };
  const auto report = [](const void* of, double theta, const SceneHit& hit) {
    static_cast<const Both*>(of)->tell(theta, hit);
  };
  each_passage(scene, filter, {&both, place, report}, time, end);
}

}  // namespace physim::collide
