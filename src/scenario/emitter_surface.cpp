// Meshes and terrain that emitters of a scenario let their particles out of.
#include <map>

#include "base/emit_shape_table.hpp"
#include "emit/emit_surface.hpp"
#include "physim/scenario.hpp"
#include "scenario/checks.hpp"
#include "scenario/names.hpp"
#include "scenario/suggest.hpp"

namespace physim {
namespace {

/// Prepares each shape and each file once, however many emitters name it.
class Surfaces {
 public:
  explicit Surfaces(const Scenario& scenario) : scenario_(scenario) {
    for (const ScenarioShape& shape : scenario.shapes) shapes_.add(shape.name);
  }

  Result<SharedShape> of(const std::string& name) {
    if (const auto found = by_name_.find(name); found != by_name_.end()) return found->second;
    const auto number = shapes_.find(name);
    if (!number)
      return Error{"no shape is named " + in_quotes(name), "",
                   shapes_.all().empty() ? "write a [[shape]]" : suggestion(name, shapes_.all(), "shapes")};
    return kept(by_name_, name, SharedShape::make(scenario_.shapes[*number].shape));
  }
  Result<SharedShape> in_file(const std::string& name) {
    if (const auto found = by_file_.find(name); found != by_file_.end()) return found->second;
    const Result<MeshShape> mesh = read_mesh_file(beside_scenario(scenario_, name));
    if (!mesh) return mesh.error();
    return kept(by_file_, name, SharedShape::make(*mesh));
  }

 private:
  using Known = std::map<std::string, SharedShape>;
  static Result<SharedShape> kept(Known& known, const std::string& name, Result<SharedShape> shape) {
    if (shape) known.emplace(name, *shape);
    return shape;
  }

  const Scenario& scenario_;
  NameIndex shapes_;  // of Scenario::shapes
  Known by_name_, by_file_;
};

Status complete_surface(ScenarioEmitter& emitter, Surfaces& surfaces, const Value& table) {
  const bool by_name = !emitter.surface_of.empty(), by_file = !emitter.surface_file.empty();
  if (!by_name && !by_file && reads(emitter.def.from.shape, kFromSurface))
    return Error{"emitter.from.surface: there is none, and the shape needs one", place_of(table, "from"),
                 "name a [[shape]] with a mesh or a height field: surface = \"...\", or a file of a mesh"};
  if (!by_name && !by_file) return {};
  const std::string key = by_name ? "of" : "file", setting = "emitter.from.surface." + key;
  const std::string place = place_of(table, "from.surface." + key);
  if (by_name && by_file) return Error{setting + ": given together with file", place, "give one of them"};
  if (by_file && emitter.def.from.shape == EmitShape::terrain)
    return Error{setting + ": a height map says no heights by itself", place,
                 "write a [[shape]] with height_field.file, and its name here: of = \"...\""};
  const Result<SharedShape> shape = by_name ? surfaces.of(emitter.surface_of) : surfaces.in_file(emitter.surface_file);
  if (!shape) return Error{setting + ": " + shape.error().message, place, shape.error().hint};
  emitter.def.from.surface.shape = *shape;
  return {};
}

}  // namespace

Status complete_emitters(Scenario& scenario, const Value& document) {
  Surfaces surfaces(scenario);
  for (std::size_t i = 0; i < scenario.emitters.size(); ++i)
    if (Status status = complete_surface(scenario.emitters[i], surfaces, element(document, "emitter", i)); !status)
      return status;
  return {};
}

}  // namespace physim
