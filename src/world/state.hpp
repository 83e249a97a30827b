// WorldState: everything of a world that changes as it runs. A snapshot is a copy of it.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/turning.hpp"
#include "physim/world.hpp"
#include "world/slots.hpp"

namespace physim {

/// The simulation's clock. Time is counted in steps, so that it gathers no rounding errors while dt stays the same.
struct Clock {
  double dt = 0;                // of the last step [s]
  double run_start = 0;         // time at which steps of this dt began [s]
  std::uint64_t run_steps = 0;  // since then
  std::uint64_t steps = 0;      // ever
  std::uint64_t epoch = 0;      // step that rows count from
  double left_over = 0;         // of advance() [s]
  double time_scale = 1;
  bool paused = false;

  [[nodiscard]] double time() const { return run_start + static_cast<double>(run_steps) * dt; }
  /// The number of the coming step, as rows count.
  [[nodiscard]] double now() const { return static_cast<double>(steps - epoch); }
};

/// Projectiles of one pool, oldest first where it replaces them.
struct Pool {
  std::uint32_t count = 0;
  std::uint32_t oldest = 0;
  std::uint32_t newest = 0;
};
struct PoolLink {
  std::uint32_t older = 0;
  std::uint32_t newer = 0;
};

/// Something that is due for a projectile at a time.
struct Due {
  double time;
  ProjectileId id;
};

/// The order of a heap whose first one is due next.
inline bool is_later(const Due& a, const Due& b) {
  return a.time != b.time ? a.time > b.time : a.id.index > b.id.index;
}

/// A force generator at work.
struct Generator {
  std::uint32_t generation = 1;
  bool active = false;
  bool begun = false;                // its targets are forced rows
  ForceDef def;                      // target.ids in order of slots, each once
  std::vector<ProjectileId> except;  // taken out of its kind or layers; the same
  double start = 0;                  // [s]
  double end = 0;                    // [s]
};

class WorldState {
 public:
  std::uint64_t owner = 0;   // number of the world
  std::uint64_t moment = 0;  // number of the snapshot
  Clock clock;
  std::vector<Slot> slots{1};      // slot 0 is nobody's
  std::vector<double> birth{0.0};  // time of launch, by slot [s]
  std::vector<Rest> rest{1};
  std::uint32_t first_free = 0;
  std::uint32_t last_free = 0;
  std::uint32_t alive = 0;
  std::vector<Rows> rows;  // by cohort
  std::vector<Pool> pools;
  std::vector<PoolLink> links;                   // by slot; empty while no pool replaces
  std::unordered_map<std::uint32_t, Own> own;    // by slot
  std::unordered_map<std::uint32_t, Tags> tags;  // by slot
  std::map<std::uint32_t, Turning> turning;      // by slot, in order
  std::vector<Due> pending;                      // launches; a heap, the next one first
  std::vector<Due> old_age;                      // ends by DespawnRules::older; the same
  std::vector<Generator> generators{1};          // 0 is none
  std::vector<std::uint32_t> free_generators;
  std::vector<std::uint32_t> force_order;                      // active generators, in the order they were added
  std::vector<std::uint32_t> group_forces;                     // those begun that have a kind or layers
  std::unordered_map<std::uint32_t, std::uint32_t> forces_on;  // by slot: begun generators that name it
  std::vector<Event> events;
  WorldCounters counters;
  Vec3d observer;
  DetailRule detail;
  std::vector<Environment> environments;

  /// Time since launch of a row that has a clock [s].
  [[nodiscard]] double row_clock(const Slot& slot) const {
    return rows[slot.cohort].visit([&]<class S>(const RowColumns<S>& c) {
      const S steps = static_cast<S>(clock.now()) - c.born[slot.row];
      return static_cast<double>(c.offset[slot.row] + steps * static_cast<S>(clock.dt));
    });
  }
  /// The slot of a projectile that is alive; null otherwise.
  [[nodiscard]] const Slot* find(ProjectileId id) const {
    if (id.index >= slots.size()) return nullptr;
    const Slot& slot = slots[id.index];
    return slot.generation == id.generation && slot.is(kAlive) ? &slot : nullptr;
  }
};

}  // namespace physim
