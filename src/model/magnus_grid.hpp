// Tables of drag and lift of balls that spin, as grids.
//
// What it models: see model/magnus.hpp for equations and symbols.
// Source: model/magnus.hpp.
#pragma once

#include <cstddef>
#include <vector>

#include "physim/projectile.hpp"

namespace physim {

/// A table as a grid.
struct MagnusGrid {
  std::vector<double> speeds;  // rising
  std::vector<double> spins;   // rising
  std::vector<double> drag;    // [speed][spin]
  std::vector<double> lift;
  bool by_parameter = false;

  bool operator==(const MagnusGrid&) const = default;
};

struct MagnusCoefficients {
  double drag;
  double lift;
};

[[nodiscard]] MagnusGrid magnus_grid(const MagnusDef& magnus);
/// Whether a table has every speed with every spin, once.
[[nodiscard]] bool is_full(const MagnusGrid& grid, std::size_t points);
/// Bilinear; `spin` is the rate across the path, `parameter` S.
[[nodiscard]] MagnusCoefficients magnus_at(const MagnusGrid& grid, double speed, double spin, double parameter);

}  // namespace physim
