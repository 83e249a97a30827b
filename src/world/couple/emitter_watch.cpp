#include "world/couple/emitter_watch.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/append.hpp"
#include "world/couple/held_forces.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// What a kind of event is to sub-emitters.
std::optional<SubEvent> sub_event(EventKind kind) {
  if (kind == EventKind::hit) return SubEvent::hit;
  if (kind == EventKind::bounced) return SubEvent::bounce;
  if (kind == EventKind::ricocheted) return SubEvent::ricochet;
  if (kind == EventKind::penetrated || kind == EventKind::left) return SubEvent::exit;
  if (kind == EventKind::landed) return SubEvent::landing;
  if (kind == EventKind::apex) return SubEvent::apex;
  return std::nullopt;
}

/// Whether an event's velocity is that after it was thrown off; nothing: its way continues unchanged.
std::optional<bool> thrown_off(const Event& event) {
  if (event.kind == EventKind::hit) return false;  // the next event reports its consequence
  const bool is_thrown = event.kind == EventKind::bounced || event.kind == EventKind::ricocheted ||
                         event.kind == EventKind::penetrated || event.kind == EventKind::stopped;
  return is_thrown ? std::optional(true) : std::nullopt;
}

bool waits_for(const EmitterDef& def, SubEvent on) {
  return std::ranges::any_of(def.subs, [on](const SubEmitter& sub) { return sub.on == on; });
}

/// It was where it is, and is there now.
void move_on(const Rows& rows, std::uint32_t row, const State<double>& to) {
  rows.visit([&](const auto& c) {
    Rows::put(c.previous, row, Rows::at(c.position, row));
    Rows::put(c.position, row, to.x);
    Rows::put(c.velocity, row, to.v);
  });
}

/// It is so old at that step.
void start_clock(const Rows& rows, std::uint32_t row, double age, double step) {
  rows.visit([&]<class S>(const RowColumns<S>& c) {
    if (!rows.layout().clocked) return;
    c.offset[row] = static_cast<S>(age);
    c.born[row] = static_cast<S>(step);
  });
}

}  // namespace

EmitterWatch::EmitterWatch(WorldImpl& world, const SettleContext& context, double end)
    : w_(world), context_(context), all_(world.state.emitters), s_(world.emitting), end_(end) {
  PHYSIM_ASSERT(!context.pairs && !context.taken);
  s_.known.forget();
  is_any_led_ = std::ranges::any_of(s_.led, [](const auto& led) { return led.has_value(); });
}

// ------------------------------------------------------------------------------------------- before the step
void EmitterWatch::note_followed() {
  s_.led.assign(all_.size(), std::nullopt);
  is_any_led_ = false;
  s_.own_births.assign(all_.size(), 0);
  for (std::uint32_t i = 1; i < all_.size(); ++i) {
    if (!all_[i].active || !all_[i].def().follows) continue;
    const Slot* slot = w_.find(all_[i].def().follows);
    if (!slot) continue;
    const BodyState now = followed_state(*slot);
    s_.led[i].emplace(MotionKey{.time = context_.time, .position = now.position, .velocity = now.velocity});
    is_any_led_ = true;
    s_.led[i]->by_launch = launch_of_followed(all_[i], *slot);
  }
}
/// What waits for its launch stands.
BodyState EmitterWatch::followed_state(const Slot& slot) const {
  BodyState now = w_.state.state_of(slot);
  if (slot.is(kPending)) now.velocity = {};
  return now;
}
/// Nothing where it does not fly by its closed form.
std::optional<LedByLaunch> EmitterWatch::launch_of_followed(Emitter& e, const Slot& slot) {
  const bool is_jointed = !w_.state.joints.empty() && w_.state.joints.of_slot(w_.state.slots.index_of(slot));
  const bool is_closed = w_.registry.cohort(slot.cohort).key.fidelity.motion == Motion::closed_form;
  if (!is_closed || is_jointed || slot.is(kStill)) {
    e.launch.reset();
    return std::nullopt;
  }
  LedByLaunch by{.cohort = slot.cohort, .body = w_.placement.body_of(slot)};
  const State<double>& at = by.body.launch;
  const double age = w_.placement.clock_of(slot), launched = context_.time - age;
  const double rounding =
      w_.state.rows_of(slot).layout().float32 ? 1e-6 * (1 + age) : 1e-9 * (1 + std::abs(context_.time));
  const bool is_known = e.launch && e.launch->id == e.def().follows && e.launch->position == at.x &&
                        e.launch->velocity == at.v && std::abs(e.launch->time - launched) <= rounding;
  if (!is_known) e.launch = {.id = e.def().follows, .position = at.x, .velocity = at.v, .time = launched};
  by.launched = e.launch->time;
  return by;
}

void EmitterWatch::reach_ages() {
  while (const auto due = all_.ages.take(end_, w_.state.slots)) {
    const Particle* particle = all_.particle(due->id.index);
    if (!particle) continue;
    if (const auto at = seen_at(due->id.index, std::nullopt, due->time)) trigger_age(due->id.index, *at, due->time);
  }
}

void EmitterWatch::end_lives() {
  s_.dying.clear(), s_.ends.clear();
  while (const auto due = all_.lives.take(end_, w_.state.slots))
    s_.dying.push_back(due->id), s_.ends.push_back(due->time);
  constexpr std::size_t kAhead = 8;
  for (std::size_t i = 0; i < s_.dying.size(); ++i) {
    w_.prefetch(s_.dying, i);  // they lie all over the memory
    if (i + kAhead < s_.dying.size()) {
      all_.prefetch(s_.dying[i + kAhead].index);
      w_.state.slots.prefetch_birth(s_.dying[i + kAhead].index);
    }
    if (w_.find(s_.dying[i])) end_life(s_.dying[i].index, std::nullopt, s_.ends[i]);
  }
}

// ------------------------------------------------------------------------------------------- after it
void EmitterWatch::watch(const Chunk& chunk) {
  PHYSIM_ASSERT(chunk.strikes.empty());
  for (const Event& event : chunk.events) watch(event);
  std::unordered_map<std::uint32_t, const Event*> last;  // of those that leave
  for (const Change& change : chunk.changes)
    if (change.kind == Change::Kind::remove && is_known(change.slot)) last[change.slot] = nullptr;
  if (last.empty()) return;
  for (const Event& event : chunk.events)
    if (const auto at = last.find(event.id.index); at != last.end()) at->second = &event;
  for (const auto& change : chunk.changes) {
    const auto at = last.find(change.slot);
    if (at == last.end()) continue;
    leaves(change.slot, at->second);
    last.erase(at);
  }
}
void EmitterWatch::begin_following(std::uint32_t index, double time) {
  if (!is_any_led_) return;
  const BodyState at = w_.state.state_of(w_.state.slots[index]);
  for (std::uint32_t i = 1; i < all_.size(); ++i) {
    if (!s_.led[i] || !follows(all_[i], index)) continue;
    s_.led[i]->way.turn({.time = time, .position = at.position, .velocity = at.velocity});
  }
}
void EmitterWatch::follow_to_end() {
  for (std::uint32_t i = 1; i < all_.size(); ++i) {
    std::optional<Led>& led = s_.led[i];
    const Slot* slot = led && !led->is_left ? w_.find(all_[i].def().follows) : nullptr;
    if (!slot) continue;
    led->at_end = followed_state(*slot);
  }
}

/// By a rule that is looked at when the step is over.
void EmitterWatch::leave_now(std::uint32_t slot) {
  depart(slot, all_.particle(slot)->emitter, w_.state.state_of(w_.state.slots[slot]), end_);
}
void EmitterWatch::trigger_all(std::uint32_t index) {
  std::vector<std::uint32_t> slots;
  all_.each_particle_of(index, [&](std::uint32_t slot, const Particle&) { slots.push_back(slot); });
  for (const std::uint32_t slot : slots)
    trigger(slot, SubEvent::trigger, end_, w_.state.state_of(w_.state.slots[slot]), {});
}

// ------------------------------------------------------------------------------------------- what happens
bool EmitterWatch::is_known(std::uint32_t slot) const {
  if (all_.particle(slot)) return true;
  return std::ranges::any_of(all_.all(), [&](const Emitter& e) { return e.active && follows(e, slot); });
}
bool EmitterWatch::follows(const Emitter& e, std::uint32_t slot) const {
  return e.def().follows && e.def().follows == w_.state.slots.id_of(slot);
}
/// An emitter that follows it turns where it does.
void EmitterWatch::turn_followed(const Event& event) {
  const auto turns = thrown_off(event);
  if (!turns) return;
  for (std::uint32_t i = 1; i < all_.size(); ++i) {
    if (!s_.led[i] || s_.led[i]->is_left || !follows(all_[i], event.id.index)) continue;
    StepWay& way = s_.led[i]->way;
    if (event.time < way.end()) continue;  // rounding
    const MotionKey key{.time = event.time, .position = event.position, .velocity = event.velocity};
    *turns ? way.turn(key) : way.arrive(key);
    if (auto& by = s_.led[i]->by_launch) by->until = std::min(by->until, event.time);
  }
}
void EmitterWatch::watch(const Event& event) {
  turn_followed(event);
  if (!all_.particle(event.id.index)) return;
  if (const auto on = sub_event(event.kind))
    trigger(event.id.index, *on, event.time, {event.position, event.velocity}, event.normal);
}
/// It leaves the world where its last event says, or at the end of the step.
void EmitterWatch::leaves(std::uint32_t slot, const Event* last) {
  const BodyState at = last ? BodyState{last->position, last->velocity} : w_.state.state_of(w_.state.slots[slot]);
  const double time = last ? last->time : end_;
  end_followed(slot, at, time);
  if (const Particle* particle = all_.particle(slot)) depart(slot, particle->emitter, at, time);
}
/// An emitter that follows it comes no farther.
void EmitterWatch::end_followed(std::uint32_t slot, const BodyState& at, double time) {
  if (!is_any_led_) return;
  for (std::uint32_t i = 1; i < all_.size(); ++i)
    if (s_.led[i] && !s_.led[i]->is_left && follows(all_[i], slot)) {
      s_.led[i]->is_left = true;
      if (time >= s_.led[i]->way.end())
        s_.led[i]->way.arrive({.time = time, .position = at.position, .velocity = at.velocity});
    }
}
void EmitterWatch::depart(std::uint32_t slot, std::uint32_t emitter, const BodyState& at, double time) {
  append(s_.departures, {emitter, time});
  trigger(slot, SubEvent::death, time, at, {});
}
void EmitterWatch::trigger(std::uint32_t slot, SubEvent on, double time, const BodyState& at, const Vec3d& normal,
                           std::size_t only) {
  if (!waits_for(all_[all_.emitter_of(slot)].def(), on)) return;
  Particle& particle = *all_.particle(slot);
  s_.triggers.push_back({on, time, w_.state.slots.birth(slot), particle, at, normal, only});
  // What comes once is counted apart: in which order steps look at it does not matter.
  const bool comes_once = on == SubEvent::birth || on == SubEvent::age || on == SubEvent::death;
  s_.triggers.back().particle.events = comes_once ? 0 : ++particle.events;
}

// ------------------------------------------------------------------------------------------- ages, ends of lives
/// Where one is at a time inside of the step; none: it is gone by then. The chunk has what happens to it before.
std::optional<BodyState> EmitterWatch::flown_to(std::uint32_t index, std::optional<double> born, double time) {
  const Slot& slot = w_.state.slots[index];
  if (slot.is(kStill)) return w_.state.state_of(slot);
  const double until = passed_at(time);
  auto at = s_.known.state_after(context_, slot.cohort, slot.row, born, until);
  s_.chunk.cohort = slot.cohort;
  if (!at)
    at = with_held_forces(w_, context_, slot, [&](const SettleContext& context) {
      return state_inside(context, s_.chunk, slot.row, born, until);
    });
  return at ? std::optional(BodyState{at->x, at->v}) : std::nullopt;
}
/// For a caller that only looks.
std::optional<BodyState> EmitterWatch::seen_at(std::uint32_t index, std::optional<double> born, double time) {
  const std::optional<BodyState> at = flown_to(index, born, time);
  s_.chunk.events.clear(), s_.chunk.changes.clear();
  return at;
}
void EmitterWatch::trigger_age(std::uint32_t index, const BodyState& at, double time) {
  const auto& subs = all_[all_.particle(index)->emitter].def().subs;
  for (std::size_t i = 0; i < subs.size(); ++i)
    if (subs[i].on == SubEvent::age && w_.state.slots.birth(index) + subs[i].age == time)
      trigger(index, SubEvent::age, time, at, {}, i);
}

void EmitterWatch::end_life(std::uint32_t index, std::optional<double> born, double time) {
  const std::optional<BodyState> at = flown_to(index, born, time);
  if (tell_chunk()) return;  // it left before
  if (at) expire(index, *at, time);
}
void EmitterWatch::expire(std::uint32_t index, const BodyState& at, double time) {
  w_.keep_event(
      PlainEvent{EventKind::expired, Reason::older, w_.state.slots.id_of(index), 0, time, at.position, at.velocity});
  end_followed(index, at, time);
  if (const std::uint32_t emitter = all_.emitter_of(index)) depart(index, emitter, at, time);
  all_.leave(index, &EmitterCounts::aged);
  w_.remove(index, LifeStatus::expired);
}
/// Takes the events of a row that was flown alone, and what follows from them; returns whether it left.
bool EmitterWatch::tell_chunk() {
  Chunk& chunk = s_.chunk;
  if (chunk.events.empty() && chunk.changes.empty()) return false;
  for (Event& event : chunk.events)
    event.time = std::max(event.time, w_.state.slots.birth(event.id.index));  // rounding
  watch(chunk);
  for (const Event& event : chunk.events) w_.keep_event(event);
  bool left = false;
  for (const Change& change : chunk.changes) {
    left = left || change.kind == Change::Kind::remove;
    w_.carry_out(change);
  }
  chunk.events.clear(), chunk.changes.clear();
  return left;
}

// ------------------------------------------------------------------------------------------- of one newborn
void EmitterWatch::look_ahead(std::uint32_t index, double born, double birth, double until) {
  each_age(all_[all_.particle(index)->emitter].def().subs, birth, [&](double then) {
    if (then > until) return;
    if (const auto at = seen_at(index, born, then)) trigger_age(index, *at, then);
  });
}

void EmitterWatch::fly_newborn(std::uint32_t index, double born) {
  const Slot& slot = w_.state.slots[index];
  if (slot.is(kStill)) return;
  if (const auto end = s_.known.state_after(context_, slot.cohort, slot.row, born, context_.dt)) {
    move_on(w_.state.rows_of(slot), slot.row, *end);
    return start_clock(w_.state.rows_of(slot), slot.row, context_.dt - born, context_.now + 1);
  }
  s_.chunk.cohort = slot.cohort;
  with_held_forces(w_, context_, slot, [&](const SettleContext& context) {
    settle_alone(context, s_.chunk, slot.row, born);
    return 0;
  });
  w_.state.rows_of(slot).swap_positions(slot.row);  // it was written as the next position
  tell_chunk();
}

// ------------------------------------------------------------------------------------------- of what is past already
void EmitterWatch::grow_up(std::uint32_t index, double birth, double dies) {
  const double end = std::min(dies, end_);
  std::vector<double> stops;
  each_age(all_[all_.particle(index)->emitter].def().subs, birth, [&](double then) {
    if (then <= end) stops.push_back(then);
  });
  std::ranges::sort(stops);
  double now = birth;
  for (const double stop : stops) {
    if (!fly_in_parts(index, now, stop, now == birth)) return;
    trigger_age(index, w_.state.state_of(w_.state.slots[index]), stop);
    now = stop;
  }
  if (!fly_in_parts(index, now, end, now == birth) || dies > end_) return;
  expire(index, w_.state.state_of(w_.state.slots[index]), dies);
}

bool EmitterWatch::fly_in_parts(std::uint32_t index, double from, double to, bool is_birth) {
  PHYSIM_ASSERT(to >= from);
  if (to == from) return true;
  // Fixed steps take the world's; a closed form takes none.
  constexpr double kLongestClosed = 100;  // for one that bounces this is some thousand steps [s]
  const Slot& slot = w_.state.slots[index];
  const bool is_closed = w_.registry.cohort(slot.cohort).key.fidelity.motion == Motion::closed_form;
  const double longest = is_closed ? kLongestClosed : w_.def.step;
  const double parts = std::max(std::ceil((to - from) / longest - 1e-9), 1.0);
  SettleContext part = context_;
  part.dt = (to - from) / parts;
  const double now = w_.state.clock.now();
  count_from(slot, now - parts);
  for (double k = 0; k < parts && !slot.is(kStill); ++k) {
    if (has_flown_most()) return w_.retire(index, Reason::stalled), false;
    part.time = from + k * part.dt;
    part.now = now - parts + k;
    s_.chunk.cohort = slot.cohort;
    s_.chunk.flown = 0;
    with_held_forces(w_, part, slot, [&](const SettleContext& context) {
      settle_alone(context, s_.chunk, slot.row, is_birth && k == 0 ? std::optional(0.0) : std::nullopt);
      return 0;
    });
    flown_ += std::max<std::uint64_t>(s_.chunk.flown, 1);
    w_.state.rows_of(slot).swap_positions(slot.row);
    if (tell_chunk()) return false;
  }
  w_.state.rows_of(slot).visit([&]<class S>(const RowColumns<S>& c) {
    if (!w_.state.rows_of(slot).layout().clocked) return;
    c.offset[slot.row] += (static_cast<S>(now) - c.born[slot.row]) * static_cast<S>(part.dt);
  });
  count_from(slot, now);
  return true;
}

/// A row's clock counts steps from that one on.
void EmitterWatch::count_from(const Slot& slot, double step) {
  const Rows& rows = w_.state.rows_of(slot);
  if (!rows.layout().clocked) return;
  rows.visit([&]<class S>(const RowColumns<S>& c) { c.born[slot.row] = static_cast<S>(step); });
}

}  // namespace physim
