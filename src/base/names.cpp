// Names of enumerators: exactly as they are spelled in the headers, in the order of their values. Those of rungs stand
// in their table, model/ladder.hpp.
#include "physim/names.hpp"

#include <array>
#include <iterator>

#include "base/event_table.hpp"

namespace physim {

// The count of names is checked against the last enumerator, so that a new one cannot be forgotten at the end.
#define PHYSIM_NAMES(Enum, last, ...)                                                                 \
  template <>                                                                                         \
  std::span<const std::string_view> names_of<Enum>() {                                                \
    static constexpr std::string_view names[] = {__VA_ARGS__};                                        \
    static_assert(std::size(names) == static_cast<std::size_t>(Enum::last) + 1, "a name is missing"); \
    return names;                                                                                     \
  }

PHYSIM_NAMES(AttitudeFrame, world, "bore", "world")
PHYSIM_NAMES(RateFrame, inertial, "world", "inertial")
PHYSIM_NAMES(RateNorm, twice_speed, "speed", "twice_speed")
PHYSIM_NAMES(DampingFrame, inertial, "air", "inertial")
PHYSIM_NAMES(DragTable, custom, "constant", "g1", "g2", "g5", "g6", "g7", "g8", "gi", "gs", "ra4", "sphere", "custom")
PHYSIM_NAMES(SpinMeasure, parameter, "rate", "parameter")
PHYSIM_NAMES(WindAxis, range, "height", "range")
PHYSIM_NAMES(WindInterpolation, step, "linear", "step")
PHYSIM_NAMES(Crossing, falling, "any", "rising", "falling")
PHYSIM_NAMES(Arc, both, "low", "high", "both")
PHYSIM_NAMES(Outcome, hit, "landed", "reached_range", "event", "time_limit", "step_limit", "left_domain", "non_finite",
             "stalled", "refused", "hit")
PHYSIM_NAMES(GroundMode, bounce, "none", "land", "stick", "bounce")
PHYSIM_NAMES(MotionCurve, smooth, "straight", "smooth")
PHYSIM_NAMES(OnHit, ask, "pass", "stop", "stick", "bounce", "impact", "ask")
PHYSIM_NAMES(Combine, maximum, "product", "mean", "minimum", "maximum")
PHYSIM_NAMES(Smoothing, extrapolate, "none", "interpolate", "extrapolate")
PHYSIM_NAMES(WhenFull, replace_oldest, "refuse", "replace_oldest")
PHYSIM_NAMES(LifeStatus, retired, "unknown", "pending", "in_flight", "landed", "expired", "retired")
PHYSIM_NAMES(Reason, inside, "none", "below", "farther", "older", "slower", "outside_box", "despawned", "replaced",
             "non_finite", "left_domain", "stalled", "inside")
PHYSIM_NAMES(ImpactKind, stopped, "none", "bounced", "ricocheted", "penetrated", "stopped")
PHYSIM_NAMES(EmitShape, terrain, "point", "cone", "sphere", "hemisphere", "box", "circle", "ring", "line", "mesh",
             "mesh_edges", "mesh_vertices", "terrain")
PHYSIM_NAMES(EmitAlong, axis, "normal", "smooth", "axis")
PHYSIM_NAMES(ArcMode, spread, "random", "loop", "ping_pong", "spread")
PHYSIM_NAMES(SubEvent, trigger, "birth", "hit", "bounce", "ricochet", "exit", "landing", "apex", "death", "age",
             "trigger")
PHYSIM_NAMES(SubAxis, normal, "emitter", "velocity", "normal")
PHYSIM_NAMES(StopAction, remove, "none", "remove")
PHYSIM_NAMES(JointKind, spring, "rod", "cable", "spring")
PHYSIM_NAMES(JointEventKind, ended, "came_taut", "ended")

#undef PHYSIM_NAMES

template <>
std::span<const std::string_view> names_of<EventKind>() {
  static constexpr auto names = [] {
    std::array<std::string_view, kEventKinds> list;
    for (std::size_t i = 0; i < kEventKinds; ++i) list[i] = kEventTable[i].name;
    return list;
  }();
  return names;
}

}  // namespace physim
