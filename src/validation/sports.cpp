// Suite sports: balls that spin, against published flights, tour averages and measured coefficients. The balls are the
// presets; nothing is tuned.
#include <cmath>

#include "physim/body.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
namespace {

constexpr double kRpm = kPi / 30;  // [rad/s]
constexpr double kMph = 0.44704, kYard = 0.9144;

Fidelity spinning() {
  Fidelity f = Fidelity::constant_air();
  f.integrator = Integrator::dop853;
  f.rotation = RotationModel::magnus;
  return f;
}

Environment air_at_temperature(double kelvin) {
  Environment e;
  e.gravity.model = GravityModel::constant;
  e.atmosphere.model = AirModel::constant;
  e.atmosphere.temperature = kelvin;
  return e;
}

// ---------------------------------------------------------------------------------------------------- golf
constexpr double kCarryGate = 7, kDriveGate = 8;  // of the root mean square over a tour, over drives [yd]

bool is_golf_table(const CsvFile& file) {
  return file.has("v_m_s") && file.has("rpm") && file.has("CD") && file.has("CL");
}

/// Cd and Cl of the preset where a table was measured; below a spin parameter of 0.15 it has those of later balls.
void compare_golf_table(const CsvFile& file, SuiteResult& result) {
  const ProjectileDef ball = presets::golf_ball().projectile;
  for (const CsvRow& row : file.rows()) {
    Launch launch{.speed = file.needed(row, "v_m_s")};
    launch.spin.backspin = file.needed(row, "rpm") * kRpm;
    const Flight flight = fly(ball, launch, air_at_temperature(288.15), spinning(), {}, {.ground = {}, .time = 0.01});
    const double area = kPi / 4 * ball.diameter * ball.diameter;
    const double part = ball.mass / (0.5 * 1.225 * area * launch.speed * launch.speed);
    const auto add = [&](const char* column, double length_of) {
      result.compare("golf", formatted("%s at %g m/s and %g rpm", column, launch.speed, file.needed(row, "rpm")),
                     file.needed(row, column), length_of * part, 1e-3, complaint(flight, spinning()));
    };
    if (std::fmod(file.needed(row, "rpm"), 1000) != 0) continue;  // between points of the preset's table
    if (launch.speed > 28 && launch.spin.backspin * ball.diameter / 2 < 0.15 * launch.speed) continue;
    add("CD", length(flight.accelerations(0).drag));
    add("CL", length(flight.accelerations(0).lift));
  }
}

/// The errors of one tour, gathered.
struct Tour {
  std::string name;
  double squares = 0;
  int rows = 0;
  std::string problem;
};

/// Carries in calm air of 77 degF at sea level, which TrackMan normalizes its averages to; judged by their root mean
/// square, since rows are averages of many players with many clubs.
void compare_carries(const CsvFile& file, SuiteResult& result) {
  file.require({"ball_speed_mph", "launch_deg", "spin_rpm", "carry_yd"});
  const bool is_drives = file.name() == "golf_drives.csv";
  const ProjectileDef ball = presets::golf_ball().projectile;
  std::vector<Tour> tours;
  Tour all{.name = "all tours"};
  for (const CsvRow& row : file.rows()) {
    Launch launch{.speed = file.needed(row, "ball_speed_mph") * kMph,
                  .elevation = file.needed(row, "launch_deg") * kDegree};
    launch.spin.backspin = file.needed(row, "spin_rpm") * kRpm;
    const Flight flight = fly(ball, launch, air_at_temperature(298.15), spinning());
    const double off = flight.end().position.x / kYard - file.needed(row, "carry_yd");
    const std::string name = file.text(row, "tour").empty() ? "tour" : file.text(row, "tour");
    if (tours.empty() || tours.back().name != name) tours.push_back({.name = name});
    for (Tour* tour : {&tours.back(), &all}) {
      tour->squares += off * off;
      ++tour->rows;
      if (tour->problem.empty()) tour->problem = complaint(flight, spinning());
    }
  }
  if (tours.size() > 1) tours.push_back(all);
  for (const Tour& tour : tours)
    result.compare("golf", "carry off by [yd], root mean square, " + tour.name, 0, std::sqrt(tour.squares / tour.rows),
                   is_drives ? kDriveGate : kCarryGate, tour.problem);
}

// ---------------------------------------------------------------------------------------------------- baseball
constexpr double kFlyBallGate = 1.4 * kFoot;

/// 103 mph, 27.5 deg, 2500 rpm of backspin, 70 degF, 29.92 inHg, 50 %, 15 ft above the sea; x and height in feet.
void compare_fly_ball(const CsvFile& file, SuiteResult& result) {
  file.require({"t", "y", "z"});
  Environment e = air_at_temperature(294.26);
  e.gravity.acceleration = 32.174 * kFoot;
  e.altitude = 15 * kFoot;
  e.atmosphere.humidity = 0.5;
  Launch launch{.position = {2 * kFoot, 3 * kFoot, 0}, .speed = 103 * kMph, .elevation = 27.5 * kDegree};
  launch.spin.backspin = 2500 * kRpm;
  const Flight flight = fly(presets::baseball().projectile, launch, e, spinning());
  const std::string problem = complaint(flight, spinning());
  for (const CsvRow& row : file.rows()) {
    const double t = file.needed(row, "t");
    const Vec3d x = flight.at(t).position;
    const auto add = [&](const char* name, const char* column, double actual) {
      result.compare("baseball", formatted("%s at %.2f s [m]", name, t), file.needed(row, column) * kFoot,
                     t <= flight.duration() + 0.05 ? actual : kNaN, kFlyBallGate, problem);
    };
    add("distance", "y", x.x);
    add("height", "z", x.y);
  }
}

// ---------------------------------------------------------------------------------------------------- football
/// Cd of a ball that does not spin, as the preset reads it.
void compare_football(const CsvFile& file, SuiteResult& result) {
  file.require({"v_m_s", "CD"});
  const ProjectileDef ball = presets::football().projectile;
  for (const CsvRow& row : file.rows()) {
    const double v = file.needed(row, "v_m_s");
    const Flight flight =
        fly(ball, {.speed = v}, air_at_temperature(288.15), spinning(), {}, {.ground = {}, .time = 0.01});
    const double area = kPi / 4 * ball.diameter * ball.diameter;
    const double cd = length(flight.accelerations(0).drag) * ball.mass / (0.5 * 1.225 * v * v * area);
    result.compare("football", formatted("Cd without spin at %g m/s", v), file.needed(row, "CD"), cd,
                   0.012,  // straight lines between the points of the preset's table
                   complaint(flight, spinning()));
  }
}

constexpr std::string_view kSportsFiles[] = {"golf_carry.csv",
                                             "golf_trackman_tour_averages.csv",
                                             "golf_drives.csv",
                                             "baseball_fly_ball.csv",
                                             "baseball_nathan_fly_ball.csv",
                                             "football_drag.csv",
                                             "football_goff_carre_cd_nospin.csv"};

void run_sports(const std::filesystem::path& folder, SuiteResult& result) {
  const auto paths = files_in(folder, kSportsFiles, ".csv");
  for (const auto& path : paths) {
    const CsvFile file = CsvFile::read(path);
    if (is_golf_table(file))
      compare_golf_table(file, result);
    else if (file.has("carry_yd"))
      compare_carries(file, result);
    else if (file.has("t") && file.has("y") && file.has("z"))
      compare_fly_ball(file, result);
    else if (file.has("v_m_s") && file.has("CD"))
      compare_football(file, result);
    else {
      result.skipped.push_back(file.name() + ": no figures that this suite knows");
      continue;
    }
    result.sources.push_back({file.name(), file.comments()});
  }
}

}  // namespace

const Suite kSportsSuite = {
    "sports",
    "Balls that spin: golf tour averages and drives at little spin, a published baseball "
    "flight, the drag of a football",
    "carry 7 yd root mean square untuned, drives at little spin 8 yd, fly ball 1.4 ft, Cd 0.012",
    "sports",
    kSportsFiles,
    run_sports};

}  // namespace physim::validation
