// The rungs that games use most, which kernels of worlds know at compile time: the models, the same functions, fold to
// a few instructions there, and packs stay in registers.
#pragma once

#include <cstdint>
#include <iterator>
#include <utility>

#include "model/conditions.hpp"

namespace physim {

/// Effects of a static rung: constant gravity over a flat Earth, no rotation, and no features. A force that acts over a
/// whole step may come on top: every static rung that steps can take one.
struct StaticRungSpec {
  Motion motion;
  DragModel drag;
  WindModel wind = WindModel::off;
  AirModel air = AirModel::vacuum;  // read with a drag curve alone
};

/// Those that step take semi-implicit Euler's; the closed form is that of a fall in a vacuum.
inline constexpr StaticRungSpec kStaticRungs[] = {
    {Motion::force, DragModel::off},
    {Motion::force, DragModel::damping},
    {Motion::force, DragModel::linear_quadratic},
    {Motion::force, DragModel::linear_quadratic, WindModel::constant},
    {Motion::force, DragModel::equation, WindModel::off, AirModel::isa},
    {Motion::force, DragModel::equation, WindModel::constant, AirModel::isa},
    {Motion::closed_form, DragModel::off},
};
inline constexpr int kStaticRungCount = static_cast<int>(std::size(kStaticRungs));
inline constexpr std::int8_t kNoStaticRung = -1;

/// Index in kStaticRungs of a rung as granted; kNoStaticRung where none fits.
[[nodiscard]] constexpr std::int8_t static_rung_of(const Fidelity& f, const Features& features) {
  if (f.gravity != GravityModel::constant || f.earth != EarthModel::flat || features != Features{})
    return kNoStaticRung;
  const bool steps = f.integrator == Integrator::semi_implicit_euler && !f.planar && f.rotation == RotationModel::none;
  for (int i = 0; i < kStaticRungCount; ++i) {
    const StaticRungSpec& rung = kStaticRungs[i];
    if (f.drag != rung.drag || (f.motion == Motion::closed_form) != (rung.motion == Motion::closed_form)) continue;
    if (rung.motion == Motion::closed_form) return static_cast<std::int8_t>(i);
    if (steps && f.wind == rung.wind && (rung.drag != DragModel::equation || f.air == rung.air))
      return static_cast<std::int8_t>(i);
  }
  return kNoStaticRung;
}

/// Calls f with the index of a static rung as an integral constant; nothing happens where there is none.
template <class F>
PHYSIM_INLINE void with_static_rung(int rung, const F& f) {
  const auto try_each = [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA {
    ((rung == I ? f(std::integral_constant<int, I>{}) : void()), ...);
  };
  try_each(std::make_integer_sequence<int, kStaticRungCount>());
}

}  // namespace physim
