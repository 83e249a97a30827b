// Rain: particles that fill a box about a viewer evenly, however that moves.
//
// Symbols: n density; u velocity of the box; v velocity of a particle; k an axis, N = +-k outwards through a face; A
//   area of a face; b bound of the speed at which anything comes in through it.
// Equations: what flows steadily stays even where n A max(0, (u - v) N) come in through each face a second, evenly over
//   it. Velocities differ from particle to particle: n A b candidates a second come to a face, with b not below
//   max(0, (u - v) N) for any v that there may be, and each stays with the probability max(0, (u - v) N) / b. When the
//   box jumps, n V candidates are even in it, and those stay that were not in the box before.
// When it is wrong: where v changes inside of the box, as it does for what falls freely: n is then that at the faces.
// Source: G. A. Bird, Molecular Gas Dynamics and the Direct Simulation of Gas Flows (1994), sec. 4.2 (the flux through
//   a face); P. A. W. Lewis, G. S. Shedler, "Simulation of nonhomogeneous Poisson processes by thinning", Naval
//   Research Logistics Quarterly 26 (1979) 403-413.
#pragma once

#include <array>
#include <optional>

#include "emit/chance.hpp"
#include "emit/drawn.hpp"

namespace physim {

class Rain {
 public:
  Rain(const EmitterDef& def, std::uint64_t seed);

  /// Whether there is any.
  [[nodiscard]] bool falls() const { return rain_.density > 0; }
  [[nodiscard]] const RainDef& def() const { return rain_; }

  /// What may come into a box that moves steadily.
  struct Inflow {
    Vec3d velocity{};               // of the box [m/s]
    std::array<double, 6> bound{};  // through +x, -x, +y, -y, +z, -z [m/s]
    double rate = 0;                // candidates [1/s]
  };
  /// `from` and `to`: rotations of the emitter at both ends of the way.
  [[nodiscard]] Inflow inflow(const Vec3d& velocity, const Quatd& from, const Quatd& to) const;
  /// Candidates that fill the whole box.
  [[nodiscard]] std::uint32_t filling() const;

  /// Where the candidate of a number comes in, from the middle of the box, if one of that velocity does.
  [[nodiscard]] std::optional<Vec3d> entry(const Inflow& inflow, std::uint64_t number, const Vec3d& velocity) const;
  /// Where one of a number is in a box that has jumped, from its middle; the box before it is at `before` from there.
  [[nodiscard]] std::optional<Vec3d> filled(std::uint64_t number, const std::optional<Vec3d>& before) const;
  /// Whether a place, from the middle, is in the box, or beside it by what rounding does.
  [[nodiscard]] bool holds(const Vec3d& place) const;

 private:
  RainDef rain_;
  std::uint64_t seed_;
  Vec3d half_;
  NumberRange speed_;
  bool is_straight_;  // all leave along the emitter's axis
};

}  // namespace physim
