#include "simclient/core/study_desk.hpp"

#include <algorithm>

#include "physim/quantity.hpp"
#include "simclient/core/client.hpp"

namespace physim::client {
namespace {

constexpr double kMostShots = 1e12;  // that a study beside a scene is asked for: months on one machine

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

}  // namespace

Status begin_study(Client& client) {
  const Result<Study> study = study_asked(client);
  if (!study) return study.error();
  if (Status status = client.study.run.begin(*study); !status) return status;
  client.study.begun_at = client.versions();
  for (const std::string& note : client.study.run.plan()->notes()) client.say(note);
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
  std::vector<std::string>& inputs = client.study.asked.inputs;
  const auto before = std::ranges::find_if(inputs, [&](const std::string& other) {
    const Result<StudyInput> read = parse_study_input(other);
    return read && read->path == input->path && read->added == input->added && read->drawn_for == input->drawn_for;
  });
  if (before != inputs.end())
    *before = text;
  else
    inputs.push_back(text);
  return is_changed(client), Status();
}

Status add_study_target(Client& client, const std::string& text) {
  if (const Result<StudyTarget> target = parse_study_target(text); !target) return target.error();
  client.study.asked.targets.push_back(text);
  return is_changed(client), Status();
}

void remove_study_input(Client& client, std::size_t input) {
  std::vector<std::string>& inputs = client.study.asked.inputs;
  if (input >= inputs.size()) return;
  inputs.erase(inputs.begin() + static_cast<std::ptrdiff_t>(input));
  is_changed(client);
}

void remove_study_target(Client& client, std::size_t target) {
  std::vector<std::string>& targets = client.study.asked.targets;
  if (target >= targets.size()) return;
  targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(target));
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

}  // namespace physim::client
