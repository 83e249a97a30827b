// Suite ballistics: published range tables and zeroes of exterior-ballistics tools, each a scenario with its
// [[expect]]; and densities of moist air.
#include <algorithm>

#include "physim/environment.hpp"
#include "report/number.hpp"
#include "scenario/expectation.hpp"
#include "scenario/units.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
using report::significant;
namespace {

/// "drop_m at 182.88 m", "elevation_rad".
std::string figure_name(const Expectation& expect) {
  const physim::Figure* figure = find_figure(expect.quantity);
  std::string unit(figure == nullptr ? "" : units_of(figure->quantity).front());
  std::ranges::replace(unit, '/', '_');
  const std::string place = expect.at == ExpectAt::range ? " at " + significant(expect.at_value, 6) + " m" : "";
  return expect.quantity + (unit.empty() ? "" : "_" + unit) + place;
}

void compare_scenario(const std::filesystem::path& path, SuiteResult& result) {
  const Result<Scenario> scenario = load_scenario(path.string());
  if (!scenario) throw DataError{scenario.error()};
  result.sources.push_back({path.stem().string(), scenario->source});
  for (const ScenarioShot& shot : scenario->shots) {
    const Flight flight = fly_shot(*scenario, shot);
    for (const Expectation& expect : scenario->expect) {
      if (!expect.shot.empty() && expect.shot != shot.projectile.name) continue;
      std::string problem = complaint(flight, shot.projectile.fidelity);
      const Result<double> value = measure(flight, expect);
      if (problem.empty() && !value) problem = value.error().text();
      result.compare(path.stem().string(), figure_name(expect), expect.equals, value ? *value : kNaN, expect.within,
                     problem);
    }
  }
}

void compare_air(const CsvFile& file, SuiteResult& result) {
  file.require({"case", "temperature_K", "pressure_Pa", "relative_humidity", "density_kg_m3", "gate_relative"});
  result.sources.push_back({file.name(), file.comments()});
  for (const CsvRow& row : file.rows()) {
    const double temperature = file.needed(row, "temperature_K"), pressure = file.needed(row, "pressure_Pa");
    const double humidity = file.needed(row, "relative_humidity"), expected = file.needed(row, "density_kg_m3");
    const Result<double> density = moist_air_density(temperature, pressure, humidity);
    result.compare(file.text(row, "case"),
                   formatted("density_kg_m3 at %.8g K, %.8g Pa, humidity %.8g", temperature, pressure, humidity),
                   expected, density ? *density : kNaN, file.needed(row, "gate_relative") * expected,
                   density ? "" : density.error().text());
  }
}

constexpr std::string_view kAir = "air.csv";
constexpr std::string_view kBallisticsFiles[] = {"bc1_g1_nowind.toml", kAir};

void run_ballistics(const std::filesystem::path& folder, SuiteResult& result) {
  for (const auto& path : files_in(folder, {}, ".toml")) compare_scenario(path, result);
  if (std::filesystem::is_regular_file(folder / kAir)) compare_air(CsvFile::read(folder / kAir), result);
}

}  // namespace

const Suite kBallisticsSuite = {"ballistics",
                                "Published range tables, zeroes and air densities of exterior-ballistics tools",
                                "each case's own: abs + moa of the range + rel of the value",
                                "ballistics",
                                kBallisticsFiles,
                                run_ballistics};

}  // namespace physim::validation
