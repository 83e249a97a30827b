// How far rows are from the things of a scene: who may have come near is looked at once a step.
#pragma once

#include "collide/scene_contact.hpp"
#include "world/settle.hpp"

namespace physim {

/// So far something may fly from where it is before it can touch anything; 0 where things move, or there is none. Where
/// that is less than the way of a step, it is that way, below 0: near something, as look_around() knows it [m].
template <class S>
[[nodiscard]] S clear_way(const SettleContext& context, const State<double>& s, const CollisionDef& collision) {
  PHYSIM_ASSERT(context.dt > 0);
  if (!context.scene || context.scene->has_motion() || context.scene->engine() != nullptr) return S(0);
  constexpr double kSteps = 64;  // looking farther costs more than looking again
  const double reach = collision.radius + kSteps * context.dt * (length(s.v) + 10 * context.dt);
  const double clear = context.scene->clearance(s.x, reach, {.layers = collision.layers});
  // What is flown of it is summed up in numbers of the row's own.
  constexpr double kSum = 2 * kSteps * static_cast<double>(std::numeric_limits<S>::epsilon());
  const double way = context.dt * length(s.v), left = (clear - collision.radius) * (1 - kSum) - 4 * spacing_at<S>(s.x);
  return static_cast<S>(left > way ? left : -way);
}

/// A row that moved on and may have come near a thing of an engine, in the chunk that it belongs to.
struct NearRow {
  Chunk* chunk = nullptr;
  std::uint32_t row = 0;
};
/// Looks at such rows; the engine is asked about all of those of the same layers in one call.
void look_around(const SettleContext& context, const std::vector<NearRow>& rows);

/// Looks at a row that moved on and may have come near a thing of the scene: where it did, it is put back and settled.
void look_around(const SettleContext& context, Chunk& chunk, std::uint32_t row);

}  // namespace physim
