// Values of settings as text that reads back as the same value, bit for bit.
#pragma once

#include <optional>
#include <string>

#include "scenario/schema.hpp"

namespace physim {

/// The value of a setting as the right side of an override; nothing where there is nothing to say (a preset).
[[nodiscard]] std::optional<std::string> written(const Entry& entry, const Scope& scope);

}  // namespace physim
