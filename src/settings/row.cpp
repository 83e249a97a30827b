// Texts about ranges, in lists of settings.
#include "settings/row.hpp"

#include "settings/units.hpp"

namespace physim {
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

}  // namespace physim
