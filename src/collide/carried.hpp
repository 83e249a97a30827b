// Places on things that move, and what such a thing does to the motion of what slides or rolls along it.
//
// Symbols: w angular velocity of the thing [rad/s]; n normal of its surface; u velocity of its surface where it is
//   touched; v_r velocity of what moves along it, less u [m/s]; a acceleration by everything but the surface [m/s^2].
// Equations: dv_r/dt = a - du/dt, with u where the way is, not where it began; n' = w x n turns v_r with it. The
// surface
//   presses by -(a - du/dt) . n - v_r . n'.
// Source: motion in a frame that turns: H. Goldstein, C. Poole, J. Safko, Classical Mechanics (2002), sec. 4.10.
#pragma once

#include "collide/even_way.hpp"
#include "collide/path.hpp"
#include "model/ball_contact.hpp"
#include "model/body.hpp"
#include "physim/scene.hpp"

namespace physim {

/// A place above a thing: the middle of what touches the thing.
struct OnThing {
  Vec3d x;        // [m]
  Vec3d normal;   // of the surface
  double radius;  // from the surface to it [m]
  double since;   // time of the scene at which it is there [s]
};
/// A motion along a thing over a time, as the surface below it sees it.
struct AlongThing {
  Vec3d over;   // velocity with which a conveyor's surface runs over the thing [m/s]
  Vec3d way;    // [m]
  double time;  // [s]
};

/// Functions of the motion of a thing that contacts with it call. Each path points to one table of them
/// (Path::carriage()), so a program whose scenes have no paths links none of that code.
struct Carriage {
  using Piece = collide::Path::Piece;

  /// The place after a time of what a thing carries, and the velocity of the surface below it; it went `along` the
  /// surface meanwhile. What does not go along it has the velocity of that surface.
  State<double> (*carried)(const Piece& by, const OnThing& on, const Vec3d& along, double time);
  /// The mean acceleration of what goes along a thing that turns; `a` is that of what does not go along it, `v` the
  /// velocity over the surface to begin with.
  Vec3d (*seen_from_turning)(const Piece& by, const OnThing& on, const Vec3d& a, const Vec3d& v,
                             const AlongThing& along);
  /// The motion at the end of a way along a thing that turns: what goes along it turns with its surface.
  BallMotion (*turned)(const Piece& by, const OnThing& on, const BallMotion& motion, const Ball& ball,
                       const AlongThing& along);
  /// When a way meets what moves steadily, or what it is carried to: a cast along its chord, `over` above it, met that.
  EvenWay::Moment (*moment_met)(const EvenWay& way, const SceneHit& met, const Vec3d& over);
};

}  // namespace physim
