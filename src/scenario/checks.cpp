// Checks that need more than one setting.
#include "scenario/checks.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"
#include "scenario/expectation.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/schema.hpp"
#include "scenario/study_text.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "study/plan.hpp"

namespace physim {
namespace {

Status check_direction(const Launch& launch, const Value& shot) {
  if (launch.velocity) {
    for (const auto& [key, value] : {std::pair<std::string_view, double>{"speed", launch.speed},
                                     {"elevation", launch.elevation},
                                     {"azimuth", launch.azimuth}})
      if (value != 0)
        return Error{"shot." + std::string(key) + ": given together with velocity", place_of(shot, key),
                     "give either velocity, or speed with elevation and azimuth"};
    if (launch.sight.zero_range > 0)
      return error_at(shot, "shot.sight.zero_range", "given together with velocity",
                      "give speed instead; the zero range finds the elevation");
  }
  if (launch.elevation != 0 && launch.sight.zero_range > 0)
    return error_at(shot, "shot.elevation", "given together with sight.zero_range",
                    "the zero range finds the elevation; give one of them");
  return {};
}

Status check_bands(const DragDef& drag, const Value& shot) {
  if (drag.bands.empty()) return {};
  if (drag.ballistic_coefficient > 0)
    return error_at(shot, "shot.drag.bands", "given together with ballistic_coefficient", "give one of them");
  const Value* table = shot.find("drag");
  PHYSIM_ASSERT(table != nullptr);  // no preset has bands
  for (std::size_t i = 0; i < drag.bands.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (drag.bands[i].above == drag.bands[j].above)
        return Error{"shot.drag.bands: two bands from " + quantity_in_words(drag.bands[i].above, Quantity::speed),
                     place_of(element(*table, "bands", i), "above"), "each band needs its own speed"};
  return {};
}

Status check_drag(const DragDef& drag, const Value& shot) {
  if (drag.table == DragTable::custom && drag.curve.empty())
    return error_at(shot, "shot.drag.curve", "table = \"custom\" without points",
                    "write curve = [[Mach number, drag coefficient], ...]");
  const Value* table = shot.find("drag");
  PHYSIM_ASSERT(table != nullptr || drag.curve.empty());  // no preset has one
  if (!drag.curve.empty() && table->find("table") == nullptr)
    return error_at(shot, "shot.drag.curve", "not used by the default table = \"constant\"",
                    "write table = \"custom\"");
  return check_bands(drag, shot);
}

Status check_motor(const ScenarioShot& shot, const Value& table) {
  const Value* given = table.find("motor");
  if (given == nullptr || shot.projectile.motor == MotorDef{} || has_motor(shot.projectile)) return {};
  return Error{"shot.motor: there is no thrust", given->place.text(), "give file or thrust"};
}

/// What the library objects to in a part of a scenario, where the part's table has it, or else where the nearest table
/// around it stands. `member`: of the library, "projectile."; `head`: of the file, "shot.".
void take_in_place(const std::vector<Error>& all, std::string_view member, std::string_view head, const Value& table,
                   Mistakes& mistakes) {
  for (const Error& bad : all) {
    const std::string path = bad.place.substr(bad.place.starts_with(member) ? member.size() : 0);
    const std::string place = follow(table, path).nearest.place.text();
    if (!mistakes.has(place)) mistakes.take(Error{std::string(head) + path + ": " + bad.message, place, bad.hint});
  }
}

/// What the library objects to in a shot, beyond the ranges of its settings; of its launch where nothing else does.
void check_flown(const ScenarioShot& shot, const Value& table, bool with_launch, Mistakes& mistakes) {
  std::vector<Error> of_projectile, of_launch;
  Status status = check(shot.projectile, &of_projectile);
  if (with_launch) status = check(shot.launch, &of_launch);
  if (of_projectile.empty() && of_launch.empty())
    if (status = check(shot.projectile, shot.launch); !status) of_launch.push_back(status.error());
  take_in_place(of_projectile, "projectile.", "shot.", table, mistakes);
  take_in_place(of_launch, "launch.", "shot.", table, mistakes);
}

/// Names go into overrides ("shot.NAME.mass=...") and into columns of files.
Status check_name(const std::string& name, const Value& shot) {
  for (const char c : name)
    if (static_cast<unsigned char>(c) < 0x20 || c == '=' || c == '"')
      return error_at(shot, "shot.name", in_quotes(name) + " has a character that names may not have",
                      "leave out =, \" and control characters");
  if (trimmed(name) != name) return error_at(shot, "shot.name", in_quotes(name) + " begins or ends with a space", "");
  return {};
}

void check_shots(const Scenario& scenario, const ScenarioNames& names, const Value& document, Mistakes& mistakes) {
  for (std::size_t i = 0; i < scenario.shots.size() && !mistakes.is_full(); ++i) {
    const ScenarioShot& shot = scenario.shots[i];
    const Value& table = element(document, "shot", i);
    mistakes.take(check_name(shot.projectile.name, table));
    if (const std::size_t first = *names.shots.find(shot.projectile.name); first != i)
      mistakes.take(error_at(table, "shot.name", "two shots are named " + in_quotes(shot.projectile.name),
                             "the first is at " + place_of(element(document, "shot", first), "name")));
    const bool is_directed = mistakes.take(check_direction(shot.launch, table));
    mistakes.take(check_drag(shot.projectile.drag, table));
    mistakes.take(check_motor(shot, table));
    check_flown(shot, table, is_directed, mistakes);
  }
}

/// What the library objects to in an environment, where the file gives it. What flies there reports all else.
void check_environment(const Environment& environment, const Value& document, Mistakes& mistakes) {
  std::vector<Error> all;
  const Status status = check(environment, &all);
  PHYSIM_ASSERT(status.ok() == all.empty());
  std::erase_if(all, [&](const Error& bad) { return !follow(document, bad.place).is_there; });
  take_in_place(all, "", "", document, mistakes);
}

/// Flights have figures of their own, and where there are things, those of hits.
Status check_hit_expectation(const ScenarioNames& names, const Expectation& expect, const Value& table) {
  const bool has_things = !names.things.all().empty();
  if (!expect.thing.empty() && !has_things) return error_at(table, "expect.thing", "there is no [world] for it", "");
  if (!expect.thing.empty())
    if (Status status = check_thing_expectation(names, expect, table); !status) return status;
  const Figure* figure = find_figure(expect.quantity);
  PHYSIM_ASSERT(figure != nullptr);  // the reader knows no others
  if (figure->is_of_flights()) return {};
  if (!has_things || !figure->is_of_things())
    return error_at(table, "expect.quantity", in_quotes(expect.quantity) + " is a figure of a [world]",
                    "write [world], and the shots fly in it");
  if (expect.at == ExpectAt::end) return {};
  return error_at(table, "expect.at", "hits are those of the whole flight", "leave it out");
}

void check_expectations(const Scenario& scenario, const ScenarioNames& names, const Value& document,
                        Mistakes& mistakes) {
  for (std::size_t i = 0; i < scenario.expect.size() && !mistakes.is_full(); ++i) {
    const Value& table = element(document, "expect", i);
    const Expectation& expect = scenario.expect[i];
    if (!expect.shot.empty())
      mistakes.take(check_named(names.shots, expect.shot, "shot", "expect.shot", place_of(table, "shot")));
    mistakes.take(check_hit_expectation(names, expect, table));
    const Value* at = table.find("at");
    if (const Table* places = at ? at->get<Table>() : nullptr; places && places->size() != 1)
      mistakes.take(Error{"expect.at: " + std::to_string(places->size()) + " places", at->place.text(),
                          "give one of time, range, height or a moment"});
  }
}

constexpr std::string_view kOfStudy = "study.";
/// Objections to a study of a shot. Inputs may still come from options.
std::vector<Error> mistakes_of_study(const Scenario& scenario, const ScenarioShot& shot) {
  std::vector<Error> errors;
  const Study study = read_study(scenario, shot, errors);
  if (!errors.empty() || study.inputs.empty()) return errors;
  const Status status = check(study, true, &errors);
  PHYSIM_ASSERT(status.ok() == errors.empty());
  return errors;
}

std::string numbered_input(std::size_t i) { return "inputs[" + std::to_string(i) + ']'; }

/// A path leads to a text, or to something in it.
bool leads_to(std::string_view path, std::string_view text) {
  PHYSIM_ASSERT(!text.empty());
  if (!path.starts_with(text)) return false;
  path.remove_prefix(text.size());
  return path.empty() || path.front() == '.' || path.front() == '[';
}

/// An error of the library about the study of a shot, whose inputs are numbered as their texts are. Correlations are
/// made of several texts. One about a number that is drawn is about the last input that draws it.
Error by_texts(const Scenario& scenario, const ScenarioShot& shot, Error error) {
  const std::vector<InputOfShot> inputs = inputs_of(scenario, shot);
  for (std::size_t i = inputs.size(); i-- > 0;)  // texts have no lower numbers than inputs: none is met twice
    for (std::string* text : {&error.message, &error.place, &error.hint})
      replace_all(*text, numbered_input(i), numbered_input(inputs[i].text));
  if (error.place.starts_with("correlated[") && scenario.study.correlated.size() > 1)
    error.place.erase(std::string_view("correlated").size(), error.place.find(']') - error.place.find('[') + 1);
  const std::string setting = in_files(error.place);
  const auto drawn = std::ranges::find(inputs.rbegin(), inputs.rend(), setting, &InputOfShot::path);
  if (drawn == inputs.rend()) return error;
  return {setting + ": " + error.message, numbered_input(drawn->text), error.hint};
}

}  // namespace

Error error_at(const Value& table, const std::string& path, const std::string& message, const std::string& hint) {
  return {path + ": " + message, place_of(table, path.substr(path.find('.') + 1)), hint};
}

Status check_scenario(const Scenario& scenario, const Value& document) {
  const ScenarioNames names(scenario);
  Mistakes mistakes;
  check_shots(scenario, names, document, mistakes);
  check_environment(scenario.environment, document, mistakes);
  check_world(scenario, names, document, mistakes);
  if (!scenario.world.given) check_expectations(scenario, names, document, mistakes);
  if (mistakes.empty()) check_study(scenario, document, mistakes);  // it is made of all of them
  return mistakes.status();
}

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

std::string setting_of_study(const std::string& place) {
  const std::string path = std::string(kOfStudy) + place;
  return find_node(path) != nullptr ? path : place;
}

Error in_study(const Scenario& scenario, const ScenarioShot& shot, Error error) {
  const ScenarioStudy& study = scenario.study;
  if (!error.place.starts_with(kOfStudy)) error = by_texts(scenario, shot, std::move(error));
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
  if (table == nullptr || scenario.world.given || !scenario.study.is_complete) return;  // a study flies shots alone
  std::vector<Error> first;
  const ScenarioShot* of = nullptr;
  for (const ScenarioShot& shot : scenario.shots) {
    std::vector<Error> errors = mistakes_of_study(scenario, shot);
    if (errors.empty()) return;  // a study is of one shot
    if (first.empty()) first = std::move(errors), of = &shot;
  }
  for (const Error& each : first) {
    Error error = in_study(scenario, *of, each);
    if (error.place == each.place)
      error = {setting_of_study(each.place) + ": " + error.message, table->place.text(), error.hint};
    mistakes.take(error);
  }
}

}  // namespace physim
