// Rain about a camera that drives and then cuts to another place: always as dense, and dry below a roof.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;
using namespace physim::units;

int main() {
  World world = World::create({.ground = {.mode = GroundMode::land}}).value();
  Scene scene;
  const ShapeId roof = scene.add_shape(BoxShape{{5, 0.1, 5}}).value();
  if (!scene.add({.shape = roof, .transform = {.position = {200, 6, 0}}})) return 1;
  if (!world.set_scene(scene)) return 1;

  EmitterDef def;
  def.kind = world
                 .add_kind({.mass = 0.0005_g, .diameter = 1_mm, .fidelity = Fidelity::arcade()},
                           {.use_gravity = false, .collision = {.on_hit = OnHit::stop}})
                 .value();
  def.rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, -90_deg);  // forwards is down
  def.per_second = {0};
  def.rain = {.density = 2, .size = {30, 14, 30}, .drift = {1, 0, 0.5}, .shelter = 50};
  def.start = {.lifetime = {kInfinity}, .speed = {3.5, 4.5}};  // drops of 1 mm, as fast as they fall
  def.maximum = 50'000;
  const EmitterId rain = world.add_emitter(def).value();

  Vec3d camera{0, 7, 0};
  const auto place = [&] { return Transform{camera, def.rotation}; };
  for (int frame = 0; frame < 180; ++frame) {  // 30 m/s, three seconds
    camera.x += 0.5;
    if (!world.move_emitter(rain, place())) return 1;
    world.single_step();
  }
  const std::size_t while_driving = world.particles(rain, {});

  camera = {200, 7, 0};  // a cut: from one frame to the next
  if (!world.jump_emitter(rain, place())) return 1;
  for (int frame = 0; frame < 120; ++frame) world.single_step();

  std::vector<Vec3d> position(world.particles(rain, {}));
  world.particles(rain, {.position = position});
  std::size_t below = 0, beside = 0;
  for (const Vec3d& p : position) {
    if (p.y < 5 && std::abs(p.x - 200) < 3 && std::abs(p.z) < 3) ++below;
    if (p.y < 5 && std::abs(p.x - 190) < 3 && std::abs(p.z) < 3) ++beside;
  }
  const double expected = 2.0 * 30 * 14 * 30;
  std::printf("%zu drops about the camera on its way, %.0f expected\n", while_driving, expected);
  std::printf("a room full of drops beside the roof: %zu; below it: %zu\n", beside, below);
  const bool is_right = std::abs(static_cast<double>(while_driving) - expected) < 0.03 * expected;
  return is_right && below < beside / 10 ? 0 : 1;
}
