// [[joint]] of a scenario: what its tables cannot say about themselves, and how a run's world gets them.
#include <algorithm>

#include "base/assert.hpp"
#include "scenario/checks.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"
#include "scenario/world_run_impl.hpp"
#include "world/joints.hpp"

namespace physim {
namespace {

Status check_joint(const ScenarioNames& names, const ScenarioJoint& joint, const Value& table) {
  if (Status status = check_lone_shot(names, joint.a, "joint.a", place_of(table, {"a"})); !status) return status;
  if (!joint.b.empty())
    if (Status status = check_lone_shot(names, joint.b, "joint.b", place_of(table, {"b"})); !status) return status;
  if (joint.a == joint.b)
    return Error{"joint.b: is joint.a too", place_of(table, {"b"}), "a joint holds two different shots"};
  if (!joint.b.empty() && table.find("point"))
    return Error{"joint.point: given together with b", place_of(table, {"point"}), "give one of them"};
  PHYSIM_ASSERT(!joint.a.empty());  // a required key
  Joint def = joint.def;
  def.a = {1, 1};  // any projectile
  if (const Status status = check(def); !status) {
    const Error& error = status.error();
    const std::string key = error.place.substr(error.place.find('.') + 1);
    return Error{error.place + ": " + error.message, place_of(table, {key}), error.hint};
  }
  return {};
}

}  // namespace

void complete_joints(Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.joints.size(); ++i)
    if (std::string& name = scenario.joints[i].name; name.empty()) name = "joint-" + std::to_string(i + 1);
}

Status check_joints(const Scenario& scenario, const ScenarioNames& names, const Value& document) {
  for (std::size_t i = 0; i < scenario.joints.size(); ++i)
    if (Status status = check_joint(names, scenario.joints[i], element(document, "joint", i)); !status) return status;
  return {};
}

Status WorldRun::Impl::add_joints() {
  for (const ScenarioJoint& joint : scenario.joints) {
    Joint def = joint.def;
    def.a = lone[index_of_shot(joint.a)];
    if (!joint.b.empty()) def.b = lone[index_of_shot(joint.b)];
    if (const Result<JointId> added = world.add_joint(def); !added)
      return with_place(added.error(), scenario.file + ": joint " + in_quotes(joint.name));
  }
  return {};
}

}  // namespace physim
