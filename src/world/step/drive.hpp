// Drives: what an emitter does to the flight of one of its particles, asked in the stages of a step.
#pragma once

#include "emit/flight_law.hpp"
#include "solve/step.hpp"
#include "world/core/state.hpp"

namespace physim {

/// A particle, as what acts on its flight asks.
[[nodiscard]] InFlight in_flight(const ParticleSpan& particle, double birth);

class Drive {
 public:
  Drive() = default;  // nothing acts
  /// What acts on the projectile of a slot.
  Drive(const Registry& registry, const WorldState& state, std::uint32_t slot) { find(registry, state, slot); }

  explicit operator bool() const { return law_ != nullptr; }
  /// Before a step of an integrator, from a time of the world on and of a length [s].
  void begin_step(Integrator integrator, double time, double dt);
  /// In a stage at a time of the world.
  [[nodiscard]] Pushed<double> at(double time, const State<double>& s) const;

 private:
  void find(const Registry& registry, const WorldState& state, std::uint32_t slot);

  const FlightLaw* law_ = nullptr;
  const Conditions<double>* conditions_ = nullptr;  // where gravity counts
  InFlight particle_;
  double gravity_scale_ = 1;
  double mass_ = 1;  // where forces count [kg]
  Vec3d gap_{};      // what velocities added want beside their rate in this step [m/s^2]
};

}  // namespace physim
