// Direction, rail, spin, attitude, jump and drift of a launch.
#include "prepare/launch.hpp"

#include <algorithm>
#include <optional>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"
#include "model/attitude.hpp"
#include "model/magnus.hpp"
#include "model/motor.hpp"
#include "model/standard_atmosphere.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "prepare/equivalent_drag.hpp"
#include "prepare/grant.hpp"

namespace physim {

namespace {

/// Turns the spin of a launch into W.
void prepare_spin(const Launch& launch, const Vec3d& forward, const Vec3d& right, Body<double>& b) {
  const Vec3d up = cross(right, forward);
  b.spin = right * launch.spin.backspin - up * launch.spin.sidespin + forward * launch.spin.gyrospin;
}

/// Puts a body on its launch rail, which lies along the bore; without one the bore says where a resting nose points.
bool prepare_rail(const Launch& launch, const Vec3d& bore, const Fidelity& granted, Body<double>& b) {
  PHYSIM_ASSERT(launch.velocity || !(abs(length_squared(bore) - 1) > 1e-9));
  const bool on_rail = launch.rail_length > 0 && flies_motors(granted);
  b.rail = bore;
  b.rail_phase = on_rail ? kSliding : kOffRail;
  if (on_rail) b.rail_end = dot(launch.position, bore) + launch.rail_length;
  return on_rail;
}

}  // namespace

bool put_launch(const Launch& launch, const SightFrame& sight, double elevation, const Fidelity& granted,
                Body<double>& b) {
  PHYSIM_ASSERT(elevation - elevation == 0 && launch.rail_length >= 0);
  const Vec3d bore = launch_direction(launch, sight, elevation);
  b.launch = {launch.position, velocity_along(launch, bore)};
  b.sight = sight.forward;
  b.plane = sight.right;
  if (granted.planar) b.launch.v -= b.plane * dot(b.plane, b.launch.v);
  if (spins(granted)) prepare_spin(launch, bore, sight.right, b);
  return prepare_rail(launch, bore, granted, b);
}

void put_launch(const ProjectileDef& p, const Launch& launch, const SightFrame& sight, double elevation,
                Conditions<double>& c, Body<double>& b) {
  c.has_rail = put_launch(launch, sight, elevation, c.fidelity, b) || c.has_rail;
  if (c.fidelity.drag == DragModel::linear_quadratic && p.drag.k1 == 0 && p.drag.k2 == 0)
    b.k2_per_mass = EquivalentDrag(p, b, c).k2_per_mass(b.launch);
}

Body<double> prepare_body(const ProjectileDef& p, const Launch& launch, double elevation, TablePool& pool,
                          Conditions<double>& c) {
  Body<double> b = prepare_kind(p, pool, c);
  put_launch(p, launch, sight_frame(launch), elevation, c, b);
  return b;
}

Attitude prepare_attitude(const ProjectileDef& p, const Launch& launch, double elevation, const Vec3d& velocity,
                          const Conditions<double>& c) {
  Launch bore = launch;
  bore.velocity.reset();
  const Vec3d direction = launch_direction(bore, sight_frame(launch), elevation);
  return launch_attitude(p, launch, velocity, direction, c);
}

void put_launch(const ProjectileDef& p, const Launch& launch, double elevation, const Body<double>& b,
                const Conditions<double>& c, Rotor<double>& rotor) {
  PHYSIM_ASSERT(turns(c.fidelity));
  rotor.launch = turn_of(c.fidelity, rotor, prepare_attitude(p, launch, elevation, b.launch.v, c));
}

Rotor<double> prepare_rotor(const ProjectileDef& p, const Launch& launch, double elevation, const Body<double>& b,
                            TablePool& pool, Conditions<double>& c) {
  Rotor<double> rotor = prepare_rotor_kind(p, pool, c);
  put_launch(p, launch, elevation, b, c, rotor);
  return rotor;
}

std::optional<double> stability_factor(const ProjectileDef& p, const Launch& launch, const Environment& environment) {
  const IeeeMode mode;
  if (!check(p) || !check(launch) || !check(environment)) return std::nullopt;
  return stability_of_checked(p, launch_speed(launch), environment);
}

std::optional<double> stability_of_checked(const ProjectileDef& p, double speed, const Environment& environment) {
  if (p.twist == 0 || p.length <= 0) return std::nullopt;
  const AirSample air = air_sample(environment, std::clamp(environment.altitude, kLowestAltitude, kHighestAltitude));
  if (!(air.pressure > 0)) return std::nullopt;
  return miller_stability(p, speed, air.temperature, air.pressure);
}

namespace {

/// Miller's, where Litz's formulas hold.
std::optional<double> stability_at_launch(const ProjectileDef& p, double speed, const Environment& environment) {
  const auto stability = stability_of_checked(p, speed, environment);
  return stability && *stability < kMostStable ? stability : std::nullopt;
}

}  // namespace

SpinDrift prepare_spin_drift(const ProjectileDef& p, double launch_speed, const Environment& environment,
                             const Fidelity& granted) {
  if (granted.rotation != RotationModel::spin_drift) return {};
  const auto stability = stability_at_launch(p, launch_speed, environment);
  return stability ? litz_spin_drift(*stability, p.twist) : SpinDrift{};
}

PHYSIM_COLD void jump_in_crosswind(const ProjectileDef& p, const Environment& environment, const Conditions<double>& c,
                                   Body<double>& b) {
  if (!c.fidelity.aerodynamic_jump) return;
  PHYSIM_ASSERT(c.fidelity.rotation == RotationModel::spin_drift);
  const double speed = length(b.launch.v);
  if (speed == 0) return;
  const auto stability = stability_at_launch(p, speed, environment);
  if (!stability) return;
  const double from_right = -dot(wind(c, b, 0.0, b.launch.x), b.plane);
  const auto turn = sincos(litz_aerodynamic_jump(*stability, p.length / p.diameter, p.twist, from_right));
  b.launch.v = b.launch.v * turn.cos + cross(b.plane, b.launch.v) * turn.sin;
}

}  // namespace physim
