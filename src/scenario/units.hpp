// Quantities as text: what is accepted at the door.
#pragma once

#include <charconv>
#include <optional>
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

/// Reads the number that a text begins with, a "+" before it too; as std::from_chars() does.
std::from_chars_result number_at_start(std::string_view text, double& number);
/// What stands behind the number that a text begins with, blanks included: " gr" of "168 gr"; the whole text if that
/// begins with none.
[[nodiscard]] std::string_view behind_number(std::string_view text);

/// Equal bits: -0 is not 0, and one NaN is another.
[[nodiscard]] bool is_same_number(double a, double b);

/// What a text of a number must read back as: the same bits, or else the nearest number that there is.
enum class ReadsAs { same, nearest };
/// The shortest text of a value with a unit behind it, " gr"; nothing if there is no such unit, or if no number in it
/// reads as the same bits and these are asked for.
[[nodiscard]] std::optional<std::string> number_with(double value, Quantity quantity, const std::string& unit,
                                                     ReadsAs wanted = ReadsAs::same);

/// `expected a mass such as "168 gr"`
[[nodiscard]] std::string expected(Quantity quantity);

[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace physim
