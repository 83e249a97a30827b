// Checks of [[material]], [[shape]] and [[thing]]: by making the scene, so that errors have its line.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "physim/environment.hpp"
#include "physim/scenario.hpp"
#include "scenario/checks.hpp"
#include "scenario/expectation.hpp"
#include "scenario/published_materials.hpp"
#include "scenario/scene_maker.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"

namespace physim {
namespace {

/// A path without the numbers of its lists.
std::string keys_of(std::string path) {
  for (std::size_t open = path.find('['); open != path.npos; open = path.find('['))
    path.erase(open, path.find(']', open) + 1 - open);
  return path;
}

/// An error about an element of a list, as one of the file: at the key that it names, where the element has it.
Error at_key(const Error& error, const std::string& list, const Value& table) {
  const PathInFile at = follow(table, error.place);
  const std::string path = !at.is_there          ? list + " (" + error.place + ")"
                           : error.place.empty() ? list
                                                 : list + "." + keys_of(error.place);
  return {path + ": " + error.message, (at.is_there ? at.nearest : table).place.text(), error.hint};
}

/// The tables in an element that say of which kind it is, and the key that names one.
std::vector<const Member*> kinds_of(const Value& element, const std::string& list, std::string_view kind_key,
                                    std::initializer_list<std::string_view> others) {
  PHYSIM_ASSERT(element.get<Table>() != nullptr);
  std::vector<const Member*> kinds;
  for (const Member& member : *element.get<Table>()) {
    const SchemaNode* node = find_node(list + "." + member.key);
    const bool is_table = node && (node->entry == nullptr || node->is_list_of_tables());
    const bool is_kind = is_table && std::ranges::count(others, member.key) == 0;
    if (is_kind || member.key == kind_key) kinds.push_back(&member);
  }
  return kinds;
}

Status check_one_kind(const Value& element, const std::string& list, std::string_view kind_key,
                      std::initializer_list<std::string_view> others) {
  const std::vector<const Member*> kinds = kinds_of(element, list, kind_key, others);
  if (kinds.size() < 2) return {};
  // A kind that is named beside its own table contradicts nothing.
  const auto named = std::ranges::find(kinds, kind_key, &Member::key);
  const auto* const text = named != kinds.end() ? (*named)->value.get<std::string>() : nullptr;
  if (kinds.size() == 2 && text && (kinds[0]->key == *text || kinds[1]->key == *text)) return {};
  return Error{list + ": it is of two kinds, " + kinds[0]->key + " and " + kinds[1]->key, kinds[1]->key_place.text(),
               "give one of them"};
}

bool is_mesh(const ScenarioShape& shape) { return std::holds_alternative<MeshShape>(shape.shape); }

/// The frames that terrain is laid out in: those of all shots.
Result<EarthFrames> frames_of(const Scenario& scenario) {
  const auto earth_of = [](const ScenarioShot& shot) { return shot.projectile.fidelity.earth; };
  const auto is_on_sphere = [&](const ScenarioShot& shot) {
    return earth_of(shot) == EarthModel::sphere || earth_of(shot) == EarthModel::sphere_rotating;
  };
  const auto spheres = std::ranges::count_if(scenario.shots, is_on_sphere);
  if (spheres == 0) return EarthFrames(scenario.environment, EarthModel::ellipsoid);
  if (spheres == std::ssize(scenario.shots)) return EarthFrames(scenario.environment, EarthModel::sphere);
  return Error{"some shots fly over a sphere and others do not", "", "give all of them one fidelity.earth"};
}

/// How far a grid goes about a place on the side that it ends first; infinite if that is as far as was asked for, at a
/// pole or once round the Earth.
double reach_within(const GeodeticGrid& grid, const TerrainCut& cut) {
  constexpr double kEarthRadius = 6371008.8, kQuarterTurn = kPi / 2;
  PHYSIM_ASSERT(grid.rows >= 2 && grid.columns >= 2);
  const double north = grid.latitude + (grid.rows - 1) * grid.latitude_step;
  const double half = (grid.columns - 1) * grid.longitude_step / 2, parallel = std::max(std::cos(cut.latitude), 1e-6);
  const double east = std::remainder(cut.longitude - grid.longitude - half, 2 * kPi);  // of the middle
  double least = kInfinity;
  // Points are the middles of cells, and of several points one may be taken.
  const auto take = [&](double angle, double step, double metres) {
    if ((angle + std::abs(step)) * metres < cut.reach) least = std::min(least, std::max(angle, 0.0) * metres);
  };
  if (north + grid.latitude_step < kQuarterTurn) take(north - cut.latitude, grid.latitude_step, kEarthRadius);
  if (grid.latitude - grid.latitude_step > -kQuarterTurn)
    take(cut.latitude - grid.latitude, grid.latitude_step, kEarthRadius);
  if (2 * half + grid.longitude_step < 2 * kPi * (1 - 1e-9)) {
    take(half + east, grid.longitude_step, kEarthRadius * parallel);
    take(half - east, grid.longitude_step, kEarthRadius * parallel);
  }
  return least;
}

/// Terrain about the place of the environment.
Status read_terrain(ScenarioShape& shape, const Scenario& scenario) {
  PHYSIM_ASSERT(is_mesh(shape) && !shape.terrain.empty());
  shape.cut.latitude = scenario.environment.earth.latitude;
  shape.cut.longitude = scenario.environment.earth.longitude;
  const Result<EarthFrames> frames = frames_of(scenario);
  if (!frames) return frames.error();
  const Result<GeodeticGrid> grid = read_terrain_file(beside_scenario(scenario, shape.terrain), shape.cut);
  if (!grid) return grid.error();
  shape.impossible = grid->impossible;
  shape.impossible_height = grid->impossible_height;
  if (std::isfinite(shape.cut.reach)) shape.reached = reach_within(*grid, shape.cut);
  Result<MeshShape> mesh = terrain_mesh(*grid, *frames);
  if (!mesh) return mesh.error();
  shape.shape = std::move(*mesh);
  return {};
}

/// What a shape has in a file.
Status read_file(ScenarioShape& shape, const Scenario& scenario) {
  if (is_mesh(shape) && !shape.terrain.empty()) return read_terrain(shape, scenario);
  if (shape.file.empty()) return {};
  const std::string file = beside_scenario(scenario, shape.file);
  if (is_mesh(shape)) {
    Result<MeshShape> mesh = read_mesh_file(file);
    if (!mesh) return mesh.error();
    shape.shape = std::move(*mesh);
  } else if (auto* field = std::get_if<HeightFieldShape>(&shape.shape)) {
    Result<HeightFieldShape> read = read_height_map(file, shape.low, shape.high);
    if (!read) return read.error();
    read->spacing_x = field->spacing_x;
    read->spacing_z = field->spacing_z;
    *field = std::move(*read);
  }
  return {};
}

Status check_material(const Value& table) {
  if (table.find("preset") && table.find("concrete"))
    return error_at(table, "material.concrete", "given together with preset", "give one of them");
  return check_one_kind(table, "material", "penetration", {"combine", "ricochet", "spread"});
}

Status check_shape(const ScenarioShape& shape, const Value& table) {
  if (Status status = check_one_kind(table, "shape", "kind", {}); !status) return status;
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    if (Status status = check_rotation("shape.compound", shape.parts[i].rotation, element(table, "compound", i));
        !status)
      return status;
  struct Source {
    std::string_view kind, key;
    std::vector<std::string_view> others;  // that it stands for
  };
  for (const Source& source : {Source{"mesh", "file", {"vertices", "triangles", "terrain"}},
                               Source{"mesh", "terrain", {"vertices", "triangles"}},
                               Source{"height_field", "file", {"columns", "rows", "heights"}}})
    for (const std::string_view other : source.others) {
      const Value* of_kind = table.find(source.kind);
      if (!of_kind || !of_kind->find(source.key) || !of_kind->find(other)) continue;
      return Error{"shape." + std::string(source.kind) + "." + std::string(source.key) + ": given together with " +
                       std::string(other),
                   place_of(*of_kind, source.key), "give one of them"};
    }
  return {};
}

/// How many tables of a list the file has.
std::size_t count_in(const Value& document, const std::string& list) {
  const Value* value = document.find(list);
  const Array* array = value ? value->get<Array>() : nullptr;
  return array ? array->size() : 0;
}

/// The published materials that things, parts and meshes name, where the scenario has none of that name.
void bring_published(Scenario& scenario) {
  std::set<std::string, std::less<>> seen;  // names of their own: the list of materials grows
  for (const Material& material : scenario.materials) seen.insert(material.name);
  const auto bring = [&](const std::string& name) {
    if (!seen.insert(name).second) return;
    const auto published = published_material(name);
    if (published) scenario.materials.push_back(*published), scenario.materials.back().name = name;
  };
  for (const ScenarioThing& thing : scenario.things) bring(thing.material);
  for (const ScenarioShape& shape : scenario.shapes) {
    for (const ScenarioPart& part : shape.parts) bring(part.material);
    for (const std::string& name : shape.materials) bring(name);
  }
}

}  // namespace

Status check_rotation(const std::string& path, const ScenarioRotation& rotation, const Value& table) {
  const bool by_angles = rotation.yaw != 0 || rotation.pitch != 0 || rotation.roll != 0;
  if (rotation.angle != 0 && by_angles)
    return Error{path + ".rotation: given by an angle and by yaw, pitch and roll", place_of(table, "rotation"),
                 "give one of them"};
  if (rotation.axis == Vec3d{})
    return Error{path + ".rotation.axis: it has no direction", place_of(table, "rotation.axis"), ""};
  return {};
}

std::string beside_scenario(const Scenario& scenario, const std::string& file) {
  return (std::filesystem::path(scenario.file).parent_path() / file).string();
}

Status complete_scene(Scenario& scenario, const Value& document) {
  name_each(scenario.materials, "material");
  name_each(scenario.shapes, "shape");
  name_each(scenario.things, "thing");
  bring_published(scenario);
  for (std::size_t i = 0; i < scenario.shapes.size(); ++i) {
    const Status status = read_file(scenario.shapes[i], scenario);
    if (status) continue;
    const std::string_view kind = is_mesh(scenario.shapes[i]) ? "mesh" : "height_field";
    const std::string_view key = scenario.shapes[i].terrain.empty() ? "file" : "terrain";
    return Error{"shape." + std::string(kind) + "." + std::string(key) + ": " + status.error().message,
                 place_of(element(document, "shape", i), std::string(kind) + "." + std::string(key)),
                 status.error().hint};
  }
  return {};
}

Status check_scene(const Scenario& scenario, const Value& document) {
  if (scenario.materials.empty() && scenario.shapes.empty() && scenario.things.empty()) return {};
  for (std::size_t i = 0; i < count_in(document, "material"); ++i)
    if (Status status = check_material(element(document, "material", i)); !status) return status;
  for (std::size_t i = 0; i < scenario.shapes.size(); ++i)
    if (Status status = check_shape(scenario.shapes[i], element(document, "shape", i)); !status) return status;
  if (Status status = check_given_names(scenario.things, "thing", document); !status) return status;
  for (std::size_t i = 0; i < scenario.things.size(); ++i) {
    const ScenarioThing& thing = scenario.things[i];
    const Value& table = element(document, "thing", i);
    if (Status status = check_motion("thing", thing, thing.position, thing.rotation, table, table); !status)
      return status;
  }
  return SceneMaker(scenario).make_all([&](const Error& error, const std::string& list, std::size_t i) {
    PHYSIM_ASSERT(i < count_in(document, list));  // materials that are there by their name alone are good
    return at_key(error, list, element(document, list, i));
  });
}

Status check_thing_expectation(const ScenarioNames& names, const Expectation& expect, const Value& table) {
  PHYSIM_ASSERT(!expect.thing.empty());
  if (Status status = check_named(names.things, expect.thing, "thing", "expect.thing", place_of(table, "thing"));
      !status)
    return status;
  const Figure* figure = find_figure(expect.quantity);
  PHYSIM_ASSERT(figure != nullptr);  // the reader knows no others
  if (figure->is_of_things()) return {};
  return error_at(table, "expect.quantity", in_quotes(expect.quantity) + " is no figure of hits",
                  suggestion(expect.quantity, hit_figure_names(), "of hits there are"));
}

}  // namespace physim
