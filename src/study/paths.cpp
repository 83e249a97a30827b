#include "study/paths.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

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

constexpr PathRow point_row(std::string_view path, std::string_view unit, std::string_view about,
                            double* (*point)(Shot&, std::size_t), bool above_zero = false) {
  return {.path = path, .unit = unit, .about = about, .above_zero = above_zero, .point = point};
}
constexpr PathRow wind_row(std::string_view path, std::string_view unit, std::string_view about,
                           double* (*point)(Environment&, std::size_t)) {
  return {.path = path, .unit = unit, .about = about, .place_point = point};
}

template <class Point>
double* point_at(std::vector<Point>& list, std::size_t i, double Point::*number) {
  return i < list.size() ? &(list[i].*number) : nullptr;
}
/// A curve that flies: that of another table is not read.
template <double DragPoint::*number>
double* drag_point(Shot& shot, std::size_t i) {
  DragDef& drag = shot.projectile.drag;
  return drag.table == DragTable::custom ? point_at(drag.curve, i, number) : nullptr;
}
double* wind_point(Environment& e, std::size_t i, double Vec3d::*axis) {
  return i < e.wind.profile.size() ? &(e.wind.profile[i].velocity.*axis) : nullptr;
}
double* place_of_wind(Environment& e, std::size_t i) { return point_at(e.wind.profile, i, &WindPoint::at); }

double wind_along_ground(const Environment& e) {
  const Vec3d& v = e.wind.velocity;
  return std::sqrt(v.x * v.x + v.z * v.z);
}
double wind_comes_from(const Environment& e) { return e.earth.azimuth + atan2(-e.wind.velocity.z, -e.wind.velocity.x); }

void scale_thrust(Shot& shot, double factor) {
  for (ThrustPoint& point : shot.projectile.motor.thrust) point.force *= factor;
}

#define PHYSIM_NUMBER(field) [](Shot& s) -> double& { return s.field; }
#define PHYSIM_POINT(list, number) \
  [](Shot& s, std::size_t i) -> double* { return point_at(s.projectile.list, i, &number); }
#define PHYSIM_AERO(list, about)                                                             \
  point_row("shot.aero." #list ".N", "-", about, PHYSIM_POINT(aero.list, AeroPoint::value)), \
      point_row("shot.aero." #list ".N.mach", "-", "Mach number of a point", PHYSIM_POINT(aero.list, AeroPoint::mach))
#define PHYSIM_AERO_ANGLE(list)                                                                    \
  point_row("shot.aero." #list ".N.angle_squared", "rad^2", "square of a point's angle of attack", \
            PHYSIM_POINT(aero.list, AeroPoint::angle_squared))
#define PHYSIM_WIND(axis) [](Environment& e, std::size_t i) -> double* { return wind_point(e, i, &Vec3d::axis); }
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
    shot_row("shot.gravity_scale", "-", "times gravity", PHYSIM_NUMBER(projectile.gravity_scale)),
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
    {.path = "shot.motor.thrust",
     .unit = "-",
     .about = "times the thrust of the motor's table",
     .scale = scale_thrust,
     .above_zero = kAboveZero},
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
    point_row("shot.drag.curve.N", "-", "drag coefficient of a point of its own curve",
              drag_point<&DragPoint::coefficient>),
    point_row("shot.drag.curve.N.mach", "-", "Mach number of a point of its own curve", drag_point<&DragPoint::mach>),
    point_row("shot.drag.bands.N.ballistic_coefficient", "kg/m^2", "of a band of speed",
              PHYSIM_POINT(drag.bands, BallisticBand::ballistic_coefficient), kAboveZero),
    point_row("shot.drag.bands.N.above", "m/s", "air speed from which a band holds",
              PHYSIM_POINT(drag.bands, BallisticBand::above)),
    point_row("shot.motor.thrust.N", "N", "of a point of the motor's table",
              PHYSIM_POINT(motor.thrust, ThrustPoint::force)),
    point_row("shot.motor.thrust.N.time", "s", "of a point of the motor's table, since ignition",
              PHYSIM_POINT(motor.thrust, ThrustPoint::time)),
    point_row("shot.motor.propellant.N", "kg", "left at a point of the motor's table",
              PHYSIM_POINT(motor.propellant, PropellantPoint::mass)),
    point_row("shot.motor.propellant.N.time", "s", "of what is left there, since ignition",
              PHYSIM_POINT(motor.propellant, PropellantPoint::time)),
    point_row("shot.motor.drag_curve.N", "-", "drag coefficient of a point while it burns",
              PHYSIM_POINT(motor.drag_curve, DragPoint::coefficient)),
    point_row("shot.motor.drag_curve.N.mach", "-", "Mach number of a point while it burns",
              PHYSIM_POINT(motor.drag_curve, DragPoint::mach)),
    point_row("shot.magnus.table.N.drag", "-", "drag coefficient of a point of the table",
              PHYSIM_POINT(magnus.table, MagnusPoint::drag)),
    point_row("shot.magnus.table.N.lift", "-", "lift coefficient of a point of the table",
              PHYSIM_POINT(magnus.table, MagnusPoint::lift)),
    point_row("shot.magnus.table.N.speed", "m/s", "at which a point of the table stands",
              PHYSIM_POINT(magnus.table, MagnusPoint::speed)),
    point_row("shot.magnus.table.N.spin", "rad/s", "at which a point of the table stands, or a spin parameter",
              PHYSIM_POINT(magnus.table, MagnusPoint::spin)),
    PHYSIM_AERO(drag_yaw, "CDd2 of a point"),
    PHYSIM_AERO(lift, "CLa0 of a point"),
    PHYSIM_AERO(lift_cubic, "CLa2 of a point"),
    PHYSIM_AERO(pitching, "CMa0 of a point"),
    PHYSIM_AERO(pitching_cubic, "CMa2 of a point"),
    PHYSIM_AERO(pitch_damping, "CMq + CMadot of a point"),
    PHYSIM_AERO(yaw_damping, "Cnr of a point"),
    PHYSIM_AERO(roll_damping, "Clp of a point"),
    PHYSIM_AERO(magnus_force, "CNpa of a point"),
    PHYSIM_AERO_ANGLE(magnus_force),
    PHYSIM_AERO(magnus_moment, "CMpa of a point"),
    PHYSIM_AERO_ANGLE(magnus_moment),
    wind_row("environment.wind.profile.N.velocity.x", "m/s", "of the air at a point, downrange", PHYSIM_WIND(x)),
    wind_row("environment.wind.profile.N.velocity.y", "m/s", "of the air at a point, upwards", PHYSIM_WIND(y)),
    wind_row("environment.wind.profile.N.velocity.z", "m/s", "of the air at a point, to the right", PHYSIM_WIND(z)),
    wind_row("environment.wind.profile.N.at", "m", "height or distance at which a point stands", place_of_wind),
};

#undef PHYSIM_NUMBER
#undef PHYSIM_POINT
#undef PHYSIM_AERO
#undef PHYSIM_AERO_ANGLE
#undef PHYSIM_WIND
#undef PHYSIM_THERE
#undef PHYSIM_PLACE

/// Which point a path names by a row with ".N" in it; nothing where it is none of the row.
std::optional<std::size_t> point_named(std::string_view path, const PathRow& row) {
  const std::size_t at = row.path.find(".N");
  PHYSIM_ASSERT(at != row.path.npos);
  const std::string_view head = row.path.substr(0, at + 1), tail = row.path.substr(at + 2);
  if (!path.starts_with(head) || !path.ends_with(tail) || path.size() <= head.size() + tail.size()) return std::nullopt;
  const std::string_view digits = path.substr(head.size(), path.size() - head.size() - tail.size());
  if (digits.size() > 1 && digits[0] == '0') return std::nullopt;  // one name for each
  std::size_t point = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), point);
  if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size()) return std::nullopt;
  return point;
}

StudyPath path_of(std::string_view path, const PathRow& row) {
  return {std::string(path), std::string(row.unit), std::string(row.about)};
}

}  // namespace

double* FoundPath::point_of(Shot& shot, Environment& place) const {
  PHYSIM_ASSERT(row != nullptr && row->is_of_list());
  if (point == 0) return nullptr;
  return row->point ? row->point(shot, point - 1) : row->place_point(place, point - 1);
}

std::size_t FoundPath::points(Shot& shot, Environment& place) const {
  std::size_t count = 0;
  while (FoundPath{row, count + 1}.point_of(shot, place)) ++count;
  return count;
}

double FoundPath::there(Shot shot, Environment place) const {
  PHYSIM_ASSERT(row != nullptr && (!row->is_of_list() || point_of(shot, place)));
  if (row->is_of_list()) return *point_of(shot, place);
  return row->there ? row->there(place) : row->number ? row->number(shot) : 1;
}

void FoundPath::put(Shot& shot, double number) const {
  if (row->number) row->number(shot) = number;
  if (row->point) *row->point(shot, point - 1) = number;
}

void FoundPath::put(Environment& place, double number) const {
  if (row->place) row->place(place) = number;
  if (row->place_point) *row->place_point(place, point - 1) = number;
}

std::span<const PathRow> all_paths() { return kPathRows; }

const PathRow* find_list(std::string_view path) {
  const auto* row = std::ranges::find(kPathRows, path, &PathRow::path);
  return row != std::end(kPathRows) && row->is_of_list() ? row : nullptr;
}

Result<const PathRow*> places_of_list(std::string_view path) {
  if (find_list(path)) {
    const std::string head(path.substr(0, path.find(".N") + 2));
    for (const char* last : {".mach", ".time", ".at", ".above"})
      if (const PathRow* places = find_list(head + last)) return places;
  }
  return Error{"\"" + std::string(path) + "\" is no list of points, each at a place", "list",
               "name one with its N, as study_paths() has it: \"shot.drag.curve.N\""};
}

FoundPath find_path(std::string_view path) {
  for (const PathRow& row : kPathRows) {
    PHYSIM_ASSERT(row.number || row.there || row.scale || row.is_of_list());
    if (!row.is_of_list() && row.path == path) return {&row, 0};
    if (!row.is_of_list()) continue;
    if (const auto point = point_named(path, row)) return {&row, *point};
  }
  return {};
}

std::vector<StudyPath> study_paths() {
  std::vector<StudyPath> list;
  for (const PathRow& row : kPathRows) list.push_back(path_of(row.path, row));
  return list;
}

std::optional<StudyPath> study_path(std::string_view path) {
  const FoundPath found = find_path(path);
  return found ? std::optional(path_of(path, *found.row)) : std::nullopt;
}

}  // namespace physim
