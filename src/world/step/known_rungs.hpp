// The rungs that games use most, which the world's kernels know at compile time.
#pragma once

#include "base/isa.hpp"
#include "physim/fidelity.hpp"
#include "physim/math.hpp"

namespace physim {

/// Calls f with a Rung of each, in one order everywhere.
template <template <DragModel, WindModel, AirModel> class Rung, class F>
PHYSIM_INLINE void each_known_rung(const F& f) {
  using enum DragModel;
  constexpr WindModel kCalm = WindModel::off, kWind = WindModel::constant;
  constexpr AirModel kUnread = AirModel::vacuum;
  f(Rung<off, kCalm, kUnread>{});
  f(Rung<damping, kCalm, kUnread>{});
  f(Rung<linear_quadratic, kCalm, kUnread>{});
  f(Rung<linear_quadratic, kWind, kUnread>{});
  f(Rung<equation, kCalm, AirModel::isa>{});
  f(Rung<equation, kWind, AirModel::isa>{});
}

}  // namespace physim
