// Suite mccoy: six degrees of freedom of spinning shells and bullets, against published and converged figures.
//
// A folder holds the aerodynamic tables of each projectile (*_aero.csv: coef, mach, alpha2_deg2, value), its physical
// data with what was published, and converged flights. The flights are those of R. L. McCoy, Modern Exterior Ballistics
// (1999), ch. 9: shells over a flat Earth in standard air, bullets in air of one density.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include "base/assert.hpp"
#include "scenario/scenario.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
namespace {

/// The nutation of a bullet turns by 0.9 rad in this time: the method of order 8 takes no longer steps [s].
constexpr double kLongestStep = 0.5e-3;

// ------------------------------------------------------------------------------------------------ reading
std::string squeezed(const std::string& text) {
  std::string out = lower(text);
  std::erase(out, '_');
  return out;
}

/// "sierra168" is in "sierra_168gr_308_aero", "m1_105" in "howitzer_105mm_m1_aero".
bool is_of(const std::string& projectile, const std::string& file) {
  std::istringstream words(projectile);
  for (std::string word; std::getline(words, word, '_');)
    if (squeezed(file).find(squeezed(word)) == std::string::npos) return false;
  return true;
}

/// Where the coefficients of tables go; "CD0", the drag, goes into the drag curve.
const std::map<std::string, AeroCoefficient AeroDef::*> kCoefficients = {
    {"CDd2", &AeroDef::drag_yaw},       {"CLa", &AeroDef::lift},
    {"CLa0", &AeroDef::lift},           {"CLa2", &AeroDef::lift_cubic},
    {"CMa", &AeroDef::pitching},        {"CMa0", &AeroDef::pitching},
    {"CMa2", &AeroDef::pitching_cubic}, {"CMq+CMadot", &AeroDef::pitch_damping},
    {"Clp", &AeroDef::roll_damping},    {"CNpa", &AeroDef::magnus_force},
    {"CMpa", &AeroDef::magnus_moment}};

ProjectileDef read_aero(const CsvFile& file) {
  file.require({"coef", "mach", "value"});
  ProjectileDef p;
  p.drag.table = DragTable::custom;
  for (const CsvRow& row : file.rows()) {
    const std::string& name = file.text(row, "coef");
    const double angle_squared = file.number(row, "alpha2_deg2").value_or(0) * kDegree * kDegree;
    const AeroPoint point{file.needed(row, "mach"), angle_squared, file.needed(row, "value")};
    const auto found = kCoefficients.find(name);
    if (name == "CD0")
      p.drag.curve.push_back({point.mach, point.value});
    else if (found != kCoefficients.end())
      (p.aero.*(found->second)).push_back(point);
    else
      file.fail(row, "there is no coefficient \"" + name + "\"");
  }
  return p;
}

/// Physical and published figures of all projectiles, by "case quantity".
struct Facts {
  CsvFile file;
  std::map<std::string, const CsvRow*> rows;

  explicit Facts(const std::filesystem::path& path) : file(CsvFile::read(path)) {
    file.require({"case", "quantity", "value", "unit"});
    for (const CsvRow& row : file.rows()) rows[file.text(row, "case") + " " + file.text(row, "quantity")] = &row;
  }
  [[nodiscard]] std::optional<double> number(const std::string& projectile, const std::string& name,
                                             Quantity quantity) const {
    const auto found = rows.find(projectile + " " + name);
    if (found == rows.end()) return std::nullopt;
    const CsvRow& row = *found->second;
    const std::string& unit = file.text(row, "unit");
    const auto value = parse_quantity(file.text(row, "value") + " " + unit.substr(0, unit.find('(')), quantity);
    if (!value) file.fail(row, value.error().message);
    return *value;
  }
};

// ------------------------------------------------------------------------------------------------ a flight
struct Shell {
  std::string name;
  ProjectileDef body;
};

struct Firing {
  double speed = 0, elevation = 0, twist = 0, yaw_rate = 0;
  std::optional<double> range;  // of a bullet; a shell flies to the ground
  double density = 1.225, sound_speed = 340.294;
};

Flight flown(const Shell& shell, const Firing& f) {
  Environment place;
  place.gravity.model = GravityModel::constant;
  if (f.range) {
    place.atmosphere.model = AirModel::constant;
    place.atmosphere.density = f.density;
    place.atmosphere.sound_speed = f.sound_speed;
  }
  ProjectileDef body = shell.body;
  body.twist = f.twist;
  Launch launch{.speed = f.speed, .elevation = f.elevation};
  launch.attitude.rates = {0, 0, f.yaw_rate};  // nose up
  const Fidelity fidelity{.integrator = Integrator::dop853,
                          .rotation = RotationModel::rigid_body,
                          .body_form = BodyForm::axis,
                          .interpolation = Interpolation::linear};
  Until until{.time = 300};
  until.range = f.range;
  if (f.range) until.ground.reset();
  return fly(body, launch, place, fidelity, {.relative = 1e-10, .absolute = 1e-10, .max_step = kLongestStep}, until);
}

double summit(const Flight& flight) {
  double highest = 0;
  for (const Event& e : flight.events())
    if (e.kind == EventKind::apex) highest = std::max(highest, e.position.y);
  return highest;
}

/// The first maximum of the angle of attack [deg], looked for at a time step that resolves the nutation.
double first_yaw(const Flight& flight) {
  double before = 0;
  for (double t = 0; t < flight.duration(); t += 2e-5) {
    const double now = flight.at(t).angle_of_attack;
    if (now < before && before > 1e-4) return before / kDegree;
    before = now;
  }
  return kNaN;
}

/// What a firing gives, by the columns of the converged figures.
double figure_of(const Flight& flight, const std::string& column) {
  const Sample end = flight.end();
  if (column == "range_m") return end.position.x;
  if (column == "drift_right_m") return end.position.z;
  if (column == "tof_s") return end.time;
  if (column == "v_impact_m_s") return end.speed;
  if (column == "summit_m") return summit(flight);
  if (column == "first_yaw_max_deg") return first_yaw(flight);
  PHYSIM_ASSERT(column == "Sg_muzzle");
  return flight.stability(0) ? flight.stability(0)->gyroscopic : kNaN;
}

std::string complaint_of(const Flight& flight) {
  if (flight.error()) return flight.error()->text();
  const Outcome outcome = flight.outcome();
  if (outcome != Outcome::landed && outcome != Outcome::reached_range) return "it never got there";
  return flight.fidelity_in_use().fidelity.rotation == RotationModel::rigid_body ? "" : "granted no rigid body";
}

// ------------------------------------------------------------------------------------------------ figures
struct Folder {
  std::vector<Shell> shells;
  std::optional<Facts> facts;

  [[nodiscard]] const Shell* find(const std::string& name) const {
    for (const Shell& s : shells)
      if (s.name == name) return &s;
    return nullptr;
  }
};

/// Twist [m] from "18 cal" or "12 in".
std::optional<double> twist_of(const std::string& text, const Shell& shell) {
  const std::size_t space = text.find(' ');
  const auto number = parse_number(text.substr(0, space));
  if (!number || space == std::string::npos) return std::nullopt;
  const std::string unit = text.substr(space + 1);
  if (unit.starts_with("cal")) return *number * shell.body.diameter;
  const auto length = parse_quantity(text.substr(0, text.find('/')), Quantity::length);
  return length ? std::optional(*length) : std::nullopt;
}

std::optional<double> muzzle_speed(const Folder& s, const std::string& projectile, std::optional<double> charge) {
  PHYSIM_ASSERT(s.facts.has_value());
  if (charge) return s.facts->number(projectile, formatted("v0 charge %g", *charge), Quantity::speed);
  return s.facts->number(projectile, "muzzle_velocity", Quantity::speed);
}

/// "m1_105 charge7 QE70", or "sierra168 el 0.75 deg at x=914.4 m"; says what is missing.
std::optional<Firing> firing_of(const CsvFile& file, const CsvRow& row, const Folder& s, const Shell& shell) {
  const std::string& text = file.text(row, "case");
  Firing f;
  const auto speed = muzzle_speed(s, shell.name, number_after(text, "charge"));
  const auto twist = twist_of(file.text(row, "twist"), shell);
  const auto quadrant = number_after(text, "QE"), elevation = number_after(text, " el ");
  if (!speed || !twist || (!quadrant && !elevation)) return std::nullopt;
  f.speed = *speed;
  f.twist = *twist;
  f.elevation = (quadrant ? *quadrant : *elevation) * kDegree;
  if (!quadrant) f.range = number_after(text, "x=");
  f.yaw_rate = number_after(" " + file.text(row, "launch"), " ").value_or(0);
  f.density = number_after(file.comments(), "rho =").value_or(f.density);
  f.sound_speed = number_after(file.comments(), " a =").value_or(f.sound_speed);
  return f;
}

void compare_converged(const CsvFile& file, const Folder& s, SuiteResult& result) {
  file.require({"case", "twist", "launch"});
  for (const CsvRow& row : file.rows()) {
    const std::string text = file.text(row, "case");
    const Shell* shell = s.find(text.substr(0, text.find(' ')));
    const auto firing = shell && s.facts ? firing_of(file, row, s, *shell) : std::nullopt;
    const std::string name = text + ", " + file.text(row, "twist") + ", " + file.text(row, "launch");
    if (!firing) {
      result.skipped.push_back(name + ": its projectile or how it is fired is not known");
      continue;
    }
    const Flight flight = flown(*shell, *firing);
    const std::string problem = complaint_of(flight);
    StateRow state{.name = name, .columns = {}};
    for (const char* column :
         {"Sg_muzzle", "range_m", "drift_right_m", "tof_s", "v_impact_m_s", "summit_m", "first_yaw_max_deg"}) {
      const double actual = problem.empty() ? figure_of(flight, column) : kNaN;
      state.columns.emplace_back(column, actual);
      const auto expected = file.number(row, column);
      if (!expected) continue;
      // No finer than the printed digits.
      const double gate = std::max(1e-5 * std::abs(*expected), 0.5 * last_digit_unit(file.text(row, column)) * 1.0001);
      result.compare(name, column, *expected, actual, gate, problem);
    }
    result.states.push_back(std::move(state));
  }
}

/// "PUBLISHED ch7 QE70 range", "PUBLISHED Sg 1/18", "PUBLISHED spin drift at 1000 yd, twist 10 in" ...
struct Published {
  Firing firing;
  std::string column;
  double gate;  // relative
};
std::optional<Published> published_of(const Folder& s, const Shell& shell, const std::string& quantity) {
  Published p;
  const std::string& name = shell.name;
  const auto charge = number_after(quantity, " ch");
  if (charge) {
    const auto speed = muzzle_speed(s, name, charge);
    const auto elevation = number_after(quantity, "QE");
    if (!speed || !elevation) return std::nullopt;
    const std::string rate = formatted("muzzle yaw rate 1/18 ch%g %g", *charge, *elevation);
    p.firing = {.speed = *speed, .elevation = *elevation * kDegree, .twist = 18 * shell.body.diameter};
    p.firing.yaw_rate = s.facts->number(name, rate, Quantity::angular_rate).value_or(0);
    p.column = quantity.ends_with("range") ? "range_m" : quantity.ends_with("tof") ? "tof_s" : "summit_m";
    p.gate = 0.005;
    return p;
  }
  const auto speed = s.facts->number(name, "muzzle_velocity", Quantity::speed);
  if (quantity.find("spin drift at 1000 yd") != std::string::npos && speed) {
    const auto twist = number_after(quantity, "twist");
    if (!twist) return std::nullopt;
    p.firing = {.speed = *speed, .elevation = 0.75 * kDegree, .twist = *twist * 0.0254, .range = 914.4};
    p.column = "drift_right_m";
    p.gate = 0.015;
    return p;
  }
  return std::nullopt;
}

void compare_published(const Folder& s, SuiteResult& result) {
  PHYSIM_ASSERT(s.facts.has_value());
  const CsvFile& file = s.facts->file;
  for (const CsvRow& row : file.rows()) {
    const std::string& quantity = file.text(row, "quantity");
    if (!quantity.starts_with("PUBLISHED")) continue;
    const Shell* shell = s.find(file.text(row, "case"));
    const auto published = shell ? published_of(s, *shell, quantity) : std::nullopt;
    if (!published) {
      result.skipped.push_back(file.text(row, "case") + " " + quantity + ": shown, not judged");
      continue;
    }
    const bool drift = published->column == "drift_right_m", time = published->column == "tof_s";
    const auto expected = s.facts->number(shell->name, quantity, time ? Quantity::time : Quantity::length);
    const Flight flight = flown(*shell, published->firing);
    const std::string problem = complaint_of(flight);
    result.compare(shell->name + (drift ? " drifts, published" : " ranges, published"), quantity.substr(10), *expected,
                   problem.empty() ? figure_of(flight, published->column) : kNaN, published->gate * *expected, problem);
  }
}

constexpr std::string_view kFacts = "physical_and_published_results.csv";
constexpr std::string_view kConverged = "converged_6dof.csv";
constexpr std::string_view kMcCoyFiles[] = {kConverged, kFacts};

/// Projectiles of which there are both physical data and tables.
void find_shells(const std::filesystem::path& folder, Folder& s, SuiteResult& result) {
  const Facts& facts = *s.facts;
  for (const CsvRow& row : facts.file.rows()) {
    const std::string& name = facts.file.text(row, "case");
    if (facts.file.text(row, "quantity") != "mass") continue;
    for (const auto& path : files_in(folder, {}, "_aero.csv")) {
      if (!is_of(name, path.stem().string())) continue;
      const CsvFile file = CsvFile::read(path);
      Shell shell{name, read_aero(file)};
      shell.body.mass = *facts.number(name, "mass", Quantity::mass);
      shell.body.diameter = facts.number(name, "diameter", Quantity::length).value_or(0);
      shell.body.length = facts.number(name, "length", Quantity::length).value_or(0);
      const double across = facts.number(name, "Iy", Quantity::moment_of_inertia).value_or(0);
      shell.body.inertia.moments = {facts.number(name, "Ix", Quantity::moment_of_inertia).value_or(0), across, across};
      s.shells.push_back(std::move(shell));
      result.sources.push_back({file.name(), file.comments()});
    }
  }
}

void run_mccoy(const std::filesystem::path& folder, SuiteResult& result) {
  Folder s;
  if (std::filesystem::is_regular_file(folder / kFacts)) {
    s.facts.emplace(folder / kFacts);
    result.sources.push_back({s.facts->file.name(), s.facts->file.comments()});
    find_shells(folder, s, result);
    compare_published(s, result);
  }
  if (!std::filesystem::is_regular_file(folder / kConverged)) return;
  const CsvFile converged = CsvFile::read(folder / kConverged);
  result.sources.push_back({converged.name(), converged.comments()});
  compare_converged(converged, s, result);
}

}  // namespace

const Suite kMccoySuite = {
    "mccoy",
    "Six degrees of freedom of spinning shells and bullets",
    "converged figures 1e-5 relative or half the last printed digit; published ranges, times and summits 0.5 %, drifts "
    "1.5 %",
    "mccoy",
    kMcCoyFiles,
    run_mccoy};

}  // namespace physim::validation
