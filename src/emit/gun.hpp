// Gun: when each round of a gun leaves, and along which line.
//
// Symbols: k number of a round; T = 60 / rate time between rounds; b rounds of a burst and p the pause behind it; m
//   rounds of a magazine; j = k mod m; x forwards, y up, z right.
// Equations: t(k) = [k / m] t_m + j T + [j / b] p, with t_m = t(m - 1) + max(reload, T, and p where a burst was over).
//   Round j of a burst of b is at j / (b - 1) of the recoil's curves. Angles up and right are one turn, by their length
//   and towards their direction: with a = |(up, right)|, the line is (cos a, sin a up / a, sin a right / a); frames are
//   turned there the shortest way (Rodrigues). Dispersion: both angles are normal.
// Source: O. Rodrigues' rotation formula, H. Goldstein, C. Poole, J. Safko, Classical Mechanics (2002), eq. 4.62.
#pragma once

#include <array>
#include <vector>

#include "emit/chance.hpp"
#include "emit/drawn.hpp"
#include "emit/emit_shape.hpp"

namespace physim {

/// A frame with its x axis along a line, turned there from the emitter's the shortest way.
struct LineFrame {
  std::array<Vec3d, 3> axis{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};

  [[nodiscard]] static LineFrame along(const Vec3d& line);  // of length one, not backwards
  [[nodiscard]] Vec3d turned(const Vec3d& v) const { return axis[0] * v.x + axis[1] * v.y + axis[2] * v.z; }
};

class Gun {
 public:
  explicit Gun(const GunDef& def);

  /// How many rounds it has; those without end are more than can be counted.
  [[nodiscard]] std::uint64_t rounds() const { return rounds_; }
  /// From its first one [s].
  [[nodiscard]] double time_of(std::uint64_t round) const;
  [[nodiscard]] bool is_tracer(std::uint64_t round) const;
  /// What comes out of the shape comes out of its barrel, along its line.
  [[nodiscard]] Outlet aimed(const Outlet& from, std::uint64_t round, ParticleChance& chance) const;

 private:
  [[nodiscard]] double in_magazine(std::uint64_t round) const;
  [[nodiscard]] double place_in_burst(std::uint64_t round) const;  // 0..1

  struct Muzzle {
    Vec3d position;
    LineFrame frame;
  };
  GunDef def_;
  std::vector<Muzzle> muzzles_;
  EmitCurve up_, right_;
  std::uint64_t rounds_ = 0;
  double magazine_time_ = 0;
};

}  // namespace physim
