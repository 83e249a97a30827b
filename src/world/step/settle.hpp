// Settling: the closer look at rows to which something may have happened inside a step. The kernels leave such rows
// where they were; here each is stepped on its own, with the same numbers, its events are located and acted on.
#pragma once

#include <optional>
#include <vector>

#include "flight/step_parts.hpp"
#include "world/core/state.hpp"
#include "world/step/driven_rows.hpp"
#include "world/step/hit_asking.hpp"
#include "world/step/restless.hpp"
#include "world/step/world_job.hpp"

namespace physim {

class RowsAhead;

/// What settling decided that concerns more than the row itself; done after the step, in order of slots.
struct Change {
  enum class Kind : std::uint8_t { remove, spin, stick, sleep };
  std::uint32_t slot = 0;
  Kind kind = Kind::remove;
  LifeStatus status = LifeStatus::unknown;
  Reason reason = Reason::none;
  Vec3d spin{};  // [rad/s]
};

/// Where a row of a projectile that meets others was, at a moment of a step that was settled, and that is always:
/// where it touched something, left, or passed a stop.
struct Trace {
  std::uint32_t slot = 0;
  double passed = 0;  // into the step [s]
  State<double> state{};
  Vec3d spin{};         // [rad/s]
  Turn<double> turn{};  // of rungs that turn
  Vec3d ahead{};        // by how much `state` is faster than the velocity of its row [m/s]
};

/// How a row continues from a meeting with another one.
struct Parting {
  enum class Then : std::uint8_t { flies_on, lies, stops, sticks };
  double passed = 0;            // into the step [s]
  const Trace* from = nullptr;  // the last moment before, of a step that has traces; null: it flew from its start
  State<double> state{};        // after it
  std::optional<Vec3d> spin{};  // that it has then; none: as it was [rad/s]
  Then then = Then::flies_on;
  Vec3d pull{};  // of one that lies on others: its acceleration until the end of the step [m/s^2]
};

/// Rows of one cohort that one thread steps.
struct Chunk {
  std::uint16_t cohort = 0;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  bool looks = false;      // rows that came near are looked at where they have moved on to
  bool attention = false;  // some rows were left where they were
  StepList<Event> events;
  StepList<PlainEvent> strikes;  // of rows that only struck the ground; where emitters watch, these are events
  StepList<Change> changes;
  StepList<Trace> traces;   // of those that meet others, each in order of time
  std::uint64_t flown = 0;  // steps of single rows: one that bounces takes several in a step of the world
  PushMemory pushes;
  std::vector<OpenHit> open;  // of rows that are left as they were until it is known what their hits do
};

/// Memory that steps use again and again.
struct StepScratch {
  std::vector<std::uint32_t> attention;   // a bit for each row
  std::vector<std::uint32_t> near;        // a bit for each row
  std::vector<std::size_t> words_before;  // of each cohort's rows in it
  std::vector<Chunk> chunks;
  std::size_t chunk_count = 0;
  StepList<const Change*> changes;
  StepList<std::uint64_t> change_order, change_spare;  // see ChangeKey
  StepList<EventKey> merge;                            // of events
};

/// What settling reads beside the row.
struct SettleContext {
  const WorldDef* def;
  const Registry* registry;
  WorldState* state;  // only the chunk's own rows and slots are written
  double dt;
  double now;                          // number of the step, as rows count
  double time;                         // at the start of the step [s]
  const Scene* scene;                  // null: none
  const void* taken = nullptr;         // forced rows: the TakenStep of their number type; null: no generator pushes
  bool pairs = false;                  // some projectiles meet others
  HitAsking* asking = nullptr;         // knows what hits do that ask
  const Restless* restless = nullptr;  // null: nothing is
};

/// A step that a forced row took together with others. What only follows from an event in it (the way on after a
/// bounce, or along a surface) feels the mean of the generators over the rest of the step; the effect of an emitter on
/// its particles is taken then.
template <class S>
struct TakenStep {
  bool is_stepped = false;  // else `step` is not there: the row steps by itself, and the rest holds
  Step<S> step;             // start, end, and the slopes but that at the end
  Pushed<S> push[2];        // by generators at its start and end
  bool own_force;           // some row of the cohort has a ProjectileDef::force
  bool driven = false;      // `push` has what an emitter does to a particle, too
  bool pushed = true;       // there are generators
};

/// The rows of a cohort as a kernel wants them; which of them, and where they are marked, is left open.
template <class S>
[[nodiscard]] WorldJob<S> rows_job(const SettleContext& context, std::uint16_t cohort);

/// Where the ground bounces, longer steps are flown in parts from their start: each row is looked at.
inline constexpr double kLongestBouncingStep = 0.1;  // [s]
[[nodiscard]] inline bool flies_in_parts(const WorldDef& def, double dt) {
  return def.ground.mode == GroundMode::bounce && dt > kLongestBouncingStep;
}

/// The length of the steps that velocities of rows are of, see March::restagger() [s].
[[nodiscard]] inline double plain_step(const WorldDef& def, double dt) {
  return StepParts::first(dt, flies_in_parts(def, dt));
}

/// Steps one row that was left where it was, and writes where it is after the step, unless a hit of it is left open.
/// The other calls below ask about hits at once.
void settle_row(const SettleContext& context, Chunk& chunk, std::uint32_t row);
/// As above, but a look ahead that it wants waits for others.
void settle_row(const SettleContext& context, Chunk& chunk, std::uint32_t row, RowsAhead& waiting);

/// Steps a row that is as it was when the step began from a meeting inside of it, and writes where it is after the
/// step.
void settle_after(const SettleContext& context, Chunk& chunk, std::uint32_t row, const Parting& parting);

/// Flies a row that was emitted `born` into the step, or that is as it was when it began, to the end of the step, and
/// writes where it is then, as the next position. Forced rows feel in it what `taken` gives.
void settle_alone(const SettleContext& context, Chunk& chunk, std::uint32_t row, std::optional<double> born);

/// Where a row that is as it was when the step began, or as it was emitted `born` into it, is at a time inside of the
/// step, and what happens to it before; the row stays as it was. None: it is gone by then. Forced rows feel what
/// `taken` gives.
[[nodiscard]] std::optional<State<double>> state_inside(const SettleContext& context, Chunk& chunk, std::uint32_t row,
                                                        std::optional<double> born, double until);

/// How such a row spins at a meeting, of which time and `from` are read [rad/s].
[[nodiscard]] Vec3d spin_at(const SettleContext& context, Chunk& chunk, std::uint32_t row, const Parting& parting);

}  // namespace physim
