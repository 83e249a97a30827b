// Drag, bands, curves, motor, lift by spin and aerodynamics of a projectile.
#include "prepare/projectile.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "model/aero_tables.hpp"
#include "model/attitude.hpp"
#include "model/magnus.hpp"
#include "model/motor.hpp"
#include "prepare/grant.hpp"
#include "solve/stops.hpp"

namespace physim {
namespace {

/// A constant Cd goes into the area, so that all such projectiles share one curve, Cd = 1.
double constant_cd(const DragDef& drag) { return drag.table == DragTable::constant ? drag.coefficient : 1; }

double half_area_of_coefficient(const ProjectileDef& p, double ballistic_coefficient) {
  return constant_cd(p.drag) * kPi / (8 * ballistic_coefficient);
}
double half_area_of_form(const ProjectileDef& p, double form_factor) {
  return constant_cd(p.drag) * form_factor * kPi * p.diameter * p.diameter / (8 * p.mass);
}

}  // namespace

double half_area_per_mass(const ProjectileDef& p) {
  return p.drag.ballistic_coefficient > 0 ? half_area_of_coefficient(p, p.drag.ballistic_coefficient)
                                          : half_area_of_form(p, p.drag.form_factor);
}

void put_half_areas(const ProjectileDef& p, std::span<const double> ballistic_coefficients,
                    std::span<const double> form_factors, std::span<double> into) {
  const std::size_t count = into.size();
  if (!ballistic_coefficients.empty()) {
    PHYSIM_ASSERT(ballistic_coefficients.size() == count);
    for (std::size_t i = 0; i < count; ++i) into[i] = half_area_of_coefficient(p, ballistic_coefficients[i]);
  } else if (!form_factors.empty() && !(p.drag.ballistic_coefficient > 0)) {
    PHYSIM_ASSERT(form_factors.size() == count);
    for (std::size_t i = 0; i < count; ++i) into[i] = half_area_of_form(p, form_factors[i]);
  } else {
    std::ranges::fill(into, half_area_per_mass(p));
  }
}

namespace {

void prepare_bands(const DragDef& drag, Body<double>& b) {
  const auto& given = drag.bands;
  const double factor = constant_cd(drag) * kPi / 8;
  if (given.empty()) {
    for (double& above : b.band_above) above = std::numeric_limits<double>::infinity();
    return;
  }
  auto bands = given;
  std::sort(bands.begin(), bands.end(), [](const auto& x, const auto& y) { return x.above < y.above; });
  for (int i = 0; i < kMaxBands; ++i) {
    const bool used = i < static_cast<int>(bands.size());
    b.band_above[i] = used ? bands[static_cast<std::size_t>(i)].above : std::numeric_limits<double>::infinity();
    b.band_half_area_per_mass[i] =
        used ? factor / bands[static_cast<std::size_t>(i)].ballistic_coefficient : b.half_area_per_mass;
  }
  PHYSIM_ASSERT(bands.size() <= std::size_t(kMaxBands));
  b.half_area_per_mass = factor / bands.front().ballistic_coefficient;
}

/// Scales and coefficients of the aerodynamics; see Rotor.
void prepare_aero(const ProjectileDef& p, TablePool& pool, Conditions<double>& c, Rotor<double>& r) {
  const AeroDef& a = p.aero;
  const double area = a.area > 0 ? a.area : 0.25 * kPi * p.diameter * p.diameter;
  const double length = a.length > 0 ? a.length : p.diameter;
  const double span = a.span > 0 ? a.span : length;
  const double k = a.rate_norm == RateNorm::speed ? 1 : 0.5;
  const double yaw_length = a.yaw_damping.empty() ? length : span;
  r.force_scale = 0.5 * area / p.mass;
  r.moment_scale = 0.5 * area * length;
  r.pitch_scale = 0.5 * k * area * length * length;
  r.yaw_scale = 0.5 * k * area * yaw_length * yaw_length;
  r.roll_scale = 0.5 * k * area * span * span;
  r.magnus_force_scale = 0.5 * k * area * length / p.mass;
  r.magnus_moment_scale = 0.5 * k * area * length * length;
  r.air_turns = a.damping_frame == DampingFrame::air ? 1 : 0;
  PHYSIM_ASSERT(r.force_scale >= 0 && r.moment_scale >= 0);  // air moves no body of 1e300 kg
  add_aero(a, pool, r);
  c.has_aero = c.has_aero || has_aero(a);
  c.has_aero_tables = c.has_aero_tables || has_aero_tables(a);
  c.has_aero_angles = c.has_aero_angles || has_aero_angles(a, c.fidelity);
}

/// The motor's table and what it says before launch. The curve while it burns is relative to the same area, which
/// contains a constant Cd.
void prepare_motor(const ProjectileDef& p, TablePool& pool, Conditions<double>& c, Body<double>& b) {
  const double never = std::numeric_limits<double>::infinity();
  b.burn = no_burn(0.0, never, 0.0);
  b.mass = p.mass;
  b.ignition = b.burnout = never;
  if (!has_motor(p) || !flies_motors(c.fidelity)) return;
  const CurvePart<double>& coasting = b;
  CurvePart<double> burning = coasting;
  double factor = p.motor.drag_factor;
  if (c.fidelity.drag == DragModel::equation && !p.motor.drag_curve.empty()) {
    DragDef on;
    on.table = DragTable::custom;
    on.curve = p.motor.drag_curve;
    burning = pool.add(on, c.fidelity.interpolation);
    c.has_searched_curves = c.has_searched_curves || burning.curve_row < 0;
    factor /= constant_cd(p.drag);
  }
  PHYSIM_ASSERT(constant_cd(p.drag) > 0 || p.motor.drag_curve.empty());
  const std::size_t piece = pool.motors.add(p.motor, coasting, burning, factor);
  put_piece(pool.motors.pieces().data(), static_cast<int>(piece), b, 0);
  b.ignition = p.motor.ignition_delay;
  b.burnout = p.motor.ignition_delay + burn_time(p.motor);
  c.has_motor = true;
}

void prepare_magnus(const ProjectileDef& p, TablePool& pool, Conditions<double>& c, Body<double>& b) {
  if (!spins(c.fidelity)) return;
  const MagnusDef& m = p.magnus;
  PHYSIM_ASSERT(m.decay_time > 0 && m.lift_base > 0);
  b.spin_decay = 1 / m.decay_time;
  b.ball_radius = 0.5 * p.diameter;
  b.magnus_area = kPi * p.diameter * p.diameter / (8 * p.mass);
  b.lift = m.lift;
  b.lift_base = m.lift_base;
  b.lift_saturation = m.lift_saturation;
  b.drag_per_spin = m.drag_per_spin;
  b.magnus_table = -1;
  if (m.table.empty()) return;
  b.magnus_table = static_cast<double>(pool.magnus.add(m));
  c.has_magnus_tables = true;
}

}  // namespace

void prepare_curve(const ProjectileDef& p, TablePool& pool, Conditions<double>& c, Body<double>& b) {
  static_cast<CurvePart<double>&>(b) = pool.add(p.drag, c.fidelity.interpolation);
  b.reynolds_length = p.drag.table == DragTable::sphere ? p.diameter : 0;
  c.has_spheres = c.has_spheres || p.drag.table == DragTable::sphere;
  c.has_bands = c.has_bands || !p.drag.bands.empty();
  c.has_searched_curves = c.has_searched_curves || b.curve_row < 0;
}

void put_kind(const ProjectileDef& p, TablePool& pool, Conditions<double>& c, Body<double>& b) {
  PHYSIM_ASSERT(p.mass > 0);
  std::construct_at(&b);
  b.rail_phase = kOffRail;
  b.half_area_per_mass = half_area_per_mass(p);
  prepare_bands(p.drag, b);
  if (c.fidelity.drag == DragModel::equation) prepare_curve(p, pool, c, b);
  b.k1_per_mass = p.drag.k1 / p.mass;
  b.k2_per_mass = p.drag.k2 / p.mass;
  const bool linear = c.fidelity.drag == DragModel::linear_quadratic;
  b.damping_rate = linear ? b.k1_per_mass : p.drag.damping == 1 ? 0 : -log(p.drag.damping);
  PHYSIM_ASSERT(b.damping_rate >= 0 && b.half_area_per_mass >= 0);
  b.applied = p.force * (1 / p.mass);
  const bool feels_force = c.fidelity.motion == Motion::force && p.force != Vec3d{};
  b.applied_until = feels_force ? p.force_duration : std::numeric_limits<double>::infinity();
  c.has_applied = c.has_applied || feels_force;
  // The original's loop has frames of one length: it looks at their start.
  const bool stops = !c.fidelity.original_one_shot_forces && !is_classic(c.fidelity);
  c.has_force_end = c.has_force_end || (stops && std::isfinite(b.applied_until));
  b.gravity_scale = p.gravity_scale;
  c.has_gravity_scale = c.has_gravity_scale || p.gravity_scale != 1;
  b.free = {1, 1, 1};
  prepare_motor(p, pool, c, b);
  prepare_magnus(p, pool, c, b);
}

Body<double> prepare_kind(const ProjectileDef& p, TablePool& pool, Conditions<double>& c) {
  Body<double> b;
  put_kind(p, pool, c, b);
  return b;
}

Rotor<double> prepare_rotor_kind(const ProjectileDef& p, TablePool& pool, Conditions<double>& c) {
  Rotor<double> rotor = prepare_rotor(p);
  prepare_aero(p, pool, c, rotor);
  return rotor;
}

}  // namespace physim
