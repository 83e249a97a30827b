// Equations, symbols and Source: model/magnus.hpp.
#include "model/magnus_grid.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "math/interpolation.hpp"

namespace physim {
namespace {

std::size_t index_of(const std::vector<double>& values, double value) {
  return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) - values.begin());
}

/// The cell that a value is in, and where in it, 0..1; held at both ends.
struct Place {
  std::size_t cell;
  double part;
};
Place place_of(const std::vector<double>& values, double value) {
  if (values.size() < 2 || !(value > values.front())) return {0, 0};
  const auto above = std::upper_bound(values.begin(), values.end(), value);
  if (above == values.end()) return {values.size() - 2, 1};
  const auto cell = static_cast<std::size_t>(above - values.begin()) - 1;
  PHYSIM_ASSERT(values[cell] <= value && value < values[cell + 1]);
  return {cell, (value - values[cell]) / (values[cell + 1] - values[cell])};
}

}  // namespace

PHYSIM_COLD MagnusGrid magnus_grid(const MagnusDef& magnus) {
  MagnusGrid g;
  g.by_parameter = magnus.measure == SpinMeasure::parameter;
  std::vector<double> speeds, spins;
  for (const MagnusPoint& p : magnus.table) speeds.push_back(p.speed), spins.push_back(p.spin);
  g.speeds = rising(speeds);
  g.spins = rising(spins);
  g.drag.assign(g.speeds.size() * g.spins.size(), -1);
  g.lift.assign(g.drag.size(), 0);
  for (const MagnusPoint& p : magnus.table) {
    const std::size_t at = index_of(g.speeds, p.speed) * g.spins.size() + index_of(g.spins, p.spin);
    PHYSIM_ASSERT(at < g.drag.size());
    g.drag[at] = p.drag;
    g.lift[at] = p.lift;
  }
  return g;
}

bool is_full(const MagnusGrid& g, std::size_t points) {
  return points == g.drag.size() && std::count(g.drag.begin(), g.drag.end(), -1.0) == 0;
}

MagnusCoefficients magnus_at(const MagnusGrid& g, double speed, double spin, double parameter) {
  PHYSIM_ASSERT(!g.spins.empty() && g.drag.size() == g.speeds.size() * g.spins.size());
  PHYSIM_ASSERT(g.lift.size() == g.drag.size());
  const double by = g.by_parameter ? parameter : spin;
  const Place row = place_of(g.speeds, speed);
  const Place column = place_of(g.spins, by);
  const std::size_t width = g.spins.size();
  const auto read = [&](const std::vector<double>& values) {
    const std::size_t next_row = g.speeds.size() > 1 ? width : 0;
    const std::size_t next = width > 1 ? 1 : 0;
    const std::size_t at = row.cell * width + column.cell;
    const double low = values[at] + (values[at + next] - values[at]) * column.part;
    const double high = values[at + next_row] + (values[at + next_row + next] - values[at + next_row]) * column.part;
    return low + (high - low) * row.part;
  };
  const double lowest = g.spins.front();
  const double fading = lowest > 0 && by < lowest ? by / lowest : 1;
  return {read(g.drag), read(g.lift) * fading};
}

}  // namespace physim
