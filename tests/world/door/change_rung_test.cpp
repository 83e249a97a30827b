// A projectile that changes its rung flies on as one that was on it from the start.
#include "must.hpp"
#include "physim/physim.hpp"

namespace physim::world_change_rung_test {

TEST(World, a_rung_of_another_interpolation_reads_its_own_curves) {
  World world;
  ProjectileDef p{.name = "shell", .mass = 40, .diameter = 0.155, .drag = {.table = DragTable::g7}};
  Fidelity rung = Fidelity::constant_air();
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

// The count of steps since the launch is then no whole number that can be held.
TEST(ChangeRung, a_step_can_be_as_short_against_the_age_as_steps_can_be) {
  WorldDef def{.environment = {.gravity = {.model = GravityModel::off}, .atmosphere = {.model = AirModel::vacuum}},
               .ground = {.mode = GroundMode::none}};
  World world = must(World::create(def));
  ProjectileDef p{.fidelity = Fidelity::constant_air()};
  const ProjectileId id = *world.spawn(p, {.position = {0, 100, 0}, .velocity = Vec3d{1, 0, 0}});
  for (int i = 0; i < 12; ++i) ASSERT_TRUE(world.step(9e5));
  ASSERT_TRUE(world.set_detail({.rungs = {{Fidelity::constant_air(), 5}, {Fidelity::game()}}}));
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(world.step(1e-9));
  EXPECT_TRUE(world[id].is_alive());
  EXPECT_EQ(world[id].fidelity_in_use().fidelity.integrator, Integrator::semi_implicit_euler);
}

}  // namespace physim::world_change_rung_test
