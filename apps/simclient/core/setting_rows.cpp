#include "simclient/core/setting_rows.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "base/assert.hpp"
#include "scenario/overrides.hpp"
#include "scenario/reader.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"
#include "scenario/writer.hpp"

namespace physim::client {
namespace {

/// ["0 m", "1.5 m"] as people write it, and back.
std::string without_brackets(std::string text) {
  std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == '"'; });
  return text;
}

/// Numbers to seven digits, what a field has room for. What is not typed over keeps all of its digits.
std::string shortened(const std::string& text) {
  constexpr std::ptrdiff_t kRoom = 9;
  std::string out;
  for (const char* at = text.c_str(); *at != 0;) {
    char* end = nullptr;
    const double value = *at >= '0' && *at <= '9' ? std::strtod(at, &end) : 0;
    if (end == nullptr) {
      out += *at++;
      continue;
    }
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.7g", value);
    out += end - at > kRoom ? std::string(digits) : std::string(at, static_cast<std::size_t>(end - at));
    at = end;
  }
  return out;
}

/// The value of a row, with the units that it was typed with or those of a value in a file; null: none.
std::optional<std::string> shown_text(const SettingRow& row, const Scope& scope, const TypedNumbers& typed,
                                      const Value* like) {
  if (row.unit.empty() && row.kind != SettingRow::Kind::vector) return written(*row.node->entry, scope);
  std::optional<std::string> text = written_in_file(*row.node->entry, scope);
  if (!text) return text;
  *text = as_typed(*text, *row.node, typed, like, ReadsAs::nearest);
  const bool is_one = row.kind == SettingRow::Kind::vector || text->starts_with('"');
  return shortened(is_one ? without_brackets(*text) : *text);
}

SettingRow make_row(const SchemaNode& node, const std::string& table) {
  SettingRow row;
  row.node = &node;
  row.path = node.path;
  row.name = node.name;
  if (node.path.size() > table.size() + 1 + node.name.size())
    row.group = node.path.substr(table.size() + 1, node.path.size() - table.size() - node.name.size() - 2);
  const auto all = settings();
  const auto setting = std::find_if(all.begin(), all.end(), [&](const Setting& s) { return s.path == node.path; });
  row.doc = setting->doc, row.unit = setting->unit, row.range = setting->range;
  row.default_value = setting->default_value;
  row.live = setting->live;
  Defaults defaults;
  const ValueRef slot = node.entry->slot(defaults.scope());
  if (std::holds_alternative<bool*>(slot)) row.kind = SettingRow::Kind::boolean;
  if (std::holds_alternative<Vec3d*>(slot) || std::holds_alternative<std::optional<Vec3d>*>(slot))
    row.kind = SettingRow::Kind::vector;
  if (const auto* choice = std::get_if<Choice>(&slot)) {
    row.kind = SettingRow::Kind::choice;
    row.choices = choice->names;
    for (std::size_t i = 0; choice->doc != nullptr && i < choice->names.size(); ++i)
      row.choice_docs.push_back(choice->doc(i));
  }
  if (node.entry->quantity == Quantity::angle) {
    row.unit = "deg";
    row.default_value = shown_text(row, defaults.scope(), {}, nullptr).value_or("");
  }
  return row;
}

void collect(const SchemaNode& node, const std::string& table, std::vector<SettingRow>& rows) {
  for (const SchemaNode& child : node.children) {
    if (child.entry != nullptr)
      rows.push_back(make_row(child, table));
    else
      collect(child, table, rows);
  }
}

/// The error of a file begins with the setting, which is its place here.
Error told_once(Error error) {
  const std::string again = error.place + ": ";
  if (error.message.starts_with(again)) error.message.erase(0, again.size());
  return error;
}

std::string with_brackets(std::string_view text) {
  if (text.find('[') != text.npos || text.find(',') == text.npos) return std::string(text);
  std::string out = "[";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    out += (out.size() > 1 ? ", \"" : "\"") + std::string(trimmed(text.substr(0, end))) + "\"";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + "]";
}

}  // namespace

std::string SettingRow::tooltip() const {
  std::string text = path + "\n" + doc;
  if (!unit.empty()) text += "\nunit: " + unit + ", others are understood";
  if (!range.empty() && range.size() < 120) text += "\nrange: " + range;
  if (!default_value.empty()) text += "\ndefault: " + default_value;
  return text;
}

FileUnits::FileUnits(const std::string& text) {
  if (Result<Value> document = parse_document(text, ""); document) document_ = std::move(*document);
}

const Value* FileUnits::find(std::string_view path, const std::string& shot) const {
  constexpr std::string_view kShotPath = "shot.";
  PHYSIM_ASSERT(find_node(path) != nullptr);
  std::string_view rest = path;
  const Value* here = &document_;
  const SchemaNode* node = &schema();
  if (rest.starts_with(kShotPath)) {
    const Value* list = document_.find("shot");
    const Array* shots = list ? list->get<Array>() : nullptr;
    here = nullptr;
    for (std::size_t i = 0; shots && !here && i < shots->size(); ++i)
      if (shot_name((*shots)[i], i) == shot) here = &(*shots)[i];
    node = find_node("shot");
    rest.remove_prefix(kShotPath.size());
  }
  while (here != nullptr && !rest.empty()) {
    const std::string_view key = rest.substr(0, rest.find('.'));
    if (here->get<Table>() == nullptr) return rest == node->shorthand ? here : nullptr;
    here = here->find(key);
    node = node->find(key);
    rest.remove_prefix(std::min(key.size() + 1, rest.size()));
  }
  return here;
}

std::string FileUnits::restated(std::string_view path, const std::string& shot, const std::string& number) const {
  const SchemaNode* node = find_node(path);
  PHYSIM_ASSERT(node != nullptr && node->entry != nullptr);
  const Quantity quantity = node->entry->quantity;
  const Value* said = find(path, shot);
  const std::string unit = said ? unit_of(*said, quantity) : "";
  const Result<double> value = parse_quantity(number, quantity);
  if (unit.empty() || !value) return number;
  return number_with(*value, quantity, unit, ReadsAs::nearest).value_or(number);
}

std::vector<SettingRow> setting_rows(std::string_view table) {
  std::vector<SettingRow> rows;
  if (const SchemaNode* node = find_node(table)) collect(*node, std::string(table), rows);
  return rows;
}

std::optional<std::string> row_text(const SettingRow& row, const Scenario& scenario, const ScenarioShot& shot,
                                    const FileUnits& units) {
  Scenario of_scenario;  // slots are for reading and writing
  of_scenario.environment = scenario.environment;
  of_scenario.world = scenario.world;
  ScenarioShot copy = shot;
  const Value* like = units.find(row.path, shot.projectile.name);
  return shown_text(row, {.scenario = &of_scenario, .shot = &copy}, units.typed(), like);
}

Status set_value(const SettingRow& row, const std::string& text, Scenario& scenario, ScenarioShot& shot) {
  ScenarioShot changed = shot;
  Scenario changed_scenario = scenario;
  const std::string typed = row.kind == SettingRow::Kind::vector ? with_brackets(text) : text;
  const Value value = parse_override_value(typed, Place{std::make_shared<const std::string>(row.path), 0, 0});
  const Scope scope{.scenario = &changed_scenario, .shot = &changed};
  if (Status status = read_setting(*row.node, scope, value); !status) return told_once(status.error());
  shot = std::move(changed);
  scenario = std::move(changed_scenario);
  return {};
}

Status set_value(std::string_view assignment, Scenario& scenario, ScenarioShot& shot) {
  const std::size_t equals = assignment.find('=');
  const std::string path(trimmed(assignment.substr(0, equals)));
  if (equals == assignment.npos) return Error{in_quotes(assignment) + " is no PATH=VALUE", "set", "shot.mass=170 gr"};
  std::vector<std::string_view> known;
  static const auto* const rows = new std::vector<SettingRow>([] {
    std::vector<SettingRow> all = setting_rows("shot"), more = setting_rows("environment");
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }());
  for (const SettingRow& row : *rows) {
    if (row.path == path) return set_value(row, std::string(trimmed(assignment.substr(equals + 1))), scenario, shot);
    known.push_back(row.path);
  }
  return Error{"unknown setting " + in_quotes(path), "set", suggestion(path, known, "settings")};
}

}  // namespace physim::client
