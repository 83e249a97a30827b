// What acts on the flight of an emitter's particle as it grows older.
//
// What it models: linear drag with a rate by age and speed, a part of gravity by age, a force by age, a velocity by
//   age that is in the particle's own whatever else changes that, a speed limit that what is above it falls to, and
//   swirls in space (model/curl_noise.hpp) with a strength that follows age.
// When it is wrong: it is what looks are made of. Drag of air grows with the square of the speed (a curve over the
//   speed can say so up to `fast`), and air has no limits. Rates k are felt by explicit steps of length h: methods of a
//   higher order than one overshoot those above 1/h, and blow up by those above 2/h or 3/h; steps of order one are
//   braked by them (model/ledger.hpp).
// Symbols: n(x) a number of ParticleFlight at the part x = age / span of its life; v velocity [m/s], s = |v|; k drag
//   [1/s], q(s) its part by speed [-]; g gravity felt [m/s^2], p its part [-]; F force [N], m mass [kg]; L
//   limit [m/s], c its rate [1/s]; u velocity added [m/s]; w noise of mean square 1 [-], N its strength [m/s^2].
// Equation: a = -k(x) q(s) v + (p(x) - 1) g + F(x) / m - c (1 - L(x) / s) v [s > L] + du/dt + N(x) w. At birth u is
// added
//   to the velocity.
// In a step from t to t + h of a method with the weights b and the stages c, du/dt stands in each stage with
//   e = (u(t + h) - u(t)) / h - sum b_i du/dt(t + c_i h) beside it: so the velocity has u exactly at the ends of steps,
//   across corners of its curve too, and the method keeps its order, of which e is.
// Source: Unity 2022.3 Manual, Particle System modules (what is offered, not how); linear drag: G. G. Stokes, Trans.
//   Cambridge Phil. Soc. 9 (1851) 8. The quadrature of u is ours.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "emit/chance.hpp"
#include "emit/drawn.hpp"
#include "model/curl_noise.hpp"

namespace physim {

/// One particle, as what acts on its flight asks.
struct InFlight {
  std::uint64_t number = 0;  // among those of its emitter
  double birth = 0;          // [s]
  double span = 1;           // of its curves, above 0 [s]
};

/// What it feels beside.
struct FlightState {
  Vec3d x, v;       // [m, m/s]
  Vec3d gravity{};  // as it feels it; read where scales_gravity() [m/s^2]
  double mass = 1;  // read where has_force() [kg]
};

/// Several, each number in a column.
template <std::size_t N>
struct FlightPack {
  using Column = std::array<double, N>;
  using Vectors = std::array<Column, 3>;
  std::array<std::uint64_t, N> number;
  Column birth, span;
  Column time;  // at which it is asked about [s]
  Vectors x, v;
  Vectors gravity;  // read where scales_gravity()
  Column mass;      // read where has_force()
};

class FlightLaw {
 public:
  /// Particles that are looked at together.
  static constexpr std::size_t kPack = kColumn;

  FlightLaw(const ParticleFlight& def, std::uint64_t seed);

  /// Whether there is anything.
  [[nodiscard]] bool acts() const;
  [[nodiscard]] bool scales_gravity() const { return !gravity_.is(1); }
  [[nodiscard]] bool adds_velocity() const;
  [[nodiscard]] bool has_force() const;
  /// Whether drag with a rate that follows age is all that acts.
  [[nodiscard]] bool is_drag_by_age() const;

  /// All but what is of adds_velocity() [m/s^2], and the rate of the drag in it [1/s].
  [[nodiscard]] Vec3d acceleration(const InFlight& particle, double time, const FlightState& state,
                                   double* drag_rate = nullptr) const;
  /// Those of a pack [m/s^2], [1/s].
  void accelerations(const FlightPack<kPack>& pack, FlightPack<kPack>::Vectors& a,
                     FlightPack<kPack>::Column& drag_rate) const;
  /// Rates of such drag at a time, of kPack particles; their numbers, births and spans lie in columns [1/s].
  void drag_rates(const ParticleKernel& kernel, const std::uint64_t* number, const double* birth, const double* span,
                  double time, double* rate) const;
  /// That is in its velocity at a time [m/s], and its derivative [m/s^2].
  [[nodiscard]] Vec3d added_velocity(const InFlight& particle, double time) const;
  [[nodiscard]] Vec3d velocity_rate(const InFlight& particle, double time) const;

 private:
  /// Three numbers along the axes of W.
  struct Numbers {
    EmitNumber x, y, z;
    [[nodiscard]] bool are_zero() const { return x.is(0) && y.is(0) && z.is(0); }
  };
  template <std::size_t N>
  void accelerate(const FlightPack<N>& pack, const ParticleKernel* kernel, typename FlightPack<N>::Vectors& a,
                  typename FlightPack<N>::Column& drag_rate) const;

  std::uint64_t seed_;
  EmitNumber drag_, gravity_, limit_, noise_;
  Numbers velocity_, force_;
  EmitCurve drag_by_speed_;
  double fast_, limit_rate_;
  std::optional<CurlNoise> swirls_;
};

}  // namespace physim
