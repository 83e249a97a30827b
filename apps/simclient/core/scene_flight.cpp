// What flies: projectiles, their trails, marks and vectors; and the aim.
#include <algorithm>
#include <cmath>

#include "base/members.hpp"
#include "model/ladder.hpp"
#include "physim/environment.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/trail_colours.hpp"

namespace physim::client {
namespace {

void cross(Scene& scene, const Camera& camera, double scale, const Vec3d& at, const Vec3d& one, const Vec3d& other,
           Colour colour) {
  const double size = 5 * scale * camera.pixel_size(at);
  for (const Vec3d& way : {one, other}) {
    const Vec3d arm = camera.drawn_as(way * size);
    scene.line(at - arm, at + arm, colour, 2 * scale, kCased);
  }
}

/// How high a place is and how far from another along the ground. Over a round Earth the plane at the origin leaves the
/// ground behind: there it is the altitude, and the way around.
struct Reach {
  double height = 0, distance = 0;  // [m]
};
Reach reach_of(const Session& session, const Track& track, const Vec3d& from, const Vec3d& at) {
  const Vec3d way = at - from;
  const EarthModel earth = track.granted.fidelity.earth;
  if (row(earth).shape == EarthShape::flat) return {at.y, std::hypot(way.x, way.z)};
  const EarthFrames frames(session.scenario().environment, earth);
  const Vec3d a = frames.earth_fixed(from, {}).position, b = frames.earth_fixed(at, {}).position;
  const double angle = std::atan2(length(physim::cross(a, b)), dot(a, b));
  return {frames.geodetic(at).height, angle * (length(a) - frames.geodetic(from).height)};
}

/// `is_told`: by labels that stay; those of other tracks give way.
void mark(Scene& scene, const Session& session, const Camera& camera, double scale, const Track& track, bool is_told) {
  const Vec3d right = camera.right(), up = camera.up();
  if (track.apex) {
    const Vec3d at = track.apex->position;
    const double height = reach_of(session, track, at, at).height;
    constexpr double kShown = 0.005;  // [m]; a hop that the label shows as 0.00 m has no mark
    if (std::abs(height) >= kShown) {
      cross(scene, camera, scale, at, right, up, track.colour);
      scene.label(at, "apex " + distance_text(std::round(100 * height) / 100) + formatted(", %.2f s", track.apex->time),
                  track.colour, -2, !is_told);
    }
  }
  if (track.whole && track.status == LifeStatus::expired) {  // at the end that its scenario sets
    const Sample end = track.whole->end();
    cross(scene, camera, scale, end.position, right + up, right - up, track.colour);
    scene.label(end.position, distance_text(std::round(1000 * end.range) / 1000) + formatted(" in %.3f s", end.time),
                track.colour, 1, !is_told);
    scene.label(end.position, formatted("drop %.3f m, windage %.3f m", end.drop, end.windage), track.colour, 2,
                !is_told);
  }
  if (track.impact) {
    const Vec3d at = track.impact->position;
    cross(scene, camera, scale, at, right + up, right - up, track.colour);
    const Reach reach = reach_of(session, track, track.samples.front().position, at);
    const double range = std::round(100 * reach.distance) / 100;
    if (range > 0)  // what fell where it was says nothing
      scene.label(at, distance_text(range) + formatted(" in %.2f s", track.impact->time), track.colour, 1, !is_told);
  }
}

/// One of many that are drawn as their emitter says, such as smoke: its own path and number would only hide them.
bool is_soft(const Client& client, const Track& track) {
  if (track.by_hand || track.id == client.selected) return false;
  return std::ranges::any_of(client.session.scenario().emitters, [&](const ScenarioEmitter& each) {
    return each.shot == track.name && has_sizes(each.def);
  });
}

/// Those that are not among the tracks: too many to remember, not too many to draw.
void add_crowd(const Session& session, double scale, Scene& scene) {
  const World& world = session.world();
  const auto tracks = session.tracks();
  const auto flying =
      std::count_if(tracks.begin(), tracks.end(), [](const Track& t) { return t.is_flying() && !t.whole; });
  if (world.size() <= static_cast<std::size_t>(flying)) return;
  const std::vector<ProjectileId> ids = world.ids();
  scene.crowd_size = static_cast<float>((ids.size() > 20000 ? 2 : ids.size() > 200 ? 3 : 6) * scale);
  scene.crowd.reserve(ids.size());
  for (const ProjectileId id : ids) {
    if (std::ranges::binary_search(scene.drawn, id)) continue;
    const Colour colour = world[id].colour();
    scene.crowd.push_back({session.shown_position(id), colour == kNoColour ? colours::kVelocity : colour});
  }
}

/// An effect of the ledger, as its arrow is called.
struct ShownForce {
  const char* name;
  Vec3d Accelerations::*effect;
};
constexpr ShownForce kShownForces[] = {{"gravity", &Accelerations::gravity},
                                       {"drag", &Accelerations::drag},
                                       {"Magnus", &Accelerations::lift},
                                       {"body", &Accelerations::body},
                                       {"thrust", &Accelerations::thrust},
                                       {"Coriolis", &Accelerations::coriolis},
                                       {"centrifugal", &Accelerations::centrifugal},
                                       {"applied", &Accelerations::applied},
                                       {"constraint", &Accelerations::constraint}};
static_assert(std::size(kShownForces) + 1 == kMemberCount<Accelerations>, "each effect has its arrow, and the total");

}  // namespace

void build_projectiles(const Client& client, double scale, Scene& scene) {
  add_crowd(client.session, scale, scene);
  const Track* selected = client.selected_track();
  const std::optional<TrailScale> by = trail_scale(client);
  if (by) scene.legend = by->legend();
  if (client.show.trails && !client.filmed && client.session.step() < client.session.last_step())  // gone back from
    for (const Track& track : client.session.known_tracks())
      scene.polyline(track.samples, client.camera, faded(track.colour, 0.3), 1.2 * scale, 0);
  for (const Track& track : client.session.tracks()) {
    const double width = (&track == selected ? 2.5 : 1.8) * scale, presence = client.session.presence_of(track);
    if (presence <= 0 || is_soft(client, track)) continue;
    const double part = (track.is_flying() ? 0.9 : 0.6) * presence;
    if (client.show.trails && by) {
      if (!client.theme->is_light) scene.ribbon(track.samples, client.camera, *by, 0.18 * part, 4 * width, 0);
      scene.ribbon(track.samples, client.camera, *by, part, 1.3 * width);
    } else if (client.show.trails) {
      scene.polyline(track.samples, client.camera, faded(track.colour, part), width);
    }
    if (client.show.marks && presence > 0.5)
      mark(scene, client.session, client.camera, scale, track, &track == selected);
    if (!track.is_flying()) continue;
    const Vec3d at = client.session.shown(track).position;
    const Colour colour = by ? (*by)(track.samples.back()) : track.colour;
    if (client.show.trails) scene.line(track.samples.back().position, at, faded(colour, 0.9), width, kCased);
    if (mesh_of(track.look.shape).empty())
      scene.ball(at, track.colour, (&track == selected ? 6.5 : 5.5) * scale, track.radius);
    scene.label(at, "#" + std::to_string(track.number), track.colour, -1);
  }
}

/// Cues of height: the path over the ground, lines down to it from each projectile and from its apex, and shadows.
/// Over things there is no one ground, and none of these.
void build_depth(const Client& client, double scale, Scene& scene) {
  const Camera& camera = client.camera;
  if (!scene.has_ground || scene.globe || client.session.world().scene() != nullptr) return;
  constexpr Colour kShade = 0x0A0E12A0;
  std::vector<TrackSample> below;
  for (const Track& track : client.session.tracks()) {
    if (client.session.presence_of(track) < 1 || is_soft(client, track)) continue;
    const auto foot = [&](const Vec3d& at) { return Vec3d{at.x, scene.ground, at.z}; };
    below = track.samples;
    for (TrackSample& s : below) s.position.y = scene.ground, s.velocity.y = 0;
    const bool is_flying = track.is_flying();
    const Vec3d at = is_flying ? client.session.shown(track).position : track.samples.back().position;
    if (is_flying) below.push_back({.time = below.back().time, .position = foot(at)});
    if (client.show.trails) scene.polyline(below, camera, kShade, 1.6 * scale, 0);
    if (track.apex && client.show.marks)
      scene.line(track.apex->position, foot(track.apex->position), faded(track.colour, 0.45), scale);
    if (!is_flying) continue;
    scene.line(at, foot(at), faded(track.colour, 0.6), 1.2 * scale);
    scene.discs.push_back(
        {foot(at), 0x06080A90, static_cast<float>(1.2 * track.radius), static_cast<float>(7 * scale)});
  }
}

void build_comparison(Client& client, double scale, Scene& scene) {
  int line = 0;
  const std::vector<ComparedRung>& rungs = client.comparison();
  const double part = client.is_comparison_old() ? 0.4 : 1;
  for (const ComparedRung& rung : rungs) {
    if (rung.path.empty()) continue;
    scene.polyline(rung.path, client.camera, faded(rung.colour, part), (rung.is_truth ? 3 : 2) * scale);
    scene.label(rung.path.back().position, rung.name, rung.colour, line++);
  }
}

void build_aim(Client& client, double scale, Scene& scene) {
  if (client.session.is_replay() || !client.show.aim) return;
  const Prediction& prediction = client.prediction();
  if (prediction.error) return;
  if (client.show.prediction) {
    std::vector<TrackSample> ahead = prediction.path;
    if (const Track* last = client.last_of_this_shot())  // its trail shows the rest
      std::erase_if(ahead, [last](const TrackSample& s) { return s.time <= last->samples.back().time; });
    scene.dots(ahead, client.camera, faded(colours::kText, prediction.is_old ? 0.3 : 0.75), scale);
  }
  scene.ball(prediction.muzzle, colours::kArrow, 3 * scale);
  const auto arrow = client.arrow();
  if (!arrow) return;
  const auto before = static_cast<std::ptrdiff_t>(scene.lines.size());
  scene.arrow(arrow->from, arrow->to, colours::kArrow, 3 * scale, client.camera);
  scene.on_top.assign(scene.lines.begin() + before, scene.lines.end());
  scene.lines.resize(static_cast<std::size_t>(before));
}

void build_vectors(const Client& client, double scale, Scene& scene) {
  const Track* track = client.selected_track();
  if (track == nullptr || !track->is_flying()) return;
  const Session::Shown now = client.session.shown(*track);
  const Vec3d &at = now.position, &velocity = now.velocity;
  const double longest = client.camera.distance * 0.22;
  const auto draw = [&](const Vec3d& from, const Vec3d& way, Colour colour, const std::string& what) {
    const Vec3d tip = from + way;
    scene.arrow(from, tip, colour, 2.5 * scale, client.camera);
    if (what.empty()) return;
    const Vec3d beyond = client.camera.drawn_as(normalized(way) * (16 * scale * client.camera.pixel_size(tip)));
    scene.label(tip + beyond, what, colour, -0.5);
    const auto foot = client.camera.project(from), end = client.camera.project(tip);
    const double across = foot && end ? end->x - foot->x : 0, down = foot && end ? end->y - foot->y : 0;
    if (across != 0 || down != 0) scene.labels.back().side = across / std::hypot(across, down);
  };
  if (const double speed = length(velocity); speed > 0)
    draw(at, velocity * (longest / speed), colours::kVelocity, formatted("v %.2f m/s", speed));

  Accelerations a = now.accelerations;
  const Fidelity& f = track->granted.fidelity;
  const bool by_loop = f.integrator == Integrator::classic && f.motion != Motion::closed_form;
  if (by_loop && f.drag == DragModel::damping) a.drag = {};  // it acts on the velocity, and is no force there
  const double mass = now.mass;
  double strongest = length(a.total);
  for (const ShownForce& each : kShownForces) strongest = std::max(strongest, length(a.*each.effect));
  if (!(strongest > 0) || !std::isfinite(mass)) return;
  const double unit = longest * 0.8 / strongest;  // of all of them, so that they can be added by eye
  Vec3d from = at;
  for (const ShownForce& each : kShownForces) {
    const Vec3d& effect = a.*each.effect;
    if (!(length(effect) > 0)) continue;
    const bool is_seen = length(effect) >= 0.02 * strongest;
    if (!is_seen && !client.show.forces_add_up) continue;
    draw(from, effect * unit, colours::kForce, is_seen ? formatted("%s %.3g N", each.name, length(effect) * mass) : "");
    if (client.show.forces_add_up) from += effect * unit;
  }
  const double total = length(a.total);
  if (total > 0)
    draw(at, a.total * unit, colours::kAcceleration, formatted("a %.3g m/s\u00b2, m a %.3g N", total, total * mass));
}

}  // namespace physim::client
