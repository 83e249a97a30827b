#include "world/journal/save.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/archive.hpp"
#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/written_by.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"
#include "world/core/check.hpp"
#include "world/couple/world_impl.hpp"
#include "world/journal/saved.hpp"

namespace physim {
namespace {

constexpr std::size_t kSaveHead = sizeof kSaveMagic + sizeof kSaveFormat + 8;
constexpr std::size_t kSumBytes = 8;

Error not_a_save(const std::string& message) {
  return {message, "save", "World::save() makes them, and `physim run --save`"};
}
Error makes_no_sense(const std::string& what) { return {what + " make no sense", "save", "take another copy of it"}; }

std::uint64_t sum_of(std::span<const std::byte> bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

/// What stands between head and check sum.
Result<std::span<const std::byte>> content_of(std::span<const std::byte> save) {
  if (save.size() < sizeof kSaveMagic || std::memcmp(save.data(), kSaveMagic, sizeof kSaveMagic) != 0)
    return not_a_save("this is not the save of a world");
  Reader head(save.subspan(sizeof kSaveMagic));
  std::uint64_t format = 0, length = 0, sum = 0;
  head.number(format, sizeof kSaveFormat);
  head.number(length, 8);
  if (head.good() && format != kSaveFormat)  // the content begins with the version, whatever the format
    return of_other_format("save", "save", format, kSaveFormat, version_at(save.subspan(kSaveHead)));
  if (save.size() < kSaveHead + kSumBytes || length != save.size() - kSaveHead - kSumBytes)
    return not_a_save("the save was cut, or something follows it");
  const auto content = save.subspan(kSaveHead, static_cast<std::size_t>(length));
  Reader(save.subspan(kSaveHead + content.size())).number(sum, kSumBytes);
  if (sum != sum_of(content)) return not_a_save("the save is damaged");
  return content;
}

/// An error about a save, with the version that wrote it if that was another one.
Error told(Error error, const SavedWorld& saved) { return error.message += by_another_version(saved.made_by), error; }

/// A saved world as it stands in its bytes, and how many functions it has.
Result<FunctionCounts> read(std::span<const std::byte> save, const LoadOptions& options, SavedWorld& into) {
  const auto content = content_of(save);
  if (!content) return content.error();
  Reader reader(*content, options);
  reader(into);
  if (!reader.complete()) return told(makes_no_sense("its bytes"), into);
  FunctionCounts functions = reader.functions_used();
  functions.hit_function =
      std::ranges::any_of(into.kinds, [](const SavedKind& kind) { return kind.body.collision.on_hit == OnHit::ask; });
  return functions;
}

/// A world made from a save. Each part is checked before it is taken: nothing that a save holds may be an
/// index without what it names, or a number that no call would let in.
class Loading {
 public:
  explicit Loading(SavedWorld& saved) : saved_(saved) {}

  Result<std::shared_ptr<WorldImpl>> run(const Threading& threading) {
    saved_.def.threading = threading;
    if (Status status = check(saved_.def); !status) return status.error();
    world_ = std::make_shared<WorldImpl>(saved_.def);
    for (Status (Loading::*part)() : {&Loading::surroundings, &Loading::kinds, &Loading::time, &Loading::slots,
                                      &Loading::rows, &Loading::few, &Loading::pools, &Loading::waiting,
                                      &Loading::generators, &Loading::emitters, &Loading::particles, &Loading::joints})
      if (Status status = (this->*part)(); !status) return status.error();
    state().counters = saved_.counters;
    return std::move(world_);
  }

 private:
  [[nodiscard]] WorldState& state() { return world_->state; }
  [[nodiscard]] bool is_alive(std::uint32_t slot) {
    return slot > 0 && slot < state().slots.size() && state().slots[slot].is(kAlive);
  }

  Status surroundings() {
    if (saved_.environments.empty() || saved_.environments.size() > 4096) return makes_no_sense("its environments");
    for (const Environment& environment : saved_.environments)
      if (Status status = check(environment); !status) return status;
    if (Status status = check(saved_.detail); !status) return status;
    if (!finite(saved_.observer)) return makes_no_sense("its observer's numbers");
    world_->registry.restore_environments(saved_.environments);
    state().detail = saved_.detail;
    state().observer = saved_.observer;
    if (saved_.scene) state().scene = std::make_shared<Scene>(std::move(*saved_.scene));
    world_->registry.meet_scene(state().scene != nullptr);
    return {};
  }

  Status kinds() {
    Registry& registry = world_->registry;
    if (saved_.kinds.size() > kMostKinds) return makes_no_sense("its kinds");
    for (const SavedKind& each : saved_.kinds) {
      const bool fits = each.number > 0 && each.number <= saved_.last_number && !registry.has_kind({each.number}) &&
                        !each.rungs.empty() && each.rungs.size() <= kMostRungs &&
                        each.rungs[0].asked == each.projectile.fidelity;
      if (!fits) return makes_no_sense("its kinds");
      if (Status status = check(each.projectile); !status) return status;
      // Its environment may have been taken back by a restore.
      if (Status status = check(each.body, world_->def, 4096); !status) return status;
      if (auto flown = with_drag_scaled(each.projectile, each.body.drag_scale); !flown) return flown.error();
      Kind kind;
      kind.number = each.number;
      kind.stays = each.stays;
      kind.projectile = each.projectile;
      kind.body = each.body;
      for (const SavedRung& rung : each.rungs) {
        if (!check(Tolerance{}, rung.asked)) return makes_no_sense("its rungs");
        Prepared& prepared = kind.rungs.emplace_back();
        prepared.asked = rung.asked;
        prepared.chosen = rung.chosen;
      }
      registry.add_saved_kind(std::move(kind));
    }
    return {};
  }

  Status time() {
    const Clock& c = saved_.clock;
    constexpr std::uint64_t kMostSteps = std::uint64_t{1} << 62;  // more were never taken
    const bool fits = c.dt > 0 && std::isfinite(c.dt) && c.run_start >= 0 && std::isfinite(c.time()) &&
                      c.steps >= c.epoch && c.steps >= c.run_steps && c.steps < kMostSteps && c.left_over >= 0 &&
                      std::isfinite(c.left_over) && c.time_scale >= 0 && c.time_scale <= 1000;
    if (!fits) return makes_no_sense("its clock's numbers");
    state().clock = c;
    return {};
  }

  Status slots() {
    const std::size_t count = saved_.slots.size() + 1;
    std::vector<bool> is_free(count);
    for (const std::uint32_t index : saved_.free) {
      if (index == 0 || index >= count || is_free[index]) return makes_no_sense("its free slots");
      is_free[index] = true;
    }
    std::size_t alive = 0;
    std::vector<Slot> slots(1);
    for (const SavedSlot& each : saved_.slots) {
      Slot& slot = slots.emplace_back();
      slot.generation = each.generation;
      slot.flags = each.flags;
      const bool named = static_cast<std::size_t>(slot.status()) < enumerators(slot.status()) &&
                         static_cast<std::size_t>(slot.smoothing()) < enumerators(slot.smoothing());
      const bool fits = named && (each.flags & ~kAllFlags) == 0 && slot.is(kAlive) != is_free[slots.size() - 1];
      if (!fits) return makes_no_sense("its slots");
      alive += slot.is(kAlive) ? 1 : 0;
    }
    if (alive > world_->def.max_projectiles) return makes_no_sense("its slots");
    state().slots.restore(std::move(slots), saved_.free);
    return {};
  }

  Status rows() {
    Registry& registry = world_->registry;
    for (std::uint32_t index = 1; index < state().slots.size(); ++index) {
      Slot& slot = state().slots[index];
      const SavedSlot& each = saved_.slots[index - 1];
      state().slots.birth(index) = each.birth;
      state().slots.rest(index) = {each.rest_step, std::bit_cast<float>(each.rest_time)};
      if (!slot.is(kAlive)) continue;
      const std::uint32_t kind = registry.kinds.find({each.kind});
      const bool fits = kind != 0 && registry.has_environment_of(registry.kind(kind)) &&
                        each.rung < registry.kind(kind).rungs.size() && std::isfinite(each.birth);
      if (!fits) return makes_no_sense("its projectiles");
      const Motion motion = registry.kind(kind).rungs[each.rung].in_use.fidelity.motion;
      if (slot.is(kForced) && motion != Motion::force) return makes_no_sense("those that feel forces");
      slot.kind = kind;
      slot.rung = static_cast<std::uint16_t>(each.rung);
      slot.cohort = world_->placement.cohort_for(slot);
      if (slot.cohort == kNoCohort) return makes_no_sense("its cohorts");
      registry.kinds.join(kind);
      slot.row = state().rows[slot.cohort].push(index);
      if (!world_->placement.put_saved(index, each.numbers)) return makes_no_sense("the numbers of its projectiles");
    }
    registry.kinds.go_on_from(saved_.last_number, saved_.idle);
    return {};
  }

  Status few() {
    for (const auto& [slot, own] : saved_.own) {
      if (!is_alive(slot) || !std::isfinite(own.gravity_scale)) return makes_no_sense("its live settings");
      state().extras.own[slot] = own;
    }
    for (const auto& [slot, tags] : saved_.tags) {
      if (!is_alive(slot)) return makes_no_sense("its labels");
      state().extras.tags[slot] = tags;
    }
    for (const auto& [slot, turning] : saved_.turning) {
      if (!is_alive(slot)) return makes_no_sense("its turning projectiles");
      state().extras.turning[slot] = turning;
    }
    return {};
  }

  /// The members of a pool follow from the kinds; the order counts if the oldest make room.
  Status pools() {
    std::vector<bool> in_pool(state().slots.size());
    const auto join = [&](std::uint32_t slot) {
      const std::uint32_t pool = world_->registry.kind(state().slots[slot].kind).body.pool;
      if (in_pool[slot] || state().pools.is_full(pool)) return false;
      in_pool[slot] = true;
      state().pools.join(pool, slot);
      return true;
    };
    for (const std::uint32_t slot : saved_.by_age)
      if (!is_alive(slot) || !join(slot)) return makes_no_sense("its pools");
    bool fits = true;
    state().slots.each_alive([&](std::uint32_t slot) { fits = fits && (in_pool[slot] || join(slot)); });
    return fits ? Status() : makes_no_sense("its pools");
  }

  Status waiting() {
    for (const auto& [list, schedule] :
         {std::pair(&saved_.launches, &state().launches), std::pair(&saved_.old_age, &state().old_age)})
      for (const Due& due : *list) {
        if (std::isnan(due.time) || !due.id) return makes_no_sense("its schedules");
        schedule->add(due.time, due.id);
      }
    return {};
  }

  Status generators() {
    for (const Generator& g : saved_.generators) {
      if (!g.active) continue;
      if (Status status = check(g.def); !status) return status;
      if (std::isnan(g.start) || std::isnan(g.end)) return makes_no_sense("the times of its forces");
    }
    if (!state().generators.restore(saved_.generators, saved_.free_generators, saved_.order_of_generators))
      return makes_no_sense("its forces");
    for (const std::uint32_t index : state().generators.order())
      if (const Generator& g = state().generators[index]; g.begun) world_->resume_generator(index);
    return {};
  }

  [[nodiscard]] static bool is_place(const Transform& at) {
    return finite(at.position) && std::abs(norm(at.rotation) - 1) < 1e-9;
  }
  /// Whether an emitter has done what it had to do by now.
  [[nodiscard]] bool is_up_to_date(const Emitter& e) {
    const double now = state().clock.time(), slack = 1e-9 * (1 + std::abs(now));
    const auto next = Timeline(*e.emission).next(e.timeline);
    if (next && !(e.began + next->time / e.def().cycle.rate >= now - slack)) return false;
    if (!(e.def().per_metre > 0)) return true;
    const double come = e.odometer ? (now > e.odometer->from() ? e.odometer->at(now) : 0) : e.travelled;
    return static_cast<double>(e.metre + 1) >= come * e.def().per_metre * (1 - 1e-9) - 1e-9;
  }

  Status emitters() {
    std::vector<Emitter> all(1);
    for (const SavedEmitter& each : saved_.emitters.all) {
      Emitter& e = all.emplace_back();
      e.generation = each.generation;
      e.active = each.active;
      if (!each.active) continue;
      if (Status status = check(each.def); !status) return status;
      const bool has_kinds = world_->registry.kinds.find(each.def.kind) != 0 &&
                             (each.def.gun.tracer_every == 0 || world_->registry.kinds.find(each.def.gun.tracer) != 0);
      const bool is_there = is_place(each.at) && (!each.to || is_place(*each.to));
      if (!has_kinds || !is_there || !std::isfinite(each.began) || !std::isfinite(each.travelled))
        return makes_no_sense("its emitters");
      world_->equip(e, each.def, each.seed);
      const bool has_played = each.plays || each.plays_before > 0;
      if (has_played && !Timeline(*e.emission).is_of(each.timeline))
        return makes_no_sense("the moments of its emitters");
      e.plays = each.plays;
      e.began = each.began;
      e.timeline = each.timeline;
      e.plays_before = each.plays_before;
      e.born = each.born;
      e.travelled = each.travelled;
      e.metre = each.metre;
      e.first = each.first;
      e.rain = each.rain;
      e.launch = each.launch;
      e.at = each.at;
      e.to = each.to;
      const bool is_led = e.path || each.def.follows || each.to;
      if ((is_led && !each.lead.empty()) || !e.lead.restore(each.lead))
        return makes_no_sense("the ways of its emitters");
      e.counts = each.counts;
      e.counts.alive = 0;
      const auto& launch = each.launch;
      if (launch && !(finite(launch->position) && finite(launch->velocity) && std::isfinite(launch->time)))
        return makes_no_sense("what its emitters follow");
      const bool has_rain = !each.rain.about || finite(*each.rain.about);
      if (!has_rain || !(each.rain.due >= -kRainRounding && each.rain.due <= 1) || each.first > each.born)
        return makes_no_sense("its emitters");
      for (const SavedTrail& trail : each.trails)
        if (!is_alive(trail.slot) || !e.trails.restore(each.def.trail, trail))
          return makes_no_sense("the trails of its emitters");
      world_->count_metres(e);
      if (each.plays && !is_up_to_date(e)) return makes_no_sense("how far its emitters have come");
    }
    const bool fits = state().emitters.restore(std::move(all), saved_.emitters.free, saved_.emitters.added);
    return fits ? Status() : makes_no_sense("the places of its emitters");
  }

  Status particles() {
    Emitters& emitters = state().emitters;
    std::ranges::sort(saved_.emitters.particles, {}, [](const SavedParticle& p) { return p.particle.number; });
    for (const auto& [slot, particle] : saved_.emitters.particles) {
      const bool is_its = is_alive(slot) && particle.emitter > 0 && particle.emitter < emitters.size() &&
                          emitters[particle.emitter].active && !emitters.particle(slot);
      const bool fits = is_its && particle.dies > state().slots.birth(slot) && particle.phase >= 0 &&
                        particle.phase <= 1 && std::isfinite(particle.size);
      if (!fits) return makes_no_sense("its particles");
      emitters.resume(state().slots.id_of(slot), particle);
    }
    for (const auto& [list, schedule] :
         {std::pair(&saved_.emitters.lives, &emitters.lives), std::pair(&saved_.emitters.ages, &emitters.ages)})
      for (const Due& due : *list) {
        if (std::isnan(due.time) || !due.id) return makes_no_sense("the lives of its particles");
        schedule->add(due.time, due.id);
      }
    return {};
  }

  Status joints() {
    std::vector<HeldJoint> all(1);
    for (const SavedJoint& each : saved_.joints) {
      all.push_back({each.generation, each.active, each.def, each.tension, each.is_taut, each.force});
      if (!each.active) continue;
      if (Status status = check(each.def); !status) return status;
      const Joint& def = each.def;
      const bool has_thing = !def.thing || (state().scene && state().scene->state(def.thing));
      const bool holds = is_complete(def) && has_thing && std::isfinite(each.tension) && std::isfinite(each.force) &&
                         world_->find(def.a) && (!def.b || world_->find(def.b));
      if (!holds) return makes_no_sense("its joints");
    }
    const bool fits = state().joints.restore(std::move(all), saved_.free_joints);
    return fits ? Status() : makes_no_sense("the places of its joints");
  }

  SavedWorld& saved_;
  std::shared_ptr<WorldImpl> world_;
};

SavedSlot saved_slot(const WorldImpl& world, std::uint32_t index) {
  const WorldState& state = world.state;
  const Slot& slot = state.slots[index];
  SavedSlot saved;
  saved.generation = slot.generation;
  saved.flags = slot.flags;
  saved.birth = state.slots.birth(index);
  saved.rest_step = state.slots.rest(index).step;
  saved.rest_time = std::bit_cast<std::uint32_t>(state.slots.rest(index).time);
  if (!slot.is(kAlive)) return saved;
  saved.kind = world.registry.kind(slot.kind).number;
  saved.rung = slot.rung;
  saved.numbers = world.placement.saved_numbers(index);
  return saved;
}

SavedKind saved_kind(const Kind& kind) {
  SavedKind saved{kind.number, kind.stays, kind.projectile, kind.body, {}};
  for (const Prepared& rung : kind.rungs) saved.rungs.push_back({rung.asked, rung.chosen});
  return saved;
}

SavedEmitters saved_emitters(const Emitters& emitters) {
  SavedEmitters saved;
  for (std::uint32_t i = 1; i < emitters.size(); ++i) {
    const Emitter& e = emitters[i];
    SavedEmitter& each = saved.all.emplace_back();
    each.generation = e.generation;
    each.active = e.active;
    if (!e.active) continue;
    each.def = e.def();
    each.seed = e.emission->seed();
    each.plays = e.plays;
    each.began = e.began;
    each.timeline = e.timeline;
    each.plays_before = e.plays_before;
    each.born = e.born;
    each.travelled = e.travelled;
    each.metre = e.metre;
    each.first = e.first;
    each.rain = e.rain;
    each.launch = e.launch;
    each.trails = e.trails.saved();
    std::erase_if(each.trails, [&](const SavedTrail& trail) {  // of those that left by a call since the last step
      const Particle* particle = emitters.particle(trail.slot);
      return !particle || particle->emitter != i || particle->number != trail.number;
    });
    each.at = e.at;
    each.to = e.to;
    each.lead = e.lead.keys();
    each.counts = e.counts;
  }
  saved.free = emitters.free();
  saved.added = emitters.added();
  emitters.each_particle([&](std::uint32_t slot, const Particle& p) { saved.particles.push_back({slot, p}); });
  saved.lives = emitters.lives.in_order();
  saved.ages = emitters.ages.in_order();
  return saved;
}

SavedWorld saved_world(const WorldImpl& world) {
  const WorldState& state = world.state;
  SavedWorld saved;
  saved.made_by = kVersion;
  saved.def = world.def;
  saved.environments = world.registry.environments();
  for (const Kind* kind : world.registry.kinds.known()) saved.kinds.push_back(saved_kind(*kind));
  saved.last_number = world.registry.kinds.last_number();
  saved.idle = world.registry.kinds.idle_numbers();
  saved.clock = state.clock;
  for (std::uint32_t index = 1; index < state.slots.size(); ++index) saved.slots.push_back(saved_slot(world, index));
  state.slots.each_free([&](std::uint32_t index) { saved.free.push_back(index); });
  state.pools.each_by_age([&](std::uint32_t slot) { saved.by_age.push_back(slot); });
  for (const auto& [slot, own] : state.extras.own) saved.own.push_back({slot, own});
  for (const auto& [slot, tags] : state.extras.tags) saved.tags.push_back({slot, tags});
  for (const auto& [slot, turning] : state.extras.turning) saved.turning.push_back({slot, turning});
  std::ranges::sort(saved.own, {}, &SavedOwn::slot);  // equal worlds have equal saves
  std::ranges::sort(saved.tags, {}, &SavedTags::slot);
  saved.launches = state.launches.in_order();
  saved.old_age = state.old_age.in_order();
  saved.generators = state.generators.all();
  saved.free_generators = state.generators.free();
  saved.order_of_generators = state.generators.order();
  saved.counters = state.counters;
  saved.observer = state.observer;
  saved.detail = state.detail;
  if (state.scene) saved.scene = *state.scene;
  saved.emitters = saved_emitters(state.emitters);
  for (std::uint32_t i = 1; i < state.joints.size(); ++i) {
    const HeldJoint& joint = state.joints[i];
    saved.joints.push_back({joint.generation, joint.active, joint.def, joint.tension, joint.is_taut, joint.force});
  }
  saved.free_joints = state.joints.free();
  return saved;
}

}  // namespace

Result<std::vector<std::byte>> save_of(const WorldImpl& world) {
  if (world.is_closed()) return from_inside();
  const auto magic = std::as_bytes(std::span(kSaveMagic));
  std::vector<std::byte> bytes(magic.begin(), magic.end());
  Writer writer(bytes);
  writer.write(kSaveFormat);
  writer.number(0, 8);
  writer.write(saved_world(world));
  PHYSIM_ASSERT(writer.good() && bytes.size() >= kSaveHead);
  const std::size_t length = bytes.size() - kSaveHead;
  for (unsigned i = 0; i < 8; ++i) bytes[kSaveHead - 8 + i] = static_cast<std::byte>(std::uint64_t{length} >> (8 * i));
  writer.number(sum_of(std::span(bytes).subspan(kSaveHead)), kSumBytes);
  return bytes;
}

Result<FunctionCounts> functions_of(std::span<const std::byte> save) {
  SavedWorld saved;
  return read(save, {}, saved);
}

Result<std::shared_ptr<WorldImpl>> loaded(std::span<const std::byte> save, const LoadOptions& options) {
  SavedWorld saved;
  const Result<FunctionCounts> functions = read(save, options, saved);
  if (!functions) return functions.error();
  if (Status status = check_given(*functions, options, "the save"); !status) return status.error();
  Result<std::shared_ptr<WorldImpl>> made = Loading(saved).run(options.threading);
  if (!made) return told(made.error(), saved);
  (*made)->hit_asking.set_function(options.hit_function);
  return made;
}

Result<std::vector<std::byte>> World::save() const {
  const IeeeMode mode;
  return save_of(impl());
}

Result<World> World::load(std::span<const std::byte> save, const LoadOptions& options) {
  const IeeeMode mode;
  auto made = loaded(save, options);
  if (!made) return made.error();
  return World(std::move(*made));
}

}  // namespace physim
