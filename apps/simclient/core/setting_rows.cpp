#include "simclient/core/setting_rows.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "scenario/reader.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/writer.hpp"

namespace physim::client {
namespace {

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

std::vector<SettingRow> setting_rows(std::string_view table) {
  std::vector<SettingRow> rows;
  if (const SchemaNode* node = find_node(table)) collect(*node, std::string(table), rows);
  return rows;
}

std::optional<std::string> row_text(const SettingRow& row, const Scenario& scenario, const ScenarioShot& shot) {
  Scenario of_scenario;  // slots are for reading and writing
  of_scenario.environment = scenario.environment;
  of_scenario.world = scenario.world;
  ScenarioShot copy = shot;
  std::optional<std::string> text = written(*row.node->entry, {.scenario = &of_scenario, .shot = &copy});
  if (text && row.kind == SettingRow::Kind::vector) return shortened(without_brackets(*text));
  return text && !row.unit.empty() ? shortened(*text) : text;
}

Status set_value(const SettingRow& row, const std::string& text, Scenario& scenario, ScenarioShot& shot) {
  ScenarioShot changed = shot;
  Scenario changed_scenario = scenario;
  const std::string typed = row.kind == SettingRow::Kind::vector ? with_brackets(text) : text;
  const Value value = parse_override_value(typed, Place{std::make_shared<const std::string>(row.path), 0, 0});
  const Scope scope{.scenario = &changed_scenario, .shot = &changed};
  if (Status status = read_setting(*row.node, scope, value); !status) return status;
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
