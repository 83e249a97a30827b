// Suite nesc: the atmospheric check-cases 1 to 10 of NASA's Engineering and Safety Center, against converged solutions.
//
// scenarios/nesc_case*.toml define them, by E. B. Jackson et al., Check-Cases for Verification of 6-Degree-of-Freedom
// Flight Vehicle Simulations, NASA/TM-2015-218675. All start over latitude 0, longitude 0; W points north there.
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/assert.hpp"
#include "scenario/scenario.hpp"
#include "validation/nesc_cases.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
namespace {

struct CheckCase {
  std::string name;  // "03_dampinertial"
  Scenario scenario;

  [[nodiscard]] const ScenarioShot& shot() const { return scenario.shots.front(); }
  [[nodiscard]] const Fidelity& fidelity() const { return shot().projectile.fidelity; }
};

/// The case of a number, in one of its variants; nothing if it does not exist.
std::optional<CheckCase> case_of(int number, const std::string& variant) {
  if (number < 1 || number > static_cast<int>(std::size(kNescCases))) return std::nullopt;
  if (!variant.empty() && !(number == 3 && variant == "dampinertial")) return std::nullopt;
  std::vector<std::string> overrides;
  if (!variant.empty()) overrides.emplace_back("shot.aero.damping_frame=inertial");
  Result<Scenario> scenario =
      parse_scenario(kNescCases[number - 1], formatted("nesc_case%02d.toml", number), overrides);
  PHYSIM_ASSERT(scenario && scenario->shots.size() == 1);
  return CheckCase{formatted("%02d", number) + (variant.empty() ? "" : "_" + variant), *std::move(scenario)};
}

// ------------------------------------------------------------------------------------------------ columns and gates
struct ColumnGate {
  const char* column;
  double gate;
  bool is_angle;  // differences are taken the shorter way round
};
constexpr ColumnGate kStateColumns[] = {
    {"altitude_m", 3e-6, false},  {"latitude_deg", 1e-11, false}, {"longitude_deg", 1e-11, true},
    {"v_north_m_s", 3e-7, false}, {"v_east_m_s", 3e-7, false},    {"v_down_m_s", 3e-7, false},
    {"yaw_deg", 1e-6, true},      {"pitch_deg", 1e-6, false},     {"roll_deg", 1e-6, true},
    {"p_deg_s", 1e-6, false},     {"q_deg_s", 1e-6, false},       {"r_deg_s", 1e-6, false},
    {"mach", 1e-9, false}};
constexpr std::size_t kColumnCount = std::size(kStateColumns);

/// The numbers of the columns at a time.
std::vector<double> state_at(const Flight& flight, double time) {
  const EarthFrames frames = flight.earth_frames();
  const Sample s = flight.at(time);
  const Geodetic place = frames.geodetic(s.position);
  const Vec3d v = frames.local(s.position, s.velocity);
  const YawPitchRoll a = frames.yaw_pitch_roll(s.position, s.orientation);
  const Vec3d& w = s.angular_velocity;
  std::vector<double> state = {place.height, place.latitude / kDegree, place.longitude / kDegree, v.y, v.x, -v.z};
  for (const double angle : {a.yaw, a.pitch, a.roll, w.x, w.z, -w.y}) state.push_back(angle / kDegree);
  state.push_back(s.mach);
  PHYSIM_ASSERT(state.size() == kColumnCount);
  return state;
}

double difference(const ColumnGate& column, double actual, double expected) {
  return column.is_angle ? std::remainder(actual - expected, 360.0) : actual - expected;
}

Flight flown(CheckCase c, double time) {
  c.scenario.until.time = time;
  return fly_shot(c.scenario, c.shot());
}

std::string complaint_of(const CheckCase& c, const Flight& flight) {
  const std::string other = complaint(flight, c.fidelity());
  if (!other.empty()) return other;
  return flight.fidelity_in_use().fidelity.gravity == c.fidelity().gravity ? "" : "granted other gravity";
}

void add_state(const CheckCase& c, const Flight& flight, SuiteResult& result) {
  StateRow row{.name = "case" + c.name, .columns = {{"t_s", flight.duration()}}};
  const auto state = state_at(flight, flight.duration());
  for (std::size_t i = 0; i < kColumnCount; ++i) row.columns.emplace_back(kStateColumns[i].column, state[i]);
  result.states.push_back(std::move(row));
}

void compare_row(const CheckCase& c, const Flight& flight, const std::string& problem, const CsvFile& file,
                 const CsvRow& row, SuiteResult& result) {
  const double time = file.needed(row, "t_s");
  const auto state = state_at(flight, time);
  for (std::size_t i = 0; i < kColumnCount; ++i) {
    const auto expected = file.number(row, kStateColumns[i].column);
    if (!expected) continue;
    result.compare("case " + c.name, kStateColumns[i].column + formatted(" at %g s", time), *expected,
                   *expected + difference(kStateColumns[i], state[i], *expected), kStateColumns[i].gate, problem);
  }
}

/// "case03_dampinertial.csv": the case and its variant.
std::optional<CheckCase> case_of_file(const std::string& name) {
  if (!name.starts_with("case") || name.size() < 10) return std::nullopt;
  const auto number = parse_number(name.substr(4, 2));
  const std::string rest = name.substr(6, name.size() - 10);
  if (!number || (!rest.empty() && rest.front() != '_')) return std::nullopt;
  return case_of(static_cast<int>(*number), rest.empty() ? "" : rest.substr(1));
}

// ------------------------------------------------------------------------------------------------ NASA's simulations
void compare_simulations(const CsvFile& file, SuiteResult& result) {
  file.require({"case", "nasa_sim", "t_s"});
  for (const CsvRow& row : file.rows()) {
    const auto number = parse_number(file.text(row, "case"));
    const auto c = number ? case_of(static_cast<int>(*number), "") : std::nullopt;
    if (!c) file.fail(row, "there is no case \"" + file.text(row, "case") + "\"");
    const double time = file.needed(row, "t_s");
    const auto state = state_at(flown(*c, time), time);
    StateRow distance{.name = "case" + c->name + ", NASA simulation " + file.text(row, "nasa_sim"), .columns = {}};
    for (std::size_t i = 0; i < 9; ++i) {
      const auto theirs = file.number(row, kStateColumns[i].column);
      distance.columns.emplace_back(kStateColumns[i].column,
                                    theirs ? difference(kStateColumns[i], *theirs, state[i]) : kNaN);
    }
    result.beside.push_back(std::move(distance));
  }
}

constexpr std::string_view kSimulations = "nasa_sims_final.csv";
constexpr std::string_view kNescFiles[] = {"case01.csv", "case02.csv", "case03.csv", "case03_dampinertial.csv",
                                           "case04.csv", "case05.csv", "case06.csv", "case07.csv",
                                           "case08.csv", "case09.csv", "case10.csv"};

void run_nesc(const std::filesystem::path& folder, SuiteResult& result) {
  std::vector<std::string> judged;
  for (const auto& path : files_in(folder, kNescFiles, ".csv")) {
    const CsvFile file = CsvFile::read(path);
    if (file.name() == kSimulations) {
      compare_simulations(file, result);
      continue;
    }
    const auto c = case_of_file(file.name());
    if (!c) {
      result.skipped.push_back(file.name() + ": no case of this name");
      continue;
    }
    file.require({"t_s"});
    result.sources.push_back({file.name(), file.comments()});
    double last = 0;
    for (const CsvRow& row : file.rows()) last = std::max(last, file.needed(row, "t_s"));
    const Flight flight = flown(*c, std::max(last, 1e-3));
    const std::string problem = complaint_of(*c, flight);
    for (const CsvRow& row : file.rows()) compare_row(*c, flight, problem, file, row, result);
    add_state(*c, flight, result);
    judged.push_back(c->name);
  }
  for (int number = 1; number <= 10; ++number) {
    const CheckCase c = *case_of(number, "");
    if (std::find(judged.begin(), judged.end(), c.name) == judged.end()) add_state(c, flown(c, 30), result);
  }
  std::sort(result.states.begin(), result.states.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
}

}  // namespace

const Suite kNescSuite = {
    "nesc",
    "NASA/NESC atmospheric check-cases 1 to 10, six degrees of freedom",
    "altitude 3e-6 m, latitude and longitude 1e-11 deg, velocity 3e-7 m/s, attitude 1e-6 deg, rates 1e-6 deg/s",
    "nesc",
    kNescFiles,
    run_nesc};

}  // namespace physim::validation
