// Contradictions of a [study], in the places of its texts.
#include <algorithm>

#include "base/assert.hpp"
#include "scenario/checks.hpp"
#include "study/check_study.hpp"

namespace physim {
namespace {

constexpr std::string_view kOfStudy = "study.";
constexpr std::string_view kSays = ": error: ";

/// What a study of a shot objects to. Inputs may still come from options.
Status check_study_of(const Scenario& scenario, const ScenarioShot& shot) {
  const Result<Study> study = study_of(scenario, shot);
  if (!study) return study.error();
  return study->inputs.empty() ? Status() : check(*study, true);
}

/// A path leads to a text, or to something in it.
bool leads_to(std::string_view path, std::string_view text) {
  PHYSIM_ASSERT(!text.empty());
  if (!path.starts_with(text)) return false;
  path.remove_prefix(text.size());
  return path.empty() || path.front() == '.' || path.front() == '[';
}

/// "inputs[1].path: error: ..." in the place of its text; unchanged if that is not known.
std::string put_in_place(const ScenarioStudy& study, const std::string& line) {
  const std::size_t end = line.find(kSays);
  if (end == line.npos) return line;
  std::string_view path = std::string_view(line).substr(0, end);
  if (path.starts_with(kOfStudy)) path.remove_prefix(kOfStudy.size());
  const GivenSetting* nearest = nullptr;
  for (const GivenSetting& each : study.places)
    if (leads_to(path, each.path) && (nearest == nullptr || each.path.size() > nearest->path.size())) nearest = &each;
  if (nearest == nullptr) return line;
  return nearest->place + std::string(kSays) + std::string(kOfStudy) + std::string(path) + ": " +
         line.substr(end + kSays.size());
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
  const std::string first = put_in_place(study, error.place + std::string(kSays) + error.message);
  const std::size_t end = first.find(kSays);
  error.place = first.substr(0, end);
  error.message = first.substr(end + kSays.size());
  std::string& last = error.hint.empty() ? error.message : error.hint;
  std::string all;
  for (std::size_t from = 0; from <= last.size();) {  // other mistakes, each on a line of its own
    const std::size_t to = std::min(last.find('\n', from), last.size());
    const std::string line = last.substr(from, to - from);
    all += from == 0 ? line : '\n' + put_in_place(study, line);
    from = to + 1;
  }
  last = all;
  return error;
}

Status check_study(const Scenario& scenario, const Value& document) {
  const Value* table = document.find("study");
  if (table == nullptr || scenario.world.given) return {};  // a study flies shots alone
  Status first;
  for (const ScenarioShot& shot : scenario.shots) {
    const Status status = check_study_of(scenario, shot);
    if (status) return {};  // a study is of one shot
    if (first) first = status;
  }
  if (first) return {};
  Error error = in_study(scenario.study, first.error());
  if (error.place == first.error().place) error = {error.place + ": " + error.message, table->place.text(), error.hint};
  return error;
}

}  // namespace physim
