// Spread behind a material: how a projectile is turned that came out of something, or off it.
//
// What it models: a direction that is off by two normally distributed angles, and an axis that is off the direction by
//   two more; drawn by counter, so that each hit of each projectile has its own, in any order and on any thread.
// When to use it: where standard deviations were measured; they are 0 where nothing is known.
// When it is wrong: tumbling, break-up, and any turn that depends on how the projectile came in.
// Symbols: s standard deviation [rad]; u, w numbers between 0 and 1, by Philox from seed, projectile and hit; r angle
//   off, f about the direction [rad]; d direction, e1 and e2 unit vectors across it.
// Equations: r = s sqrt(-2 ln u), f = 2 pi w;  d' = d cos r + (e1 cos f + e2 sin f) sin r.
// Source: G. E. P. Box, M. E. Muller, "A note on the generation of random normal deviates", Ann. Math. Stat. 29 (1958)
//   610-611; J. K. Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011) (Philox).
#pragma once

#include <cstdint>

#include "physim/math.hpp"

namespace physim {

/// Random numbers of one hit.
struct HitNumbers {
  double angle[2];  // sqrt(-2 ln u), of deflection and yaw [-]
  double about[2];  // f [rad]
};
[[nodiscard]] HitNumbers hit_numbers(std::uint64_t seed, std::uint32_t projectile, std::uint32_t hit);

/// d' of a direction of length 1.
[[nodiscard]] Vec3d turned_off(const Vec3d& direction, double angle, double about);

}  // namespace physim
