#include "scenario/by_path.hpp"

#include <algorithm>
#include <charconv>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/in_place.hpp"
#include "scenario/reader.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/writer.hpp"

namespace physim {
namespace {

constexpr std::string_view kShot = "shot.";
constexpr std::size_t kMostElements = 1'000'000'000;

/// The index of an element with the number in a path, from 0; nothing if the text is no number from 1.
std::optional<std::size_t> index_of(std::string_view part) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
  if (error != std::errc{} || end != part.data() + part.size() || number == 0 || number > kMostElements) return {};
  return number - 1;
}

class Follower {
 public:
  explicit Follower(const ShotNames& shots) : shot_names_(shots) {}

  /// Follows a path from a table; false if it leads nowhere.
  bool follow(const SchemaNode& table, std::string_view rest) {
    const std::size_t dot = rest.find('.');
    const SchemaNode* child = table.find(rest.substr(0, dot));
    if (child == nullptr) return false;
    target.node = child;
    if (dot == rest.npos) return true;
    rest.remove_prefix(dot + 1);
    return child->is_list_of_tables() ? follow_into(*child, rest) : follow(*child, rest);
  }

  Addressed target;

 private:
  bool follow_into(const SchemaNode& list, std::string_view rest) {
    const std::size_t depth = target.elements.size();
    PHYSIM_ASSERT(list.is_list_of_tables());
    const auto into = [&](std::optional<std::size_t> index, std::string_view behind) {
      target.elements.resize(depth);
      target.elements.push_back(index);
      return follow(list, behind);
    };
    if (into(std::nullopt, rest)) return true;
    const bool of_shots = list.path == "shot";
    const std::vector<std::string> shots = of_shots ? shot_names_() : std::vector<std::string>();
    for (std::size_t i = 0; i < shots.size(); ++i)  // names may contain dots
      if (const std::string head = shots[i] + "."; rest.starts_with(head) && into(i, rest.substr(head.size())))
        return true;
    const std::size_t dot = rest.find('.');
    const std::optional<std::size_t> index = dot == rest.npos ? std::nullopt : index_of(rest.substr(0, dot));
    if (!index || (of_shots && *index > shots.size())) return false;  // rather a name that no shot has
    return into(index, rest.substr(dot + 1));
  }

  const ShotNames& shot_names_;
};

Error unknown_setting(std::string_view path, const Place& place) {
  const std::size_t dot = path.rfind('.');
  const std::string hint = dot == path.npos ? "" : hint_of_key(path.substr(0, dot), path.substr(dot + 1));
  if (!hint.empty()) return {"unknown setting " + in_quotes(path), place.text(), hint};
  std::string_view near = nearest(path, setting_paths());
  if (near.empty() && !path.empty()) near = nearest(std::string(kShot) + std::string(path), setting_paths());
  return {"unknown setting " + in_quotes(path), place.text(),
          near.empty() ? "physim list settings shows all" : "did you mean " + in_quotes(near) + "?"};
}

/// The error of a path that leads nowhere. Every dot may be the one behind the name of a shot.
Error leads_nowhere(std::string_view path, const std::vector<std::string>& shots, const Place& place) {
  if (!path.starts_with(kShot)) return unknown_setting(path, place);
  const std::string_view rest = path.substr(kShot.size());
  std::optional<std::string> unknown, namesake;
  for (std::size_t dot = rest.find('.'); dot != rest.npos; dot = rest.find('.', dot + 1)) {
    const std::string name(rest.substr(0, dot));
    const bool known = std::ranges::find(shots, name) != shots.end();
    if (known) namesake = name;
    if (!known && !unknown && find_node(std::string(kShot) + std::string(rest.substr(dot + 1)))) unknown = name;
  }
  if (namesake) {
    Error error = unknown_setting(std::string(kShot) + std::string(rest.substr(namesake->size() + 1)), place);
    error.message += " of shot " + in_quotes(*namesake);
    return error;
  }
  if (!unknown) return unknown_setting(path, place);
  const std::vector<std::string_view> views(shots.begin(), shots.end());
  return Error{"no shot is named " + in_quotes(*unknown), place.text(), suggestion(*unknown, views, "shots")};
}

Place place_of_path(std::string_view path) { return {std::make_shared<const std::string>(path), 0, 0}; }

/// The objects that hold the target of a path.
Result<Scope> scope_of(const Addressed& target, const Scope& root, const std::string& path) {
  Scope scope = root;
  const SchemaNode* node = &schema();
  std::size_t list = 0;
  for (std::string_view rest = target.node->path; node != target.node;) {
    node = node->find(rest.substr(0, rest.find('.')));
    PHYSIM_ASSERT(node != nullptr);
    if (node == target.node) break;
    rest.remove_prefix(rest.find('.') + 1);
    if (!node->is_list_of_tables()) continue;
    const Records records = std::get<Records>(node->entry->slot(scope));
    PHYSIM_ASSERT(list < target.elements.size());
    const std::optional<std::size_t> wanted = target.elements[list++];
    const std::string count = std::to_string(records.size());
    if (!wanted && records.size() != 1)
      return Error{"there are " + count + " [[" + node->path + "]]", path, "give the number of one, from 1"};
    if (wanted.value_or(0) >= records.size())
      return Error{"there are only " + count + " [[" + node->path + "]]", path, "numbers begin with 1"};
    scope = records.element(wanted.value_or(0));
  }
  return scope;
}

/// The target of a path in a scenario, with the objects that hold it.
struct AtPath {
  const SchemaNode* node = nullptr;
  Scope scope;
};

Result<AtPath> find_in(Scenario& scenario, std::int64_t& format, std::string_view path) {
  const auto shots = [&scenario] {
    std::vector<std::string> names;
    for (const ScenarioShot& shot : scenario.shots) names.push_back(shot.projectile.name);
    return names;
  };
  const Result<Addressed> target = address(path, shots, place_of_path(path));
  if (!target) return target.error();
  const Scope root{.format = &format, .scenario = &scenario};
  const Result<Scope> scope = scope_of(*target, root, std::string(path));
  if (!scope) return scope.error();
  return AtPath{target->node, *scope};
}

}  // namespace

Result<Addressed> address(std::string_view path, const ShotNames& shots, const Place& place) {
  for (const std::string& whole : {std::string(path), std::string(kShot) + std::string(path)}) {
    Follower follower(shots);
    if (follower.follow(schema(), whole)) return follower.target;
  }
  return leads_nowhere(path, shots(), place);
}

Result<std::string> value_at(Scenario& scenario, std::string_view path) {
  const IeeeMode mode;
  std::int64_t format = 1;
  const Result<AtPath> found = find_in(scenario, format, path);
  if (!found) return found.error();
  if (found->node->entry == nullptr)
    return Error{"is a table, and has no value of its own", std::string(path), "name one of its settings"};
  const std::optional<std::string> value = written(*found->node->entry, found->scope);
  if (!value) return Error{"has no value here", std::string(path), "it stands for other settings, or is not used"};
  return *value;
}

Result<std::size_t> length_at(Scenario& scenario, std::string_view path) {
  std::int64_t format = 1;
  const Result<AtPath> found = find_in(scenario, format, path);
  if (!found) return found.error();
  if (!found->node->is_list_of_tables()) return Error{"is no list of tables", std::string(path), ""};
  return std::get<Records>(found->node->entry->slot(found->scope)).size();
}

Status check_alone(const SchemaNode& node, const Value& value) {
  const IeeeMode mode;
  if (looks_uncertain(value) && node.entry != nullptr) return {};  // a distribution in the place of a number
  Defaults defaults;
  const Scope scope = defaults.scope();
  if (node.entry == nullptr) return {};
  if (node.entry->quantity_by != nullptr || std::holds_alternative<Reference>(node.entry->slot(scope))) return {};
  return read_setting(node, scope, value);
}

}  // namespace physim
