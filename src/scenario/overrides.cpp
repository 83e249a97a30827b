#include "scenario/overrides.hpp"

#include <algorithm>
#include <optional>

#include "base/assert.hpp"
#include "scenario/reader.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

constexpr std::string_view kShot = "shot.";

/// Where an override goes: a node of the tree, of one shot or of all.
struct Addressed {
  const SchemaNode* node = nullptr;
  std::optional<std::string> shot;
};

std::vector<std::string> shot_names(const Value& document) {
  std::vector<std::string> names;
  const Value* shots = document.find("shot");
  if (const Array* array = shots ? shots->get<Array>() : nullptr)
    for (std::size_t i = 0; i < array->size(); ++i) names.push_back(shot_name((*array)[i], i));
  return names;
}

Error unknown_setting(std::string_view path, const Place& place) {
  const std::string_view near = nearest(path, setting_paths());
  return {"unknown setting " + in_quotes(path), place.text(),
          near.empty() ? "physim list settings shows all" : "did you mean " + in_quotes(near) + "?"};
}

/// "shot.NAME.mass": names may contain dots, so every dot may be the one after the name.
Result<Addressed> named_target(const Value& document, std::string_view path, const Place& place) {
  PHYSIM_ASSERT(path.starts_with(kShot));
  const std::vector<std::string> names = shot_names(document);
  const std::string_view rest = path.substr(kShot.size());
  std::optional<std::string> unknown, namesake;
  for (std::size_t dot = rest.find('.'); dot != rest.npos; dot = rest.find('.', dot + 1)) {
    const std::string name(rest.substr(0, dot));
    const SchemaNode* node = find_node(std::string(kShot) + std::string(rest.substr(dot + 1)));
    const bool known = std::find(names.begin(), names.end(), name) != names.end();
    if (known && node != nullptr) return Addressed{node, name};
    if (known) namesake = name;
    if (node != nullptr && !unknown) unknown = name;
  }
  if (namesake) {
    Error error = unknown_setting(std::string(kShot) + std::string(rest.substr(namesake->size() + 1)), place);
    error.message += " of shot " + in_quotes(*namesake);
    return error;
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  if (unknown)
    return Error{"no shot is named " + in_quotes(*unknown), place.text(), suggestion(*unknown, views, "shots")};
  return unknown_setting(path, place);
}

Result<Addressed> addressed_in(const Value& document, std::string_view path, const Place& place) {
  if (const SchemaNode* node = find_node(path); node != nullptr) return Addressed{node, std::nullopt};
  if (path.starts_with(kShot)) return named_target(document, path, place);
  return unknown_setting(path, place);
}

/// Makes a table of a value that stands for one: gravity = "off" becomes { model = "off" }.
Status make_table(const SchemaNode& node, Value& value) {
  if (value.get<Table>() != nullptr) return {};
  if (node.shorthand.empty()) return not_a_table(node, value);
  Value inner = value;
  value.content = Table{{node.shorthand, value.place, std::move(inner)}};
  return {};
}

Value& member_of(Value& table, const std::string& key, const Place& place) {
  PHYSIM_ASSERT(table.get<Table>() != nullptr);
  if (Value* found = table.find(key)) return *found;
  table.get<Table>()->push_back({key, place, Value{Table{}, place, {}}});
  return table.get<Table>()->back().value;
}

Status put(Value& here, const SchemaNode& node, std::string_view rest, const Addressed& target, const Value& value);

Status put_into_list(Value& list, const SchemaNode& node, std::string_view rest, const Addressed& target,
                     const Value& value) {
  Array* array = list.get<Array>();
  if (array == nullptr || array->empty())
    return Error{"there is no [[" + node.path + "]] to change", value.place.text(), "set the list as a whole"};
  // Elements without a list of their own have nothing to change in it, where others have one.
  const std::size_t dot = rest.find('.');
  const SchemaNode* inner = dot == rest.npos ? nullptr : node.find(rest.substr(0, dot));
  const auto has_list = [inner](const Value& each) { return each.find(inner->name) != nullptr; };
  const bool skips = inner && inner->is_list_of_tables() && std::ranges::any_of(*array, has_list);
  for (std::size_t i = 0; i < array->size(); ++i) {
    if (node.path == "shot" && target.shot && shot_name((*array)[i], i) != *target.shot) continue;
    if (skips && !has_list((*array)[i])) continue;
    if (Status status = put((*array)[i], node, rest, target, value); !status) return status;
  }
  return {};
}

/// Walks from a table to the target, making tables on the way.
Status put(Value& here, const SchemaNode& node, std::string_view rest, const Addressed& target, const Value& value) {
  if (Status status = make_table(node, here); !status) return status;
  const std::size_t dot = rest.find('.');
  const SchemaNode* child = node.find(rest.substr(0, dot));
  PHYSIM_ASSERT(child != nullptr);  // the target is in the tree
  Value& member = member_of(here, child->name, value.place);
  if (dot == rest.npos) return member = value, Status();
  rest.remove_prefix(dot + 1);
  if (child->is_list_of_tables()) return put_into_list(member, *child, rest, target, value);
  return put(member, *child, rest, target, value);
}

}  // namespace

std::string shot_name(const Value& shot, std::size_t index) {
  const Value* name = shot.find("name");
  const std::string* text = name ? name->get<std::string>() : nullptr;
  const std::string own = text ? *text : name ? name->raw : std::string{};
  return own.empty() ? "shot-" + std::to_string(index + 1) : own;
}

Status apply_override(Value& document, const std::string& override_text) {
  const Place place{std::make_shared<const std::string>("--set " + override_text), 0, 0};
  const std::size_t equals = override_text.find('=');
  if (equals == override_text.npos)
    return Error{"an override without \"=\"", place.text(), "write path=value, such as shot.mass=\"168 gr\""};
  const std::string_view path = trimmed(std::string_view(override_text).substr(0, equals));
  const std::string_view text = trimmed(std::string_view(override_text).substr(equals + 1));
  if (text.empty())
    return Error{"an override without a value", place.text(), "write path=value, such as shot.mass=\"168 gr\""};
  const Result<Addressed> target = addressed_in(document, path, place);
  if (!target) return target.error();
  return put(document, schema(), target->node->path, *target, parse_override_value(text, place));
}

}  // namespace physim
