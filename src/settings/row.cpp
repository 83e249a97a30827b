// Texts about ranges: in lists of settings and in errors.
#include "settings/row.hpp"

#include "math/angles.hpp"
#include "settings/units.hpp"

namespace physim {
namespace {

/// A bound of a range as messages show it: angles in degrees.
std::string bound_text(const SettingRow& row, double bound) {
  return short_text(row.quantity == Quantity::angle ? bound / kDegree : bound);
}

std::string unit_behind(const SettingRow& row) {
  if (row.quantity == Quantity::angle) return " degrees";
  const std::string_view unit = unit_of(row);
  return unit.empty() ? "" : " " + std::string(unit);
}

/// What a range requires, without the value that is out of it.
std::string wish_text(const SettingRow& row) {
  const Range& range = row.range;
  const std::string unit = unit_behind(row);
  if (range.high == kInfinity && range.low == 0) {
    if (!range.low_open) return "must be zero or positive";
    return range.infinite ? "must be positive" : "must be a positive number";
  }
  if (range.high == kInfinity) return range.infinite ? "must be a number" : "must be a finite number";
  PHYSIM_ASSERT(std::isfinite(range.low));
  if (range.low == -range.high && row.quantity != Quantity::angle) return "exceeds " + short_text(range.high) + unit;
  if (range.low_open)
    return "must lie above " + bound_text(row, range.low) + " and not above " + bound_text(row, range.high) + unit;
  return "must lie between " + bound_text(row, range.low) + " and " + bound_text(row, range.high) + unit;
}

}  // namespace

std::string Range::text() const {
  if (!words.empty()) return std::string(words);
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  if (has_low && low == high) return number_text(low);
  if (has_low && has_high && !low_open) return number_text(low) + " .. " + number_text(high);
  std::string out;
  if (has_low) out = (low_open ? "> " : ">= ") + number_text(low);
  if (has_high) out += (out.empty() ? "<= " : ", <= ") + number_text(high);
  return out;
}

std::string_view unit_of(const SettingRow& row) { return row.unit.empty() ? si_unit(row.quantity) : row.unit; }

std::string range_error(const SettingRow& row, double value) {
  PHYSIM_ASSERT(!row.range.contains(value));
  const std::string wish = wish_text(row);
  const bool is_said = wish.find("finite") != std::string::npos || row.range.infinite;
  const std::string also = std::isfinite(value) || is_said ? "" : ", and be finite";
  return wish + also + ", not " + bound_text(row, value);
}

Status error_of(const OutOfRange& first, const InputPlace& place, bool is_item) {
  if (!first.row) return {};
  const std::string at = is_item ? place.text() : place.text() + std::string(first.row->path);
  if (first.is_enumerator) return Error{"is none of the named values", at, ""};
  return Error{range_error(*first.row, first.value), at, hint_of(*first.row)};
}

std::string hint_of(const SettingRow& row) {
  if (!row.hint.empty()) return std::string(row.hint);
  const std::string_view unit = unit_of(row);
  return unit.empty() ? std::string(row.doc) : "in " + std::string(unit) + ": " + std::string(row.doc);
}

}  // namespace physim
