#include "report/flown.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/assert.hpp"
#include "prepare/grant.hpp"
#include "report/number.hpp"
#include "report/table.hpp"
#include "scenario/expectation.hpp"
#include "scenario/names.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim::report {

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

namespace {

/// The place in a file at which a member of the library is set for a shot; empty if no file sets it.
std::string given_place(const Scenario& scenario, const ScenarioShot& shot, const std::string& member) {
  constexpr std::string_view kShot = "shot.";
  std::string path = in_files(member);
  if (path != member) path.insert(kShot.size(), shot.projectile.name + ".");
  for (std::size_t end = path.size(); end != path.npos && end > 0; end = path.find_last_of(".[", end - 1)) {
    const auto at = std::ranges::lower_bound(scenario.given, path.substr(0, end), {}, &GivenSetting::path);
    if (at != scenario.given.end() && at->path == path.substr(0, end)) return at->place;
  }
  return "";
}

}  // namespace

Error about(const Scenario& scenario, const ScenarioShot& shot, Error error) {
  if (const std::string place = given_place(scenario, shot, error.place); !place.empty()) {
    error.message = "shot \"" + shot.projectile.name + "\": " + in_files(error.place) + ": " + error.message;
    error.place = place;
    return error;
  }
  const bool is_all = error.place.empty() || error.place == "launch" || error.place == "projectile";
  const std::string field = is_all ? "" : ": " + in_files(error.place);
  error.place = scenario.file + ": shot \"" + shot.projectile.name + "\"" + field;
  return error;
}

Error about(const AskedShot& asked, Error error) { return about(asked.scenario, asked.shot(), std::move(error)); }

Error refusal(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight) {
  return about(scenario, shot, flight.error().value_or(Error{.message = "the flight was refused"}));
}

std::string title_of(const Scenario& scenario) { return scenario.title.empty() ? scenario.file : scenario.title; }

Check judged(const Expectation& expectation, const std::string& shot, Result<double> value) {
  PHYSIM_ASSERT(expectation.shot.empty() || expectation.shot == shot);
  PHYSIM_ASSERT(expectation.within >= 0);
  const bool met = value.ok() && std::abs(*value - expectation.equals) <= expectation.within;
  return {&expectation, shot, std::move(value), met};
}

namespace {
/// Adds a note if a flight ended before its motor burned. If its time ended it, the notes of the scenario say so.
void note_unlit(const Scenario& scenario, const FlownShot& shot, std::vector<std::string>& notes) {
  PHYSIM_ASSERT(shot.shot != nullptr);
  const MotorDef& motor = shot.shot->projectile.motor;
  if (motor.thrust.empty() || !flies_motors(shot.flight.fidelity_in_use().fidelity)) return;
  const double end = shot.flight.duration();
  if (motor.ignition_delay <= end || motor.ignition_delay >= scenario.until.time) return;
  notes.push_back("the motor of shot " + in_quotes(shot.name) + " never burns: the flight ends after " +
                  quantity_in_words(end, Quantity::time) + ", and shot.motor.ignition_delay is " +
                  quantity_in_words(motor.ignition_delay, Quantity::time));
}
}  // namespace

Status fly_all(FlownScenario& flown, const Progress& progress) {
  PHYSIM_ASSERT(flown.shots.empty());
  const Scenario& scenario = flown.scenario;
  const Result<SceneParts> parts = scene_parts(scenario);
  if (!parts) return parts.error();
  if (!scenario.things.empty()) flown.scene = parts->scene;
  flown.notes = notes_of_beginnings(scenario, parts->scene, parts->things);
  std::vector<FlightHits> hits;
  for (const ScenarioShot& shot : scenario.shots) {
    Flight flight = scenario.things.empty() ? fly_shot(scenario, shot) : fly_shot(scenario, shot, parts->scene);
    if (flight.outcome() == Outcome::refused) return refusal(scenario, shot, flight);
    hits.push_back(flight_hits(scenario, shot, flight, *parts));
    flown.hits.insert(flown.hits.end(), hits.back().all.begin(), hits.back().all.end());
    flown.shots.push_back({shot.projectile.name, &shot, std::move(flight)});
    note_unlit(scenario, flown.shots.back(), flown.notes);
    if (progress) progress(flown.shots.size(), scenario.shots.size());
  }
  PHYSIM_ASSERT(hits.size() == flown.shots.size());
  NameIndex names;
  for (const FlownShot& shot : flown.shots) names.add(shot.name);
  for (const Expectation& expectation : scenario.expect) {
    const auto check = [&](std::size_t i) {
      const FlownShot& shot = flown.shots[i];
      flown.checks.push_back(judged(expectation, shot.name, measure(shot.flight, hits[i], expectation)));
    };
    if (const auto named = names.find(expectation.shot); named && !expectation.shot.empty()) check(*named);
    for (std::size_t i = 0; expectation.shot.empty() && i < hits.size(); ++i) check(i);
  }
  return {};
}

std::string place_text(const Expectation& expectation) {
  const std::string value = as_typed(expectation.at_value);
  switch (expectation.at) {
    case ExpectAt::end: return expectation.thing.empty() ? "end" : one_line(expectation.thing);
    case ExpectAt::apex: return "apex";
    case ExpectAt::rail_exit: return "rail_exit";
    case ExpectAt::burnout: return "burnout";
    case ExpectAt::time: return "time " + value + " s";
    case ExpectAt::range: return "range " + value + " m";
    case ExpectAt::height: return "height " + value + " m";
  }
  PHYSIM_UNREACHABLE();
}

std::string_view unit_of(const std::string& quantity) {
  const Figure* figure = find_figure(quantity);
  const std::string_view unit = figure == nullptr ? "" : si_unit(figure->quantity);
  return unit.empty() ? "-" : unit;
}

}  // namespace physim::report
