// The one spelling of every name that people type or read: enumerators as text and back.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "physim/emitter.hpp"
#include "physim/environment.hpp"
#include "physim/flight.hpp"
#include "physim/scene.hpp"
#include "physim/solve.hpp"
#include "physim/world.hpp"

namespace physim {

/// All names of an enumeration, in the order of its values.
template <class Enum>
[[nodiscard]] std::span<const std::string_view> names_of();

/// The name of a value: name(DragTable::g7) == "g7"; "?" of a number that is no value.
template <class Enum>
[[nodiscard]] std::string_view name(Enum value) {
  const auto names = names_of<Enum>();
  const auto at = static_cast<std::size_t>(value);
  return at < names.size() ? names[at] : std::string_view("?");
}

/// The value of a name, if it is one.
template <class Enum>
[[nodiscard]] std::optional<Enum> value_of(std::string_view text) {
  const auto names = names_of<Enum>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return static_cast<Enum>(i);
  return std::nullopt;
}

#define PHYSIM_NAMED_ENUM(Enum) \
  template <>                   \
  std::span<const std::string_view> names_of<Enum>();
PHYSIM_NAMED_ENUM(AttitudeFrame)
PHYSIM_NAMED_ENUM(RateFrame)
PHYSIM_NAMED_ENUM(RateNorm)
PHYSIM_NAMED_ENUM(DampingFrame)
PHYSIM_NAMED_ENUM(DragTable)
PHYSIM_NAMED_ENUM(SpinMeasure)
PHYSIM_NAMED_ENUM(WindAxis)
PHYSIM_NAMED_ENUM(WindInterpolation)
PHYSIM_NAMED_ENUM(EventKind)
PHYSIM_NAMED_ENUM(Crossing)
PHYSIM_NAMED_ENUM(Outcome)
PHYSIM_NAMED_ENUM(Arc)
PHYSIM_NAMED_ENUM(GroundMode)
PHYSIM_NAMED_ENUM(MotionCurve)
PHYSIM_NAMED_ENUM(OnHit)
PHYSIM_NAMED_ENUM(Smoothing)
PHYSIM_NAMED_ENUM(WhenFull)
PHYSIM_NAMED_ENUM(LifeStatus)
PHYSIM_NAMED_ENUM(Reason)
PHYSIM_NAMED_ENUM(ImpactKind)
PHYSIM_NAMED_ENUM(EmitShape)
PHYSIM_NAMED_ENUM(EmitAlong)
PHYSIM_NAMED_ENUM(ArcMode)
PHYSIM_NAMED_ENUM(SubEvent)
PHYSIM_NAMED_ENUM(SubAxis)
PHYSIM_NAMED_ENUM(StopAction)
PHYSIM_NAMED_ENUM(JointKind)
PHYSIM_NAMED_ENUM(JointEventKind)
#undef PHYSIM_NAMED_ENUM

/// All rungs of an effect (an enumeration that Fidelity has a field of), cheap to true.
template <class Enum>
[[nodiscard]] std::span<const RungInfo> rungs_of();

#define PHYSIM_RUNG_ENUM(Enum)                        \
  template <>                                         \
  std::span<const std::string_view> names_of<Enum>(); \
  template <>                                         \
  std::span<const RungInfo> rungs_of<Enum>();
PHYSIM_RUNG_ENUM(Motion)
PHYSIM_RUNG_ENUM(Integrator)
PHYSIM_RUNG_ENUM(GravityModel)
PHYSIM_RUNG_ENUM(DragModel)
PHYSIM_RUNG_ENUM(AirModel)
PHYSIM_RUNG_ENUM(WindModel)
PHYSIM_RUNG_ENUM(EarthModel)
PHYSIM_RUNG_ENUM(RotationModel)
PHYSIM_RUNG_ENUM(BodyForm)
PHYSIM_RUNG_ENUM(Precision)
PHYSIM_RUNG_ENUM(Interpolation)
#undef PHYSIM_RUNG_ENUM

/// The rungs of one effect, cheap to true.
struct EffectRungs {
  std::string_view effect{};          ///< field of Fidelity [-]
  std::span<const RungInfo> rungs{};  ///< [-]
};
/// The whole ladder of fidelity, in the order of Fidelity's fields.
[[nodiscard]] std::span<const EffectRungs> all_effects();

/// The preset of a name ("small_arms"), if it is one.
[[nodiscard]] std::optional<Fidelity> fidelity_preset(std::string_view text);
/// Names of all presets, from cheap to true.
[[nodiscard]] std::span<const std::string_view> fidelity_presets();

}  // namespace physim
