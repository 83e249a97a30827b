// What a thing brings down to the ground inside a step, and what a way over the ground brings to a thing.
#include "math/quat.hpp"
#include "scene_support.hpp"

namespace physim::world_down_to_ground_test {

using namespace test_scene;

constexpr double kRates[] = {24, 60, 1000};
constexpr double kAngle = 30 * test::kDegree, kFall = 1;  // of the slope; from the start to the ground [m]

WorldDef on_ground(GroundMode mode, double restitution = 0) {
  WorldDef def = space();
  def.ground = {.mode = mode, .height = 0, .restitution = restitution, .friction = 0};
  return def;
}
/// A slab whose upper side is a slope down along x, through the ground, on which a ball's middle begins at `kFall`.
Scene chute(double radius) {
  Scene scene;
  const Quatd turn{std::cos(kAngle / 2), 0, 0, -std::sin(kAngle / 2)};
  const Vec3d middle = Vec3d{0, kFall, 0} - rotate(turn, Vec3d{0, 0.5 + radius, 0});
  add_thing(scene, BoxShape{{20, 0.5, 5}},
            {.transform = {.position = middle, .rotation = turn},
             .material = *scene.add_material({.restitution = 1, .friction = 1})});
  return scene;
}

/// How it comes down from rest at x = 0: after which time, where, and how fast.
struct Arrival {
  double time, x, speed;
};
/// `part` of what pulls along the slope moves it: 5/7 of a ball that rolls.
Arrival arrival(double part) {
  const double a = part * kG * std::sin(kAngle), way = kFall / std::sin(kAngle);
  return {std::sqrt(2 * way / a), way * std::cos(kAngle), std::sqrt(2 * way * a)};
}
struct Slider {
  double radius, friction, part;
};
constexpr Slider kSliders[] = {
    {0, 0, 1}, {0.1, 0, 1}, {0.1, 1, 5.0 / 7}};  // a point, a ball that slides, one that rolls

TEST(DownToGround, what_comes_down_a_slope_goes_on_over_the_ground_from_that_moment) {
  for (const Slider& who : kSliders)
    for (const double rate : kRates) {
      World world = make_world(on_ground(GroundMode::bounce), chute(who.radius));
      const ProjectileId id = *world.spawn(puck(), {.position = {0, kFall + 1e-10, 0}, .velocity = Vec3d{}},
                                           bouncing(who.radius, 0, who.friction));
      const Arrival comes = arrival(who.part);
      double lowest = kFall;
      for (int i = 0; world.time() < 1.5; ++i) {
        world.step(1 / rate);
        lowest = std::min(lowest, world[id].position().y);
      }
      const double along = comes.speed * std::cos(kAngle);
      EXPECT_NEAR(world[id].velocity().x, along, 1e-8) << who.part << ' ' << rate;
      EXPECT_NEAR(world[id].position().x, comes.x + along * (world.time() - comes.time), 1e-7)
          << who.part << ' ' << rate;
      EXPECT_GE(lowest, -1e-12) << who.part << ' ' << rate;
    }
}

TEST(DownToGround, it_bounces_off_the_ground_with_the_energy_that_it_came_with) {
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (const Slider& who : kSliders)
      for (const double rate : kRates) {
        World world = make_world(on_ground(GroundMode::bounce, 1), chute(who.radius));
        const ProjectileId id = *world.spawn(puck(precision), {.position = {0, kFall + 1e-6, 0}, .velocity = Vec3d{}},
                                             bouncing(who.radius, 1, who.friction));
        const double rounding = precision == Precision::float32 ? 1e-4 : 1e-6;
        const Arrival comes = arrival(who.part);
        while (world.time() < comes.time + 0.1) world.step(1 / rate);
        const Vec3d x = world[id].position(), v = world[id].velocity();
        EXPECT_NEAR(0.5 * dot(v, v) + kG * x.y, 0.5 * comes.speed * comes.speed, 10 * rounding)
            << who.part << ' ' << rate;
        EXPECT_NEAR(v.x, comes.speed * std::cos(kAngle), rounding) << who.part << ' ' << rate;
      }
}

TEST(DownToGround, a_lift_that_goes_below_the_ground_leaves_its_passenger_there) {
  for (const double radius : {0.0, 0.1})
    for (const double rate : kRates) {
      World world = make_world(on_ground(GroundMode::bounce));
      Scene scene;
      add_thing(scene, BoxShape{{2, 0.5, 2}},
                {.transform = {.position = {0, 1 - 0.5 - radius, 0}},
                 .material = *scene.add_material({.restitution = 0, .friction = 1}),
                 .motion = SteadyMotion{.velocity = {0.2, -0.7, 0}}});
      ASSERT_TRUE(world.set_scene(scene));
      const ProjectileId id = *world.spawn(puck(), {.position = {0, 1 + 1e-10, 0}, .velocity = Vec3d{0.2, -0.7, 0}},
                                           bouncing(radius, 0, 1));
      double lowest = 1;
      while (world.time() < 2.5) {
        world.step(1 / rate);
        lowest = std::min(lowest, world[id].position().y);
      }
      EXPECT_GE(lowest, -1e-12) << radius << ' ' << rate;
      EXPECT_NEAR(world[id].position().y, 0, 1e-9) << radius << ' ' << rate;
      EXPECT_NEAR(world[id].position().x, 0.2 * world.time(), 1e-7) << radius << ' ' << rate;
    }
}

TEST(DownToGround, it_lands_or_sticks_at_the_moment_at_which_it_comes_down_in_worlds_flights_and_predictions) {
  for (const Slider& who : kSliders) {
    const Arrival comes = arrival(who.part);
    const Scene scene = chute(who.radius);
    const Launch launch{.position = {0, kFall + 1e-10, 0}, .velocity = Vec3d{}};
    const BodyDef body = bouncing(who.radius, 0, who.friction);
    for (const GroundMode mode : {GroundMode::land, GroundMode::stick})
      for (const double rate : kRates) {
        World world = make_world(on_ground(mode), scene);
        const ProjectileId id = *world.spawn(puck(), launch, body);
        const Flight predicted = world.predict(id, Until{.ground = 0.0, .time = 2}, 1 / rate);
        EXPECT_NEAR(predicted.duration(), comes.time, 1e-7) << who.part << ' ' << rate;
        std::vector<Event> landed;
        while (landed.empty() && world.time() < 2) {
          world.step(1 / rate);
          landed = events_of(world, EventKind::landed);
        }
        ASSERT_EQ(landed.size(), 1u) << who.part << ' ' << rate;
        EXPECT_NEAR(landed[0].time, comes.time, 1e-7) << who.part << ' ' << rate;
        EXPECT_NEAR(landed[0].position.x, comes.x, 1e-7) << who.part << ' ' << rate;
        EXPECT_NEAR(length(landed[0].velocity), comes.speed, 1e-7) << who.part << ' ' << rate;
      }
    Until until = meeting(scene, OnHit::bounce, who.radius);
    until.ground = 0.0;
    until.contact.restitution = 0, until.contact.friction = who.friction, until.contact.rolling_resistance = 0;
    const Flight flight = fly(puck(), launch, vacuum_of(kG), puck().fidelity, {}, until);
    EXPECT_NEAR(flight.duration(), comes.time, 1e-7) << who.part;
  }
}

}  // namespace physim::world_down_to_ground_test
