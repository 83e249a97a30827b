// Mixed fidelities: every projectile on its own rung, moved to another in flight, by hand or by distance to the camera.
#include <cstdio>
#include <physim/names.hpp>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  WorldDef def;
  def.environment.wind.velocity = {0, 0, -4};
  def.detail.rungs = {{.fidelity = Fidelity::simulation(), .within = 100}, {.fidelity = Fidelity::game()}};
  def.detail.layers = 2;  // the rule is for these only
  World world = World::create(def).value();

  ProjectileDef bullet = presets::rifle_bullet().projectile;
  const Launch launch{.position = {0, 2, 0}, .speed = 820, .elevation = 1_deg};
  ProjectileId ids[4];
  for (int i = 0; const char* rung : {"arcade", "game", "small_arms", "simulation"}) {
    bullet.fidelity = *fidelity_preset(rung);
    ids[i++] = *world.spawn(bullet, launch);
  }
  const ProjectileId watched = *world.spawn(bullet, launch, {.layers = 2});
  world.set_observer({0, 2, 0});

  std::size_t changes = 0;
  for (int frame = 0; frame < 60; ++frame) {
    world.single_step();
    for (const Event& event : world.events())
      if (event.kind == EventKind::fidelity_changed) ++changes;
  }
  for (const ProjectileId id : ids)
    std::printf("%-20s %7.2f m, %5.2f m high, %5.2f m to the left\n",
                name(world[id].fidelity_in_use().fidelity.integrator).data(), world[id].position().x,
                world[id].position().y, -world[id].position().z);
  std::printf("%zu cohorts; the watched one changed its rung %zu time: now %s\n", world.cohorts().size(), changes,
              name(world[watched].fidelity_in_use().fidelity.integrator).data());

  const Vec3d before = world[ids[1]].position();
  world[ids[1]].set_fidelity(Fidelity::reference());  // where it is and how it moves stays as it was
  return changes == 1 && world[ids[1]].position() == before ? 0 : 1;
}
