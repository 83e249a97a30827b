#include "world/couple/emitter_step.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

#include "base/append.hpp"
#include "base/restored.hpp"
#include "emit/flight_law.hpp"
#include "emit/rain.hpp"
#include "math/elementary.hpp"
#include "model/closed_form.hpp"
#include "world/couple/birth_batch.hpp"
#include "world/couple/emitter_firing.hpp"
#include "world/couple/emitter_rain.hpp"
#include "world/couple/emitter_watch.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// The fewest births that are worth being drawn side by side.
constexpr std::uint32_t kFew = 4;

/// One particle, that is no round of a gun.
bool lets_out_one(const EmitMoment& moment) { return moment.count == 1 && !moment.is_round; }

/// When emitters fire in a step, in order of time, where they are then, and what they emit.
///
/// Each emitter's next moment waits in a queue, beside those of its metres and its rain, and beside those of triggered
/// sub-emitters. An emitter's own moments are taken from its timeline several at a time, so that their
/// births are drawn and flown side by side; they wait in the queue one by one as all others do.
class EmitterBirths {
 public:
  /// The step ends at `end` [s].
  EmitterBirths(WorldImpl& world, const SettleContext& context, double end)
      : w_(world),
        context_(context),
        all_(world.state.emitters),
        s_(world.emitting),
        end_(end),
        rain_(world),
        batches_(world, context, end),
        watch_(world, context, end) {
    if (s_.ahead.size() < all_.size()) s_.ahead.resize(all_.size());
    for (const auto& births : s_.ahead)
      if (births) births->begin();
    s_.causes.clear();
  }
  /// The ways of those that are led through the step are known by now.
  void close_ways();

  [[nodiscard]] EmitterWatch& watch() { return watch_; }

  /// All that one has fired before the world's time.
  void fire_past(std::uint32_t index) {
    is_past_ = true;
    close_ways();
    skip_gone(index);
    queue_moment(index);
    queue_metre(index);
    work_off();
  }

  // ------------------------------------------------------------------------------------------- births
  void fire() {
    watch_.follow_to_end();  // once more: joints may have held it since
    close_ways();
    for (std::uint32_t i = 1; i < all_.size(); ++i) {
      queue_moment(i);
      queue_metre(i);
      begin_rain(i);
    }
    work_off();
    for (std::uint32_t i = 1; i < all_.size(); ++i) finish(i);
  }
  /// All that waits, in order of time.
  void work_off() {
    queue_triggers();
    while (!queue_.empty()) {
      const Firing firing = queue_.pop();
      if (firing.rank != kSub && !all_[firing.emitter].plays) continue;
      if (firing.rank == kOwnMoment) {
        fire_own(firing);
        queue_triggers();
        continue;
      }
      if (firing.rank == kMetre) {
        ++all_[firing.emitter].metre;
        queue_metre(firing.emitter);
      } else if (firing.rank == kRain) {
        rain_.take(firing.emitter);
        queue_rain(firing.emitter);
      }
      fire(firing);
      queue_triggers();
    }
    s_.departures.clear();  // no later code reads it
  }
  void fire(const Firing& firing) {
    Emitter& e = all_[firing.emitter];
    const std::optional<Pose> pose = cause_of(firing) ? pose_of(firing) : pose_at(firing.emitter, firing.time);
    if (!pose) {
      e.plays = false;
      return;
    }
    const std::uint64_t cut = e.counts.cut;
    const BirthPlan* const plan = plan_of(firing);
    BirthColumns& together = s_.together;
    together.begin();
    std::uint32_t i = 0;
    while (i < firing.moment.count && e.counts.cut == cut) {
      if (plan && together.is_over()) look_at_moment(*plan, firing, *pose, i);
      if (!together.is_over()) {
        i += bear_next(*plan, together, firing, *pose, together.count - together.next);
      } else {
        bear(firing, *pose, i);
        ++i;
      }
    }
    if (e.counts.cut != cut) e.counts.cut += firing.moment.count - i;  // those behind the first that was cut
  }

 private:
  enum Rank : std::uint32_t { kOwnMoment, kMetre, kFill, kRain, kSub };
  /// The most births that lead to one another at one moment: more are cut.
  static constexpr std::uint32_t kDeepest = 32;

  // ------------------------------------------------------------------------------------------- when and where they
  // fire
  /// Where one is and which way it points; none: what it follows is gone.
  [[nodiscard]] std::optional<Pose> pose_at(std::uint32_t emitter, double time) const;
  /// Distance led up to here in this step; what lies before the first cycle does not count [m].
  [[nodiscard]] double led_way(std::uint32_t emitter) const;

  /// An emitter's own moment, and when that is in the world [s].
  struct OwnMoment {
    double time;
    EmitMoment moment;
  };
  /// The next one in the step that is not taken.
  [[nodiscard]] std::optional<OwnMoment> next_moment(const Emitter& emitter) const;
  void queue_moment(std::uint32_t emitter);
  void queue_metre(std::uint32_t emitter);
  /// The box of its rain goes through the step, along a straight way.
  void begin_rain(std::uint32_t emitter);
  void queue_rain(std::uint32_t emitter);

  /// Whether moments of one are taken ahead: nothing between them changes which they are, or their numbers.
  [[nodiscard]] bool sees_ahead(const Firing& first) const;
  /// Takes its first moment, `first`, and those after it that emit one particle each, at most `most`.
  BirthColumns& look_ahead(const Firing& first, std::size_t most);
  [[nodiscard]] bool has_ahead(std::uint32_t emitter) const {
    return s_.ahead[emitter] && !s_.ahead[emitter]->is_over();
  }
  /// One of those that were taken ahead.
  [[nodiscard]] Firing firing_of(std::uint32_t emitter, const BirthColumns& births, std::size_t lane) const;
  /// How many of them come before all else that waits, from the next on, which does.
  [[nodiscard]] std::size_t first_ahead(std::uint32_t emitter, const BirthColumns& births) const;

  void take_steady(Emitter& emitter, std::size_t room, BirthColumns& births) const;
  [[nodiscard]] std::optional<double> when_led(std::uint32_t emitter, double distance) const;
  [[nodiscard]] EmitMoment rain_moment(std::uint32_t emitter, double time, std::uint32_t count) const;

  // ------------------------------------------------------------------------------------------- drawn ahead
  /// What set off a sub-emitter, until others are queued; null: it fires on its own.
  [[nodiscard]] const EmitterTrigger* cause_of(const Firing& firing) const {
    return firing.by == Firing::kNothing ? nullptr : &s_.causes[firing.by];
  }
  [[nodiscard]] const SubEmitter& sub_of(const Firing& firing) const {
    return all_[firing.parent_emitter].def().subs[firing.sub];
  }
  [[nodiscard]] std::uint32_t depth_of(const Firing& firing) const {
    const EmitterTrigger* by = cause_of(firing);
    return by && by->time == by->birth ? by->particle.depth + 1 : 0;
  }

  /// How a moment's births go side by side; null: one by one.
  [[nodiscard]] const BirthPlan* plan_of(const Firing& firing);
  /// How the births of an emitter's own moments go side by side, which are drawn ahead; null: they go one by one.
  [[nodiscard]] const BirthPlan* plan_ahead(const Firing& firing);
  /// Births of a moment, from that one on.
  void look_at_moment(const BirthPlan& plan, const Firing& firing, const Pose& pose, std::uint32_t from);
  /// A lower bound on how many more one may emit by its maximum.
  [[nodiscard]] std::size_t room(const BirthPlan& plan) const;
  /// How many more are not cut.
  [[nodiscard]] std::size_t may_be_born(const Firing& firing) const;

  void queue_triggers() {
    for (const EmitterTrigger& trigger : s_.triggers) {
      const Emitter& parent = all_[trigger.particle.emitter];
      if (!parent.active) continue;
      const auto& subs = parent.def().subs;
      for (std::size_t i = 0; i < subs.size(); ++i)
        if (subs[i].on == trigger.on && (trigger.only == ~0u || trigger.only == i)) queue_sub(parent, i, trigger);
    }
    s_.triggers.clear();
  }
  void queue_sub(const Emitter& parent, std::size_t sub, const EmitterTrigger& trigger) {
    const EmitterId named = parent.def().subs[sub].emitter;
    const EmitterId id = named ? named : all_.id_of(trigger.particle.emitter);
    if (!all_.find(id)) return;  // it was removed
    const std::uint32_t count = parent.emission->fired_by(sub, trigger.particle.number, trigger.particle.events);
    if (count == 0) return;
    s_.causes.push_back(trigger);
    queue_.push({.time = trigger.time,
                 .emitter = id.index,
                 .rank = kSub,
                 .parent = trigger.particle.number,
                 .sub = sub,
                 .parent_emitter = trigger.particle.emitter,
                 .by = static_cast<std::uint32_t>(s_.causes.size() - 1),
                 .order = found_++,
                 .moment = {.time = 0, .phase = 0, .count = count}});
  }

  // ------------------------------------------------------------------------------------------- being born
  /// Counts the births of a past whose particles are gone by now, where only their number matters: of a steady rate
  /// alone, which never finds its emitter full.
  void skip_gone(std::uint32_t index) {
    Emitter& e = all_[index];
    const EmitterDef& def = e.def();
    const DrawnNumber& lifetime = def.start.lifetime;
    const bool is_rate_alone = def.subs.empty() && def.bursts.empty() && !(def.gun.rounds_per_minute > 0) &&
                               !(def.per_metre > 0) && !def.follows && !e.emission->rain().falls();
    if (!is_rate_alone || !lifetime.curve.empty() || !lifetime.to_curve.empty()) return;
    const Timeline timeline(*e.emission);
    double first = 0, phase = 0;
    if (timeline.steady(e.timeline, {&first, 1}, {&phase, 1}) == 0) return;
    constexpr double kMargin = 2;  // births, which rounding may move
    const double longest = std::max(lifetime.value, lifetime.to.value_or(0)), rate = def.per_second.value;
    if (!(rate * def.cycle.rate * longest + kMargin < def.maximum)) return;
    const double until = (end_ - longest - e.began) * def.cycle.rate - timeline.span(e.timeline.play).first;
    const double gone = std::floor(rate * until) - kMargin;
    if (!(gone > 0 && gone < 1e18)) return;
    const auto count = static_cast<std::uint64_t>(gone);
    timeline.take_steady(e.timeline, count);
    e.born += count;
    e.counts.born += count, e.counts.aged += count;
  }
  /// The next own moment of an emitter, and those that follow before anything else happens.
  void fire_own(const Firing& firing) {
    const std::uint32_t index = firing.emitter;
    const BirthPlan* const plan = plan_ahead(firing);
    if (!plan) {
      Timeline(*all_[index].emission).take(all_[index].timeline);
      queue_moment(index);
      return fire(firing);
    }
    BirthColumns& births = *s_.ahead[index];
    for (std::size_t left = first_ahead(index, births); left > 0 && s_.triggers.empty();) {
      const Pose& pose = births.pose[births.one_pose ? 0 : births.next];
      left -= bear_next(*plan, births, firing_of(index, births, births.next), pose, left);
    }
    queue_moment(index);
  }
  /// The next births: several at once if possible, at most `most`; returns how many.
  std::uint32_t bear_next(const BirthPlan& plan, BirthColumns& births, const Firing& firing, const Pose& pose,
                          std::size_t most) {
    most = std::min({most, room(plan), may_be_born(firing)});
    Particle like{.depth = depth_of(firing)};
    if (cause_of(firing)) inherit(firing, like);
    const auto born = static_cast<std::uint32_t>(batches_.bear(plan, births, most, like));
    (cause_of(firing) ? s_.births : s_.own_births[firing.emitter]) += born;
    if (born > 0) return born;
    bear(firing, pose, births.of_moment[births.next]);
    ++births.next;
    return 1;
  }
  [[nodiscard]] Pose pose_of(const Firing& firing) const {
    const EmitterTrigger& by = *cause_of(firing);
    const Emitter& e = all_[firing.emitter];
    const std::optional<MotionState> on_way = e.on_way(firing.time);
    Pose pose{by.at.position, on_way ? on_way->rotation : e.at.rotation, by.at.velocity};
    const SubAxis axis = sub_of(firing).axis;
    const Vec3d along = axis == SubAxis::velocity ? by.at.velocity : axis == SubAxis::normal ? by.normal : Vec3d{};
    if (length(along) > 0) pose.rotation = looking_along(along);
    return pose;
  }

  /// Those alive at that moment: some of them have left since.
  [[nodiscard]] std::uint64_t alive_at(std::uint32_t index, double time) {
    for (const auto& departure : s_.departures) later_[departure.emitter].push(departure.time);
    departed_ += s_.departures.size();
    s_.departures.clear();
    auto& later = later_[index];
    while (!later.empty() && later.top() <= time) later.pop();
    return all_[index].counts.alive + later.size();
  }
  /// Whether there is room for one more, which the oldest may have to make.
  bool has_room(std::uint32_t index, double time) {
    Emitter& e = all_[index];
    if (e.def().when_full == WhenFull::refuse) {
      const std::uint64_t most = e.counts.alive + departed_ + s_.departures.size();  // if all had left later
      return most < e.def().maximum || alive_at(index, time) < e.def().maximum;
    }
    if (e.counts.alive < e.def().maximum) return true;
    const ProjectileId oldest = all_.oldest(index);
    PHYSIM_ASSERT(oldest);
    all_.leave(oldest.index, &EmitterCounts::replaced);
    w_.retire(oldest.index, Reason::replaced);
    return true;
  }

  /// Whether it is one too many. An emitter that reaches a limit without a trigger stops.
  bool is_cut(const Firing& firing) {
    const bool is_over = is_past_ && watch_.has_flown_most();
    if (cause_of(firing)) return is_over || depth_of(firing) > kDeepest || ++s_.births > kMostBirthsInStep;
    const std::uint32_t most = is_past_ ? kMostBirthsOfPast : kMostBirthsInStep;
    if (!is_over && ++s_.own_births[firing.emitter] <= most) return false;
    all_[firing.emitter].plays = false;
    return true;
  }
  void bear(const Firing& firing, const Pose& pose, std::uint32_t of_moment) {
    Emitter& e = all_[firing.emitter];
    if (is_cut(firing)) return void(++e.counts.cut);
    const EmitMoment& m = firing.moment;
    const Birth birth{e.born++, m.time, m.phase, of_moment, m.count, m.is_round, m.round};
    std::optional<BodyState> in_rain;
    if (firing.rank == kRain || firing.rank == kFill) {
      in_rain = rain_.candidate(firing.emitter, birth, firing.rank == kFill, firing.time, pose.rotation);
      if (!in_rain) return;
    }
    if (!has_room(firing.emitter, firing.time)) return void(++e.counts.refused);
    const Newborn newborn = e.emission->newborn(birth);
    if (is_past_ && e.def().subs.empty() && firing.time + newborn.lifetime <= end_) {
      ++e.counts.born, ++e.counts.aged;
      return append(s_.departures, {firing.emitter, firing.time + newborn.lifetime});  // it need not be flown
    }
    const KindId kind = newborn.tracer ? e.def().gun.tracer : e.def().kind;
    Launch launch = launch_of(firing, pose, birth.number, newborn);
    if (in_rain) launch.position = in_rain->position;
    if (in_rain && length(in_rain->velocity) > 0) launch.velocity = in_rain->velocity;
    const Result<ProjectileId> id =
        w_.spawn(kind, launch, {.moment = firing.time, .gravity = newborn.gravity, .emitter = firing.emitter});
    if (!id) return void(++e.counts.refused);
    ++e.counts.born;
    Particle particle{.emitter = firing.emitter,
                      .number = birth.number,
                      .phase = birth.phase,
                      .dies = std::max(firing.time + newborn.lifetime, std::nextafter(firing.time, kInfinity)),
                      .depth = depth_of(firing)};
    if (cause_of(firing)) inherit(firing, particle);
    all_.join(*id, particle, firing.time, end_);
    if (!e.def().subs.empty())
      watch_.trigger(id->index, SubEvent::birth, firing.time, w_.state.state_of(*w_.find(*id)), {});
    live_on(*id, firing.time, particle.dies);
  }
  void inherit(const Firing& firing, Particle& particle) const {
    const SubEmitter& sub = sub_of(firing);
    if (!sub.inherit_colour && !sub.inherit_size) return;
    const EmitterTrigger& by = *cause_of(firing);
    const Particle& parent = by.particle;
    const Look look = all_[parent.emitter].emission->look(parent.number, parent.phase, parent.dies - by.birth,
                                                          firing.time - by.birth, length(by.at.velocity));
    if (sub.inherit_colour) particle.colour = times(look.colour, parent.colour);
    if (sub.inherit_size) particle.size = look.size.x * parent.size;
  }
  [[nodiscard]] Launch launch_of(const Firing& firing, const Pose& pose, std::uint64_t number,
                                 const Newborn& newborn) const {
    const EmitterDef& def = all_[firing.emitter].def();
    Launch launch = def.launch;
    launch.position = pose.position + rotate(pose.rotation, newborn.place);
    const Vec3d direction = rotate(pose.rotation, newborn.direction);
    const double inherited = cause_of(firing) ? sub_of(firing).inherit_velocity : def.inherit_velocity;
    Vec3d velocity = direction * newborn.speed + pose.velocity * inherited;
    const FlightLaw& law = all_[firing.emitter].emission->flight();
    if (law.adds_velocity()) velocity += law.added_velocity({.number = number}, 0);
    if (length(velocity) > 0) {
      launch.velocity = velocity;
      return launch;
    }
    // At rest its bore says where it points.
    launch.velocity.reset();
    launch.speed = 0;
    launch.elevation = asin(std::clamp(direction.y, -1.0, 1.0));
    launch.azimuth = atan2(direction.z, direction.x);
    return launch;
  }

  /// From its birth to the end of the step.
  void live_on(ProjectileId id, double birth, double dies) {
    if (birth >= end_) return;
    if (is_past_) return watch_.grow_up(id.index, birth, dies);
    const double born = watch_.passed_at(birth);
    watch_.look_ahead(id.index, born, birth, std::min(end_, dies));
    if (dies <= end_)
      watch_.end_life(id.index, born, dies);
    else
      watch_.fly_newborn(id.index, born);
  }

  // ------------------------------------------------------------------------------------------- the end
  void go_on_legs(Emitter& e) {
    const MotionState there = e.lead.at(end_);
    e.at = {there.position, there.rotation, 1};
    double counted = e.travelled;
    e.lead.pass(end_, e.counted_from(), counted);
    if (e.plays) e.travelled = counted;
  }
  void finish(std::uint32_t index) {
    Emitter& e = all_[index];
    if (!e.active) return;
    const double rate = e.def().cycle.rate, last = Timeline(*e.emission).span(e.timeline.play).second;
    if (!e.odometer && e.plays) e.travelled += led_way(index);
    if (e.to) e.at = *std::exchange(e.to, std::nullopt);
    if (!e.lead.empty()) go_on_legs(e);
    if (e.def().follows && !w_.find(e.def().follows)) e.plays = false;
    if (e.plays && e.began + last / rate <= end_) e.plays = false;
    if (e.emission->rain().falls()) {
      const bool is_led = e.path || e.def().follows;
      const std::optional<Pose> pose = is_led ? pose_at(index, end_) : std::nullopt;
      rain_.end(index, pose ? pose->position : e.at.position);
    }
    note_trails(index);
    if (!e.plays && e.def().cycle.stop == StopAction::remove && e.plays_before > 0 && e.counts.alive == 0)
      all_.erase(index);
  }

  void note_trails(std::uint32_t index) {
    Emitter& e = all_[index];
    if (e.def().trail.points == 0) return;
    e.trails.drop([&](std::uint32_t slot, std::uint64_t number) {
      const Particle* particle = all_.particle(slot);
      return !particle || particle->emitter != index || particle->number != number;
    });
    all_.each_particle_of(index, [&](std::uint32_t slot, const Particle& particle) {
      const Slot& of = w_.state.slots[slot];
      const Rows& rows = w_.state.rows_of(of);
      const double before = std::max(context_.time, w_.state.slots.birth(slot));
      e.trails.note(e.def().trail, slot, particle.number, {rows.previous(of.row), before},
                    {rows.position(of.row), end_});
    });
  }

  WorldImpl& w_;
  const SettleContext& context_;
  Emitters& all_;
  EmitterScratch& s_;
  double end_;            // of the step [s]
  bool is_past_ = false;  // the step is the time before the world's
  FiringQueue queue_;
  RainStep rain_;
  BirthBatches batches_;
  std::uint64_t departed_ = 0;  // particles that left in this step and were asked about
  EmitterWatch watch_;
  std::uint64_t found_ = 0;
  // When particles of each emitter left in this step, for emitters that had to check.
  std::unordered_map<std::uint32_t, std::priority_queue<double, std::vector<double>, std::greater<>>> later_;
};

// ------------------------------------------------------------------------------------------- where they are
std::optional<Pose> EmitterBirths::pose_at(std::uint32_t index, double time) const {
  PHYSIM_ASSERT(index > 0 && index < all_.size() && index < s_.led.size());
  const Emitter& e = all_[index];
  const std::optional<Led>& led = s_.led[index];
  if (e.def().follows && (!led || (led->is_left && time > led->way.end()))) return std::nullopt;
  const bool is_on_legs = !e.lead.empty() && !is_past_;
  if (!e.path && !led && !is_on_legs) return Pose{e.at.position, e.at.rotation, {}};
  if (e.def().follows && led->by_launch && !is_past_ && time <= led->by_launch->until) {
    const LedByLaunch& by = *led->by_launch;
    const State<double> at = closed_form(w_.registry.cohort(by.cohort).conditions, by.body, time - by.launched);
    return Pose{at.x, e.at.rotation, at.v};
  }
  const MotionState at = !led ? *e.on_way(time) : led->path->at(is_past_ ? led->way.end() : time);
  return Pose{at.position, e.def().follows ? e.at.rotation : at.rotation, at.velocity};
}

void EmitterBirths::close_ways() {
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

void EmitterBirths::queue_moment(std::uint32_t index) {
  PHYSIM_ASSERT(index < s_.ahead.size());
  const Emitter& e = all_[index];
  if (!e.active || !e.plays) return;
  if (has_ahead(index)) return queue_.push(firing_of(index, *s_.ahead[index], s_.ahead[index]->next));
  if (const auto next = next_moment(e))
    queue_.push({.time = next->time, .emitter = index, .rank = kOwnMoment, .moment = next->moment});
}

std::optional<EmitterBirths::OwnMoment> EmitterBirths::next_moment(const Emitter& e) const {
  const auto moment = Timeline(*e.emission).next(e.timeline);
  if (!moment) return std::nullopt;
  const double time = e.began + moment->time / e.def().cycle.rate;
  if (time > end_) return std::nullopt;
  return OwnMoment{std::max(time, context_.time), *moment};
}

void EmitterBirths::queue_metre(std::uint32_t index) {
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

/// The time at which the distance is reached, if calls or a projectile lead the emitter.
std::optional<double> EmitterBirths::when_led(std::uint32_t index, double distance) const {
  const std::optional<Led>& led = s_.led[index];
  if (!led || !led->odometer) return std::nullopt;
  const double left = distance - all_[index].travelled, to = std::min(led->way.end(), end_);
  return left > 0 ? led->odometer->when(left, to) : led->odometer->from();
}

double EmitterBirths::led_way(std::uint32_t index) const {
  const std::optional<Led>& led = s_.led[index];
  if (!led || !led->odometer) return 0;
  const double to = std::min(led->way.end(), end_);
  return to > led->odometer->from() ? led->odometer->at(to) : 0;
}

void EmitterBirths::begin_rain(std::uint32_t index) {
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

void EmitterBirths::queue_rain(std::uint32_t index) {
  if (const std::optional<double> time = rain_.next(index))
    queue_.push({.time = *time, .emitter = index, .rank = kRain, .moment = rain_moment(index, *time, 1)});
}

EmitMoment EmitterBirths::rain_moment(std::uint32_t index, double time, std::uint32_t count) const {
  const Emitter& e = all_[index];
  const double own = (time - e.began) * e.def().cycle.rate;
  return {.time = own, .phase = Timeline(*e.emission).phase_at(e.timeline.play, own), .count = count};
}

// ------------------------------------------------------------------------------------------- several at a time
bool EmitterBirths::sees_ahead(const Firing& first) const {
  const EmitterDef& def = all_[first.emitter].def();
  return !is_past_ && lets_out_one(first.moment) && !def.follows && !(def.per_metre > 0) &&
         !all_[first.emitter].emission->rain().falls();
}

BirthColumns& EmitterBirths::look_ahead(const Firing& first, std::size_t most) {
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
void EmitterBirths::take_steady(Emitter& e, std::size_t room, BirthColumns& births) const {
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

Firing EmitterBirths::firing_of(std::uint32_t index, const BirthColumns& births, std::size_t lane) const {
  PHYSIM_ASSERT(lane < births.count);
  return {.time = births.time[lane],
          .emitter = index,
          .rank = kOwnMoment,
          .moment = {.time = births.own_time[lane], .phase = births.phase[lane]}};
}

std::size_t EmitterBirths::first_ahead(std::uint32_t index, const BirthColumns& births) const {
  PHYSIM_ASSERT(!births.is_over());
  std::size_t lane = births.next + 1;
  const double until = queue_.next_time();
  while (lane < births.count && (births.time[lane] < until || queue_.comes_before_all(firing_of(index, births, lane))))
    ++lane;
  return lane - births.next;
}

// ------------------------------------------------------------------------------------------- drawn ahead
const BirthPlan* EmitterBirths::plan_of(const Firing& firing) {
  const bool is_many = firing.moment.count >= kFew && !firing.moment.is_round;
  return is_many && !is_past_ && firing.rank != kRain && firing.rank != kFill ? batches_.plan(firing.emitter) : nullptr;
}

const BirthPlan* EmitterBirths::plan_ahead(const Firing& firing) {
  const BirthPlan* const plan = batches_.plan(firing.emitter);
  if (!plan || has_ahead(firing.emitter)) return plan;
  if (!sees_ahead(firing)) return nullptr;
  BirthColumns& births = look_ahead(firing, may_be_born(firing));
  if (births.count >= kFew && room(*plan) > 0) batches_.prepare(*plan, births);
  return plan;
}

void EmitterBirths::look_at_moment(const BirthPlan& plan, const Firing& firing, const Pose& pose, std::uint32_t from) {
  BirthColumns& b = s_.together;
  b.begin();
  if (room(plan) == 0) return;
  const EmitMoment& m = firing.moment;
  b.count = std::min<std::size_t>(BirthColumns::kLanes, m.count - from);
  b.pose[0] = pose, b.one_pose = true;
  b.inherited = cause_of(firing) ? sub_of(firing).inherit_velocity : all_[firing.emitter].def().inherit_velocity;
  for (std::uint32_t lane = 0; lane < b.count; ++lane) {
    b.number[lane] = all_[firing.emitter].born + lane;
    b.own_time[lane] = m.time, b.phase[lane] = m.phase;
    b.of_moment[lane] = from + lane, b.moment[lane] = m.count;
    b.time[lane] = firing.time;
  }
  batches_.prepare(plan, b);
}

std::size_t EmitterBirths::room(const BirthPlan& plan) const {
  PHYSIM_ASSERT(plan.kind != 0 && plan.emitter < all_.size());
  const bool refuses = all_[plan.emitter].def().when_full == WhenFull::refuse;
  return batches_.room(plan, refuses ? departed_ + s_.departures.size() : 0);
}

std::size_t EmitterBirths::may_be_born(const Firing& firing) const {
  const std::uint32_t born = cause_of(firing) ? s_.births : s_.own_births[firing.emitter];
  if (cause_of(firing) && depth_of(firing) > kDeepest) return 0;
  return kMostBirthsInStep - std::min(kMostBirthsInStep, born);
}

/// What settling would need between two steps.
SettleContext now_of(WorldImpl& world) {
  SettleContext context = world.settle_context(world.state.clock.dt);
  context.pairs = false;
  return context;
}

SettleContext alone(SettleContext context) {
  context.pairs = false;
  context.taken = nullptr;
  return context;
}

}  // namespace

void begin_emitters(WorldImpl& world, double dt) {
  if (world.state.emitters.empty()) return;
  world.emitting.triggers.clear();
  world.emitting.departures.clear();
  world.emitting.births = 0;
  const SettleContext context = alone(world.settle_context(dt));
  EmitterWatch step(world, context, world.state.clock.next());
  step.note_followed();
  step.reach_ages();
  step.end_lives();
}

void fly_launched(WorldImpl& world, const SettleContext& context, std::uint32_t slot, double time) {
  const SettleContext own = alone(context);
  EmitterWatch step(world, own, world.state.clock.time());
  step.begin_following(slot, time);
  const double passed = step.passed_at(time);
  if (passed < own.dt) step.fly_newborn(slot, passed);
}

void watch_for_emitters(WorldImpl& world, const SettleContext& context) {
  if (world.state.emitters.empty()) return;
  const SettleContext own = alone(context);
  EmitterWatch step(world, own, world.state.clock.time());
  for (std::size_t i = 0; i < world.scratch.chunk_count; ++i) step.watch(world.scratch.chunks[i]);
  step.watch(world.forced_scratch.chunk);
  step.watch(world.pairs.chunk);
  step.follow_to_end();
}

void fire_emitters(WorldImpl& world, const SettleContext& context) {
  if (world.state.emitters.empty()) return;
  const SettleContext own = alone(context);
  EmitterBirths step(world, own, world.state.clock.time());
  for (const Event& apex : world.jointed.apexes) step.watch().watch(apex);
  step.fire();
}

void fire_past(WorldImpl& world, std::uint32_t index) {
  const Restored<const Gate*> asking(Gate::in_question, &world);  // functions of one's own change nothing meanwhile
  world.is_stirred = false;                                       // a newborn row has its own clear way
  world.emitting.births = 0;
  SettleContext context = now_of(world);
  const double now = context.time;
  context.time = world.state.emitters[index].began;
  context.dt = now - context.time;
  EmitterBirths step(world, context, now);
  step.watch().note_followed();
  step.fire_past(index);
}

std::size_t fire_now(WorldImpl& world, std::uint32_t index, std::uint32_t count) {
  world.emitting.births = 0;
  const SettleContext context = now_of(world);
  EmitterBirths step(world, context, context.time);
  step.watch().note_followed();
  step.close_ways();
  const Emitter& e = world.state.emitters[index];
  const std::uint64_t before = e.counts.born;
  const double own = e.plays ? (context.time - e.began) * e.def().cycle.rate : 0;
  step.fire({.time = context.time,
             .emitter = index,
             .moment = {own, Timeline(*e.emission).phase_at(e.timeline.play, own), count}});
  const std::uint64_t born = e.counts.born - before;
  step.work_off();
  return static_cast<std::size_t>(born);
}

void trigger_now(WorldImpl& world, std::uint32_t index) {
  world.emitting.births = 0;
  const SettleContext context = now_of(world);
  EmitterBirths step(world, context, context.time);
  step.watch().note_followed();
  step.close_ways();
  step.watch().trigger_all(index);
  step.work_off();
}

void leave_after_step(WorldImpl& world, std::uint32_t slot) {
  if (!world.state.emitters.particle(slot)) return;
  const SettleContext context = now_of(world);
  EmitterWatch(world, context, world.state.clock.time()).leave_now(slot);
}

}  // namespace physim
