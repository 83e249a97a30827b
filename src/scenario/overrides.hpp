// Overrides: "shot.mass=170 gr" put into a document before it is read, so that they are checked like the file.
#pragma once

#include <string>
#include <string_view>

#include "scenario/by_path.hpp"
#include "scenario/document.hpp"

namespace physim {

/// The name of the shot at an index: its own, or "shot-1", "shot-2", ...
[[nodiscard]] std::string shot_name(const Value& shot, std::size_t index);

/// Puts one override into a document.
[[nodiscard]] Status apply_override(Value& document, const std::string& override_text);
/// The target of a path in a document; shots are known by their names.
[[nodiscard]] Result<Addressed> address_in(const Value& document, std::string_view path, const Place& place);
/// Puts a value at a target, which is looked at when the document is read. After an error the document is as it was.
[[nodiscard]] Status put_value(Value& document, const Addressed& target, Value&& value);
/// Puts a value, as it stands right of "=" in an override, at a path (scenario/by_path.hpp) of a document. The number
/// that follows the last one of a list adds an element. The value is checked by itself (check_alone()). After an error
/// the document is as it was.
[[nodiscard]] Status put_setting(Value& document, std::string_view path, std::string_view text, const Place& place);

}  // namespace physim
