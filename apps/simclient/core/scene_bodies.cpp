// Bodies in flight at their attitude, the cone of their yaw, the flame of a motor; dust where they hit, and how far
// from a target that was.
#include <algorithm>
#include <cmath>

#include "math/angles.hpp"
#include "simclient/core/plane_axes.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/target_report.hpp"

namespace physim::client {
namespace {

bool is_round(const BodyLook& look) { return look.size.x == look.size.y; }

float least_pixels(const BodyLook& look, double scale, bool is_selected) {
  const double wished = is_round(look)                   ? 13
                        : look.shape == BodyShape::brick ? 26
                        : look.size.x > 8 * look.size.y  ? 44
                                                         : 30;
  return static_cast<float>(wished * scale * (is_selected ? 1.15 : 1));
}

/// Heights may be drawn larger than lengths: a nose along the path is one along the path as it is drawn.
Quatd as_drawn(const Camera& camera, const Quatd& attitude, const Vec3d& velocity) {
  if (camera.stretch == 1 || !(length(velocity) > 0)) return attitude;
  const Vec3d drawn{velocity.x, velocity.y * camera.stretch, velocity.z};
  return nose_along(drawn) * conjugate(nose_along(velocity)) * attitude;
}

/// Adds the flame behind the tail while the motor burns.
void add_flame(const Track& track, const SceneBody& body, double age, const Camera& camera, Scene& scene) {
  if (!track.burnout || age > *track.burnout || track.look.shape != BodyShape::rocket) return;
  const double drawn = std::max(body.look.size.x, static_cast<double>(body.pixels) * camera.pixel_size(body.at));
  const Vec3d back = camera.drawn_as(rotate(body.attitude, Vec3d{-drawn, 0, 0}));
  constexpr struct {
    double behind, size;
    Colour colour;
  } kParts[] = {{1.35, 0.5, 0x9C9C9C40},
                {1.1, 0.42, 0xB0A8A068},
                {0.9, 0.34, 0xFF7A2EA0},
                {0.72, 0.28, 0xFFB347D0},
                {0.58, 0.2, 0xFFF3C0F0}};
  for (const auto& part : kParts) {
    const auto size = static_cast<float>(part.size * drawn);
    scene.sprites.push_back({body.at + back * part.behind, part.colour, size, size, 0, 3});
  }
}

/// The part of a nose's direction that is across the path: to the right and up [rad].
struct Yaw {
  double right = 0, up = 0;
  [[nodiscard]] double size() const { return std::hypot(right, up); }
};
struct PathAxes : PlaneAxes {
  Vec3d along;
  explicit PathAxes(const Vec3d& velocity)
      : PlaneAxes(axes_across(normalized(velocity))), along(normalized(velocity)) {}
  [[nodiscard]] Yaw yaw_of(const Vec3d& nose) const {
    const double x = dot(nose, right), y = dot(nose, up), across = std::hypot(x, y);
    const double angle = std::atan2(across, dot(nose, along));
    return across > 0 ? Yaw{x / across * angle, y / across * angle} : Yaw{};
  }
  [[nodiscard]] Vec3d way(const Yaw& yaw) const {
    const double size = yaw.size(), part = size > 0 ? std::sin(size) / size : 1;
    return along * std::cos(size) + (right * yaw.right + up * yaw.up) * part;
  }
};

/// The yaw over the last 1.2 s, in order of time. A flight in a world has one entry, of the present moment.
std::vector<Yaw> yaws_of(const Track& track, const Session::Shown& now, double age) {
  constexpr double kWindow = 1.2;  // [s]
  constexpr int kCount = 160;
  std::vector<Yaw> yaws;
  for (int i = kCount; i > 0 && track.whole; --i) {
    const double time = age - kWindow * i / kCount;
    if (time < 0) continue;
    const Sample at = track.whole->at(time);
    yaws.push_back(PathAxes(at.velocity).yaw_of(rotate(at.orientation, Vec3d{1, 0, 0})));
  }
  yaws.push_back(PathAxes(now.velocity).yaw_of(rotate(now.attitude, Vec3d{1, 0, 0})));
  return yaws;
}

/// The factor by which yaws are drawn larger, 1 to 50: one of a degree or two is not visible.
double exaggeration(const std::vector<Yaw>& yaws) {
  constexpr double kWide = 24 * kDegree;
  double most = 0;
  for (const Yaw& yaw : yaws) most = std::max(most, yaw.size());
  for (const double factor : {50.0, 20.0, 10.0, 5.0, 2.0})
    if (factor * most <= kWide) return factor;
  return 1;
}

/// A cone about the path whose half angle is the yaw, and the way of the nose on its rim. The attitude that is drawn.
Quatd add_yaw_cone(const Client& client, double scale, const Track& track, const Session::Shown& now, Scene& scene) {
  constexpr double kTumbles = 60 * kDegree, kLeast = 0.02 * kDegree;
  const double age = client.session.shown_time() - track.born;
  if (now.yaw < kLeast || now.yaw > kTumbles || !(length(now.velocity) > 0)) return now.attitude;
  const Camera& camera = client.camera;
  const std::vector<Yaw> yaws = yaws_of(track, now, age);
  const double factor = exaggeration(yaws), reach = 84 * scale * camera.pixel_size(now.position);
  const Vec3d v{now.velocity.x, now.velocity.y * camera.stretch, now.velocity.z};
  const PathAxes axes(v);
  const auto rim = [&](const Yaw& yaw) {
    return now.position + camera.drawn_as(axes.way({yaw.right * factor, yaw.up * factor}) * reach);
  };
  const Colour colour = faded(colours::kForce, 0.8);
  constexpr int kSides = 40;
  const auto on_circle = [&](int i) {
    const double angle = 2 * kPi * i / kSides;
    return rim({now.yaw * std::cos(angle), now.yaw * std::sin(angle)});
  };
  for (int i = 0; i < kSides; ++i) {
    scene.line(on_circle(i), on_circle(i + 1), colour, 1.4 * scale, kCased);
    if (i % 10 == 0) scene.line(now.position, on_circle(i), faded(colour, 0.45), scale, 0);
  }
  scene.line(now.position, rim({}), faded(colour, 0.6), scale, 0);
  for (std::size_t i = 1; i < yaws.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(yaws.size());
    scene.line(rim(yaws[i - 1]), rim(yaws[i]), faded(track.colour, part * part), 1.6 * scale, 0);
  }
  scene.ball(rim(yaws.back()), track.colour, 3 * scale);
  scene.label(
      rim({0, now.yaw}),
      formatted("yaw %.2f\u00b0", now.yaw / kDegree) + (factor > 1 ? formatted(", drawn \u00d7%g", factor) : ""),
      colours::kForce, -1);
  const Vec3d nose = rotate(now.attitude, Vec3d{1, 0, 0});
  const Yaw yaw = PathAxes(now.velocity).yaw_of(nose);
  const Vec3d drawn = PathAxes(now.velocity).way({yaw.right * factor, yaw.up * factor});
  const Vec3d axis = cross(nose, drawn);
  const double turned = std::atan2(length(axis), dot(nose, drawn));
  return length(axis) > 0 ? turn_about(normalized(axis), turned) * now.attitude : now.attitude;
}

/// A cloud that grows and thins out, away from a surface.
void add_puff(Scene& scene, const Camera& camera, double scale, const Vec3d& at, const Vec3d& normal, double age,
              double radius, Colour colour) {
  const double part = age / Session::kDustTime, pixel = camera.pixel_size(at);
  const double size = std::max(5 * radius, 13 * scale * pixel) * (0.35 + 0.65 * std::sqrt(part));
  const PlaneAxes plane = axes_across(normal);
  const double opacity = 0.55 * (1 - part) * (1 - part);
  constexpr int kClouds = 7;
  for (int i = 0; i < kClouds; ++i) {
    const double angle = 2.4 * i, out = size * (i == 0 ? 0 : 0.5 + 0.06 * i);
    const Vec3d aside = plane.right * std::cos(angle) + plane.up * std::sin(angle);
    const auto wide = static_cast<float>(size * (1.2 - 0.08 * i));
    scene.sprites.push_back({at + (aside * out + normal * (0.45 * size + 0.3 * out * part)), faded(colour, opacity),
                             wide, wide, 0, static_cast<float>(3 * scale)});
  }
}

constexpr Colour kDust = 0xCBBD9CFF, kSpray = 0xDCEBF5FF, kChips = 0xB9B4ACFF;

Colour dust_of(const std::string& material) {
  if (material.find("water") != material.npos || material.find("ice") != material.npos) return kSpray;
  return material.find("soil") != material.npos || material.find("sand") != material.npos ? kDust : kChips;
}

}  // namespace

void build_bodies(Client& client, double scale, Scene& scene) {
  const Track* selected = client.selected_track();
  for (const Track& track : client.session.tracks()) {
    if (!track.is_flying() || mesh_of(track.look.shape).empty() || client.session.presence_of(track) <= 0) continue;
    const Session::Shown now = client.session.shown(track);
    const double age = client.session.shown_time() - track.born;
    const bool has_cone = client.show.attitude && &track == selected && turns(track.granted.fidelity);
    const Quatd attitude = has_cone ? add_yaw_cone(client, scale, track, now, scene) : now.attitude;
    SceneBody body{now.position, as_drawn(client.camera, attitude, now.velocity), track.look, track.colour,
                   least_pixels(track.look, scale, &track == selected)};
    add_flame(track, body, age, client.camera, scene);
    scene.bodies.push_back(body);
  }
}

/// Adds dust where hits were within the last Session::kDustTime, and a dark spot at each impact on the ground.
void build_dust(const Client& client, double scale, Scene& scene) {
  if (scene.globe) return;
  const Session& session = client.session;
  const double now = session.shown_time();
  const auto age_of = [&](double time) { return now >= time && now - time < Session::kDustTime ? now - time : -1; };
  const physim::Scene* things = session.world().scene();
  for (const Track& track : session.tracks()) {
    if (!track.impact || !scene.has_ground ||
        std::abs(track.impact->position.y - scene.ground) > 3 * track.radius + 0.01)
      continue;
    const Vec3d at{track.impact->position.x, scene.ground, track.impact->position.z};
    if (things == nullptr && session.presence_of(track) >= 1)
      scene.discs.push_back({at, 0x1C1712A0, static_cast<float>(1.6 * track.radius), static_cast<float>(5 * scale)});
    if (const double age = age_of(track.born + track.impact->time); age >= 0)
      add_puff(scene, client.camera, scale, at, {0, 1, 0}, age, track.radius, kDust);
  }
  if (things == nullptr) return;
  constexpr std::size_t kMost = 24;
  const auto& hits = session.hits().hits();
  for (std::size_t i = hits.size() - std::min(hits.size(), kMost); i < hits.size(); ++i) {
    const Hit& hit = hits[i];
    const double age = age_of(hit.time);
    const auto thing = age >= 0 && !is_passed(hit) ? things->state(hit.instance, now) : std::nullopt;
    if (!thing || hit.speed() < 5) continue;
    add_puff(scene, client.camera, scale, place_in_world(*thing, hit.at), rotate(thing->rotation, hit.normal), age,
             hit.radius, dust_of(hit.material));
  }
}

/// Labels each target with the report of the selected shot, if it was fired by hand.
void build_misses(Client& client, double scale, Scene& scene) {
  if (!client.show.marks) return;
  const Track* track = client.selected_track();
  if (track == nullptr || !track->by_hand || track->whole) return;
  for (const TargetDisc& target : targets_of(client.session.scenario())) {
    auto report = report_of(target, client.session, *track);
    if (!report) continue;
    if (!report->has_hit) report->change = client.aim_change_of(*track, target);
    const Colour colour = report->has_hit ? palette(2) : colours::kWarning;
    scene.label(target.middle + Vec3d{0, target.radius, 0}, report->text(target.radius), colour, -1.6);
    if (report->has_hit || report->short_by > 0) continue;
    const Vec3d way = target.middle - track->samples.front().position;
    const Vec3d right = normalized(cross(way, Vec3d{0, 1, 0}));
    const Vec3d at = target.middle + right * report->right + Vec3d{0, report->up, 0};
    scene.line(at, target.middle, faded(colour, 0.8), 1.2 * scale, kCased);
    scene.ball(at, colour, 3 * scale);
  }
}

}  // namespace physim::client
