// Emitters, forces, joints and the decision of hits in worlds.
#include "capi/parts.hpp"

#include <algorithm>

#include "base/enumerators.hpp"
#include "model/force_laws.hpp"
#include "physim/names.hpp"
#include "scenario/scene_maker.hpp"

namespace physim::capi {
namespace {

static_assert(static_cast<int>(JointKind::slider) == PHYSIM_SLIDER &&
              static_cast<int>(OnHit::impact) == PHYSIM_HIT_BY_MATERIAL);

/// An emitter of a scenario as one of a world. Its kinds are added to the world.
Result<EmitterDef> emitter_in(WorldObject& object, const Scenario& scenario, const ScenarioEmitter& emitter) {
  const auto shot = shot_in(scenario, emitter.shot.c_str());
  if (!shot) return shot.error();
  const Result<KindId> kind = add_kind(object, scenario, *shot);
  if (!kind) return kind.error();
  const Launch& launch = scenario.shots[*shot].launch;
  EmitterDef def = def_of(emitter);
  def.kind = *kind;
  def.launch.rail_length = launch.rail_length;
  def.launch.attitude = launch.attitude;
  def.launch.spin = launch.spin;
  if (!emitter.tracer.empty()) {
    const auto tracer = shot_in(scenario, emitter.tracer.c_str());
    if (!tracer) return tracer.error();
    const Result<KindId> of_tracer = add_kind(object, scenario, *tracer);
    if (!of_tracer) return of_tracer.error();
    def.gun.tracer = *of_tracer;
  }
  PHYSIM_ASSERT(def.subs.size() == emitter.subs.size());
  for (std::size_t i = 0; i < def.subs.size(); ++i) {
    const std::string& fires = emitter.subs[i].emitter;
    if (fires == emitter.def.name) continue;  // it fires itself
    const auto known = object.emitters.find(fires);
    if (known == object.emitters.end() || object.world().emitter(known->second) == nullptr)
      return Error{"its sub fires an emitter that is not in this world", fires, "add that one first"};
    def.subs[i].emitter = known->second;
  }
  return def;
}

/// What a force of a scenario acts on, where the call names no projectiles: one kind, or layers, or everything.
Result<ForceTarget> target_of(WorldObject& object, const Scenario& scenario, const ScenarioForce& force) {
  if (force.shots.size() + (force.layers != 0 ? 1 : 0) > 1)
    return Error{"acts on several shots, or on shots and layers", "force.shots", "name one, or give the projectiles"};
  if (force.layers != 0) return ForceTarget{{}, {}, force.layers};
  if (force.shots.empty()) return ForceTarget::everything();
  const auto shot = shot_in(scenario, force.shots[0].c_str());
  if (!shot) return shot.error();
  const Result<KindId> kind = add_kind(object, scenario, *shot);
  if (!kind) return kind.error();
  return ForceTarget{{}, *kind, 0};
}

ForceTarget these(const physim_id* ids, std::size_t count) {
  const auto* first = same_memory<const ProjectileId>(ids);
  return {.ids = {first, first + count}, .kind = {}, .layers = 0};
}

physim_hit_question question_of(const HitQuestion& q) {
  physim_hit_question out{.projectile = put_id(q.projectile),
                          .thing = put_id(q.instance),
                          .kind = q.kind.index,
                          .primitive = q.primitive,
                          .material = q.material.index,
                          .inside = q.inside,
                          .time = q.time,
                          .position = {},
                          .velocity = {},
                          .normal = {},
                          .surface_velocity = {},
                          .energy = q.energy,
                          .obliquity = q.obliquity,
                          .thickness = q.thickness};
  put(out.position, q.position);
  put(out.velocity, q.velocity);
  put(out.normal, q.normal);
  put(out.surface_velocity, q.surface_velocity);
  return out;
}

/// Columns with the stride of particles; empty if there is none.
template <class T, class Mine>
Column<T> column(Mine* first, std::size_t room, std::size_t stride) {
  if (first == nullptr) return {};
  PHYSIM_ASSERT(stride % alignof(T) == 0);
  return {same_memory<T>(first), room, stride != 0 ? stride : sizeof(T)};
}

}  // namespace

CustomForce force_of(physim_force_function function, void* user) {
  return {[function, user](const ForceBatch& batch) {
    PHYSIM_ASSERT(batch.position.size() == batch.id.size() && batch.force.size() == batch.id.size());
    const physim_force_batch seen{batch.id.size(),
                                  batch.time,
                                  same_memory<const physim_id>(batch.id.data()),
                                  same_memory<const double>(batch.position.data()),
                                  same_memory<const double>(batch.velocity.data()),
                                  batch.mass.data(),
                                  same_memory<double>(batch.force.data())};
    function(user, &seen);
  }};
}

HitFunction hit_of(physim_hit_function function, void* user) {
  if (function == nullptr) return {};
  return [function, user](const HitBatch& batch) {
    const std::size_t count = batch.questions.size();
    std::vector<physim_hit_question> questions(count);
    std::vector<physim_hit_answer> answers(count, {PHYSIM_HIT_STOPS, 0, {}});
    std::transform(batch.questions.begin(), batch.questions.end(), questions.begin(), question_of);
    PHYSIM_ASSERT(batch.answers.size() == count);
    function(user, count, questions.data(), answers.data());
    for (std::size_t i = 0; i < count; ++i) {
      const bool known = answers[i].then >= 0 && answers[i].then <= PHYSIM_HIT_BY_MATERIAL;
      batch.answers[i].then = known ? static_cast<OnHit>(answers[i].then) : OnHit::ask;  // which the world refuses
      if (answers[i].has_velocity != 0) batch.answers[i].velocity = vector_at(answers[i].velocity);
    }
  };
}

}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

// ----------------------------------------------------------------------------------------------------------- emitters
physim_result physim_world_add_emitter(physim_world* world, const physim_def* def, const char* emitter,
                                       const physim_id* follows, physim_id* id) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(def, "def");
    call.need(id, "id");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    const Scenario& scenario = (*checked)->scenario;
    const auto index = index_in(scenario.emitters, emitter, "emitter", [](const auto& e) { return e.def.name; });
    if (!call.take(index, PHYSIM_NOT_FOUND)) return;
    const ScenarioEmitter& one = scenario.emitters[*index];
    Result<EmitterDef> made = emitter_in(*into, scenario, one);
    if (!call.take(made)) return;
    if (follows != nullptr) made->follows = id_of<ProjectileId>(*follows);
    const Result<EmitterId> added = into->world().add_emitter(*made);
    if (!call.take(added)) return;
    into->emitters[one.def.name] = *added;
    *id = put_id(*added);
  });
}

physim_result physim_emitter_do(physim_world* world, physim_id emitter, physim_emitter_action action, double value) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(!std::isnan(value), "value", "is not a number");
    call.need(action != PHYSIM_EMIT || (value >= 0 && value <= 1e6), "value", "is not 0 to 1e6");
    if (!call.ok()) return;
    const auto id = id_of<EmitterId>(emitter);
    World& w = into->world();
    switch (action) {
      case PHYSIM_PLAY: call.take(w.play_emitter(id)); return;
      case PHYSIM_STOP: call.take(w.stop_emitter(id)); return;
      case PHYSIM_TRIGGER: call.take(w.trigger_emitter(id)); return;
      case PHYSIM_EMIT: call.take(w.emit(id, static_cast<std::uint32_t>(value))); return;
      case PHYSIM_SEEK: call.take(w.seek_emitter(id, value)); return;
    }
    call.need(false, "action", "is none");
  });
}

physim_result physim_emitter_move(physim_world* world, physim_id emitter, const physim_transform* to, double time) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(to, "to");
    const physim_transform t = call.read(to, "to");
    call.need(is_finite(t.position, 3) && is_finite(t.rotation, 4) && !std::isnan(time), "to",
              "has a number that is none");
    if (!call.ok()) return;
    const Transform place{vector_at(t.position), rotation_at(t.rotation), 1};
    World& w = into->world();
    const auto id = id_of<EmitterId>(emitter);
    call.take(time > w.time() ? w.lead_emitter(id, place, time)
              : time < 0      ? w.jump_emitter(id, place)
                              : w.move_emitter(id, place));
  });
}

physim_result physim_emitter_read(const physim_world* world, physim_id emitter, physim_emitter_info* info) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const auto id = id_of<EmitterId>(emitter);
    if (of->world().emitter(id) == nullptr) return call.fail(PHYSIM_NOT_FOUND, "there is no such emitter", "emitter");
    const EmitterCounts counts = of->world().emitter_counts(id);
    call.write(info, {.size = 0,
                      .alive = counts.alive,
                      .playing = of->world().is_playing(id),
                      .reserved = 0,
                      .born = counts.born,
                      .refused = counts.refused,
                      .landed = counts.landed,
                      .gone = counts.aged + counts.expired + counts.replaced + counts.taken});
  });
}

physim_result physim_emitter_particles(const physim_world* world, physim_id emitter, size_t room,
                                       const physim_particles* into, size_t* count) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(into, "into");
    const physim_particles p = call.read(into, "into");
    call.need_rows(into, room, "room");
    call.need(count, "count");
    call.need(p.stride % sizeof(double) == 0, "stride", "is no size of a struct with such members");
    if (!call.ok()) return;
    const auto id = id_of<EmitterId>(emitter);
    if (of->world().emitter(id) == nullptr) return call.fail(PHYSIM_NOT_FOUND, "there is no such emitter", "emitter");
    ParticleColumns columns{.id = column<ProjectileId>(p.id, room, p.stride),
                            .position = column<Vec3d>(p.position, room, p.stride),
                            .previous = column<Vec3d>(p.previous, room, p.stride),
                            .velocity = column<Vec3d>(p.velocity, room, p.stride),
                            .size = column<Vec3d>(p.extent, room, p.stride),
                            .rotation = column<Vec3d>(p.rotation, room, p.stride),
                            .colour = column<std::uint32_t>(p.colour, room, p.stride),
                            .age = column<double>(p.age, room, p.stride),
                            .number = column<std::uint64_t>(p.number, room, p.stride),
                            .eye = {}};
    if (p.eye != nullptr) columns.eye = vector_at(p.eye);
    *count = of->world().particles(id, columns);
  });
}

physim_result physim_emitter_trails(const physim_world* world, physim_id emitter, const physim_trails* into,
                                    size_t* particles, size_t* places) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(particles, "particles");
    call.need(places, "places");
    const physim_trails t = call.read(into, "into");
    if (!call.ok()) return;
    const auto id = id_of<EmitterId>(emitter);
    if (of->world().emitter(id) == nullptr) return call.fail(PHYSIM_NOT_FOUND, "there is no such emitter", "emitter");
    const TrailColumns columns{.id = column<ProjectileId>(t.id, *particles, 0),
                               .first = column<std::uint32_t>(t.first, *particles, 0),
                               .count = column<std::uint32_t>(t.count, *particles, 0),
                               .position = column<Vec3d>(t.position, *places, 0),
                               .time = column<double>(t.time, *places, 0)};
    const TrailCounts counts = of->world().trails(id, columns);
    *particles = counts.particles, *places = counts.places;
  });
}

// ------------------------------------------------------------------------------------------------------ forces, hits
physim_result physim_world_add_force(physim_world* world, const physim_def* def, const char* force,
                                     const physim_id* ids, size_t count, const physim_id* other, physim_id* id) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(def, "def");
    call.need_rows(ids, count, "ids");
    call.need(id, "id");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    const Scenario& scenario = (*checked)->scenario;
    const auto index = index_in(scenario.forces, force, "force", [](const ScenarioForce& f) { return f.name; });
    if (!call.take(index, PHYSIM_NOT_FOUND)) return;
    const ScenarioForce& one = scenario.forces[*index];
    const Result<ForceTarget> target = count > 0 ? these(ids, count) : target_of(*into, scenario, one);
    if (!call.take(target)) return;
    ForceDef made{.law = one.law, .target = *target, .delay = one.delay, .duration = one.duration};
    if (ProjectileId* end = other_end_of(made.law); end != nullptr && other != nullptr)
      *end = id_of<ProjectileId>(*other);
    const Result<ForceId> added = into->world().add_force(made);
    if (call.take(added)) *id = put_id(*added);
  });
}

physim_result physim_world_add_force_function(physim_world* world, physim_force_function function, void* user,
                                              const physim_id* ids, size_t count, uint32_t layers, physim_id* id) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(function != nullptr, "function", "is null");
    call.need_rows(ids, count, "ids");
    call.need(id, "id");
    if (!call.ok()) return;
    ForceDef made{.law = force_of(function, user), .target = these(ids, count)};
    made.target.layers = layers;
    const Result<ForceId> added = into->world().add_force(made);
    if (call.take(added)) *id = put_id(*added);
  });
}

physim_result physim_world_set_hit_function(physim_world* world, physim_hit_function function, void* user) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    if (call.ok()) call.take(into->world().set_hit_function(hit_of(function, user)));
  });
}

// ------------------------------------------------------------------------------------------------------------- joints
physim_result physim_world_add_joint(physim_world* world, const physim_joint* joint, physim_id* id) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(joint, "joint");
    const physim_joint j = call.read(joint, "joint");
    call.need(id, "id");
    call.need(static_cast<std::size_t>(j.kind) < kEnumerators<JointKind>, "joint.kind", "is none");
    if (!call.ok()) return;
    Joint made{.kind = static_cast<JointKind>(j.kind),
               .a = id_of<ProjectileId>(j.a),
               .b = id_of<ProjectileId>(j.b),
               .point = vector_at(j.point),
               .length = {},
               .restitution = j.restitution};
    if (j.length != 0) made.length = j.length;
    if (j.break_force != 0) made.break_force = j.break_force;
    made.velocity = vector_at(j.velocity);
    made.thing = id_of<InstanceId>(j.thing);
    made.axis = vector_at(j.axis);
    made.reference = vector_at(j.reference);
    const bool is_hinge = made.kind == JointKind::hinge;
    if (j.low != 0 || j.high != 0) {
      if (j.low != -kInfinity) (is_hinge ? made.low_angle : made.low) = j.low;
      if (j.high != kInfinity) (is_hinge ? made.high_angle : made.high) = j.high;
    }
    if (made.kind == JointKind::spring) made.stiffness = j.stiffness, made.damping = j.damping;
    const Result<JointId> added = into->world().add_joint(made);
    if (call.take(added)) *id = put_id(*added);
  });
}

physim_result physim_joint_move(physim_world* world, physim_id joint, const double position[3],
                                const double velocity[3]) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(position, "position");
    call.need(velocity, "velocity");
    if (!call.ok()) return;
    const auto id = id_of<JointId>(joint);
    if (into->world().joint(id) == nullptr) return call.fail(PHYSIM_NOT_FOUND, "there is no such joint", "joint");
    call.take(into->world().move_joint(id, {vector_at(position), vector_at(velocity)}));
  });
}

physim_result physim_joint_read(const physim_world* world, physim_id joint, physim_joint_info* info) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const auto id = id_of<JointId>(joint);
    if (of->world().joint(id) == nullptr) return call.fail(PHYSIM_NOT_FOUND, "there is no such joint", "joint");
    const JointState state = of->world().joint_state(id);
    call.write(info, {.size = 0,
                      .taut = state.is_taut,
                      .length = state.length,
                      .tension = state.tension,
                      .force = state.force,
                      .angle = state.angle,
                      .way = state.way});
  });
}

physim_result physim_joint_events(const physim_world* world, physim_joint_event* into, size_t each, size_t room,
                                  size_t* count) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need_rows(into, room, "into");
    call.need(count, "count");
    call.need(room == 0 || each >= sizeof(std::int32_t), "each", "is not the sizeof of the struct");
    if (!call.ok()) return;
    const std::vector<JointEvent> events = of->world().joint_events();
    *count = std::min(room, events.size());
    for (std::size_t i = 0; i < *count; ++i)
      put_row(into, each, i,
              {.kind = static_cast<std::int32_t>(events[i].kind),
               .reserved = 0,
               .joint = put_id(events[i].joint),
               .projectile = put_id(events[i].projectile),
               .time = events[i].time,
               .speed = events[i].speed});
  });
}

physim_result physim_world_release(physim_world* world, physim_id force, const physim_id* ids, size_t count,
                                   size_t* released) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need_rows(ids, count, "ids");
    if (!call.ok()) return;
    std::size_t total = 0;
    for (std::size_t i = 0; i < count; ++i)
      total += into->world()[id_of<ProjectileId>(ids[i])].remove_force(id_of<ForceId>(force)).ok();
    if (released != nullptr) *released = total;
  });
}

physim_result physim_world_remove(physim_world* world, physim_what what, physim_id id) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(what >= PHYSIM_A_FORCE && what <= PHYSIM_AN_EMITTER, "what", "is none");
    if (!call.ok()) return;
    World& w = into->world();
    if (what == PHYSIM_A_FORCE) call.take(w.remove_force(id_of<ForceId>(id)));
    if (what == PHYSIM_A_JOINT) call.take(w.remove_joint(id_of<JointId>(id)));
    if (what == PHYSIM_AN_EMITTER) call.take(w.remove_emitter(id_of<EmitterId>(id)));
  });
}
