// Reads quantities in all their units.
#include "scenario/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <vector>

#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "base/ieee_mode.hpp"
#include "math/angles.hpp"
#include "scenario/suggest.hpp"

namespace physim {
namespace {

/// One spelling of a unit for comparing: "lb/in²", "lb/in2" and "lb/in^2" are the same.
std::string normalized_unit(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> kReplaced[] = {
      {"^", ""}, {"²", "2"}, {"³", "3"}, {"°", "deg"}, {"µ", "u"}};
  std::string out;
  while (!text.empty()) {
    std::string_view from = text.substr(0, 1), to = from;
    for (const auto& [old_text, new_text] : kReplaced)
      if (text.starts_with(old_text)) from = old_text, to = new_text;
    out += to;
    text.remove_prefix(from.size());
  }
  return out;
}

const Unit* find_unit(const QuantityInfo& quantity, std::string_view text) {
  for (const Unit& unit : quantity.units)
    if (unit.name == text) return &unit;
  const std::string normalized = normalized_unit(text);
  for (const Unit& unit : quantity.units)
    if (normalized_unit(unit.name) == normalized) return &unit;
  return nullptr;
}

/// Why a unit is not one of the quantity's: it belongs to another, or to none.
Error wrong_unit(std::string_view text, std::string_view unit, const QuantityInfo& wanted) {
  for (const QuantityInfo& other : all_quantities())
    if (find_unit(other, unit) != nullptr)
      return {in_quotes(text) + " is " + std::string(other.with_article), "", expected(wanted.quantity)};
  if (unit.front() == ',') return {in_quotes(text) + " has a comma", "", "write a decimal point"};
  const std::vector<std::string> names = units_of(wanted.quantity);
  const std::vector<std::string_view> views(names.begin(), names.end());
  return {"unknown unit " + in_quotes(unit) + " in " + in_quotes(text), "", suggestion(unit, views, "known units")};
}

}  // namespace

Quantity quantity_of_si_unit(std::string_view unit) {
  const auto of = std::ranges::find(all_quantities(), unit, [](const QuantityInfo& q) { return q.units.front().name; });
  return of == all_quantities().end() ? Quantity::number : of->quantity;
}

Quantity quantity_of_value(EventKind kind) {
  switch (row_of(kind).watch) {
    case Watch::height:
    case Watch::range: return Quantity::length;
    case Watch::speed: return Quantity::speed;
    case Watch::time: return Quantity::time;
    case Watch::none:
    case Watch::climb_rate:
    case Watch::mach:
    case Watch::ignition:
    case Watch::burnout:
    case Watch::rail: break;
  }
  return Quantity::number;
}

std::string expected(Quantity quantity) {
  return "expected " + std::string(info(quantity).with_article) + " such as " + in_quotes(info(quantity).example);
}

std::vector<std::string> units_of(Quantity quantity) {
  std::vector<std::string> names;
  if (!is_named(quantity)) return names;
  for (const Unit& unit : info(quantity).units)
    if (!unit.alias && !unit.name.empty()) names.emplace_back(unit.name);
  return names;
}

const Unit* last_unit(std::string_view text, Quantity quantity) {
  const Unit* last = nullptr;
  constexpr std::string_view kDigits = "0123456789.", kEnds = " ,\"]";
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (kDigits.find(text[i - 1]) == kDigits.npos || kDigits.find(text[i]) != kDigits.npos) continue;
    const std::string_view behind = trimmed(text.substr(i));
    const std::string_view name = behind.substr(0, behind.find_first_of(kEnds));
    if (const Unit* unit = name.empty() ? nullptr : find_unit(info(quantity), name)) last = unit;
  }
  return last;
}

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

Result<double> parse_quantity(std::string_view text, Quantity quantity) {
  const IeeeMode mode;
  if (!is_named(quantity)) return Error{"is none of the named values", "quantity", ""};
  const QuantityInfo& wanted = info(quantity);
  const std::string_view whole = trimmed(text);
  std::string_view digits = whole;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double number = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (failure == std::errc::result_out_of_range)
    return Error{in_quotes(whole) + " is too large or too small for a double", "", expected(quantity)};
  if (failure != std::errc{} || std::isnan(number))
    return Error{in_quotes(whole) + " is not a number", "", expected(quantity)};
  const std::string_view unit_text = trimmed(digits.substr(static_cast<std::size_t>(end - digits.data())));
  if (unit_text.empty()) return number;  // SI
  const Unit* unit = find_unit(wanted, unit_text);
  if (unit == nullptr) return wrong_unit(whole, unit_text, wanted);
  const double shifted = unit->zero == 0 ? number : number + unit->zero;  // -0 + 0 would lose the sign
  return shifted * unit->factor / unit->divisor;
}

}  // namespace physim
