// Settings by their paths, at every door: overrides of the command line, ScenarioFile, the C interface.
//
// A path names tables and keys: "environment.wind.velocity". Behind a list of tables may stand the number of an
// element, from 1, "thing.2.position"; without one all elements are meant. A shot also goes by its name,
// "shot.NAME.mass", and a path that begins with no table of a file is one of shots: "drag.table" is "shot.drag.table".
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/document.hpp"
#include "scenario/schema.hpp"

namespace physim {

/// The target of a path: a setting or table of the tree, and an element of each list of tables on its way.
struct Addressed {
  const SchemaNode* node = nullptr;
  std::vector<std::optional<std::size_t>> elements;  // from 0, outer lists first; none: all elements
};

/// Returns the names of all shots; called where a path may have one.
using ShotNames = std::function<std::vector<std::string>()>;

/// Finds the target of a path. Whether the numbered elements exist is not looked at.
[[nodiscard]] Result<Addressed> address(std::string_view path, const ShotNames& shots, const Place& place);

/// The value of a setting as the right side of an override, in SI. An error if the path leads to no setting, or to
/// several, and if there is no value, as of a preset. Slots of settings write as well as read, hence no const.
[[nodiscard]] Result<std::string> value_at(Scenario& scenario, std::string_view path);
/// The number of elements of a list of tables.
[[nodiscard]] Result<std::size_t> length_at(Scenario& scenario, std::string_view path);

/// Refuses a value that a setting cannot have whatever the others are. What depends on others is not looked at.
[[nodiscard]] Status check_alone(const SchemaNode& node, const Value& value);

}  // namespace physim
