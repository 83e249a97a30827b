// Newton's cradle: five steel balls hang side by side on rods; the one that is let go drives the last one out.
#include <algorithm>
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
  const BodyDef ball{.can_sleep = false,
                     .restitution = 1,
                     .friction = 0,
                     .collision = {.on_hit = OnHit::bounce, .radius = 0.015, .others = 1}};
  constexpr double kRod = 0.2, kApart = 0.0301;  // [m]
  ProjectileId row[5];
  for (int i = 0; i < 5; ++i) {
    const double out = i == 0 ? 0.5 : 0;  // [rad]
    const Vec3d from{kApart * i, 0, 0};
    const Vec3d at = from + Vec3d{-kRod * std::sin(out), -kRod * std::cos(out), 0};
    row[i] = world.spawn(steel, {.position = at, .velocity = Vec3d{}}, ball).value();
    if (!world.add_joint({.kind = JointKind::rod, .a = row[i], .point = from, .length = kRod})) return 1;
  }
  double farthest = 0;  // of the last ball [m]
  for (int frame = 0; frame < 240; ++frame) {
    world.step(1.0 / 480);
    farthest = std::max(farthest, world[row[4]].position().x - 4 * kApart);
  }
  std::printf("the first ball was let go %.1f mm out; the last one came %.1f mm out\n", 1e3 * kRod * std::sin(0.5),
              1e3 * farthest);
  return std::abs(farthest - kRod * std::sin(0.5)) < 0.003 ? 0 : 1;
}
