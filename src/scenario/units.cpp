// Reads quantities in all their units.
#include "scenario/units.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "base/ieee_mode.hpp"
#include "math/angles.hpp"
#include "scenario/document.hpp"
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
    if (is_same_key(unit.name, text)) return &unit;
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

std::from_chars_result number_at_start(std::string_view text, double& number) {
  const bool has_plus = text.starts_with('+') && !text.starts_with("+-");
  return std::from_chars(text.data() + (has_plus ? 1 : 0), text.data() + text.size(), number);
}

std::string_view behind_number(std::string_view text) {
  double number = 0;
  const auto [end, failure] = number_at_start(text, number);
  return failure == std::errc::invalid_argument ? text : text.substr(static_cast<std::size_t>(end - text.data()));
}

bool is_same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

std::optional<std::string> number_with(double value, Quantity quantity, const std::string& unit, ReadsAs wanted) {
  constexpr int kMostDigits = std::numeric_limits<double>::max_digits10, kNeighbours = 4;
  const IeeeMode mode;
  const Unit* known = find_unit(info(quantity), trimmed(unit));
  if (known == nullptr) return std::nullopt;
  const auto text_of = [&](double number) -> std::optional<std::string> {
    std::string text = number_text(number) + unit;
    const Result<double> read = parse_quantity(text, quantity);
    return read && is_same_number(*read, value) ? std::optional(std::move(text)) : std::nullopt;
  };
  const double middle = value * known->divisor / known->factor - known->zero;  // but for its last digits
  const auto rounded = [&](std::chars_format format, int digits) {
    char buffer[64];
    const auto done = std::to_chars(buffer, std::end(buffer), middle, format, digits);
    PHYSIM_ASSERT(done.ec == std::errc());
    double number = 0;
    std::from_chars(buffer, done.ptr, number);
    return number;
  };
  // A unit whose zero is elsewhere leaves a number with an error of its own size, also near 0.
  const bool is_shifted = known->zero != 0 && std::abs(middle) < 1e9;
  for (int digits = 0; is_shifted && digits <= kMostDigits; ++digits)
    if (auto text = text_of(rounded(std::chars_format::fixed, digits) + 0.0)) return text;  // -0 is 0 there
  for (int digits = 1; digits <= kMostDigits; ++digits)
    if (auto text = text_of(rounded(std::chars_format::general, digits))) return text;
  for (double low = middle, high = middle, i = 0; i < kNeighbours; ++i) {
    low = std::nextafter(low, -HUGE_VAL), high = std::nextafter(high, HUGE_VAL);
    for (const double number : {low, high})
      if (auto text = text_of(number)) return text;
  }
  return wanted == ReadsAs::nearest ? std::optional(number_text(middle) + unit) : std::nullopt;
}

Result<double> parse_quantity(std::string_view text, Quantity quantity) {
  const IeeeMode mode;
  if (!is_named(quantity)) return Error{"is none of the named values", "quantity", ""};
  const QuantityInfo& wanted = info(quantity);
  const std::string_view whole = trimmed(text);
  double number = 0;
  const auto [end, failure] = number_at_start(whole, number);
  if (failure == std::errc::result_out_of_range)
    return Error{in_quotes(whole) + " is too large or too small for a double", "", expected(quantity)};
  if (failure != std::errc{} || std::isnan(number))
    return Error{in_quotes(whole) + " is not a number", "", expected(quantity)};
  const std::string_view unit_text = trimmed(whole.substr(static_cast<std::size_t>(end - whole.data())));
  if (unit_text.empty()) return number;  // SI
  const Unit* unit = find_unit(wanted, unit_text);
  if (unit == nullptr) return wrong_unit(whole, unit_text, wanted);
  const double shifted = unit->zero == 0 ? number : number + unit->zero;  // -0 + 0 would lose the sign
  return shifted * unit->factor / unit->divisor;
}

}  // namespace physim
