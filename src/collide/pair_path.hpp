// Where two balls on curved paths touch.
//
// A path is a row of legs, each the cubic through the states at its ends. Between two moments at which both are on one
// leg the way from one to the other is a cubic, too; it lies within a known distance of its chord. Where the chord
// comes nowhere so near that they could touch, they do not; where chord and cubic are the same to rounding, the moment
// is that of the chord; else both halves are asked, the first one first. So the first touch is found, whatever the
// speeds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "base/assert.hpp"
#include "math/vec3.hpp"

namespace physim::collide {

/// A moment of a path.
struct Knot {
  double time = 0;  // [s]
  Vec3d x;          // [m]
  Vec3d v;          // [m/s]
};

/// The cubic between two moments of a path.
struct Leg {
  Knot begin, end;
  double placed = 1e-9;  // rounding of places, and the gap that contacts leave to surfaces [m]

  [[nodiscard]] double span() const { return end.time - begin.time; }
  [[nodiscard]] Knot at(double time) const {
    const double h = span();
    if (!(h > 0) || time >= end.time) return {time, end.x, end.v};
    if (time <= begin.time) return {time, begin.x, begin.v};
    const double s = (time - begin.time) / h;
    const Vec3d way = end.x - begin.x;
    const Vec3d early = begin.v * h - way, late = way - end.v * h;  // 0 on a straight and steady path
    const double r = 1 - s;
    const Vec3d bend = early * r + late * s;
    return {time, begin.x + way * s + bend * (s * r), velocity(s, early, late)};
  }

 private:
  /// The derivative of the cubic, except where places are too coarse for it: a leg shorter than their rounding has the
  /// velocity of its end, and one whose bend is rounding that of a steady acceleration.
  [[nodiscard]] Vec3d velocity(double s, const Vec3d& early, const Vec3d& late) const {
    const double h = span(), r = 1 - s, off = 0.5 * length(early - late);
    if (h * (length(begin.v) + length(end.v)) <= placed) return end.v;
    if (off <= placed && 3 * off > h * length(end.v - begin.v)) return begin.v * r + end.v * s;
    return (end.x - begin.x + (early * r + late * s) * (r - s) + (late - early) * (s * r)) * (1 / h);
  }
};

enum class Touch { comes_near, goes_away };

/// Looks for the moment at which a way shorter than `distance` begins, or ends.
class PairSearch {
 public:
  PairSearch(const Leg& a, const Leg& b, double distance, Touch touch)
      : a_(a), b_(b), distance_(distance), touch_(touch) {
    double largest = 0;
    for (const Knot* knot : {&a.begin, &a.end, &b.begin, &b.end})
      largest = std::max({largest, std::abs(knot->x.x), std::abs(knot->x.y), std::abs(knot->x.z)});
    same_ = 1e-13 + 8 * std::numeric_limits<double>::epsilon() * largest;
  }

  [[nodiscard]] std::optional<double> first(double from, double to) {
    if (!(to >= from)) return std::nullopt;
    for (;; same_ *= 64) {  // two that go along each other, or so wildly that no piece is straight
      pieces_ = 0;
      const auto found = within(apart(from), apart(to), 0);
      if (pieces_ <= kMostPieces) return found;
    }
  }

 private:
  static constexpr int kMostPieces = 1 << 14;

  [[nodiscard]] Knot apart(double time) const {
    const Knot a = a_.at(time), b = b_.at(time);
    return {time, a.x - b.x, a.v - b.v};
  }

  [[nodiscard]] std::optional<double> within(const Knot& from, const Knot& to, int depth) {
    constexpr int kDeepest = 48;
    if (++pieces_ > kMostPieces) return std::nullopt;
    const double h = to.time - from.time;
    const Vec3d chord = to.x - from.x;
    // The inner control points of the cubic less those of its chord: it bends away by 3/4 of the longer at most.
    const double bend = 0.75 / 3 * std::max(length(from.v * h - chord), length(chord - to.v * h));
    if (touch_ == Touch::comes_near) {
      if (!(nearest(from.x, chord) - bend <= distance_)) return std::nullopt;  // what is no number meets nothing
    } else if (!(std::max(length(from.x), length(to.x)) + bend >= distance_)) {
      return std::nullopt;
    }
    const double middle = from.time + 0.5 * h;
    if (bend <= same_ || depth == kDeepest || !(middle > from.time && middle < to.time))
      return on_chord(from, chord, h);
    const Knot half = apart(middle);
    if (const auto found = within(from, half, depth + 1)) return found;
    return within(half, to, depth + 1);
  }

  [[nodiscard]] static double nearest(const Vec3d& from, const Vec3d& chord) {
    const double square = length_squared(chord);
    const double part = square > 0 ? std::clamp(-dot(from, chord) / square, 0.0, 1.0) : 0.0;
    return length(from + chord * part);
  }

  /// |from + part chord| = distance.
  [[nodiscard]] std::optional<double> on_chord(const Knot& from, const Vec3d& chord, double h) const {
    const double square = length_squared(chord);
    const double beyond = length(from.x) - distance_;
    if (touch_ == Touch::comes_near ? beyond <= 0 : beyond >= 0) return from.time;
    if (!(square > 0)) return std::nullopt;
    const double c = beyond * (length(from.x) + distance_);
    const double b = dot(from.x, chord);
    const double root = b * b - square * c;
    if (touch_ == Touch::goes_away) {
      const double part = b > 0 ? -c / (b + std::sqrt(root)) : (std::sqrt(root) - b) / square;
      if (!(part <= 1)) return std::nullopt;
      return from.time + part * h;
    }
    if (!(root >= 0) || !(b < 0)) return std::nullopt;
    const double part = c / (std::sqrt(root) - b);
    if (!(part <= 1)) return std::nullopt;
    return from.time + part * h;
  }

  const Leg& a_;
  const Leg& b_;
  double distance_;
  Touch touch_;
  double same_;  // chord and cubic [m]
  int pieces_ = 0;
};

/// The leg of a path, of two knots at least, on which it is at a time, and after it.
[[nodiscard]] inline std::size_t leg_at(std::span<const Knot> path, double time) {
  PHYSIM_ASSERT(path.size() >= 2);
  std::size_t leg = 0;
  while (leg + 2 < path.size() && path[leg + 1].time <= time) ++leg;
  return leg;
}
[[nodiscard]] inline Leg leg_of(std::span<const Knot> path, std::size_t leg) {
  PHYSIM_ASSERT(leg + 1 < path.size());
  return {path[leg], path[leg + 1]};
}

/// When two paths come within a distance of each other for the first time, or part from it, from a time on. Nothing
/// comes within a distance that is not above 0.
[[nodiscard]] inline std::optional<double> first_touch(std::span<const Knot> a, std::span<const Knot> b,
                                                       double distance, Touch touch, double from) {
  if (touch == Touch::comes_near && !(distance > 0)) return std::nullopt;
  std::size_t i = leg_at(a, from), j = leg_at(b, from);
  for (;;) {
    const Leg one = leg_of(a, i), other = leg_of(b, j);
    const double to = std::min(one.end.time, other.end.time);
    if (const auto time = PairSearch(one, other, distance, touch).first(from, to)) return time;
    from = std::max(from, to);
    const bool ends_a = one.end.time <= to, ends_b = other.end.time <= to;
    if (ends_a && ++i + 1 >= a.size()) return std::nullopt;
    if (ends_b && ++j + 1 >= b.size()) return std::nullopt;
  }
}

}  // namespace physim::collide
