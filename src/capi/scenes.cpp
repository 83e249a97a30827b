// Scenes: of their own, and of worlds.
#include <algorithm>

#include "base/ieee_mode.hpp"
#include "capi/objects.hpp"
#include "capi/parts.hpp"

namespace physim::capi {
namespace {

/// A scene, or the scene of a world: what changes it goes to one of the two.
struct AnyScene {
  std::shared_ptr<SceneObject> alone;
  std::shared_ptr<WorldObject> of_world;

  /// Null: the world has none.
  [[nodiscard]] const Scene* scene() const {
    PHYSIM_ASSERT((alone == nullptr) != (of_world == nullptr));
    return alone ? &alone->scene : std::as_const(*of_world).world().scene();
  }
  [[nodiscard]] std::vector<InstanceId>& things() const { return alone ? alone->things : of_world->things; }
  Result<InstanceId> add(const InstanceDef& def) const {
    return alone ? alone->scene.add(def) : of_world->world().add_instance(def);
  }
  Status move(InstanceId id, const Transform& to) const {
    return alone ? alone->scene.move(id, to) : of_world->world().move_instance(id, to);
  }
  Status set_motion(InstanceId id, const SceneMotion& motion) const {
    return alone ? alone->scene.set_motion(id, motion) : of_world->world().set_instance_motion(id, motion);
  }
  Status set_layers(InstanceId id, std::uint32_t layers) const {
    return alone ? alone->scene.set_layers(id, layers) : of_world->world().set_instance_layers(id, layers);
  }
  Status set_conveyor(InstanceId id, const ConveyorDef& conveyor) const {
    return alone ? alone->scene.set_conveyor(id, conveyor) : of_world->world().set_instance_conveyor(id, conveyor);
  }
  Status remove(InstanceId id) const { return alone ? alone->scene.remove(id) : of_world->world().remove_instance(id); }
};

/// What a pointer to a scene or world stands for; without a scene, if none is needed, and if the call failed.
AnyScene find_scene(Call& call, const void* handle, bool changes, bool needs_one = true) {
  const Kept found = kept(number_of(handle));
  AnyScene any;
  if (found.kind == Stands<physim_scene>::kName)
    any.alone = std::static_pointer_cast<SceneObject>(found.object);
  else if (found.kind == Stands<physim_world>::kName)
    any.of_world = std::static_pointer_cast<WorldObject>(found.object);
  else
    call.fail_to_find(handle, found, "scene", "physim_scene or physim_world");
  if (any.of_world) call.look_at(any.of_world, changes);
  if (call.ok() && needs_one && any.scene() == nullptr)
    call.fail(PHYSIM_NOT_FOUND, "this world has no scene", "scene", "physim_world_set_scene() gives it one");
  return any;
}

Transform transform_of(Call& call, const physim_transform* given, const char* name = "to") {
  call.need(given, name);
  const physim_transform t = call.read(given, name);
  call.need(is_finite(t.position, 3) && is_finite(t.rotation, 4) && std::isfinite(t.scale), name,
            "has a number that is none");
  return {vector_at(t.position), rotation_at(t.rotation), t.scale != 0 ? t.scale : 1};
}

SceneSegment segment_of(const physim_segment& s) {
  return {vector_at(s.from), vector_at(s.to), s.radius, s.time, s.duration};
}

physim_hit hit_row(const SceneHit& hit) {
  physim_hit out{.thing = put_id(hit.instance),
                 .primitive = hit.primitive,
                 .material = hit.material.index,
                 .entering = hit.entering,
                 .starts_inside = hit.starts_inside,
                 .part = hit.part,
                 .time = hit.time,
                 .position = {},
                 .normal = {},
                 .velocity = {}};
  put(out.position, hit.position);
  put(out.normal, hit.normal);
  put(out.velocity, hit.velocity);
  return out;
}

physim_segment segment_row(const SceneSegment& s) {
  physim_segment out{.from = {}, .to = {}, .radius = s.radius, .time = s.time, .duration = s.duration};
  put(out.from, s.from);
  put(out.to, s.to);
  return out;
}

/// What an engine said about a segment; nothing was met if it named no thing.
SceneHit answer_of(const physim_hit& hit) {
  SceneHit out;
  if (hit.thing.index == 0) return out;
  out.part = hit.part;
  out.normal = vector_at(hit.normal);
  out.velocity = vector_at(hit.velocity);
  out.instance = id_of<InstanceId>(hit.thing);
  out.primitive = hit.primitive;
  out.material.index = hit.material;
  out.entering = hit.entering != 0;
  out.starts_inside = hit.starts_inside != 0;
  return out;
}

void need_each(Call& call, std::size_t each, std::size_t rows) {
  call.need(rows == 0 || each >= sizeof(physim_id), "each", "is not the sizeof of the struct");
}

}  // namespace

EngineQuery engine_of(physim_engine_function function, void* user) {
  if (function == nullptr) return {};
  return [function, user](const EngineBatch& batch) {
    PHYSIM_ASSERT(batch.hits.size() == batch.segments.size());
    std::vector<physim_segment> segments(batch.segments.size());
    std::vector<physim_hit> hits(batch.segments.size());
    std::transform(batch.segments.begin(), batch.segments.end(), segments.begin(), segment_row);
    for (physim_hit& hit : hits) hit.entering = SceneHit{}.entering;
    const physim_engine_batch asked{segments.size(), segments.data(), hits.data(), batch.layers, 0};
    function(user, &asked);
    std::transform(hits.begin(), hits.end(), batch.hits.begin(), answer_of);
  };
}

}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

physim_result physim_scene_create(const physim_def* def, physim_scene** scene) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(scene, "scene");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    Result<SceneParts> parts = scene_parts((*checked)->scenario);
    if (call.take(parts))
      call.give(scene, std::make_shared<SceneObject>(SceneObject{std::move(parts->scene), std::move(parts->things)}));
  });
}

physim_result physim_scene_load(const void* data, size_t size, const physim_functions* functions,
                                physim_scene** scene) {
  return guarded([&](Call& call) {
    const physim_functions given = call.read(functions, "functions");
    call.need(data, "data");
    call.need(scene, "scene");
    if (!call.ok()) return;
    Result<Scene> loaded =
        Scene::load({static_cast<const std::byte*>(data), size}, engine_of(given.engine, given.engine_user));
    if (!call.take(loaded)) return;
    auto made = std::make_shared<SceneObject>();
    made->scene = std::move(*loaded);
    call.give(scene, std::move(made));
  });
}

physim_result physim_scene_set_engine(physim_scene* scene, physim_engine_function function, void* user, double skin) {
  return guarded([&](Call& call) {
    const auto into = call.find(scene, "scene");
    call.need(!std::isnan(skin), "skin", "is not a number");
    if (!call.ok()) return;
    EngineScene engine{.query = engine_of(function, user)};
    if (skin != 0) engine.skin = skin;
    call.take(into->scene.set_engine(engine));
  });
}

physim_result physim_scene_read_engine(const void* scene, physim_engine_info* info) {
  return guarded([&](Call& call) {
    const AnyScene of = find_scene(call, scene, false);
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const EngineCounters counters = of.scene()->engine_counters();
    call.write(info, {.size = 0,
                      .reserved = 0,
                      .calls = counters.calls,
                      .segments = counters.segments,
                      .refused = counters.refused});
  });
}

physim_result physim_world_set_scene(physim_world* world, const physim_scene* scene) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find_or_null(scene, "scene");
    if (!call.ok()) return;
    if (!call.take(from ? into->world().set_scene(from->scene) : into->world().remove_scene())) return;
    into->things = from ? from->things : std::vector<InstanceId>();
  });
}

physim_result physim_scene_add(void* scene, const physim_def* def, physim_id* ids, size_t room, size_t* count) {
  return guarded([&](Call& call) {
    const IeeeMode mode;
    const AnyScene into = find_scene(call, scene, true, false);
    const auto from = call.find(def, "def");
    call.need_rows(ids, room, "ids");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    SceneMaker maker((*checked)->scenario, into.scene() != nullptr ? *into.scene() : Scene());
    if (!call.take(maker.make_all())) return;
    PHYSIM_ASSERT(maker.things().size() == (*checked)->scenario.things.size());
    std::vector<InstanceId> things = into.things();
    things.insert(things.end(), maker.things().begin(), maker.things().end());
    if (into.alone)
      into.alone->scene = maker.scene();
    else if (!call.take(into.of_world->world().set_scene(maker.scene())))
      return;
    into.things() = std::move(things);
    for (std::size_t i = 0; i < std::min(room, maker.things().size()); ++i) ids[i] = put_id(maker.things()[i]);
    if (count != nullptr) *count = maker.things().size();
  });
}

physim_result physim_scene_copy(void* scene, physim_id like, const physim_transform* to, physim_id* id) {
  return guarded([&](Call& call) {
    const AnyScene into = find_scene(call, scene, true);
    const Transform transform = transform_of(call, to);
    call.need(id, "id");
    if (!call.ok()) return;
    std::optional<InstanceDef> def = into.scene()->instance(id_of<InstanceId>(like));
    if (!def) return call.fail(PHYSIM_NOT_FOUND, "there is no such thing", "like");
    def->transform = transform;
    def->motion = AtRest{};
    const Result<InstanceId> added = into.add(*def);
    if (call.take(added)) *id = put_id(*added);
  });
}

physim_result physim_scene_find(const void* scene, const char* name, physim_id* id) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, false);
    call.need(name, "name");
    call.need(id, "id");
    if (!call.ok()) return;
    for (const InstanceId thing : in.things())
      if (const auto def = in.scene()->instance(thing); def && def->name == name) return void(*id = put_id(thing));
    call.fail(PHYSIM_NOT_FOUND, "no thing has this name", name);
  });
}

physim_result physim_scene_move(void* scene, physim_id thing, const physim_transform* to) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, true);
    const Transform transform = transform_of(call, to);
    if (call.ok()) call.take(in.move(id_of<InstanceId>(thing), transform));
  });
}

physim_result physim_scene_set_motion(void* scene, physim_id thing, const physim_motion* motion) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, true);
    const physim_motion m = call.read(motion, "motion");
    if (!call.ok()) return;
    SceneMotion as = AtRest{};
    if (motion != nullptr) as = SteadyMotion{m.start, vector_at(m.velocity), vector_at(m.angular_velocity)};
    call.take(in.set_motion(id_of<InstanceId>(thing), as));
  });
}

physim_result physim_scene_set_layers(void* scene, physim_id thing, uint32_t layers) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, true);
    if (call.ok()) call.take(in.set_layers(id_of<InstanceId>(thing), layers));
  });
}

physim_result physim_scene_set_conveyor(void* scene, physim_id thing, const double velocity[3]) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, true);
    if (!call.ok()) return;
    const ConveyorDef conveyor{velocity == nullptr ? Vec3d{} : vector_at(velocity)};
    call.take(in.set_conveyor(id_of<InstanceId>(thing), conveyor));
  });
}

physim_result physim_scene_remove(void* scene, physim_id thing) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, true);
    if (call.ok()) call.take(in.remove(id_of<InstanceId>(thing)));
  });
}

physim_result physim_scene_cast(const void* scene, const physim_segment* segments, size_t count, uint32_t layers,
                                physim_hit* hits, size_t each, const physim_pool* pool) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, false);
    const auto threads = call.find_or_null(pool, "pool");
    call.need_rows(segments, count, "segments");
    call.need_rows(hits, count, "hits");
    need_each(call, each, count);
    if (!call.ok()) return;
    std::vector<SceneSegment> asked(count);
    std::vector<SceneHit> found(count);
    std::transform(segments, segments + count, asked.begin(), segment_of);
    const Lent lent(threads);
    in.scene()->first_hits(asked, found, {.layers = layers}, lent.runner());
    for (std::size_t i = 0; i < count; ++i) put_row(hits, each, i, hit_row(found[i]));
  });
}

physim_result physim_scene_hits(const void* scene, const physim_segment* segment, uint32_t layers, physim_hit* hits,
                                size_t each, size_t room, size_t* count) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, false);
    call.need(segment, "segment");
    call.need_rows(hits, room, "hits");
    call.need(count, "count");
    need_each(call, each, room);
    if (!call.ok()) return;
    const std::vector<SceneHit> found = in.scene()->all_hits(segment_of(*segment), {.layers = layers});
    for (std::size_t i = 0; i < std::min(room, found.size()); ++i) put_row(hits, each, i, hit_row(found[i]));
    *count = found.size();
  });
}

physim_result physim_scene_nearest(const void* scene, const double point[3], double within, uint32_t layers,
                                   double time, physim_nearest* nearest) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, false);
    call.need(point, "point");
    call.need(within >= 0, "within", "is negative, or not a number");
    call.need(std::isfinite(time), "time", "is not finite");
    call.need_struct(nearest, "nearest");
    if (!call.ok()) return;
    const SceneNearest found = in.scene()->nearest(vector_at(point), within, {.layers = layers}, time);
    if (!found) return call.fail(PHYSIM_NOT_FOUND, "nothing is that near", "within");
    physim_nearest out{};
    out.material = found.material.index;
    out.thing = put_id(found.instance);
    out.distance = found.distance;
    put(out.position, found.position);
    put(out.away, found.away);
    call.write(nearest, out);
  });
}

physim_result physim_scene_overlaps(const void* scene, const double middle[3], double radius, uint32_t layers,
                                    double time, physim_id* ids, size_t room, size_t* count) {
  return guarded([&](Call& call) {
    const AnyScene in = find_scene(call, scene, false);
    call.need(middle, "middle");
    call.need(radius >= 0, "radius", "is negative, or not a number");
    call.need(std::isfinite(time), "time", "is not finite");
    call.need_rows(ids, room, "ids");
    call.need(count, "count");
    if (!call.ok()) return;
    const std::vector<InstanceId> found = in.scene()->overlaps(vector_at(middle), radius, {.layers = layers}, time);
    for (std::size_t i = 0; i < std::min(room, found.size()); ++i) ids[i] = put_id(found[i]);
    *count = found.size();
  });
}

namespace physim::capi {
namespace {

/// Gives ids out, as far as there is room for them.
void give_ids(Call& call, const Result<std::vector<ProjectileId>>& found, physim_id* ids, std::size_t room,
              std::size_t* count) {
  if (!call.take(found)) return;
  for (std::size_t i = 0; i < std::min(room, found->size()); ++i) ids[i] = put_id((*found)[i]);
  *count = found->size();
}

}  // namespace
}  // namespace physim::capi

physim_result physim_world_in_ball(const physim_world* world, const double middle[3], double radius, uint32_t layers,
                                   physim_id* ids, size_t room, size_t* count) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(middle, "middle");
    call.need(radius >= 0, "radius", "is negative, or not a number");
    call.need_rows(ids, room, "ids");
    call.need(count, "count");
    if (call.ok())
      give_ids(call, std::as_const(*of).world().projectiles_in(vector_at(middle), radius, layers), ids, room, count);
  });
}

physim_result physim_world_in_box(const physim_world* world, const physim_transform* at, const double half[3],
                                  uint32_t layers, physim_id* ids, size_t room, size_t* count) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    const Transform transform = transform_of(call, at, "at");
    call.need(half, "half");
    call.need_rows(ids, room, "ids");
    call.need(count, "count");
    if (call.ok())
      give_ids(call, std::as_const(*of).world().projectiles_in(transform, vector_at(half), layers), ids, room, count);
  });
}

physim_result physim_world_cast(const physim_world* world, const physim_segment* segment, uint32_t layers,
                                physim_projectile_hit* hits, size_t each, size_t room, size_t* count) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(segment, "segment");
    call.need_rows(hits, room, "hits");
    call.need(count, "count");
    need_each(call, each, room);
    if (!call.ok()) return;
    const SceneSegment s = segment_of(*segment);
    const auto found = std::as_const(*of).world().projectiles_along(s.from, s.to, s.radius, layers);
    if (!call.take(found)) return;
    for (std::size_t i = 0; i < std::min(room, found->size()); ++i) {
      const ProjectileHit& hit = (*found)[i];
      physim_projectile_hit out{.id = put_id(hit.id), .part = hit.part, .position = {}, .normal = {}};
      put(out.position, hit.position);
      put(out.normal, hit.normal);
      put_row(hits, each, i, out);
    }
    *count = found->size();
  });
}
