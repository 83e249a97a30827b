// A step of the world: free rows by kernels in chunks, forced rows stage by stage, then what follows from both.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/ieee_mode.hpp"
#include "base/spread_sort.hpp"
#include "base/text.hpp"
#include "prepare/check.hpp"
#include "world/couple/world_impl.hpp"
#include "world/step/change_key.hpp"
#include "world/step/kernels.hpp"
#include "world/step/look_around.hpp"
#include "world/step/struck_rows.hpp"

namespace physim {
namespace {

/// Rows that one thread takes at a time: some microseconds of work that stay in its cache.
constexpr std::uint32_t kChunkRows = 4096;

constexpr double kLongestStep = 1e6;  // [s]

/// Nothing turns a projectile upwards, so none dips below the ground and comes out of it within a step.
bool only_falls(const WorldCohort& cohort) {
  const Fidelity& f = cohort.key.fidelity;
  const Features& features = cohort.key.features;
  const bool own = std::ranges::any_of(kOwnParts, [&](const OwnPart& part) { return features.*part.feature; });
  const bool pushed = cohort.key.forced || features.has_applied || own || features.has_motor || features.has_rail ||
                      features.has_force_function || cohort.key.fidelity.rotation == RotationModel::magnus;
  const bool updraught = f.wind == WindModel::profile || cohort.conditions.wind.velocity.y > 0;
  return f.earth == EarthModel::flat && !pushed && !updraught && !cohort.layout.turning;
}

template <class S>
Watchdog<S> watchdog_of(const WorldDef& def, const WorldCohort& cohort, double dt) {
  const DespawnRules& d = cohort.key.rules.despawn;
  const WatchList& watch = cohort.course_double.watch;
  double floor = d.below;
  for (int i = 0; i < watch.count; ++i)
    if (watch.item[i].spec.kind == EventKind::ground || watch.item[i].spec.kind == EventKind::height)
      floor = std::max(floor, watch.item[i].spec.value);
  Watchdog<S> w{};
  w.floor = static_cast<S>(floor);
  // Rounded towards the safe side: a closer look costs little, a missed one a landing.
  if (std::isfinite(floor)) w.floor = std::nextafter(w.floor, std::numeric_limits<S>::infinity());
  w.slowest = static_cast<S>(std::max(d.slower, cohort.key.rules.sleep_speed));
  w.farthest = static_cast<S>(d.farther);
  w.low = vec_cast<S>(d.box_low);
  w.high = vec_cast<S>(d.box_high);
  w.apex = def.apex_events;
  if (flies_in_parts(def, dt)) w.floor = std::numeric_limits<S>::infinity();
  for (int i = 0; i < watch.count; ++i) w.watched = w.watched || !is_seen_by_watchdog(watch.item[i]);
  w.box = d.outside_box;
  w.simple = only_falls(cohort) && !w.apex && !w.watched && !w.box && !cohort.layout.launched;
  return w;
}

}  // namespace

template <class S>
WorldJob<S> rows_job(const SettleContext& context, std::uint16_t index) {
  const WorldCohort& cohort = context.registry->cohort(index);
  const Rows& rows = context.state->rows[index];
  WorldJob<S> job{};
  job.course = &cohort.course<S>();
  job.static_rung = cohort.static_rung;
  job.columns = rows.columns<S>();
  job.fields = rows.layout().fields.data();
  job.field_masks = rows.field_masks().data();
  job.field_count = static_cast<unsigned>(rows.layout().fields.size());
  job.clocked = rows.layout().clocked;
  job.launched = rows.layout().launched;
  job.now = static_cast<S>(context.now);
  job.h = static_cast<S>(context.dt);
  job.radius = std::nextafter(static_cast<S>(cohort.most_radius), std::numeric_limits<S>::infinity());
  if (context.restless && rows.layout().meeting) job.restless = &context.restless->boxes<S>();
  job.watchdog = watchdog_of<S>(*context.def, cohort, context.dt);
  return job;
}
template WorldJob<float> rows_job(const SettleContext& context, std::uint16_t cohort);
template WorldJob<double> rows_job(const SettleContext& context, std::uint16_t cohort);

namespace {

/// What the threads of one step share.
struct StepWork {
  SettleContext context;
  WorldKernel kernel;
  const DrivenRows* driven;
  std::uint32_t* attention;
  std::uint32_t* near;
  const std::size_t* words_before;
  Chunk* chunks;
  bool stream;
  bool asks_engine;  // rows are looked at when all have moved, in the caller's thread
};

template <class S>
void move_chunk(const StepWork& work, Chunk& chunk) {
  PHYSIM_ASSERT(chunk.first % kRowsPerWord == 0 && chunk.last <= work.context.state->rows[chunk.cohort].size());
  PHYSIM_ASSERT(chunk.first < chunk.last);
  // One row of each chunk, another one in each step.
  PHYSIM_ASSERT(is_in_place(
      *work.context.registry, *work.context.state, chunk.cohort,
      chunk.first + static_cast<std::uint32_t>(work.context.state->clock.steps % (chunk.last - chunk.first))));
  WorldJob<S> job = rows_job<S>(work.context, chunk.cohort);
  job.first = chunk.first;
  job.last = chunk.last;
  job.attention = work.attention + work.words_before[chunk.cohort];
  job.stream = work.stream;
  if (work.context.registry->cohort(chunk.cohort).key.forced)
    job.push = work.driven->pushes<S>(*work.context.registry, *work.context.state, chunk.cohort, chunk.first,
                                      chunk.last, chunk.pushes);
  // What stands in its row beside place and velocity cannot be put back.
  const RowLayout& layout = work.context.state->rows[chunk.cohort].layout();
  chunk.looks = layout.meeting && !layout.carried && !layout.turning;
  if (chunk.looks) job.near = work.near + work.words_before[chunk.cohort];
  chunk.attention = step_rows_with(work.kernel, job);
}

/// Calls f with every row of a chunk that came near a thing.
template <class F>
void each_near(const StepWork& work, const Chunk& chunk, const F& f) {
  if (chunk.looks) each_marked(work.near + work.words_before[chunk.cohort], chunk.first, chunk.last, f);
}

void settle_chunk(const StepWork& work, Chunk& chunk) {
  if (chunk.attention)
    settle_marked(work.context, work.kernel, chunk, work.attention + work.words_before[chunk.cohort]);
}

/// All rows that came near something ask in one call.
void ask_engine(const StepWork& work, std::span<Chunk> chunks) {
  std::vector<NearRow> rows;
  for (Chunk& chunk : chunks) each_near(work, chunk, [&](std::uint32_t row) { rows.push_back({&chunk, row}); });
  look_around(work.context, rows);
  for (Chunk& chunk : chunks) settle_chunk(work, chunk);
}

void run_chunk(void* shared, std::size_t i) {
  const IeeeMode mode;
  const auto& work = *static_cast<const StepWork*>(shared);
  Chunk& chunk = work.chunks[i];
  if (work.context.state->rows[chunk.cohort].layout().float32)
    move_chunk<float>(work, chunk);
  else
    move_chunk<double>(work, chunk);
  if (work.asks_engine) return;
  LookAround look(work.context, chunk);
  each_near(work, chunk, [&](std::uint32_t row) { look.add(row); });
  look.finish();
  settle_chunk(work, chunk);
}

/// Does everything in the caller's thread.
class NoThreads final : public TaskRunner {
 public:
  void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
    for (std::size_t i = 0; i < count; ++i) task(context, i);
  }
  [[nodiscard]] unsigned threads() const override { return 1; }
};

}  // namespace

TaskRunner& WorldImpl::runner(std::size_t rows) {
  static NoThreads none;
  const std::size_t wanted = rows / std::max<std::size_t>(def.threading.rows_per_thread, 1);
  if (wanted <= 1 || def.threading.threads == 1) return none;
  if (lent) return *lent;
  if (!own_threads) own_threads = make_thread_pool(def.threading.threads);
  return *own_threads;
}

void World::set_task_runner(TaskRunner* runner) { impl().lent = runner; }

/// Launches what is due in the step just taken: each flies from its moment to the end of the step, alone.
void WorldImpl::launch_pending(const SettleContext& context) {
  while (const auto due = state.launches.take(state.clock.time(), state.slots)) {
    Slot& slot = *find(due->id);
    slot.set(kPending, false);
    slot.set_status(LifeStatus::in_flight);
    const BodyState at = state.state_of(slot);
    const Body<double> old = placement.body_of(slot);
    placement.relocate(due->id.index);
    placement.write_row(due->id.index, at, {.previous = at.position, .old = &old, .birth = due->time});
    tell_launch(due->id.index, {.moment = due->time});
    fly_launched(*this, context, due->id.index, due->time);
  }
}

void WorldImpl::expire_old() {
  while (const ProjectileId id = state.old_age.take_due(state.clock.time(), state.slots)) {
    tell(EventKind::expired, id.index, Reason::older);
    leave_after_step(*this, id.index);
    remove(id.index, LifeStatus::expired);
  }
}

void WorldImpl::step_free(double dt) {
  scratch.chunk_count = 0;
  scratch.words_before.assign(state.rows.size(), 0);
  const SettleContext context = settle_context(dt);
  std::size_t words = 0;
  std::size_t moving = 0;
  std::size_t bytes = 0;
  for (std::uint16_t c = 0; c < state.rows.size(); ++c) {
    const CohortKey& key = registry.cohort(c).key;
    scratch.words_before[c] = words;
    if (key.still || !steps_with_free(context, c)) continue;
    const Rows& rows = state.rows[c];
    const std::uint32_t size = rows.size();
    moving += size;
    bytes += size * rows.row_bytes();
    words += (size + kRowsPerWord - 1) / kRowsPerWord;
    for (std::uint32_t first = 0; first < size; first += kChunkRows) {
      const std::uint32_t last = std::min(size, first + kChunkRows);
      if (scratch.chunk_count == scratch.chunks.size()) scratch.chunks.emplace_back();
      Chunk& chunk = scratch.chunks[scratch.chunk_count++];
      chunk.cohort = c;
      chunk.first = first;
      chunk.last = last;
      chunk.events.clear(), chunk.strikes.clear();
      chunk.changes.clear();
      chunk.traces.clear();
    }
  }
  if (scratch.attention.size() < words) scratch.attention.resize(words);
  if (scratch.near.size() < words) scratch.near.resize(words);
  StepWork work{context,
                world_kernel(),
                &forced_scratch.driven,
                scratch.attention.data(),
                scratch.near.data(),
                scratch.words_before.data(),
                scratch.chunks.data(),
                bytes > kCacheBytes,
                state.scene && state.scene->engine()};
  runner(moving).run(scratch.chunk_count, run_chunk, &work);
  if (work.asks_engine) ask_engine(work, std::span(scratch.chunks).first(scratch.chunk_count));
  settle_asked(*this, work.context);
  for (std::uint16_t c = 0; c < state.rows.size(); ++c) {
    const CohortKey& key = registry.cohort(c).key;
    if (!key.still) state.rows[c].swap_positions();
  }
  state.counters.projectile_steps += moving;
}

namespace {

/// Whether an event has a time of the step that is over.
[[maybe_unused]] bool is_of_step(const Clock& clock, double time) {
  const double slack = 1e-3 * clock.dt + 1e-6 * clock.time();  // clocks of float32 rows
  return time >= clock.time() - clock.dt - slack && time <= clock.time() + slack;
}

}  // namespace

/// Does what settling decided, in order of slots, so that neither threads nor the order of rows matter.
void WorldImpl::finish_step() {
  StepList<std::uint64_t>& keys = scratch.change_order;
  keys.clear(), scratch.change_spare.clear(), scratch.changes.clear();
  const auto collect = [&](const Chunk& chunk) {
    PHYSIM_ASSERT(std::ranges::all_of(chunk.events, [&](const Event& e) { return is_of_step(state.clock, e.time); }));
    PHYSIM_ASSERT(std::ranges::all_of(chunk.strikes, [&](const auto& t) { return is_of_step(state.clock, t.time); }));
    for (const Change& c : chunk.changes) {
      keys.push_back(ChangeKey::of(c, scratch.changes.size()));
      scratch.changes.push_back(&c);
    }
    keep_events(chunk.strikes);
    for (const Event& event : chunk.events) keep_event(event);
  };
  for (std::size_t i = 0; i < scratch.chunk_count; ++i) collect(scratch.chunks[i]);
  collect(forced_scratch.chunk);
  collect(pairs.chunk);
  for (const PutAfter& put : pairs.put) {
    if (!state.slots[put.slot].is(kAlive)) continue;
    wake(put.slot);
    placement.set_row_state(put.slot, put.state);
  }
  if (!std::ranges::is_sorted(keys)) spread_sort(keys, scratch.change_spare, ChangeKey::slot, std::less{});
  for (std::size_t i = 0; i < keys.size(); ++i) {
    prefetch(keys.size(), i, [&](std::size_t k) { return ChangeKey::slot(keys[k]); });
    carry_out(*scratch.changes[ChangeKey::at(keys[i])]);
  }
  wake_piled(std::exchange(pairs.disturbed, {}));
  rest_piles(*this);
}

void WorldImpl::carry_out(const Change& change) {
  Slot& slot = state.slots[change.slot];
  if (!slot.is(kAlive)) return;
  switch (change.kind) {
    case Change::Kind::remove:
      if (change.reason == Reason::non_finite) ++state.counters.retired;
      remove(change.slot, change.status);
      break;
    case Change::Kind::spin:
      slot.set(kTurning, true);
      state.extras.turning[change.slot].angular_velocity = change.spin;
      break;
    case Change::Kind::stick:
      placement.set_row_state(change.slot, {state.state_of(slot).position, {}});
      placement.stop_turning(change.slot);
      slot.set(kStuck, true);
      slot.set_status(LifeStatus::landed);
      placement.relocate(change.slot);
      break;
    case Change::Kind::sleep:
      if (!state.joints.of_slot(change.slot)) put_to_sleep(change.slot);  // else its net does, whole
      break;
  }
}

namespace {

/// Everyone alive has a row.
[[maybe_unused]] std::size_t rows_of_all(const WorldState& state) {
  std::size_t count = 0;
  for (const Rows& rows : state.rows) count += rows.size();
  return count;
}

}  // namespace

void WorldImpl::step(double dt) {
  PHYSIM_ASSERT(dt > 0 && !is_inside);
  const Inside inside(*this);
  [[maybe_unused]] const std::uint64_t steps_before = state.clock.steps;
  [[maybe_unused]] const double before = state.clock.time();
  // Begin: what is due now, and what acts on all projectiles where they are.
  hit_asking.forget();
  placement.rebase(dt);
  begin_generators(dt);
  apply_detail();
  move_scene(dt);
  begin_joints(*this, dt);
  begin_emitters(*this, dt);
  begin_pairs(*this);
  is_stirred = false;
  // Advance, and resolve what rows meet by themselves. Forced rows go first: their springs may end at free ones.
  step_forced(dt);
  step_free(dt);
  const SettleContext context = settle_context(dt);
  meet_pairs(*this, context);
  turn(dt);
  state.clock.tick();
  PHYSIM_ASSERT(state.clock.time() >= before && state.clock.steps == steps_before + 1);
  ++state.counters.steps;
  launch_pending(context);
  // Commit, in order of slots; then births in order of time.
  watch_for_emitters(*this, context);
  finish_step();
  hold_joints(*this, dt);
  expire_old();
  fire_emitters(*this, context);
  end_generators();
  // Show.
  scratch.merge.clear();
  state.events.put_in_order(scratch.merge, given_events);
  state.events_of_step = state.events.size();
  PHYSIM_ASSERT(rows_of_all(state) == state.slots.alive());
  if (recorder) recorder->stepped([this] { return hash(); });
}

// --------------------------------------------------------------------------------------------------- time
Status World::step(double dt) {
  WorldImpl& w = impl();
  const Recorded<Call::step> call(w, dt);
  if (call.is_refused()) return call.refusal();
  if (!(dt >= kShortestStep && dt < kLongestStep))
    return Error{"must be 1e-9 s at least and below 1e6 s, not " + rounded_text(dt), "dt", "take several steps"};
  w.forget_events();
  w.step(dt);
  return {};
}

int World::advance(double real_dt) {
  WorldImpl& w = impl();
  const Recorded<Call::advance> call(w, real_dt);
  if (call.is_refused()) return 0;
  Clock& clock = w.state.clock;
  w.forget_events();
  if (!(real_dt >= 0 && real_dt < 1e9) || clock.paused) return 0;
  clock.left_over += real_dt * clock.time_scale;
  int steps = 0;
  while (clock.left_over >= w.def.step && static_cast<std::uint32_t>(steps) < w.def.max_steps) {
    w.step(w.def.step);
    clock.left_over -= w.def.step;
    ++steps;
  }
  if (clock.left_over >= w.def.step) {  // too slow to keep up: time is dropped rather than owed
    const double kept = std::fmod(clock.left_over, w.def.step);
    w.state.counters.dropped_time += clock.left_over - kept;
    clock.left_over = kept;
  }
  return steps;
}

void World::single_step() {
  WorldImpl& w = impl();
  const Recorded<Call::single_step> call(w);
  if (call.is_refused()) return;
  w.forget_events();
  w.step(w.def.step);
}

void World::set_paused(bool paused) {
  WorldImpl& w = impl();
  const Recorded<Call::set_paused> call(w, paused);
  if (call.is_refused()) return;
  w.state.clock.paused = paused;
}
bool World::is_paused() const { return impl().state.clock.paused; }
Status World::set_time_scale(double scale) {
  WorldImpl& w = impl();
  const Recorded<Call::set_time_scale> call(w, scale);
  if (call.is_refused()) return call.refusal();
  if (!(scale >= 0 && scale <= 1000)) return Error{"must lie between 0 and 1000", "time_scale", ""};
  w.state.clock.time_scale = scale;
  return {};
}
double World::time_scale() const { return impl().state.clock.time_scale; }
double World::time() const {
  const IeeeMode mode;
  return impl().state.clock.time();
}
double World::fraction() const {
  const IeeeMode mode;
  return impl().state.clock.left_over / impl().def.step;
}

}  // namespace physim
