#include "world/look_around.hpp"

#include <algorithm>

namespace physim {
namespace {

/// Where a row is after its step, if that was not settled: it lies on a path from one end to the other.
template <class S>
[[nodiscard]] bool meets_nothing(const SettleContext& context, const RowColumns<S>& c, std::uint32_t row,
                                 const CollisionDef& collision) {
  const Vec3d from = Rows::at(c.position, row), to = Rows::at(c.previous, row);
  const Vec3d mean = (to - from) * (1 / context.dt);
  // Twice as far as a cubic with these velocities at its ends is from its chord.
  const double bend = length(Rows::at(c.started, row) - mean) + length(Rows::at(c.velocity, row) - mean);
  const double beside = 8.0 / 27 * context.dt * bend + 1e-9;
  const SceneFilter filter{.layers = collision.layers};
  if (context.scene->any_hit({from, to, collision.radius + beside, context.time, context.dt}, filter)) return false;
  // A look farther around is worth it where the last one told something; who was near then mostly still is.
  constexpr std::uint32_t kSeldom = 8;
  const bool was_clear = static_cast<double>(c.clear[row]) > -0.5 * length(mean) * context.dt;
  const bool looks = was_clear || (row + static_cast<std::uint32_t>(context.state->clock.steps)) % kSeldom == 0;
  c.clear[row] = looks ? clear_way<S>(context, {to, mean}, collision) : S(0);
  return true;
}

template <class S>
void look_around_in(const SettleContext& context, Chunk& chunk, std::uint32_t row) {
  const Rows& rows = context.state->rows[chunk.cohort];
  const RowColumns<S>& c = rows.columns<S>();
  const Slot& slot = context.state->slots[rows.slot(row)];
  if (context.scene && meets_nothing(context, c, row, context.registry->kind(slot.kind).body.collision)) return;
  for (int axis = 0; axis < 3; ++axis) c.velocity[axis][row] = c.started[axis][row];
  settle_row(context, chunk, row);
}

}  // namespace

void look_around(const SettleContext& context, Chunk& chunk, std::uint32_t row) {
  const RowLayout& layout = context.state->rows[chunk.cohort].layout();
  return layout.float32 ? look_around_in<float>(context, chunk, row) : look_around_in<double>(context, chunk, row);
}

}  // namespace physim
