// Newton's cradle: of five steel balls in a row the first one strikes; the last one leaves with its speed.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;

int main() {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  World world = World::create(def).value();
  ProjectileDef steel{.mass = 0.11, .diameter = 0.03};
  steel.fidelity.drag = DragModel::off;
  // They meet each other: `others` names the layers whose projectiles a ball meets.
  const BodyDef ball{.gravity_scale = 0,
                     .restitution = 1,
                     .friction = 0,
                     .collision = {.on_hit = OnHit::bounce, .radius = 0.015, .others = 1}};
  const double speed = 1.5;  // [m/s]
  ProjectileId row[5];
  for (int i = 0; i < 5; ++i) {
    const Launch launch{.position = {i == 0 ? -0.2 : 0.03 * i, 0, 0}, .velocity = Vec3d{i == 0 ? speed : 0, 0, 0}};
    row[i] = world.spawn(steel, launch, ball).value();
  }
  for (int frame = 0; frame < 30; ++frame) {
    world.step(1.0 / 60);
    for (const Event& e : world.events())
      if (e.kind == EventKind::hit && e.id.index < e.other.index)
        std::printf("%.6f s: ball %u strikes ball %u\n", e.time, e.id.index, e.other.index);
  }
  for (const ProjectileId id : row) std::printf("ball %u: %.6f m/s\n", id.index, world[id].velocity().x);
  return std::abs(world[row[4]].velocity().x - speed) < 1e-6 && length(world[row[0]].velocity()) < 1e-6 ? 0 : 1;
}
