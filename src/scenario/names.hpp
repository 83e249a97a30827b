// Names of parts of a scenario, found at a cost that does not grow with how many there are.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "scenario/scenario.hpp"

namespace physim {

/// A text of the library with its members by their paths in files: "launch.speed" and "projectile.mass" become
/// "shot.speed" and "shot.mass".
[[nodiscard]] std::string in_files(std::string text);

/// Numbers of named things. The texts must stay where they are.
class NameIndex {
 public:
  /// Gives a name the next number; false if it has one already.
  bool add(std::string_view name) {
    const bool is_new = numbers_.emplace(name, names_.size()).second;
    names_.push_back(name);
    return is_new;
  }
  [[nodiscard]] bool has(std::string_view name) const { return numbers_.contains(name); }
  /// The number of a name, from 0: of the first of that name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const {
    const auto found = numbers_.find(name);
    return found != numbers_.end() ? std::optional(found->second) : std::nullopt;
  }
  /// All names in the order of their numbers.
  [[nodiscard]] const std::vector<std::string_view>& all() const { return names_; }

 private:
  std::unordered_map<std::string_view, std::size_t> numbers_;
  std::vector<std::string_view> names_;
};

/// What the parts of a scenario are called. The scenario must stay where it is.
struct ScenarioNames {
  NameIndex shots, volleys, emitters, things, pools;
  std::unordered_set<std::string_view> of_volleys, of_emitters;  // shots that these fire

  explicit ScenarioNames(const Scenario& scenario);
  /// A shot is fired once, at the start, unless a volley or an emitter fires it.
  [[nodiscard]] bool is_alone(std::string_view shot) const {
    return !of_volleys.contains(shot) && !of_emitters.contains(shot);
  }
  /// Names of shots that are fired by themselves.
  [[nodiscard]] std::vector<std::string_view> lone_shots() const;
  /// Names of what is counted together: shots that are fired by themselves, volleys and emitters.
  [[nodiscard]] std::vector<std::string_view> groups() const;
};

}  // namespace physim
