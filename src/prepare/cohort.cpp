// Turns what a user gives into what the models compute with.
#include "prepare/cohort.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/elementary.hpp"
#include "model/aero_tables.hpp"
#include "model/attitude.hpp"
#include "model/standard_atmosphere.hpp"

namespace physim {
namespace {

WindField<double> prepare_wind(const Wind& wind, WindModel model) {
  WindField<double> field{};
  field.points = 1;
  field.by_range = wind.by == WindAxis::range;
  field.stepped = wind.interpolation == WindInterpolation::step;
  if (model == WindModel::off) return field;
  field.velocity[0] = wind.velocity;
  if (model == WindModel::constant || wind.profile.empty()) {
    // A low rung has one wind: the profile's first point stands for it where no other is given.
    if (!wind.profile.empty() && wind.velocity == Vec3d{}) field.velocity[0] = wind.profile.front().velocity;
    return field;
  }
  field.points = static_cast<int>(wind.profile.size());
  for (int i = 0; i < field.points; ++i) {
    const WindPoint& p = wind.profile[static_cast<std::size_t>(i)];
    field.at[i] = p.at;
    field.velocity[i] = p.velocity;
    if (i > 0) field.slope[i - 1] = (p.velocity - Vec3d(field.velocity[i - 1])) * (1 / (p.at - field.at[i - 1]));
  }
  return field;
}

constexpr double kPi = 3.14159265358979323846;

/// A constant Cd goes into the area, so that all such projectiles share one curve, Cd = 1.
double constant_cd(const DragDef& drag) { return drag.table == DragTable::constant ? drag.coefficient : 1; }

/// i A / (2 m): from the ballistic coefficient, or from mass, diameter and form factor.
double half_area_per_mass(const ProjectileDef& p) {
  if (p.drag.ballistic_coefficient > 0) return constant_cd(p.drag) * kPi / (8 * p.drag.ballistic_coefficient);
  return constant_cd(p.drag) * p.drag.form_factor * kPi * p.diameter * p.diameter / (8 * p.mass);
}

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
  b.half_area_per_mass = factor / bands.front().ballistic_coefficient;
}

/// Adds the projectile's drag curve to the pool and its flags to the conditions.
void prepare_curve(const ProjectileDef& p, CurvePool& pool, Conditions<double>& c, Body<double>& b) {
  const CurvePlace place = pool.add(p.drag, c.fidelity.interpolation);
  b.curve_row = place.row;
  b.curve_start = place.start;
  b.curve_cells = place.cells;
  b.curve_last = place.last;
  b.reynolds_length = p.drag.table == DragTable::sphere ? p.diameter : 0;
  c.has_spheres = c.has_spheres || p.drag.table == DragTable::sphere;
  c.has_bands = c.has_bands || !p.drag.bands.empty();
  c.has_searched_curves = c.has_searched_curves || place.row < 0;
}

/// Scales and coefficients of the aerodynamics; see Rotor.
void prepare_aero(const ProjectileDef& p, CurvePool& pool, Conditions<double>& c, Rotor<double>& r) {
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
  add_aero(a, pool, r);
  c.has_aero = c.has_aero || has_aero(a);
  c.has_aero_tables = c.has_aero_tables || has_aero_tables(a);
  c.has_aero_angles = c.has_aero_angles || has_aero_angles(a, c.fidelity);
}

}  // namespace

EquivalentDrag::EquivalentDrag(const ProjectileDef& p, const Body<double>& b, const Conditions<double>& c)
    : body_(b), conditions_(c) {
  conditions_.fidelity.drag = DragModel::equation;
  prepare_curve(p, pool_, conditions_, body_);
}

double EquivalentDrag::k2_per_mass(const State<double>& s) {
  conditions_.curve_rows = pool_.rows().data();
  conditions_.searched_curves = pool_.searched().data();
  const Vec3d u = air_velocity(conditions_, s);
  const double speed = length(u);
  if (speed == 0) return 0;
  return length(drag_equation(conditions_, body_, air_state(conditions_, s.x), u)) / (speed * speed);
}

Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted) {
  Conditions<double> c{};
  c.fidelity = granted;
  prepare_earth(environment, granted, c);
  c.air = prepare_air(environment, granted.air);
  c.wind = prepare_wind(environment.wind, granted.wind);
  return c;
}

Conditions<float> to_float(const Conditions<double>& c) {
  Conditions<float> f{};
  f.fidelity = c.fidelity;
  f.gravity = static_cast<float>(c.gravity);
  f.radius = static_cast<float>(c.radius);
  f.altitude = static_cast<float>(c.altitude);
  f.omega = vec_cast<float>(c.omega);
  f.globe = to_float(c.globe);
  const auto copy = [](const double* from, float* to, int count) {
    for (int i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]);
  };
  f.air.density = static_cast<float>(c.air.density);
  f.air.per_sound_speed = static_cast<float>(c.air.per_sound_speed);
  f.air.kelvin_per_sound = static_cast<float>(c.air.kelvin_per_sound);
  f.air.low_middle = static_cast<float>(c.air.low_middle);
  f.air.low_scale = static_cast<float>(c.air.low_scale);
  f.air.low_top = static_cast<float>(c.air.low_top);
  copy(c.air.low_density, f.air.low_density, kDensityTerms);
  copy(c.air.low_per_sound, f.air.low_per_sound, kPerSoundTerms);
  f.air.temperature = static_cast<float>(c.air.temperature);
  f.air.per_scale_height = static_cast<float>(c.air.per_scale_height);
  f.air.layers = c.air.layers;
  copy(c.air.base, f.air.base, kAirLayers);
  copy(c.air.lapse, f.air.lapse, kAirLayers);
  copy(c.air.power, f.air.power, kAirLayers);
  copy(c.air.decay, f.air.decay, kAirLayers);
  copy(c.air.base_density, f.air.base_density, kAirLayers);
  copy(c.air.base_per_sound, f.air.base_per_sound, kAirLayers);
  f.wind.points = c.wind.points;
  f.wind.by_range = c.wind.by_range;
  f.wind.stepped = c.wind.stepped;
  copy(c.wind.at, f.wind.at, kMaxWindPoints);
  for (int i = 0; i < kMaxWindPoints; ++i) {
    f.wind.velocity[i] = vec_cast<float>(Vec3d(c.wind.velocity[i]));
    f.wind.slope[i] = vec_cast<float>(Vec3d(c.wind.slope[i]));
  }
  f.searched_curves = c.searched_curves;
  f.has_searched_curves = c.has_searched_curves;
  f.has_spheres = c.has_spheres;
  f.has_bands = c.has_bands;
  f.motor_pieces = c.motor_pieces;
  f.has_motor = c.has_motor;
  f.magnus_grids = c.magnus_grids;
  f.has_magnus_tables = c.has_magnus_tables;
  f.has_rail = c.has_rail;
  f.has_applied = c.has_applied;
  f.has_gravity_scale = c.has_gravity_scale;
  f.has_frozen = c.has_frozen;
  f.has_aero = c.has_aero;
  f.has_aero_tables = c.has_aero_tables;
  f.has_aero_angles = c.has_aero_angles;
  return f;
}

namespace {

bool waits_for_no_value(EventKind kind) { return kind == EventKind::apex || kind >= EventKind::ignition; }

/// Ignition, burnout and the end of the rail.
template <class Add>
void watch_stops(const Conditions<double>& c, const Add& add) {
  const auto tell = [&](EventKind kind) { add({kind, 0, Crossing::rising, false}, Outcome::event); };
  if (c.has_motor) tell(EventKind::ignition), tell(EventKind::burnout);
  if (c.has_rail) tell(EventKind::rail_exit);
}

}  // namespace

bool has_lowest_altitude(const Fidelity& f) { return f.air == AirModel::isa && f.drag == DragModel::equation; }

WatchList prepare_watch(const Until& until, const Conditions<double>& c, bool with_all) {
  WatchList watch{};
  const auto add = [&](const EventSpec& spec, Outcome outcome) { watch.item[watch.count++] = {spec, outcome}; };
  if (until.ground) add({EventKind::ground, *until.ground, Crossing::falling, true}, Outcome::landed);
  if (until.range) add({EventKind::range, *until.range, Crossing::rising, true}, Outcome::reached_range);
  add({EventKind::time, until.time, Crossing::rising, true}, Outcome::time_limit);
  if (has_lowest_altitude(c.fidelity))
    add({EventKind::height, kLowestAltitude - c.altitude, Crossing::falling, true}, Outcome::left_domain);
  if (with_all) {
    add({EventKind::apex, 0, Crossing::falling, false}, Outcome::event);
    watch_stops(c, add);
  }
  for (EventSpec spec : until.events) {
    // What cannot happen is not looked for: without motors and rails their numbers are not there.
    if ((spec.kind == EventKind::ignition || spec.kind == EventKind::burnout) && !c.has_motor) continue;
    if (spec.kind == EventKind::rail_exit && !c.has_rail) continue;
    if (waits_for_no_value(spec.kind)) spec.value = 0;
    add(spec, Outcome::event);
  }
  return watch;
}

bool flies_motors(const Fidelity& granted) {
  return granted.motion == Motion::force && granted.integrator != Integrator::classic;
}

bool has_motor(const ProjectileDef& p) { return !p.motor.thrust.empty(); }

namespace {

/// The motor's table and what it says before launch. The curve while it burns is relative to the same area, which
/// contains a constant Cd.
void prepare_motor(const ProjectileDef& p, CurvePool& pool, Conditions<double>& c, Body<double>& b) {
  const double never = std::numeric_limits<double>::infinity();
  b.burn = no_burn(0.0, never, 0.0);
  b.mass = p.mass;
  b.ignition = b.burnout = never;
  if (!has_motor(p) || !flies_motors(c.fidelity)) return;
  const CurvePlace coasting{b.curve_row, b.curve_start, b.curve_cells, b.curve_last};
  CurvePlace burning = coasting;
  double factor = p.motor.drag_factor;
  if (c.fidelity.drag == DragModel::equation && !p.motor.drag_curve.empty()) {
    DragDef on;
    on.table = DragTable::custom;
    on.curve = p.motor.drag_curve;
    burning = pool.add(on, c.fidelity.interpolation);
    c.has_searched_curves = c.has_searched_curves || burning.row < 0;
    factor /= constant_cd(p.drag);
  }
  const std::size_t piece = pool.motors.add(p.motor, coasting, burning, factor);
  put_piece(pool.motors.pieces().data(), static_cast<int>(piece), b, 0);
  b.ignition = p.motor.ignition_delay;
  b.burnout = p.motor.ignition_delay + burn_time(p.motor);
  c.has_motor = true;
}

}  // namespace

bool has_magnus(const ProjectileDef& p) { return p.magnus.lift != 0 || !p.magnus.table.empty(); }

void prepare_spin(const Launch& launch, const Vec3d& forward, const Vec3d& right, Body<double>& b) {
  const Vec3d up = cross(right, forward);
  b.spin = right * launch.spin.backspin - up * launch.spin.sidespin + forward * launch.spin.gyrospin;
}

namespace {

void prepare_magnus(const ProjectileDef& p, CurvePool& pool, Conditions<double>& c, Body<double>& b) {
  if (!spins(c.fidelity)) return;
  const MagnusDef& m = p.magnus;
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

void prepare_rail(const Launch& launch, const Vec3d& bore, Conditions<double>& c, Body<double>& b) {
  b.rail = bore;
  b.rail_phase = kOffRail;
  if (launch.rail_length == 0 || !flies_motors(c.fidelity)) return;
  b.rail_end = dot(launch.position, bore) + launch.rail_length;
  b.rail_phase = kSliding;
  c.has_rail = true;
}

Body<double> prepare_kind(const ProjectileDef& p, CurvePool& pool, Conditions<double>& c) {
  Body<double> b{};
  b.rail_phase = kOffRail;
  b.half_area_per_mass = half_area_per_mass(p);
  prepare_bands(p.drag, b);
  if (c.fidelity.drag == DragModel::equation) prepare_curve(p, pool, c, b);
  b.k1_per_mass = p.drag.k1 / p.mass;
  b.k2_per_mass = p.drag.k2 / p.mass;
  const bool linear = c.fidelity.drag == DragModel::linear_quadratic;
  b.damping_rate = linear ? b.k1_per_mass : p.drag.damping == 1 ? 0 : -log(p.drag.damping);
  b.applied = p.force * (1 / p.mass);
  b.applied_until = p.force == Vec3d{} ? 0 : p.force_duration;
  const bool feels_forces = c.fidelity.motion == Motion::force;
  c.has_applied = c.has_applied || (feels_forces && p.force != Vec3d{});
  b.gravity_scale = 1;
  b.free = {1, 1, 1};
  prepare_motor(p, pool, c, b);
  prepare_magnus(p, pool, c, b);
  return b;
}

void put_launch(const ProjectileDef& p, const Launch& launch, double elevation, Conditions<double>& c,
                Body<double>& b) {
  const SightFrame sight = sight_frame(launch);
  const Vec3d bore = launch_direction(launch, sight, elevation);
  b.launch = {launch.position, velocity_along(launch, bore)};
  b.sight = sight.forward;
  b.plane = sight.right;
  if (c.fidelity.planar) b.launch.v -= b.plane * dot(b.plane, b.launch.v);
  if (c.fidelity.drag == DragModel::linear_quadratic && p.drag.k1 == 0 && p.drag.k2 == 0)
    b.k2_per_mass = EquivalentDrag(p, b, c).k2_per_mass(b.launch);
  if (spins(c.fidelity)) prepare_spin(launch, bore, sight.right, b);
  prepare_rail(launch, bore, c, b);
}

Body<double> prepare_body(const ProjectileDef& p, const Launch& launch, double elevation, CurvePool& pool,
                          Conditions<double>& c) {
  Body<double> b = prepare_kind(p, pool, c);
  put_launch(p, launch, elevation, c, b);
  return b;
}

Rotor<double> prepare_rotor_kind(const ProjectileDef& p, CurvePool& pool, Conditions<double>& c) {
  Rotor<double> rotor = prepare_rotor(p);
  prepare_aero(p, pool, c, rotor);
  return rotor;
}

void put_launch(const ProjectileDef& p, const Launch& launch, double elevation, const Body<double>& b,
                const Conditions<double>& c, Rotor<double>& rotor) {
  Launch bore = launch;
  bore.velocity.reset();
  bore.speed = 1;
  const Vec3d direction = launch_velocity(bore, sight_frame(launch), elevation);
  rotor.launch = turn_of(c.fidelity, rotor, launch_attitude(p, launch, b.launch.v, direction, c));
}

Rotor<double> prepare_rotor(const ProjectileDef& p, const Launch& launch, double elevation, const Body<double>& b,
                            CurvePool& pool, Conditions<double>& c) {
  Rotor<double> rotor = prepare_rotor_kind(p, pool, c);
  put_launch(p, launch, elevation, b, c, rotor);
  return rotor;
}

namespace {

/// Miller's, where it has a meaning.
std::optional<double> stability_at_launch(const ProjectileDef& p, double speed, const Environment& environment) {
  const auto air = air_at(environment, std::clamp(environment.altitude, kLowestAltitude, kHighestAltitude));
  if (!air) return std::nullopt;
  const double stability = miller_stability(p, speed, air->temperature, air->pressure);
  return stability < kMostStable ? std::optional(stability) : std::nullopt;
}

}  // namespace

SpinDrift prepare_spin_drift(const ProjectileDef& p, double launch_speed, const Environment& environment,
                             const Fidelity& granted) {
  if (granted.rotation != RotationModel::spin_drift) return {};
  const auto stability = stability_at_launch(p, launch_speed, environment);
  return stability ? litz_spin_drift(*stability, p.twist) : SpinDrift{};
}

void jump_in_crosswind(const ProjectileDef& p, const Environment& environment, const Conditions<double>& c,
                       Body<double>& b) {
  if (!c.fidelity.aerodynamic_jump) return;
  const double speed = length(b.launch.v);
  if (speed == 0) return;
  const auto stability = stability_at_launch(p, speed, environment);
  if (!stability) return;
  const double from_right = -dot(wind(c, b.launch.x), b.plane);
  const auto turn = sincos(litz_aerodynamic_jump(*stability, p.length / p.diameter, p.twist, from_right));
  b.launch.v = b.launch.v * turn.cos + cross(b.plane, b.launch.v) * turn.sin;
}

template <class S>
StepPlan<S> prepare_plan(const Tolerance& tolerance, const Fidelity& granted, double step) {
  const bool adaptive = steps_itself(granted);
  const double most = sizeof(S) == 4 ? 16e6 : 9e15;  // whole numbers that S counts exactly
  const double relative = tolerance.relative.value_or(sizeof(S) == 4 ? 1e-5 : 1e-9);
  return {static_cast<S>(relative), static_cast<S>(tolerance.absolute), static_cast<S>(adaptive ? 0 : step),
          static_cast<S>(std::min(tolerance.max_step, 1e30)),
          static_cast<S>(std::min(static_cast<double>(tolerance.max_steps), most))};
}
template StepPlan<float> prepare_plan<float>(const Tolerance&, const Fidelity&, double);
template StepPlan<double> prepare_plan<double>(const Tolerance&, const Fidelity&, double);

void Cohort::finish() {
  conditions.fidelity = in_use.fidelity;
  conditions.curve_rows = pool.rows().data();
  conditions.searched_curves = pool.searched().data();
  conditions.motor_pieces = pool.motors.pieces().data();
  conditions.magnus_grids = pool.magnus.grids().data();
  if (in_use.fidelity.precision == Precision::float64) return;
  rows_float.assign(pool.rows().size(), 0.0f);
  for (std::size_t i = 0; i < rows_float.size(); ++i) rows_float[i] = static_cast<float>(pool.rows()[i]);
  conditions_float = to_float(conditions);
  conditions_float.curve_rows = rows_float.data();
}

bool Cohort::corners_matter() const {
  const Fidelity& f = in_use.fidelity;
  return f.motion != Motion::closed_form && (conditions.has_rail || (steps_itself(f) && has_corners(conditions)));
}

std::optional<Outcome> ends_at_once(const Conditions<double>& c, const Body<double>& b, const Until& until) {
  if (has_lowest_altitude(c.fidelity) && altitude(c, b.launch.x) <= kLowestAltitude) return Outcome::left_domain;
  if (!until.ground || height(c, b.launch.x) > *until.ground) return std::nullopt;
  if (b.rail_phase < kOffRail && b.rail.y >= 0) return std::nullopt;  // its rail stands on the ground
  const double climb = climb_rate(c, b.launch);
  // Level at the start: weight against thrust decides.
  const Vec3d push = c.has_applied ? applied(c, b, 0.0) : Vec3d{};
  const Vec3d swing = throws_out(c.fidelity) ? centrifugal(c, b.launch.x) : Vec3d{};
  const double climb_later = climb_rate(c, State<double>{b.launch.x, gravity(c, b.launch.x) + swing + push});
  if (climb < 0 || (climb == 0 && climb_later < 0)) return Outcome::landed;
  return std::nullopt;
}

}  // namespace physim
