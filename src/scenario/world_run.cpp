// A scenario's world, step by step: fires what is due, steps, looks at the wall, and counts.
#include "scenario/world_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/archive.hpp"
#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/zero.hpp"
#include "model/force_laws.hpp"
#include "model/sight.hpp"
#include "physim/scenario.hpp"
#include "scenario/checks.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/new_file.hpp"
#include "scenario/scene_maker.hpp"
#include "scenario/suggest.hpp"
#include "scenario/thing_hits.hpp"
#include "scenario/volley.hpp"
#include "scenario/world_run_impl.hpp"

namespace physim {

void Series::add(double value) {
  const IeeeMode mode;
  ++count;
  const double before = value - mean;
  mean += before / static_cast<double>(count);
  squares += before * (value - mean);
  low = std::min(low, value);
  high = std::max(high, value);
}

double Series::spread() const {
  const IeeeMode mode;
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
}

// ----------------------------------------------------------------------------------------------------------- loading
std::string WorldRun::Impl::place_of_shot(std::size_t index) const {
  return scenario.file + ": shot " + in_quotes(scenario.shots[index].projectile.name);
}

Status WorldRun::Impl::load() {
  for (std::size_t i = 0; i < scenario.shots.size(); ++i)
    if (const std::string name = scenario.shots[i].projectile.name; names.is_alone(name))
      if (Status status = add_group(name, i, Volley{}); !status) return status;
  for (const Volley& volley : scenario.volleys)
    if (Status status = add_group(volley.name, index_of_shot(volley.shot), volley); !status) return status;
  for (const ScenarioEmitter& emitter : scenario.emitters)
    if (Status status = add_group(emitter.def.name, index_of_shot(emitter.shot)); !status) return status;
  world.set_observer(scenario.world.observer);
  if (Status status = set_scene(); !status) return status;
  // Springs to a shot need it to exist; all other forces are added first, so that they act on what is fired.
  if (Status status = add_forces(false); !status) return status;
  fire();
  const std::size_t known = world.events().size();
  if (Status status = add_emitters(); !status) return status;
  count(world.events().subspan(known));  // what they fired before the start
  is_loaded = true;
  if (Status status = add_joints(); !status) return status;
  return add_forces(true);
}

Status WorldRun::Impl::set_scene() {
  if (scenario.things.empty()) return {};
  SceneMaker maker(scenario);
  if (Status status = maker.make_all(); !status) return with_place(status.error(), scenario.file);
  materials = maker.materials();
  things = maker.things();
  return world.set_scene(maker.scene());
}

Status WorldRun::Impl::add_forces(bool to_shots) {
  for (const ScenarioForce& force : scenario.forces)
    if (force.other.empty() != to_shots)
      if (Status status = add_force(force); !status)
        return with_place(status.error(), scenario.file + ": force " + in_quotes(force.name));
  return {};
}

Result<KindId> WorldRun::Impl::kind_of(std::size_t index) {
  PHYSIM_ASSERT(index < scenario.shots.size());
  ScenarioShot& shot = scenario.shots[index];
  if (const auto pool = names.pools.find(shot.pool); pool && !shot.pool.empty())
    shot.body.pool = static_cast<std::uint32_t>(*pool);
  shot.body.cheapest_within = shot.cheapest_within.value_or(0);
  const Result<KindId> kind = world.add_kind(shot.projectile, shot.body);
  return kind ? kind : with_place(kind.error(), place_of_shot(index));
}

Status WorldRun::Impl::add_group(const std::string& name, std::size_t index) {
  WorldGroup group;
  group.name = name;
  group.shot = index;
  const Result<KindId> kind = kind_of(index);
  if (!kind) return kind.error();
  group.kind = kinds[index] = *kind;
  groups.push_back(std::move(group));
  return {};
}

Status WorldRun::Impl::add_group(const std::string& name, std::size_t index, const Volley& volley) {
  if (Status status = add_group(name, index); !status) return status;
  const ScenarioShot& shot = scenario.shots[index];
  const auto aimed = aimed_launch(shot.projectile, shot.launch, scenario.environment, shot.projectile.fidelity);
  if (!aimed) return with_place(aimed.error(), place_of_shot(index));
  magazines.push_back({groups.size() - 1, 0, volley, *aimed});
  return {};
}

Status WorldRun::Impl::add_force(const ScenarioForce& force) {
  ForceDef def{.law = force.law, .target = {}, .delay = force.delay, .duration = force.duration};
  if (ProjectileId* end = other_end_of(def.law); end != nullptr && !force.other.empty())
    *end = lone[index_of_shot(force.other)];
  std::vector<ForceTarget> targets;
  if (force.shots.empty() && force.layers == 0) targets.push_back(ForceTarget::everything());
  if (force.layers != 0) targets.push_back({{}, {}, force.layers});
  for (const std::string& name : force.shots)
    if (const KindId kind = kinds[index_of_shot(name)]) targets.push_back({{}, kind, 0});
  for (ForceTarget& target : targets) {
    def.target = std::move(target);
    if (const Result<ForceId> added = world.add_force(def); !added) return added.error();
  }
  return {};
}

/// The last step within the duration is as long as what is left of it [s].
double WorldRun::Impl::coming_step() const {
  const ScenarioWorld& w = scenario.world;
  const std::uint64_t taken = world.counters().steps;
  const double left = w.duration - static_cast<double>(taken) * w.def.step;
  return taken + 1 == steps() && left < (1 - 1e-9) * w.def.step ? left : w.def.step;
}

std::uint64_t WorldRun::Impl::steps() const {
  return static_cast<std::uint64_t>(std::ceil(scenario.world.duration / scenario.world.def.step - 1e-9));
}

// ------------------------------------------------------------------------------------------------------------- firing
void WorldRun::Impl::fire() {
  for (Magazine& magazine : magazines) fire(magazine);
  std::erase_if(magazines, [](const Magazine& m) { return m.fired == static_cast<std::uint64_t>(m.volley.count); });
}

void WorldRun::Impl::fire(Magazine& magazine) {
  const Volley& volley = magazine.volley;
  const double slack = 1e-9 * scenario.world.def.step;  // a launch at 0.1 s belongs to the step that starts there
  const double end = world.time() + coming_step();
  PHYSIM_ASSERT(magazine.group < groups.size());
  WorldGroup& group = groups[magazine.group];
  while (magazine.fired < static_cast<std::uint64_t>(volley.count)) {
    const double moment = volley.start + static_cast<double>(magazine.fired) * volley.interval;
    if (moment >= end - slack) return;
    const double delay = moment > world.time() + slack ? moment - world.time() : 0;
    PHYSIM_ASSERT(delay >= 0 && delay < scenario.world.def.step);
    const Launch launch = scattered(magazine.launch, volley, magazine.fired++);
    std::size_t known = world.events().size();
    if (known > kMostEventsOfCalls / 2) world.forget_events(), known = 0;  // they are counted
    const Result<ProjectileId> spawned = world.spawn(group.kind, launch, delay);
    const std::span<const Event> news = world.events().subspan(known);
    if (!spawned) {
      if (group.refused++ == 0) group.refusal = spawned.error().message;
      count(news);
      continue;
    }
    const ProjectileId id = *spawned;
    const auto born = std::ranges::find(news, EventKind::spawned, &Event::kind);
    const auto before = static_cast<std::size_t>(born - news.begin());
    count(news.first(before));  // it may have taken the place of another; that one's track ends here
    if (tracks.size() <= id.index) tracks.resize(id.index + std::size_t{1});
    tracks[id.index] = {id.generation, {magazine.group, ++launches}, false, world.time() + delay, launch.position};
    count(news.subspan(before));
    if (volley.shot.empty()) lone[group.shot] = id;
  }
}

// ----------------------------------------------------------------------------------------------------------- counting
Track* WorldRun::Impl::track_of(ProjectileId id) {
  if (id.index < tracks.size() && tracks[id.index].generation == id.generation) return &tracks[id.index];
  const auto gone = taken_over.find(id);
  return gone != taken_over.end() ? &gone->second : nullptr;
}

void WorldRun::Impl::touch(Track& track, WorldGroup& group, double time, const Vec3d& position, const Vec3d& velocity) {
  PHYSIM_ASSERT(time > track.since - scenario.world.def.step);  // the track of this flight, and of no later one
  if (track.touched) return;
  track.touched = true;
  const Vec3d way = position - track.from;
  group.range.add(std::sqrt(way.x * way.x + way.z * way.z));
  group.time.add(time - track.since);
  group.speed.add(length(velocity));
}

void WorldRun::Impl::count(std::span<const Event> news) {
  const SceneOfRun scene_of_run{&scenario, materials};
  for (const Event& event : news) {
    Track* track = track_of(event.id);
    if (track == nullptr && event.kind == EventKind::spawned) track = adopt(event);
    if (track == nullptr) continue;
    PHYSIM_ASSERT(track->launched.group < groups.size());
    events.push_back({track->launched, event});
    WorldGroup& group = groups[track->launched.group];
    const Scene* scene = world.scene();
    const CollisionDef& collision = scenario.shots[group.shot].body.collision;
    if (const ThingHit* hit =
            scene ? take_event(thing_hits, *track, collision, scene_of_run, event, *scene) : nullptr) {
      ++group.hits;
      count_hit(group.on_things, group.by_thing, *hit, scenario);
      touch(*track, group, hit->time, hit->position, hit->velocity);
    }
    switch (event.kind) {
      case EventKind::spawned: ++group.spawned; break;
      case EventKind::landed:
        ++group.landed;
        touch(*track, group, event.time, event.position, event.velocity);
        break;
      case EventKind::bounced:
        ++group.bounces;
        touch(*track, group, event.time, event.position, event.velocity);
        break;
      case EventKind::hit:
        if (!event.other) break;  // a thing of the scene
        ++group.hits;
        touch(*track, group, event.time, event.position, event.velocity);
        break;
      case EventKind::apex: group.apex.add(event.position.y); break;
      case EventKind::slept: ++group.slept; break;
      case EventKind::expired: ++group.expired; break;
      case EventKind::retired: ++group.retired; break;
      case EventKind::ground:  // all others are kept in the list of events, and not counted
      case EventKind::range:
      case EventKind::height:
      case EventKind::mach:
      case EventKind::speed:
      case EventKind::time:
      case EventKind::ignition:
      case EventKind::burnout:
      case EventKind::rail_exit:
      case EventKind::woke:
      case EventKind::fidelity_changed:
      case EventKind::entered:
      case EventKind::left:
      case EventKind::sensed:
      case EventKind::ricocheted:
      case EventKind::penetrated:
      case EventKind::stopped:
      case EventKind::stayed: break;
    }
  }
  taken_over.clear();
}

/// Between two steps a path is a parabola: straight, less the sag of its acceleration.
void WorldRun::Impl::look_at_wall(double dt) {
  const double wall = *scenario.world.wall;
  world.segments(segments);
  stopped.clear();
  for (const Segment& s : segments) {
    if (!(s.from.x < wall && s.to.x >= wall)) continue;
    Track* track = track_of(s.id);
    if (track == nullptr) continue;
    const double span = std::min(dt, world.time() - track->since);  // it may have been launched within the step
    const double part = (wall - s.from.x) / (s.to.x - s.from.x), rest = (1 - part) * span;
    PHYSIM_ASSERT(part <= 1);
    const Vec3d a = world[s.id].accelerations().total;
    WallHit hit{track->launched, s.id, world.time() - rest,
                s.from + (s.to - s.from) * part - a * (part * span * rest / 2), world[s.id].velocity() - a * rest};
    hit.position.x = wall;
    hits.push_back(hit);
    stopped.push_back(s.id);
  }
  std::sort(hits.begin(), hits.end(), [](const WallHit& a, const WallHit& b) {
    return a.time != b.time ? a.time < b.time : a.id.index < b.id.index;
  });
  for (const WallHit& hit : hits) {
    WorldGroup& group = groups[hit.launched.group];
    ++group.hits;
    group.hit_y.add(hit.position.y);
    group.hit_z.add(hit.position.z);
    touch(tracks[hit.id.index], group, hit.time, hit.position, hit.velocity);
  }
  PHYSIM_ASSERT(hits.size() == stopped.size());
  const std::size_t known = world.events().size();
  std::sort(stopped.begin(), stopped.end(), [](ProjectileId a, ProjectileId b) { return a.index < b.index; });
  world.despawn(stopped);
  count(world.events().subspan(known));
}

void WorldRun::Impl::step() {
  if (!is_loaded) {
    events.clear();
    fire();
  }
  is_loaded = false;
  hits.clear();
  thing_hits.clear();
  const double dt = coming_step();
  PHYSIM_ASSERT(dt > 0);
  world.step(dt);
  count(world.events());
  drop_contacts(thing_hits);
  if (scenario.world.wall) look_at_wall(dt);
}

// --------------------------------------------------------------------------------------------------------- the public
WorldRun::WorldRun(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WorldRun::WorldRun(WorldRun&&) noexcept = default;
WorldRun& WorldRun::operator=(WorldRun&&) noexcept = default;
WorldRun::~WorldRun() = default;

// ------------------------------------------------------------------------------------------------------------ emitters
Status WorldRun::Impl::add_emitters() {
  const auto order = order_of_emitters(scenario, names.emitters);
  PHYSIM_ASSERT(order.ok());  // circles are refused when a scenario is read
  for (const std::size_t i : *order) {
    const ScenarioEmitter& emitter = scenario.emitters[i];
    const Result<EmitterDef> def = in_world(i);
    if (!def) return def.error();
    const Result<EmitterId> added = world.add_emitter(*def);
    if (!added) return with_place(added.error(), scenario.file + ": emitter " + in_quotes(emitter.def.name));
    group_of(i).emitter = *added;
  }
  return {};
}

/// The emitters of a run are the last of its groups.
WorldGroup& WorldRun::Impl::group_of(std::size_t emitter) {
  PHYSIM_ASSERT(emitter < scenario.emitters.size());
  return groups[groups.size() - scenario.emitters.size() + emitter];
}

/// An emitter with the kinds and ids of this run's world, which has those that its subs name.
Result<EmitterDef> WorldRun::Impl::in_world(std::size_t index) {
  const ScenarioEmitter& emitter = scenario.emitters[index];
  const std::size_t shot = index_of_shot(emitter.shot);
  const Launch& launch = scenario.shots[shot].launch;
  EmitterDef def = def_of(emitter);
  def.kind = group_of(index).kind;
  def.launch.rail_length = launch.rail_length;
  def.launch.attitude = launch.attitude;
  def.launch.spin = launch.spin;
  if (!emitter.follows.empty()) def.follows = lone[index_of_shot(emitter.follows)];
  if (!emitter.tracer.empty()) {
    const Result<KindId> tracer = kind_of(index_of_shot(emitter.tracer));
    if (!tracer) return tracer.error();
    def.gun.tracer = *tracer;
  }
  for (std::size_t i = 0; i < def.subs.size(); ++i)  // none yet: it fires itself
    def.subs[i].emitter = group_of(*names.emitters.find(emitter.subs[i].emitter)).emitter;
  return def;
}

const std::size_t* WorldRun::Impl::group_fired_by(std::uint32_t emitter) {
  const auto known = group_of_emitter.find(emitter);
  if (known != group_of_emitter.end() && groups[known->second].emitter.index == emitter) return &known->second;
  group_of_emitter.clear();
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (groups[i].emitter) group_of_emitter.emplace(groups[i].emitter.index, i);
  const auto found = group_of_emitter.find(emitter);
  return found != group_of_emitter.end() ? &found->second : nullptr;
}

/// The track of what an emitter fired; null where none did.
Track* WorldRun::Impl::adopt(const Event& born) {
  const auto index = static_cast<std::uint32_t>(born.value);  // of the emitter
  const std::size_t* const fired = index == 0 ? nullptr : group_fired_by(index);
  if (fired == nullptr) return nullptr;
  if (tracks.size() <= born.id.index) tracks.resize(born.id.index + std::size_t{1});
  const std::size_t group = *fired;
  if (const Track& before = tracks[born.id.index]; before.generation != 0)
    taken_over.emplace(ProjectileId{born.id.index, before.generation}, before);
  tracks[born.id.index] = {born.id.generation, {group, ++launches}, false, born.time, born.position};
  return &tracks[born.id.index];
}

namespace {

/// The hash of all that a run is made from.
std::uint64_t hash_of_run(const Scenario& scenario) {
  std::uint64_t hash = hash_of(scenario.world.def, scenario.volleys, scenario.forces, scenario.materials,
                               scenario.shapes, scenario.things, scenario.emitters, scenario.joints);
  for (const ScenarioShot& shot : scenario.shots) hash = hash_of(hash, shot.projectile, shot.launch, shot.body);
  return hash;
}

/// Names that lead nowhere and numbers that no enumerator has: a file cannot have them, a program's scenario can.
Status check_parts(const Scenario& scenario) {
  const ScenarioNames names(scenario);
  const std::string& file = scenario.file;
  Checker c;
  for (const Volley& volley : scenario.volleys) {
    c.also(check_named(names.shots, volley.shot, "shot", "volley.shot", file));
    c.named(volley.spread.shape, "volley.spread.shape");
  }
  for (const ScenarioForce& force : scenario.forces) {
    for (const std::string& shot : force.shots) c.also(check_named(names.shots, shot, "shot", "force.shots", file));
    if (!force.other.empty()) c.also(check_lone_shot(names, force.other, "force.other", file));
  }
  for (const ScenarioJoint& joint : scenario.joints) {
    c.also(check_lone_shot(names, joint.a, "joint.a", file));
    if (!joint.b.empty()) c.also(check_lone_shot(names, joint.b, "joint.b", file));
  }
  for (const ScenarioEmitter& emitter : scenario.emitters) {
    c.also(check_named(names.shots, emitter.shot, "shot", "emitter.shot", file));
    if (!emitter.tracer.empty()) c.also(check_named(names.shots, emitter.tracer, "shot", "emitter.gun.tracer", file));
    if (!emitter.follows.empty()) c.also(check_lone_shot(names, emitter.follows, "emitter.follows", file));
    for (const ScenarioSub& sub : emitter.subs)
      c.require(names.emitters.has(sub.emitter), "emitter.sub.emitter", "names no emitter");
  }
  if (!c.status_so_far()) return c.status();
  const auto order = order_of_emitters(scenario, names.emitters);
  return order ? Status() : Status(order.error());
}

/// The world's definition is that of the scenario; one that would never come to an end is refused.
Status prepare(Scenario& scenario) {
  constexpr double kMostSteps = 1e12;
  if (!scenario.world.given) return Error{"the scenario has no [world]", scenario.file, "write [world] into it"};
  scenario.world.def.environment = scenario.environment;
  scenario.world.def.tolerance = scenario.tolerance;
  const double steps = scenario.world.duration / scenario.world.def.step;
  if (!(steps <= kMostSteps))
    return Error{"would take " + rounded_text(steps) + " steps, and a run takes at most 1e12",
                 scenario.file + ": world.duration", "shorten it, or lengthen world.step"};
  return check_parts(scenario);
}

/// A recording must not replace what the scenario comes from, nor may its name until it is complete.
Status check_recording(const Scenario& scenario, const std::string& recording) {
  if (recording.empty()) return {};
  for (const std::string& file : scenario.files)
    if (is_same_file(file, recording) || is_same_file(file, recording + kIncomplete))
      return Error{"cannot record: it would replace " + file + ", which the scenario comes from", recording,
                   "name another file"};
  return {};
}

}  // namespace

Result<WorldRun> WorldRun::create(Scenario scenario, const std::string& recording) {
  const IeeeMode mode;
  if (Status status = prepare(scenario); !status) return status.error();
  if (Status status = check_recording(scenario, recording); !status) return status.error();
  Result<World> world = World::create(scenario.world.def);
  if (!world) return with_place(world.error(), scenario.file);
  if (!recording.empty())
    if (Status status = record_to_file(*world, recording); !status) return status.error();
  auto impl = std::make_unique<Impl>(std::move(scenario), std::move(*world));
  if (Status status = impl->load(); !status) return status.error();
  return WorldRun(std::move(impl));
}

Result<std::vector<std::byte>> WorldRun::save() const {
  const IeeeMode mode;
  const auto world = impl_->world.save();
  if (!world) return world.error();
  return saved_run(*impl_, hash_of_run(impl_->scenario), *world);
}

Result<WorldRun> WorldRun::load(Scenario scenario, std::span<const std::byte> save, const std::string& recording) {
  const IeeeMode mode;
  if (Status status = prepare(scenario); !status) return status.error();
  if (Status status = check_recording(scenario, recording); !status) return status.error();
  Result<SavedRun> saved = read_run(save);
  if (!saved) return saved.error();
  // As a fresh run names its pools and kinds.
  Result<WorldRun> made = create(scenario);
  if (!made) return made.error();
  Impl& run = *made->impl_;
  const bool same = hash_of_run(run.scenario) == saved->scenario && saved->state.groups.size() == run.groups.size() &&
                    saved->state.lone.size() == run.lone.size();
  if (!same)
    return Error{"is of another scenario", "save", "give the scenario, with the same --set, that it was made with"};
  LoadOptions options{.threading = scenario.world.def.threading};
  if (scenario.environment.wind.field) options.wind_fields.push_back(scenario.environment.wind.field);
  if (scenario.environment.force) options.force_fields.push_back(scenario.environment.force);
  Result<World> world = World::load(saved->world, options);
  if (!world) return world.error();
  run.world = std::move(*world);
  static_cast<RunState&>(run) = std::move(saved->state);
  if (!recording.empty())
    if (Status status = record_to_file(run.world, recording, {.from_now = true}); !status) return status.error();
  return made;
}

void WorldRun::step() {
  const IeeeMode mode;
  impl_->step();
}
std::uint64_t WorldRun::steps() const {
  const IeeeMode mode;
  return impl_->steps();
}
World& WorldRun::world() { return impl_->world; }
const World& WorldRun::world() const { return impl_->world; }
const Scenario& WorldRun::scenario() const { return impl_->scenario; }
std::span<const InstanceId> WorldRun::things() const { return impl_->things; }
std::span<const JointId> WorldRun::joints() const { return impl_->joints; }
std::span<const RunEvent> WorldRun::events() const { return impl_->events; }
std::span<const WallHit> WorldRun::hits() const { return impl_->hits; }
std::span<const ThingHit> WorldRun::thing_hits() const { return impl_->thing_hits; }

std::optional<Launched> WorldRun::launched(ProjectileId id) const {
  const Track* track = impl_->track_of(id);
  return track ? std::optional(track->launched) : std::nullopt;
}

std::vector<WorldGroup> WorldRun::groups() const {
  const IeeeMode mode;
  std::vector<WorldGroup> groups = impl_->groups;
  for (const ProjectileId id : impl_->world.ids()) {
    const Track* track = impl_->track_of(id);
    if (track == nullptr) continue;
    WorldGroup& group = groups[track->launched.group];
    const BodyState at = impl_->world[id].state();
    const double part = 1 / static_cast<double>(++group.alive);
    group.position += (at.position - group.position) * part;
    group.velocity += (at.velocity - group.velocity) * part;
    group.mean_speed += (length(at.velocity) - group.mean_speed) * part;
  }
  for (WorldGroup& group : groups) {
    if (!group.emitter) continue;
    group.counts = impl_->world.emitter_counts(group.emitter);
    group.spawned = group.counts.born;
    group.refused = group.counts.refused;
    group.landed = group.counts.landed;
    group.expired = group.counts.expired;
  }
  return groups;
}

RunSnapshot WorldRun::snapshot() const {
  RunSnapshot snapshot;
  snapshot.world_ = impl_->world.snapshot();
  snapshot.state_ = std::make_shared<const RunState>(*impl_);
  return snapshot;
}

bool WorldRun::restore(const RunSnapshot& snapshot) {
  if (!impl_->world.restore(snapshot.world_)) return false;
  PHYSIM_ASSERT(snapshot.state_ != nullptr);  // it is taken with the world
  static_cast<RunState&>(*impl_) = *snapshot.state_;
  return true;
}

}  // namespace physim
