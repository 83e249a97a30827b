// What slides or rolls comes to walls and sensors at the moment that its own law says, whatever the step.
#include "math/quat.hpp"
#include "scene_support.hpp"

namespace physim::world_stops_on_way_test {

using namespace test_scene;

constexpr double kRates[] = {24, 60, 1000};
constexpr double kWall = 1, kSpeed = 5;  // where a wall stands [m]; of what comes to a sensor [m/s]

/// Points slide against friction 0.5, balls roll against a resistance of 0.1.
struct Mover {
  double radius, slows;  // [m], [m/s^2]
  BodyDef body;
};
std::vector<Mover> movers() {
  BodyDef ball = bouncing(0.1);
  ball.rolling_resistance = 0.1;
  ball.angular_velocity = {0, 0, -kSpeed / 0.1};
  return {{0, 0.5 * kG, bouncing(0, 1, 0.5)}, {0.1, 0.1 * kG * 5 / 7, ball}};
}
/// A wall across x that takes no energy, and a floor if there is no ground.
Scene wall_and_floor(bool has_floor) {
  Scene scene;
  const MaterialId smooth = *scene.add_material({.restitution = 1, .friction = 0});
  const MaterialId rough = *scene.add_material({.restitution = 0, .friction = 1});
  put(scene, BoxShape{{0.5, 3, 5}}, {kWall + 0.5, 0, 0}, smooth);
  if (has_floor) put(scene, BoxShape{{50, 0.5, 5}}, {0, -0.5, 0}, rough);
  return scene;
}

/// It comes back from the wall, and rests where it would behind it, seen in the wall.
TEST(OnItsWay, a_wall_in_the_way_changes_nothing_of_how_far_a_point_slides) {
  const Mover point = movers()[0];
  for (const bool on_ground : {true, false})
    for (const double speed : {3.2, 4.0, 5.0})
      for (const double rate : kRates) {
        WorldDef def = space();
        if (on_ground) def.ground = {.mode = GroundMode::bounce, .restitution = 0, .friction = 1};
        World world = make_world(def, wall_and_floor(!on_ground));
        const ProjectileId id = *world.spawn(
            puck(), {.position = {0, on_ground ? 0 : 1e-10, 0}, .velocity = Vec3d{speed, 0, 0}}, point.body);
        const double slides = speed * speed / (2 * point.slows);
        std::vector<Event> hits;
        while (world.time() < 2) {
          world.step(1 / rate);
          for (const Event& e : events_of(world, EventKind::hit))
            if (e.normal.x < 0) hits.push_back(e);
        }
        EXPECT_NEAR(world[id].position().x, 2 * kWall - slides, 1e-7) << on_ground << ' ' << speed << ' ' << rate;
        EXPECT_EQ(world[id].velocity().x, 0) << on_ground << ' ' << speed << ' ' << rate;
        ASSERT_EQ(hits.size(), 1u) << on_ground << ' ' << speed << ' ' << rate;
        const double v = std::sqrt(speed * speed - 2 * point.slows * kWall);
        EXPECT_NEAR(hits[0].time, (speed - v) / point.slows, 1e-7) << on_ground << ' ' << speed << ' ' << rate;
        EXPECT_NEAR(hits[0].velocity.x, v, 1e-7) << on_ground << ' ' << speed << ' ' << rate;
      }
}

/// From rest down a slope of 30 degrees, to a wall across it.
TEST(OnItsWay, what_starts_to_roll_or_slide_comes_to_a_wall_in_its_time) {
  const double angle = 30 * test::kDegree, pull = kG * std::sin(angle);
  const Quatd turn{std::cos(angle / 2), 0, 0, -std::sin(angle / 2)};
  struct Kind {
    double radius, friction, part;
  };
  for (const Kind& kind : {Kind{0, 0, 1}, Kind{0.1, 0, 1}, Kind{0.1, 1, 5.0 / 7}})
    for (const double way : {0.0005, 0.02, 0.7})
      for (const double rate : kRates) {
        Scene scene;
        const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = 1});
        const ShapeId slab = *scene.add_shape(BoxShape{{9, 0.5, 5}}), wall = *scene.add_shape(BoxShape{{0.5, 3, 5}});
        const auto at = [&](const Vec3d& place) {
          return Transform{.position = rotate(turn, place), .rotation = turn};
        };
        ASSERT_TRUE(scene.add({.shape = slab, .transform = at({0, -0.5 - kind.radius, 0}), .material = made_of}));
        ASSERT_TRUE(scene.add({.shape = wall, .transform = at({way + 0.5 + kind.radius, 0, 0}), .material = made_of}));
        World world = make_world(space(), scene);
        ASSERT_TRUE(world.spawn(puck(), {.position = rotate(turn, Vec3d{0, 1e-10, 0}), .velocity = Vec3d{}},
                                bouncing(kind.radius, 0, kind.friction)));
        const double a = kind.part * pull;
        std::vector<Event> hits;
        while (world.time() < 1) {
          world.step(1 / rate);
          for (const Event& e : events_of(world, EventKind::hit))
            if (dot(e.normal, rotate(turn, Vec3d{1, 0, 0})) < -0.9) hits.push_back(e);
        }
        ASSERT_GE(hits.size(), 1u) << kind.part << ' ' << way << ' ' << rate;
        EXPECT_NEAR(hits[0].time, std::sqrt(2 * way / a), 2e-6) << kind.part << ' ' << way << ' ' << rate;
        EXPECT_NEAR(length(hits[0].velocity), std::sqrt(2 * way * a), 1e-6) << kind.part << ' ' << way << ' ' << rate;
      }
}

/// A sensor reports in and out when v t - a t^2 / 2 says, on the ground and on a floor.
TEST(OnItsWay, sensors_report_when_a_way_over_a_floor_goes_in_and_out) {
  for (const Mover& mover : movers())
    for (const bool on_ground : {true, false})
      for (const double rate : kRates) {
        if (on_ground && mover.radius > 0) continue;  // the ground knows points
        WorldDef def = space();
        if (on_ground) def.ground = {.mode = GroundMode::bounce, .restitution = 0, .friction = 1};
        World world = make_world(def);
        Scene scene;
        if (!on_ground)
          put(scene, BoxShape{{50, 0.5, 5}}, {0, -0.5 - mover.radius, 0},
              *scene.add_material({.restitution = 0, .friction = 1}));
        add_thing(scene, BoxShape{{0.4, 1, 1}}, {.transform = {.position = {1, 0, 0}}, .sensor = true});
        ASSERT_TRUE(world.set_scene(scene));
        const double speed = kSpeed;
        ASSERT_TRUE(world.spawn(puck(), {.position = {0, on_ground ? 0 : 1e-10, 0}, .velocity = Vec3d{speed, 0, 0}},
                                mover.body));
        std::vector<Event> in, out;
        while (world.time() < 1) {
          world.step(1 / rate);
          for (const Event& e : events_of(world, EventKind::sensed)) in.push_back(e);
          for (const Event& e : events_of(world, EventKind::left)) out.push_back(e);
        }
        const auto when = [&](double x) {
          return (speed - std::sqrt(speed * speed - 2 * mover.slows * x)) / mover.slows;
        };
        ASSERT_EQ(in.size(), 1u) << mover.radius << ' ' << rate;
        ASSERT_EQ(out.size(), 1u) << mover.radius << ' ' << rate;
        EXPECT_NEAR(in[0].time, when(0.6), 1e-6) << mover.radius << ' ' << on_ground << ' ' << rate;
        EXPECT_NEAR(out[0].time, when(1.4), 1e-6) << mover.radius << ' ' << on_ground << ' ' << rate;
      }
}

/// Squares of such lengths are infinite.
TEST(OnItsWay, a_way_whose_length_no_number_holds_goes_by_sensors) {
  for (const double far : {1e150, 1e160, 1e200, 1e300}) {
    Scene scene;
    add_thing(scene, BoxShape{{1, 1, 1}}, {.sensor = true});
    World world = make_world(space(), scene);
    const ProjectileId id =
        *world.spawn(puck(), {.position = {far, 0, 0}, .velocity = Vec3d{-far, 0, 0}}, movers()[0].body);
    world.step(1);
    ASSERT_EQ(world.size(), 1u) << far;
    EXPECT_LT(length(world[id].position()), 1e-6 * far) << far;
  }
}

}  // namespace physim::world_stops_on_way_test
