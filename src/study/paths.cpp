#include "study/paths.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "model/standard_atmosphere.hpp"
#include "model/station.hpp"
#include "physim/study.hpp"

namespace physim {
namespace {

using Number = double& (*)(Shot&);
constexpr bool kAboveZero = true;

constexpr PathRow shot_row(std::string_view path, std::string_view unit, std::string_view about, Number number,
                           bool above_zero = false) {
  return {.path = path, .unit = unit, .about = about, .number = number, .above_zero = above_zero};
}
constexpr PathRow launch_row(std::string_view path, std::string_view unit, std::string_view about, Number number,
                             std::span<const double> LaunchColumns::*column, bool above_zero = false) {
  return {.path = path, .unit = unit, .about = about, .number = number, .launches = column, .above_zero = above_zero};
}
constexpr PathRow weather_row(std::string_view path, std::string_view unit, std::string_view about,
                              std::span<const double> Weather::*column, double (*there)(const Environment&),
                              bool above_zero = false) {
  return {.path = path, .unit = unit, .about = about, .weather = column, .there = there, .above_zero = above_zero};
}

constexpr PathRow compass_row(std::string_view path, std::string_view unit, std::string_view about, CompassWind compass,
                              double (*there)(const Environment&)) {
  return {.path = path, .unit = unit, .about = about, .there = there, .compass = compass};
}
constexpr PathRow place_row(std::string_view path, std::string_view unit, std::string_view about,
                            double& (*place)(Environment&), double (*there)(const Environment&),
                            bool above_zero = false) {
  return {.path = path, .unit = unit, .about = about, .there = there, .above_zero = above_zero, .place = place};
}

double wind_along_ground(const Environment& e) {
  const Vec3d& v = e.wind.velocity;
  return std::sqrt(v.x * v.x + v.z * v.z);
}
double wind_comes_from(const Environment& e) { return e.earth.azimuth + atan2(-e.wind.velocity.z, -e.wind.velocity.x); }

void scale_thrust(Shot& shot, const Shot& plain, double factor) {
  shot.projectile.motor.thrust = plain.projectile.motor.thrust;
  for (ThrustPoint& point : shot.projectile.motor.thrust) point.force *= factor;
}

#define PHYSIM_NUMBER(field) [](Shot& s) -> double& { return s.field; }
#define PHYSIM_THERE(number) [](const Environment& e) -> double { return number; }
#define PHYSIM_PLACE(field) [](Environment& e) -> double& { return e.field; }, PHYSIM_THERE(e.field)

constexpr PathRow kPathRows[] = {
    launch_row("shot.speed", "m/s", "at the muzzle", PHYSIM_NUMBER(launch.speed), &LaunchColumns::speed),
    launch_row("shot.elevation", "rad", "of the bore above the horizon", PHYSIM_NUMBER(launch.elevation),
               &LaunchColumns::elevation),
    launch_row("shot.azimuth", "rad", "of the plane of fire, to the right", PHYSIM_NUMBER(launch.azimuth),
               &LaunchColumns::azimuth),
    launch_row("shot.position.x", "m", "of the muzzle, downrange", PHYSIM_NUMBER(launch.position.x), &LaunchColumns::x),
    launch_row("shot.position.y", "m", "of the muzzle, upwards", PHYSIM_NUMBER(launch.position.y), &LaunchColumns::y),
    launch_row("shot.position.z", "m", "of the muzzle, to the right", PHYSIM_NUMBER(launch.position.z),
               &LaunchColumns::z),
    weather_row("environment.wind.velocity.x", "m/s", "of the air, downrange", &Weather::wind_x,
                PHYSIM_THERE(e.wind.velocity.x)),
    weather_row("environment.wind.velocity.y", "m/s", "of the air, upwards", &Weather::wind_y,
                PHYSIM_THERE(e.wind.velocity.y)),
    weather_row("environment.wind.velocity.z", "m/s", "of the air, to the right", &Weather::wind_z,
                PHYSIM_THERE(e.wind.velocity.z)),
    compass_row("environment.wind.speed", "m/s", "of the air along the ground, by compass with wind.from",
                CompassWind::speed, wind_along_ground),
    compass_row("environment.wind.from", "rad", "where the wind comes from, clockwise from north; see earth.azimuth",
                CompassWind::from, wind_comes_from),
    weather_row("environment.atmosphere.temperature", "K", "at the station", &Weather::temperature,
                PHYSIM_THERE(station_air(e).temperature), kAboveZero),
    weather_row("environment.atmosphere.pressure", "Pa", "at the station", &Weather::pressure,
                PHYSIM_THERE(station_air(e).pressure), kAboveZero),
    weather_row("environment.atmosphere.humidity", "-", "at the station, 0 to 1", &Weather::humidity,
                PHYSIM_THERE(station_air(e).humidity)),
    weather_row("environment.atmosphere.density", "kg/m^3", "at the origin, of constant and exponential air",
                &Weather::density, PHYSIM_THERE(prepare_air_numbers(e, AirModel::constant).density), kAboveZero),
    place_row("environment.altitude", "m", "of the origin above sea level", PHYSIM_PLACE(altitude)),
    place_row("environment.gravity.acceleration", "m/s^2", "at sea level", PHYSIM_PLACE(gravity.acceleration)),
    place_row("environment.atmosphere.scale_height", "m", "of exponential air", PHYSIM_PLACE(atmosphere.scale_height),
              kAboveZero),
    place_row("environment.earth.latitude", "rad", "of the origin", PHYSIM_PLACE(earth.latitude)),
    place_row("environment.earth.longitude", "rad", "of the origin", PHYSIM_PLACE(earth.longitude)),
    place_row("environment.earth.azimuth", "rad", "compass direction of the x axis", PHYSIM_PLACE(earth.azimuth)),
    shot_row("shot.mass", "kg", "of the projectile", PHYSIM_NUMBER(projectile.mass), kAboveZero),
    shot_row("shot.diameter", "m", "reference diameter", PHYSIM_NUMBER(projectile.diameter), kAboveZero),
    shot_row("shot.length", "m", "of the projectile", PHYSIM_NUMBER(projectile.length)),
    shot_row("shot.twist", "m", "rifling, length of one turn", PHYSIM_NUMBER(projectile.twist)),
    shot_row("shot.drag.coefficient", "-", "of a constant drag coefficient",
             PHYSIM_NUMBER(projectile.drag.coefficient)),
    launch_row("shot.drag.ballistic_coefficient", "kg/m^2", "m / (i d^2)",
               PHYSIM_NUMBER(projectile.drag.ballistic_coefficient), &LaunchColumns::ballistic_coefficient, kAboveZero),
    launch_row("shot.drag.form_factor", "-", "times the drag coefficient of a table",
               PHYSIM_NUMBER(projectile.drag.form_factor), &LaunchColumns::form_factor, kAboveZero),
    shot_row("shot.drag.k1", "kg/s", "linear drag", PHYSIM_NUMBER(projectile.drag.k1)),
    shot_row("shot.drag.k2", "kg/m", "quadratic drag", PHYSIM_NUMBER(projectile.drag.k2)),
    shot_row("shot.drag.damping", "-", "part of the velocity kept after a second",
             PHYSIM_NUMBER(projectile.drag.damping), kAboveZero),
    shot_row("shot.force.x", "N", "of a constant force", PHYSIM_NUMBER(projectile.force.x)),
    shot_row("shot.force.y", "N", "of a constant force", PHYSIM_NUMBER(projectile.force.y)),
    shot_row("shot.force.z", "N", "of a constant force", PHYSIM_NUMBER(projectile.force.z)),
    shot_row("shot.force_duration", "s", "of that force", PHYSIM_NUMBER(projectile.force_duration)),
    shot_row("shot.magnus.lift", "-", "lift coefficient of a ball that spins", PHYSIM_NUMBER(projectile.magnus.lift)),
    shot_row("shot.magnus.drag_per_spin", "s", "drag coefficient for each rad/s",
             PHYSIM_NUMBER(projectile.magnus.drag_per_spin)),
    shot_row("shot.magnus.decay_time", "s", "of the spin", PHYSIM_NUMBER(projectile.magnus.decay_time), kAboveZero),
    shot_row("shot.inertia.moments.x", "kg m^2", "of a rigid body", PHYSIM_NUMBER(projectile.inertia.moments.x)),
    shot_row("shot.inertia.moments.y", "kg m^2", "of a rigid body", PHYSIM_NUMBER(projectile.inertia.moments.y)),
    shot_row("shot.inertia.moments.z", "kg m^2", "of a rigid body", PHYSIM_NUMBER(projectile.inertia.moments.z)),
    {"shot.motor.thrust", "-", "times the thrust of the motor's table", nullptr, nullptr, nullptr, nullptr,
     scale_thrust, kAboveZero},
    shot_row("shot.motor.propellant_mass", "kg", "burned in all", PHYSIM_NUMBER(projectile.motor.propellant_mass)),
    shot_row("shot.motor.ignition_delay", "s", "from launch to ignition",
             PHYSIM_NUMBER(projectile.motor.ignition_delay)),
    shot_row("shot.motor.drag_factor", "-", "times the drag while it burns",
             PHYSIM_NUMBER(projectile.motor.drag_factor)),
    shot_row("shot.rail_length", "m", "of the launch rail", PHYSIM_NUMBER(launch.rail_length)),
    shot_row("shot.sight.cant", "rad", "roll of the launcher, clockwise from behind", PHYSIM_NUMBER(launch.sight.cant)),
    shot_row("shot.spin.backspin", "rad/s", "of a ball", PHYSIM_NUMBER(launch.spin.backspin)),
    shot_row("shot.spin.sidespin", "rad/s", "of a ball", PHYSIM_NUMBER(launch.spin.sidespin)),
    shot_row("shot.spin.gyrospin", "rad/s", "of a ball", PHYSIM_NUMBER(launch.spin.gyrospin)),
    shot_row("shot.attitude.yaw", "rad", "of a rigid body's nose, to the right", PHYSIM_NUMBER(launch.attitude.yaw)),
    shot_row("shot.attitude.pitch", "rad", "of a rigid body's nose, up", PHYSIM_NUMBER(launch.attitude.pitch)),
    shot_row("shot.attitude.roll", "rad", "of a rigid body, right side down", PHYSIM_NUMBER(launch.attitude.roll)),
    shot_row("shot.attitude.rates.x", "rad/s", "of a rigid body, rolling", PHYSIM_NUMBER(launch.attitude.rates.x)),
    shot_row("shot.attitude.rates.y", "rad/s", "of a rigid body, yawing", PHYSIM_NUMBER(launch.attitude.rates.y)),
    shot_row("shot.attitude.rates.z", "rad/s", "of a rigid body, pitching", PHYSIM_NUMBER(launch.attitude.rates.z)),
};

#undef PHYSIM_NUMBER
#undef PHYSIM_THERE
#undef PHYSIM_PLACE

}  // namespace

std::span<const PathRow> all_paths() { return kPathRows; }

const PathRow* find_path(std::string_view path) {
  const auto* at = std::ranges::find(kPathRows, path, &PathRow::path);
  PHYSIM_ASSERT(at == std::end(kPathRows) || at->number || at->there || at->scale);
  return at == std::end(kPathRows) ? nullptr : at;
}

std::vector<StudyPath> study_paths() {
  std::vector<StudyPath> list;
  for (const PathRow& row : kPathRows)
    list.push_back({std::string(row.path), std::string(row.unit), std::string(row.about)});
  return list;
}

}  // namespace physim
