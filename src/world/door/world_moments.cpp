// Moments of a world: snapshots and the hash of its state.
#include <algorithm>

#include "base/ieee_mode.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {

// ------------------------------------------------------------------------------------------- snapshots
double Snapshot::time() const {
  const IeeeMode mode;
  return state_ ? state_->clock.time() : 0;
}

Snapshot World::snapshot() const {
  const WorldImpl& w = impl();
  if (w.is_closed()) return {};
  const std::lock_guard lock(w.taking);
  // What is written is no part of the world: its recording, and which snapshots there are.
  const Recorded<Call::snapshot> call(const_cast<WorldImpl&>(w), w.next_moment());
  auto copy = [&w] {
    const std::lock_guard reading(w.showing);
    return std::make_shared<WorldState>(w.state);
  }();
  copy->environments = w.registry.environments();
  copy->moment = ++w.moments;
  w.living.add(copy->moment, copy);
  return Snapshot(std::move(copy));
}

Status World::restore(const Snapshot& snapshot) {
  WorldImpl& w = impl();
  if (!snapshot) return Error{"the snapshot is empty", "snapshot", "World::snapshot() makes one"};
  const WorldState& then = *snapshot.state_;
  if (then.owner != w.state.owner) return Error{"the snapshot is of another world", "snapshot", ""};
  const Recorded<Call::restore> call(w, w.recorded_moment(then.moment));
  if (call.is_refused()) return call.refusal();
  w.state.events.leave(w.given_events);  // a caller may be reading them
  w.state = then;
  w.forced_scratch.driven.forget();
  w.is_stirred = false;
  w.registry.meet_scene(w.state.scene != nullptr);
  w.registry.restore_environments(then.environments);
  w.registry.kinds.recount(w.moments, [&w](const auto& join) {
    w.state.slots.each_alive([&](std::uint32_t slot) { join(w.state.slots[slot].kind); });
  });
  return {};
}

std::uint64_t WorldImpl::next_moment() const { return recorder ? moments + 1 - recorder->first_moment : 0; }

std::uint64_t WorldImpl::recorded_moment(std::uint64_t moment) {
  if (!recorder) return 0;
  if (moment <= recorder->first_moment)
    recorder->fail({"a snapshot was restored that was taken before the recording began", "recording",
                    "take snapshots after record()"});
  return moment - recorder->first_moment;
}

// ------------------------------------------------------------------------------------------- hash
namespace {

template <class S>
void add_vector(Hash& h, S* const (&column)[3], std::uint32_t row, S fourth) {
  h.add(column[0][row], column[1][row]);
  h.add(column[2][row], fourth);
}

/// What a row holds that decides its future and does not follow from its kind and rung; `first` is the first piece of
/// its motor's table. The previous position does not: it is only shown.
template <class S>
void add_row(Hash& h, const RowLayout& layout, const RowColumns<S>& c, std::uint32_t row, S now, S first) {
  add_vector(h, c.position, row, c.velocity[0][row]);
  h.add(c.velocity[1][row], c.velocity[2][row]);
  if (layout.carried) add_vector(h, c.carried, row, S(0));
  if (layout.launched) add_vector(h, c.launch, row, S(0));
  if (layout.clocked) h.add(c.offset[row], now - c.born[row]);
  const std::size_t fields = layout.own.size();
  for (std::size_t i = 0; i + 1 < fields; i += 2) h.add(c.field[layout.own[i]][row], c.field[layout.own[i + 1]][row]);
  if (fields % 2 != 0) h.add(c.field[layout.own[fields - 1]][row], S(0));
  if (layout.burning) h.add(c.field[kBodyNumber.burn_piece][row] - first, S(0));
  if (!layout.turning) return;
  for (unsigned i = 0; i < kNumbers<Turn>; ++i) h.add(c.turn[i][row], S(0));
}

/// The projectiles. Each is hashed alone and the sum taken, so that the order of rows and cohorts does not matter,
/// and the processor works on several at a time.
std::uint64_t sum_of_rows(const WorldState& s, const Kinds& kinds) {
  std::uint64_t sum = 0;
  const auto last_step = static_cast<std::uint32_t>(s.clock.steps);
  for (const Rows& rows : s.rows) {
    rows.visit([&]<class S>(const RowColumns<S>& c) {
      const S now = static_cast<S>(s.clock.now());
      for (std::uint32_t row = 0; row < rows.size(); ++row) {
        const std::uint32_t index = rows.slot(row);
        const Slot& slot = s.slots[index];
        PHYSIM_ASSERT(slot.rung < kinds[slot.kind].rungs.size());
        const Rest& rest = s.slots.rest(index);
        const Prepared& rung = kinds[slot.kind].on(slot.rung);
        Hash h(rung.hash);
        h.add(index, slot.generation);
        h.add(slot.flags, std::bit_cast<std::uint32_t>(rest.step + 1 == last_step ? rest.time : 0.0f));
        h.add(s.slots.birth(index));  // pending launches and the ends of old ages follow from it
        add_row(h, rows.layout(), c, row, now, static_cast<S>(rung.body.burn_piece));
        sum += h.value();
      }
    });
  }
  return sum;
}

/// What few projectiles have of their own: sums again, as these tables have no order.
std::uint64_t sum_of_few(const WorldState& s) {
  std::uint64_t sum = 0;
  for (const auto& [slot, own] : s.extras.own) sum += hash_of(slot, own);
  for (const auto& [slot, tags] : s.extras.tags) sum += hash_of(slot, tags);
  for (const auto& [slot, t] : s.extras.turning) {
    const Quatd& q = t.orientation;
    sum += hash_of(slot, t.angular_velocity, q.w, q.x, q.y, q.z);
  }
  return sum;
}

void add_clock(Hash& h, const Clock& c) {
  for (const double x : {c.dt, c.run_start, c.left_over, c.time_scale}) h.add(x);
  h.add(c.run_steps);
  h.add(std::uint64_t{c.paused});
}

/// Which slots come next, and which ids they give; what became of the projectiles that were there.
void add_free_slots(Hash& h, const WorldState& s) {
  s.slots.each_free([&](std::uint32_t slot) {
    h.add(slot, s.slots[slot].generation);
    h.add(s.slots[slot].flags, 0u);
  });
  h.add(std::uint64_t{s.slots.size()});
}

}  // namespace

std::uint64_t WorldImpl::hash() const {
  Hash h(def_hash);
  add_clock(h, state.clock);
  h.add(sum_of_rows(state, registry.kinds));
  h.add(sum_of_few(state));
  add_free_slots(h, state);
  state.pools.add_to(h);
  state.generators.add_to(h, registry.kinds);
  state.emitters.add_to(h, state.slots);
  state.joints.add_to(h);
  h.add(hash_of(state.observer, state.detail, registry.environments()));
  if (state.scene) h.add(state.scene->hash());
  return h.value();
}

std::uint64_t World::hash() const {
  const IeeeMode mode;
  return impl().hash();
}

}  // namespace physim
