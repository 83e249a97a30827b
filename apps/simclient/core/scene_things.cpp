// Things of the world's scene: their names, the marks of what hit them, and what a tool is about to put there.
#include <algorithm>
#include <cmath>

#include "math/angles.hpp"
#include "physim/names.hpp"
#include "simclient/core/plane_axes.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/target_report.hpp"
#include "simclient/core/timeline.hpp"

namespace physim::client {
namespace {

constexpr std::size_t kMostLabels = 4;  // of hits of the selected projectile

struct Plane : PlaneAxes {
  Vec3d middle;
};

/// Across a direction.
Plane plane_across(const Vec3d& middle, const Vec3d& normal) { return {axes_across(normal), middle}; }

void circle(Scene& scene, const Camera& camera, const Plane& plane, double radius, Colour colour, double width) {
  const double pixels = radius / camera.pixel_size(plane.middle);
  const int sides = pixels < 8 ? 12 : 32;
  const auto at = [&](int i) {
    const double angle = 2 * kPi * i / sides;
    return plane.middle + plane.right * (radius * std::cos(angle)) + plane.up * (radius * std::sin(angle));
  };
  for (int i = 0; i < sides; ++i) scene.line(at(i), at(i + 1), colour, width);
}

void star(Scene& scene, const Plane& plane, double size, Colour colour, double width) {
  for (const double side : {-1.0, 1.0}) {
    const Vec3d arm = (plane.right + plane.up * side) * (0.7 * size);
    scene.line(plane.middle - arm, plane.middle + arm, colour, width);
  }
}

/// A ring on the surface. What came in flat has an arrow the way it left; what stayed a cross; what went in a line to
/// its end, with a ring where it came out.
void mark(Scene& scene, const Client& client, double scale, const Hit& hit, const MotionState& thing, double presence) {
  const Camera& camera = client.camera;
  const Vec3d at = place_in_world(thing, hit.at), normal = rotate(thing.rotation, hit.normal);
  const double size = std::max(1.2 * hit.radius, 5 * scale * camera.pixel_size(at));
  const Plane plane = plane_across(at + normal * (0.05 * size), normal);
  const Colour colour = faded(client.session.colour_of(hit), presence * (is_passed(hit) ? 0.5 : 1));
  circle(scene, camera, plane, size, colour, 1.8 * scale);
  if (hit.outcome == EventKind::ricocheted && length(hit.after) > 0)
    scene.arrow(at, at + normalized(hit.after) * (5 * size), colour, 1.5 * scale, camera);
  if (hit.outcome == EventKind::stopped) star(scene, plane, size, colour, 1.8 * scale);
  if (hit.outcome != EventKind::penetrated && hit.outcome != EventKind::stopped) return;
  const Vec3d end = place_in_world(thing, hit.end);
  scene.line(at, end, colour, 2.2 * scale);
  if (hit.outcome == EventKind::penetrated)
    circle(scene, camera, plane_across(end - normal * (0.05 * size), normal), 0.6 * size, colour, 1.8 * scale);
}

void build_marks(const Client& client, double scale, Scene& scene) {
  const physim::Scene* things = client.session.world().scene();
  if (things == nullptr || !client.show.marks) return;
  const Track* selected = client.selected_track();
  const auto& hits = client.session.hits().hits();
  constexpr std::size_t kMostMarks = 60, kFading = 30;  // marks: the oldest of them fade
  const std::vector<TargetDisc> targets = targets_of(client.session.scenario());
  std::size_t labels = 0, marks = 0;
  for (auto hit = hits.rbegin(); hit != hits.rend() && marks < kMostMarks; ++hit, ++marks) {
    const auto thing = things->state(hit->instance, client.session.shown_time());
    if (!thing) continue;
    mark(scene, client, scale, *hit, *thing,
         std::min(1.0, static_cast<double>(kMostMarks - marks) / static_cast<double>(kFading)));
    if (selected == nullptr || selected->id != hit->id || is_passed(*hit) || labels++ >= kMostLabels) continue;
    const auto is_it = [&](const TargetDisc& each) { return each.name == hit->thing; };
    if (selected->by_hand && std::ranges::any_of(targets, is_it)) continue;  // a target says more itself
    scene.label(place_in_world(*thing, hit->at), hit_text(*hit), client.session.colour_of(*hit), -1);
  }
}

/// The edges of a box that stands upright on a line between two feet.
void build_wall_ghost(const Client& client, double scale, const Vec3d& from, const Vec3d& to, Scene& scene) {
  const Vec3d way{to.x - from.x, 0, to.z - from.z};
  if (!(length(way) > 0)) return;
  const Vec3d across = normalized(Vec3d{-way.z, 0, way.x}) * (client.placing.thickness / 2);
  const Vec3d low{0, std::min(from.y, to.y), 0}, up{0, client.placing.height, 0};
  const Vec3d a{from.x, low.y, from.z}, b{to.x, low.y, to.z};
  const Vec3d feet[] = {a - across, b - across, b + across, a + across};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d next = feet[(i + 1) % 4];
    scene.line(feet[i], next, colours::kForce, 2 * scale);
    scene.line(feet[i] + up, next + up, colours::kForce, 2 * scale);
    scene.line(feet[i], feet[i] + up, colours::kForce, 2 * scale);
  }
  scene.label((a + b) * 0.5 + up, formatted("%.4g m long, %.4g m high", length(way), client.placing.height),
              colours::kForce, -1);
}

void build_target_ghost(Client& client, double scale, const Vec3d& middle, Scene& scene) {
  const Vec3d way = middle - client.launcher.shot().launch.position;
  const Vec3d level{way.x, 0, way.z};
  if (!(length(level) > 0)) return;
  const Plane plane = plane_across(middle, normalized(level));
  for (const double part : {1.0, 2.0 / 3, 1.0 / 3})
    circle(scene, client.camera, plane, client.placing.radius * part, colours::kForce, 2 * scale);
  scene.label(middle + Vec3d{0, client.placing.radius, 0}, distance_text(std::round(10 * length(level)) / 10) + " away",
              colours::kForce, -1);
}

}  // namespace

std::string hit_text(const Hit& hit) {
  const double before = hit.speed(), after = hit.speed_after();
  const std::string what = hit.thing + ": " + std::string(name(hit.outcome));
  if (hit.outcome == EventKind::stopped)
    return what + (hit.depth > 0 ? formatted(" %.4g mm deep", 1000 * hit.depth) : "") + formatted(", %.4g m/s", before);
  if (is_passed(hit)) return what + formatted(", %.4g m/s", before);
  return what + formatted(", %.4g to %.4g m/s", before, after);
}

void build_things(Client& client, double scale, Scene& scene) {
  const Scenery& scenery = client.scenery();
  scene.scenery = scenery.is_empty() ? nullptr : &scenery;
  for (const SceneryEdge& edge : scenery.edges)
    scene.line(edge.a, edge.b, edge.colour, 1.2 * scale, 40 * client.camera.distance);
  build_marks(client, scale, scene);
  if (!client.show.marks) return;
  for (const SceneryName& each : scenery.names) scene.label(each.at, each.text, colours::kDim, -0.5);
}

/// Rings about all projectiles at the time that the mouse points at.
void build_cursor(const Client& client, double scale, Scene& scene) {
  if (!client.cursor) return;
  const Camera& camera = client.camera;
  for (const Track& track : client.session.known_tracks()) {
    const auto there = sample_at(track, *client.cursor);
    if (!there) continue;
    const Plane plane{{camera.drawn_as(camera.right()), camera.drawn_as(camera.up())}, there->position};
    circle(scene, camera, plane, 7 * scale * camera.pixel_size(there->position), track.colour, 2 * scale);
  }
}

void build_tools(Client& client, double scale, Scene& scene) {
  const std::optional<Pixel>& pointer = client.pointer;
  if (client.wall_from) scene.ball(*client.wall_from, colours::kForce, 4 * scale);
  if (client.tool == Tool::wall && pointer) {
    const auto to = client.surface_under(*pointer);
    if (to && client.wall_from) build_wall_ghost(client, scale, *client.wall_from, *to, scene);
    if (to) scene.ball(*to, colours::kForce, 4 * scale);
  }
  if (client.tool == Tool::target && pointer)
    if (const auto middle = client.target_under(*pointer)) build_target_ghost(client, scale, *middle, scene);
  const Tape& tape = client.tape;
  if (tape.from) scene.ball(*tape.from, colours::kForce, 4 * scale);
  if (!tape.from || !tape.to) return;
  const Vec3d way = *tape.to - *tape.from;
  scene.ball(*tape.to, colours::kForce, 4 * scale);
  scene.line(*tape.from, *tape.to, colours::kForce, 2 * scale);
  const Vec3d middle = (*tape.from + *tape.to) * 0.5;
  scene.label(middle, formatted("%.3f m", length(way)), colours::kForce, -1);
  scene.label(middle, formatted("along %.3f, up %.3f, right %.3f m", way.x, way.y, way.z), colours::kForce, 0);
}

}  // namespace physim::client
