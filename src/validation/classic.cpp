// Suite classic: the published tests of the original PhySim, row by row, and what its two failed tests should have
// shown.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/assert.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
namespace {

constexpr double kFrame = 1.0 / 60.0;        // [s]
constexpr Vec3d kLaunchPoint = {0, 1.5, 0};  // of every test [m]
constexpr int kLastTest = 6;

/// One published test, flown as the original did. The original looks along z.
struct Setup {
  double mass = 1;             ///< [kg]
  Vec3d velocity;              ///< [m/s]
  double gravity = 0;          ///< downwards; 0: off [m/s^2]
  double damping = 1;          ///< [-]
  Vec3d applied_acceleration;  ///< by forces that the original applied for one frame [m/s^2]
};

Setup setup_of(int test) {
  PHYSIM_ASSERT(test >= 1 && test <= kLastTest);
  switch (test) {
    case 1: return {.mass = 2, .velocity = {0, 2, 35}, .gravity = 1, .damping = 0.9};
    case 2: return {.mass = 2, .velocity = {0, 0, 35}, .gravity = 1, .damping = 0.9};
    case 3: return {.mass = 2, .applied_acceleration = {0, -4, 10}};
    case 4: return {.mass = 1, .velocity = {0, 1, 35}};
    case 5: return {.mass = 200, .velocity = {0, 2, 40}, .gravity = 20, .damping = 0.9};
    default: return {.mass = 200, .applied_acceleration = {0, 0, 10}};  // 6
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
  shot.projectile.force = setup.applied_acceleration * setup.mass;
  shot.launch.position = kLaunchPoint;
  shot.launch.velocity = setup.velocity;
  shot.environment.gravity = {.model = GravityModel::constant, .acceleration = setup.gravity};
  if (setup.gravity == 0) {
    shot.environment.gravity.acceleration = 9.80665;
    shot.fidelity.gravity = GravityModel::off;
  }
  if (setup.damping == 1) shot.fidelity.drag = DragModel::off;
  if (length_squared(setup.applied_acceleration) > 0) shot.fidelity.motion = Motion::force;
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

constexpr const char* kColumns[] = {"x", "y", "z", "vx", "vy", "vz"};

double component(const Sample& sample, int column) {
  PHYSIM_ASSERT(column >= 0 && column < 6);
  const Vec3d& v = column < 3 ? sample.position : sample.velocity;
  return column % 3 == 0 ? v.x : column % 3 == 1 ? v.y : v.z;
}

/// What the note of a row says about one column.
struct Correction {
  std::string instead;        ///< the value that should stand there, as text
  bool sign_is_lost = false;  ///< the printed sign says nothing
  bool unusable = false;      ///< misprinted, and the right value is not given
};

bool mentions(const std::string& clause, const std::string& word) {
  for (auto at = clause.find(word); at != std::string::npos; at = clause.find(word, at + 1)) {
    const auto is_letter = [&](std::size_t i) { return i < clause.size() && std::isalpha(clause[i] & 0x7f) != 0; };
    if (!(at > 0 && is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  }
  return false;
}

void read_clause(const std::string& clause, std::map<std::string, Correction>& corrections) {
  std::vector<std::string> columns;
  for (const char* column : kColumns)
    if (mentions(clause, column)) columns.emplace_back(column);
  if (columns.empty()) columns.assign(std::begin(kColumns), std::end(kColumns));
  std::string instead;
  if (const auto at = clause.find("replay "); at != std::string::npos) {
    const auto first = at + 7;
    instead = clause.substr(first, clause.find_first_not_of("+-.0123456789eE", first) - first);
  }
  for (const std::string& column : columns) {
    Correction& correction = corrections[column];
    if (mentions(clause, "sign") || mentions(clause, "signs")) correction.sign_is_lost = true;
    if (!instead.empty()) correction.instead = instead;
    if (instead.empty() && clause.find("misprint") != std::string::npos) correction.unusable = true;
  }
}

/// "y misprinted (replay 1.33); vz rounded": clauses, each about the columns it names.
std::map<std::string, Correction> read_note(const std::string& note) {
  std::map<std::string, Correction> corrections;
  for (std::size_t first = 0; first < note.size();) {
    const auto last = std::min(note.find(';', first), note.size());
    read_clause(note.substr(first, last - first), corrections);
    first = last + 1;
  }
  return corrections;
}

/// Half of the last printed digit, and what rounding each frame to float can add up to.
double float_gate(const std::string& printed, double expected, double at_launch, int frame) {
  const double rounding = std::numeric_limits<float>::epsilon() * frame;
  return 0.5 * last_digit_unit(printed) + rounding * std::max(std::abs(expected), std::abs(at_launch));
}

void compare_row(const CsvFile& file, const CsvRow& row, const Flight& flight, const std::string& problem, int frame,
                 const std::string& case_name, SuiteResult& result) {
  auto corrections = read_note(file.text(row, "note"));
  const Sample start = flight.at(0);
  const Sample sample = at_frame(flight, frame);
  for (int c = 0; c < 6; ++c) {
    std::string printed = file.text(row, kColumns[c]);
    if (!file.number(row, kColumns[c])) continue;
    const Correction& correction = corrections[kColumns[c]];
    if (correction.unusable) {
      result.skipped.push_back(formatted("%s line %d %s: misprinted", file.name().c_str(), row.line, kColumns[c]));
      continue;
    }
    if (!correction.instead.empty()) printed = correction.instead;
    const auto expected = parse_number(printed);
    if (!expected) file.fail(row, "\"" + printed + "\" in the note is not a number");
    result.compare(case_name, formatted("%s frame %d", kColumns[c], frame),
                   correction.sign_is_lost ? std::copysign(*expected, component(sample, c)) : *expected,
                   component(sample, c), float_gate(printed, *expected, component(start, c), frame), problem);
  }
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
  file.require({"test", "frame", "x", "y", "z", "vx", "vy", "vz"});
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

/// A force that lasts one second: it accelerates as long as it acts, then no more. The frame loop may be one frame
/// late.
void compare_corrected(int test, double gravity, SuiteResult& result) {
  constexpr double kLasts = 1.0;  // [s]
  const Setup setup = setup_of(test);
  ClassicShot shot = shot_of(setup);
  shot.projectile.force_duration = kLasts;
  if (gravity > 0) {
    shot.environment.gravity.acceleration = gravity;
    shot.fidelity.gravity = GravityModel::constant;
  }
  const Flight flight = fly_frames(shot, 120);
  const std::string problem = complaint(flight, shot.fidelity);
  const Vec3d g = {0, -gravity, 0};
  const Vec3d a = setup.applied_acceleration;
  for (const int frame : {30, 60, 90, 120}) {
    const double t = frame * kFrame;
    const double pushed = std::min(t, kLasts);
    const Vec3d velocity = a * pushed + g * t;
    const Vec3d position = kLaunchPoint + a * (0.5 * pushed * pushed + pushed * (t - pushed)) + g * (0.5 * t * t);
    const Sample sample = at_frame(flight, frame);
    const double one_frame = 1.01 * kFrame * (length(a) + length(g));
    for (int c = 1; c < 6; ++c) {
      if (c == 3) continue;  // vx is 0
      const Sample exact{.position = position, .velocity = velocity};
      result.compare(formatted("test %d corrected", test), formatted("%s frame %d", kColumns[c], frame),
                     component(exact, c), component(sample, c), c < 3 ? 1.5 * one_frame * t : one_frame, problem);
    }
  }
}

constexpr std::string_view kClassicFiles[] = {"tables.csv"};

void run_classic(const std::filesystem::path& folder, SuiteResult& result) {
  compare_tables(folder, kClassicFiles, "not a table of tests and frames", result, compare_published);
  compare_corrected(3, 0, result);
  compare_corrected(6, 20, result);
}

}  // namespace

const Suite kClassicSuite = {
    "classic",
    "The original PhySim (2017), replayed frame by frame in float32",
    "half of the last printed digit, plus float rounding at the frame; corrected tests: one frame of the closed form",
    "classic",
    kClassicFiles,
    run_classic};

}  // namespace physim::validation
