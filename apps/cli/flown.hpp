// A scenario, loaded and flown, with its checks.
#pragma once

#include <string>
#include <vector>

#include "physim/flight.hpp"
#include "physim/scenario.hpp"

namespace physim::cli {

class Command;

/// What `run` and `compare` read: a file, and settings that replace some of its own.
struct ScenarioInput {
  std::string file;
  std::vector<std::string> overrides;
};
void add_scenario_options(Command& command, ScenarioInput& input);

struct FlownShot {
  std::string name;
  const ScenarioShot* shot;  // in FlownScenario::scenario
  Flight flight;
};

/// One [[expect]] looked up on one shot.
struct Check {
  const Expectation* expectation;
  std::string shot;
  Result<double> value;
  bool met;
};

struct FlownScenario {
  Scenario scenario;
  std::vector<FlownShot> shots;
  std::vector<Check> checks;
};

/// The title of a scenario; one without a title is called by its file.
[[nodiscard]] std::string title_of(const Scenario& scenario);

/// The error of a shot that was refused, with its scenario and name as the place.
[[nodiscard]] Error refusal(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight);

/// Flies every shot into `flown`, whose scenario is given; the error of the first that is refused.
[[nodiscard]] Status fly_all(FlownScenario& flown);

/// "end", "apex", "range 500 m": where an expectation looks.
[[nodiscard]] std::string place_text(const Expectation& expectation);
/// The SI unit of an expectation's quantity, "-" for none.
[[nodiscard]] std::string_view unit_of(const std::string& quantity);

}  // namespace physim::cli
