// Rows of the panels, made from the one list of settings: what a setting is called, what it says, how it is changed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/scenario.hpp"

namespace physim {
struct Entry;
struct SchemaNode;
}  // namespace physim

namespace physim::client {

/// One setting of a scenario or of a shot.
struct SettingRow {
  enum class Kind { text, vector, choice, boolean };

  const SchemaNode* node = nullptr;
  std::string path;   // "shot.drag.table"
  std::string name;   // "table"
  std::string group;  // "drag"; empty: of the shot itself
  Kind kind = Kind::text;
  std::span<const std::string_view> choices;
  std::vector<std::string_view> choice_docs;  // of each choice; empty where they are not known
  std::string doc, unit, range, default_value;
  bool live = false;  // can be changed in flight

  /// What a person is told about it: documentation, unit, range, default.
  [[nodiscard]] std::string tooltip() const;
};

/// All settings of a table and of the tables in it, in the order of the list: "shot" or "environment". Lists of tables
/// are one row each.
[[nodiscard]] std::vector<SettingRow> setting_rows(std::string_view table);

/// The value of a row as it may be typed, vectors as "0 m, 1.5 m, 0 m"; nothing where there is nothing to say (a
/// preset).
[[nodiscard]] std::optional<std::string> row_text(const SettingRow& row, const Scenario& scenario,
                                                  const ScenarioShot& shot);
/// Changes a setting as a file would: units are accepted, and errors are those of files.
[[nodiscard]] Status set_value(const SettingRow& row, const std::string& text, Scenario& scenario, ScenarioShot& shot);
/// Changes a setting by an assignment, "shot.mass=170 gr".
[[nodiscard]] Status set_value(std::string_view assignment, Scenario& scenario, ScenarioShot& shot);

}  // namespace physim::client
