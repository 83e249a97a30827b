// Emitters of a world: adding, playing, moving and reading them.
#include <algorithm>
#include <cmath>

#include "base/archive.hpp"
#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "emit/flight_law.hpp"
#include "math/quat.hpp"
#include "world/couple/emitter_step.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

constexpr double kLatestLeg = 1e9;                // of World::lead_emitter() [s]
constexpr double kFastestLeg = 1e9;               // of World::lead_emitter() [m/s]
constexpr std::uint32_t kMostAtOnce = 1'000'000;  // of World::emit()

/// Whether a kind's own rung is moved by forces; auto fidelity finds one that is.
bool feels_pushes(const Kind& kind) {
  return kind.body.cheapest_within > 0 || kind.projectile.fidelity.motion == Motion::force;
}

Error no_emitter() { return {"there is no such emitter", "emitter", "it was removed, or never added"}; }

}  // namespace

/// Whether all that a definition names is there.
Status WorldImpl::refuses(const EmitterDef& asked) const {
  Checker c;
  c.also(check(asked));
  if (!c.status_so_far()) return c.status();  // laws are made of sound numbers only
  const auto is_kind = [this](KindId kind) {
    const std::uint32_t index = registry.kinds.find(kind);
    return index != 0 && registry.has_environment_of(registry.kind(index));
  };
  c.require(is_kind(asked.kind), "emitter.kind", "there is no such kind", "add_kind() makes one");
  c.require(asked.gun.tracer_every == 0 || is_kind(asked.gun.tracer), "emitter.gun.tracer", "there is no such kind",
            "add_kind() makes one");
  if (FlightLaw(asked.flight, 0).acts()) {
    const auto feels = [this](KindId kind) {
      const std::uint32_t index = registry.kinds.find(kind);
      return index == 0 || feels_pushes(registry.kind(index));
    };
    c.require(feels(asked.kind) && (asked.gun.tracer_every == 0 || feels(asked.gun.tracer)), "emitter.flight",
              "its kind flies a closed form, which nothing on the way acts on", "give the kind motion 'force'");
  }
  c.require(!asked.follows || find(asked.follows), "emitter.follows", "there is no such projectile",
            "spawn() makes one");
  for (const SubEmitter& sub : asked.subs)
    c.require(!sub.emitter || state.emitters.find(sub.emitter), "emitter.subs.emitter", "there is no such emitter",
              "add it first");
  return c.status();
}

void WorldImpl::equip(Emitter& emitter, const EmitterDef& asked, std::uint64_t seed) const {
  emitter.emission = std::make_shared<const Emission>(asked, seed);
  EmitterDef named = asked;  // kinds are identified by their content: a number counts those that came before
  named.kind = named.gun.tracer = {};
  emitter.hash = hash_of(named, seed, registry.kinds.hash_of(asked.kind), registry.kinds.hash_of(asked.gun.tracer));
  emitter.drives = emitter.emission->flight().acts();
  if (std::holds_alternative<AtRest>(asked.motion)) return;
  if (auto path = collide::Path::make(asked.motion, {asked.position, asked.rotation, 1}))
    emitter.path = std::make_shared<const collide::Path>(std::move(*path));
}

void WorldImpl::play(std::uint32_t index) {
  Emitter& emitter = state.emitters[index];
  const EmitterCycle& cycle = emitter.def().cycle;
  emitter.plays = true;
  emitter.began = state.clock.time() - (cycle.prewarm ? cycle.duration / cycle.rate : 0);
  emitter.timeline = Timeline(*emitter.emission).begin(emitter.plays_before++);
  emitter.first = emitter.born;
  begin_counting(emitter);
  if (cycle.prewarm) fire_past(*this, index);
}

void WorldImpl::seek(std::uint32_t index, double time) {
  Emitter& emitter = state.emitters[index];
  std::vector<std::uint32_t> slots;
  state.emitters.each_particle_of(index, [&](std::uint32_t slot, const Particle&) { slots.push_back(slot); });
  for (const std::uint32_t slot : slots) retire(slot, Reason::despawned);
  PHYSIM_ASSERT(emitter.counts.alive == 0 && emitter.first <= emitter.born);
  emitter.plays = true;
  emitter.plays_before = std::max<std::uint64_t>(emitter.plays_before, 1);
  emitter.began = state.clock.time() - time;
  emitter.timeline = Timeline(*emitter.emission).begin(emitter.plays_before - 1);
  emitter.born = emitter.first;
  emitter.trails.clear();
  emitter.by_age.clear();
  emitter.oldest = 0;
  begin_counting(emitter);
  if (time > 0) fire_past(*this, index);
  Emitter& now = state.emitters[index];
  if (Timeline(*now.emission).span(now.timeline.play).second / now.def().cycle.rate <= time) now.plays = false;
}

/// Distance and rain, where it begins to play.
void WorldImpl::begin_counting(Emitter& emitter) const {
  // What lies behind on its legs does not count.
  emitter.travelled = 0 - emitter.lead.counted(emitter.counted_from(), state.clock.time());
  emitter.metre = 0;
  emitter.rain = {};
  count_metres(emitter);
}

void WorldImpl::count_metres(Emitter& emitter) const {
  if (!emitter.path || !(emitter.def().per_metre > 0)) return;
  // None of its path counts before its first cycle.
  const double delay = Timeline(*emitter.emission).span(emitter.timeline.play).first;
  emitter.odometer = std::make_shared<const Odometer>(*emitter.path, emitter.began + delay / emitter.def().cycle.rate);
}

Result<EmitterId> World::add_emitter(const EmitterDef& def) {
  WorldImpl& w = impl();
  const Recorded<Call::add_emitter> call(w, def);
  if (call.is_refused()) return call.refusal();
  if (Status status = w.refuses(def); !status) return status.error();
  w.registry.kinds.keep(w.registry.kinds.find(def.kind));
  if (def.gun.tracer) w.registry.kinds.keep(w.registry.kinds.find(def.gun.tracer));
  const std::uint32_t index = w.state.emitters.add();
  Emitter& emitter = w.state.emitters[index];
  Hash own;
  own.add(w.state.emitters.added());
  w.equip(emitter, def, def.seed.value_or(own.value()));
  emitter.at = {def.position, normalized(def.rotation), 1};
  if (def.cycle.plays) w.play(index);
  return call.returns(w.state.emitters.id_of(index));
}

Status World::remove_emitter(EmitterId id) {
  WorldImpl& w = impl();
  const Recorded<Call::remove_emitter> call(w, id);
  if (call.is_refused()) return call.refusal();
  if (!w.state.emitters.find(id)) return no_emitter();
  std::vector<std::uint32_t> its;
  w.state.emitters.each_particle_of(id.index, [&its](std::uint32_t slot, const Particle&) { its.push_back(slot); });
  const bool drove = w.state.emitters[id.index].drives;
  w.state.emitters.erase(id.index);
  for (const std::uint32_t index : its) {
    const Slot& slot = w.state.slots[index];
    w.state.rows_of(slot).note_change(slot.row);
    if (drove) w.update_forced(index);
  }
  return {};
}

Status World::play_emitter(EmitterId id) {
  WorldImpl& w = impl();
  const Recorded<Call::play_emitter> call(w, id);
  if (call.is_refused()) return call.refusal();
  if (!w.state.emitters.find(id)) return no_emitter();
  w.play(id.index);
  return {};
}

Status World::stop_emitter(EmitterId id) {
  WorldImpl& w = impl();
  const Recorded<Call::stop_emitter> call(w, id);
  if (call.is_refused()) return call.refusal();
  Emitter* emitter = w.state.emitters.find(id);
  if (!emitter) return no_emitter();
  emitter->plays = false;
  return {};
}

namespace {

/// Whether a call may put an emitter there.
Status check_move(const Emitter* emitter, const Transform& to) {
  if (!emitter) return no_emitter();
  if (emitter->path || emitter->def().follows)
    return Error{"has a motion, or follows a projectile", "emitter", "move one that stands"};
  const double turned = norm(to.rotation);
  if (!(length(to.position) <= 1e15) || !(turned > 0 && std::isfinite(turned)))
    return Error{"must lie within 1e15 m, with a rotation of a length that is not zero", "to", ""};
  return {};
}

}  // namespace

Status World::move_emitter(EmitterId id, const Transform& to) {
  WorldImpl& w = impl();
  const Recorded<Call::move_emitter> call(w, id, to);
  if (call.is_refused()) return call.refusal();
  Emitter* emitter = w.state.emitters.find(id);
  if (Status status = check_move(emitter, to); !status) return status;
  emitter->leave_lead(w.state.clock.time());
  emitter->to = Transform{to.position, normalized(to.rotation), 1};
  return {};
}

Status World::lead_emitter(EmitterId id, const Transform& to, double time) {
  WorldImpl& w = impl();
  const Recorded<Call::lead_emitter> call(w, id, to, time);
  if (call.is_refused()) return call.refusal();
  Emitter* emitter = w.state.emitters.find(id);
  if (Status status = check_move(emitter, to); !status) return status;
  const MotionKey here{
      .time = w.state.clock.time(), .position = emitter->at.position, .rotation = emitter->at.rotation};
  const MotionKey& from = emitter->lead.empty() ? here : emitter->lead.end();
  const double takes = time - from.time;
  if (!(takes >= EmitterLead::kShortestLeg && time <= kLatestLeg))
    return Error{"must be later than " + short_text(from.time) + " s, when this leg begins, by 1e-6 s or more, and " +
                     "within 1e9 s; " + short_text(time) + " is not",
                 "time", "a time of the world, see World::time(); legs follow each other"};
  if (!(length(to.position - from.position) <= kFastestLeg * takes))
    return Error{"wants a speed above 1e9 m/s", "time", "be there later"};
  emitter->to.reset();
  emitter->lead.go(here, {.time = time, .position = to.position, .rotation = normalized(to.rotation)});
  return {};
}

Status World::jump_emitter(EmitterId id, const Transform& to) {
  WorldImpl& w = impl();
  const Recorded<Call::jump_emitter> call(w, id, to);
  if (call.is_refused()) return call.refusal();
  Emitter* emitter = w.state.emitters.find(id);
  if (Status status = check_move(emitter, to); !status) return status;
  emitter->leave_lead(w.state.clock.time());
  emitter->at = Transform{to.position, normalized(to.rotation), 1};
  emitter->to.reset();
  return {};
}

Status World::seek_emitter(EmitterId id, double time) {
  WorldImpl& w = impl();
  const Recorded<Call::seek_emitter> call(w, id, time);
  if (call.is_refused()) return call.refusal();
  if (!w.state.emitters.find(id)) return no_emitter();
  if (!(time >= 0 && time <= 1e9)) return Error{"must lie between 0 and 1e9 s", "time", "so long ago it began"};
  w.seek(id.index, time);
  return {};
}

Result<std::size_t> World::emit(EmitterId id, std::uint32_t count) {
  WorldImpl& w = impl();
  const Recorded<Call::emit> call(w, id, count);
  if (call.is_refused()) return call.refusal();
  if (!w.state.emitters.find(id)) return no_emitter();
  if (count > kMostAtOnce) return Error{"must not be above a million", "count", "call it again"};
  return fire_now(w, id.index, count);
}

Status World::trigger_emitter(EmitterId id) {
  WorldImpl& w = impl();
  const Recorded<Call::trigger_emitter> call(w, id);
  if (call.is_refused()) return call.refusal();
  if (!w.state.emitters.find(id)) return no_emitter();
  trigger_now(w, id.index);
  return {};
}

// ------------------------------------------------------------------------------------------- reading
std::vector<EmitterId> World::emitters() const {
  const Emitters& all = impl().state.emitters;
  std::vector<EmitterId> ids;
  for (std::uint32_t i = 1; i < all.size(); ++i)
    if (all[i].active) ids.push_back(all.id_of(i));
  return ids;
}
const EmitterDef* World::emitter(EmitterId id) const {
  const Emitter* emitter = impl().state.emitters.find(id);
  return emitter ? &emitter->def() : nullptr;
}
bool World::is_playing(EmitterId id) const {
  const Emitter* emitter = impl().state.emitters.find(id);
  return emitter && emitter->plays;
}
EmitterCounts World::emitter_counts(EmitterId id) const {
  const Emitter* emitter = impl().state.emitters.find(id);
  return emitter ? emitter->counts : EmitterCounts{};
}

namespace {

template <class T>
void put(const Column<T>& column, std::size_t i, const T& value) {
  if (i < column.size()) column[i] = value;
}

}  // namespace

TrailCounts World::trails(EmitterId id, const TrailColumns& into) const {
  const IeeeMode mode;
  const WorldState& state = impl().state;
  const Emitter* emitter = state.emitters.find(id);
  TrailCounts counts;
  if (!emitter || emitter->def().trail.points == 0) return counts;
  const double now = state.clock.time(), since = now - emitter->def().trail.time;
  const auto place = [&](const Vec3d& position, double time) {
    put(into.position, counts.places, position);
    put(into.time, counts.places, time);
    ++counts.places;
  };
  state.emitters.each_particle_of(id.index, [&](std::uint32_t index, const Particle& particle) {
    const std::size_t first = counts.places;
    double last = -kInfinity;
    emitter->trails.each_place(index, particle.number, since, [&](const TrailPlace& at) {
      place(at.position, at.time);
      last = at.time;
    });
    if (last < now) place(state.state_of(state.slots[index]).position, now);
    put(into.id, counts.particles, state.slots.id_of(index));
    put(into.first, counts.particles, static_cast<std::uint32_t>(first));
    put(into.count, counts.particles, static_cast<std::uint32_t>(counts.places - first));
    ++counts.particles;
  });
  return counts;
}

}  // namespace physim
