// The analytic case of a body that turns without torque.
#include <cmath>
#include <cstdio>

#include "validation/analytic.hpp"

namespace physim::validation {
namespace {

constexpr double kSlugFt2 = 14.5939029372 * 0.3048 * 0.3048;  // [kg m^2]

/// Moments about forward, right and down [kg m^2], as the comments state them: "(A,B,C slug ft2)".
Vec3d stated_moments(const CsvFile& file) {
  Vec3d m;
  const std::size_t at = file.comments().find('(');
  if (at == std::string::npos || std::sscanf(file.comments().c_str() + at, "(%lf,%lf,%lf slug", &m.x, &m.y, &m.z) != 3)
    throw DataError{{.message = "the comments do not state the moments of inertia", .place = file.name()}};
  return m * kSlugFt2;
}

void check_row(const CsvFile& file, const CsvRow& row, const Flight& flight, const Vec3d& moments, const Method& method,
               SuiteResult& result) {
  const double time = file.needed(row, "t_s");
  RowCheck check(file, row, method, label_of(file, row, {{"t", "t_s"}}), result);
  std::string problem = complaint(flight, method.fidelity);
  if (problem.empty() && flight.fidelity_in_use().fidelity.rotation != RotationModel::rigid_body)
    problem = "granted no rigid body";
  check.blame(problem);
  const Vec3d w = flight.at(time).angular_velocity;  // forward, up, right
  const Vec3d momentum = component_product(moments, w);
  const double size = length(w) / kRadiansPerDegree;
  check.compare("p_deg_s", w.x / kRadiansPerDegree, size);
  check.compare("q_deg_s", w.z / kRadiansPerDegree, size);
  check.compare("r_deg_s", -w.y / kRadiansPerDegree, size);
  check.compare("kinetic_energy_J", 0.5 * dot(momentum, w));
  check.compare("ang_momentum_kg_m2_s", length(momentum));
}

}  // namespace

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
        kRadiansPerDegree;
    shot.until = {.ground = std::nullopt, .time = std::max(last, 1e-3)};
    const Flight flight = shot.fly(method);
    for (const CsvRow& row : file.rows()) check_row(file, row, flight, shot.projectile.inertia.moments, method, result);
  }
}

}  // namespace physim::validation
