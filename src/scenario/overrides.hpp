// Overrides: "shot.mass=170 gr" put into a document before it is read, so that they are checked like the file.
#pragma once

#include <string>

#include "scenario/document.hpp"

namespace physim {

/// The name of the shot at an index: its own, or "shot-1", "shot-2", ...
[[nodiscard]] std::string shot_name(const Value& shot, std::size_t index);

/// Puts one override into a document.
[[nodiscard]] Status apply_override(Value& document, const std::string& override_text);

}  // namespace physim
