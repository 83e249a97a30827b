#include "world/step/drive.hpp"

#include "math/vec3.hpp"
#include "model/gravity.hpp"
#include "solve/explicit_runge_kutta.hpp"
#include "world/step/force_field.hpp"

namespace physim {

InFlight in_flight(const ParticleSpan& particle, double birth) {
  const double lifetime = particle.dies - birth;
  PHYSIM_ASSERT(lifetime > 0);
  return {particle.number, birth, lifetime < kInfinity ? lifetime : 1};
}

void Drive::find(const Registry& registry, const WorldState& state, std::uint32_t index) {
  law_ = state.emitters.law_of(index);
  if (!law_) return;
  particle_ = in_flight(state.emitters.span(index), state.slots.birth(index));
  const Slot& slot = state.slots[index];
  if (law_->has_force()) mass_ = mass_of(registry, state, slot);
  if (!law_->scales_gravity()) return;
  conditions_ = &registry.cohort(slot.cohort).conditions;
  if (conditions_->has_gravity_scale) gravity_scale_ = gravity_scale_of(registry, state, index);
}

void Drive::begin_step(Integrator integrator, double time, double dt) {
  PHYSIM_ASSERT(law_ && dt >= 0);
  if (!law_->adds_velocity() || !(dt > 0)) return;
  gap_ = (law_->added_velocity(particle_, time + dt) - law_->added_velocity(particle_, time)) * (1 / dt);
  with_method(integrator, [&](auto method) {
    for (int i = 0; i < method.kStages; ++i) {
      double weight = 1;
      if constexpr (RungeKutta<decltype(method)>) weight = method.b[i];
      if (weight != 0) gap_ -= law_->velocity_rate(particle_, time + method.c[i] * dt) * weight;
    }
  });
}

Pushed<double> Drive::at(double time, const State<double>& s) const {
  PHYSIM_ASSERT(law_ && mass_ > 0);
  FlightState felt{.x = s.x, .v = s.v};
  if (conditions_) felt.gravity = gravity(*conditions_, s.x) * gravity_scale_;
  felt.mass = mass_;
  Pushed<double> pushed{};
  pushed.a = law_->acceleration(particle_, time, felt, &pushed.drag_rate);
  if (law_->adds_velocity()) pushed.a += law_->velocity_rate(particle_, time) + gap_;
  return pushed;
}

}  // namespace physim
