// Suite ballistics: published range tables, zeroes and air densities of exterior-ballistics tools.
#include "validation/ballistics.hpp"

#include <algorithm>
#include <cmath>

#include "physim/air.hpp"
#include "physim/flight.hpp"
#include "report/number.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
using report::significant;
namespace {

/// The bore elevation that makes the bullet strike where it should, above the aim at the zero range.
Result<double> zero_of(const BallisticCase& shot, double zero_range) {
  Launch launch = shot.launch;
  launch.sight.height += shot.impact_above_aim;  // a line of sight this much higher, parallel to the true one
  launch.sight.zero_range = 0;
  return zero_elevation(shot.projectile, launch, shot.environment, shot.fidelity, zero_range);
}

template <class T>
std::string problem_of(const Result<T>& result) {
  return result ? std::string() : result.error().text();
}

/// What a row of a range table can show.
struct Quantity {
  const char* column;
  const char* gate;
  double Sample::*value;
};
constexpr Quantity kQuantities[] = {
    {"drop_m", "drop", &Sample::drop},
    {"windage_m", "windage", &Sample::windage},
    {"velocity_m_s", "velocity", &Sample::speed},
    {"time_s", "time", &Sample::time},
    {"mach", "mach", &Sample::mach},
    {"energy_J", "energy", &Sample::energy},
};

/// A flown case that answers by the range as the case counts it.
class RangeTable {
 public:
  RangeTable(BallisticCase shot, double last_range) : shot_(std::move(shot)) {
    Launch launch = shot_.launch;
    if (shot_.impact_above_aim != 0 && launch.sight.zero_range > 0) {
      const auto elevation = zero_of(shot_, launch.sight.zero_range);
      if (!elevation) problem_ = elevation.error().text();
      launch.elevation = elevation ? *elevation : 0;
      launch.sight.zero_range = 0;
    }
    along_ = fly_to(launch, last_range);
    if (!shot_.range_is_horizontal || launch.sight.look_angle == 0) return;
    launch.elevation = along_->elevation();  // the same flight, with ranges counted along the horizon
    launch.sight = {};
    horizontal_ = fly_to(launch, last_range);
  }

  [[nodiscard]] Result<Sample> at(double range) const {
    if (!problem_.empty()) return Error{.message = problem_};
    if (const std::string why = complaint(*along_, shot_.fidelity); !why.empty()) return Error{.message = why};
    if (!horizontal_) return along_->at_range(range);
    const Result<Sample> there = horizontal_->at_range(range);
    return there ? Result<Sample>(along_->at(there->time)) : there;
  }

 private:
  [[nodiscard]] Flight fly_to(const Launch& launch, double range) const {
    const double slope = shot_.range_is_horizontal ? std::cos(launch.sight.look_angle) : 1.0;
    const Until until{.ground = std::nullopt, .time = 600, .range = range / slope * (1 + 1e-9)};
    return fly(shot_.projectile, launch, shot_.environment, shot_.fidelity, {}, until);
  }

  BallisticCase shot_;
  std::optional<Flight> along_, horizontal_;
  std::string problem_;
};

void compare_row(const CaseReader& row, const CaseReader& gates, const RangeTable& table, const std::string& case_name,
                 SuiteResult& result) {
  const double range = row.needed("range_m");
  const Result<Sample> sample = table.at(range);
  for (const Quantity& quantity : kQuantities) {
    const auto expected = row.number(quantity.column);
    const auto gate = read_gate(gates, quantity.gate);
    if (!expected || !gate) continue;
    result.compare(case_name, std::string(quantity.column) + " at " + significant(range, 6) + " m", *expected,
                   sample ? (*sample).*quantity.value : kNaN, gate->of(range, *expected), problem_of(sample));
  }
}

void compare_trajectories(const JsonCases& file, SuiteResult& result) {
  for (std::size_t i = 0; i < file.cases().size(); ++i) {
    const CaseReader reader(file, i);
    const auto& rows = reader.raw("rows");
    if (!rows.is_array() || rows.empty()) reader.fail("\"rows\" is not a list of rows");
    if (!reader.raw("gate").is_object()) reader.fail("\"gate\" is missing");
    double last_range = 0;
    for (std::size_t r = 0; r < rows.size(); ++r)
      last_range = std::max(last_range, reader.element("rows", r).needed("range_m"));
    const RangeTable table(read_ballistic_case(reader), last_range);
    for (std::size_t r = 0; r < rows.size(); ++r)
      compare_row(reader.element("rows", r), reader.object("gate"), table, file.id(i), result);
  }
}

void compare_zeroes(const JsonCases& file, SuiteResult& result) {
  for (std::size_t i = 0; i < file.cases().size(); ++i) {
    const CaseReader reader(file, i);
    const BallisticCase shot = read_ballistic_case(reader);
    const double range = reader.needed("zero_range_m");
    const Result<double> elevation = zero_of(shot, range);
    const double expected = reader.needed("expected_elevation_rad"), gate = reader.needed("gate_rad");
    result.compare(file.id(i), "elevation_rad for " + significant(range, 6) + " m", expected,
                   elevation ? *elevation : kNaN, gate, problem_of(elevation));
  }
}

/// "288.15 K, 101325 Pa, humidity 0.5"
std::string air_label(const CaseReader& reader) {
  std::string label;
  const auto add = [&](const char* key, const char* before, const char* after) {
    const auto value = reader.number(key);
    if (value) label += (label.empty() ? "" : ", ") + (before + significant(*value, 8) + after);
  };
  add("temperature_K", "", " K");
  add("pressure_Pa", "", " Pa");
  add("relative_humidity", "humidity ", "");
  add("altitude_m", "", " m");
  return label;
}

/// Density of the air of a case: of its station, or of the standard atmosphere through it.
Result<double> density_of(const CaseReader& reader) {
  const auto temperature = reader.number("temperature_K");
  const auto pressure = reader.number("pressure_Pa");
  if (temperature && pressure)
    return moist_air_density(*temperature, *pressure, reader.number_or("relative_humidity", 0));
  Environment environment;
  read_air(reader, environment);
  const auto air = air_at(environment, environment.altitude);
  return air ? Result<double>(air->density) : Result<double>(air.error());
}

void compare_air(const JsonCases& file, SuiteResult& result) {
  for (std::size_t i = 0; i < file.cases().size(); ++i) {
    const CaseReader reader(file, i);
    const double expected = reader.needed("expected_density_kg_m3");
    const Result<double> density = density_of(reader);
    result.compare(file.id(i), "density_kg_m3 at " + air_label(reader), expected, density ? *density : kNaN,
                   reader.number_or("gate_abs_kg_m3", 0) + reader.number_or("gate_rel", 0) * std::abs(expected),
                   problem_of(density));
  }
}

constexpr std::string_view kFiles[] = {"trajectories.json", "zero.json", "air.json"};
using Reader = void (*)(const JsonCases& file, SuiteResult& result);
constexpr Reader kReaders[] = {compare_trajectories, compare_zeroes, compare_air};

void run(const std::filesystem::path& folder, SuiteResult& result) {
  for (const auto& path : files_in(folder, kFiles, ".json")) {
    const std::string name = path.filename().string();
    const auto known = std::find(std::begin(kFiles), std::end(kFiles), name);
    if (known == std::end(kFiles)) {
      result.skipped.push_back(name + ": neither trajectories.json, zero.json nor air.json");
      continue;
    }
    const JsonCases file(path);
    for (std::size_t i = 0; i < file.cases().size(); ++i) result.sources.push_back({file.id(i), file.source(i)});
    kReaders[known - std::begin(kFiles)](file, result);
  }
}

}  // namespace

const Suite kBallisticsSuite = {"ballistics",
                                "Published range tables, zeroes and air densities of exterior-ballistics tools",
                                "each case's own: abs + moa of the range + rel of the value",
                                "ballistics",
                                kFiles,
                                run};

}  // namespace physim::validation
