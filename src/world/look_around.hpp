// How far rows are from the things of a scene: who may have come near is looked at once a step.
#pragma once

#include "world/settle.hpp"

namespace physim {

/// So far something may fly from a place before it can touch anything, in a scene in which nothing moves [m].
template <class S>
[[nodiscard]] S clear_way(const SettleContext& context, const Vec3d& x, const Vec3d& velocity,
                          const CollisionDef& collision) {
  PHYSIM_ASSERT(context.scene != nullptr && context.dt > 0);
  constexpr double kSteps = 64;  // looking farther costs more than looking again
  const double reach = collision.radius + kSteps * context.dt * (length(velocity) + 10 * context.dt);
  const double clear = context.scene->clearance(x, reach, {.layers = collision.layers});
  return static_cast<S>(clear - collision.radius - 4 * spacing_at<S>(x));
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
