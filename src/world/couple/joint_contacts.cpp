#include "world/couple/joint_contacts.hpp"

#include "base/assert.hpp"
#include "collide/contact_rules.hpp"
#include "collide/engine.hpp"
#include "collide/scene_by_motion.hpp"
#include "model/ladder.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// Balls are cast as ones that are smaller by this part of their radius, so that what they lie on is met from outside.
constexpr double kThinner = 1e-6;

/// Over a flat Earth. On others it is put on the ground as the next step begins.
std::optional<NetContact> ground_on_way(const WorldImpl& w, const Slot& slot, const Vec3d& from, const Vec3d& to) {
  const Ground& ground = w.def.ground;
  const bool is_flat = w.registry.cohort(slot.cohort).key.fidelity.earth == EarthModel::flat;
  if (ground.mode != GroundMode::bounce || !is_flat || !(to.y < ground.height)) return std::nullopt;
  const double part = from.y > ground.height ? (from.y - ground.height) / (from.y - to.y) : 0;
  Vec3d place = from + (to - from) * part;
  place.y = ground.height;
  const OwnSurface own = OwnSurface::of(w.registry.kind(slot.kind).body);
  return NetContact{{0, 1, 0}, ground.height, place, surface_between(ground, own).restitution};
}

std::optional<NetContact> thing_on_way(const WorldImpl& w, const Slot& slot, const Vec3d& from, const Vec3d& to) {
  const CollisionDef& collision = w.registry.kind(slot.kind).body.collision;
  const Scene* scene = w.state.scene.get();
  if (!scene || !w.registry.cohort(slot.cohort).key.meets || collision.on_hit == OnHit::pass) return std::nullopt;
  const double thinner = collision.radius * kThinner;
  const SceneHit hit = scene->first_hit({from, to, collision.radius - thinner, w.state.clock.time(), 0},
                                        {.layers = collision.layers, .sensors = false});
  if (!hit || !(length(hit.normal) > 0)) return std::nullopt;
  const Vec3d way = to - from;
  if (dot(hit.normal, way) >= 0) return std::nullopt;  // it leaves it
  // Outside of it also when its row has rounded its place.
  PHYSIM_ASSERT(hit.part >= 0 && hit.part <= 1);
  const double skin = thinner + 1e-9 + 4 * w.state.rows_of(slot).layout().epsilon() * length(to);
  NetContact contact{hit.normal, dot(hit.normal, hit.position) + skin, hit.position + hit.normal * skin};
  contact.rests = is_at_rest(*scene, hit.instance);
  const OwnSurface own = OwnSurface::of(w.registry.kind(slot.kind).body);
  if (collision.on_hit == OnHit::bounce)
    contact.restitution = surface_between(scene->material(hit.material), own).restitution;
  return contact;
}

}  // namespace

bool is_at_rest(const Scene& scene, InstanceId thing) {
  return thing.generation != kEngineGeneration && SceneByMotion(scene).rests(thing.index);
}

std::optional<NetContact> contact_on_way(const WorldImpl& w, std::uint32_t index, const Vec3d& from, const Vec3d& to) {
  PHYSIM_ASSERT(index > 0);
  if (from == to) return std::nullopt;
  const Slot& slot = w.state.slots[index];
  const auto ground = ground_on_way(w, slot, from, to), thing = thing_on_way(w, slot, from, to);
  if (!ground || !thing) return ground ? ground : thing;
  return length(ground->place - from) < length(thing->place - from) ? ground : thing;
}

}  // namespace physim
