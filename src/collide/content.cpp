#include "collide/content.hpp"

#include <algorithm>
#include <cmath>

#include "base/checker.hpp"
#include "prepare/check.hpp"

namespace physim::collide {
namespace {

/// A length that a shape has.
void check_size(Checker& c, double size, const char* place, bool may_be_zero = false) {
  c.require((may_be_zero ? size >= 0 : size >= 1e-9) && size <= kFarthest, place,
            may_be_zero ? "must lie between 0 and 1e15 m" : "must lie between 1e-9 m and 1e15 m", "in m");
}

/// Makes shapes from what they are defined by.
struct ShapeMaker {
  const SceneContent& scene;
  std::vector<std::uint32_t>& parts;

  Result<Shape> operator()(const PlaneShape&) const { return Shape(HalfSpace{}); }
  Result<Shape> operator()(const SphereShape& s) const {
    Checker c;
    check_size(c, s.radius, "shape.radius");
    if (auto status = c.status(); !status) return status.error();
    return Shape(Sphere{s.radius});
  }
  Result<Shape> operator()(const BoxShape& b) const {
    Checker c;
    for (const double half : {b.half.x, b.half.y, b.half.z}) check_size(c, half, "shape.half");
    if (auto status = c.status(); !status) return status.error();
    return Shape(Box{b.half});
  }
  Result<Shape> operator()(const CapsuleShape& s) const {
    Checker c;
    check_size(c, s.radius, "shape.radius");
    check_size(c, s.half_height, "shape.half_height", true);
    if (auto status = c.status(); !status) return status.error();
    return Shape(Capsule{s.radius, s.half_height});
  }
  Result<Shape> operator()(const CylinderShape& s) const {
    Checker c;
    check_size(c, s.radius, "shape.radius");
    check_size(c, s.half_height, "shape.half_height");
    if (auto status = c.status(); !status) return status.error();
    return Shape(Cylinder{s.radius, s.half_height});
  }
  Result<Shape> operator()(const ConvexHullShape& h) const {
    auto hull = ConvexHull::make(h);
    if (!hull) return hull.error();
    return Shape(std::move(*hull));
  }
  Result<Shape> operator()(const MeshShape& m) const {
    auto mesh = Mesh::make(m, scene.materials.size());
    if (!mesh) return mesh.error();
    return Shape(std::move(*mesh));
  }
  Result<Shape> operator()(const HeightFieldShape& f) const {
    auto field = HeightField::make(f);
    if (!field) return field.error();
    return Shape(std::move(*field));
  }
  Result<Shape> operator()(const CompoundShape& c) const {
    if (c.parts.empty()) return Error{"has no parts", "shape.parts", "add some"};
    Compound compound;
    for (std::size_t i = 0; i < c.parts.size(); ++i) {
      const std::string place = "shape.parts[" + std::to_string(i) + "]";
      const SceneContent::ShapeSlot* slot = scene.find(c.parts[i].shape);
      if (!slot) return Error{"is no shape of this scene", place + ".shape", "add_shape() gives them"};
      if (std::holds_alternative<Compound>(*slot->shape) || std::holds_alternative<HalfSpace>(*slot->shape))
        return Error{"is a compound or a plane", place + ".shape", "take its parts, or a plane of its own"};
      if (auto status = check(c.parts[i].transform, place + ".transform"); !status) return status.error();
      if (c.parts[i].material && c.parts[i].material->index >= scene.materials.size())
        return Error{"is no material of this scene", place + ".material", "add_material() gives them"};
      const Placement placement(c.parts[i].transform);
      compound.parts.push_back({c.parts[i], placement, placement.outside(bounds_of(*slot->shape)), slot->shape});
      parts.push_back(c.parts[i].shape.index);
    }
    return Shape(std::move(compound));
  }
};

}  // namespace

Status check(const Transform& t, const std::string& place) {
  Checker c;
  c.require(finite(t.position) && length(t.position) <= kFarthest, place + ".position", "must lie within 1e15 m");
  const double norm = norm_squared(t.rotation);
  c.require(norm > 1e-12 && norm < 1e12, place + ".rotation", "is no rotation: its length is none",
            "a unit quaternion; {1, 0, 0, 0} does not turn");
  c.require(t.scale >= 1e-9 && t.scale <= 1e9, place + ".scale", "must lie between 1e-9 and 1e9", "1 changes nothing");
  return c.status();
}

// ------------------------------------------------------------------------------------------- shapes
Result<Shape> SceneContent::prepare(const ShapeDef& def, std::vector<std::uint32_t>& parts) const {
  return std::visit(ShapeMaker{*this, parts}, def);
}

void SceneContent::put(ShapeSlot& slot, Shape&& shape, std::vector<std::uint32_t>&& parts) {
  PHYSIM_ASSERT(!slot.shape && slot.uses == 0);
  slot.shape = std::make_shared<const Shape>(std::move(shape));
  slot.hash = std::make_shared<std::atomic<std::uint64_t>>(0);
  slot.parts = std::move(parts);
  for (const std::uint32_t part : slot.parts) ++shapes[part].uses;
}

// ------------------------------------------------------------------------------------------- things
Result<std::shared_ptr<const Path>> SceneContent::check(const InstanceDef& def) const {
  if (!find(def.shape)) return Error{"is no shape of this scene", "instance.shape", "add_shape() gives them"};
  if (def.material.index >= materials.size())
    return Error{"is no material of this scene", "instance.material", "add_material() gives them"};
  if (auto status = collide::check(def.transform, "instance.transform"); !status) return status.error();
  if (auto status = physim::check(def.conveyor, "instance.conveyor"); !status) return status.error();
  const double front = length(def.passage.front);
  if (!(front >= 0 && front <= 1e15) || (front > 0 && front < 1e-15))
    return Error{"must be a direction of a length between 1e-15 and 1e15, or zero", "instance.passage.front",
                 "(0, 1, 0): it stops what falls on it"};
  if (def.sensor && front > 0)
    return Error{"a sensor stops nothing", "instance.passage.front", "leave one of both out"};
  if (def.passage.tells_stay && !def.sensor)
    return Error{"only a sensor tells who stays in it", "instance.passage.tells_stay", "set `sensor`"};
  if (std::holds_alternative<AtRest>(def.motion)) return std::shared_ptr<const Path>();
  auto path = Path::make(def.motion, def.transform);
  if (!path) return path.error();
  return std::make_shared<const Path>(std::move(*path));
}

void SceneContent::put(std::uint32_t index, const InstanceDef& def, std::shared_ptr<const Path>&& path) {
  InstanceSlot& slot = instances[index];
  PHYSIM_ASSERT(!slot.alive && find(def.shape));
  slot.alive = true;
  slot.def = def;
  slot.layers = def.layers;
  slot.sensor = def.sensor;
  slot.one_way = def.passage.front != Vec3d{};
  slot.placement = Placement(def.transform);
  slot.path = std::move(path);
  slot.shape = shapes[def.shape.index].shape;
  ++shapes[def.shape.index].uses;
  ++alive;
  ++changes;
  enter_tree(index);
}

void SceneContent::remove(std::uint32_t index) {
  InstanceSlot& slot = instances[index];
  leave_tree(index);
  PHYSIM_ASSERT(shapes[slot.def.shape.index].uses > 0 && alive > 0);
  --shapes[slot.def.shape.index].uses;
  --alive;
  ++changes;
  slot.alive = false;
  slot.shape.reset();
  slot.path.reset();
  slot.def = {};
  free_instances.push_back(index);
}

void SceneContent::set_motion(std::uint32_t index, const Transform& at, const SceneMotion& motion,
                              std::shared_ptr<const Path>&& path) {
  InstanceSlot& slot = instances[index];
  leave_tree(index);
  slot.def.transform = at;
  slot.def.motion = motion;
  slot.placement = Placement(at);
  slot.path = std::move(path);
  ++changes;
  enter_tree(index);
}

void SceneContent::enter_tree(std::uint32_t index) {
  InstanceSlot& slot = instances[index];
  PHYSIM_ASSERT(slot.alive && slot.shape && slot.leaf == Tree::kNone);
  sensors += slot.def.sensor ? 1 : 0;
  in_motion += slot.path ? 1 : 0;
  conveyors += slot.def.conveyor == ConveyorDef{} ? 0 : 1;
  one_ways += slot.one_way ? 1 : 0;
  tells_stay += slot.def.passage.tells_stay ? 1 : 0;
  meshes += std::holds_alternative<Mesh>(*instances[index].shape) ? 1 : 0;
  const auto list = [index](std::vector<std::uint32_t>& in) { in.insert(std::ranges::lower_bound(in, index), index); };
  const Bounds own = bounds_of(*slot.shape);
  if (own.low.x > own.high.x) return list(unbounded);
  if (!slot.path && std::holds_alternative<HeightField>(*slot.shape)) list(fields);
  if (!slot.path) return resting.insert(slot.placement.outside(own), index);
  list(movers);
  slot.leaf = moving.insert(slot.path->bounds(own, covered_from, covered_to), index);
}

void SceneContent::leave_tree(std::uint32_t index) {
  InstanceSlot& slot = instances[index];
  sensors -= slot.def.sensor ? 1 : 0;
  in_motion -= slot.path ? 1 : 0;
  conveyors -= slot.def.conveyor == ConveyorDef{} ? 0 : 1;
  one_ways -= slot.one_way ? 1 : 0;
  tells_stay -= slot.def.passage.tells_stay ? 1 : 0;
  meshes -= std::holds_alternative<Mesh>(*instances[index].shape) ? 1 : 0;
  const auto unlist = [index](std::vector<std::uint32_t>& from) {
    const auto place = std::ranges::lower_bound(from, index);
    PHYSIM_ASSERT(place != from.end() && *place == index);
    from.erase(place);
  };
  if (!slot.path && std::holds_alternative<HeightField>(*slot.shape)) unlist(fields);
  if (resting.remove(index)) return;
  if (slot.leaf == Tree::kNone) return unlist(unbounded);
  moving.remove(slot.leaf);
  unlist(movers);
  slot.leaf = Tree::kNone;
}

void SceneContent::cover(double from, double to) {
  PHYSIM_ASSERT(from <= to);
  covered_from = from;
  covered_to = to;
  for (const std::uint32_t index : movers) {
    InstanceSlot& slot = instances[index];
    moving.remove(slot.leaf);
    slot.leaf = moving.insert(slot.path->bounds(bounds_of(*slot.shape), from, to), index);
  }
}

}  // namespace physim::collide
