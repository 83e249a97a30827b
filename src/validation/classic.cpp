// Suite classic: the published tests of the original PhySim, every column of every row, and what its two failed tests
// should have shown.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

#include "base/assert.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
namespace {

constexpr double kFrame = 1.0 / 60.0;        // [s]
constexpr Vec3d kLaunchPoint = {0, 1.5, 0};  // of every test [m]
constexpr int kLastTest = 6;

/// One published test, flown as the original did. The original looks along z.
struct Setup {
  double mass = 1;     ///< [kg]
  Vec3d velocity;      ///< [m/s]
  double gravity = 0;  ///< downwards; 0: off [m/s^2]
  double damping = 1;  ///< [-]
  Vec3d push;          ///< acceleration by the linear force of the original's force mode; zero: constants mode [m/s^2]

  [[nodiscard]] bool has_forces() const { return length_squared(push) > 0; }
};

Setup setup_of(int test) {
  PHYSIM_ASSERT(test >= 1 && test <= kLastTest);
  switch (test) {
    case 1: return {.mass = 2, .velocity = {0, 2, 35}, .gravity = 1, .damping = 0.9};
    case 2: return {.mass = 2, .velocity = {0, 0, 35}, .gravity = 1, .damping = 0.9};
    case 3: return {.mass = 2, .gravity = 4, .push = {0, 0, 10}};
    case 4: return {.mass = 1, .velocity = {0, 1, 35}};
    case 5: return {.mass = 200, .velocity = {0, 2, 40}, .gravity = 20, .damping = 0.9};
    default: return {.mass = 200, .gravity = 4, .push = {0, 4, 10}};  // 6, at elevation 4
  }
}

struct ClassicShot {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Fidelity fidelity = Fidelity::classic();
};

ClassicShot shot_of(const Setup& setup) {
  ClassicShot shot;
  shot.projectile.mass = setup.mass;
  shot.projectile.drag.damping = setup.damping;
  shot.projectile.force = setup.push * setup.mass;
  shot.launch.position = kLaunchPoint;
  shot.launch.velocity = setup.velocity;
  shot.environment.gravity = {.model = GravityModel::constant, .acceleration = setup.gravity};
  if (setup.gravity == 0) {
    shot.environment.gravity.acceleration = 9.80665;
    shot.fidelity.gravity = GravityModel::off;
  }
  if (setup.damping == 1) shot.fidelity.drag = DragModel::off;
  if (setup.has_forces()) shot.fidelity.motion = Motion::force;
  return shot;
}

Flight fly_frames(const ClassicShot& shot, int frames) {
  const Tolerance tolerance{.step = kFrame};
  const Until until{.ground = std::nullopt, .time = (frames + 0.5) * kFrame};
  return fly(shot.projectile, shot.launch, shot.environment, shot.fidelity, tolerance, until);
}

Sample at_frame(const Flight& flight, int frame) {
  PHYSIM_ASSERT(frame >= 0);
  const std::vector<double> times = flight.step_times();
  const auto index = static_cast<std::size_t>(frame);
  return flight.at(index < times.size() ? times[index] : frame * kFrame);
}

// ----------------------------------------------------------------------------------------------- the printed rows
constexpr std::array kColumns = {"x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az", "speed", "mass"};
using Row = std::array<double, kColumns.size()>;
constexpr std::size_t kVy = 4, kVz = 5, kSpeed = 9;

constexpr double kDecimal = 0.5e-6;  // half of the last decimal that the original showed

/// The columns of a sample. The original's speed was a float, as all its numbers.
Row row_of(const Sample& s) {
  const Vec3d &x = s.position, &v = s.velocity, &a = s.acceleration;
  const double speed = length(vec_cast<float>(v));
  return {x.x, x.y, x.z, v.x, v.y, v.z, a.x, a.y, a.z, speed, s.mass};
}

/// The misprints of one row; null: the figure stands as it should.
using Listed = std::array<const Misprint*, kColumns.size()>;

/// Reads "vy=-2.866667 sign lost; az=0 of the next frame" into misprints without the figures as printed.
std::map<std::string, Misprint> read_misprints(const CsvFile& file, const CsvRow& row) {
  std::map<std::string, Misprint> found;
  std::istringstream clauses(file.text(row, "misprints"));
  for (std::string clause; std::getline(clauses, clause, ';');) {
    const auto first = clause.find_first_not_of(' ');
    const auto sign = clause.find('='), end = std::min(clause.find(' ', sign), clause.size());
    if (first == std::string::npos || sign == std::string::npos || end + 1 >= clause.size())
      file.fail(row, "\"" + clause + "\" is no misprint; as in \"vy=-2.866667 sign lost\"");
    const std::string column = clause.substr(first, sign - first);
    if (std::ranges::find(kColumns, column) == kColumns.end())
      file.fail(row, "column \"" + column + "\" of a misprint is none of the table");
    const Misprint misprint{.instead = clause.substr(sign + 1, end - sign - 1), .reason = clause.substr(end + 1)};
    if (!parse_number(misprint.instead)) file.fail(row, "\"" + misprint.instead + "\" of a misprint is not a number");
    if (!found.emplace(column, misprint).second) file.fail(row, "column \"" + column + "\" is misprinted twice");
  }
  return found;
}

/// A misprinted v_z follows from the row's speed and v_y, where these stand as they should: six digits that do not come
/// from a flight.
void compare_with_speed(const Row& row, const Listed& listed, double actual, const std::string& case_name,
                        const std::string& at_frame, const std::string& problem, SuiteResult& result) {
  if (listed[kVz] == nullptr || listed[kSpeed] != nullptr) return;
  const double speed = row[kSpeed], vy = row[kVy];
  const double vz = std::sqrt(std::max(0.0, speed * speed - vy * vy));
  const double rounding = kDecimal * (speed + std::abs(vy)) + std::numeric_limits<float>::epsilon() * speed * speed;
  result.compare(case_name, "vz by speed" + at_frame, vz, actual, vz > 0 ? rounding / vz : kDecimal, problem);
}

void compare_row(const CsvFile& file, const CsvRow& row, const Flight& flight, const std::string& problem, int frame,
                 const std::string& case_name, SuiteResult& result) {
  auto misprints = read_misprints(file, row);
  const Row flown = row_of(at_frame(flight, frame));
  const std::string at_frame = formatted(" frame %d", frame);
  Row expected{};
  Listed listed{};
  for (std::size_t c = 0; c < kColumns.size(); ++c) {
    expected[c] = file.needed(row, kColumns[c]);
    if (const auto found = misprints.find(kColumns[c]); found != misprints.end()) {
      Misprint& misprint = found->second;
      misprint.figure = case_name + ", " + kColumns[c] + at_frame;
      misprint.printed = file.text(row, kColumns[c]);
      if (problem.empty() && std::abs(expected[c] - flown[c]) <= kDecimal)
        file.fail(row, "column \"" + found->first + "\" is no misprint: it was flown as printed");
      expected[c] = *parse_number(misprint.instead);
      listed[c] = &misprint;
      result.misprints.push_back(misprint);
    }
    result.compare(case_name, kColumns[c] + at_frame, expected[c], flown[c], kDecimal, problem);
  }
  compare_with_speed(expected, listed, flown[kVz], case_name, at_frame, problem, result);
}

int whole_number(const CsvFile& file, const CsvRow& row, const char* column) {
  const double value = file.needed(row, column);
  if (value != std::floor(value) || value < 0 || value > 1e6)
    file.fail(row, formatted("column \"%s\" needs a whole number", column));
  return static_cast<int>(value);
}

/// Rows of tests that fired forces: as the original failed.
bool compare_published(const CsvFile& file, SuiteResult& result) {
  if (!file.has("test") || !file.has("frame")) return false;
  file.require({"test", "frame", "x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az", "speed", "mass", "misprints"});
  std::map<int, int> last_frame;
  for (const CsvRow& row : file.rows()) {
    int& last = last_frame[whole_number(file, row, "test")];
    last = std::max(last, whole_number(file, row, "frame"));
  }
  for (const auto& [test, frames] : last_frame) {
    if (test < 1 || test > kLastTest) {
      result.skipped.push_back(formatted("test %d: the original published tests 1 to %d", test, kLastTest));
      continue;
    }
    ClassicShot shot = shot_of(setup_of(test));
    const bool one_shot = shot.fidelity.motion == Motion::force;
    shot.fidelity.original_one_shot_forces = one_shot;
    const Flight flight = fly_frames(shot, frames);
    const std::string problem = complaint(flight, shot.fidelity);
    const std::string case_name = formatted("test %d%s", test, one_shot ? " as published" : "");
    for (const CsvRow& row : file.rows())
      if (whole_number(file, row, "test") == test)
        compare_row(file, row, flight, problem, whole_number(file, row, "frame"), case_name, result);
  }
  return true;
}

// -------------------------------------------------------------------------------------- as they should have been
constexpr double kPushLasts = 1.0;  // [s]

/// A test of forces that act as long as they last: the push for a second, gravity for ever, drag as given.
ClassicShot corrected_shot(const Setup& setup, double k1, double k2) {
  ClassicShot shot = shot_of(setup);
  shot.projectile.force_duration = kPushLasts;
  shot.projectile.drag.k1 = k1;
  shot.projectile.drag.k2 = k2;
  if (k2 > 0) shot.fidelity.drag = DragModel::linear_quadratic;
  return shot;
}

/// Without drag. The frame loop may be one frame late.
void compare_corrected(int test, SuiteResult& result) {
  const Setup setup = setup_of(test);
  const ClassicShot shot = corrected_shot(setup, 0, 0);
  const Flight flight = fly_frames(shot, 120);
  const std::string problem = complaint(flight, shot.fidelity);
  const Vec3d g = {0, -setup.gravity, 0};
  const Vec3d a = setup.push;
  for (const int frame : {30, 60, 90, 120}) {
    const double t = frame * kFrame;
    const double pushed = std::min(t, kPushLasts);
    const Vec3d velocity = a * pushed + g * t;
    const Vec3d position = kLaunchPoint + a * (0.5 * pushed * pushed + pushed * (t - pushed)) + g * (0.5 * t * t);
    const Row exact = row_of({.position = position, .velocity = velocity});
    const Row flown = row_of(at_frame(flight, frame));
    const double one_frame = 1.01 * kFrame * (length(a) + length(g));
    for (const std::size_t c : {1, 2, 4, 5})
      result.compare(formatted("test %d corrected", test), formatted("%s frame %d", kColumns[c], frame), exact[c],
                     flown[c], c < 3 ? 1.5 * one_frame * t : one_frame, problem);
  }
}

/// Velocities under the push, gravity and drag k1 |v| + k2 |v|^2, by the classical Runge-Kutta method with so short
/// steps that its own error is below 1e-9 m/s.
class MeantMotion {
 public:
  MeantMotion(const Setup& setup, double k1, double k2) : setup_(setup), k1_(k1), k2_(k2) {}

  [[nodiscard]] Vec3d velocity(double time) const {
    Vec3d v;
    const auto steps = static_cast<int>(std::lround(time * kSteps));
    for (int i = 0; i < steps; ++i) v = after_step(v, i < kPushLasts * kSteps);
    return v;
  }
  /// Returns the speed at which drag ends the fall.
  [[nodiscard]] double terminal_speed() const {
    const double weight = setup_.mass * setup_.gravity;
    return (std::sqrt(k1_ * k1_ + 4 * k2_ * weight) - k1_) / (2 * k2_);
  }

 private:
  static constexpr int kSteps = 1000;  // in a second

  [[nodiscard]] Vec3d acceleration(const Vec3d& v, bool pushed) const {
    const Vec3d drag = v * ((k1_ + k2_ * length(v)) / setup_.mass);
    return (pushed ? setup_.push : Vec3d{}) + Vec3d{0, -setup_.gravity, 0} - drag;
  }
  [[nodiscard]] Vec3d after_step(const Vec3d& v, bool pushed) const {
    constexpr double h = 1.0 / kSteps;
    const Vec3d a = acceleration(v, pushed), b = acceleration(v + a * (h / 2), pushed);
    const Vec3d c = acceleration(v + b * (h / 2), pushed), d = acceleration(v + c * h, pushed);
    return v + (a + b * 2 + c * 2 + d) * (h / 6);
  }

  Setup setup_;
  double k1_, k2_;
};

/// With drag: the original's loop, which may be one frame late, and an integrator of order 5 as exact as the reference.
void compare_meant(int test, double k1, double k2, SuiteResult& result) {
  const Setup setup = setup_of(test);
  const MeantMotion meant(setup, k1, k2);
  ClassicShot loop = corrected_shot(setup, k1, k2), exact = loop;
  exact.fidelity.integrator = Integrator::tsit5;
  exact.fidelity.precision = Precision::float64;
  for (const auto& [shot, name, gate] :
       {std::tuple{&loop, "", 1.01 * kFrame * (length(setup.push) + setup.gravity)}, {&exact, " by tsit5", 1e-6}}) {
    const Flight flight = fly_frames(*shot, 480);
    const std::string problem = complaint(flight, shot->fidelity);
    const std::string case_name = formatted("test %d as meant%s", test, name);
    for (const double t : {0.5, 1.0, 2.0, 3.0, 5.0, 8.0})
      result.compare(case_name, formatted("speed t=%g", t), length(meant.velocity(t)), flight.at(t).speed, gate,
                     problem);
    result.compare(case_name, "terminal speed t=8", meant.terminal_speed(), flight.at(8).speed, 2e-4, problem);
  }
}

constexpr std::string_view kClassicFiles[] = {"tables.csv"};

void run_classic(const std::filesystem::path& folder, SuiteResult& result) {
  compare_tables(folder, kClassicFiles, "not a table of tests and frames", result, compare_published);
  for (const int test : {3, 6}) compare_corrected(test, result);
  compare_meant(3, 0, 0.4, result);
  compare_meant(6, 20, 40, result);
}

}  // namespace

const Suite kClassicSuite = {
    "classic",
    "The original PhySim (2017), replayed frame by frame in float32",
    "every column of every printed row to six decimals, as the original showed them; corrected tests: one frame of the "
    "closed form; with drag one frame of a converged integration, and 1e-6 m/s of it by an integrator of order 5",
    "classic",
    kClassicFiles,
    run_classic};

}  // namespace physim::validation
