// Rigid bodies in a world: generators, changes of rung, sleep, bounces, snapshots.
#include "rigid.hpp"
#include "world/world_support.hpp"

namespace physim::world_rigid_world_test {

using namespace test;

ProjectileDef brick_on(Integrator integrator, Precision precision = Precision::float64) {
  ProjectileDef p = nasa_brick();
  p.fidelity = rigid(integrator);
  p.fidelity.precision = precision;
  return p;
}

Launch thrown() {
  Launch launch = spun_launch();
  launch.position = {0, 100, 0};
  launch.speed = 20;
  launch.elevation = 0.5;
  return launch;
}

bool same_turn(const World& a, ProjectileId x, const World& b, ProjectileId y) {
  const Quatd p = a[x].orientation(), q = b[y].orientation();
  return same_bits(a[x].angular_velocity(), b[y].angular_velocity()) && same_bits(p.w, q.w) && same_bits(p.x, q.x) &&
         same_bits(p.y, q.y) && same_bits(p.z, q.z);
}

TEST(RigidWorld, generators_do_not_change_how_it_turns) {
  for (const Integrator i : {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun,
                             Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      World free, pushed;
      const ProjectileId a = *free.spawn(brick_on(i, precision), thrown());
      const ProjectileId b = *pushed.spawn(brick_on(i, precision), thrown());
      ASSERT_TRUE(pushed[b].add_force(ConstantForce{{1, 2, 3}}));
      for (int step = 0; step < 100; ++step) {
        ASSERT_TRUE(free.step(0.01));
        ASSERT_TRUE(pushed.step(0.01));
      }
      // Adaptive integrators divide the steps of the free one.
      if (is_adaptive(i))
        EXPECT_TRUE(near(free[a].angular_velocity(), pushed[b].angular_velocity(),
                         precision == Precision::float32 ? 1e-4 : 1e-7));
      else
        EXPECT_TRUE(same_turn(free, a, pushed, b)) << text(i);
      EXPECT_GT(length(free[a].position() - pushed[b].position()), 0.1);
    }
}

TEST(RigidWorld, adaptive_integrators_divide_frames) {
  World world;
  const ProjectileId id = *world.spawn(brick_on(Integrator::dop853), thrown());
  for (int step = 0; step < 2; ++step) ASSERT_TRUE(world.step(1.0));
  const Flight flight =
      fly(nasa_brick(), thrown(), {}, rigid(Integrator::dop853), {1e-13, 1e-13}, {.ground = {}, .time = 2});
  EXPECT_TRUE(
      near(world[id].angular_velocity(), rotate(flight.end().orientation, flight.end().angular_velocity), 1e-8));
}

TEST(RigidWorld, a_landing_is_found_where_a_flight_finds_it_and_a_bounce_goes_on_turning) {
  World world = make_world({.ground = {.mode = GroundMode::bounce}});
  const ProjectileId id = *world.spawn(brick_on(Integrator::rk4), thrown(), {.can_sleep = false});
  for (int step = 0; step < 700; ++step) ASSERT_TRUE(world.step(0.01));
  const Flight flight =
      fly(nasa_brick(), thrown(), {}, rigid(Integrator::rk4), {.step = 0.01}, {.ground = {}, .time = 7});
  EXPECT_GT(length(world[id].position() - flight.end().position), 1);  // it bounced
  EXPECT_TRUE(
      near(world[id].angular_velocity(), rotate(flight.end().orientation, flight.end().angular_velocity), 1e-6));
}

TEST(RigidWorld, attitude_survives_a_change_of_form_and_of_precision) {
  World world;
  ProjectileDef shell = brick_on(Integrator::rk4);
  shell.inertia.moments = {0.02, 0.2, 0.2};
  shell.fidelity.body_form = BodyForm::axis;
  const ProjectileId id = *world.spawn(shell, thrown());
  for (int step = 0; step < 50; ++step) ASSERT_TRUE(world.step(0.01));
  const Quatd q = world[id].orientation();
  const Vec3d omega = world[id].angular_velocity();
  Fidelity f = shell.fidelity;
  f.body_form = BodyForm::quaternion;
  ASSERT_TRUE(world[id].set_fidelity(f));
  EXPECT_TRUE(near(world[id].angular_velocity(), omega, 1e-13));
  EXPECT_TRUE(near(rotate(world[id].orientation(), Vec3d{1, 2, 3}), rotate(q, Vec3d{1, 2, 3}), 1e-13));
  f.precision = Precision::float32;
  ASSERT_TRUE(world[id].set_fidelity(f));
  EXPECT_TRUE(near(world[id].angular_velocity(), omega, 1e-6));
  f.rotation = RotationModel::none;
  ASSERT_TRUE(world[id].set_fidelity(f));
  EXPECT_EQ(world[id].angular_velocity(), Vec3d{});
  f.rotation = RotationModel::rigid_body;
  ASSERT_TRUE(world[id].set_fidelity(f));
  EXPECT_TRUE(near(rotate(world[id].orientation(), Vec3d{1, 0, 0}), normalized(world[id].velocity()), 1e-6));
}

// Both rungs hold seven numbers, with other meanings.
TEST(RigidWorld, spin_and_direction_survive_a_change_between_rigid_body_and_modified_point_mass) {
  ProjectileDef p{.mass = 15,
                  .diameter = 0.1,
                  .twist = 2,
                  .inertia = {.moments = {0.02, 0.2, 0.2}},
                  .aero = {.lift = {{0, 0, 1.6}}, .pitching = {{0, 0, 3.5}}}};
  Fidelity repose = Fidelity::simulation(), rigid = repose;
  repose.integrator = rigid.integrator = Integrator::rk4;
  repose.rotation = RotationModel::modified_point_mass;
  rigid.rotation = RotationModel::rigid_body;
  repose.body_form = rigid.body_form = BodyForm::axis;
  p.fidelity = repose;
  World world;
  const ProjectileId id = *world.spawn(p, {.speed = 300, .elevation = 0.6});
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(world.step(0.001));
  const auto spin_now = [&] {
    return dot(world[id].angular_velocity(), rotate(world[id].orientation(), Vec3d{1, 0, 0}));
  };
  const double spin = spin_now();
  EXPECT_NEAR(spin, 2 * 3.14159265358979323846 * 300 / 2, 1);
  for (const Fidelity& next : {rigid, repose}) {
    const Vec3d nose = rotate(world[id].orientation(), Vec3d{1, 0, 0});
    ASSERT_TRUE(world[id].set_fidelity(next));
    ASSERT_EQ(world[id].fidelity_in_use().fidelity.rotation, next.rotation);
    EXPECT_NEAR(spin_now(), spin, 1e-9 * spin);
    EXPECT_TRUE(near(rotate(world[id].orientation(), Vec3d{1, 0, 0}), nose, 1e-9));
  }
  ASSERT_TRUE(world.step(0.001));
  EXPECT_NEAR(spin_now(), spin, 1e-6 * spin);
}

TEST(RigidWorld, angular_velocity_can_be_set_and_sleep_stops_it) {
  World world;
  const ProjectileId id = *world.spawn(brick_on(Integrator::rk4), thrown());
  ASSERT_TRUE(world[id].set_angular_velocity({1, 2, 3}));
  EXPECT_TRUE(near(world[id].angular_velocity(), Vec3d{1, 2, 3}, 1e-14));
  ASSERT_TRUE(world[id].sleep());
  EXPECT_LT(length(world[id].angular_velocity()), 1e-15);
}

TEST(RigidWorld, snapshots_hold_it_and_the_hash_sees_it) {
  World world;
  const ProjectileId id = *world.spawn(brick_on(Integrator::rk4), thrown());
  ASSERT_TRUE(world.step(0.01));
  const Snapshot then = world.snapshot();
  const std::uint64_t hash = world.hash();
  ASSERT_TRUE(world.step(0.01));
  const Quatd q = world[id].orientation();
  ASSERT_TRUE(world.restore(then));
  EXPECT_EQ(world.hash(), hash);
  ASSERT_TRUE(world.step(0.01));
  EXPECT_TRUE(same_bits(world[id].orientation().w, q.w));
  ASSERT_TRUE(world.restore(then));
  ASSERT_TRUE(world[id].set_angular_velocity({1, 2, 3}));
  EXPECT_NE(world.hash(), hash);
}

}  // namespace physim::world_rigid_world_test
