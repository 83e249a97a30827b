// Shots of a scenario and their flights, with the scenario's checks.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "physim/flight.hpp"
#include "physim/result.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim::report {

/// A scenario and the shot in it that was asked for.
struct AskedShot {
  Scenario scenario;
  std::size_t index = 0;
  [[nodiscard]] const ScenarioShot& shot() const { return scenario.shots[index]; }
};

/// The shot of a name, the first for an empty one.
[[nodiscard]] Result<std::size_t> find_shot(const Scenario& scenario, const std::string& name);

/// An error of the library about a shot, with scenario and name as its place.
[[nodiscard]] Error about(const Scenario& scenario, const ScenarioShot& shot, Error error);
[[nodiscard]] Error about(const AskedShot& asked, Error error);
/// The error of a shot that was refused, with its scenario and name as the place.
[[nodiscard]] Error refusal(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight);

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
  std::deque<ThingHit> hits = {};       // on things, shot by shot
  std::optional<Scene> scene = {};      // of its things, where it has some
  std::vector<std::string> notes = {};  // about how shots begin
};

/// What came out of an expectation on a shot or a group.
[[nodiscard]] Check judged(const Expectation& expectation, const std::string& shot, Result<double> value);

/// The title of a scenario; one without a title is called by its file.
[[nodiscard]] std::string title_of(const Scenario& scenario);

/// Flies every shot into `flown`, which has its scenario; the error of the first that is refused.
[[nodiscard]] Status fly_all(FlownScenario& flown, const Progress& progress = {});

/// "end", "apex", "range 500 m": where an expectation looks.
[[nodiscard]] std::string place_text(const Expectation& expectation);
/// The SI unit of an expectation's quantity, "-" for none.
[[nodiscard]] std::string_view unit_of(const std::string& quantity);

}  // namespace physim::report
