// First bullet: a world stepped by frame, an id, and the event that tells where and when it landed.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  World world;  // ground at height 0, where flights end; standard atmosphere; 60 steps a second
  ProjectileDef bullet = presets::rifle_bullet().projectile;
  bullet.fidelity = Fidelity::game();  // the one line that a simulation changes: Fidelity::simulation()

  const auto id = world.spawn(bullet, {.position = {0, 1.5, 0}, .speed = 800_mps, .elevation = 0.2_deg});
  if (!id) return std::puts(id.error().text().c_str()), 1;
  const Projectile tracer = world[*id];
  for (int frame = 0; tracer.is_alive(); ++frame) {
    if (frame % 24 == 0) {  // drawn at 144 frames a second, between the steps of the world
      const Vec3d at = tracer.render_position();
      std::printf("frame %3d: %6.1f m, %.2f m high, Mach %.2f\n", frame, at.x, at.y, tracer.mach());
    }
    world.advance(1.0 / 144);  // seconds that have passed on the screen
    for (const Event& event : world.events())
      if (event.kind == EventKind::landed) std::printf("landed after %.4f s at %.2f m\n", event.time, event.position.x);
  }
  return tracer.status() == LifeStatus::landed ? 0 : 1;
}
