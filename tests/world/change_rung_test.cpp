// A projectile that changes its rung flies on as one that was on it from the start.
#include <gtest/gtest.h>

#include "physim/physim.hpp"

namespace physim {
namespace world_change_rung_test {

TEST(World, a_rung_of_another_interpolation_reads_its_own_curves) {
  World world;
  ProjectileDef p{.name = "shell", .mass = 40, .diameter = 0.155};
  p.drag.table = DragTable::g7;
  Fidelity rung = Fidelity::sport_ball();
  for (const DragTable table : {DragTable::g1, DragTable::g8}) {  // curves of cubic that pchip does not have
    ProjectileDef other = p;
    other.drag.table = table;
    other.fidelity = rung;
    other.fidelity.interpolation = Interpolation::cubic;
    world.add_kind(other);
  }
  p.fidelity = rung;
  p.fidelity.interpolation = Interpolation::cubic;
  const Launch launch{.position = {0, 100, 0}, .speed = 400};
  const ProjectileId changed = *world.spawn(p, launch);
  p.fidelity = rung;
  const ProjectileId from_start = *world.spawn(p, launch);
  ASSERT_TRUE(world[changed].set_fidelity(rung));
  for (int i = 0; i < 10; ++i) world.step(0.01);
  EXPECT_EQ(world[changed].state(), world[from_start].state());
}

}  // namespace world_change_rung_test
}  // namespace physim
