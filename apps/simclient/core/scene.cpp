#include "simclient/core/scene.hpp"

#include <algorithm>
#include <cmath>

namespace physim::client {

void Scene::clear() {
  lines.clear();
  balls.clear();
  crowd.clear();
  sprites.clear();
  drawn.clear();
  labels.clear();
}

void Scene::line(const Vec3d& a, const Vec3d& b, Colour colour, double width, double fog) {
  lines.push_back({a, b, colour, static_cast<float>(width), static_cast<float>(fog)});
}

void Scene::ball(const Vec3d& at, Colour colour, double pixels, double radius) {
  balls.push_back({at, colour, static_cast<float>(radius), static_cast<float>(pixels)});
}

void Scene::polyline(const std::vector<TrackSample>& samples, Colour colour, double width) {
  const std::size_t stride = samples.size() / 800 + 1;  // more than the screen can show
  std::size_t last = 0;
  for (std::size_t i = stride; i < samples.size(); last = i, i += stride)
    line(samples[last].position, samples[i].position, colour, width);
  if (!samples.empty() && last + 1 < samples.size())
    line(samples[last].position, samples.back().position, colour, width);
}

/// Dots of equal distance on the screen, so that a path is dotted near and far.
void Scene::dots(const std::vector<TrackSample>& samples, const Camera& camera, Colour colour, double scale) {
  const double gap = 9 * scale;  // [pixels]
  double way = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Vec3d a = samples[i - 1].position, b = samples[i].position;
    const auto from = camera.project(a), to = camera.project(b);
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
  line(from, to, colour, width);
  for (const double side : {-0.5, 0.5})
    line(to, to + camera.drawn_as(across * (head * side) - along * head), colour, width);
}

void Scene::label(const Vec3d& at, const std::string& text, Colour colour, double line) {
  labels.push_back({at, text, colour, true, line});
}

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

void build_scene(Client& client, double scale, Scene& scene) {
  scene.clear();
  scene.ground = client.session.ground().value_or(0);
  scene.has_ground = client.session.ground().has_value();
  build_ground(client, scale, scene);
  build_things(client, scale, scene);
  build_particles(client, scale, scene);
  build_projectiles(client, scale, scene);
  if (client.bottom == BottomPanel::compare) build_comparison(client, scale, scene);
  build_aim(client, scale, scene);
  if (client.show.vectors) build_vectors(client, scale, scene);
  build_tools(client, scale, scene);
}

}  // namespace physim::client
