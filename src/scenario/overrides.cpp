#include "scenario/overrides.hpp"

#include <algorithm>
#include <optional>

#include "base/assert.hpp"
#include "physim/body.hpp"
#include "scenario/reader.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

std::vector<std::string> shot_names(const Value& document) {
  std::vector<std::string> names;
  const Value* shots = document.find("shot");
  if (const Array* array = shots ? shots->get<Array>() : nullptr)
    for (std::size_t i = 0; i < array->size(); ++i) names.push_back(shot_name((*array)[i], i));
  return names;
}

/// Makes a table of a value that stands for one: gravity = "off" becomes { model = "off" }.
Status make_table(const SchemaNode& node, Value& value) {
  if (value.get<Table>() != nullptr) return {};
  if (node.shorthand.empty()) return not_a_table(node, value);
  Value inner = value;
  value.content = Table{{node.shorthand, value.place, std::move(inner)}};
  return {};
}

/// Where an override goes, and the number of the next list of tables on its way.
struct Way {
  const Addressed& target;
  std::size_t list = 0;
  const Value* element = nullptr;  // of the last list that it goes through
};

/// A list that a shot has of its preset has no elements in the document, and a first one would be all of it.
Status check_new_list(const SchemaNode& list, const Value* shot, const Place& place) {
  if (list.path != "shot.magnus.table") return {};
  const Value* name = shot->find("preset");
  const std::string* text = name ? name->get<std::string>() : nullptr;
  const auto preset = text ? projectile_preset(*text) : std::nullopt;
  if (!preset || preset->projectile.magnus.table.empty()) return {};
  return Error{list.path + " is that of the preset " + in_quotes(*text) + ", whose rows are not set one by one",
               place.text(), "set the table as a whole, or shot.drag and shot.magnus.lift without a preset"};
}

Status put(Value& here, const SchemaNode& node, Way way, Value&& value);

/// Into one element, which is made if it is the next one.
Status put_into_element(Array& array, const SchemaNode& node, std::size_t index, const Way& way, Value&& value) {
  PHYSIM_ASSERT(node.is_list_of_tables());
  const std::string count = std::to_string(array.size()), next = std::to_string(array.size() + 1);
  if (index > array.size())
    return Error{"there are " + count + " [[" + node.path + "]]", value.place.text(), "number " + next + " adds one"};
  if (index < array.size()) return put(array[index], node, way, std::move(value));
  Value made{Table{}, value.place, {}, {}};
  if (Status status = put(made, node, way, std::move(value)); !status) return status;
  array.push_back(std::move(made));
  return {};
}

Status put_into_list(Value& list, const SchemaNode& node, Way way, Value&& value) {
  PHYSIM_ASSERT(way.list < way.target.elements.size());
  const std::optional<std::size_t> element = way.target.elements[way.list++];
  Array* array = list.get<Array>();
  if (array == nullptr || (array->empty() && !element))
    return Error{"there is no [[" + node.path + "]] to change", value.place.text(), "set the list as a whole"};
  if (element) return put_into_element(*array, node, *element, way, std::move(value));
  if (array->size() == 1) return put(array->front(), node, way, std::move(value));
  // Elements without a list of their own have nothing to change in it, where others have one.
  const SchemaNode& inner = node.child_towards(*way.target.node);
  const auto has_list = [&inner](const Value& each) { return each.find(inner.name) != nullptr; };
  const bool is_last = &inner == way.target.node;
  const bool skips = !is_last && inner.is_list_of_tables() && std::ranges::any_of(*array, has_list);
  for (Value& each : *array) {
    if (skips && !has_list(each)) continue;
    if (Status status = put(each, node, way, Value(value)); !status) return status;
  }
  return {};
}

/// Walks from a table to the target. What is missing on the way is made apart, so that an error leaves nothing behind.
Status put(Value& here, const SchemaNode& node, Way way, Value&& value) {
  if (Status status = make_table(node, here); !status) return status;
  if (node.is_list_of_tables()) way.element = &here;
  const SchemaNode& child = node.child_towards(*way.target.node);
  Value* member = here.find(child.name);
  const bool is_last = &child == way.target.node, is_list = !is_last && child.is_list_of_tables();
  const auto put_into = [&](Value& into) {
    if (is_last) return into = std::move(value), Status();
    return is_list ? put_into_list(into, child, way, std::move(value)) : put(into, child, way, std::move(value));
  };
  if (member != nullptr) return put_into(*member);
  Table& table = *here.get<Table>();
  if (table.size() == table.capacity()) table.reserve(2 * table.size() + 6);  // few have one key alone
  if (is_last) return table.push_back({child.name, value.place, std::move(value)}), Status();
  Value made{Table{}, value.place, {}, {}};
  if (is_list) {
    if (Status status = check_new_list(child, way.element, made.place); !status) return status;
    made.content = Array{};
  }
  if (Status status = put_into(made); !status) return status;
  table.push_back({child.name, made.place, std::move(made)});
  return {};
}

}  // namespace

std::string shot_name(const Value& shot, std::size_t index) {
  const Value* name = shot.find("name");
  const std::string* text = name ? name->get<std::string>() : nullptr;
  const std::string own = text ? *text : name && name->raw ? *name->raw : std::string{};
  return own.empty() ? "shot-" + std::to_string(index + 1) : own;
}

Result<Addressed> address_in(const Value& document, std::string_view path, const Place& place) {
  return address(
      path, [&document] { return shot_names(document); }, place);
}

Status put_value(Value& document, const Addressed& target, Value&& value) {
  PHYSIM_ASSERT(target.node != nullptr);
  return put(document, schema(), {target}, std::move(value));
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
  const Result<Addressed> target = address_in(document, path, place);
  if (!target) return target.error();
  return put_value(document, *target, parse_override_value(text, place));
}

Status put_setting(Value& document, std::string_view path, std::string_view text, const Place& place) {
  const Result<Addressed> target = address_in(document, path, place);
  if (!target) return target.error();
  Value value = parse_override_value(text, place);
  if (Status status = check_alone(*target->node, value); !status) return status;
  return put_value(document, *target, std::move(value));
}

}  // namespace physim
