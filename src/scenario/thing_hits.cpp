#include "scenario/thing_hits.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "collide/seen_hit.hpp"
#include "math/angles.hpp"

namespace physim {
namespace {

void add_hit(ThingHits& to, const ThingHit& hit) {
  ++to.count;
  to.bounces += hit.outcome == EventKind::bounced;
  to.ricochets += hit.outcome == EventKind::ricocheted;
  to.penetrations += hit.outcome == EventKind::penetrated;
  to.stops += hit.outcome == EventKind::stopped;
  to.time.add(hit.time);
  to.x.add(hit.position.x), to.y.add(hit.position.y), to.z.add(hit.position.z);
  to.speed.add(hit.speed());
  to.speed_after.add(hit.speed_after());
  to.obliquity.add(hit.obliquity);
  if (hit.depth > 0) to.depth.add(hit.depth);
}

/// The hit that an event goes on with: of which it is not known yet what became. `last`: the projectile's last one.
ThingHit* open_hit(std::vector<ThingHit>& hits, std::size_t last, const Event& event) {
  ThingHit* first = nullptr;
  for (std::size_t i = 0; i <= last && last < hits.size(); ++i) {
    ThingHit& hit = hits[last - i];
    if (hit.time < event.time) break;
    // Several may be met at one time, at a corner and part behind part; worlds tell all of them before what became.
    const bool is_met = hit.id == event.id && hit.instance == event.instance && hit.primitive == event.primitive;
    if (is_met && hit.outcome == EventKind::hit) first = &hit;
  }
  return first;
}

}  // namespace

double ThingHit::speed() const {
  const IeeeMode mode;
  return length(velocity - surface_velocity);
}
double ThingHit::speed_after() const {
  const IeeeMode mode;
  return outcome == EventKind::stopped ? 0 : length(velocity_after - surface_velocity);
}

ThingHit SceneOfRun::hit(const Launched& launched, const Event& event, double radius, const Scene& scene) const {
  PHYSIM_ASSERT(scenario != nullptr);
  ThingHit hit{.launched = launched, .id = event.id, .time = event.time, .position = event.position};
  hit.velocity = hit.velocity_after = event.velocity;
  hit.instance = event.instance;
  hit.primitive = event.primitive;
  const auto thing = scene.instance(event.instance);
  if (thing && thing->user_data < scenario->things.size()) hit.thing = static_cast<std::size_t>(thing->user_data);
  hit.surface_velocity = surface_velocity(scene, event, radius, event.time);
  hit.obliquity = obliquity_of(event.velocity - hit.surface_velocity, event.normal);
  if (event.kind == EventKind::left) hit.obliquity = kPi - hit.obliquity;  // it goes outwards
  const auto known = std::ranges::find(materials, event.material);
  if (known != materials.end()) hit.material = static_cast<std::size_t>(known - materials.begin());
  return hit;
}

const ThingHit* take_event(std::vector<ThingHit>& hits, Track& track, const CollisionDef& collision,
                           const SceneOfRun& run, const Event& event, const Scene& scene) {
  if (!event.instance) return nullptr;  // only what is met has one
  const EventKind kind = event.kind;
  if (kind == EventKind::entered || kind == EventKind::left || kind == EventKind::sensed) {
    hits.emplace_back(run.hit(track.launched, event, collision.radius, scene)).outcome = kind;
    return nullptr;  // told, and not counted: it hit nothing
  }
  if (kind == EventKind::hit) {
    track.hit = hits.size();
    ThingHit& hit = hits.emplace_back(run.hit(track.launched, event, collision.radius, scene));
    const bool stays =
        collision.on_hit == OnHit::stop || collision.on_hit == OnHit::stick || event.reason == Reason::inside;
    if (!stays) return nullptr;
    hit.outcome = EventKind::stopped;
    hit.energy = event.energy;
    hit.velocity_after = {};
    return &hit;
  }
  ThingHit* hit = open_hit(hits, track.hit, event);  // what became of it
  if (hit == nullptr) return nullptr;
  hit->outcome = kind;
  hit->velocity_after = event.velocity;
  hit->depth = event.value;
  hit->energy = event.energy;
  return hit;
}

void drop_contacts(std::vector<ThingHit>& hits) {
  std::erase_if(hits, [](const ThingHit& hit) { return hit.outcome == EventKind::hit; });
}

std::uint64_t Passages::of(std::string_view thing) const {
  if (thing.empty()) return count;
  const auto known = std::ranges::find(by_thing, thing, &std::pair<std::string, std::uint64_t>::first);
  return known == by_thing.end() ? 0 : known->second;
}

void count_passage(Passages& passages, const ThingHit& hit, const Scenario& scenario) {
  if (hit.outcome != EventKind::sensed && hit.outcome != EventKind::entered) return;
  ++passages.count;
  if (hit.thing == ThingHit::kNone) return;
  PHYSIM_ASSERT(hit.thing < scenario.things.size());
  const std::string& name = scenario.things[hit.thing].name;
  auto of_thing = std::ranges::find(passages.by_thing, name, &std::pair<std::string, std::uint64_t>::first);
  if (of_thing == passages.by_thing.end()) of_thing = passages.by_thing.insert(of_thing, {name, 0});
  ++of_thing->second;
}

void count_hit(ThingHits& on_things, std::vector<ThingHits>& by_thing, const ThingHit& hit, const Scenario& scenario) {
  add_hit(on_things, hit);
  if (hit.thing == ThingHit::kNone) return;
  const std::string& name = scenario.things[hit.thing].name;
  auto of_thing = std::ranges::find(by_thing, name, &ThingHits::thing);
  if (of_thing == by_thing.end()) {
    by_thing.emplace_back().thing = name;
    of_thing = by_thing.end() - 1;
  }
  add_hit(*of_thing, hit);
}

}  // namespace physim
