// The ground: a grid, and scale lines across the line of fire with their distances.
#include <cmath>

#include "math/angles.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

/// The axis of the world that the shot flies along most: scale lines do not turn with every touch of the aim.
Vec3d main_axis(double azimuth) {
  switch (static_cast<int>(std::lround(azimuth / kRightAngle)) & 3) {
    case 0: return {1, 0, 0};
    case 1: return {0, 0, 1};
    case 2: return {-1, 0, 0};
    default: return {0, 0, -1};
  }
}

/// Behind a thing, or within it. Letters, unlike what they stand at, are drawn over everything.
bool is_hidden(const Client& client, const Vec3d& at) {
  const physim::Scene* things = client.session.world().scene();
  if (things == nullptr) return false;
  const Camera& camera = client.camera;
  Vec3d eye = camera.eye();
  eye.y = camera.target.y + (eye.y - camera.target.y) / camera.stretch;
  const Vec3d nearly = at + (eye - at) * 1e-3;  // what it lies on does not hide it
  return things->any_hit({.from = eye, .to = nearly, .time = client.session.shown_time()}, {.sensors = false});
}

/// The wall that stops what reaches it: its foot, its sides, and how far away it is.
void build_wall(const Client& client, double scale, double size, Scene& scene) {
  const std::optional<double>& wall = client.session.scenario().world.wall;
  if (!wall || !client.session.scenario().world.given) return;
  const Vec3d foot{*wall, scene.ground, client.launcher.shot().launch.position.z};
  const Vec3d right{0, 0, size / 2}, up{0, 0.75 * size, 0};
  const Vec3d corners[] = {foot - right, foot + right, foot + right + up, foot - right + up};
  for (int i = 0; i < 4; ++i) scene.line(corners[i], corners[(i + 1) % 4], colours::kWarning, 2 * scale);
  scene.label(foot + up, "wall, " + distance_text(*wall), colours::kWarning, -1);
}

}  // namespace

void build_ground(const Client& client, double scale, Scene& scene) {
  const Camera& camera = client.camera;
  const Vec3d muzzle = client.launcher.shot().launch.position;
  const Vec3d along = main_axis(client.launcher.azimuth()), across = {-along.z, 0, along.x};
  const Vec3d origin = {muzzle.x, scene.has_ground ? scene.ground : muzzle.y, muzzle.z};
  const double seen = camera.distance * 1.6;
  const double step = scale_step(seen, 10);
  scene.grid_origin = origin;
  scene.grid_step = step;
  if (scene.globe || !scene.has_scale) return;
  const double middle = std::round(dot(camera.target - origin, along) / step);
  constexpr int kMarks = 14;
  const double reach = 24 * step;
  scene.line(origin + along * (middle * step - reach), origin + along * (middle * step + reach), colours::kText,
             1.5 * scale, reach);
  for (int i = -kMarks; i <= kMarks; ++i) {
    // Distances from the muzzle stand on the line of fire, with a thick mark.
    const double x = (middle + i) * step;
    const Vec3d mark = origin + along * x, half = across * (step * 0.12);
    scene.line(mark - half, mark + half, colours::kText, 2.5 * scale, reach);
    if (!is_hidden(client, mark))
      scene.labels.push_back({mark + across * (step * 0.16),
                              step < 1000 ? distance_text(x) : formatted("%.6g km", x / 1000), colours::kText, false,
                              0});
  }
  if (scene.has_ground) build_wall(client, scale, step, scene);
}

}  // namespace physim::client
