// What lies, rolls or slides on a thing is one contact: told once, and the same at any step, height and frame rate.
#include "scene_support.hpp"

namespace physim::world_staying_test {

using namespace test_scene;

BodyDef rolling(double resistance, double radius) {
  return {.can_sleep = false,
          .restitution = 0,
          .friction = 0.4,
          .rolling_resistance = resistance,
          .collision = {.on_hit = OnHit::bounce, .radius = radius}};
}
MeshShape square(double half) {
  return {{{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}}, {{0, 2, 1}, {0, 3, 2}}, {}};
}
HeightFieldShape field(double half) {
  HeightFieldShape shape{.columns = 9, .rows = 9, .spacing_x = half / 4, .spacing_z = half / 4};
  shape.heights.assign(81, 0);
  return shape;
}

/// 0.5 m/s against a rolling resistance of 0.01: v^2 / (2 c g) = 1.27465 m, of a solid ball 7/5 of that; whatever the
/// surface, its height, and the step.
TEST(Staying, what_rolls_to_rest_rolls_as_far_at_every_step_and_height) {
  const double right = 0.25 / (2 * 0.01 * kG);
  const ShapeDef shapes[] = {BoxShape{{8, 1, 8}}, PlaneShape{}, square(8), field(8)};
  const double below[] = {1, 0, 0, 0}, aside[] = {0, 0, 0, 8};
  for (int i = 0; i < 4; ++i)
    for (const double height : {0.0, 100.0, 1000.0})
      for (const double step : {1e-3, 1.0 / 60, 1.0 / 30})
        for (const double radius : {0.0, 0.1}) {
          Scene scene;
          put(scene, shapes[i], {-aside[i], height - below[i], -aside[i]});
          World world = make_world(space(), scene);
          ProjectileDef ball{.mass = 1, .diameter = 0.2, .fidelity = rung(Integrator::rk4)};
          Launch launch{.position = {0.3, height + radius, 0.2}, .velocity = Vec3d{0.3, 0, 0.4}};
          const ProjectileId id = *world.spawn(ball, launch, rolling(0.01, radius));
          if (radius > 0) {
            ASSERT_TRUE(world[id].set_angular_velocity(Vec3d{0.4, 0, -0.3} * (1 / radius)));
          }
          const auto events = run_for(world, 8, step);
          const double k = radius > 0 ? 1.4 : 1;
          const std::string where = std::to_string(i) + " at " + std::to_string(height) + " m, " +
                                    std::to_string(step) + " s, radius " + std::to_string(radius);
          EXPECT_NEAR(length(world[id].position() - launch.position), k * right, 1e-6) << where;
          EXPECT_EQ(length(world[id].velocity()), 0) << where;
          EXPECT_LE(test::of_kind(events, EventKind::hit).size(), 1u) << where;
        }
}

/// One hit at any frame rate: a ball falls, strikes, and rolls for ten seconds.
TEST(Staying, what_rolls_on_is_hit_once) {
  for (const double rate : {24.0, 60.0, 1000.0})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Scene scene;
      put(scene, BoxShape{{100, 1, 100}}, {0, -1, 0});
      World world = make_world(space(), scene);
      ProjectileDef ball{.mass = 1, .diameter = 0.2, .fidelity = rung(Integrator::rk4, precision)};
      BodyDef body = rolling(0, 0.1);
      const ProjectileId id = *world.spawn(ball, {.position = {0, 1, 0}, .velocity = Vec3d{3, 0, 1}}, body);
      const auto hits = test::of_kind(run_for(world, 10, 1 / rate), EventKind::hit);
      EXPECT_EQ(hits.size(), 1u) << rate;
      // Some spacings of float32 at 30 m.
      EXPECT_NEAR(world[id].position().y, 0.1, precision == Precision::float32 ? 1e-5 : 1e-9);
    }
}

/// A lift that starts smoothly carries what lies on it, and lets it go where it slows by more than g: keys from 0 to
/// 1 m within 0.5 s leave it at 0.35107 s, and at 0.5 s it is 1.101708 m high.
TEST(Staying, a_lift_carries_and_lets_go) {
  for (const double rate : {30.0, 60.0, 240.0, 1000.0}) {
    Scene scene;
    InstanceDef lift{.shape = *scene.add_shape(BoxShape{{1, 0.1, 1}}),
                     .transform = {.position = {0, -0.1, 0}},
                     .material = *scene.add_material({.restitution = 0, .friction = 1})};
    KeyedMotion keys{.keys = {{.time = 0, .position = {0, -0.1, 0}}, {.time = 0.5, .position = {0, 0.9, 0}}},
                     .curve = MotionCurve::smooth};
    lift.motion = keys;
    ASSERT_TRUE(scene.add(lift));
    World world = make_world(space(), scene);
    ProjectileDef ball{.mass = 1, .diameter = 0.1, .fidelity = rung(Integrator::rk4)};
    const ProjectileId id = *world.spawn(ball, {.position = {0, 0.05, 0}}, rolling(0, 0.05));
    const auto events = run_for(world, 0.5, 1 / rate);
    EXPECT_NEAR(world[id].position().y, 1.1017083848, 1e-4) << rate;
    EXPECT_LE(test::of_kind(events, EventKind::hit).size(), 1u) << rate;
  }
}

/// A flight that begins on a thing rolls there as far as in a world.
TEST(Staying, a_flight_begins_on_a_thing) {
  Scene scene;
  put(scene, PlaneShape{}, {});
  for (const double radius : {0.0, 0.1}) {
    Until until = meeting(scene, OnHit::bounce, radius);
    until.time = 9;
    until.contact.restitution = 0;
    until.contact.friction = 0.4;
    until.contact.rolling_resistance = radius > 0 ? 0 : 0.01;
    const Flight flight = fly(stone(), {.position = {0, radius, 0}, .velocity = Vec3d{0.5, 0, 0}}, vacuum_of(kG),
                              rung(Integrator::rk4), {.step = 0.01}, until);
    // The ball slides until it rolls at 5/7 of its speed, with 0.4 * 0.5 of its weight.
    const double slides = 0.5 * 2 / 7 / (0.2 * kG), rolls = 0.5 * 5 / 7;
    const double rolled = 0.5 * (0.5 + rolls) * slides + rolls * (9 - slides);
    EXPECT_NEAR(flight.end().position.x, radius > 0 ? rolled : 0.25 / (2 * 0.01 * kG), 1e-6) << radius;
  }
}

/// What a bounce takes is told, as what a material takes is: of the whole of a projectile that stops.
TEST(Staying, hits_tell_the_energy_that_they_take) {
  for (const OnHit on_hit : {OnHit::bounce, OnHit::stop, OnHit::stick}) {
    Scene scene;
    add_thing(scene, PlaneShape{}, {.material = *scene.add_material({.restitution = 0.8, .friction = 0})});
    WorldDef def = space();
    def.environment = vacuum_of(0);
    World world = make_world(def, scene);
    ProjectileDef ball{.mass = 2, .fidelity = rung(Integrator::rk4)};
    BodyDef body = rolling(0, 0);
    body.restitution = 1;
    body.collision.on_hit = on_hit;
    ASSERT_TRUE(world.spawn(ball, {.position = {0, 1, 0}, .velocity = Vec3d{3, -4, 0}}, body));
    const bool bounces = on_hit == OnHit::bounce;
    const auto told = test::of_kind(run_for(world, 0.5), bounces ? EventKind::bounced : EventKind::hit);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_NEAR(told[0].energy, bounces ? 16 * (1 - 0.64) : 25, 1e-12);
  }
}

}  // namespace physim::world_staying_test
