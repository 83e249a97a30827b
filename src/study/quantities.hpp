// The table of a study's quantities: a row for each StudyQuantity.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "base/enumerators.hpp"
#include "physim/study.hpp"

namespace physim {

struct QuantityRow {
  StudyQuantity quantity;
  std::string_view name, unit;
  bool of_impact = false;  // of what the shot meets first, else of the end of its flight
};

constexpr auto kStudyQuantities = [] {
  using enum StudyQuantity;
  return std::array{
      QuantityRow{time, "time", "s"},
      QuantityRow{x, "x", "m"},
      QuantityRow{y, "y", "m"},
      QuantityRow{z, "z", "m"},
      QuantityRow{vx, "vx", "m/s"},
      QuantityRow{vy, "vy", "m/s"},
      QuantityRow{vz, "vz", "m/s"},
      QuantityRow{speed, "speed", "m/s"},
      QuantityRow{right, "right", "m"},
      QuantityRow{up, "up", "m"},
      QuantityRow{along, "along", "m"},
      QuantityRow{impact_speed, "impact_speed", "m/s", true},
      QuantityRow{obliquity, "obliquity", "rad", true},
      QuantityRow{impact_energy, "impact_energy", "J", true},
  };
}();
static_assert(has_row_for_each(kStudyQuantities, &QuantityRow::quantity), "a quantity has no row");

[[nodiscard]] constexpr const QuantityRow& row_of(StudyQuantity quantity) {
  return kStudyQuantities[static_cast<std::size_t>(quantity)];
}
[[nodiscard]] constexpr std::string_view unit_of(StudyQuantity quantity) { return row_of(quantity).unit; }
[[nodiscard]] constexpr bool is_of_impact(StudyQuantity quantity) { return row_of(quantity).of_impact; }

}  // namespace physim
