// Round shot of a 12-pounder over the sea: flat ones skip, steep ones sink.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Scene scene;
  const MaterialId water = scene.add_material(materials::water()).value();
  if (!scene.add({.shape = scene.add_shape(PlaneShape{}).value(), .material = water})) return 1;
  WorldDef def;
  def.ground.mode = GroundMode::none;  // the sea is what there is
  World world = World::create(def).value();
  if (!world.set_scene(scene)) return 1;
  const ProjectileDef shot{.mass = 12_lb, .diameter = 0.1153};
  const BodyDef body{.collision = {.on_hit = OnHit::impact}, .despawn = {.below = -10, .older = 20}};
  for (const double elevation : {-2_deg, -4_deg, -8_deg}) {
    const ProjectileId id =
        world.spawn(shot, {.position = {0, 4, 0}, .speed = 300, .elevation = elevation}, body).value();
    int skips = 0;
    double range = 0;
    while (world[id].is_alive()) {
      world.step(1.0 / 60);
      for (const Event& e : world.events())
        if (e.kind == EventKind::ricocheted) ++skips, range = e.position.x;
    }
    std::printf("%2.0f degrees down: %d skips", -elevation / 1_deg, skips);
    std::printf(skips > 0 ? ", the last at %.0f m\n" : "\n", range);
  }
}
