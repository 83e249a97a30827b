// A bullet goes through a plank and stops in a wall.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Scene scene;
  const auto put = [&](const Material& material, double x, const Vec3d& half) {
    const MaterialId made_of = scene.add_material(material).value();
    return scene.add({scene.add_shape(BoxShape{half}).value(), {.position = {x, 0, 0}}, made_of}).ok();
  };
  if (!put(materials::fir(), 50, {0.009, 1, 0.1}) || !put(materials::concrete(30e6), 60, {0.15, 2, 3})) return 1;
  World world = World::create({}).value();
  if (!world.set_scene(scene)) return 1;
  const BodyDef body{.collision = {.on_hit = OnHit::impact}};
  if (!world.spawn({.mass = 168_gr, .diameter = 0.308_in}, {.position = {0, 0.1, 0}, .speed = 780}, body)) return 1;
  for (int i = 0; i < 60; ++i) {
    world.step(1.0 / 60);
    for (const Event& e : world.events())
      std::printf("%.4f s: %s at %.3f m, %.1f m/s\n", e.time, name(e.kind).data(), e.position.x, length(e.velocity));
  }
}
