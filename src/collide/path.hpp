// The path of a thing that moves: pieces along which its origin follows a cubic and it turns about one axis.
//
// Symbols: c(u) = c0 + c1 u + c2 u^2 + c3 u^3 place of its origin, u seconds after the piece began; q(u) = turn(axis,
//   rate u) q0 its rotation. x(u) a point that moves beside it along a straight line; as seen from the thing it is at
//   y = R(q)^T (x - c).
// Equation: with v = x' - c', d = x - c and w = rate axis: y'' = R^T (-c'' - 2 w x v + w x (w x d)), so that
//   |y''| <= |c''| + 2 |w| |v| + |w|^2 |d|. A chord over a time h is nowhere farther from y than h^2 / 8 max |y''|.
// Source: motion in a frame that turns: H. Goldstein, C. Poole, J. Safko, Classical Mechanics (2002), eq. 4.91; error
// of
//   linear interpolation: J. Stoer, R. Bulirsch, Introduction to Numerical Analysis (2002), th. 2.1.4.1.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "collide/shape.hpp"
#include "physim/result.hpp"
#include "physim/scene.hpp"

namespace physim {
struct Carriage;
}

namespace physim::collide {

/// What all things that move do to what touches them.
extern const Carriage kCarriage;

class Path {
 public:
  /// One piece, from `start` to where the next one begins.
  struct Piece {
    double start = -kInfinity;  // of its time
    double origin = 0;          // from which its time is counted
    Vec3d c0, c1, c2, c3;
    Quatd q0;
    Vec3d axis;  // of length one where it turns
    double rate = 0;

    [[nodiscard]] MotionState at(double time) const;
    [[nodiscard]] Vec3d velocity(double time) const;
    /// |c''| is not larger between two times.
    [[nodiscard]] double most_acceleration(double from, double to) const;
    [[nodiscard]] bool is_straight() const { return rate == 0 && c2 == Vec3d{} && c3 == Vec3d{}; }
  };

  /// One of pieces in order of time, the first of which begins at -infinity.
  explicit Path(std::vector<Piece> pieces) : pieces_(std::move(pieces)) { PHYSIM_ASSERT(!pieces_.empty()); }

  /// The path of a thing that stands at `at` where it does not move. Refused where numbers are none or too large.
  [[nodiscard]] static Result<Path> make(const SceneMotion& motion, const Transform& at);

  [[nodiscard]] MotionState at(double time) const { return piece_at(time).at(time); }
  [[nodiscard]] Placement placement(double time) const { return Placement(transform(piece_at(time), time)); }
  [[nodiscard]] Placement placement(const Piece& piece, double time) const { return Placement(transform(piece, time)); }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] const Carriage* carriage() const { return carriage_; }
  [[nodiscard]] std::size_t bytes() const { return pieces_.capacity() * sizeof(Piece); }

  /// Calls visit(piece, from, to) for the pieces between two times, in order, at least once; stops where it says false.
  template <class Visit>
  void pieces(double from, double to, const Visit& visit) const {
    PHYSIM_ASSERT(from <= to && !pieces_.empty());
    for (std::size_t i = index_at(from); i < pieces_.size(); ++i) {
      const double end = i + 1 < pieces_.size() ? pieces_[i + 1].start : kInfinity;
      if (!visit(pieces_[i], std::max(from, pieces_[i].start), std::min(to, end)) || end >= to) return;
    }
  }

  /// Whether it stands still between two times.
  [[nodiscard]] bool rests(double from, double to) const;
  /// A box about what a box becomes between two times.
  [[nodiscard]] Bounds bounds(const Bounds& own, double from, double to) const;
  /// How fast the distance of p from the thing changes at most between two times.
  [[nodiscard]] double most_approach(const Vec3d& p, double from, double to) const;

 private:
  Path() = default;
  [[nodiscard]] Transform transform(const Piece& piece, double time) const;
  [[nodiscard]] std::size_t index_at(double time) const;
  [[nodiscard]] const Piece& piece_at(double time) const { return pieces_[index_at(time)]; }

  std::vector<Piece> pieces_;
  double scale_ = 1;
  const Carriage* carriage_ = nullptr;  // of a thing
};

/// Stands at a key, from a time on [s].
[[nodiscard]] Path::Piece resting(const MotionKey& key, double start);
/// From one key to a later one.
[[nodiscard]] Path::Piece between(const MotionKey& a, const MotionKey& b, MotionCurve curve);

}  // namespace physim::collide
