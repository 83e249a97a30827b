// What a scene holds, from the user's side: shapes, materials and things come, go and change.
#include "physim/scene.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "collide/content.hpp"
#include "prepare/check.hpp"

namespace physim {

Scene::Scene() : impl_(std::make_unique<Impl>()) {}
Scene::~Scene() = default;
Scene::Scene(const Scene& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
Scene& Scene::operator=(const Scene& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
Scene::Scene(Scene&& other) noexcept : impl_(std::move(other.impl_)) {
  try {
    other.impl_ = std::make_unique<Impl>();
  } catch (const std::bad_alloc&) {  // what was moved away has nothing then, and is good for its end alone
  }
}
Scene& Scene::operator=(Scene&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}

Result<ShapeId> Scene::add_shape(const ShapeDef& def) {
  const IeeeMode mode;
  std::vector<std::uint32_t> parts;
  Result<collide::Shape> shape = impl_->prepare(def, parts);
  if (!shape) return shape.error();
  const std::uint32_t index = collide::take_slot(impl_->shapes, impl_->free_shapes);
  Impl::ShapeSlot& slot = impl_->shapes[index];
  ++slot.generation;
  impl_->put(slot, std::move(*shape), std::move(parts));
  return ShapeId{index, slot.generation};
}

Status Scene::remove_shape(ShapeId id) {
  const Impl::ShapeSlot* found = impl_->find(id);
  if (!found) return Error{"is not there", "shape", ""};
  if (found->uses > 0) return Error{"is in use by " + std::to_string(found->uses), "shape", "remove what has it first"};
  Impl::ShapeSlot& slot = impl_->shapes[id.index];
  for (const std::uint32_t part : slot.parts) --impl_->shapes[part].uses;
  slot.parts.clear();
  slot.shape.reset();
  impl_->free_shapes.push_back(id.index);
  return {};
}

std::optional<ShapeInfo> Scene::info(ShapeId id) const {
  const Impl::ShapeSlot* slot = impl_->find(id);
  if (!slot) return std::nullopt;
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.info(); })
          return one.info();
        else
          return ShapeInfo{.bytes = sizeof(collide::Shape)};
      },
      *slot->shape);
}

Result<MaterialId> Scene::add_material(const Material& material) {
  if (auto status = check_material(material); !status) return status.error();
  impl_->materials.push_back(material);
  return MaterialId{static_cast<std::uint32_t>(impl_->materials.size() - 1)};
}

const Material& Scene::material(MaterialId id) const {
  return impl_->materials[id.index < impl_->materials.size() ? id.index : 0];
}

Result<InstanceId> Scene::add(const InstanceDef& def) {
  const IeeeMode mode;
  auto path = impl_->check(def);
  if (!path) return path.error();
  const std::uint32_t index = collide::take_slot(impl_->instances, impl_->free_instances);
  const std::uint32_t generation = ++impl_->instances[index].generation;
  impl_->put(index, def, std::move(*path));
  return InstanceId{index, generation};
}

Status Scene::remove(InstanceId id) {
  if (!impl_->find(id)) return Error{"is not there", "instance", ""};
  impl_->remove(id.index);
  return {};
}

Status Scene::move(InstanceId id, const Transform& to) {
  const IeeeMode mode;
  if (!impl_->find(id)) return Error{"is not there", "instance", ""};
  if (auto status = collide::check(to, "transform"); !status) return status;
  impl_->set_motion(id.index, to, AtRest{}, nullptr);
  return {};
}

Status Scene::set_motion(InstanceId id, const SceneMotion& motion) {
  const IeeeMode mode;
  const Impl::InstanceSlot* slot = impl_->find(id);
  if (!slot) return Error{"is not there", "instance", ""};
  InstanceDef def = slot->def;
  def.motion = motion;
  auto path = impl_->check(def);
  if (!path) return path.error();
  impl_->set_motion(id.index, def.transform, motion, std::move(*path));
  return {};
}

Status Scene::cover(double from, double to) {
  const IeeeMode mode;
  if (!(from >= -collide::kLatest && to <= collide::kLatest && from <= to))
    return Error{"must lie within 1e9 s, and the first one not behind the other one", "times", ""};
  impl_->cover(from, to);
  return {};
}

std::optional<MotionState> Scene::state(InstanceId id, double time) const {
  const IeeeMode mode;
  const Impl::InstanceSlot* slot = impl_->find(id);
  if (!slot || !(std::abs(time) <= collide::kLatest)) return std::nullopt;
  return slot->state_at(time);
}

std::uint64_t Scene::changes() const { return impl_->changes; }

Status Scene::set_layers(InstanceId id, std::uint32_t layers) {
  Impl::InstanceSlot* slot = impl_->find(id);
  if (!slot) return Error{"is not there", "instance", ""};
  slot->def.layers = slot->layers = layers;
  ++impl_->changes;
  return {};
}

Status Scene::set_conveyor(InstanceId id, const ConveyorDef& conveyor) {
  Impl::InstanceSlot* slot = impl_->find(id);
  if (!slot) return Error{"is not there", "instance", ""};
  if (auto status = check(conveyor, "conveyor"); !status) return status;
  const auto runs = [&] { return slot->def.conveyor == ConveyorDef{} ? std::size_t{0} : std::size_t{1}; };
  PHYSIM_ASSERT(impl_->conveyors >= runs());
  impl_->conveyors -= runs();
  slot->def.conveyor = conveyor;
  impl_->conveyors += runs();
  ++impl_->changes;
  return {};
}

Vec3d Scene::conveyor_velocity(InstanceId id, const Vec3d& normal, double time) const {
  if (impl_->conveyors == 0 || !(std::abs(time) <= collide::kLatest)) return {};
  const IeeeMode mode;
  const Impl::InstanceSlot* slot = impl_->find(id);
  if (!slot || slot->def.conveyor == ConveyorDef{}) return {};
  const Vec3d v = rotate(slot->state_at(time).rotation, slot->def.conveyor.velocity);
  return v - normal * dot(v, normal);
}

Status Scene::set_engine(const EngineScene& engine) {
  if (!(engine.skin >= 1e-6 && engine.skin <= 0.1))
    return Error{"must lie between 1e-6 and 0.1 m", "engine.skin", "ten times what the engine may be off, or more"};
  impl_->engine = engine.query ? std::make_shared<const collide::Engine>(engine) : nullptr;
  ++impl_->changes;
  return {};
}
const EngineScene* Scene::engine() const { return impl_->engine ? &impl_->engine->def() : nullptr; }
EngineCounters Scene::engine_counters() const { return impl_->engine ? impl_->engine->counters() : EngineCounters{}; }
double Scene::skin() const { return impl_->engine ? impl_->engine->def().skin : 0; }

std::optional<InstanceDef> Scene::instance(InstanceId id) const {
  const Impl::InstanceSlot* slot = impl_->find(id);
  return slot ? std::optional(slot->def) : std::nullopt;
}

std::size_t Scene::parts(InstanceId id) const {
  const Impl::InstanceSlot* slot = impl_->find(id);
  const auto* compound = slot ? std::get_if<collide::Compound>(slot->shape.get()) : nullptr;
  return compound ? compound->parts.size() : 0;
}

bool Scene::has_sensors() const { return impl_->sensors > 0; }
bool Scene::is_sensor(InstanceId id) const {
  const Impl::InstanceSlot* slot = impl_->find(id);
  return slot && slot->sensor;
}
bool Scene::tells_stay() const { return impl_->tells_stay > 0; }
bool Scene::is_one_way(InstanceId id) const {
  const Impl::InstanceSlot* slot = impl_->find(id);
  return slot && slot->one_way;
}
bool Scene::has_motion() const { return impl_->in_motion > 0; }

std::size_t Scene::size() const { return impl_->alive; }

std::size_t Scene::bytes() const {
  std::size_t sum = sizeof(Impl) + impl_->resting.bytes() + impl_->moving.bytes() +
                    impl_->shapes.capacity() * sizeof(Impl::ShapeSlot) +
                    impl_->instances.capacity() * sizeof(Impl::InstanceSlot);
  for (const std::uint32_t index : impl_->movers) sum += impl_->instances[index].path->bytes();
  for (std::uint32_t i = 1; i < impl_->shapes.size(); ++i)
    if (const auto known = info({i, impl_->shapes[i].generation})) sum += known->bytes;
  return sum;
}

}  // namespace physim
