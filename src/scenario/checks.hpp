// Checks that need more than one setting, and notes; of scenarios with a [world], what its tables cannot say about
// themselves.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>

#include "scenario/document.hpp"
#include "scenario/names.hpp"
#include "scenario/scenario.hpp"
#include "scenario/suggest.hpp"

namespace physim {

class Mistakes;

/// The contradictions within a scenario, as one error; the document gives the places of its settings.
[[nodiscard]] Status check_scenario(const Scenario& scenario, const Value& document);

/// Adds a note for each setting that another one overrules, and for each number far from what is usual, with its place.
void add_notes(Scenario& scenario, const Value& document);

/// Notes where the texts of a [study] stand.
void note_study_places(ScenarioStudy& study, const Value& document);
/// What is wrong with a [study], whichever of the shots it is of.
void check_study(const Scenario& scenario, const Value& document, Mistakes& mistakes);

/// Contradictions of a [world], or of what there is without one.
void check_world(const Scenario& scenario, const ScenarioNames& names, const Value& document, Mistakes& mistakes);

/// Contradictions of what there is for projectiles to hit; it makes the scene to see whether it can be made.
[[nodiscard]] Status check_scene(const Scenario& scenario, const Value& document);
/// Whether there is the thing that an expectation asks about, and a figure of hits on it.
[[nodiscard]] Status check_thing_expectation(const ScenarioNames& names, const Expectation& expect, const Value& table);

/// `path` and `table`: what is turned, and where the file says it.
[[nodiscard]] Status check_rotation(const std::string& path, const ScenarioRotation& rotation, const Value& table);
/// A motion said by the members of ScenarioMotion, which the file has in `motion`: `table` itself or a table in it.
template <class Moving>
[[nodiscard]] Status check_motion(const std::string& path, const Moving& moving, const Vec3d& position,
                                  const ScenarioRotation& rotation, const Value& table, const Value& motion) {
  const std::string path_of_motion = &motion == &table ? path : path + ".motion";
  if (Status status = check_rotation(path, rotation, table); !status) return status;
  for (std::size_t i = 0; i < moving.keys.size(); ++i)
    if (Status status = check_rotation(path_of_motion + ".keys", moving.keys[i].rotation, element(motion, "keys", i));
        !status)
      return status;
  if (moving.keys.empty()) return {};
  const auto said_twice = [](const std::string& setting, const Value& where, std::string_view key) {
    return Error{setting + "." + std::string(key) + ": given together with keys", place_of(where, key),
                 "the keys say where it is and how it moves"};
  };
  if (moving.velocity != Vec3d{}) return said_twice(path_of_motion, motion, "velocity");
  if (moving.angular_velocity != Vec3d{}) return said_twice(path_of_motion, motion, "angular_velocity");
  if (position != Vec3d{}) return said_twice(path, table, "position");
  const bool is_turned = rotation.angle != 0 || rotation.yaw != 0 || rotation.pitch != 0 || rotation.roll != 0;
  if (is_turned) return said_twice(path, table, "rotation");
  return {};
}

/// Default names of a scene's parts, published materials that things name, and meshes out of files.
[[nodiscard]] Status complete_scene(Scenario& scenario, const Value& document);

/// Default names, laws without numbers, and whether there is a world at all.
void complete_world(Scenario& scenario, const Value& document);

/// Meshes and terrain that emitters name, read and prepared once each.
[[nodiscard]] Status complete_emitters(Scenario& scenario, const Value& document);
/// A file that a scenario names, found from where the scenario is.
[[nodiscard]] std::string beside_scenario(const Scenario& scenario, const std::string& file);

/// Contradictions of [[emitter]].
[[nodiscard]] Status check_emitters(const Scenario& scenario, const ScenarioNames& names, const Value& document);

/// Contradictions of [[joint]].
[[nodiscard]] Status check_joints(const Scenario& scenario, const ScenarioNames& names, const Value& document);
/// A remark on a joint: its ends are elsewhere at launch, or other joints contradict it.
struct JointRemark {
  std::size_t joint;  // index in Scenario::joints
  std::string what;
  std::string key = "length";  // that it is about
};
[[nodiscard]] std::vector<JointRemark> joint_remarks(const Scenario& scenario);

/// An error about a setting: `path` is that in the file, whose first part leads to the table.
[[nodiscard]] Error error_at(const Value& table, const std::string& path, const std::string& message,
                             const std::string& hint);
/// "volley-1", where an element of a list has no name.
template <class List>
void name_each(List& list, std::string_view kind) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name.empty()) list[i].name = std::string(kind) + "-" + std::to_string(i + 1);
}

/// Error if two elements of a list are given one name: a name that is made up is none.
template <class List>
[[nodiscard]] Status check_given_names(const List& list, const std::string& kind, const Value& document) {
  std::unordered_set<std::string_view> given;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Value& table = element(document, kind, i);
    if (table.find("name") && !given.insert(list[i].name).second)
      return error_at(table, kind + ".name", "another " + kind + " is named " + in_quotes(list[i].name),
                      "give it a name of its own");
  }
  return {};
}

/// Error if no part has that name; `kind`: "shot".
[[nodiscard]] Status check_named(const NameIndex& names, const std::string& name, const std::string& kind,
                                 const std::string& path, const std::string& place);
/// ... a shot that is fired alone, so that there is one of it.
[[nodiscard]] Status check_lone_shot(const ScenarioNames& names, const std::string& name, const std::string& path,
                                     const std::string& place);

}  // namespace physim
