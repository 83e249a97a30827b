// Quantities as text: what is accepted at the door.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scenario/scenario.hpp"
#include "settings/units.hpp"

namespace physim {

/// Squares of angles stand in files in square degrees [rad^2].
inline constexpr double kSquareDegree = 3.0461741978670857e-4;

/// What has an SI unit; a plain number where nothing has.
[[nodiscard]] Quantity quantity_of_si_unit(std::string_view unit);

/// What the value of an event measures.
[[nodiscard]] Quantity quantity_of_value(EventKind kind);

/// The last unit in a text such as "shot.speed = +- 10 ft/s per round"; null if the text has none of the quantity.
[[nodiscard]] const Unit* last_unit(std::string_view text, Quantity quantity);

/// `expected a mass such as "168 gr"`
[[nodiscard]] std::string expected(Quantity quantity);

[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace physim
