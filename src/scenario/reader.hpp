// Values of settings from a document.
#pragma once

#include "scenario/document.hpp"
#include "scenario/schema.hpp"

namespace physim {

/// The extent of checks.
enum class Checks {
  of_each,   ///< of every setting that is there by itself: others may still be to come
  together,  ///< of all together
  all,       ///< of all together, and Scenario::notes and given are made
};

/// Reads all settings of a table into the objects of a scope. Unknown keys are errors. One error reports all mistakes,
/// in the order of their places.
[[nodiscard]] Status read_table(const SchemaNode& node, const Scope& scope, const Value& value,
                                Checks checks = Checks::all);

/// Reads one setting, or one list of tables, into the objects of a scope.
[[nodiscard]] Status read_setting(const SchemaNode& node, const Scope& scope, const Value& value);

/// Reads a document of a scenario file into a new scenario, which is large to move; `file` names it in errors, and
/// other files are looked for beside it.
[[nodiscard]] Status read_scenario(const Value& document, const std::string& file, Checks checks, Scenario& scenario);

/// The notes of a scenario that was read from a document without them.
[[nodiscard]] Result<std::vector<std::string>> notes_of(Scenario scenario, Value document);

/// What to write instead of a key that a table does not have, where that is no misspelling; empty where nothing is
/// known of it. `table`: its path.
[[nodiscard]] std::string hint_of_key(std::string_view table, std::string_view key);

/// Error of a value that should be a table.
[[nodiscard]] Error not_a_table(const SchemaNode& node, const Value& value);

}  // namespace physim
