// A rope bridge: planks hang on two cables between two walls; a heavy ball is dropped on one of them.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;

int main() {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  World world = World::create(def).value();
  ProjectileDef plank{.mass = 3, .diameter = 0.3}, boulder{.mass = 60, .diameter = 0.4};
  plank.fidelity.drag = boulder.fidelity.drag = DragModel::off;
  constexpr int kPlanks = 15;
  constexpr double kCable = 0.67, kWide = 1, kLong = 10;  // [m]

  // Two rows of ends of planks; a rod is the plank between them, cables lead from one plank to the next.
  std::vector<ProjectileId> sides[2];
  std::vector<Joint> joints;
  for (int side = 0; side < 2; ++side) {
    const double z = side * kWide;
    std::vector<ProjectileId>& ends = sides[side];
    for (int i = 1; i <= kPlanks; ++i)
      ends.push_back(world.spawn(plank, {.position = {kLong * i / (kPlanks + 1), 0, z}, .velocity = Vec3d{}}).value());
    joints.push_back({.kind = JointKind::cable, .a = ends.front(), .point = {0, 0, z}, .length = kCable});
    for (int i = 1; i < kPlanks; ++i)
      joints.push_back({.kind = JointKind::cable, .a = ends[i - 1], .b = ends[i], .length = kCable});
    joints.push_back({.kind = JointKind::cable, .a = ends.back(), .point = {kLong, 0, z}, .length = kCable});
  }
  for (int i = 0; i < kPlanks; ++i) joints.push_back({.kind = JointKind::rod, .a = sides[0][i], .b = sides[1][i]});
  for (const Joint& joint : joints)
    if (!world.add_joint(joint)) return 1;
  // The air and the ropes take energy.
  if (!world.add_force({LinearQuadraticDragForce{.k1 = 6}, ForceTarget::everything()})) return 1;

  const ProjectileId middle = sides[0][kPlanks / 2];
  for (int frame = 0; frame < 60 * 15; ++frame) world.step(1.0 / 60);
  const double sag = -world[middle].position().y;
  std::printf("the bridge hangs %.2f m deep\n", sag);
  // The boulder is tied to a plank's end where it lands.
  const ProjectileId load =
      world.spawn(boulder, {.position = world[middle].position() + Vec3d{0, 0.5, 0}, .velocity = Vec3d{}}).value();
  const JointId rope = world.add_joint({.kind = JointKind::cable, .a = load, .b = middle, .length = 0.5}).value();
  for (int frame = 0; frame < 60 * 15; ++frame) world.step(1.0 / 60);
  std::printf("with a boulder it hangs %.2f m deep, and holds it with %.0f N\n", -world[middle].position().y,
              world.joint_state(rope).tension);
  const double weight = 60 * 9.80665;
  return std::abs(world.joint_state(rope).tension - weight) < 0.05 * weight ? 0 : 1;
}
