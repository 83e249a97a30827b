// How far rows are from the things of a scene: rows that may have come near are looked at once a step.
#pragma once

#include "collide/scene_by_motion.hpp"
#include "collide/scene_contact.hpp"
#include "world/step/rows_ahead.hpp"
#include "world/step/settle.hpp"

namespace physim {

/// Whether resting things can be distinguished from others, so that rows keep what they find out about them.
[[nodiscard]] inline bool knows_rest(const SettleContext& context) {
  return context.scene && !context.scene->engine() && !SceneByMotion(*context.scene).has_boundless_movers();
}

/// How far something may fly from its place before it can touch anything at rest; 0 if unknown. If that is
/// less than the way of a step, it is that way, below 0: near something, as look_around() knows it [m].
template <class S>
[[nodiscard]] S clear_way(const SettleContext& context, const State<double>& s, const CollisionDef& collision) {
  PHYSIM_ASSERT(context.dt > 0);
  if (!knows_rest(context)) return S(0);
  constexpr double kSteps = 64;  // looking farther costs more than looking again
  const double reach = collision.radius + kSteps * context.dt * (length(s.v) + 10 * context.dt);
  const double clear = SceneByMotion(*context.scene).clearance(s.x, reach, {.layers = collision.layers});
  // What is flown of it is summed up in numbers of the row's own.
  constexpr double kSum = 2 * kSteps * static_cast<double>(std::numeric_limits<S>::epsilon());
  const double way = context.dt * length(s.v), left = (clear - collision.radius) * (1 - kSum) - 2 * touch_at<S>(s.x);
  return static_cast<S>(left > way ? left : -way);
}

inline constexpr double kNearSteps = 64;  // a row that was near something looks again after this number of steps

/// Whether it is time to look how far a row may fly, by what its column of clear ways says after a step of a length
/// [m]: a row that comes from afar always does. It takes as long as some steps near a thing.
template <class S>
[[nodiscard]] bool is_look_due(S clear, double gone) {
  return static_cast<double>(clear) > -0.5 * gone || static_cast<double>(clear) < -kNearSteps * gone;
}
/// What the column of clear ways keeps of how far a row flew since it looked, below 0: 0 for a new row, which mostly is
/// near something; all of these do not look in one step, nor at once.
template <class S>
[[nodiscard]] S waited(S clear, std::uint32_t row, double gone) {
  constexpr std::uint32_t kSpread = 16;
  const bool is_new = static_cast<double>(clear) > -1.5 * gone;
  return is_new ? static_cast<S>(-gone * (kNearSteps - 1 - row % kSpread)) : clear;
}

/// About the way of something at a steady acceleration. `beside`: how far the path of one step may be from
/// its chord [m].
template <class S>
[[nodiscard]] TubeAhead way_ahead(const SettleContext& context, const State<double>& s, const Vec3d& acceleration,
                                  double beside, const CollisionDef& collision) {
  PHYSIM_ASSERT(knows_rest(context) && context.dt > 0);
  if (!(beside < kInfinity)) return {};    // the next step leaves what numbers can hold
  constexpr double kSteps = 9;             // one of them is at hand, mostly
  constexpr double kSlack = 1.25;          // of the sag: accelerations change
  constexpr double kBeside = 2;            // and so does what a step needs
  constexpr double kDrift = 1e-4;          // of the length
  const double turns = 0.5 * length(s.v);  // it may lose this much of its velocity
  const double time = std::min(kSteps * context.dt, turns / std::max(length(acceleration), 1e-9));
  const Vec3d along = s.v * time + acceleration * (0.5 * time * time);
  const double far = length(along);
  if (!(far > 0 && far < collide::kFarthest)) return {};
  const Vec3d across = acceleration - along * (dot(acceleration, along) / (far * far));
  const double room = kSlack / 8 * time * time * length(across) + kBeside * beside + kDrift * far;
  // Places and sums of the row's own numbers are rounded.
  const double places = spacing_at<S>(s.x) + spacing_at<S>(s.x + along);
  const double lost = 8 * places + 32 * static_cast<double>(std::numeric_limits<S>::epsilon()) * far + 1e-9;
  return {{{s.x, s.x + along, collision.radius + room + lost}, collision.layers}, room};
}
/// As far as its way is clear; none where it is near something, or comes about.
template <class S>
[[nodiscard]] ClearTube<S> tube_along(const TubeAhead& ahead) {
  const SceneSegment& way = ahead.query.segment;
  const Vec3<S> from = vec_cast<S>(way.from);
  const Vec3<S> clear = vec_cast<S>((way.to - way.from) * (ahead.query.part * (1 - 1e-6)));
  const S per_square = S(1) / dot(clear, clear);
  if (!(per_square > 0 && per_square < std::numeric_limits<S>::max())) return {};
  return {from, clear, per_square, static_cast<S>(ahead.room)};
}

/// A row that moved on and may have come near a thing of an engine, in the chunk that it belongs to.
struct NearRow {
  Chunk* chunk = nullptr;
  std::uint32_t row = 0;
};
/// Looks at such rows; the engine is asked about all of those of the same layers in one call.
void look_around(const SettleContext& context, const std::vector<NearRow>& rows);

/// Looks at rows of a chunk that moved on and may have come near a thing of the scene: where one did, it is put back
/// and settled. Many of them look ahead together, before and after that.
class LookAround {
 public:
  LookAround(const SettleContext& context, Chunk& chunk) : context_(context), chunk_(chunk) {}
  LookAround(const LookAround&) = delete;
  LookAround& operator=(const LookAround&) = delete;

  /// Rows come in order; what is said of one may come later.
  void add(std::uint32_t row);
  /// Looks for all that were added.
  void finish();

 private:
  void look_at_waiting();

  const SettleContext& context_;
  Chunk& chunk_;
  RowsAhead waiting_;
  RowsAhead settled_;
};

/// Finds the tubes of rows that were settled and wait for them.
void put_tubes(const SettleContext& context, const Chunk& chunk, RowsAhead& waiting);

}  // namespace physim
