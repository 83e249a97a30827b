// Rows of the panels, made from the one list of settings: what a setting is called, what it says, how it is changed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/as_written.hpp"
#include "scenario/scenario.hpp"

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

/// The manner in which a scenario's file says numbers, and what was typed since it was opened.
class FileUnits {
 public:
  FileUnits() = default;
  /// The text of a file; of none, empty.
  explicit FileUnits(const std::string& text);

  /// The numbers of an assignment are shown and saved with the units that they have there.
  void take_typed(std::string_view path, std::string_view text) { typed_.take(path, text); }
  [[nodiscard]] const TypedNumbers& typed() const { return typed_; }
  /// The value that the file has of a setting, of a shot by its name; null if it has none.
  [[nodiscard]] const Value* find(std::string_view path, const std::string& shot) const;
  /// A number, "11.0158147 g", in the unit that the file has for a setting, "170 gr", or the nearest that there is in
  /// it; as it is, if the file has none.
  [[nodiscard]] std::string restated(std::string_view path, const std::string& shot, const std::string& number) const;

 private:
  Value document_{Table(), {}, {}, {}};
  TypedNumbers typed_;
};

/// All settings of a table and of the tables in it, in the order of the list: "shot" or "environment". Lists of tables
/// are one row each.
[[nodiscard]] std::vector<SettingRow> setting_rows(std::string_view table);

/// The value of a row as it may be typed, vectors as "0 m, 1.5 m, 0 m"; nothing where there is nothing to say (a
/// preset). Numbers have the units of the file; those that it has none for are in SI, angles in degrees.
[[nodiscard]] std::optional<std::string> row_text(const SettingRow& row, const Scenario& scenario,
                                                  const ScenarioShot& shot, const FileUnits& units = {});
/// Changes a setting as a file would: units are accepted, and errors are those of files.
[[nodiscard]] Status set_value(const SettingRow& row, const std::string& text, Scenario& scenario, ScenarioShot& shot);
/// Changes a setting by an assignment, "shot.mass=170 gr".
[[nodiscard]] Status set_value(std::string_view assignment, Scenario& scenario, ScenarioShot& shot);

}  // namespace physim::client
