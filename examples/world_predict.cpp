// Looks ahead: where a grenade will land if nothing changes, and a world that goes on with what a flight computed.
#include <cstdio>

#include "physim/physim.hpp"

using namespace physim;
using namespace physim::units;

int main() {
  World world;
  ProjectileDef grenade;
  grenade.mass = 400_g;
  grenade.diameter = 60_mm;
  grenade.drag.table = DragTable::sphere;
  grenade.fidelity = Fidelity::constant_air();
  const auto thrown = world.spawn(grenade, {.position = {0, 1.8, 0}, .speed = 25_mps, .elevation = 40_deg});
  if (!thrown) return std::puts(thrown.error().text().c_str()), 1;
  if (!world.add_force({.law = ConstantForce{{0, 0, 0.4}}, .target = ForceTarget::everything(), .delay = 1})) return 1;
  for (int frame = 0; frame < 30; ++frame) world.single_step();

  const Flight ahead = world.predict(*thrown, 10);  // until the ground, for 10 s at most
  const Sample impact = ahead.end();
  std::printf("in %.2f s it will be at %.2f m, %.2f m to the right\n", ahead.duration(), impact.position.x,
              impact.position.z);

  // Another world takes it over half a second from now.
  World other;
  const auto there = other.spawn(ahead, 0.5);
  if (!there) return std::puts(there.error().text().c_str()), 1;
  for (int frame = 0; frame < 30; ++frame) world.single_step();
  const bool equal = world[*thrown].position() == other[*there].position();
  std::printf("half a second later it is %s\n", equal ? "there, to the bit" : "elsewhere");
  return equal ? 0 : 1;
}
