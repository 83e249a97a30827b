#include "report/flown.hpp"

#include <cmath>

#include "report/number.hpp"
#include "scenario/expectation.hpp"
#include "scenario/units.hpp"

namespace physim::report {
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

Result<std::size_t> find_shot(const Scenario& scenario, const std::string& wanted) {
  std::string names;
  for (std::size_t i = 0; i < scenario.shots.size(); ++i) {
    const std::string& name = scenario.shots[i].projectile.name;
    if (wanted.empty() || name == wanted) return i;
    names += (names.empty() ? "\"" : ", \"") + name + "\"";
  }
  return Error{
      .message = "there is no shot \"" + wanted + "\"", .place = scenario.file, .hint = "its shots are " + names};
}

Error about(const Scenario& scenario, const ScenarioShot& shot, Error error) {
  const std::string field = error.place.empty() ? "" : ": " + error.place;
  error.place = scenario.file + ": shot \"" + shot.projectile.name + "\"" + field;
  return error;
}

Error about(const AskedShot& asked, Error error) { return about(asked.scenario, asked.shot(), std::move(error)); }

Error refusal(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight) {
  return about(scenario, shot, flight.error().value_or(Error{.message = "the flight was refused"}));
}

std::string title_of(const Scenario& scenario) { return scenario.title.empty() ? scenario.file : scenario.title; }

Status fly_all(FlownScenario& flown, const Progress& progress) {
  const Scenario& scenario = flown.scenario;
  for (const ScenarioShot& shot : scenario.shots) {
    Flight flight = fly_shot(scenario, shot);
    if (flight.outcome() == Outcome::refused) return refusal(scenario, shot, flight);
    flown.shots.push_back({shot.projectile.name, &shot, std::move(flight)});
    if (progress) progress(flown.shots.size(), scenario.shots.size());
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

}  // namespace physim::report
