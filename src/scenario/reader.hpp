// Values of settings from a document.
#pragma once

#include "scenario/document.hpp"
#include "scenario/schema.hpp"

namespace physim {

/// Reads all settings of a table into the objects of a scope. Unknown keys are errors. One error reports all mistakes,
/// in the order of their places.
[[nodiscard]] Status read_table(const SchemaNode& node, const Scope& scope, const Value& value);

/// Reads one setting, or one list of tables, into the objects of a scope.
[[nodiscard]] Status read_setting(const SchemaNode& node, const Scope& scope, const Value& value);

/// Error of a value that should be a table.
[[nodiscard]] Error not_a_table(const SchemaNode& node, const Value& value);

}  // namespace physim
