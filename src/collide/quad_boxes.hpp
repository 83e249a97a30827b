// Four boxes in float at a time, compared with a segment, a point or another box.
//
// Source: A. Williams, S. Barrus, R. K. Morley, P. Shirley, "An efficient and robust ray-box intersection algorithm",
//   Journal of Graphics Tools 10 (2005) 49-54; T. Ize, "Robust BVH ray traversal", Journal of Computer Graphics
//   Techniques 2 (2013) 12-27 (how wide the far side must be made).
#pragma once

#include "collide/box.hpp"
#include "math/pack.hpp"

namespace physim::collide {

inline constexpr double kFloatSlack = 0x1p-22;  // what coordinates lose in float, four times

/// Four floats at a time: the same operations on every machine.
using Quad = Pack<float, 4>;
[[nodiscard]] PHYSIM_INLINE Quad larger(const Quad& a, const Quad& b) {
#if defined(__SSE2__)
  Quad c;  // g++ 12 does not see that a selection is one instruction
  c.r[0] = (Quad::Register)_mm_max_ps((__m128)a.r[0], (__m128)b.r[0]);
  return c;
#else
  return max(a, b);
#endif
}
/// A bit for each lane in which a <= b.
[[nodiscard]] PHYSIM_INLINE unsigned lanes_up_to(const Quad& a, const Quad& b) {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps((__m128)a.r[0], (__m128)b.r[0])));
#else
  unsigned lanes = 0;
  for (int i = 0; i < 4; ++i) lanes |= a[i] <= b[i] ? 1u << i : 0u;
  return lanes;
#endif
}

/// Four doubles, to the nearest floats.
[[nodiscard]] PHYSIM_INLINE Quad rounded(const double* from) {
  Quad c;
#if defined(__SSE2__)
  c.r[0] = (Quad::Register)_mm_movelh_ps(_mm_cvtpd_ps(_mm_loadu_pd(from)), _mm_cvtpd_ps(_mm_loadu_pd(from + 2)));
#else
  for (int i = 0; i < 4; ++i) c.set(i, static_cast<float>(from[i]));
#endif
  return c;
}

/// Four boxes, rounded outwards; those that are none are empty.
struct QuadBoxes {
  static constexpr std::size_t kSides = 12;  // of four boxes, low or high

  float plane[2 * kSides];  // low sides by axis and box, then high ones

  [[nodiscard]] Bounds box(int lane) const {
    const float *low = plane + lane, *high = low + kSides;
    return {{low[0], low[4], low[8]}, {high[0], high[4], high[8]}};
  }
  /// From corner to corner.
  [[nodiscard]] PHYSIM_INLINE Quad sizes() const {
    Quad sum(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Quad size = Quad::load(plane + kSides + 4 * axis) - Quad::load(plane + 4 * axis);
      sum = sum + size * size;
    }
    return sqrt(sum);
  }
};

/// A segment from a part of it on, ready to be compared with four boxes in float whose coordinates are not beyond an
/// extent. What it is rounded to is added to its radius.
class QuadTest {
 public:
  QuadTest() = default;
  PHYSIM_INLINE QuadTest(const Segment& s, const Vec3d& per_along, double extent, double base) : base_(base) {
    const Vec3d from = s.at(base);
    const double most = std::max(extent, std::max(std::abs(from.x), std::max(std::abs(from.y), std::abs(from.z))));
    const double slack =
        s.radius + kFloatSlack * (most + s.radius) + 4 * std::numeric_limits<double>::epsilon() * s.extent();
    set(0, from.x, per_along.x, slack);
    set(1, from.y, per_along.y, slack);
    set(2, from.z, per_along.z, slack);
  }
  /// As far as boxes are looked at; what it is rounded to is much less than what is added.
  [[nodiscard]] float reach(const Segment& s) const { return static_cast<float>(s.reach - base_) * (1 + 0x1p-20f); }
  /// The boxes that are entered, and where.
  PHYSIM_INLINE unsigned enters(const QuadBoxes& boxes, float reach, Quad& in) const {
    // Written out for the three axes: g++ keeps the loop, and waits for it at each of them.
    const auto entry = [&](std::size_t i) {
      return (Quad::load(boxes.plane + near_at_[i]) - near_[i]) * per_along_[i];
    };
    const auto exit = [&](std::size_t i) { return (Quad::load(boxes.plane + far_at_[i]) - far_[i]) * per_along_[i]; };
    in = larger(entry(2), larger(entry(1), larger(entry(0), Quad(0.0f))));
    const Quad out = min(exit(2), min(exit(1), min(exit(0), Quad(reach))));
    return lanes_up_to(in, out * (1 + 0x1p-20f));
  }

 private:
  PHYSIM_INLINE void set(std::size_t axis, double from, double per_along, double slack) {
    near_at_[axis] = (per_along < 0 ? QuadBoxes::kSides : 0) + 4 * axis;
    far_at_[axis] = (per_along < 0 ? 0 : QuadBoxes::kSides) + 4 * axis;
    const double aside = std::copysign(slack, per_along);
    near_[axis] = Quad(static_cast<float>(from + aside));
    far_[axis] = Quad(static_cast<float>(from - aside));
    per_along_[axis] = Quad(static_cast<float>(std::clamp(per_along, -1e30, 1e30)));
  }

  Quad near_[3], far_[3], per_along_[3];
  std::size_t near_at_[3], far_at_[3];  // the sides of each axis that are entered and left
  double base_;
};

/// A point, ready to be compared with four boxes in float whose coordinates are not beyond an extent.
class QuadPoint {
 public:
  QuadPoint(const Vec3d& p, double extent) {
    const double slack = kFloatSlack * (extent + length(p));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = Quad(static_cast<float>(p[axis] - slack));
      high_[axis] = Quad(static_cast<float>(p[axis] + slack));
    }
  }
  /// Not more than the distances of four boxes; infinite for empty ones.
  [[nodiscard]] PHYSIM_INLINE Quad least_distance(const QuadBoxes& boxes) const {
    Quad sum(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Quad below = Quad::load(boxes.plane + 4 * axis) - high_[axis];
      const Quad beyond =
          larger(larger(low_[axis] - Quad::load(boxes.plane + QuadBoxes::kSides + 4 * axis), below), Quad(0.0f));
      sum = sum + beyond * beyond;
    }
    return sqrt(sum) * (1 - 0x1p-20f);
  }

 private:
  Quad low_[3], high_[3];
};

/// A box, ready to be compared with four others.
class QuadOverlap {
 public:
  explicit QuadOverlap(const Bounds& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = Quad(float_below(box.low[axis]));
      high_[axis] = Quad(float_above(box.high[axis]));
    }
  }
  /// A bit for each of the boxes that it may meet.
  [[nodiscard]] unsigned meets(const QuadBoxes& boxes) const {
    unsigned lanes = 0xf;
    for (std::size_t axis = 0; axis < 3; ++axis)
      lanes &= lanes_up_to(Quad::load(boxes.plane + 4 * axis), high_[axis]) &
               lanes_up_to(low_[axis], Quad::load(boxes.plane + QuadBoxes::kSides + 4 * axis));
    return lanes;
  }

 private:
  Quad low_[3], high_[3];
};

}  // namespace physim::collide
