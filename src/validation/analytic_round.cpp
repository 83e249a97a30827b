// Analytic cases under Newton's law over a sphere, in turning frames, and of bodies that turn.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/assert.hpp"
#include "validation/analytic.hpp"

namespace physim::validation {
namespace {

constexpr double kEarthGM = 3.986004418e14;  // [m^3/s^2]
constexpr double kMeanRadius = 6371000.0;    // [m]
constexpr double kEnergyDrift = 1e-11;       // over a revolution [-]

std::vector<Method> on_the_sphere() {
  std::vector<Method> methods = integrators();
  for (Method& method : methods) {
    method.fidelity.gravity = GravityModel::inverse_square;
    method.fidelity.earth = EarthModel::sphere;
  }
  return methods;
}

/// 1 kg around a sphere; the origin of W is on its surface.
ShotInPlace shot_around(double gm, double radius) {
  ShotInPlace shot = shot_under(gm / (radius * radius));
  shot.environment.gravity.radius = radius;
  return shot;
}

// -------------------------------------------------------------------------------------------------------------- orbits

/// A state of an orbit in its own plane. Orbit x is up in W (from the sphere's centre), orbit y is downrange.
struct OrbitState {
  double x = 0, y = 0, vx = 0, vy = 0;
};

struct Orbit {
  double a = 0, e = 0;
  std::vector<const CsvRow*> rows;
};

std::vector<Orbit> orbits_of(const CsvFile& file) {
  std::vector<Orbit> orbits;
  for (const CsvRow& row : file.rows()) {
    const double a = file.needed(row, "a_m");
    const double e = file.needed(row, "e");
    if (a <= 0 || e < 0 || e >= 1) file.fail(row, "an orbit needs a_m > 0 and 0 <= e < 1");
    auto at = std::find_if(orbits.begin(), orbits.end(), [&](const Orbit& o) { return o.a == a && o.e == e; });
    if (at == orbits.end()) at = orbits.insert(orbits.end(), Orbit{a, e, {}});
    at->rows.push_back(&row);
  }
  return orbits;
}

OrbitState periapsis(const Orbit& orbit, double gm) {
  return {orbit.a * (1 - orbit.e), 0, 0, std::sqrt(gm / orbit.a * (1 + orbit.e) / (1 - orbit.e))};
}

/// The largest change of the energy over the revolution, relative to it.
void report_energy_drift(const Flight& flight, double gm, const Method& method, const std::string& label,
                         SuiteResult& result) {
  const auto energy = [&](double time) {
    const Sample s = flight.at(time);
    return 0.5 * s.speed * s.speed - gm / length(s.position + Vec3d{0, kMeanRadius, 0});
  };
  double drift = 0;
  for (const double time : flight.step_times()) drift = std::max(drift, std::abs(energy(time) / energy(0) - 1));
  result.compare("kepler_orbits energy " + method.name, "energy drift " + label, 0, drift, kEnergyDrift,
                 complaint(flight, method.fidelity));
}

void check_orbit(const CsvFile& file, const Orbit& orbit, double gm, const Method& method, SuiteResult& result) {
  ShotInPlace shot = shot_around(gm, kMeanRadius);
  const OrbitState start = periapsis(orbit, gm);
  shot.launch.position = {start.y, start.x - kMeanRadius, 0};
  shot.launch.velocity = Vec3d{start.vy, start.vx, 0};
  shot.until.ground = std::nullopt;
  shot.until.time = 0;
  for (const CsvRow* row : orbit.rows) shot.until.time = std::max(shot.until.time, file.needed(*row, "t_s"));
  const Flight flight = shot.fly(method);
  PHYSIM_ASSERT(!orbit.rows.empty());
  const double gate = orbit.e == 0 ? 1e-5 : 1e-4;
  for (const CsvRow* row : orbit.rows) {
    const double t = file.needed(*row, "t_s");
    const Sample sample = flight.at(t);
    RowCheck check(file, *row, method, label_of(file, *row, {{"a", "a_m"}, {"e", "e"}, {"t", "t_s"}}),
                   complaint(flight, method.fidelity), result);
    check.compare_within("x_m", sample.position.y + kMeanRadius, gate);
    check.compare_within("y_m", sample.position.x, gate);
    check.compare_within("vx_m_s", sample.velocity.y, method.relative * sample.speed);
    check.compare_within("vy_m_s", sample.velocity.x, method.relative * sample.speed);
  }
  report_energy_drift(flight, gm, method, formatted("a=%.6g e=%g", orbit.a, orbit.e), result);
}

// ------------------------------------------------------------------------------------------------------ turning frames
std::vector<Method> with_coriolis() {
  std::vector<Method> methods = integrators();
  for (Method& method : methods) method.fidelity.earth = EarthModel::flat_coriolis;
  return methods;
}

/// For a time, over no ground.
void fly_for(double time, ShotInPlace& shot) {
  shot.until.ground = std::nullopt;
  shot.until.time = time;
}

std::vector<Method> with_magnus() {
  std::vector<Method> methods = integrators();
  for (Method& method : methods) {
    method.fidelity.drag = DragModel::equation;
    method.fidelity.air = AirModel::constant;
    method.fidelity.rotation = RotationModel::magnus;
  }
  return methods;
}

/// A ball without drag with the lift kappa x v, for any kappa in W: rho A l r / (2 m) omega = kappa.
void spin_by(const Vec3d& kappa, ShotInPlace& shot) {
  constexpr double kDensity = 1.2, kRadius = 0.1, kArea = 0.0314159265358979323846;
  shot.environment.atmosphere.model = AirModel::constant;
  shot.environment.atmosphere.density = kDensity;
  shot.projectile.diameter = 2 * kRadius;
  shot.projectile.drag.coefficient = 0;
  shot.projectile.magnus.lift = 1;
  const Vec3d omega = kappa * (2 * shot.projectile.mass / (kDensity * kArea * kRadius));
  const Vec3d& v = *shot.launch.velocity;
  const double level = std::hypot(v.x, v.z);
  const Vec3d forward = v * (1 / length(v)), right{-v.z / level, 0, v.x / level};
  shot.launch.spin = {dot(omega, right), -dot(omega, cross(right, forward)), dot(omega, forward)};
}

/// "v0=(30,0,20)"
Vec3d launch_velocity(const CsvFile& file) {
  const std::string& text = file.comments();
  const auto open = text.find("v0=(");
  const auto close = open == std::string::npos ? open : text.find(')', open);
  if (close == std::string::npos) return {30, 0, 20};
  std::string list = text.substr(open + 4, close - open - 4);
  double v[3] = {};
  for (double& component : v) {
    const auto comma = std::min(list.find(','), list.size());
    component = parse_number(list.substr(0, comma)).value_or(kNaN);
    list.erase(0, std::min(comma + 1, list.size()));
  }
  return {v[0], v[1], v[2]};
}

/// The file's z is up and its x downrange: a turn about x.
Vec3d into_W(const Vec3d& v) { return {v.x, v.z, -v.y}; }
Vec3d from_W(const Vec3d& v) { return {v.x, -v.z, v.y}; }

// ------------------------------------------------------------------------------------------------ bodies that turn
constexpr double kSlugFt2 = 14.5939029372 * 0.3048 * 0.3048;  // [kg m^2]

/// Moments about forward, right and down [kg m^2], as the comments state them: "(A,B,C slug ft2)".
Vec3d stated_moments(const CsvFile& file) {
  Vec3d m;
  const std::size_t at = file.comments().find('(');
  if (at == std::string::npos || std::sscanf(file.comments().c_str() + at, "(%lf,%lf,%lf slug", &m.x, &m.y, &m.z) != 3)
    throw DataError{{.message = "the comments do not state the moments of inertia", .place = file.name()}};
  return m * kSlugFt2;
}

void compare_rotation(const CsvFile& file, const CsvRow& row, const Flight& flight, const Vec3d& moments,
                      const Method& method, SuiteResult& result) {
  RowCheck check(file, row, method, label_of(file, row, {{"t", "t_s"}}), complaint(flight, method.fidelity), result);
  const Vec3d w = flight.at(file.needed(row, "t_s")).angular_velocity;  // forward, up, right
  const Vec3d momentum = component_product(moments, w);
  const double size = length(w) / kDegree;
  check.compare("p_deg_s", w.x / kDegree, size);
  check.compare("q_deg_s", w.z / kDegree, size);
  check.compare("r_deg_s", -w.y / kDegree, size);
  check.compare("kinetic_energy_J", 0.5 * dot(momentum, w));
  check.compare("ang_momentum_kg_m2_s", length(momentum));
}

}  // namespace

void kepler_orbits(const CsvFile& file, SuiteResult& result) {
  file.require({"a_m", "e", "t_s", "x_m", "y_m"});
  const double gm = file.constant("GM", kEarthGM);
  for (const Method& method : on_the_sphere())
    for (const Orbit& orbit : orbits_of(file)) check_orbit(file, orbit, gm, method, result);
}

void newton_gravity_range(const CsvFile& file, SuiteResult& result) {
  file.require({"v0_m_s", "elev_deg"});
  const double radius = file.constant("R", kMeanRadius);
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_around(file.constant("GM", kEarthGM), radius);
    shot.launch.speed = file.needed(row, "v0_m_s");
    shot.launch.elevation = file.needed(row, "elev_deg") * kDegree;
    shot.until.events = {{.kind = EventKind::apex}};
    const std::string label = label_of(file, row, {{"v0", "v0_m_s"}, {"elev", "elev_deg"}});
    fly_row(file, row, label, on_the_sphere(), shot, result, [&](RowCheck& check, const Flight& flight) {
      const Vec3d end = flight.end().position, apex = apex_of(flight).position;
      check.compare("ground_range_m", radius * std::atan2(end.x, end.y + radius));
      check.compare("apex_height_m", std::hypot(apex.x, apex.y + radius) - radius);
      check.compare("t_flight_s", flight.duration());
    });
  }
}

void radial_fall_newton(const CsvFile& file, SuiteResult& result) {
  file.require({"h_m"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_around(file.constant("GM", kEarthGM), file.constant("R", kMeanRadius));
    shot.launch.position = {0, file.needed(row, "h_m"), 0};
    shot.launch.velocity = Vec3d{};
    const std::string label = label_of(file, row, {{"h", "h_m"}});
    fly_row(file, row, label, on_the_sphere(), shot, result, [](RowCheck& check, const Flight& flight) {
      check.compare("t_s", flight.duration());
      check.compare("v_impact_m_s", flight.end().speed);
    });
  }
}

void coriolis_uniform_g(const CsvFile& file, SuiteResult& result) {
  file.require({"case", "lat_deg", "t_s"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_under(file.constant("g", kStandardGravity));
    const double azimuth = file.number(row, "az_deg").value_or(0) * kDegree;
    shot.environment.earth = {.latitude = file.needed(row, "lat_deg") * kDegree,
                              .azimuth = azimuth,
                              .rotation_rate = file.constant("w", 7.292115e-5)};
    const std::string& kind = file.text(row, "case");
    if (kind == "drop") {
      shot.launch.velocity = Vec3d{};
    } else {
      shot.launch.speed = file.needed(row, "h_m_or_v0");
      shot.launch.elevation = file.needed(row, "elev_deg") * kDegree;
    }
    const std::string label =
        kind + " " +
        label_of(file, row, {{"lat", "lat_deg"}, {"h/v0", "h_m_or_v0"}, {"elev", "elev_deg"}, {"az", "az_deg"}});
    fly_for(file.needed(row, "t_s"), shot);
    fly_row(file, row, label, with_coriolis(), shot, result, [&](RowCheck& check, const Flight& flight) {
      const Vec3d end = flight.end().position;
      check.compare("east_m", end.x * std::sin(azimuth) + end.z * std::cos(azimuth), length(end));
      check.compare("north_m", end.x * std::cos(azimuth) - end.z * std::sin(azimuth), length(end));
      check.compare("up_m", end.y, length(end));
    });
  }
}

void magnus_constant_kappa(const CsvFile& file, SuiteResult& result) {
  file.require({"kx_1_s", "ky_1_s", "kz_1_s", "t_s"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_under(file.constant("g", kStandardGravity));
    const Vec3d kappa = {file.needed(row, "kx_1_s"), file.needed(row, "ky_1_s"), file.needed(row, "kz_1_s")};
    shot.launch.velocity = into_W(launch_velocity(file));
    spin_by(into_W(kappa), shot);
    const std::string label = label_of(file, row, {{"kx", "kx_1_s"}, {"ky", "ky_1_s"}, {"kz", "kz_1_s"}, {"t", "t_s"}});
    fly_for(file.needed(row, "t_s"), shot);
    fly_row(file, row, label, with_magnus(), shot, result, [](RowCheck& check, const Flight& flight) {
      const Vec3d x = from_W(flight.end().position), v = from_W(flight.end().velocity);
      check.compare("x_m", x.x, length(x));
      check.compare("y_m", x.y, length(x));
      check.compare("z_m", x.z, length(x));
      check.compare("vx", v.x, length(v));
      check.compare("vy", v.y, length(v));
      check.compare("vz", v.z, length(v));
    });
  }
}

void torque_free_body(const CsvFile& file, SuiteResult& result) {
  file.require({"t_s", "p_deg_s", "q_deg_s", "r_deg_s"});
  const Vec3d stated = stated_moments(file);
  const CsvRow* first = nullptr;
  double last = 0;
  for (const CsvRow& row : file.rows()) {
    last = std::max(last, file.needed(row, "t_s"));
    if (file.needed(row, "t_s") == 0) first = &row;
  }
  if (first == nullptr) throw DataError{{.message = "no row at time 0 tells how it starts", .place = file.name()}};
  for (Method method : integrators()) {
    method.fidelity.rotation = RotationModel::rigid_body;
    method.fidelity.gravity = GravityModel::off;
    ShotInPlace shot = shot_under(kStandardGravity);
    shot.projectile.inertia.moments = {stated.x, stated.z, stated.y};
    shot.launch.attitude.rates =
        Vec3d{file.needed(*first, "p_deg_s"), -file.needed(*first, "r_deg_s"), file.needed(*first, "q_deg_s")} *
        kDegree;
    shot.until = {.ground = std::nullopt, .time = std::max(last, 1e-3)};
    const Flight flight = shot.fly(method);
    for (const CsvRow& row : file.rows())
      compare_rotation(file, row, flight, shot.projectile.inertia.moments, method, result);
  }
}

}  // namespace physim::validation
