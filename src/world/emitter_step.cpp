#include "world/emitter_step.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

#include "base/append.hpp"
#include "base/restored.hpp"
#include "emit/flight_law.hpp"
#include "math/elementary.hpp"
#include "world/emitter_ahead.hpp"
#include "world/emitter_watch.hpp"
#include "world/world_impl.hpp"

namespace physim {
namespace {

/// Births of a past, most of which nobody has to fly.
constexpr std::uint32_t kMostOfPast = 1u << 26;
class EmitterBirths : EmitterAhead {
 public:
  EmitterBirths(WorldImpl& world, const SettleContext& context, double end)
      : EmitterAhead(world, context, end), w_(world), watch_(world, context, end) {
    s_.causes.clear();
  }
  using EmitterAhead::close_ways;

  [[nodiscard]] EmitterWatch& watch() { return watch_; }

  /// All that one has fired before the world's time.
  void fire_past(std::uint32_t index) {
    is_past_ = true;
    close_ways();
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
    s_.departures.clear();  // nobody asks any more who was there
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
    for (std::uint32_t i = 0; i < firing.moment.count && e.counts.cut == cut;) {
      if (plan && together.is_over()) look_at_moment(*plan, firing, *pose, i);
      if (!together.is_over()) {
        i += bear_next(*plan, together, firing, *pose, together.count - together.next);
      } else {
        bear(firing, *pose, i);
        ++i;
      }
    }
  }

 private:
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
  /// The next moment of an emitter by itself, and those that come after it before anything else does.
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
  /// The next of them: some at once where that may be, at most so many; how many.
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

  /// One too many. An emitter that lets out so many by itself stops.
  bool is_cut(const Firing& firing) {
    if (cause_of(firing)) return depth_of(firing) > kDeepest || ++s_.births > kMostBirths;
    if (++s_.own_births[firing.emitter] <= (is_past_ ? kMostOfPast : kMostBirths)) return false;
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
      return append(s_.departures, {firing.emitter, firing.time + newborn.lifetime});  // nobody has to fly it
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
  EmitterWatch watch_;
  std::uint64_t found_ = 0;
  // When particles of each emitter left in this step, where somebody had to ask.
  std::unordered_map<std::uint32_t, std::priority_queue<double, std::vector<double>, std::greater<>>> later_;
};

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
  EmitterBirths(world, own, world.state.clock.time()).fire();
}

void fire_past(WorldImpl& world, std::uint32_t index) {
  const Restored<const Gate*> asking(Gate::in_question, &world);  // functions of one's own change nothing meanwhile
  world.is_stirred = false;                                       // who is born knows how far it may fly
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
