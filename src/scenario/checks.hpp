// Checks that need more than one setting; of scenarios with a [world], what its tables cannot say about themselves.
#pragma once

#include "scenario/document.hpp"
#include "scenario/names.hpp"
#include "scenario/scenario.hpp"

namespace physim {

class Mistakes;

/// The contradictions within a scenario, as one error; the document gives the places of its settings.
[[nodiscard]] Status check_scenario(const Scenario& scenario, const Value& document);

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

/// Default names of [[joint]], and their contradictions.
void complete_joints(Scenario& scenario);
[[nodiscard]] Status check_joints(const Scenario& scenario, const ScenarioNames& names, const Value& document);
/// A remark on a joint: its ends are elsewhere at launch, or other joints contradict it.
struct JointRemark {
  std::size_t joint;  // index in Scenario::joints
  std::string what;
  std::string key = "length";  // that it is about
};
[[nodiscard]] std::vector<JointRemark> joint_remarks(const Scenario& scenario);

[[nodiscard]] Status check_shot_name(const ScenarioNames& names, const std::string& name, const std::string& path,
                                     const std::string& place);
/// ... of a shot that is fired alone, so that there is one of it.
[[nodiscard]] Status check_lone_shot(const ScenarioNames& names, const std::string& name, const std::string& path,
                                     const std::string& place);

}  // namespace physim
