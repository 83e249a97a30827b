#include "simclient/core/scene.hpp"

#include <algorithm>
#include <cmath>

#include "simclient/core/stroke.hpp"

namespace physim::client {

void Scene::clear() {
  lines.clear();
  on_top.clear();
  balls.clear();
  bodies.clear();
  legend.reset();
  discs.clear();
  crowd.clear();
  sprites.clear();
  lights.clear();
  glow.clear();
  drawn.clear();
  labels.clear();
}

void Scene::line(const Vec3d& a, const Vec3d& b, Colour colour, double width, double fog) {
  lines.push_back({a, b, colour, static_cast<float>(width), static_cast<float>(fog)});
}

void Scene::ball(const Vec3d& at, Colour colour, double pixels, double radius) {
  balls.push_back({at, colour, static_cast<float>(radius), static_cast<float>(pixels)});
}

namespace {

/// The cubic through two samples with their velocities, at a part of the way; nothing where they do not belong to one
/// smooth curve, as at a hit.
std::optional<Vec3d> on_curve(const TrackSample& a, const TrackSample& b, double part) {
  const double time = b.time - a.time;
  const Vec3d way = b.position - a.position;
  const double off = length(way - (a.velocity + b.velocity) * (0.5 * time));
  if (!(off < 0.1 * length(way))) return std::nullopt;
  const double t = part, u = 1 - part;
  return a.position * (u * u * (1 + 2 * t)) + b.position * (t * t * (1 + 2 * u)) + a.velocity * (time * t * u * u) -
         b.velocity * (time * t * t * u);
}

/// A point of a path, and the number of the sample before it with the part of the way to the next.
struct PathPoint {
  Vec3d at;
  std::size_t sample = 0;
  double part = 0;
};

/// Points of a path so near on the screen that lines between them are as smooth as it is.
std::vector<PathPoint> points_of(const std::vector<TrackSample>& samples, const Projector& view) {
  constexpr double kApart = 14, kMostBetween = 32;  // [pixels]; points between two samples
  std::vector<PathPoint> points;
  points.reserve(samples.size());
  std::optional<Pixel> last;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::optional<Pixel> at = view.project(samples[i].position);
    const double apart = at && last ? std::hypot(at->x - last->x, at->y - last->y) : 0;
    const double count = std::min(std::floor(apart / kApart), kMostBetween);
    for (double k = 1; k <= count; ++k)
      if (const auto point = on_curve(samples[i - 1], samples[i], k / (count + 1)))
        points.push_back({*point, i - 1, k / (count + 1)});
    points.push_back({samples[i].position, i, 0});
    last = at;
  }
  return points;
}

}  // namespace

void Scene::polyline(const std::vector<TrackSample>& samples, const Camera& camera, Colour colour, double width,
                     double fog) {
  const Projector view = camera.projector();
  const std::vector<PathPoint> points = points_of(samples, view);
  const auto kept = points_of_stroke(points.size(), [&](std::size_t i) { return view.project(points[i].at); });
  for (std::size_t i = 1; i < kept.size(); ++i) line(points[kept[i - 1]].at, points[kept[i]].at, colour, width, fog);
}

void Scene::ribbon(const std::vector<TrackSample>& samples, const Camera& camera, const SampleColour& colour_of,
                   double opacity, double width, double fog) {
  const Projector view = camera.projector();
  const std::vector<PathPoint> points = points_of(samples, view);
  const auto kept = points_of_stroke(points.size(), [&](std::size_t i) { return view.project(points[i].at); });
  const auto colour_at = [&](const PathPoint& p) {
    return colour_of(p.part > 0 ? between(samples[p.sample], samples[p.sample + 1], p.part) : samples[p.sample]);
  };
  for (std::size_t i = 1; i < kept.size(); ++i) {
    std::size_t from = kept[i - 1];
    Colour colour = colour_at(points[from]);
    for (std::size_t k = from + 1; k <= kept[i]; ++k) {
      const Colour next = colour_at(points[k]);
      if (next == colour && k < kept[i]) continue;
      line(points[from].at, points[k].at, faded(colour, opacity), width, fog);
      from = k, colour = next;
    }
  }
}

/// Dots of equal distance on the screen, so that a path is dotted near and far.
void Scene::dots(const std::vector<TrackSample>& samples, const Camera& camera, Colour colour, double scale) {
  const double gap = 9 * scale;  // [pixels]
  const Projector view = camera.projector();
  double way = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Vec3d a = samples[i - 1].position, b = samples[i].position;
    const auto from = view.project(a), to = view.project(b);
    if (!from || !to) continue;
    const double length = std::hypot(to->x - from->x, to->y - from->y);
    if (length > 4 * camera.width()) continue;
    for (double at = gap - way; at <= length; at += gap) ball(a + (b - a) * (at / length), colour, 1.6 * scale);
    way = std::fmod(way + length, gap);
  }
}

void Scene::arrow(const Vec3d& from, const Vec3d& to, Colour colour, double width, const Camera& camera) {
  const Vec3d way = camera.shown(to) - camera.shown(from);
  const double size = length(way);
  if (!(size > 0)) return;
  const Vec3d along = way * (1 / size);
  Vec3d across = cross(along, camera.forward());
  if (length(across) < 1e-6) across = camera.right();
  across = normalized(across);
  const double head = std::min(size * 0.35, camera.pixel_size(to) * 6 * width);
  line(from, to, colour, width, kCased);
  for (const double side : {-0.5, 0.5})
    line(to, to + camera.drawn_as(across * (head * side) - along * head), colour, width, kCased);
}

void Scene::label(const Vec3d& at, const std::string& text, Colour colour, double line, bool gives_way) {
  labels.push_back({.at = at, .text = text, .colour = colour, .line = line, .gives_way = gives_way});
}

double haze_of(const Camera& camera) { return 9 * camera.distance; }

double scale_step(double length, double wanted) {
  const double rough = std::max(length, 1e-9) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double part : {1.0, 2.0, 5.0})
    if (part * power >= rough * 0.999) return part * power;
  return 10 * power;
}

std::string distance_text(double metres) {
  const bool far = std::abs(metres) >= 10000;
  return formatted(far ? "%.6g km" : "%.6g m", far ? metres / 1000 : metres);
}

namespace {

/// The next shot goes farther than up or down, among no things: distances stand at the height of its muzzle then.
bool flies_level(Client& client) {
  if (client.session.is_replay() || client.session.world().scene() != nullptr) return false;
  const auto& path = client.prediction().path;
  if (path.empty()) return false;
  double low = path[0].position.y, high = low, far = 0;
  for (const TrackSample& s : path) {
    low = std::min(low, s.position.y), high = std::max(high, s.position.y);
    far = std::max(far, std::hypot(s.position.x - path[0].position.x, s.position.z - path[0].position.z));
  }
  return far > 2 * (high - low);
}

}  // namespace

void build_scene(Client& client, double scale, Scene& scene) {
  scene.clear();
  scene.theme = client.theme;
  scene.quality = client.quality.now;
  scene.globe = globe_of(client);
  scene.ground = client.session.ground().value_or(0);
  scene.has_ground = client.session.ground().has_value();
  scene.has_scale = scene.has_ground || flies_level(client);
  scene.contour_step = scale_step(client.camera.distance, 20);
  build_ground(client, scale, scene);
  build_things(client, scale, scene);
  build_misses(client, scale, scene);
  build_particles(client, scale, scene);
  if (client.show.depth) build_depth(client, scale, scene);
  build_globe(client, scale, scene);
  build_projectiles(client, scale, scene);
  build_bodies(client, scale, scene);
  build_dust(client, scale, scene);
  if (client.bottom == BottomPanel::compare) build_comparison(client, scale, scene);
  build_aim(client, scale, scene);
  if (client.show.vectors) build_vectors(client, scale, scene);
  build_cursor(client, scale, scene);
  build_tools(client, scale, scene);
  if (scene.quality != Quality::high) thin_crowd(client.camera, scene);
  build_glow(client.camera, scale, scene);
}

}  // namespace physim::client
