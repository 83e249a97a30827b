#include "simclient/core/placing.hpp"

#include <algorithm>
#include <cmath>

#include "math/angles.hpp"
#include "scenario/published_materials.hpp"
#include "scenario/suggest.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

/// What a hand means by a place or an angle: no more digits than the thing's size asks for.
double rounded(double x, double size) {
  const double digit = std::pow(10.0, std::floor(std::log10(size)) - 2);
  return digit >= 1 ? std::round(x / digit) * digit : std::round(x * std::round(1 / digit)) / std::round(1 / digit);
}
Vec3d rounded(const Vec3d& p, double size) { return {rounded(p.x, size), rounded(p.y, size), rounded(p.z, size)}; }
double rounded_angle(double angle) { return std::round(angle / kDegree * 10) / 10 * kDegree; }

std::string free_thing_name(const Scenario& scenario, const std::string& what) {
  for (int i = 1;; ++i) {
    const std::string name = what + "-" + std::to_string(i);
    const bool is_taken = std::ranges::count(scenario.things, name, &ScenarioThing::name) > 0 ||
                          std::ranges::count(scenario.shapes, name, &ScenarioShape::name) > 0;
    if (!is_taken) return name;
  }
}

Result<Placed> placed(Scenario scenario, const std::string& what, ShapeDef shape, ScenarioThing thing,
                      const std::string& material) {
  const std::vector<std::string> choices = materials_to_choose(scenario);
  if (!material.empty() && std::ranges::count(choices, material) == 0) {
    const std::vector<std::string_view> names(choices.begin(), choices.end());
    return Error{"no material is named " + in_quotes(material), what, suggestion(material, names, "materials")};
  }
  thing.name = thing.shape = free_thing_name(scenario, what);
  thing.material = material;
  const bool is_there = std::ranges::count(scenario.materials, material, &Material::name) > 0;
  const auto published = is_there ? std::nullopt : published_material(material);
  if (published) {
    scenario.materials.push_back(*published);
    scenario.materials.back().name = material;
  }
  ScenarioShape of_thing;
  of_thing.name = thing.name;
  of_thing.shape = std::move(shape);
  scenario.shapes.push_back(std::move(of_thing));
  scenario.things.push_back(thing);
  return Placed{std::move(scenario), thing.name};
}

}  // namespace

void fit_sizes(Placing& placing, double distance) {
  placing.height = scale_step(distance, 10);
  placing.thickness = placing.height / 10;
  placing.radius = placing.height / 4;
}

std::vector<std::string> materials_to_choose(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const Material& material : scenario.materials) names.push_back(material.name);
  for (const std::string_view name : published_materials())
    if (std::ranges::count(names, name) == 0) names.emplace_back(name);
  return names;
}

Result<Placed> with_wall(const Scenario& scenario, const Vec3d& from, const Vec3d& to, const Placing& placing) {
  const double length = std::hypot(to.x - from.x, to.z - from.z);
  if (!(length > 0 && placing.height > 0 && placing.thickness > 0))
    return Error{"has no size", "wall", "set its two ends apart, and its height and thickness above 0"};
  const double size = std::min({length, placing.height, placing.thickness});
  ScenarioThing thing;
  const double foot = std::min(from.y, to.y);
  thing.position = rounded({(from.x + to.x) / 2, foot + placing.height / 2, (from.z + to.z) / 2}, size);
  thing.rotation.yaw = rounded_angle(std::atan2(to.z - from.z, to.x - from.x));
  const Vec3d half{rounded(length / 2, length), placing.height / 2, placing.thickness / 2};
  return placed(scenario, "wall", BoxShape{half}, thing, placing.material);
}

Result<Placed> with_target(const Scenario& scenario, const Vec3d& middle, const Vec3d& shot_from,
                           const Placing& placing) {
  if (!(placing.radius > 0 && placing.thickness > 0))
    return Error{"has no size", "target", "set its radius and thickness above 0"};
  ScenarioThing thing;
  thing.position = rounded(middle, placing.radius);
  // A cylinder's axis is y. Its x axis goes to the left of the line of fire, and the roll about that lays y along it.
  thing.rotation.yaw =
      rounded_angle(std::remainder(std::atan2(middle.z - shot_from.z, middle.x - shot_from.x) - kRightAngle, 2 * kPi));
  thing.rotation.roll = kRightAngle;
  return placed(scenario, "target", CylinderShape{placing.radius, placing.thickness / 10}, thing, placing.material);
}

}  // namespace physim::client
