// What reading of single values is made of: numbers in their units, lists of points, numbers and colours that are
// drawn; and what errors about them look like.
#pragma once

#include <string>
#include <string_view>

#include "scenario/document.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/schema.hpp"

namespace physim {

/// What a number must be, and how its setting is called in messages.
struct Wanted {
  std::string_view path;
  Quantity quantity;
  Range range;
};

[[nodiscard]] Error fault(std::string_view path, const Value& value, const std::string& message,
                          const std::string& hint);
[[nodiscard]] Error wrong_kind(std::string_view path, const Value& value, const std::string& wanted);

// A target is changed only where its value is good. All mistakes of a list are noted.
[[nodiscard]] Status read_number(const Wanted& wanted, const Value& value, double& target);
/// [[first, second], ...] with rising first numbers.
void read_points(const Entry& entry, const Value& value, const Points& points, Mistakes& mistakes);
/// 5, or [4, 6] for evenly between two, or { value, to, curve, to_curve }.
void read_drawn(const Wanted& wanted, const Value& value, DrawnNumber& target, Mistakes& mistakes);
/// "#ff8000", or ["#ff8000", "#80808080"], or { colour, to, gradient, to_gradient }.
void read_drawn(std::string_view path, const Value& value, DrawnColour& target, Mistakes& mistakes);
/// [[at, "#rrggbbaa"], ...] with rising places, 0..1.
void read_gradient(std::string_view path, const Value& value, Gradient& target, Mistakes& mistakes);

/// How many entries a list may have.
[[nodiscard]] Status check_length(std::string_view path, const Value& value, std::size_t length, const Range& range);

}  // namespace physim
