// The units of quantities, and numbers as text that parses back bit for bit.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "physim/units.hpp"

namespace physim {

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

/// In the order of the enumerators.
[[nodiscard]] std::span<const QuantityInfo> all_quantities();
/// False for a number that is no enumerator, which a cast can make.
[[nodiscard]] bool is_named(Quantity quantity);
[[nodiscard]] const QuantityInfo& info(Quantity quantity);

/// The SI unit, "" for plain numbers.
[[nodiscard]] inline std::string_view si_unit(Quantity quantity) { return info(quantity).units.front().name; }

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string number_text(double value);
/// The shortest text that reads back as the same quantity, with the SI unit: "0.0109 kg".
[[nodiscard]] std::string quantity_text(double value, Quantity quantity);
/// As quantity_text(), for sentences: without the rounding errors of conversions into SI, "0.3048 m" of 12 in.
[[nodiscard]] std::string quantity_in_words(double value, Quantity quantity);

}  // namespace physim
