// Refuses bad input before a flight starts.
#include <cmath>
#include <limits>
#include <string>

#include "base/checker.hpp"
#include "base/event_table.hpp"
#include "model/aero_tables.hpp"
#include "model/attitude.hpp"
#include "model/humid_air.hpp"
#include "model/ladder.hpp"
#include "model/standard_atmosphere.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"
#include "prepare/projectile.hpp"
#include "settings/body_rows.hpp"
#include "settings/environment_rows.hpp"
#include "settings/flight_rows.hpp"
#include "settings/shot_rows.hpp"
#include "solve/take_step.hpp"

namespace physim {
namespace {

using namespace setting_rows;

// Numbers further out mean nothing here, and results computed from them are not finite.
constexpr double kSmallest = 1e-9;        // distance between points of a table [s, m, or Mach number]
constexpr double kSmallestError = 1e-15;  // of a place, asked for [m]
constexpr double kLongestBurn = 1e6;      // [s]
constexpr double kMostThrust = 1e12;      // [N]
constexpr double kLeastImpulse = 1e-9;    // [N s]

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

void check_curve(Checker& c, const std::vector<DragPoint>& curve, Checker::Text name) {
  if (is_surely_right(curve)) return;
  c.require(!curve.empty(), name, "is empty", "give at least one point (Mach, Cd)");
  check_items<kDragPointRows>(c, curve, name);
  for (std::size_t i = 1; i < curve.size(); ++i)
    c.require(curve[i].mach - curve[i - 1].mach >= kSmallest, InputPlace(name, i),
              "Mach numbers must rise, by 1e-9 at least", "sort the points by Mach number");
}

/// A coefficient's points; `angles`: several of them may have the same Mach number.
void check_coefficient(Checker& c, const AeroCoefficient& points, const std::string& list, bool angles) {
  check_items<kAeroAnglePointRows>(c, points, list);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const InputPlace place(list, i);
    const AeroPoint& p = points[i];
    c.require(angles || p.angle_squared == 0, place, "may not depend on the angle of attack",
              "only magnus_force and magnus_moment do; the others have a cubic part");
    if (i == 0) continue;
    const AeroPoint& before = points[i - 1];
    c.require(p.mach > before.mach || (p.mach == before.mach && p.angle_squared > before.angle_squared), place,
              "Mach numbers must rise, and angles at each", "sort the points by Mach number, then by angle");
  }
}

void check_aero(Checker& c, const ProjectileDef& p) {
  check_rows<kAeroRows>(c, p, "projectile.");
  const AeroDef& a = p.aero;
  if (!has_aero(a)) return;
  const auto look = [&](const auto& row) {
    constexpr std::size_t kNumbers = std::tuple_size_v<decltype(row.elements)>;  // three where angles are among them
    if constexpr (kNumbers > 0) check_coefficient(c, row.get(p), "projectile." + std::string(row.path), kNumbers == 3);
  };
  std::apply([&](const auto&... row) { (look(row), ...); }, kAeroRows);
  const char* kApart = "keep them at least 1/16384 apart";
  c.require(!mach_numbers_too_close(a), "projectile.aero", "has Mach numbers that are too close to each other", kApart);
  c.require(!angles_too_close(a.magnus_force), "projectile.aero.magnus_force", "has angles too close to each other",
            kApart);
  c.require(!angles_too_close(a.magnus_moment), "projectile.aero.magnus_moment", "has angles too close to each other",
            kApart);
}

/// Points at times that rise from 0. Where a table may have steps, two points at one time are one.
template <const auto& rows, class Point>
void check_table(Checker& c, const std::vector<Point>& table, const std::string& name, bool may_step) {
  constexpr std::size_t kMost = 1000;
  c.require(table.size() >= 2 && table.size() <= kMost, name, "has too few or too many points", "2 to 1000");
  check_items<rows>(c, table, name);
  for (std::size_t i = 0; i < table.size() && i < kMost; ++i) {
    const InputPlace place(name, i);
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

void check_motor(Checker& c, const ProjectileDef& p) {
  const MotorDef& m = p.motor;
  check_table<kThrustPointRows>(c, m.thrust, "projectile.motor.thrust", true);
  check_rows<kMotorRows>(c, p, "projectile.");
  c.require(m.propellant_mass < p.mass, "projectile.motor.propellant_mass", "is not less than the projectile's mass",
            "the mass at launch includes it");
  if (!c.status_so_far()) return;
  for (const ThrustPoint& point : m.thrust)
    c.require(point.force <= kMostThrust, "projectile.motor.thrust", "exceeds 1e12 N", "forces are in newtons");
  c.require(total_impulse(m) >= kLeastImpulse, "projectile.motor.thrust", "gives no impulse",
            "leave the table empty where there is no motor");
  if (!m.propellant.empty()) {
    check_table<kPropellantPointRows>(c, m.propellant, "projectile.motor.propellant", false);
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

void check_magnus(Checker& c, const ProjectileDef& p) {
  const MagnusDef& m = p.magnus;
  check_rows<kMagnusRows>(c, p, "projectile.");
  c.require(m.table.size() <= 10000, "projectile.magnus.table", "has too many points", "at most 10000");
  check_items<kMagnusPointRows>(c, m.table, "projectile.magnus.table");
  if (m.table.empty() || !c.status_so_far()) return;
  c.require(is_full(magnus_grid(m), m.table.size()), "projectile.magnus.table", "is no full grid",
            "give every speed with every spin, once");
}

Status check_projectile(const ProjectileDef& p, bool curve_too) {
  Checker c;
  check_rows<kProjectileRows>(c, p, "projectile.");
  check_rows<kFidelityRows>(c, p.fidelity, "fidelity.");
  const DragDef& d = p.drag;
  if (c.status_so_far())
    c.require(std::isfinite(half_area_per_mass(p)), "projectile.mass", "is too small for its drag area", "in kg");
  if (curve_too && d.table == DragTable::custom) check_curve(c, d.curve, "projectile.drag.curve");
  c.require(d.bands.size() <= std::size_t(kMaxBands), "projectile.drag.bands", "has too many bands", "at most 8");
  check_items<kBandRows>(c, d.bands, "projectile.drag.bands");
  check_rows<kInertiaRows>(c, p, "projectile.");
  c.require(!has_inertia(p) || is_possible(p.inertia), "projectile.inertia", "is no inertia that a body can have",
            "moments are positive, none exceeds the sum of the others, and products are small enough");
  check_aero(c, p);
  if (has_motor(p)) check_motor(c, p);
  check_magnus(c, p);
  return c.status();
}

}  // namespace

Status check(const ProjectileDef& p) { return check_projectile(p, true); }
Status check_but_curve(const ProjectileDef& p) { return check_projectile(p, false); }

Status check(const ProjectileDef& p, const Launch& l) {
  if (!has_motor(p)) return {};
  Checker c;
  const bool at_rest = l.velocity ? *l.velocity == Vec3d{} : l.speed == 0;
  c.require(!at_rest || l.rail_length > 0, "launch.rail_length", "a rocket that starts from rest needs a rail",
            "without one nothing holds its nose up");
  return c.status();
}

Status check(const Launch& l) {
  if (are_in_range<kMuzzleRows, kLaunchRows, kSightRows, kAttitudeRows>(l) && l.sight.zero_range == 0 && !l.velocity)
    return {};
  Checker c;
  check_rows<kMuzzleRows, kLaunchRows, kSightRows, kAttitudeRows>(c, l, "launch.");
  c.require(!(l.sight.zero_range > 0 && l.elevation != 0), "launch.elevation",
            "cannot be given together with a zero range", "the zero range decides the elevation");
  c.require(!(l.sight.zero_range > 0 && l.velocity), "launch.velocity", "cannot be given together with a zero range",
            "give a speed");
  c.require(!(l.velocity && l.speed != 0), "launch.velocity", "cannot be given together with a speed", "");
  return c.status();
}

Status check(const Environment& e) {
  Checker c;
  check_rows<kGroundRows, kAirRows, kScaleHeightRows, kWindRows, kEarthRows>(c, e, "environment.");
  const Atmosphere& a = e.atmosphere;
  if (a.humidity && *a.humidity > 0 && c.status_so_far()) {
    const Readings<double> air = station_air(e);
    c.require(vapour_fraction(air.temperature, air.pressure, *a.humidity) < 0.5, "environment.atmosphere.humidity",
              "is more vapour than air of this temperature and pressure can be made of",
              "lower it, or raise the pressure");
  }
  const auto& profile = e.wind.profile;
  c.require(profile.size() <= std::size_t(kMaxWindPoints), "environment.wind.profile", "has too many points",
            "at most 32");
  check_items<kWindPointRows>(c, profile, "environment.wind.profile");
  for (std::size_t i = 1; i < profile.size(); ++i)
    c.require(profile[i].at - profile[i - 1].at >= kSmallest, InputPlace("environment.wind.profile", i),
              "places must rise, by 1e-9 m at least", "sort the points");
  return c.status();
}

Status check(const Tolerance& t, const Fidelity& f) {
  Checker c;
  check_rows<kFidelityRows>(c, f, "fidelity.");
  check_rows<kToleranceRows>(c, t, "tolerance.");
  if (!c.status_so_far()) return c.status();
  // An adaptive integrator cannot reach an error below a few roundings: it would only shrink its step for ever.
  const bool adaptive =
      f.motion != Motion::closed_form && (f.integrator == Integrator::automatic || is_adaptive(f.integrator));
  const double least = 4 * row(f.precision).rounding;
  const char* at_best =
      f.precision == Precision::float32 ? "float32 allows 5e-7 at best" : "float64 allows 1e-15 at best";
  c.require(!adaptive || !t.relative || *t.relative >= least, "tolerance.relative", "lies below rounding", at_best);
  c.require(t.step == 0 || t.step >= kShortestStep, "tolerance.step", "is shorter than 1e-9 s",
            "0: found by a pilot flight");
  c.require(t.position_error >= kSmallestError, "tolerance.position_error", "is smaller than 1e-15 m",
            "no number keeps that");
  c.require(t.max_step >= kShortestStep, "tolerance.max_step", "is shorter than 1e-9 s", "infinity: no limit");
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

Status check(const CollisionDef& collision, const std::string& place) {
  Checker c;
  c.require(collision.radius == 0 || collision.radius >= 1e-12, place + ".radius",
            "must be zero, or lie between 1e-12 and 1e6 m", "0: a point");
  return c.status();
}

Status check(const ContactDef& contact, const std::string& place) {
  Checker c;
  check_rows<kContactRows>(c, contact, place + ".");
  c.also(check(contact.collision, place + ".collision"));
  c.require(contact.collision.on_hit != OnHit::ask, place + ".collision.on_hit", "asks, and a flight has nobody to ask",
            "worlds have World::set_hit_function()");
  c.require(abs(contact.scene_time) <= 1e9, place + ".scene_time", "must lie between -1e9 and 1e9 s");
  return c.status();
}

Status check(const Until& u) {
  Checker c;
  check_rows<kUntilRows>(c, u, "until.");
  c.require(u.events.size() <= 24, "until.events", "has too many events", "at most 24");
  for (std::size_t i = 0; i < u.events.size(); ++i) {
    const auto place = [i](const char* member) { return InputPlace("until.events", i, member); };
    c.is_number(u.events[i].value, place(".value"));
    c.require(is_watchable(u.events[i].kind), place(".kind"), "is none of the named values");
    c.named(u.events[i].direction, Crossing::falling, place(".direction"));
  }
  if (u.scene) c.also(check(u.contact, "until.contact"));
  return c.status();
}

}  // namespace physim
