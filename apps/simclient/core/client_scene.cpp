// What the mouse does in the scene of a client, and what it puts there.
#include <cmath>

#include "simclient/core/client.hpp"

namespace physim::client {

void Client::use_tool(Tool wanted) {
  tool = tool == wanted ? Tool::fire : wanted;
  tape = {};
  wall_from.reset();
  if (tool == Tool::tape) say("tape measure: click two points on paths, things or the ground");
  if (tool == Tool::wall || tool == Tool::target) fit_sizes(placing, camera.distance);
  if (tool == Tool::wall) say("wall: click where its two ends stand");
  if (tool == Tool::target) say("target: click on a path, a thing or the ground");
}

void Client::select_under(const Pixel& pixel) {
  const auto found = probe(pixel);
  if (found && found->track != nullptr) return void(selected = found->track->id);
  say(session.is_replay() ? "nothing flies here" : "nothing flies here; Enter fires the next shot");
}

void Client::click(const Pixel& pixel) {
  if (tool == Tool::fire) {
    if (!fires_by_click()) return select_under(pixel);
    if (Status status = fire_by_hand(); !status) complain(status.error());
    return;
  }
  const std::optional<Vec3d> point = tool == Tool::wall     ? surface_under(pixel)
                                     : tool == Tool::target ? target_under(pixel)
                                                            : point_under(pixel);
  if (!point) return complain({"there is nothing", "here", "click on a path, a thing or the ground"});
  if (tool == Tool::tape) {
    if (tape.from && !tape.to)
      tape.to = point;
    else
      tape = {point, std::nullopt};
    return;
  }
  if (tool == Tool::wall && !wall_from) return void(wall_from = point);
  const Status status = tool == Tool::wall ? place_wall(*wall_from, *point) : place_target(*point);
  wall_from.reset();
  if (!status) return complain(status.error());
  tool = Tool::fire;
}

std::optional<Vec3d> Client::point_under(const Pixel& pixel) {
  if (const auto found = probe(pixel)) return found->sample.position;
  return surface_under(pixel);
}

std::optional<Vec3d> Client::surface_under(const Pixel& pixel) const {
  const std::optional<Vec3d> ground = camera.at_height(pixel, session.ground().value_or(0));
  const physim::Scene* scene = session.world().scene();
  if (scene == nullptr) return ground;
  // Rays are straight as they are drawn; heights may be stretched there.
  const Ray ray = camera.ray(pixel);
  const auto in_world = [&](const Vec3d& shown) {
    return Vec3d{shown.x, camera.target.y + (shown.y - camera.target.y) / camera.stretch, shown.z};
  };
  SceneSegment segment;
  segment.from = in_world(ray.origin);
  segment.to = in_world(ray.origin + ray.direction * (1e4 * camera.distance));
  segment.time = session.shown_time();
  const SceneHit hit = scene->first_hit(segment);
  if (!hit) return ground;
  const bool is_nearer = !ground || length(hit.position - segment.from) < length(*ground - segment.from);
  return is_nearer || !session.ground() ? hit.position : *ground;
}

namespace {

/// The place at which a path crosses a height, of several the nearest in time to `time` [s]; nullopt if it never does.
std::optional<Vec3d> nearest_as_high(const std::vector<TrackSample>& path, double time, double height) {
  std::optional<TrackSample> best;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const TrackSample &a = path[i - 1], &b = path[i];
    if ((a.position.y < height) == (b.position.y < height)) continue;
    const TrackSample there = between(a, b, (height - a.position.y) / (b.position.y - a.position.y));
    if (!best || std::abs(there.time - time) < std::abs(best->time - time)) best = there;
  }
  return best ? std::optional(best->position) : std::nullopt;
}

}  // namespace

std::optional<Vec3d> Client::target_under(const Pixel& pixel) {
  if (const auto found = probe(pixel)) {
    const Vec3d at = found->sample.position;
    const double least = session.ground().value_or(at.y - placing.radius) + placing.radius;
    if (at.y >= least) return at;
    const auto& path = found->track ? found->track->samples : prediction().path;
    return nearest_as_high(path, found->sample.time, least).value_or(at);
  }
  std::optional<Vec3d> place = surface_under(pixel);
  if (place) place->y += placing.radius;
  return place;
}

Status Client::place_wall(const Vec3d& from, const Vec3d& to) {
  return place(with_wall(session.scenario(), from, to, placing));
}

Status Client::place_target(const Vec3d& middle) {
  return place(with_target(session.scenario(), middle, launcher.shot().launch.position, placing));
}

Status Client::place(const Result<Placed>& placed) {
  if (!placed) return placed.error();
  if (Status status = session.set_scene(placed->scenario); !status) return status;
  unsaved_ = true;
  ++session_version_;
  content_.scene = ++contents_;
  note_changes();
  const std::string of = placing.material.empty() ? "" : " of " + placing.material;
  return say(placed->name + of + "; Ctrl+Z takes it away"), Status();
}

std::optional<AimChange> Client::aim_change_of(const Track& track, const TargetDisc& target) {
  constexpr std::size_t kMost = 64;
  for (const Missed& each : missed_)
    if (each.id == track.id && each.target == target.name && each.session_version == session_version_)
      return each.change;
  missed_.push_back({track.id, target.name, session_version_, aim_change(target, session, track)});
  if (missed_.size() > kMost) missed_.pop_front();
  return missed_.back().change;
}

const Scenery& Client::scenery() {
  // Planes reach so far that their edges are beyond what is looked at.
  const double reach = std::exp2(std::ceil(std::log2(40 * camera.distance + length(camera.target))));
  return scenery_.make(session.world().scene(), session_version_, session.shown_time(), reach, session.ground());
}

}  // namespace physim::client
