#include "flown.hpp"

#include <cmath>

#include "command.hpp"
#include "output_number.hpp"
#include "progress.hpp"
#include "scenario/expectation.hpp"
#include "scenario/units.hpp"

namespace physim::cli {
namespace {

std::vector<Check> check(const Scenario& scenario, const std::vector<FlownShot>& shots) {
  std::vector<Check> checks;
  for (const Expectation& expectation : scenario.expect) {
    for (const FlownShot& flown : shots) {
      if (!expectation.shot.empty() && expectation.shot != flown.name) continue;
      Result<double> value = measure(flown.flight, expectation);
      const bool met = value.ok() && std::abs(*value - expectation.equals) <= expectation.within;
      checks.push_back({&expectation, flown.name, std::move(value), met});
    }
  }
  return checks;
}

}  // namespace

void add_scenario_options(Command& command, ScenarioInput& input) {
  command.add_option("FILE", input.file, "Scenario file (TOML)").required();
  command
      .add_option("--set", input.overrides,
                  "Replace a setting of the file: --set shot.mass=\"170 gr\" for every shot, --set shot.NAME.mass=... "
                  "for one; `physim list settings` names them all. May be given many times")
      .type_name("KEY=VALUE")
      .one_value_each();
}

std::string title_of(const Scenario& scenario) { return scenario.title.empty() ? scenario.file : scenario.title; }

Error refusal(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight) {
  Error error = flight.error().value_or(Error{.message = "the flight was refused"});
  const std::string field = error.place.empty() ? "" : ": " + error.place;
  error.place = scenario.file + ": shot \"" + shot.projectile.name + "\"" + field;
  return error;
}

Status fly_all(FlownScenario& flown) {
  const Scenario& scenario = flown.scenario;
  Progress progress("flying", scenario.shots.size());
  for (const ScenarioShot& shot : scenario.shots) {
    Flight flight = fly_shot(scenario, shot);
    if (flight.outcome() == Outcome::refused) return refusal(scenario, shot, flight);
    flown.shots.push_back({shot.projectile.name, &shot, std::move(flight)});
    progress.advance();
  }
  flown.checks = check(scenario, flown.shots);
  return {};
}

std::string place_text(const Expectation& expectation) {
  const std::string value = as_typed(expectation.at_value);
  switch (expectation.at) {
    case ExpectAt::end: return "end";
    case ExpectAt::apex: return "apex";
    case ExpectAt::rail_exit: return "rail_exit";
    case ExpectAt::burnout: return "burnout";
    case ExpectAt::time: return "time " + value + " s";
    case ExpectAt::range: return "range " + value + " m";
    case ExpectAt::height: return "height " + value + " m";
  }
  return "";
}

std::string_view unit_of(const std::string& quantity) {
  const Figure* figure = find_figure(quantity);
  const std::string_view unit = figure == nullptr ? "" : si_unit(figure->quantity);
  return unit.empty() ? "-" : unit;
}

}  // namespace physim::cli
