// Refuses bad input before a flight starts.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/checker.hpp"
#include "base/event_table.hpp"
#include "model/aero_tables.hpp"
#include "model/air_levels.hpp"
#include "model/attitude.hpp"
#include "model/humid_air.hpp"
#include "model/ladder.hpp"
#include "model/standard_atmosphere.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"
#include "prepare/projectile.hpp"
#include "solve/take_step.hpp"

namespace physim {
namespace {

constexpr double kRightAngleUp = 1.5707963267948968;  // the next number above a right angle [rad]

// Numbers further out mean nothing here, and what is computed from them is no number any more.
constexpr double kSmallest = 1e-9;        // distance between points of a table [s, m, or Mach number]
constexpr double kLeastLayer = 0.01;      // between levels of the air [m]
constexpr double kSmallestError = 1e-15;  // of a place, asked for [m]
constexpr double kFastestAero = 100;      // Mach number of aerodynamic tables [-]
constexpr double kWidestAero = 100;       // square of an angle there [rad^2]
constexpr double kMostGravity = 1e12;     // [m/s^2]
constexpr double kMostWind = 1e18;        // [m/s]
constexpr double kLongestBurn = 1e6;      // [s]
constexpr double kMostThrust = 1e12;      // [N]
constexpr double kLeastImpulse = 1e-9;    // [N s]

void check_fidelity(Checker& c, const Fidelity& f) {
  for_each_effect([&]<class Enum>(const char* place, Enum Fidelity::*rung) { c.named(f.*rung, place); });
  c.not_negative(f.tolerance, "fidelity.tolerance", "0: what the precision allows for");
}

/// Whether all points of a curve are right, by one look without a branch: batches look at one for each shot.
bool is_surely_right(const std::vector<DragPoint>& curve) {
  bool right = !curve.empty();
  double before = -1;
  for (const DragPoint& p : curve) {
    right &= (p.mach >= 0) & (p.mach - before >= kSmallest) & (p.coefficient >= 0) & (p.coefficient < kInfinity);
    before = p.mach;
  }
  return right && before < kInfinity;
}

PHYSIM_COLD void check_curve(Checker& c, const std::vector<DragPoint>& curve, Checker::Text name) {
  if (is_surely_right(curve)) return;
  c.require(!curve.empty(), name, "is empty", "give at least one point (Mach, Cd)");
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const InputPlace place(name, i);
    c.not_negative(curve[i].mach, place, "Mach numbers start at 0");
    c.not_negative(curve[i].coefficient, place, "drag coefficients are not negative");
    if (i > 0)
      c.require(curve[i].mach - curve[i - 1].mach >= kSmallest, place, "Mach numbers must rise, by 1e-9 at least",
                "sort the points by Mach number");
  }
}

PHYSIM_COLD void check_bands(Checker& c, const std::vector<BallisticBand>& bands) {
  c.require(bands.size() <= std::size_t(kMaxBands), "projectile.drag.bands", "has too many bands", "at most 8");
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const InputPlace place("projectile.drag.bands", i);
    c.not_negative(bands[i].above, place, "bands start at a speed").positive(bands[i].ballistic_coefficient, place, "");
  }
}

/// A coefficient's points; `angles`: several of them may have the same Mach number.
PHYSIM_COLD void check_coefficient(Checker& c, const AeroCoefficient& points, const char* name, bool angles) {
  const std::string list = std::string("projectile.aero.") + name;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const InputPlace place(list, i);
    const AeroPoint& p = points[i];
    c.require(!(p.mach > kFastestAero), place, "has a Mach number beyond 100", "");
    c.require(!(p.angle_squared > kWidestAero), place, "has an angle beyond 10 rad", "angles are in radians, squared");
    c.not_negative(p.mach, place, "Mach numbers start at 0").not_negative(p.angle_squared, place, "it is a square");
    c.is_number(p.value, place);
    c.require(angles || p.angle_squared == 0, place, "may not depend on the angle of attack",
              "only magnus_force and magnus_moment do; the others have a cubic part");
    if (i == 0) continue;
    const AeroPoint& before = points[i - 1];
    c.require(p.mach > before.mach || (p.mach == before.mach && p.angle_squared > before.angle_squared), place,
              "Mach numbers must rise, and angles at each", "sort the points by Mach number, then by angle");
  }
}

PHYSIM_COLD void check_aero(Checker& c, const AeroDef& a) {
  c.named(a.rate_norm, "projectile.aero.rate_norm");
  c.named(a.damping_frame, "projectile.aero.damping_frame");
  c.not_negative(a.area, "projectile.aero.area", "0: from the diameter");
  c.not_negative(a.length, "projectile.aero.length", "0: the diameter");
  c.not_negative(a.span, "projectile.aero.span", "0: the length");
  if (!has_aero(a)) return;
  const std::pair<const char*, const AeroCoefficient*> by_mach[] = {{"drag_yaw", &a.drag_yaw},
                                                                    {"lift", &a.lift},
                                                                    {"lift_cubic", &a.lift_cubic},
                                                                    {"pitching", &a.pitching},
                                                                    {"pitching_cubic", &a.pitching_cubic},
                                                                    {"pitch_damping", &a.pitch_damping},
                                                                    {"yaw_damping", &a.yaw_damping},
                                                                    {"roll_damping", &a.roll_damping}};
  for (const auto& [name, points] : by_mach) check_coefficient(c, *points, name, false);
  check_coefficient(c, a.magnus_force, "magnus_force", true);
  check_coefficient(c, a.magnus_moment, "magnus_moment", true);
  const char* kApart = "keep them at least 1/16384 apart";
  c.require(!mach_numbers_too_close(a), "projectile.aero", "has Mach numbers that are too close to each other", kApart);
  c.require(!angles_too_close(a.magnus_force), "projectile.aero.magnus_force", "has angles too close to each other",
            kApart);
  c.require(!angles_too_close(a.magnus_moment), "projectile.aero.magnus_moment", "has angles too close to each other",
            kApart);
}

/// Points with a time and a value that is not negative; times rising from 0. Where a table may have steps, two points
/// at one time are one.
template <class Point>
PHYSIM_COLD void check_table(Checker& c, const std::vector<Point>& table, double Point::*value, const std::string& name,
                             bool may_step) {
  constexpr std::size_t kMost = 1000;
  c.require(table.size() >= 2 && table.size() <= kMost, name, "has too few or too many points", "2 to 1000");
  for (std::size_t i = 0; i < table.size() && i < kMost; ++i) {
    const InputPlace place(name, i);
    c.is_number(table[i].time, place).not_negative(table[i].*value, place, "");
    if (i == 0)
      c.require(table[i].time == 0, place, "must be at time 0", "times count from ignition");
    else if (table[i].time > kLongestBurn)
      c.require(false, place, "lies beyond 1e6 s", "times are in seconds");
    else if (may_step && table[i].time == table[i - 1].time)
      c.require(i == 1 || table[i].time > table[i - 2].time, place, "is a third point at one time",
                "two points at one time are a step");
    else
      c.require(table[i].time - table[i - 1].time >= kSmallest, place, "times must rise, by 1e-9 s at least",
                "sort the points by time");
  }
}

PHYSIM_COLD void check_motor(Checker& c, const ProjectileDef& p) {
  const MotorDef& m = p.motor;
  check_table(c, m.thrust, &ThrustPoint::force, "projectile.motor.thrust", true);
  c.not_negative(m.propellant_mass, "projectile.motor.propellant_mass", "in kg");
  c.require(m.propellant_mass < p.mass, "projectile.motor.propellant_mass", "is not less than the projectile's mass",
            "the mass at launch includes it");
  c.require(m.ignition_delay >= 0 && m.ignition_delay <= 1e6, "projectile.motor.ignition_delay",
            "must lie between 0 and 1e6 s", "");
  c.require(m.drag_factor >= 0 && m.drag_factor <= 1000, "projectile.motor.drag_factor", "must lie between 0 and 1000",
            "1 means the same drag");
  if (!c.status_so_far()) return;
  for (const ThrustPoint& point : m.thrust)
    c.require(point.force <= kMostThrust, "projectile.motor.thrust", "exceeds 1e12 N", "forces are in newtons");
  c.require(total_impulse(m) >= kLeastImpulse, "projectile.motor.thrust", "gives no impulse",
            "leave the table empty where there is no motor");
  if (!m.propellant.empty()) {
    check_table(c, m.propellant, &PropellantPoint::mass, "projectile.motor.propellant", false);
    c.require(m.propellant.front().mass == m.propellant_mass && m.propellant.back().mass == 0 &&
                  m.propellant.back().time == burn_time(m),
              "projectile.motor.propellant", "must go from propellant_mass to 0 over the burn",
              "its last time is that of the thrust");
    for (std::size_t i = 1; i < m.propellant.size(); ++i)
      c.require(m.propellant[i].mass <= m.propellant[i - 1].mass, InputPlace("projectile.motor.propellant", i),
                "must not grow", "it is what is left");
  }
  if (m.drag_curve.empty()) return;
  check_curve(c, m.drag_curve, "projectile.motor.drag_curve");
  const DragDef& d = p.drag;
  c.require(d.bands.empty() && d.table != DragTable::sphere && (d.table != DragTable::constant || d.coefficient > 0),
            "projectile.motor.drag_curve", "does not go together with bands, spheres or a drag coefficient of 0",
            "give drag_factor instead");
}

PHYSIM_COLD void check_magnus(Checker& c, const MagnusDef& m) {
  c.named(m.measure, "projectile.magnus.measure");
  c.is_number(m.lift, "projectile.magnus.lift").positive(m.lift_base, "projectile.magnus.lift_base", "");
  c.not_negative(m.lift_saturation, "projectile.magnus.lift_saturation", "");
  c.not_negative(m.drag_per_spin, "projectile.magnus.drag_per_spin", "");
  c.require(m.decay_time > 0, "projectile.magnus.decay_time", "must be positive", "infinity: the spin stays");
  constexpr std::size_t kMost = 10000;
  c.require(m.table.size() <= kMost, "projectile.magnus.table", "has too many points", "at most 10000");
  for (std::size_t i = 0; i < m.table.size() && i < kMost; ++i) {
    const InputPlace point("projectile.magnus.table", i);
    const MagnusPoint& p = m.table[i];
    c.not_negative(p.speed, point, "").not_negative(p.spin, point, "spins have no direction here");
    c.not_negative(p.drag, point, "drag coefficients are not negative").is_number(p.lift, point);
  }
  if (m.table.empty() || !c.status_so_far()) return;
  c.require(is_full(magnus_grid(m), m.table.size()), "projectile.magnus.table", "is no full grid",
            "give every speed with every spin, once");
}

Status check_projectile(const ProjectileDef& p, bool curve_too, std::vector<Error>* all) {
  Checker c(all);
  c.positive(p.mass, "projectile.mass", "in kg");
  c.positive(p.diameter, "projectile.diameter", "in m");
  c.not_negative(p.length, "projectile.length", "0 where it is not known").is_number(p.twist, "projectile.twist");
  check_fidelity(c, p.fidelity);
  const DragDef& d = p.drag;
  c.named(d.table, "projectile.drag.table");
  c.not_negative(d.coefficient, "projectile.drag.coefficient", "");
  c.not_negative(d.ballistic_coefficient, "projectile.drag.ballistic_coefficient", "0: from mass and diameter");
  c.positive(d.form_factor, "projectile.drag.form_factor", "");
  c.require(d.damping > 0 && d.damping <= 1, "projectile.drag.damping", "must lie above 0 and not above 1",
            "1 means no drag");
  if (c.status_so_far())
    c.require(std::isfinite(half_area_per_mass(p)), "projectile.mass", "is too small for its drag area", "in kg");
  c.not_negative(d.k1, "projectile.drag.k1", "").not_negative(d.k2, "projectile.drag.k2", "");
  if (curve_too && d.table == DragTable::custom) check_curve(c, d.curve, "projectile.drag.curve");
  if (!d.bands.empty()) check_bands(c, d.bands);
  c.is_vector(p.inertia.moments, "projectile.inertia.moments");
  c.is_vector(p.inertia.products, "projectile.inertia.products");
  c.require(!has_inertia(p) || is_possible(p.inertia), "projectile.inertia", "is no inertia that a body can have",
            "moments are positive, none exceeds the sum of the others, and products are small enough");
  check_aero(c, p.aero);
  c.is_number(p.gravity_scale, "projectile.gravity_scale").is_vector(p.force, "projectile.force");
  c.require(p.force_duration >= 0, "projectile.force_duration", "must be zero or positive", "");
  if (has_motor(p)) check_motor(c, p);
  check_magnus(c, p.magnus);
  return c.status();
}

}  // namespace

Status check(const ProjectileDef& p, std::vector<Error>* all) { return check_projectile(p, true, all); }
Status check_but_curve(const ProjectileDef& p) { return check_projectile(p, false, nullptr); }

Status check(const ProjectileDef& p, const Launch& l) {
  if (!has_motor(p)) return {};
  Checker c;
  const bool at_rest = l.velocity ? *l.velocity == Vec3d{} : l.speed == 0;
  c.require(!at_rest || l.rail_length > 0, "launch.rail_length", "a rocket that starts from rest needs a rail",
            "without one nothing holds its nose up");
  return c.status();
}

namespace {

/// Whether all that a launch says is right, by one look at its numbers: a sum is finite only where each of them is.
bool is_surely_right(const Launch& l) {
  const auto sum = [](const Vec3d& v) { return v.x + v.y + v.z; };
  const LaunchAttitude& a = l.attitude;
  const Sight& s = l.sight;
  const double numbers = sum(l.position) + (l.velocity ? sum(*l.velocity) : 0.0) + (l.speed + l.rail_length) +
                         (l.elevation + l.azimuth) + (l.spin.backspin + l.spin.sidespin + l.spin.gyrospin) +
                         (a.yaw + a.pitch + a.roll + sum(a.rates)) + (s.height + s.cant + s.dial);
  if (!std::isfinite(numbers) || s.zero_range != 0 || (l.velocity && l.speed != 0)) return false;
  return l.speed >= 0 && l.rail_length >= 0 && std::abs(l.elevation) <= 2 * kRightAngleUp &&
         std::abs(s.look_angle) <= kRightAngleUp && std::abs(s.dial) <= kRightAngleUp &&
         static_cast<unsigned>(a.frame) <= unsigned(AttitudeFrame::world) &&
         static_cast<unsigned>(a.rate_frame) <= unsigned(RateFrame::inertial);
}

}  // namespace

PHYSIM_COLD Status check(const Launch& l, std::vector<Error>* all) {
  if (is_surely_right(l)) return {};
  Checker c(all);
  c.is_vector(l.position, "launch.position").not_negative(l.speed, "launch.speed", "in m/s");
  c.is_number(l.spin.backspin, "launch.spin.backspin").is_number(l.spin.sidespin, "launch.spin.sidespin");
  c.is_number(l.spin.gyrospin, "launch.spin.gyrospin");
  c.not_negative(l.rail_length, "launch.rail_length", "0: no rail");
  c.is_number(l.elevation, "launch.elevation").is_number(l.azimuth, "launch.azimuth");
  // Degrees taken for radians are the commonest slip; what is beyond these is surely one.
  c.require(!(std::abs(l.elevation) > 2 * kRightAngleUp), "launch.elevation", "must lie between -180 and 180 degrees",
            "angles are in radians: 30 degrees are 30_deg");
  if (l.velocity) c.is_vector(*l.velocity, "launch.velocity");
  const LaunchAttitude& a = l.attitude;
  c.named(a.frame, "launch.attitude.frame");
  c.named(a.rate_frame, "launch.attitude.rate_frame");
  c.is_number(a.yaw, "launch.attitude.yaw").is_number(a.pitch, "launch.attitude.pitch");
  c.is_number(a.roll, "launch.attitude.roll").is_vector(a.rates, "launch.attitude.rates");
  c.is_number(l.sight.height, "launch.sight.height").is_number(l.sight.cant, "launch.sight.cant");
  c.require(std::abs(l.sight.look_angle) <= kRightAngleUp, "launch.sight.look_angle",
            "must lie between -90 and 90 degrees", "angles are in radians");
  c.not_negative(l.sight.zero_range, "launch.sight.zero_range", "0: no zero");
  c.require(std::abs(l.sight.dial) <= kRightAngleUp, "launch.sight.dial", "must lie between -90 and 90 degrees",
            "angles are in radians");
  c.require(!(l.sight.zero_range > 0 && l.elevation != 0), "launch.elevation",
            "cannot be given together with a zero range", "the zero range decides the elevation");
  c.require(!(l.sight.zero_range > 0 && l.velocity), "launch.velocity", "cannot be given together with a zero range",
            "give a speed");
  c.require(!(l.velocity && l.speed != 0), "launch.velocity", "cannot be given together with a speed", "");
  return c.status();
}

namespace {

/// The levels of a sounding, which rise, and whose pressures fall.
PHYSIM_COLD void check_levels(const Atmosphere& a, Checker& c) {
  const std::string_view place = "environment.atmosphere.profile";
  PHYSIM_ASSERT(!a.profile.empty());
  c.require(a.profile.size() <= std::size_t(kMostLevels), place, "has too many levels", "at most 100000");
  static_assert(kMostLevels == 100000);
  c.require(!a.temperature && !a.pressure && !a.humidity && !a.station_altitude, place,
            "gives the air by levels, and a station gives it, too",
            "leave temperature, pressure, humidity and station_altitude out, or the profile");
  for (std::size_t i = 0; i < a.profile.size(); ++i) {
    const AirPoint& level = a.profile[i];
    const InputPlace there("environment.atmosphere.profile", i);
    c.require(level.altitude >= kLowestAltitude && level.altitude <= kHighestAltitude, there,
              "must lie between -5000 m and 86000 m", "altitudes are in metres above sea level");
    c.require(level.temperature >= 150 && level.temperature <= 350, there, "must have 150 K to 350 K",
              "temperatures are in kelvin");
    if (level.humidity)
      c.require(*level.humidity >= 0 && *level.humidity <= 1, there, "must have a humidity between 0 and 1",
                "60 % is 0.6");
    if (level.pressure) {
      c.require(*level.pressure >= 0.01 && *level.pressure <= 200000, there, "must have 0.01 Pa to 200000 Pa",
                "pressures are in pascal");
      c.require(i == 0 || a.profile[0].pressure, place, "has levels with pressures, and its first level has none",
                "give that of the first level, or none at all");
    }
    if (i > 0)
      c.require(level.altitude - a.profile[i - 1].altitude >= kLeastLayer * (1 - 1e-6), there,
                "must lie higher than the one below", "sort the levels by altitude; two lie 0.01 m apart at least");
  }
  if (!c.status_so_far()) return;
  const std::vector<AirLevel> levels = air_levels(a);
  for (const AirLevel& each : levels)
    c.require(each.humidity == 0 || vapour_fraction(each.temperature, each.pressure, each.humidity) < 0.5, place,
              "has more vapour at " + short_text(std::round(each.height)) +
                  " m than air of its temperature and pressure can be made of",
              "lower the humidity of levels that are high and warm");
  if (!c.status_so_far()) return;
  const AirLevel* before = nullptr;
  auto level = levels.begin();
  for (std::size_t i = 0; i < a.profile.size(); ++i) {
    const InputPlace there("environment.atmosphere.profile", i);
    level = std::ranges::find(level, levels.end(), geopotential(a.profile[i].altitude), &AirLevel::height);
    PHYSIM_ASSERT(level != levels.end());
    c.require(!before || level->pressure < before->pressure, there, "must have less pressure than the level below",
              "pressures are those at the level, in pascal");
    // Levels far apart need not be in balance: what lies between is not known.
    const double fall = before ? log(before->pressure / level->pressure) : 0;
    const double balanced = before ? balanced_fall(*before, *level) : 0;
    c.require(std::abs(fall - balanced) <= 0.05 + 0.25 * balanced, there,
              "has a pressure that its height above the level below cannot make",
              "pressures are those at the level, in pascal");
    before = &*level;
  }
}

}  // namespace

PHYSIM_COLD Status check(const Environment& e, std::vector<Error>* all) {
  Checker c(all);
  c.require(e.altitude >= kLowestAltitude && e.altitude <= 1e9, "environment.altitude",
            "must lie between -5000 m and 1e9 m", "");
  c.named(e.gravity.model, "environment.gravity.model");
  c.named(e.atmosphere.model, "environment.atmosphere.model");
  c.named(e.wind.by, "environment.wind.by");
  c.named(e.wind.interpolation, "environment.wind.interpolation");
  c.is_number(e.gravity.acceleration, "environment.gravity.acceleration");
  c.require(std::abs(e.gravity.acceleration) <= kMostGravity, "environment.gravity.acceleration", "exceeds 1e12 m/s^2",
            "accelerations are in m/s^2");
  c.positive(e.gravity.radius, "environment.gravity.radius", "in m");
  const Atmosphere& a = e.atmosphere;
  if (a.temperature)
    c.require(*a.temperature >= 150 && *a.temperature <= 350, "environment.atmosphere.temperature",
              "must lie between 150 K and 350 K", "temperatures are in kelvin");
  if (a.pressure)
    c.require(*a.pressure >= 100 && *a.pressure <= 120000, "environment.atmosphere.pressure",
              "must lie between 100 Pa and 120000 Pa", "pressures are in pascal");
  if (a.humidity)
    c.require(*a.humidity >= 0 && *a.humidity <= 1, "environment.atmosphere.humidity", "must lie between 0 and 1",
              "60 % is 0.6");
  if (a.station_altitude)
    c.require(*a.station_altitude >= kLowestAltitude && *a.station_altitude <= 80000,
              "environment.atmosphere.station_altitude", "must lie between -5000 m and 80000 m", "");
  if (a.humidity && *a.humidity > 0 && c.status_so_far()) {
    const Readings<double> air = station_air(e);
    c.require(vapour_fraction(air.temperature, air.pressure, *a.humidity) < 0.5, "environment.atmosphere.humidity",
              "is more vapour than air of this temperature and pressure can be made of",
              "lower it, or raise the pressure");
  }
  if (!a.profile.empty()) check_levels(a, c);
  if (a.density) c.not_negative(*a.density, "environment.atmosphere.density", "");
  if (a.sound_speed) c.positive(*a.sound_speed, "environment.atmosphere.sound_speed", "");
  c.positive(a.scale_height, "environment.atmosphere.scale_height", "");
  const auto check_wind = [&c](const Vec3d& velocity, const InputPlace& place) {
    c.is_vector(velocity, place);
    c.require(!(length(velocity) > kMostWind), place, "exceeds 1e18 m/s", "velocities are in m/s");
  };
  check_wind(e.wind.velocity, "environment.wind.velocity");
  const auto& profile = e.wind.profile;
  c.require(profile.size() <= std::size_t(kMostLevels), "environment.wind.profile", "has too many points",
            "at most 100000");
  static_assert(kMostLevels == 100000);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const InputPlace place("environment.wind.profile", i);
    c.is_number(profile[i].at, place);
    check_wind(profile[i].velocity, place);
    if (i > 0)
      c.require(profile[i].at - profile[i - 1].at >= kSmallest, place, "places must rise, by 1e-9 m at least",
                "sort the points");
  }
  const Earth& earth = e.earth;
  c.is_number(earth.latitude, "environment.earth.latitude").is_number(earth.longitude, "environment.earth.longitude");
  c.require(std::abs(earth.latitude) <= kRightAngleUp, "environment.earth.latitude",
            "must lie between -90 and 90 degrees", "angles are in radians, south is negative");
  c.is_number(earth.azimuth, "environment.earth.azimuth");
  c.is_number(earth.rotation_rate, "environment.earth.rotation_rate");
  return c.status();
}

Status check(const Tolerance& t, const Fidelity& f) {
  Checker c;
  check_fidelity(c, f);
  if (!c.status_so_far()) return c.status();
  // An adaptive integrator cannot reach an error below a few roundings: it would only shrink its step for ever.
  c.not_negative(t.relative.value_or(0), "tolerance.relative", "")
      .not_negative(t.absolute.value_or(0), "tolerance.absolute", "");
  const bool adaptive =
      f.motion != Motion::closed_form && (is_chosen_by_rotation(f.integrator) || is_adaptive(f.integrator));
  const double least = 4 * row(f.precision).rounding;
  const char* at_best =
      f.precision == Precision::float32 ? "float32 allows 5e-7 at best" : "float64 allows 1e-15 at best";
  c.require(!adaptive || !t.relative || *t.relative >= least, "tolerance.relative", "lies below rounding", at_best);
  c.not_negative(t.step, "tolerance.step", "0: found by a pilot flight");
  c.require(t.step == 0 || t.step >= kShortestStep, "tolerance.step", "is shorter than 1e-9 s",
            "0: found by a pilot flight");
  c.positive(t.position_error, "tolerance.position_error", "in m");
  c.require(t.position_error >= kSmallestError, "tolerance.position_error", "is smaller than 1e-15 m",
            "no number keeps that");
  c.require(t.max_step > 0, "tolerance.max_step", "must be positive", "");
  c.require(t.max_step >= kShortestStep, "tolerance.max_step", "is shorter than 1e-9 s", "infinity: no limit");
  c.require(t.max_steps > 0 && t.max_steps <= 1'000'000'000, "tolerance.max_steps", "must lie between 1 and 1e9", "");
  return c.status();
}

Status check_fits(const Vec3d& position, const Vec3d& velocity, Precision precision) {
  if (precision == Precision::float64) return {};
  const auto sum = [](const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
  if (sum(position) + sum(velocity) <= std::numeric_limits<float>::max()) return {};
  const bool near = finite(vec_cast<double>(vec_cast<float>(position)));
  if (near && finite(vec_cast<double>(vec_cast<float>(velocity)))) return {};
  return Error{"is too large for float32", near ? "velocity" : "position", "ask for float64"};
}

Status check(const CollisionDef& collision, std::string_view place) {
  Checker c;
  c.named(collision.on_hit, InputPlace(place, ".on_hit"));
  c.require(collision.inertia > 0 && collision.inertia <= 1, InputPlace(place, ".inertia"),
            "must lie above 0 and not above 1", "2/5: a solid ball");
  c.require(collision.radius == 0 || (collision.radius >= 1e-12 && collision.radius <= 1e6),
            InputPlace(place, ".radius"), "must be zero, or lie between 1e-12 and 1e6 m", "0: a point");
  return c.status();
}

Status check(const CombineDef& combine, std::string_view place) {
  Checker c;
  c.named(combine.restitution, InputPlace(place, ".restitution"));
  c.named(combine.friction, InputPlace(place, ".friction"));
  return c.status();
}

Status check(const ConveyorDef& conveyor, std::string_view place) {
  const auto [x, y, z] = conveyor.velocity;
  const bool good = abs(x) <= 1e6 && abs(y) <= 1e6 && abs(z) <= 1e6;
  return Checker().require(good, InputPlace(place, ".velocity"), "must have components within 1e6 m/s").status();
}

Status check(const ContactDef& contact, const std::string& place) {
  Checker c;
  c.also(check(contact.collision, place + ".collision"));
  c.require(contact.collision.on_hit != OnHit::ask, place + ".collision.on_hit", "asks, and a flight has nobody to ask",
            "worlds have World::set_hit_function()");
  c.require(contact.restitution >= 0 && contact.restitution <= 1, place + ".restitution", "must lie between 0 and 1");
  c.not_negative(contact.friction, place + ".friction");
  c.not_negative(contact.rolling_resistance, place + ".rolling_resistance");
  c.also(check(contact.combine, place + ".combine"));
  c.require(abs(contact.scene_time) <= 1e9, place + ".scene_time", "must lie between -1e9 and 1e9 s");
  return c.status();
}

PHYSIM_COLD Status check(const Until& u) {
  Checker c;
  if (u.ground) c.is_number(*u.ground, "until.ground");
  if (u.range) c.positive(*u.range, "until.range", "in m");
  c.positive(u.time, "until.time", "a flight needs an end");
  c.require(u.events.size() <= 24, "until.events", "has too many events", "at most 24");
  for (std::size_t i = 0; i < u.events.size(); ++i) {
    const auto place = [i](const char* member) { return InputPlace("until.events", i, member); };
    c.is_number(u.events[i].value, place(".value"));
    c.require(is_watchable(u.events[i].kind), place(".kind"), "is none of the named values");
    c.named(u.events[i].direction, place(".direction"));
  }
  if (u.scene) c.also(check(u.contact, "until.contact"));
  return c.status();
}

}  // namespace physim
