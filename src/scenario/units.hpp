// Quantities and their units: what is accepted at the door, and numbers as text that parses back bit for bit.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "physim/scenario.hpp"

namespace physim {

/// Squares of angles stand in files in square degrees [rad^2].
inline constexpr double kSquareDegree = 3.0461741978670857e-4;

/// A unit: SI value = (number + zero) * factor / divisor. Divisors keep "60 %" and "59 degF" exactly rounded.
struct Unit {
  std::string_view name;
  double factor = 1;
  double zero = 0;
  double divisor = 1;
  bool alias = false;  // another spelling of a unit in the list; accepted, not advertised
};

/// All that is said about a quantity.
struct QuantityInfo {
  Quantity quantity;
  std::string_view with_article;  // "a mass"
  std::string_view example;       // "168 gr"
  std::span<const Unit> units;    // the SI unit first
};

[[nodiscard]] const QuantityInfo& info(Quantity quantity);

/// The SI unit, "" for plain numbers.
[[nodiscard]] inline std::string_view si_unit(Quantity quantity) { return info(quantity).units.front().name; }

/// What has an SI unit; a plain number where nothing has.
[[nodiscard]] Quantity quantity_of_si_unit(std::string_view unit);

/// What the value of an event measures.
[[nodiscard]] Quantity quantity_of_value(EventKind kind);

/// `expected a mass such as "168 gr"`
[[nodiscard]] std::string expected(Quantity quantity);

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string number_text(double value);
/// The shortest text that reads back as the same quantity, with the SI unit: "0.0109 kg".
[[nodiscard]] std::string quantity_text(double value, Quantity quantity);

[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace physim
