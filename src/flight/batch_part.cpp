#include "flight/batch_part.hpp"

#include <algorithm>
#include <cmath>

#include "base/event_table.hpp"
#include "flight/flight_record.hpp"
#include "flight/kernels.hpp"
#include "flight/pilot.hpp"
#include "flight/plain_shots.hpp"
#include "model/earth.hpp"
#include "prepare/launch.hpp"
#include "prepare/watch_list.hpp"

namespace physim {
namespace {

/// Shots of a group that fly together at a time: few enough to stay in the cache between preparing, flying and
/// gathering.
constexpr std::size_t kChunk = 2048;

/// How many shots ahead structures are asked for.
constexpr std::size_t kAhead = 2;

bool is_by_shot(const std::vector<ShotEvent>& events) {
  return std::is_sorted(events.begin(), events.end(),
                        [](const ShotEvent& a, const ShotEvent& b) { return a.shot < b.shot; });
}

/// Numbers that lanes hold: of air all, or the polynomials of the lowest layer alone.
NumberRuns runs_of(PartSet parts, bool low_air_alone) {
  const PartSet air = PartSet::of<AirPart>();
  if (!low_air_alone || (parts & air) != air) return parts.runs();
  constexpr unsigned kFirst = kBodyNumber.air.low_density[0], kEnd = kBodyNumber.air.layer[0].lapse;
  static_assert(kFirst + kDensityTerms + kPerSoundTerms == kEnd);
  NumberRuns runs = (parts - air).runs();
  runs.add(kFirst, kEnd - kFirst);  // the air comes last
  return runs;
}

/// Which of the numbers that lanes hold differ between launches, as far as their columns say.
NumberRuns differing(const LaunchSource& from, const NumberRuns& held) {
  const auto differs = [](const NumberColumn& column) { return column.of_shots != nullptr; };
  const auto own = [&](unsigned number) {
    if (number == kBodyNumber.launch.x.x) return differs(from.x);
    if (number == kBodyNumber.launch.x.y) return differs(from.y);
    if (number == kBodyNumber.launch.x.z) return differs(from.z);
    const bool is_axis = (number >= kBodyNumber.plane.x && number <= kBodyNumber.plane.z) ||
                         (number >= kBodyNumber.sight.x && number <= kBodyNumber.sight.z);
    return !is_axis || differs(from.azimuth);
  };
  NumberRuns runs;
  held.each([&](unsigned number) {
    if (own(number)) runs.add(number, 1);
  });
  return runs;
}

State<double> drifted(const ShotGroup& group, std::size_t i, const State<double>& flown, double time) {
  PHYSIM_ASSERT(i < group.drifts.size());
  return with_drift(flown, group.drifts[i].first, group.drifts[i].second, time);
}

}  // namespace

void BatchPart::fly(std::size_t first, PartResult& into) {
  PHYSIM_ASSERT(first + into.shots.size() <= task_.shots.size());
  part_ = &into;
  first_ = first;
  if (!fly_as_columns()) {
    for (std::uint32_t i = 0; i < into.shots.size(); ++i) {
      task_.shots.prefetch(first_ + i + kAhead);
      fly_or_gather(i);
    }
  }
  for (ShotGroup& group : groups_.all()) fly(group);
  if (into.wants_events) order_events();
}

void BatchPart::refuse(std::size_t i, const Error& error) {
  PHYSIM_ASSERT(i < part_->shots.size());
  part_->shots[i] = {};
  ++part_->refused;
  if (!part_->error) part_->error = error;
}

void BatchPart::fly_or_gather(std::uint32_t i) {
  const ShotState state = groups_.prepare(first_ + i);
  if (state == ShotState::refused) return refuse(i, groups_.refusal());
  const ShotKind& kind = groups_.kind();
  ShotGroup& group = *kind.group;
  if (!part_->in_use) part_->in_use = group.cohort.in_use;
  if (state == ShotState::over) return end_at_once(i);
  if (state == ShotState::alone) return fly_alone(i);
  if (!group.shots.empty() && group.features() != static_cast<const Features&>(group.cohort.conditions))
    fly(group);  // without what is new
  if (group.own != groups_.parts_of_shots() && groups_.launch().rail_length > 0) {
    fly(group);  // those without a rail
    group.own = groups_.parts_of_shots();
  }
  const Fidelity& granted = group.cohort.in_use.fidelity;
  group.add(i, kind.body);
  if (turns(granted)) group.rotors.push_back(kind.rotor);
  if (drifts(granted))
    group.drifts.emplace_back(
        prepare_spin_drift(*kind.projectile, length(kind.body.launch.v), groups_.environment(), granted),
        kind.body.plane);
  if (group.shots.size() == kChunk) fly(group);
}

/// Each chunk's are in order; those of several groups lie between each other.
void BatchPart::order_events() {
  if (is_by_shot(part_->events)) return;
  const std::vector<ShotEvent> unsorted = part_->events;  // copied back, so that the result keeps its memory
  const auto& order = by_shot_.order(unsorted, part_->shots.size());
  for (std::size_t i = 0; i < order.size(); ++i) part_->events[i] = unsorted[order[i]];
}

void BatchPart::put_attitude(std::uint32_t i, const Attitude& attitude) {
  PHYSIM_ASSERT(part_->attitudes.empty() || i < part_->attitudes.size());
  if (part_->attitudes.empty()) return;
  part_->attitudes[i] = {attitude.q_WB, attitude.omega};
  part_->turned = true;
}

void BatchPart::end_at_once(std::uint32_t i) {
  const ShotKind& kind = groups_.kind();
  const State<double>& launch = kind.body.launch;
  part_->shots[i] = {groups_.outcome(), 0, launch.x, launch.v, {}};
  if (groups_.outcome() == Outcome::landed && part_->wants_events)
    part_->events.push_back(
        {i, {.kind = EventKind::ground, .value = *task_.until.ground, .position = launch.x, .velocity = launch.v}});
  const Cohort& cohort = kind.group->cohort;
  if (turns(cohort.in_use.fidelity))
    put_attitude(i, attitude_of(cohort.conditions, kind.body, kind.rotor, 0, launch, kind.rotor.launch));
}

void BatchPart::fly_alone(std::uint32_t i) {
  const Flight flight = physim::fly(*groups_.kind().projectile, groups_.launch(), groups_.environment(), task_.fidelity,
                                    task_.tolerance, task_.until);
  if (flight.error()) return refuse(i, *flight.error());
  const Sample end = flight.end();
  part_->shots[i] = {flight.outcome(), flight.duration(), end.position, end.velocity, flight.cost()};
  for (const Event& event : flight.events())
    if (part_->wants_events && (!row_of(event.kind).in_flights || asks_for(event.kind)))
      part_->events.push_back({i, event});
  if (turns(flight.fidelity_in_use().fidelity)) put_attitude(i, {end.orientation, end.angular_velocity});
}

bool BatchPart::asks_for(EventKind kind) const {
  return std::ranges::any_of(task_.until.events, [kind](const EventSpec& spec) { return spec.kind == kind; });
}

Status BatchPart::put_step(ShotGroup& group) {
  if (group.step) return {};
  const auto step = steps_.step_of(group.cohort.in_use.fidelity);
  if (!step) return step.error();
  group.step = *step;
  return {};
}

void BatchPart::fly(ShotGroup& group) {
  if (group.shots.empty()) return;
  const Fidelity& granted = group.cohort.in_use.fidelity;
  if (const Status status = put_step(group); !status) {
    for (const std::uint32_t i : group.shots) refuse(i, status.error());
    return group.clear();
  }
  // A shot prepared since then may have brought features, as a motor or a rail; of what belongs to them nothing was
  // gathered.
  Features& features = group.cohort.conditions;
  const Features now = features;
  features = group.features();
  run_kernel(group, nullptr);
  for (const std::uint32_t i : by_shot_.order(group.events, group.shots.size())) keep(group, group.events[i]);
  if (drifts(granted)) add_drift(group);
  if (!group.turned.empty()) keep_attitudes(group);
  features = now;
  group.clear();
}

bool BatchPart::run_kernel_in_low_air(ShotGroup& group, PlainShots& plain) {
  group.cohort.finish();
  const Conditions<double>& c = group.cohort.conditions;
  const bool judged_without_air = prepare_watch(task_.until, c, Watcher::batch).without_air;
  const bool takes_steps = c.fidelity.motion != Motion::closed_form;
  if (!takes_steps || !judged_without_air || !only_air_has_corners(c) || !plain.seem_to_stay_low(c)) return false;
  bool left = false;
  left_low_air_ = &left;
  plain.prepare_low_air_alone(true);
  run_kernel(group, &plain.launches());
  plain.prepare_low_air_alone(false);
  left_low_air_ = nullptr;
  return !left;
}

void BatchPart::run_kernel(ShotGroup& group, const LaunchSource* launches) {
  group.cohort.finish();
  if (group.cohort.in_use.fidelity.precision == Precision::float32)
    run_kernel<float>(group, launches, batch_kernel().fly_float);
  else
    run_kernel<double>(group, launches, batch_kernel().fly_double);
}

template <class S>
void BatchPart::run_kernel(ShotGroup& group, const LaunchSource* launches, void (*kernel)(const BatchJob<S>&)) {
  const Fidelity& granted = group.cohort.in_use.fidelity;
  const std::size_t gathered = group.shots.size();
  PHYSIM_ASSERT(gathered <= kChunk && group.own_numbers.size() == gathered * group.own_stride());
  PHYSIM_ASSERT(group.rotors.size() == (turns(granted) ? gathered : 0));
  PHYSIM_ASSERT(group.drifts.size() == (drifts(granted) ? gathered : 0));
  PHYSIM_ASSERT(launches == nullptr || gathered == 0);
  watch_ = prepare_watch(task_.until, group.cohort.conditions, Watcher::batch);
  const Course<S> course = group.cohort.course<S>(task_.tolerance, *group.step, watch_);
  group.turned.resize(group.rotors.size());
  RawEvent& (*next_event)(void*) = nullptr;
  if (part_->wants_events)
    next_event = [](void* to) -> RawEvent& { return static_cast<ShotGroup*>(to)->events.emplace_back(); };
  const PartSet own = group.own & parts_flown(granted, group.cohort.conditions);
  const PartSet judged = watch_.without_air ? own - kWeatherParts : own;
  const bool low_air_alone = left_low_air_ != nullptr;
  Body<double> common = group.common;
  for (unsigned i = 0; low_air_alone && i < kNumbers<AirNumbers>; ++i)
    numbers(common.air)[i] = std::numeric_limits<double>::quiet_NaN();
  NumberRuns own_runs = runs_of(own, low_air_alone), judged_runs = runs_of(judged, low_air_alone);
  if (launches != nullptr) own_runs = differing(*launches, own_runs), judged_runs = differing(*launches, judged_runs);
  kernel({&course, launches, group.own_numbers.data(), group.own_stride(), own_runs, judged_runs, &common,
          group.rotors.data(), launches ? nullptr : group.shots.data(), launches ? part_->shots.size() : gathered,
          part_->shots.data(), group.turned.empty() ? nullptr : group.turned.data(), next_event, &group,
          left_low_air_});
}

/// Whether the lanes may compute the launches of a part themselves. What all have in common is asked of the first; any
/// shot that is not plain sends the part the other way.
bool BatchPart::fly_as_columns() {
  if (!task_.shots.columns || part_->wants_events || part_->shots.empty()) return false;
  const LaunchColumns& from = *task_.shots.columns;
  if (groups_.prepare(first_) != ShotState::flies) return false;
  ShotGroup& group = *groups_.kind().group;
  const Fidelity& granted = group.cohort.in_use.fidelity;
  const bool by_frames = steps_by_frames(granted) && !step_given(granted, task_.tolerance);
  const bool own_launch =
      group.own != groups_.parts_of_shots() && from.common.rail_length <= 0 && from.common.sight.zero_range <= 0;
  const bool all_in_launch = !turns(granted) && !drifts(granted) && !granted.planar && !is_round(granted.earth);
  if (!own_launch || by_frames || !all_in_launch) return false;
  PlainShots plain(task_, granted, first_, part_->shots.size());
  if (!plain.are_all() || !put_step(group)) return false;
  if (!part_->in_use) part_->in_use = group.cohort.in_use;
  if (!run_kernel_in_low_air(group, plain)) run_kernel(group, &plain.launches());
  return true;
}

void BatchPart::keep(const ShotGroup& group, const RawEvent& e) {
  PHYSIM_ASSERT(e.index >= 0 && e.index < watch_.count);
  const EventSpec& spec = watch_.item[e.index].spec;
  ShotEvent& kept = part_->events.emplace_back();  // written where it stays: see base/append.hpp
  kept.shot = group.shots[e.shot];
  Event& event = kept.event;
  event.kind = spec.kind;
  event.direction = e.rising ? Crossing::rising : Crossing::falling;
  event.value = spec.value;
  event.time = e.time;
  const auto put = [&event](const State<double>& s) { event.position = s.x, event.velocity = s.v; };
  if (drifts(group.cohort.in_use.fidelity)) return put(drifted(group, e.shot, e.state, e.time));
  put(e.state);
}

void BatchPart::add_drift(const ShotGroup& group) {
  for (std::size_t i = 0; i < group.shots.size(); ++i) {
    ShotResult& result = part_->shots[group.shots[i]];
    const State<double> s = drifted(group, i, {result.position, result.velocity}, result.time);
    result.position = s.x;
    result.velocity = s.v;
  }
}

void BatchPart::keep_attitudes(const ShotGroup& group) {
  PHYSIM_ASSERT(group.turned.size() == group.shots.size());
  const Conditions<double>& c = group.cohort.conditions;
  for (std::size_t i = 0; i < group.shots.size(); ++i) {
    const ShotResult& result = part_->shots[group.shots[i]];
    const State<double> end{result.position, result.velocity};
    Body<double> body = group.body(i);
    State<double> start = end;
    if (has_stops(c)) pass_stops(c, result.time, true, start, body);
    put_attitude(group.shots[i], attitude_of(c, body, group.rotors[i], result.time, end, group.turned[i]));
  }
}

}  // namespace physim
