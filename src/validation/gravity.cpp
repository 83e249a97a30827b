// Suite gravity: what a projectile at rest on the turning ellipsoid feels, against exact normal gravity and J2.
#include "report/number.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
using report::significant;
namespace {

constexpr double kGate = 1e-9;  // [m/s^2]

/// Up and north, in the local frame of the ellipsoid.
struct Felt {
  double up = kNaN, north = kNaN;
  std::string problem;
};

/// The acceleration of a projectile that is let go: gravitation and centrifugal acceleration, as a flight has them.
Felt felt_at(double latitude, double height, GravityModel gravity) {
  Environment environment;
  environment.altitude = height;
  environment.earth.latitude = latitude * kDegree;
  const Fidelity fidelity{.gravity = gravity,
                          .drag = DragModel::off,
                          .air = AirModel::vacuum,
                          .wind = WindModel::off,
                          .earth = EarthModel::ellipsoid,
                          .rotation = RotationModel::none};
  const Launch launch{.velocity = Vec3d{}};
  const Flight flight = fly({}, launch, environment, fidelity, {}, {.ground = std::nullopt, .time = 0.01});
  Felt felt{.problem = complaint(flight, fidelity)};
  if (felt.problem.empty() && flight.fidelity_in_use().fidelity.gravity != gravity)
    felt.problem = "granted other gravity";
  if (!felt.problem.empty()) return felt;
  const Vec3d a = flight.accelerations(0).total;  // W: x north, y up
  felt.up = a.y;
  felt.north = a.x;
  return felt;
}

struct Model {
  GravityModel gravity;
  const char *name, *up, *north;  // and its columns
};
constexpr Model kModels[] = {{GravityModel::wgs84, "wgs84", "gamma_up", "gamma_north"},
                             {GravityModel::j2, "j2", "J2_up", "J2_north"}};

bool compare_file(const CsvFile& file, SuiteResult& result) {
  if (!file.has("lat_deg") || !file.has("h_m")) return false;
  for (const CsvRow& row : file.rows()) {
    const double latitude = file.needed(row, "lat_deg"), height = file.needed(row, "h_m");
    const std::string place = " at " + significant(latitude, 8) + " deg, " + significant(height, 8) + " m";
    for (const Model& model : kModels) {
      const auto up = file.number(row, model.up), north = file.number(row, model.north);
      if (!up && !north) continue;
      const Felt felt = felt_at(latitude, height, model.gravity);
      if (up) result.compare(model.name, model.up + place, *up, felt.up, kGate, felt.problem);
      if (north) result.compare(model.name, model.north + place, *north, felt.north, kGate, felt.problem);
    }
  }
  return true;
}

constexpr std::string_view kGravityFiles[] = {"wgs84_normal_gravity.csv"};

void run_gravity(const std::filesystem::path& folder, SuiteResult& result) {
  compare_tables(folder, kGravityFiles, "no table of gravity by latitude and height", result, compare_file);
}

}  // namespace

const Suite kGravitySuite = {
    "gravity",     "Gravity on the turning ellipsoid: normal gravity of WGS-84, and point mass with J2",
    "1e-9 m/s^2",  "gravity",
    kGravityFiles, run_gravity};

}  // namespace physim::validation
