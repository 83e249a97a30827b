// The Earth from far away: a ball, the ways over its ground, and pins at the highest and the lowest place of an orbit.
#include <algorithm>

#include "model/ladder.hpp"
#include "physim/environment.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

/// From so far away the Earth is round.
constexpr double kGlobeDistance = 30e3;  // [m]
constexpr double kAbove = 1.002;         // radii at which ways over the ground are drawn: before the ball

/// The foot of a place on the ball.
Vec3d foot(const SceneGlobe& globe, const Vec3d& at) {
  return globe.centre + normalized(at - globe.centre) * (kAbove * globe.radius);
}

/// A path as it is over the ground, with the velocities of its foot.
std::vector<TrackSample> over_ground(const SceneGlobe& globe, std::vector<TrackSample> path) {
  for (TrackSample& s : path) {
    const Vec3d way = s.position - globe.centre, up = normalized(way);
    s.velocity = (s.velocity - up * dot(s.velocity, up)) * (kAbove * globe.radius / length(way));
    s.position = foot(globe, s.position);
  }
  return path;
}

/// Behind the ball as the camera sees it.
bool is_hidden(const SceneGlobe& globe, const Camera& camera, const Vec3d& at) {
  const Vec3d eye = camera.eye(), way = at - eye, middle = globe.centre - eye;
  const double part = std::clamp(dot(middle, way) / dot(way, way), 0.0, 1.0);
  return length(middle - way * part) < globe.radius;
}

void pin(Scene& scene, const Camera& camera, const Apsis& apsis, const char* name, double scale) {
  const Vec3d below = foot(*scene.globe, apsis.at);
  scene.line(below, apsis.at, colours::kText, 1.5 * scale, kCased);
  scene.ball(below, colours::kText, 2.5 * scale);
  scene.ball(apsis.at, colours::kText, 4 * scale);
  const Colour colour = is_hidden(*scene.globe, camera, apsis.at) ? colours::kDim : colours::kText;
  scene.label(apsis.at, formatted("%s %.1f km", name, apsis.altitude / 1000), colour, -1);
}

}  // namespace

std::optional<SceneGlobe> globe_of(const Client& client) {
  const EarthModel earth = client.launcher.shot().projectile.fidelity.earth;
  if (row(earth).shape == EarthShape::flat || client.camera.distance < kGlobeDistance) return std::nullopt;
  const EarthFrames frames(client.session.scenario().environment, earth);
  const Vec3d origin = frames.earth_fixed({}, {}).position;
  SceneGlobe globe;
  globe.centre = frames.from_earth_fixed({}).position;
  globe.radius = length(origin) - frames.geodetic({}).height;
  std::size_t i = 0;
  for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
    constexpr double kFar = 1e6;  // [m]
    const Vec3d way = (frames.earth_fixed(axis * kFar, {}).position - origin) * (1 / kFar);
    for (const double x : {way.x, way.y, way.z}) globe.to_geographic[i++] = x;
  }
  return globe;
}

void build_globe(Client& client, double scale, Scene& scene) {
  if (!scene.globe) return;
  if (client.show.depth && client.show.trails)
    for (const Track& track : client.session.tracks())
      scene.polyline(over_ground(*scene.globe, track.samples), client.camera, faded(track.colour, 0.55), 1.4 * scale,
                     0);
  const Prediction& ahead = client.prediction();
  if (client.session.is_replay() || ahead.error || !client.show.aim || !client.show.prediction) return;
  if (client.show.depth)
    scene.polyline(over_ground(*scene.globe, ahead.path), client.camera, faded(colours::kText, 0.4), 1.2 * scale, 0);
  if (!client.show.marks || ahead.is_old) return;
  const Track* last = client.last_of_this_shot();
  const bool is_marked = last != nullptr && last->apex;  // with its height and time
  if (ahead.apsides.highest && !is_marked) pin(scene, client.camera, *ahead.apsides.highest, "Ap", scale);
  if (ahead.apsides.lowest) pin(scene, client.camera, *ahead.apsides.lowest, "Pe", scale);
}

}  // namespace physim::client
