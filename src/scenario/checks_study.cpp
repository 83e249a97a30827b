// Contradictions of a [study], in the places of its texts.
#include <algorithm>

#include "base/assert.hpp"
#include "scenario/checks.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/study_text.hpp"
#include "study/check_study.hpp"

namespace physim {
namespace {

constexpr std::string_view kOfStudy = "study.";
/// What a study of a shot objects to. Inputs may still come from options.
std::vector<Error> mistakes_of_study(const Scenario& scenario, const ScenarioShot& shot) {
  std::vector<Error> errors;
  const Study study = read_study(scenario, shot, errors);
  if (!errors.empty() || study.inputs.empty()) return errors;
  const Status status = check(study, true, &errors);
  PHYSIM_ASSERT(status.ok() == errors.empty());
  return errors;
}

/// A path leads to a text, or to something in it.
bool leads_to(std::string_view path, std::string_view text) {
  PHYSIM_ASSERT(!text.empty());
  if (!path.starts_with(text)) return false;
  path.remove_prefix(text.size());
  return path.empty() || path.front() == '.' || path.front() == '[';
}

}  // namespace

void note_study_places(ScenarioStudy& study, const Value& document) {
  const Value* table = document.find("study");
  const Table* members = table ? table->get<Table>() : nullptr;
  if (members == nullptr) return;
  PHYSIM_ASSERT(study.places.empty());
  for (const Member& member : *members) {
    study.places.push_back({member.key, member.value.place.text()});
    const Array* texts = member.value.get<Array>();
    for (std::size_t i = 0; texts != nullptr && i < texts->size(); ++i)
      study.places.push_back({member.key + '[' + std::to_string(i) + ']', (*texts)[i].place.text()});
  }
}

Error in_study(const ScenarioStudy& study, Error error) {
  std::string_view path = error.place;
  if (path.starts_with(kOfStudy)) path.remove_prefix(kOfStudy.size());
  const GivenSetting* nearest = nullptr;
  for (const GivenSetting& each : study.places)
    if (leads_to(path, each.path) && (nearest == nullptr || each.path.size() > nearest->path.size())) nearest = &each;
  if (nearest == nullptr) return error;
  error.message = std::string(kOfStudy) + std::string(path) + ": " + error.message;
  error.place = nearest->place;
  return error;
}

void check_study(const Scenario& scenario, const Value& document, Mistakes& mistakes) {
  const Value* table = document.find("study");
  if (table == nullptr || scenario.world.given) return;  // a study flies shots alone
  std::vector<Error> first;
  for (const ScenarioShot& shot : scenario.shots) {
    std::vector<Error> errors = mistakes_of_study(scenario, shot);
    if (errors.empty()) return;  // a study is of one shot
    if (first.empty()) first = std::move(errors);
  }
  for (const Error& each : first) {
    Error error = in_study(scenario.study, each);
    if (error.place == each.place) error = {each.place + ": " + each.message, table->place.text(), each.hint};
    mistakes.take(error);
  }
}

}  // namespace physim
