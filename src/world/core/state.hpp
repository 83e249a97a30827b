// WorldState: everything of a world that changes as it runs. A snapshot is a copy of it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "physim/scene.hpp"
#include "physim/world.hpp"
#include "world/core/clock.hpp"
#include "world/core/emitters.hpp"
#include "world/core/event_list.hpp"
#include "world/core/generators.hpp"
#include "world/core/joints.hpp"
#include "world/core/newcomers.hpp"
#include "world/core/pools.hpp"
#include "world/core/schedule.hpp"
#include "world/core/slots.hpp"

namespace physim {

class WorldState {
 public:
  std::uint64_t owner = 0;   // number of the world
  std::uint64_t moment = 0;  // number of the snapshot
  Clock clock;
  SlotTable slots;
  std::vector<Rows> rows;  // by cohort
  Pools pools;
  Extras extras;
  Schedule launches;  // that wait
  Schedule old_age;   // ends by DespawnRules::older
  Generators generators;
  Emitters emitters;
  Joints joints;
  EventList events;
  std::size_t events_of_step = 0;  // the first of them
  WorldCounters counters;
  std::shared_ptr<Scene> scene;  // null: none; a change first makes a private copy
  Newcomers newcomers;           // of the scene
  Vec3d observer;
  DetailRule detail;
  std::vector<Environment> environments;

  /// The cohort that a projectile lies in.
  [[nodiscard]] const Rows& rows_of(const Slot& slot) const {
    PHYSIM_ASSERT(slot.cohort < rows.size() && slot.row < rows[slot.cohort].size());
    PHYSIM_ASSERT(rows[slot.cohort].slot(slot.row) == slots.index_of(slot));
    return rows[slot.cohort];
  }
  [[nodiscard]] Rows& rows_of(const Slot& slot) { return const_cast<Rows&>(std::as_const(*this).rows_of(slot)); }
  [[nodiscard]] BodyState state_of(const Slot& slot) const {
    const Rows& columns = rows_of(slot);
    return {columns.position(slot.row), columns.velocity(slot.row)};
  }
  /// Time since launch of a row that has a clock [s].
  [[nodiscard]] double row_clock(const Slot& slot) const {
    return rows[slot.cohort].visit([&]<class S>(const RowColumns<S>& c) {
      const S steps = static_cast<S>(clock.now()) - c.born[slot.row];
      return static_cast<double>(c.offset[slot.row] + steps * static_cast<S>(clock.dt));
    });
  }
};

}  // namespace physim
