#include "scenario/scene_maker.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
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

template <class List, class Add>
Status add_each(const List& list, const char* kind, const Add& add) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (const Status status = add(i); !status) {
      Error error = status.error();
      error.place = std::string(kind) + " " + in_quotes(list[i].name) + (error.place.empty() ? "" : ": " + error.place);
      return error;
    }
  return {};
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

Status SceneMaker::make_all() {
  PHYSIM_ASSERT(things_.empty());
  Status status = add_each(scenario_.materials, "material", [this](std::size_t i) { return add_material(i); });
  if (status) status = add_each(scenario_.shapes, "shape", [this](std::size_t i) { return add_shape(i); });
  if (status) status = add_each(scenario_.shapes, "shape", [this](std::size_t i) { return add_compound(i); });
  if (status) status = add_each(scenario_.things, "thing", [this](std::size_t i) { return add_thing(i); });
  return status;
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

Result<Scene> scene_of(const Scenario& scenario) {
  const IeeeMode mode;
  SceneMaker maker(scenario);
  if (const Status status = maker.make_all(); !status) return status.error();
  return maker.scene();
}

Result<SceneParts> scene_parts(const Scenario& scenario) {
  const IeeeMode mode;
  SceneMaker maker(scenario);
  if (const Status status = maker.make_all(); !status) return status.error();
  return SceneParts{maker.scene(), maker.materials(), maker.things()};
}

}  // namespace physim
