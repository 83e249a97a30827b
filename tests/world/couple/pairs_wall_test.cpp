// Balls that touch a wall, or a row of others, when they are struck.
#include "scene_support.hpp"

namespace physim::world_pairs_wall_test {

using namespace test_scene;

constexpr double kRates[] = {24, 60, 250, 1000};
constexpr double kRadius = 0.1, kSpeed = 2;  // [m], [m/s]

ProjectileDef ball() { return {.mass = 1, .diameter = 2 * kRadius, .fidelity = rung(Integrator::rk4)}; }
BodyDef of_billiards(double restitution) {
  BodyDef body = bouncing(kRadius, restitution, 0);
  body.collision.others = 1;
  return body;
}
/// The velocities of a ball that came along a floor and of one that lay `gap` before a cushion.
std::vector<Vec3d> at_cushion(double restitution, double gap, double rate) {
  Scene scene;
  const MaterialId smooth = *scene.add_material({.restitution = 1, .friction = 0});
  put(scene, BoxShape{{40, 0.5, 5}}, {0, -0.5, 0}, smooth);
  put(scene, BoxShape{{0.5, 5, 5}}, {2.5 + gap, 0, 0}, smooth);
  World world = make_world(space(), scene);
  std::vector<ProjectileId> ids;
  for (const bool comes : {true, false})
    ids.push_back(*world.spawn(
        ball(), {.position = {comes ? 0 : 2 - kRadius, kRadius, 0}, .velocity = Vec3d{comes ? kSpeed : 0, 0, 0}},
        of_billiards(restitution)));
  run_for(world, 1.5, 1 / rate);
  return {world[ids[0]].velocity(), world[ids[1]].velocity()};
}

/// One at a cushion had the speed of a gap over a rounding of time (97 km/s at 60 Hz).
TEST(PairsWall, no_ball_at_a_cushion_makes_energy) {
  for (const double restitution : {0.0, 0.3, 0.5, 0.8, 0.95})
    for (const double gap : {0.0, 1e-10, 1e-6})
      for (const double rate : kRates) {
        double squares = 0;
        for (const Vec3d& v : at_cushion(restitution, gap, rate)) squares += length_squared(v);
        EXPECT_LE(squares, kSpeed * kSpeed * (1 + 1e-9)) << restitution << ' ' << gap << ' ' << rate;
      }
}

/// It gives what it gets to the cushion and back: it stopped there, and the speed was lost.
TEST(PairsWall, a_ball_at_a_cushion_gives_its_speed_back) {
  for (const double gap : {0.0, 1e-10, 1e-6})
    for (const double rate : kRates) {
      const std::vector<Vec3d> v = at_cushion(1, gap, rate);
      EXPECT_LT(length(v[0] - Vec3d{-kSpeed, 0, 0}), 1e-6) << gap << ' ' << rate;
      EXPECT_LT(length(v[1]), 1e-6) << gap << ' ' << rate;
    }
}

/// A net or a call may leave what lies on a floor in it by a rounding: it went through the walls.
TEST(PairsWall, what_lies_in_a_floor_by_a_rounding_meets_walls) {
  for (const double depth : {-1e-10, 0.0, 1e-12, 2e-11, 2e-10})
    for (const double radius : {0.0, kRadius})
      for (const double rate : kRates) {
        Scene scene;
        const MaterialId smooth = *scene.add_material({.restitution = 0, .friction = 0});
        put(scene, BoxShape{{40, 0.5, 5}}, {0, -0.5, 0}, smooth);
        put(scene, BoxShape{{0.5, 5, 5}}, {2.5, 0, 0}, smooth);
        World world = make_world(space(), scene);
        const ProjectileId id = *world.spawn(
            ball(), {.position = {0.9, radius - depth, 0}, .velocity = Vec3d{kSpeed, 0, 0}}, bouncing(radius, 0, 0));
        run_for(world, 1, 1 / rate);
        EXPECT_NEAR(world[id].position().x, 2 - radius, 1e-8) << depth << ' ' << radius << ' ' << rate;
        EXPECT_NEAR(world[id].position().y, radius, 1e-8) << depth << ' ' << radius << ' ' << rate;
      }
}

/// Five balls in a row on a smooth lift: the last one leaves with the speed of the one that came.
TEST(PairsWall, a_blow_goes_through_a_row_on_a_lift) {
  for (const double rises : {0.0, 0.5})
    for (const double rate : kRates) {
      Scene scene;
      const MaterialId smooth = *scene.add_material({.restitution = 0, .friction = 0});
      add_thing(scene, BoxShape{{40, 0.5, 5}},
                {.transform = {.position = {0, -0.5, 0}},
                 .material = smooth,
                 .motion = SteadyMotion{.velocity = {0, rises, 0}}});
      World world = make_world(space(), scene);
      std::vector<ProjectileId> ids;
      for (int i = 0; i < 5; ++i)
        ids.push_back(*world.spawn(ball(),
                                   {.position = {i == 0 ? 0 : 2 * kRadius * (i + 4), kRadius + 1e-10, 0},
                                    .velocity = Vec3d{i == 0 ? kSpeed : 0, rises, 0}},
                                   of_billiards(1)));
      run_for(world, 1, 1 / rate);
      for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(world[ids[i]].velocity().x, i == 4 ? kSpeed : 0, 1e-9) << rises << ' ' << rate << ' ' << i;
    }
}

}  // namespace physim::world_pairs_wall_test
