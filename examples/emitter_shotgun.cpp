// Shotgun: how densely each choke's pellets lie on a target at 40 yards, against the share that defines the choke.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;
using namespace physim::units;

namespace {

constexpr double kDistance = 36.576, kRadius = 0.381;  // 40 yards; a circle of 30 inches [m]
constexpr std::uint32_t kPellets = 410, kShots = 25;   // an ounce of number 8 shot

/// Where the pellets of all shots strike the target.
std::vector<Vec3d> pattern(double dispersion) {
  Scene scene;
  const ShapeId sheet = scene.add_shape(BoxShape{{0.01, 5, 5}}).value();
  if (!scene.add({.shape = sheet, .transform = {.position = {kDistance + 0.01, 0, 0}}})) return {};
  World world = World::create({.ground = {.mode = GroundMode::none}}).value();
  if (!world.set_scene(scene)) return {};

  EmitterDef def;  // a shell is a burst of pellets, a microsecond after each other
  def.kind =
      world.add_kind({.mass = 1_oz / kPellets, .diameter = 2.29_mm, .drag = {.table = DragTable::sphere}}).value();
  def.per_second = {0};
  def.gun = {.rounds_per_minute = 60e6,
             .burst_rounds = kPellets,
             .burst_pause = 0.5,
             .magazine = kPellets * kShots,
             .magazines = 1,
             .dispersion = dispersion};
  def.start.speed = {365, 375};
  if (!world.add_emitter(def)) return {};

  std::vector<Vec3d> holes;
  while (world.time() < 0.5 * kShots) {
    world.single_step();
    for (const Event& event : world.events())
      if (event.kind == EventKind::hit) holes.push_back(event.position);
  }
  return holes;
}

/// The part of them inside of the circle about their middle.
double share_of(const std::vector<Vec3d>& holes) {
  Vec3d middle;
  for (const Vec3d& hole : holes) middle += hole * (1.0 / static_cast<double>(holes.size()));
  double inside = 0;
  for (const Vec3d& hole : holes) inside += std::hypot(hole.y - middle.y, hole.z - middle.z) < kRadius;
  return inside / static_cast<double>(holes.size());
}

}  // namespace

int main() {
  // Source: Kent Wildfowling and Conservation Association, "More about Choke", kentwildfowlers.co.uk/chokes.htm:
  // pellets in a 30 inch circle at 40 yards. Half choke is called modified in America.
  const struct {
    const char* name;
    double share;
  } chokes[] = {{"true cylinder", 0.40}, {"improved cylinder", 0.50}, {"half", 0.60}, {"full", 0.70}};
  bool is_right = true;
  for (const auto& [choke, share] : chokes) {
    // Of a normal distribution, 1 - exp(-r^2 / (2 s^2)) lies within r of the middle (Rayleigh).
    const double dispersion = kRadius / std::sqrt(-2 * std::log(1 - share)) / kDistance;
    const std::vector<Vec3d> holes = pattern(dispersion);
    const double found = share_of(holes), sampling = std::sqrt(share * (1 - share) / static_cast<double>(holes.size()));
    std::printf("%-17s %4.1f mrad: %4.1f %% of %zu pellets, published %.0f %%\n", choke, dispersion / 1_mrad,
                100 * found, holes.size(), 100 * share);
    is_right = is_right && holes.size() == kPellets * kShots && std::abs(found - share) < 3 * sampling;
  }
  return is_right ? 0 : 1;
}
