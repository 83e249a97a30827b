// Saves a world in the middle of a game, and goes on with what was loaded: the same to the last bit.
#include <cstdio>

#include "physim/physim.hpp"

using namespace physim;
using namespace physim::units;

int main() {
  // A force of one's own cannot be saved: it is handed in again.
  const auto wind = [](const ForceBatch& batch) {
    for (Vec3d& force : batch.force) force.z += 0.02;
  };
  World world;
  ProjectileDef shell = presets::rifle_bullet().projectile;
  shell.fidelity = Fidelity::constant_air();
  for (int i = 0; i < 100; ++i)
    if (!world.spawn(shell, {.position = {0, 2, 0}, .speed = 100_mps, .elevation = 0.01 * i}, {}, 0.02 * i)) return 1;
  if (!world.add_force({.law = CustomForce{wind}, .target = ForceTarget::everything()})) return 1;
  for (int frame = 0; frame < 60; ++frame) world.single_step();

  const auto saved = world.save();
  if (!saved) return std::puts(saved.error().text().c_str()), 1;
  auto loaded = World::load(*saved, {.threading = {}, .custom_forces = {{wind}}});
  if (!loaded) return std::puts(loaded.error().text().c_str()), 1;
  std::printf("%zu projectiles at %.1f s\n", loaded->size(), loaded->time());

  for (int frame = 0; frame < 240; ++frame) world.single_step(), loaded->single_step();
  std::printf("%zu and %zu at %.1f s, %s\n", world.size(), loaded->size(), world.time(),
              world.hash() == loaded->hash() ? "equal to the bit" : "not equal");
  return world.hash() == loaded->hash() ? 0 : 1;
}
