// Eight boxes in float at a time, compared with a segment, a point or another box.
//
// Source: A. Williams, S. Barrus, R. K. Morley, P. Shirley, "An efficient and robust ray-box intersection algorithm",
//   Journal of Graphics Tools 10 (2005) 49-54; T. Ize, "Robust BVH ray traversal", Journal of Computer Graphics
//   Techniques 2 (2013) 12-27 (how wide the far side must be made).
#pragma once

#include <cstdint>

#include "collide/quad_boxes.hpp"

namespace physim::collide {

/// Boxes, rounded outwards; those that are none are empty.
struct EightBoxes {
  float side[6][8];  // low sides by axis and box, then high ones

  [[nodiscard]] PHYSIM_INLINE Octet low(std::size_t axis) const { return Octet::load(side[axis]); }
  [[nodiscard]] PHYSIM_INLINE Octet high(std::size_t axis) const { return Octet::load(side[3 + axis]); }
  [[nodiscard]] Bounds box(int lane) const {
    return {{side[0][lane], side[1][lane], side[2][lane]}, {side[3][lane], side[4][lane], side[5][lane]}};
  }
  /// From corner to corner.
  [[nodiscard]] PHYSIM_INLINE Octet sizes() const {
    Octet sum(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Octet size = high(axis) - low(axis);
      sum = sum + size * size;
    }
    return sqrt(sum);
  }
};

/// A segment from a part of it on, ready to be compared with boxes in float whose coordinates are not beyond an extent.
/// What it is rounded to is added to its radius.
struct BoxRay {
  float near[4], far[4],
      per_along[4];         // from where sides are entered and left, and one over its way; the last: nothing
  std::uint8_t near_at[4];  // which sides are entered, along each axis
  float reach;              // as far as boxes are looked at

  /// Makes it of a segment from its part `base` on.
  PHYSIM_INLINE void set(const Segment& s, float extent, double base) {
    const Quad from = rounded(s.from + s.along * base), along = rounded(s.along);
    const auto radius = static_cast<float>(s.radius);
    const float most = std::max(extent, most_of_three(abs(from)));
    // Places on the segment and places aside of them are rounded once each, which takes half of what is allowed for.
    const float slack =
        radius + (most + radius) * static_cast<float>(kFloatSlack) + (most + most_of_three(abs(along))) * 0x1p-49f;
    const Quad aside = with_sign_of(along, Quad(slack));
    (from + aside).store(near);
    (from - aside).store(far);
    (Quad(1.0f) / with_sign_of(along, max(abs(along), Quad(1e-30f)))).store(per_along);
    for (std::uint8_t axis = 0; axis < 3; ++axis) near_at[axis] = std::signbit(along[axis]) ? 3 + axis : axis;
    set_reach(s.reach, base);
  }
  /// As far as boxes are looked at: a part of the segment, and where the ray begins. What their difference is rounded
  /// to is much less than what is added.
  PHYSIM_INLINE void set_reach(double part, double base) { reach = static_cast<float>(part - base) * (1 + 0x1p-20f); }
  /// The boxes that are entered, a bit for each, and where. Four roundings of either side, of 2^-24 of a part each, are
  /// less than what the far one is moved out by.
  PHYSIM_INLINE unsigned enters(const EightBoxes& boxes, Octet& in) const {
    const auto entry = [&](std::size_t axis) PHYSIM_INLINE_LAMBDA {
      return (Octet::load(boxes.side[near_at[axis]]) - Octet(near[axis])) * Octet(per_along[axis]);
    };
    const auto exit = [&](std::size_t axis) PHYSIM_INLINE_LAMBDA {
      return (Octet::load(boxes.side[2 * axis + 3 - near_at[axis]]) - Octet(far[axis])) * Octet(per_along[axis]);
    };
    in = max(entry(2), max(entry(1), max(entry(0), Octet(0.0f))));
    const Octet out = min(exit(2), min(exit(1), min(exit(0), Octet(reach))));
    return lanes_at_most(in, out * (1 + 0x1p-20f));
  }

 private:
  PHYSIM_INLINE static Quad with_sign_of(const Quad& sign, const Quad& size) {
    constexpr std::uint32_t kSign = 0x80000000;
    using Bits = BitsOf<Quad>;
    return from_bits<Quad>((to_bits(sign) & Bits(kSign)) | to_bits(size));
  }
};

/// A point, ready to be compared with boxes in float whose coordinates are not beyond an extent.
class BoxPoint {
 public:
  BoxPoint(const Vec3d& p, double extent) {
    const double slack = kFloatSlack * (extent + length(p));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = Octet(static_cast<float>(p[axis] - slack));
      high_[axis] = Octet(static_cast<float>(p[axis] + slack));
    }
  }
  /// Not more than the distances of eight boxes; infinite for empty ones.
  [[nodiscard]] PHYSIM_INLINE Octet least_distance(const EightBoxes& boxes) const {
    Octet sum(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Octet below = boxes.low(axis) - high_[axis];
      const Octet beyond = max(max(low_[axis] - boxes.high(axis), below), Octet(0.0f));
      sum = sum + beyond * beyond;
    }
    return sqrt(sum) * (1 - 0x1p-20f);
  }

 private:
  Octet low_[3], high_[3];
};

/// A box, ready to be compared with others.
class BoxOverlap {
 public:
  explicit BoxOverlap(const Bounds& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = Octet(float_below(box.low[axis]));
      high_[axis] = Octet(float_above(box.high[axis]));
    }
  }
  /// A bit for each of the boxes that it may meet.
  [[nodiscard]] unsigned meets(const EightBoxes& boxes) const {
    unsigned lanes = 0xff;
    for (std::size_t axis = 0; axis < 3; ++axis)
      lanes &= lanes_at_most(boxes.low(axis), high_[axis]) & lanes_at_most(low_[axis], boxes.high(axis));
    return lanes;
  }

 private:
  Octet low_[3], high_[3];
};

}  // namespace physim::collide
