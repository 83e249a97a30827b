// Scenario files: text to document, overrides into it, settings out of it, contradictions.
#include "scenario/scenario.hpp"

#include <algorithm>
#include <cstdint>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/checks.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/in_place.hpp"
#include "scenario/measured_column.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/overrides.hpp"
#include "scenario/reader.hpp"
#include "scenario/text_file.hpp"

namespace physim {
namespace {

constexpr std::int64_t kFormat = 1;                     // of scenario files
constexpr std::uintmax_t kLargestScenario = 256 << 20;  // a scenario is written by people; this is a wrong file

/// The version comes first: in another version any other complaint could be wrong.
Status check_format(const Value& document, const std::string& file) {
  const Value* format = document.find("physim");
  if (format == nullptr) return Error{"the format version is missing", file + ":1:1", "write physim = 1 at the top"};
  const auto* version = format->get<std::int64_t>();
  if (version == nullptr || *version != kFormat)
    return Error{"physim: unknown format version " + shown(*format), format->place.text(),
                 "this program reads version 1"};
  return {};
}

/// What a table cannot say about itself: default names, and where expectations stand.
/// A world objects to some joints only when it gets them.
void note_joint_places(Scenario& scenario, const Value& document) {
  for (std::size_t i = 0; i < scenario.joints.size(); ++i) {
    const Value& table = element(document, "joint", i);
    auto& places = scenario.joint_places.emplace_back();
    places[""] = table.place.text();
    for (const Member& member : *table.get<Table>()) places["joint." + member.key] = member.value.place.text();
  }
}

void complete(Scenario& scenario, const Value& document) {
  for (std::size_t i = 0; i < scenario.shots.size(); ++i) {
    const Value& shot = element(document, "shot", i);
    scenario.shots[i].projectile.name = shot_name(shot, i);
    // A velocity takes the place of the speed that a preset brought along.
    if (shot.find("preset") && shot.find("velocity") && !shot.find("speed")) scenario.shots[i].launch.speed = 0;
  }
  complete_world(scenario, document);
  for (std::size_t i = 0; i < scenario.expect.size(); ++i)
    scenario.expect[i].place = element(document, "expect", i).place.text();
  note_joint_places(scenario, document);
}

/// The values in a table, but for those in lists of tables.
void add_given(const Value& table, const std::string& head, std::vector<GivenSetting>& given) {
  for (const Member& member : *table.get<Table>()) {
    const Array* array = member.value.get<Array>();
    const bool is_list_of_tables = array != nullptr && !array->empty() && array->front().get<Table>() != nullptr;
    if (member.value.get<Table>() != nullptr)
      add_given(member.value, head + member.key + ".", given);
    else if (!head.empty() || !is_list_of_tables)
      given.push_back({head + member.key, member.value.place.text()});
  }
}

std::vector<GivenSetting> given_settings(const Scenario& scenario, const Value& document) {
  std::vector<GivenSetting> given;
  add_given(document, "", given);
  for (std::size_t i = 0; i < scenario.shots.size(); ++i)
    add_given(element(document, "shot", i), "shot." + scenario.shots[i].projectile.name + ".", given);
  std::ranges::sort(given, {}, &GivenSetting::path);
  return given;
}

/// Tables of measurements that the study names are files of the scenario, though only a study reads them.
Status begin_reading_measurements(const Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.study.inputs.size(); ++i) {
    const std::string_view file = file_of_column(scenario.study.inputs[i]);
    if (file.empty()) continue;
    Status begun = begin_reading(beside_scenario(scenario, std::string(file)), kMeasurements);
    if (!begun)
      return in_study(scenario, scenario.shots.front(),
                      {begun.error().message, "study.inputs[" + std::to_string(i) + ']', begun.error().hint});
  }
  return {};
}

}  // namespace

namespace {

/// Reads a document that has no distribution in the place of a number.
Status read_plain(const Value& document, const std::string& file, Checks checks, Scenario& scenario) {
  const FilesInUse in_use;
  const Value* shots = document.find("shot");
  const Array* array = shots ? shots->get<Array>() : nullptr;
  const Error no_shot{"the scenario has no shot", shots ? shots->place.text() : file + ":1:1", "add a [[shot]]"};
  if (array != nullptr && array->empty()) return no_shot;
  scenario.file = file;
  std::int64_t format = kFormat;
  const Scope scope{.format = &format, .scenario = &scenario};
  if (Status status = read_table(schema(), scope, document, checks); !status) return status;
  if (shots == nullptr) return no_shot;  // unknown keys, of which one may be a misspelling, come first
  PHYSIM_ASSERT(format == kFormat);
  PHYSIM_ASSERT(scenario.shots.size() == array->size());
  complete(scenario, document);
  note_study_places(scenario.study, document);
  if (checks == Checks::of_each) return {};
  if (Status status = complete_scene(scenario, document); !status) return status;
  if (Status status = complete_emitters(scenario, document); !status) return status;
  if (Status status = check_scenario(scenario, document); !status) return status;
  if (Status status = begin_reading_measurements(scenario); !status) return status;
  if (checks == Checks::all) {
    add_notes(scenario, document);
    scenario.given = given_settings(scenario, document);
  }
  scenario.files = in_use.inputs();
  return {};
}

}  // namespace

Status read_scenario(const Value& document, const std::string& file, Checks checks, Scenario& scenario) {
  const IeeeMode mode;
  const FilesInUse in_use;
  if (Status status = check_format(document, file); !status) return status;
  if (!may_have_distributions(document, &schema())) return read_plain(document, file, checks, scenario);
  Value plain = document;
  if (Status status = take_distributions(plain, file); !status) return status;
  if (Status status = read_plain(plain, file, checks, scenario); !status) return status;
  if (checks != Checks::of_each) scenario.files = in_use.inputs();
  return {};
}

Result<std::vector<std::string>> notes_of(Scenario scenario, Value document) {
  const IeeeMode mode;
  const FilesInUse in_use;
  PHYSIM_ASSERT(!scenario.shots.empty());
  if (may_have_distributions(document, &schema()))
    if (Status status = take_distributions(document, scenario.file); !status) return status.error();
  add_notes(scenario, document);
  return std::move(scenario.notes);
}

const ScenarioEmitter* emitter_alone_of(const Scenario& scenario, std::string_view shot) {
  const auto fires = [&](const ScenarioEmitter& emitter) { return emitter.shot == shot || emitter.tracer == shot; };
  if (std::ranges::find(scenario.volleys, shot, &Volley::shot) != scenario.volleys.end()) return nullptr;
  const auto emitter = std::ranges::find_if(scenario.emitters, fires);
  return emitter == scenario.emitters.end() ? nullptr : &*emitter;
}

namespace {

Result<Scenario> parse_with(const std::string& text, const std::string& file, std::span<const std::string> overrides,
                            bool has_complete_study) {
  const IeeeMode mode;
  Result<Value> document = parse_document(text, file);
  if (!document) return document.error();
  Mistakes mistakes;
  for (const std::string& override_text : overrides) mistakes.take(apply_override(*document, override_text));
  Scenario scenario;
  scenario.study.is_complete = has_complete_study;
  mistakes.take(read_scenario(*document, file, Checks::all, scenario));
  if (mistakes.empty()) return scenario;
  return mistakes.status().error();
}

Result<Scenario> parse_file(const std::string& text, const std::string& file, std::span<const std::string> overrides,
                            bool has_complete_study) {
  const FilesInUse in_use;
  if (Status begun = begin_reading(file, "scenario"); !begun) return begun.error();
  Result<Scenario> scenario = parse_with(text, file, overrides, has_complete_study);
  if (scenario) scenario->files = in_use.inputs();
  return scenario;
}

}  // namespace

Result<Scenario> parse_scenario(const std::string& text, const std::string& file,
                                std::span<const std::string> overrides) {
  return parse_with(text, file, overrides, true);
}

Result<std::string> read_scenario_text(const std::string& file) {
  const FilesInUse in_use;
  if (Status begun = begin_reading(file, "scenario"); !begun) return begun.error();
  return read_text_file(file, kLargestScenario, "scenario file");
}

Result<Scenario> parse_scenario_file(const std::string& text, const std::string& file,
                                     std::span<const std::string> overrides) {
  return parse_file(text, file, overrides, true);
}

Result<Scenario> load_scenario(const std::string& file, std::span<const std::string> overrides,
                               bool has_complete_study) {
  const Result<std::string> text = read_scenario_text(file);
  if (!text) return text.error();
  return parse_file(*text, file, overrides, has_complete_study);
}

}  // namespace physim
