// The scene of a scenario, made part by part, so that an error names its part, and its emitters as those of a world.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "scenario/names.hpp"
#include "scenario/scenario.hpp"

namespace physim {

/// The motion of what says it by the members of ScenarioMotion.
template <class Moving>
[[nodiscard]] SceneMotion motion_of(const Moving& moving) {
  if (!moving.keys.empty()) {
    KeyedMotion motion{.keys = {}, .curve = moving.curve};
    for (const ScenarioKey& key : moving.keys)
      motion.keys.push_back({key.time, key.position, key.rotation.quaternion(), key.velocity});
    return motion;
  }
  if (moving.velocity == Vec3d{} && moving.angular_velocity == Vec3d{}) return AtRest{};
  return SteadyMotion{moving.start, moving.velocity, moving.angular_velocity};
}

class SceneMaker {
 public:
  /// Adds to a scene that may have other things already.
  explicit SceneMaker(const Scenario& scenario, Scene scene = {}) : scenario_(scenario), scene_(std::move(scene)) {
    for (const ScenarioShape& shape : scenario.shapes) shapes_.add(shape.name);
  }

  /// All materials, shapes, compounds and things; the place of an error names the part.
  [[nodiscard]] Status make_all();
  /// ... `in_place`: an error about the i-th part of a kind. Its place is a path in the part's table:
  /// "compound[1].shape".
  using ErrorInPlace = std::function<Error(const Error& error, const std::string& kind, std::size_t i)>;
  [[nodiscard]] Status make_all(const ErrorInPlace& in_place);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// The ids of Scenario::materials, in their order.
  [[nodiscard]] const std::vector<MaterialId>& materials() const { return materials_; }
  /// The ids of Scenario::things, in their order.
  [[nodiscard]] const std::vector<InstanceId>& things() const { return things_; }

 private:
  [[nodiscard]] Status add_material(std::size_t index);
  [[nodiscard]] Status add_shape(std::size_t index);     // nothing where it is a compound
  [[nodiscard]] Status add_compound(std::size_t index);  // nothing where it is none
  [[nodiscard]] Status add_thing(std::size_t index);
  [[nodiscard]] Result<CompoundShape::Part> part_of(const ScenarioShape& compound, const ScenarioPart& part) const;
  [[nodiscard]] Result<MaterialId> material_of(const std::string& name) const;
  [[nodiscard]] Result<MeshShape> mesh_of(const ScenarioShape& shape) const;
  [[nodiscard]] Status keep_shape(const ShapeDef& shape, const std::string& name);

  const Scenario& scenario_;
  NameIndex shapes_;  // of Scenario::shapes
  Scene scene_;
  std::vector<MaterialId> materials_;
  std::vector<InstanceId> things_;
  std::map<std::string_view, ShapeId> shape_ids_;
  std::map<std::string_view, MaterialId> material_ids_;
};

/// All of an emitter but what only its world knows: kinds, whom it follows, and the ids of its subs' emitters.
[[nodiscard]] EmitterDef def_of(const ScenarioEmitter& emitter);

/// The emitters in an order in which each comes after those that its subs name, but for itself, as a world wants them.
/// An error where several fire each other in a circle; its place is the name of one of them.
[[nodiscard]] Result<std::vector<std::size_t>> order_of_emitters(const Scenario& scenario, const NameIndex& names);

}  // namespace physim
