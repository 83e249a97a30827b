#include "world/emitter_moments.hpp"

#include <algorithm>

#include "emit/rain.hpp"
#include "model/closed_form.hpp"
#include "world/world_impl.hpp"

namespace physim {
namespace {

/// One particle, that is no round of a gun.
bool lets_out_one(const EmitMoment& moment) { return moment.count == 1 && !moment.is_round; }

}  // namespace

EmitterMoments::EmitterMoments(WorldImpl& world, const SettleContext& context, double end)
    : world_(world), context_(context), all_(world.state.emitters), s_(world.emitting), end_(end), rain_(world) {
  if (s_.ahead.size() < all_.size()) s_.ahead.resize(all_.size());
  for (const auto& births : s_.ahead)
    if (births) births->begin();
}

// ------------------------------------------------------------------------------------------- where they are
std::optional<Pose> EmitterMoments::pose_at(std::uint32_t index, double time) const {
  const Emitter& e = all_[index];
  const std::optional<Led>& led = s_.led[index];
  if (e.def().follows && (!led || (led->is_left && time > led->way.end()))) return std::nullopt;
  const bool is_on_legs = !e.lead.empty() && !is_past_;
  if (!e.path && !led && !is_on_legs) return Pose{e.at.position, e.at.rotation, {}};
  if (e.def().follows && led->by_launch && !is_past_ && time <= led->by_launch->until) {
    const LedByLaunch& by = *led->by_launch;
    const State<double> at = closed_form(world_.registry.cohort(by.cohort).conditions, by.body, time - by.launched);
    return Pose{at.x, e.at.rotation, at.v};
  }
  const MotionState at = !led ? *e.on_way(time) : led->path->at(is_past_ ? led->way.end() : time);
  return Pose{at.position, e.def().follows ? e.at.rotation : at.rotation, at.velocity};
}

void EmitterMoments::close_ways() {
  for (std::uint32_t i = 1; i < all_.size(); ++i) {
    const Emitter& e = all_[i];
    if (!e.active) continue;
    std::optional<Led>& led = s_.led[i];
    if (e.to && !is_past_) {
      led.emplace(MotionKey{.time = context_.time, .position = e.at.position, .rotation = e.at.rotation});
      led->way.go_straight({.time = end_, .position = e.to->position, .rotation = e.to->rotation});
    }
    if (!led) continue;
    if (led->at_end)
      led->way.arrive({.time = end_, .position = led->at_end->position, .velocity = led->at_end->velocity});
    led->path = led->way.path();
    if (is_past_ || !e.plays || !(e.def().per_metre > 0)) continue;
    led->odometer.emplace(*led->path, std::clamp(e.counted_from(), context_.time, end_));
  }
}

void EmitterMoments::queue_moment(std::uint32_t index) {
  const Emitter& e = all_[index];
  if (!e.active || !e.plays) return;
  if (has_ahead(index)) return queue_.push(firing_of(index, *s_.ahead[index], s_.ahead[index]->next));
  if (const auto next = next_moment(e))
    queue_.push({.time = next->time, .emitter = index, .rank = kOwnMoment, .moment = next->moment});
}

std::optional<EmitterMoments::OwnMoment> EmitterMoments::next_moment(const Emitter& e) const {
  const auto moment = Timeline(*e.emission).next(e.timeline);
  if (!moment) return std::nullopt;
  const double time = e.began + moment->time / e.def().cycle.rate;
  if (time > end_) return std::nullopt;
  return OwnMoment{std::max(time, context_.time), *moment};
}

void EmitterMoments::queue_metre(std::uint32_t index) {
  const Emitter& e = all_[index];
  if (!e.active || !e.plays || !(e.def().per_metre > 0)) return;
  const double distance = static_cast<double>(e.metre + 1) / e.def().per_metre;
  const std::optional<double> time = e.odometer       ? e.odometer->when(distance, end_)
                                     : e.lead.empty() ? when_led(index, distance)
                                                      : e.lead.when(distance, e.travelled, e.counted_from(), end_);
  const double rate = e.def().cycle.rate, last = Timeline(*e.emission).span(e.timeline.play).second;
  if (!time || *time > e.began + last / rate) return;
  const double now = std::max(*time, context_.time);  // rounding may put it just before
  const double own = (now - e.began) * rate;
  EmitMoment moment{.time = own, .phase = Timeline(*e.emission).phase_at(e.timeline.play, own)};
  queue_.push({.time = now, .emitter = index, .rank = kMetre, .moment = moment});
}

/// By when it has come so far, where calls or a projectile lead it.
std::optional<double> EmitterMoments::when_led(std::uint32_t index, double distance) const {
  const std::optional<Led>& led = s_.led[index];
  if (!led || !led->odometer) return std::nullopt;
  const double left = distance - all_[index].travelled, to = std::min(led->way.end(), end_);
  return left > 0 ? led->odometer->when(left, to) : led->odometer->from();
}

double EmitterMoments::led_way(std::uint32_t index) const {
  const std::optional<Led>& led = s_.led[index];
  if (!led || !led->odometer) return 0;
  const double to = std::min(led->way.end(), end_);
  return to > led->odometer->from() ? led->odometer->at(to) : 0;
}

void EmitterMoments::begin_rain(std::uint32_t index) {
  const Emitter& e = all_[index];
  if (!e.active || !e.plays || !e.emission->rain().falls()) return;
  const auto [first, last] = Timeline(*e.emission).span(e.timeline.play);
  const double from = std::max(context_.time, e.began + first / e.def().cycle.rate);
  double to = std::min(end_, e.began + last / e.def().cycle.rate);
  if (s_.led[index] && s_.led[index]->is_left) to = std::min(to, s_.led[index]->way.end());
  const std::optional<Pose> begin = pose_at(index, from), end = pose_at(index, to);
  if (!(from <= to) || !begin || !end) return;
  const std::uint32_t filling = rain_.begin(index, *begin, *end, from, to);
  if (filling > 0)
    queue_.push({.time = from, .emitter = index, .rank = kFill, .moment = rain_moment(index, from, filling)});
  queue_rain(index);
}

void EmitterMoments::queue_rain(std::uint32_t index) {
  if (const std::optional<double> time = rain_.next(index))
    queue_.push({.time = *time, .emitter = index, .rank = kRain, .moment = rain_moment(index, *time, 1)});
}

EmitMoment EmitterMoments::rain_moment(std::uint32_t index, double time, std::uint32_t count) const {
  const Emitter& e = all_[index];
  const double own = (time - e.began) * e.def().cycle.rate;
  return {.time = own, .phase = Timeline(*e.emission).phase_at(e.timeline.play, own), .count = count};
}

// ------------------------------------------------------------------------------------------- several at a time
bool EmitterMoments::sees_ahead(const Firing& first) const {
  const EmitterDef& def = all_[first.emitter].def();
  return !is_past_ && lets_out_one(first.moment) && !def.follows && !(def.per_metre > 0) &&
         !all_[first.emitter].emission->rain().falls();
}

BirthColumns& EmitterMoments::look_ahead(const Firing& first, std::size_t most) {
  PHYSIM_ASSERT(sees_ahead(first) && !has_ahead(first.emitter));
  Emitter& e = all_[first.emitter];
  if (!s_.ahead[first.emitter]) s_.ahead[first.emitter] = std::make_unique<BirthColumns>();
  BirthColumns& births = *s_.ahead[first.emitter];
  births.begin();
  births.one_pose = !e.path && !s_.led[first.emitter];
  births.inherited = e.def().inherit_velocity;
  const std::size_t room = std::clamp<std::size_t>(most, 1, BirthColumns::kLanes);
  const Timeline timeline(*e.emission);
  take_steady(e, room, births);
  const auto begin = births.count == 0 ? std::optional<OwnMoment>({first.time, first.moment}) : next_moment(e);
  for (auto next = begin; births.count < room && next && lets_out_one(next->moment); next = next_moment(e)) {
    const std::size_t lane = births.count++;
    births.time[lane] = next->time;
    births.own_time[lane] = next->moment.time, births.phase[lane] = next->moment.phase;
    timeline.take(e.timeline);
  }
  for (std::size_t lane = 0; lane < births.count; ++lane) {
    births.number[lane] = e.born + lane;
    births.of_moment[lane] = 0, births.moment[lane] = 1;
    if (lane == 0 || !births.one_pose) births.pose[lane] = *pose_at(first.emitter, births.time[lane]);
  }
  return births;
}

/// Births of a steady rate, which are known at once.
void EmitterMoments::take_steady(Emitter& e, std::size_t room, BirthColumns& births) const {
  const Timeline timeline(*e.emission);
  const std::span own(births.own_time.data(), room), phase(births.phase.data(), room);
  const std::size_t steady = timeline.steady(e.timeline, own, phase);
  const double rate = e.def().cycle.rate;
  while (births.count < steady) {
    const double time = e.began + own[births.count] / rate;
    if (time > end_) break;
    births.time[births.count++] = std::max(time, context_.time);
  }
  if (births.count > 0) timeline.take_steady(e.timeline, births.count);
}

Firing EmitterMoments::firing_of(std::uint32_t index, const BirthColumns& births, std::size_t lane) const {
  PHYSIM_ASSERT(lane < births.count);
  return {.time = births.time[lane],
          .emitter = index,
          .rank = kOwnMoment,
          .moment = {.time = births.own_time[lane], .phase = births.phase[lane]}};
}

std::size_t EmitterMoments::first_ahead(std::uint32_t index, const BirthColumns& births) const {
  PHYSIM_ASSERT(!births.is_over());
  std::size_t lane = births.next + 1;
  const double until = queue_.next_time();
  while (lane < births.count && (births.time[lane] < until || queue_.comes_before_all(firing_of(index, births, lane))))
    ++lane;
  return lane - births.next;
}

}  // namespace physim
