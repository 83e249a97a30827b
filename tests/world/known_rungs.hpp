// The rungs that the world's kernels know at compile time, for tests.
#pragma once

#include <vector>

#include "physim/fidelity.hpp"

namespace physim::test {

/// Those that step; closed forms are known, too.
inline std::vector<Fidelity> known_rungs() {
  std::vector<Fidelity> list;
  for (const DragModel drag : {DragModel::off, DragModel::damping, DragModel::linear_quadratic, DragModel::equation})
    for (const WindModel wind : {WindModel::off, WindModel::constant})
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        Fidelity f = Fidelity::game();
        f.drag = drag;
        f.wind = wind;
        f.air = AirModel::isa;
        f.precision = precision;
        list.push_back(f);
      }
  return list;
}

}  // namespace physim::test
