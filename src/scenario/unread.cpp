#include "scenario/unread.hpp"

#include <map>

#include "base/assert.hpp"
#include "model/ladder.hpp"
#include "prepare/grant.hpp"

namespace physim {
namespace {

using Rules = std::map<std::string_view, std::vector<const UnreadRule*>>;

const Rules& all_rules() {
  static const Rules rules = [] {
    Rules by_path;
    for (const std::span<const UnreadRule> part :
         {unread_in_flights(), unread_in_scenes(), unread_in_worlds(), unread_in_emitters()})
      for (const UnreadRule& rule : part)
        for (std::string_view rest = rule.settings; !rest.empty();) {
          const std::string_view path = rest.substr(0, rest.find(' '));
          rest.remove_prefix(std::min(path.size() + 1, rest.size()));
          PHYSIM_ASSERT(find_node(path) != nullptr);
          by_path[path].push_back(&rule);
        }
    return by_path;
  }();
  return rules;
}

/// Rungs that may be chosen instead of a fidelity: each effect lowered alone, but drag and motion, which stay.
void add_cheaper(const Fidelity& asked, const auto& add) {
  for_each_effect([&](const char*, auto member) {
    using Rung = std::decay_t<decltype(asked.*member)>;
    if constexpr (std::is_same_v<Rung, DragModel> || std::is_same_v<Rung, Motion>) return;
    for (const Rung rung : all_rungs<Rung>()) {
      Fidelity cheaper = asked;
      cheaper.*member = rung;
      if (level(rung) >= 0 && level(rung) < level(asked.*member)) add(cheaper);
    }
  });
}

/// All rungs that shots of a scenario may fly at: those of a world's detail if it rules them, else their own.
std::vector<FlownRung> rungs_of(const Scenario& scenario) {
  std::vector<FlownRung> rungs;
  for (const ScenarioShot& shot : scenario.shots) {
    const auto add = [&](const Fidelity& asked) {
      const FidelityInUse in_use = scenario.world.given ? grant_in_world(asked, shot.projectile, scenario.environment)
                                                        : grant(by_steps(asked, scenario.tolerance.step > 0),
                                                                shot.projectile, scenario.environment);
      rungs.push_back({&shot, asked, in_use.fidelity});
    };
    if (is_ruled_by_detail(scenario, shot)) {
      for (const DetailRung& rung : scenario.world.def.detail.rungs) add(rung.fidelity);
      continue;
    }
    add(shot.projectile.fidelity);
    if (shot.cheapest_within) add_cheaper(shot.projectile.fidelity, add);
  }
  PHYSIM_ASSERT(rungs.size() >= scenario.shots.size());
  return rungs;
}

class UnreadSearch {
 public:
  explicit UnreadSearch(Scenario& scenario) : scenario_(scenario), rungs_(rungs_of(scenario)) {}

  std::vector<UnreadSetting> run(const Value& document) {
    std::int64_t format = 1;
    const Scope scope{.format = &format, .scenario = &scenario_};
    in_table(schema(), scope, document);
    in_study(scope, document);
    return std::move(found_);
  }

 private:
  /// Reports a node that nothing reads; true if it did.
  bool report(const SchemaNode& node, const Scope& scope, const Value& value) {
    const auto rules = all_rules().find(node.path);
    if (rules == all_rules().end()) return false;
    const Reading reading{.scenario = scenario_, .scope = scope, .rungs = rungs_};
    for (const UnreadRule* rule : rules->second) {
      if ((rule->describes && value.place.line != 0) || rule->is_read(reading)) continue;
      PHYSIM_ASSERT(rule->why.front() == ' ' || rule->why.front() == ':');  // it follows "has no effect"
      const std::string why = std::string(rule->why) + (rule->value ? rule->value(reading) : "");
      found_.push_back({value.place.text(), node.path, why});
      return true;
    }
    return false;
  }

  /// Inputs of the study draw settings that nothing may read.
  void in_study(const Scope& scope, const Value& document) {
    const Value* study = document.find("study");
    const Value* inputs = study ? study->find("inputs") : nullptr;
    if (inputs == nullptr) return;
    PHYSIM_ASSERT(!scenario_.shots.empty());
    for (const std::string& text : scenario_.study.inputs) {
      const Result<StudyInput> input = parse_study_input(text);
      if (!input) continue;
      Scope drawn = scope;
      drawn.shot = &scenario_.shots.front();
      const std::size_t before = found_.size();
      const SchemaNode* node = &schema();
      for (std::size_t end = 0; node != nullptr && end != input->path.npos && found_.size() == before;) {
        end = input->path.find('.', end + 1);
        node = find_node(input->path.substr(0, end));
        if (node != nullptr) report(*node, drawn, *inputs);
      }
      if (found_.size() == before) continue;
      const UnreadSetting& input_unread = found_.back();
      const bool is_correlated = std::ranges::any_of(
          scenario_.study.correlated, [&](const std::string& each) { return each.find(input->path) != each.npos; });
      const Value* correlated = study->find("correlated");
      const std::string why = input_unread.why;
      found_.back().path = "study.inputs: " + input_unread.path;
      if (is_correlated && correlated != nullptr)
        found_.push_back({correlated->place.text(), "study.correlated: " + input->path, why});
    }
  }

  void in_table(const SchemaNode& node, const Scope& scope, const Value& value) {
    PHYSIM_ASSERT(value.get<Table>() != nullptr);
    for (const SchemaNode& child : node.children)
      if (const Value* found = value.find(child.name)) at_node(child, scope, *found);
  }

  void at_node(const SchemaNode& node, const Scope& scope, const Value& value) {
    if (node.is_list_of_tables()) return in_list(node, scope, value);
    if (report(node, scope, value) || node.entry != nullptr) return;
    if (value.get<Table>() != nullptr) return in_table(node, scope, value);
    if (const SchemaNode* shorthand = node.find(node.shorthand)) report(*shorthand, scope, value);
  }

  /// A rule about a list of the file is asked about each of its elements; about a list in a table, once.
  void in_list(const SchemaNode& node, const Scope& scope, const Value& value) {
    PHYSIM_ASSERT(node.entry != nullptr && node.entry->slot != nullptr);
    const ValueRef into = node.entry->slot(scope);
    const auto* records = std::get_if<Records>(&into);
    const Array* array = value.get<Array>();
    const bool is_outer = node.path.find('.') == node.path.npos;
    if (records == nullptr || array == nullptr) return;
    if (!is_outer && report(node, scope, value)) return;
    for (std::size_t i = 0; i < std::min(records->size(), array->size()); ++i) {
      const Value& element = (*array)[i];
      const Scope inner = records->element(i);
      if (is_outer && report(node, inner, element)) continue;
      if (element.get<Table>() != nullptr) in_table(node, inner, element);
    }
  }

  Scenario& scenario_;
  std::vector<FlownRung> rungs_;
  std::vector<UnreadSetting> found_;
};

}  // namespace

bool Reading::is_drawn(std::string_view path) const {
  PHYSIM_ASSERT(!path.empty());
  return std::ranges::any_of(scenario.study.inputs,
                             [&](const std::string& input) { return input.find(path) != input.npos; });
}

std::vector<UnreadSetting> unread_settings(Scenario& scenario, const Value& document) {
  return UnreadSearch(scenario).run(document);
}

}  // namespace physim
