// The figures that an [[expect]] can ask for.
#pragma once

#include <span>
#include <string_view>

#include "physim/scenario.hpp"

namespace physim {

/// A figure of a flight at one time: by its sample, or by its place on the Earth. Neither: of the flight as a whole.
struct Figure {
  std::string_view name;
  Quantity quantity;
  double (*value)(const Sample&);
  double Geodetic::*place = nullptr;
};

[[nodiscard]] std::span<const Figure> figures();
[[nodiscard]] std::span<const std::string_view> figure_names();
/// The figure of a name; null where there is none.
[[nodiscard]] const Figure* find_figure(std::string_view name);

}  // namespace physim
