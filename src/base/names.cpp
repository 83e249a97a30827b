// Names of enumerators: exactly as they are spelled in the headers, in the order of their values. Those of rungs stand
// in their table, model/ladder.hpp.
#include "physim/names.hpp"

#include <array>
#include <iterator>

#include "base/emit_shape_table.hpp"
#include "base/enumerators.hpp"
#include "base/event_table.hpp"
#include "base/joint_table.hpp"

namespace physim {

#define PHYSIM_NAMES(Enum, ...)                                                 \
  template <>                                                                   \
  std::span<const std::string_view> names_of<Enum>() {                          \
    static constexpr std::string_view names[] = {__VA_ARGS__};                  \
    static_assert(std::size(names) == kEnumerators<Enum>, "a name is missing"); \
    return names;                                                               \
  }

PHYSIM_NAMES(AttitudeFrame, "bore", "world")
PHYSIM_NAMES(RateFrame, "world", "inertial")
PHYSIM_NAMES(RateNorm, "speed", "twice_speed")
PHYSIM_NAMES(DampingFrame, "air", "inertial")
PHYSIM_NAMES(DragTable, "constant", "g1", "g2", "g5", "g6", "g7", "g8", "gi", "gs", "ra4", "sphere", "custom")
PHYSIM_NAMES(SpinMeasure, "rate", "parameter")
PHYSIM_NAMES(WindAxis, "height", "range")
PHYSIM_NAMES(WindInterpolation, "linear", "step")
PHYSIM_NAMES(Crossing, "any", "rising", "falling")
PHYSIM_NAMES(Arc, "low", "high", "both")
PHYSIM_NAMES(Outcome, "landed", "reached_range", "event", "time_limit", "step_limit", "left_domain", "non_finite",
             "stalled", "refused", "hit")
PHYSIM_NAMES(GroundMode, "none", "land", "stick", "bounce")
PHYSIM_NAMES(MotionCurve, "straight", "smooth")
PHYSIM_NAMES(OnHit, "pass", "stop", "stick", "bounce", "impact", "ask")
PHYSIM_NAMES(Combine, "product", "mean", "minimum", "maximum")
PHYSIM_NAMES(Smoothing, "none", "interpolate", "extrapolate")
PHYSIM_NAMES(WhenFull, "refuse", "replace_oldest")
PHYSIM_NAMES(LifeStatus, "unknown", "pending", "in_flight", "landed", "expired", "retired")
PHYSIM_NAMES(Reason, "none", "below", "farther", "older", "slower", "outside_box", "despawned", "replaced",
             "non_finite", "left_domain", "stalled", "inside")
PHYSIM_NAMES(ImpactKind, "none", "bounced", "ricocheted", "penetrated", "stopped")
PHYSIM_NAMES(EmitAlong, "normal", "smooth", "axis")
PHYSIM_NAMES(ArcMode, "random", "loop", "ping_pong", "spread")
PHYSIM_NAMES(SubEvent, "birth", "hit", "bounce", "ricochet", "exit", "landing", "apex", "death", "age", "trigger")
PHYSIM_NAMES(SubAxis, "emitter", "velocity", "normal")
PHYSIM_NAMES(StopAction, "none", "remove")
PHYSIM_NAMES(JointEventKind, "came_taut", "ended", "broke")

#undef PHYSIM_NAMES

// Names that stand in tables of rows.
#define PHYSIM_NAMES_IN(Enum, table)                   \
  template <>                                          \
  std::span<const std::string_view> names_of<Enum>() { \
    return kNamesIn<table>;                            \
  }

PHYSIM_NAMES_IN(EmitShape, kEmitShapeTable)
PHYSIM_NAMES_IN(EventKind, kEventTable)
PHYSIM_NAMES_IN(JointKind, kJointTable)

#undef PHYSIM_NAMES_IN

}  // namespace physim
