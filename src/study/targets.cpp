#include "study/targets.hpp"

#include <algorithm>

#include "base/checker.hpp"
#include "physim/scene.hpp"

namespace physim {
namespace {

bool covers(const CircleTarget& c, double right, double up) {
  const double x = right - c.centre.right, y = up - c.centre.up;
  return x * x + y * y <= c.radius * c.radius;
}

bool covers(const RectangleTarget& r, double right, double up) {
  const double x = right - r.centre.right, y = up - r.centre.up;
  // Without branches: impacts come at random.
  return ((x >= -0.5 * r.width) & (x < 0.5 * r.width) & (y >= -0.5 * r.height) & (y < 0.5 * r.height)) != 0;
}

bool covers(const PolygonTarget& p, double right, double up) {
  PHYSIM_ASSERT(p.corners.size() >= 3);
  bool inside = false;
  for (std::size_t i = 0, before = p.corners.size() - 1; i < p.corners.size(); before = i++) {
    const PlanePoint &a = p.corners[i], &b = p.corners[before];
    if ((a.up > up) != (b.up > up) && right < a.right + (b.right - a.right) * (up - a.up) / (b.up - a.up))
      inside = !inside;
  }
  return inside;
}

/// A thing is met, not covered: it has no place on the plane.
bool covers(const ThingTarget&, double, double) { return false; }

struct NamedThing {
  InstanceId id;
  std::string name;
};

/// All that stands within the farthest place that a scene is asked about; by rising ids.
std::vector<NamedThing> all_things(const Scene& scene) {
  constexpr double kFarthest = 1e15;  // [m]
  std::vector<NamedThing> things;
  for (const InstanceId id : scene.overlaps({}, kFarthest)) things.push_back({id, scene.instance(id)->name});
  std::ranges::sort(things, {}, &NamedThing::id);
  return things;
}

/// A hint: the names there are, each once and not too many of them.
std::string list_of_names(const std::vector<NamedThing>& things) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> names;
  for (const NamedThing& thing : things)
    if (!thing.name.empty() && std::ranges::count(names, thing.name) == 0 && names.size() <= kMost)
      names.push_back(thing.name);
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) text += (i == 0 ? "they are " : ", ") + names[i];
  return text + (names.size() > kMost ? " ..." : "");
}

/// The side of the line from a to b on which a corner lies: above 0 left, below 0 right.
double side_of(const PlanePoint& a, const PlanePoint& b, const PlanePoint& corner) {
  return (b.right - a.right) * (corner.up - a.up) - (b.up - a.up) * (corner.right - a.right);
}

/// True if two edges of the outline cross.
bool crosses_itself(const std::vector<PlanePoint>& corners) {
  const std::size_t count = corners.size();
  PHYSIM_ASSERT(count > 0);
  const auto cross = [&](std::size_t i, std::size_t j) {
    const PlanePoint &a = corners[i], &b = corners[(i + 1) % count], &c = corners[j], &d = corners[(j + 1) % count];
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
  };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (cross(i, j)) return true;
  return false;
}

void check_point(Checker& c, const PlanePoint& point, const std::string& place) {
  c.is_number(point.right, place + ".right").is_number(point.up, place + ".up");
}

}  // namespace

Status check(const StudyTarget& target, const std::string& place) {
  Checker c;
  if (const auto* circle = std::get_if<CircleTarget>(&target.shape)) {
    check_point(c, circle->centre, place + ".centre");
    c.positive(circle->radius, place + ".radius");
  } else if (const auto* rectangle = std::get_if<RectangleTarget>(&target.shape)) {
    check_point(c, rectangle->centre, place + ".centre");
    c.positive(rectangle->width, place + ".width").positive(rectangle->height, place + ".height");
  } else if (const auto* polygon = std::get_if<PolygonTarget>(&target.shape)) {
    c.require(polygon->corners.size() >= 3, place + ".corners", "must be three or more");
    for (const PlanePoint& corner : polygon->corners) check_point(c, corner, place + ".corners");
    c.require(!c.status_so_far() || !crosses_itself(polygon->corners), place + ".corners",
              "make an outline that crosses itself", "name the corners in the order in which the outline passes them");
  }
  return c.status();
}

void mark_covered(const StudyTarget& target, std::span<const std::uint32_t> shots, std::span<const double> right,
                  std::span<const double> up, std::span<std::uint8_t> marks) {
  const auto mark = [&](const auto shape) {  // a copy, which marks cannot lie in
    for (const std::uint32_t i : shots) marks[i] = covers(shape, right[i], up[i]) ? 1 : 0;
  };
  std::visit(mark, target.shape);
}

ThingsOfTargets things_of(const Study& study) {
  PHYSIM_ASSERT(study.scene != nullptr);
  ThingsOfTargets things(study.targets.size());
  const auto all = all_things(*study.scene);
  for (std::size_t i = 0; i < study.targets.size(); ++i)
    if (const auto* target = std::get_if<ThingTarget>(&study.targets[i].shape))
      for (const auto& [id, name] : all)
        if (name == target->thing) things[i].push_back(id);
  return things;
}

Status check_things(const Study& study, bool of_flights) {
  Checker c;
  c.require(!study.until.scene, "until.scene", "is lent for a flight, and a study keeps its own", "give study.scene");
  c.require(of_flights || !study.scene, "scene", "is met by flights, and not by a function");
  if (study.scene)
    c.require(!study.scene->engine(), "scene", "has an engine that answers one call at a time, and studies ask at once",
              "let the things stand in the scene itself");
  const auto all = study.scene && of_flights ? all_things(*study.scene) : std::vector<NamedThing>();
  for (std::size_t i = 0; i < study.targets.size() && c.status_so_far(); ++i) {
    const auto* target = std::get_if<ThingTarget>(&study.targets[i].shape);
    if (!target) continue;
    const std::string place = "targets[" + std::to_string(i) + "].thing";
    c.require(study.scene != nullptr, place, "is named, and there is no scene that it could stand in");
    const bool there = std::ranges::any_of(all, [&](const NamedThing& each) { return each.name == target->thing; });
    c.require(!study.scene || there, place, "no thing of the scene is called \"" + target->thing + "\"",
              list_of_names(all));
  }
  return c.status();
}

}  // namespace physim
