// The way of one projectile or emitter through a step, as seen after it: cubics from key to key, with a corner where it
// was thrown off.
//
// Symbols: x0, v0 place and velocity at the earlier key [m, m/s], x1, v1 those at the later one, h the time between.
// Equation: where v1 is known, the cubic of x0, v0, x1, v1; where only the velocity after a corner is, v1 = 2 (x1 - x0)
// /
//   h - v0, which makes it a parabola: exact in a vacuum, wrong by h^2 / 2 times the change of acceleration elsewhere.
// Source: J. Stoer, R. Bulirsch, Introduction to Numerical Analysis (2002), 2.1.5 (Hermite's interpolation).
#pragma once

#include <vector>

#include "collide/path.hpp"

namespace physim {

class StepWay {
 public:
  /// It begins at a key.
  explicit StepWay(const MotionKey& begin);

  /// Comes to a key at a steady velocity, which is not the key's.
  void go_straight(MotionKey key);
  /// Comes to a key along a cubic, with the key's velocity.
  void arrive(const MotionKey& key);
  /// Is thrown off at a key: the key's velocity is that after.
  void turn(const MotionKey& key);

  /// When it was at the last key [s].
  [[nodiscard]] double end() const { return last_.time; }
  /// The whole path; it stands before, and continues straight after, so that a look at its very end sees its velocity.
  [[nodiscard]] collide::Path path() const;

 private:
  void go(const MotionKey& key, MotionCurve curve);

  MotionKey last_;
  std::vector<collide::Path::Piece> pieces_;
};

}  // namespace physim
