#include "scenario/scene_maker.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "collide/mesh.hpp"
#include "scenario/published_materials.hpp"
#include "scenario/settings_parts.hpp"
#include "scenario/suggest.hpp"
#include "scenario/world_run.hpp"

namespace physim {
namespace {

template <class Id>
Result<Id> id_of(const std::map<std::string_view, Id>& ids, const std::string& name, const std::string& what,
                 std::span<const std::string_view> others) {
  if (const auto found = ids.find(name); found != ids.end()) return found->second;
  std::vector<std::string_view> names(others.begin(), others.end());
  for (const auto& [each, id] : ids) names.push_back(each);
  const std::string hint = names.empty() ? "write a [[" + what + "]]" : suggestion(name, names, what + "s");
  return Error{"no " + what + " is named " + in_quotes(name), what, hint};
}

}  // namespace

Quatd ScenarioRotation::quaternion() const {
  const IeeeMode mode;
  const bool by_angles = yaw != 0 || pitch != 0 || roll != 0;
  return by_angles ? quat_from_yaw_pitch_roll(yaw, pitch, roll) : quat_from_axis_angle(axis, angle);
}

Status SceneMaker::add_material(std::size_t index) {
  const Material& material = scenario_.materials[index];
  PHYSIM_ASSERT(materials_.size() == index);
  const Result<MaterialId> id = scene_.add_material(material);
  if (!id) return id.error();
  if (!material_ids_.emplace(material.name, *id).second)
    return Error{"two materials are named " + in_quotes(material.name), "name", ""};
  materials_.push_back(*id);
  return {};
}

Status SceneMaker::add_shape(std::size_t index) {
  const ScenarioShape& shape = scenario_.shapes[index];
  if (shape.is_compound()) return {};
  if (std::holds_alternative<CompoundShape>(shape.shape)) {
    std::string kinds;
    for (const std::string_view kind : shape_kinds()) kinds += (kinds.empty() ? "" : ", ") + std::string(kind);
    return Error{"it is no shape", "", "give one of " + kinds};
  }
  if (shape.materials.empty() || !std::holds_alternative<MeshShape>(shape.shape))
    return keep_shape(shape.shape, shape.name);
  const Result<MeshShape> mesh = mesh_of(shape);
  return mesh ? keep_shape(*mesh, shape.name) : mesh.error();
}

/// The material of a name; of no name, that of every scene.
Result<MaterialId> SceneMaker::material_of(const std::string& name) const {
  if (name.empty()) return MaterialId{};
  return id_of(material_ids_, name, "material", published_materials());
}

/// A mesh with the materials that its shape names.
Result<MeshShape> SceneMaker::mesh_of(const ScenarioShape& shape) const {
  PHYSIM_ASSERT(!shape.materials.empty());
  MeshShape mesh = std::get<MeshShape>(shape.shape);
  mesh.materials.clear();
  const std::size_t names = shape.materials.size(), triangles = mesh.triangles.size();
  if (names != 1 && names != triangles)
    return Error{std::to_string(names) + " materials for " + std::to_string(triangles) + " triangles", "mesh.materials",
                 "give one for each triangle, or one for all"};
  for (std::size_t i = 0; i < names; ++i) {
    const Result<MaterialId> id = material_of(shape.materials[i]);
    if (!id) return Error{id.error().message, "mesh.materials[" + std::to_string(i) + "]", id.error().hint};
    mesh.materials.push_back(*id);
  }
  mesh.materials.resize(triangles, mesh.materials.front());
  return mesh;
}

Status SceneMaker::add_compound(std::size_t index) {
  PHYSIM_ASSERT(index < scenario_.shapes.size());
  const ScenarioShape& shape = scenario_.shapes[index];
  if (!shape.is_compound()) return {};
  CompoundShape compound;
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    const Result<CompoundShape::Part> part = part_of(shape, shape.parts[i]);
    if (!part)
      return Error{part.error().message, "compound[" + std::to_string(i) + "]." + part.error().place,
                   part.error().hint};
    compound.parts.push_back(*part);
  }
  return keep_shape(compound, shape.name);
}

Result<CompoundShape::Part> SceneMaker::part_of(const ScenarioShape& compound, const ScenarioPart& part) const {
  PHYSIM_ASSERT(compound.is_compound());
  const auto number = shapes_.find(part.shape);
  const ScenarioShape* const named = number ? &scenario_.shapes[*number] : nullptr;
  if (named != nullptr && named->is_compound())
    return Error{named == &compound ? "it names itself" : in_quotes(part.shape) + " is a compound, too", "shape",
                 "name shapes of other kinds, such as the parts of that one"};
  if (named != nullptr && std::holds_alternative<PlaneShape>(named->shape))
    return Error{in_quotes(part.shape) + " is a plane, which has no end", "shape", "give it a thing of its own"};
  const Result<ShapeId> shape = id_of(shape_ids_, part.shape, "shape", {});
  if (!shape) return shape.error();
  CompoundShape::Part made{*shape, {part.position, part.rotation.quaternion(), part.scale}};
  if (part.material.empty()) return made;
  const Result<MaterialId> material = material_of(part.material);
  if (!material) return material.error();
  made.material = *material;
  return made;
}

Status SceneMaker::keep_shape(const ShapeDef& shape, const std::string& name) {
  const Result<ShapeId> id = scene_.add_shape(shape);
  if (!id) return id.error();
  if (!shape_ids_.emplace(name, *id).second) return Error{"two shapes are named " + in_quotes(name), "name", ""};
  return {};
}

Status SceneMaker::add_thing(std::size_t index) {
  const ScenarioThing& thing = scenario_.things[index];
  const Result<ShapeId> shape = id_of(shape_ids_, thing.shape, "shape", {});
  if (!shape) return shape.error();
  InstanceDef def{.shape = *shape,
                  .transform = {thing.position, thing.rotation.quaternion(), thing.scale},
                  .material = {},
                  .layers = thing.layers,
                  .sensor = thing.sensor,
                  .user_data = index,
                  .name = thing.name,
                  .motion = motion_of(thing),
                  .conveyor = thing.conveyor,
                  .passage = thing.passage};
  const Result<MaterialId> material = material_of(thing.material);
  if (!material) return material.error();
  def.material = *material;
  const Result<InstanceId> added = scene_.add(def);
  if (!added) return added.error();
  PHYSIM_ASSERT(things_.size() == index);
  things_.push_back(*added);
  return {};
}

Status SceneMaker::make_all(const ErrorInPlace& in_place) {
  PHYSIM_ASSERT(things_.empty());
  const auto add_each = [&](const std::string& kind, std::size_t count, Status (SceneMaker::*add)(std::size_t)) {
    for (std::size_t i = 0; i < count; ++i)
      if (const Status status = (this->*add)(i); !status) return Status(in_place(status.error(), kind, i));
    return Status();
  };
  const std::size_t shapes = scenario_.shapes.size();
  Status status = add_each("material", scenario_.materials.size(), &SceneMaker::add_material);
  if (status) status = add_each("shape", shapes, &SceneMaker::add_shape);
  if (status) status = add_each("shape", shapes, &SceneMaker::add_compound);
  return status ? add_each("thing", scenario_.things.size(), &SceneMaker::add_thing) : status;
}

Status SceneMaker::make_all() {
  return make_all([this](Error error, const std::string& kind, std::size_t i) {
    const std::string& name = kind == "material" ? scenario_.materials[i].name
                              : kind == "shape"  ? scenario_.shapes[i].name
                                                 : scenario_.things[i].name;
    error.place = kind + " " + in_quotes(name) + (error.place.empty() ? "" : ": " + error.place);
    return error;
  });
}

std::size_t degenerate_triangles(const ScenarioShape& shape) {
  const IeeeMode mode;
  const auto* mesh = std::get_if<MeshShape>(&shape.shape);
  if (!mesh) return 0;
  const std::size_t vertices = mesh->vertices.size();
  return static_cast<std::size_t>(std::ranges::count_if(mesh->triangles, [&](const auto& corners) {
    if (std::ranges::any_of(corners, [vertices](std::uint32_t corner) { return corner >= vertices; })) return false;
    return !collide::Mesh::has_area(
        {mesh->vertices[corners[0]], mesh->vertices[corners[1]], mesh->vertices[corners[2]]});
  }));
}

Result<SceneParts> scene_parts(const Scenario& scenario) {
  const IeeeMode mode;
  SceneMaker maker(scenario);
  if (const Status status = maker.make_all(); !status) return status.error();
  return SceneParts{maker.scene(), maker.materials(), maker.things()};
}

Result<Scene> scene_of(const Scenario& scenario) {
  Result<SceneParts> parts = scene_parts(scenario);
  return parts ? Result<Scene>(std::move(parts->scene)) : parts.error();
}

EmitterDef def_of(const ScenarioEmitter& emitter) {
  EmitterDef def = emitter.def;
  def.rotation = emitter.rotation.quaternion();
  def.motion = motion_of(emitter.motion);
  for (const ScenarioSub& sub : emitter.subs) def.subs.push_back(sub.def);
  return def;
}

Result<std::vector<std::size_t>> order_of_emitters(const Scenario& scenario, const NameIndex& names) {
  const std::size_t count = scenario.emitters.size();
  std::vector<std::vector<std::size_t>> fired_by(count);  // those that wait for an emitter
  std::vector<std::size_t> waits(count), round(count), order;
  for (std::size_t i = 0; i < count; ++i)
    for (const ScenarioSub& sub : scenario.emitters[i].subs) {
      const std::optional<std::size_t> fires = names.find(sub.emitter);
      PHYSIM_ASSERT(fires.has_value());  // names are checked before
      if (*fires != i) fired_by[*fires].push_back(i), ++waits[i];
    }
  for (std::size_t i = 0; i < count; ++i)
    if (waits[i] == 0) order.push_back(i);
  for (std::size_t k = 0; k < order.size(); ++k)
    for (const std::size_t i : fired_by[order[k]]) {
      // In rounds over the list, each takes those that may exist by then.
      round[i] = std::max(round[i], round[order[k]] + (i < order[k] ? 1 : 0));
      if (--waits[i] == 0) order.push_back(i);
    }
  if (order.size() < count) {
    const auto left =
        static_cast<std::size_t>(std::ranges::find_if(waits, [](auto n) { return n > 0; }) - waits.begin());
    return Error{"emitters fire each other in a circle", scenario.emitters[left].def.name,
                 "an emitter may fire itself, and those that do not lead back to it"};
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(round[i], i); });
  return order;
}

}  // namespace physim
