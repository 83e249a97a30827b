#include "simclient/core/study_desk.hpp"

#include <algorithm>

#include "physim/units.hpp"
#include "report/study_answer.hpp"
#include "scenario/study_text.hpp"
#include "scenario/suggest.hpp"
#include "simclient/core/client.hpp"
#include "study/places.hpp"

namespace physim::client {
namespace {

constexpr std::string_view kEnd = "end";  // what show_study_at() calls the end
constexpr double kMostShots = 1e12;       // that a study beside a scene is asked for: months on one machine

Result<Study> study_asked(const Client& client) {
  const StudyDesk& desk = client.study;
  if (client.session.is_replay()) return Error{"a replay has no shot to study", "study", "come back from it: replay"};
  if (desk.asked.inputs.empty())
    return Error{"nothing is uncertain yet", "study", "say what is: study-input shot.speed = +- 3 m/s"};
  Scenario scenario = client.session.scenario();
  scenario.study = desk.asked;
  Result<Study> study = study_of(scenario, client.launcher.shot());
  if (!study || desk.width.empty()) return study;
  const bool hits = !study->targets.empty();
  const Result<double> width = parse_quantity(desk.width, hits ? Quantity::number : Quantity::length);
  if (!width) return Error{width.error().message, "study-width", width.error().hint};
  study->until_width = StudyWidth{.width = *width};
  if (hits) study->until_width->target = 0;
  return study;
}

/// What was flown is of another study.
void is_changed(Client& client) {
  client.study.run.clear();
  client.has_changed_settings();
}

/// A further text, or another one in the place of the first that says something of the same.
template <class IsOfTheSame>
void put(std::vector<std::string>& texts, const std::string& text, const IsOfTheSame& is_of_the_same) {
  const auto before = std::ranges::find_if(texts, is_of_the_same);
  if (before != texts.end())
    *before = text;
  else
    texts.push_back(text);
}

/// What a text of a place calls it; one that is none, itself.
std::string place_name(const std::string& text) {
  const Result<StudyPlace> place = parse_study_place(text);
  return place ? place_text(place->event) : text;
}

/// As a study will check them when it begins.
Status check_at(const std::vector<std::string>& texts) {
  const auto places = study_places_of({.at = texts});
  if (!places) return places.error();
  return check_places({.at = *places}, true);
}

}  // namespace

Status begin_study(Client& client) {
  const Result<Study> study = study_asked(client);
  if (!study) return study.error();
  if (Status status = client.study.run.begin(*study); !status) return status;
  client.study.begun_at = client.versions();
  for (const std::string& note : report::notes_of(*client.study.run.plan())) client.say(note);
  return {};
}

Status start_or_pause_study(Client& client) {
  StudyRun& run = client.study.run;
  client.bottom = BottomPanel::study;
  switch (run.state()) {
    case StudyRun::State::running: return run.pause(), Status();
    case StudyRun::State::paused: return run.go_on(), Status();
    case StudyRun::State::none:
    case StudyRun::State::done: return begin_study(client);
  }
  return {};
}

Status add_study_input(Client& client, const std::string& text) {
  const Result<StudyInput> input = parse_study_input(text);
  if (!input) return input.error();
  put(client.study.asked.inputs, text, [&](const std::string& other) {
    const Result<StudyInput> read = parse_study_input(other);
    return read && read->path == input->path && read->added == input->added && read->drawn_for == input->drawn_for;
  });
  return is_changed(client), Status();
}

Status add_study_target(Client& client, const std::string& text) {
  if (const Result<StudyTarget> target = parse_study_target(text); !target) return target.error();
  client.study.asked.targets.push_back(text);
  return is_changed(client), Status();
}

Status add_study_at(Client& client, const std::string& text) {
  if (const Result<StudyPlace> place = parse_study_place(text); !place) return place.error();
  std::vector<std::string> at = client.study.asked.at;
  put(at, text, [&](const std::string& other) { return place_name(other) == place_name(text); });
  if (Status status = check_at(at); !status) return status;
  client.study.asked.at = std::move(at);
  return is_changed(client), Status();
}

void remove_study_text(Client& client, std::vector<std::string> ScenarioStudy::*list, std::size_t text) {
  std::vector<std::string>& texts = client.study.asked.*list;
  if (text >= texts.size()) return;
  texts.erase(texts.begin() + static_cast<std::ptrdiff_t>(text));
  is_changed(client);
}

Status set_study_shots(Client& client, const std::string& text) {
  const Result<double> shots = parse_quantity(text, Quantity::number);
  if (!shots) return Error{shots.error().message, "study-shots", shots.error().hint};
  if (!(*shots >= 1 && *shots <= kMostShots))
    return Error{"must be from 1 to 1e12 shots", "study-shots", "more are for physim study, on many machines"};
  client.study.asked.shots = static_cast<std::int64_t>(*shots);
  return is_changed(client), Status();
}

Status set_study_width(Client& client, const std::string& text) {
  if (!text.empty() && !parse_quantity(text, Quantity::number) && !parse_quantity(text, Quantity::length))
    return Error{"\"" + text + "\" is no width", "study-width",
                 "as \"1 %\" of a hit probability, or \"2 mm\" of a mean"};
  client.study.width = text;
  client.study.run.clear();
  return {};
}

std::vector<std::string> place_names(const StudyDesk& desk) {
  std::vector<std::string> names;
  for (const std::string& text : desk.asked.at) names.push_back(place_name(text));
  return names;
}

Status show_study_at(Client& client, const std::string& place) {
  const std::vector<std::string> names = place_names(client.study);
  std::vector<std::string_view> known = {kEnd};
  known.insert(known.end(), names.begin(), names.end());
  const std::string name = place_name(place);
  if (std::ranges::find(known, name) == known.end())
    return Error{"the study is not told at " + in_quotes(place), "study-show",
                 suggestion(name, known, "it is told at")};
  client.study.shown_at = name;
  client.bottom = BottomPanel::study;
  return {};
}

std::optional<std::size_t> shown_place(const StudyDesk& desk) {
  const std::vector<std::string> names = place_names(desk);
  const auto shown = std::ranges::find(names, desk.shown_at);
  if (shown == names.end()) return std::nullopt;
  return static_cast<std::size_t>(shown - names.begin());
}

}  // namespace physim::client
