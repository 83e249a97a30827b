// The scene of a world: what its projectiles meet, and what follows where it changes.
#include <algorithm>
#include <utility>

#include "base/ieee_mode.hpp"
#include "collide/scene_by_motion.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

Error no_scene() { return {"the world has no scene", "scene", "World::set_scene() gives it one"}; }

}  // namespace

/// Calls f with the slot of each that sleeps and meets things, in no order.
template <class F>
void WorldImpl::each_sleeper(const F& f) const {
  for (std::uint16_t c = 0; c < state.rows.size(); ++c) {
    const Rows& rows = state.rows[c];
    if (!registry.cohort(c).key.still || !registry.cohort(c).key.meets) continue;
    for (std::uint32_t row = 0; row < rows.size(); ++row)
      if (state.slots[rows.slot(row)].is(kAsleep)) f(rows.slot(row));
  }
}

/// Sleeping projectiles check if they still lie on something; of many changes between two steps only the first asks.
void WorldImpl::stir_scene() {
  if (std::exchange(is_stirred, true)) return;
  std::vector<std::uint32_t> asleep;
  each_sleeper([&](std::uint32_t slot) { asleep.push_back(slot); });
  std::ranges::sort(asleep);  // so that the order of rows does not matter
  for (const std::uint32_t slot : asleep) wake_alone(slot);
}

/// All rows look again for what is clear about them.
void WorldImpl::forget_clear() {
  state.newcomers.clear();
  for (const Rows& rows : state.rows) {
    if (!rows.layout().meeting) continue;
    for (std::uint32_t row = 0; row < rows.size(); ++row) rows.forget_clear(row);
  }
}

/// A thing came, or is elsewhere, or moves in another way. What moves, or was there before, rows need not know.
void WorldImpl::notice(InstanceId changed) {
  const SceneByMotion parts(*state.scene);
  if (!parts.rests(changed.index)) return;
  const bool has_box = parts.box_at_rest(changed.index).has_value();
  if (!has_box || !state.newcomers.add(changed.index, state.clock.steps)) forget_clear();
}

/// Before a step: where things may be that rows have not noticed.
void WorldImpl::find_restless(bool is_covered) {
  restless.clear();
  if (state.newcomers.are_settled(state.clock.steps)) forget_clear();
  if (!state.scene || state.scene->engine()) return;
  if (is_covered)
    restless.find(*state.scene, state.newcomers);
  else
    restless.be_everywhere();
}

/// Before a step: finds where moving things will be, and wakes projectiles that sleep there.
void WorldImpl::move_scene(double dt) {
  const bool moves = state.scene && state.scene->has_motion();
  const double now = state.clock.time();
  // Clocks of rows are rounded, those of float32 by a part of the step: who ends behind what is covered asks each
  // mover.
  const double most = collide::kLatest, end = now + dt;
  const double covered = end < most ? std::min(end + 0.01 * dt, most) : end;
  const bool is_covered = !moves || own_scene().cover(now, covered).ok();  // beyond 1e9 s nothing is met
  find_restless(is_covered);
  if (!moves || !is_covered) return;
  constexpr double kNear = 1e-3;  // [m]
  std::vector<std::uint32_t> struck;
  each_sleeper([&](std::uint32_t slot) {
    const CollisionDef& collision = registry.kind(state.slots[slot].kind).body.collision;
    const Vec3d x = state.state_of(state.slots[slot]).position;
    const SceneFilter filter{.layers = collision.layers};
    if (state.scene->is_reached(x, collision.radius + kNear, filter, now, now + dt)) struck.push_back(slot);
  });
  std::ranges::sort(struck);
  wake_piled(std::move(struck));
}

void WorldImpl::put_scene(std::shared_ptr<Scene> scene) {
  state.scene = std::move(scene);
  registry.meet_scene(state.scene != nullptr);
  state.slots.each_alive([this](std::uint32_t slot) { placement.relocate(slot); });
  forget_clear();
  is_stirred = false;
  stir_scene();
  end_joints_at_gone_things(*this);
}

/// The scene, owned by this state alone.
Scene& WorldImpl::own_scene() {
  PHYSIM_ASSERT(state.scene != nullptr);
  if (state.scene.use_count() > 1) state.scene = std::make_shared<Scene>(*state.scene);
  return *state.scene;
}

/// Calls f with the scene, where there is one, to change a thing.
template <class F>
Status WorldImpl::change_scene(InstanceId changed, const F& f) {
  if (!state.scene) return no_scene();
  Status status = f(own_scene());
  if (!status) return status;
  notice(changed);
  stir_scene();
  return status;
}

Status World::set_scene(const Scene& scene) {
  WorldImpl& w = impl();
  const Recorded<Call::set_scene> call(w, scene);
  if (call.is_refused()) return call.refusal();
  w.put_scene(std::make_shared<Scene>(scene));
  return {};
}

Status World::remove_scene() {
  WorldImpl& w = impl();
  const Recorded<Call::remove_scene> call(w);
  if (call.is_refused()) return call.refusal();
  if (!w.state.scene) return no_scene();
  w.put_scene(nullptr);
  return {};
}

const Scene* World::scene() const { return impl().state.scene.get(); }

// A shape that no thing uses yet moves nothing.
Result<ShapeId> World::add_shape(const ShapeDef& shape) {
  WorldImpl& w = impl();
  const Recorded<Call::add_shape> call(w, shape);
  if (call.is_refused()) return call.refusal();
  if (!w.state.scene) return no_scene();
  return call.returns(w.own_scene().add_shape(shape));
}

Status World::remove_shape(ShapeId shape) {
  WorldImpl& w = impl();
  const Recorded<Call::remove_shape> call(w, shape);
  if (call.is_refused()) return call.refusal();
  return w.state.scene ? w.own_scene().remove_shape(shape) : Status(no_scene());
}

Result<MaterialId> World::add_material(const Material& material) {
  WorldImpl& w = impl();
  const Recorded<Call::add_material> call(w, material);
  if (call.is_refused()) return call.refusal();
  if (!w.state.scene) return no_scene();
  return call.returns(w.own_scene().add_material(material));
}

Result<InstanceId> World::add_instance(const InstanceDef& instance) {
  WorldImpl& w = impl();
  const Recorded<Call::add_instance> call(w, instance);
  if (call.is_refused()) return call.refusal();
  if (!w.state.scene) return no_scene();
  const Result<InstanceId> added = w.own_scene().add(instance);
  if (added) w.notice(*added), w.stir_scene();
  return call.returns(added);
}

Status World::remove_instance(InstanceId instance) {
  WorldImpl& w = impl();
  const Recorded<Call::remove_instance> call(w, instance);
  if (call.is_refused()) return call.refusal();
  Status status = w.change_scene(instance, [&](Scene& scene) { return scene.remove(instance); });
  if (status) end_joints_at_gone_things(w);
  return status;
}

Status World::move_instance(InstanceId instance, const Transform& to) {
  WorldImpl& w = impl();
  const Recorded<Call::move_instance> call(w, instance, to);
  if (call.is_refused()) return call.refusal();
  return w.change_scene(instance, [&](Scene& scene) { return scene.move(instance, to); });
}

Status World::set_instance_motion(InstanceId instance, const SceneMotion& motion) {
  WorldImpl& w = impl();
  const Recorded<Call::set_instance_motion> call(w, instance, motion);
  if (call.is_refused()) return call.refusal();
  return w.change_scene(instance, [&](Scene& scene) { return scene.set_motion(instance, motion); });
}

Status World::set_instance_layers(InstanceId instance, std::uint32_t layers) {
  WorldImpl& w = impl();
  const Recorded<Call::set_instance_layers> call(w, instance, layers);
  if (call.is_refused()) return call.refusal();
  return w.change_scene(instance, [&](Scene& scene) { return scene.set_layers(instance, layers); });
}

Status World::set_instance_conveyor(InstanceId instance, const ConveyorDef& conveyor) {
  WorldImpl& w = impl();
  const Recorded<Call::set_instance_conveyor> call(w, instance, conveyor);
  if (call.is_refused()) return call.refusal();
  return w.change_scene(instance, [&](Scene& scene) { return scene.set_conveyor(instance, conveyor); });
}

}  // namespace physim
