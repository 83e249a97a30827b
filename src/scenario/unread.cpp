#include "scenario/unread.hpp"

#include <map>

#include "base/assert.hpp"
#include "prepare/grant.hpp"

namespace physim {
namespace {

using Rules = std::map<std::string_view, std::vector<const UnreadRule*>>;

const Rules& all_rules() {
  static const Rules rules = [] {
    Rules by_path;
    for (const std::span<const UnreadRule> part :
         {unread_in_flights(), unread_in_scenes(), unread_in_worlds(), unread_in_emitters()})
      for (const UnreadRule& rule : part) {
        PHYSIM_ASSERT(find_node(rule.path) != nullptr);
        PHYSIM_ASSERT(rule.why != nullptr);
        by_path[rule.path].push_back(&rule);
      }
    return by_path;
  }();
  return rules;
}

/// All rungs that shots of a scenario may fly at: their own, and those of a world's detail.
std::vector<FlownRung> rungs_of(const Scenario& scenario) {
  std::vector<FlownRung> rungs;
  const bool is_world = scenario.world.given;
  for (const ScenarioShot& shot : scenario.shots) {
    const auto add = [&](const Fidelity& asked) {
      const Fidelity stepped = by_steps(asked, is_world || scenario.tolerance.step > 0);
      rungs.push_back({&shot, asked, grant(stepped, shot.projectile, scenario.environment, shot.launch).fidelity});
    };
    add(shot.projectile.fidelity);
    if (is_world)
      for (const DetailRung& rung : scenario.world.def.detail.rungs) add(rung.fidelity);
  }
  PHYSIM_ASSERT(rungs.size() >= scenario.shots.size());
  return rungs;
}

class UnreadSearch {
 public:
  explicit UnreadSearch(Scenario& scenario) : scenario_(scenario), rungs_(rungs_of(scenario)) {}

  std::vector<UnreadSetting> run(const Value& document) {
    std::int64_t format = 1;
    in_table(schema(), {.format = &format, .scenario = &scenario_}, document, document);
    return std::move(found_);
  }

 private:
  /// Reports a node that nothing reads; true if it did.
  bool report(const SchemaNode& node, const Scope& scope, const Value& value, const Value& owner) {
    const auto rules = all_rules().find(node.path);
    if (rules == all_rules().end()) return false;
    for (const UnreadRule* rule : rules->second) {
      std::string why = rule->why({.scenario = scenario_, .scope = scope, .table = owner, .rungs = rungs_});
      if (why.empty()) continue;
      found_.push_back({value.place.text(), node.path, std::move(why)});
      return true;
    }
    return false;
  }

  void in_table(const SchemaNode& node, const Scope& scope, const Value& value, const Value& owner) {
    PHYSIM_ASSERT(value.get<Table>() != nullptr);
    for (const SchemaNode& child : node.children)
      if (const Value* found = value.find(child.name)) at_node(child, scope, *found, owner);
  }

  void at_node(const SchemaNode& node, const Scope& scope, const Value& value, const Value& owner) {
    if (node.is_list_of_tables()) return in_list(node, scope, value, owner);
    if (report(node, scope, value, owner) || node.entry != nullptr) return;
    if (value.get<Table>() != nullptr) return in_table(node, scope, value, owner);
    if (const SchemaNode* shorthand = node.find(node.shorthand)) report(*shorthand, scope, value, owner);
  }

  /// A rule about a list is asked about each of its elements.
  void in_list(const SchemaNode& node, const Scope& scope, const Value& value, const Value& owner) {
    const ValueRef into = node.entry->slot(scope);
    const auto* records = std::get_if<Records>(&into);
    const Array* array = value.get<Array>();
    if (records == nullptr || array == nullptr) return static_cast<void>(report(node, scope, value, owner));
    for (std::size_t i = 0; i < std::min(records->size(), array->size()); ++i) {
      const Value& element = (*array)[i];
      const Scope inner = records->element(i);
      if (!report(node, inner, element, element) && element.get<Table>() != nullptr)
        in_table(node, inner, element, element);
    }
  }

  Scenario& scenario_;
  std::vector<FlownRung> rungs_;
  std::vector<UnreadSetting> found_;
};

}  // namespace

bool Reading::has(Path path) const {
  const Value* value = &table;
  for (const std::string_view key : path)
    if (value = value->find(key); value == nullptr) return false;
  return true;
}

std::vector<UnreadSetting> unread_settings(Scenario& scenario, const Value& document) {
  return UnreadSearch(scenario).run(document);
}

}  // namespace physim
