// Surfaces that run: conveyors of things and of the ground, beside closed forms.
#include "math/quat.hpp"
#include "scene_support.hpp"
#include "world/pairs_support.hpp"

namespace physim::world_conveyor_test {

using namespace test_scene;

constexpr double kRates[] = {24, 60, 1000};
constexpr double kBelt = 2, kFriction = 0.2;

BodyDef laid(double radius = 0, double friction = kFriction) {
  return {.can_sleep = true,
          .restitution = 0,
          .friction = friction,
          .rolling_resistance = 0,
          .collision = {.on_hit = OnHit::bounce, .radius = radius}};
}
InstanceDef belt_in(Scene& scene, const Vec3d& velocity, const Quatd& turn = {}, double length = 60) {
  return {.shape = *scene.add_shape(BoxShape{{length, 0.5, 5}}),
          .transform = {.position = rotate(turn, Vec3d{0, -0.5, 0}), .rotation = turn},
          .material = *scene.add_material({.restitution = 0, .friction = 1}),
          .conveyor = {velocity}};
}
Scene belt(const Vec3d& velocity, const Quatd& turn = {}, double length = 60) {
  Scene scene;
  EXPECT_TRUE(scene.add(belt_in(scene, velocity, turn, length)));
  return scene;
}
Quatd about_z(double angle) { return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; }

/// Friction takes along what lies there: it has the belt's speed after u / (mu g), and came u^2 / (2 mu g) less far.
TEST(Conveyor, takes_points_along_at_any_frame_rate) {
  const double time = 2, reached = kBelt / (kFriction * kG), far = kBelt * time - kBelt * reached / 2;
  for (const double rate : kRates)
    for (const bool ground : {false, true}) {
      WorldDef def = space();
      if (ground) def.ground = {.mode = GroundMode::bounce, .conveyor = {{kBelt, 0, 0}}};
      World world = make_world(def);
      if (!ground) {
        ASSERT_TRUE(world.set_scene(belt({kBelt, 0, 0})));
      }
      const ProjectileId id = *world.spawn(puck(), {}, laid());
      run_for(world, 0.75 * reached, 1 / rate);
      EXPECT_NEAR(world[id].velocity().x, kFriction * kG * world.time(), 1e-9) << rate << ' ' << ground;
      run_for(world, time - world.time(), 1 / rate);
      EXPECT_NEAR(world[id].velocity().x, kBelt, 1e-12) << rate << ' ' << ground;
      EXPECT_NEAR(world[id].position().x - kBelt * (world.time() - time), far, 1e-6) << rate << ' ' << ground;
      EXPECT_NEAR(world[id].position().y, 0, 1e-9) << rate << ' ' << ground;
    }
}

/// A solid ball is turned by the belt until it rolls on it, at 2/7 of its speed: slower than what cannot turn.
TEST(Conveyor, turns_balls_until_they_roll_on_it) {
  for (const double rate : kRates) {
    World world = make_world(space(), belt({kBelt, 0, 0}));
    const ProjectileId free = *world.spawn(puck(), {.position = {0, 0.1, 0}}, laid(0.1));
    BodyDef held = laid(0.1);
    held.frozen_rotation = Axes::all;
    const ProjectileId stiff = *world.spawn(puck(), {.position = {0, 0.1, 2}}, held);
    run_for(world, 2, 1 / rate);
    EXPECT_NEAR(world[free].velocity().x, 2 * kBelt / 7, 1e-6) << rate;
    EXPECT_NEAR(world[free].angular_velocity().z, (kBelt - 2 * kBelt / 7) / 0.1, 1e-4) << rate;
    EXPECT_NEAR(world[stiff].velocity().x, kBelt, 1e-9) << rate;
  }
}

/// A bounce changes the speed along the belt by mu (1 + e) v_n, and by no more than the slip.
TEST(Conveyor, pulls_at_what_bounces) {
  constexpr double kRestitution = 0.5, kDown = 4;
  for (const double friction : {0.1, 1.0})
    for (const bool ground : {false, true}) {
      WorldDef def = space();
      def.environment = vacuum_of(0);
      if (ground) def.ground = {.mode = GroundMode::bounce, .conveyor = {{0, 0, kBelt}}};
      World world = make_world(def);
      if (!ground) {
        ASSERT_TRUE(world.set_scene(belt({0, 0, kBelt})));
      }
      BodyDef body = laid(0, friction);
      body.restitution = kRestitution;
      body.combine.restitution = ground ? Combine::product : Combine::maximum;
      const ProjectileId id = *world.spawn(puck(), {.position = {0, 1, 0}, .velocity = Vec3d{0, -kDown, 0}}, body);
      const auto bounces = of_kind(run_for(world, 0.5), EventKind::bounced);
      ASSERT_EQ(bounces.size(), 1u);
      const double pulled = std::min(friction * (1 + kRestitution) * kDown, kBelt);
      EXPECT_NEAR(world[id].velocity().z, pulled, 1e-9) << friction << ' ' << ground;
      EXPECT_NEAR(world[id].velocity().y, kRestitution * kDown, 1e-9) << friction << ' ' << ground;
      EXPECT_GE(bounces.front().energy, 0);
    }
}

/// The velocity is in the thing's frame, and only its part along the surface acts.
TEST(Conveyor, runs_along_the_surface_of_a_thing_that_is_turned) {
  const double angle = 30 * test::kDegree;
  for (const Vec3d& velocity : {Vec3d{kBelt, 0, 0}, Vec3d{kBelt, 7, 0}}) {
    World world = make_world(space(), belt(velocity, about_z(angle)));
    const ProjectileId id = *world.spawn(puck(), {}, laid(0, 1));
    run_for(world, 2, 1.0 / 60);
    const Vec3d up{std::cos(angle), std::sin(angle), 0};
    EXPECT_LT(length(world[id].velocity() - up * kBelt), 1e-9);
    // Friction less the slope's pull gives it the speed of the belt.
    const double rises = kG * (std::cos(angle) - std::sin(angle));
    EXPECT_NEAR(length(world[id].position()), kBelt * world.time() - kBelt * kBelt / (2 * rises), 1e-6);
    EXPECT_EQ(of_kind(world.events(), EventKind::slept).size(), 0u);
  }
  const Scene scene = belt({kBelt, 7, 0}, about_z(angle));
  const Vec3d n{-std::sin(angle), std::cos(angle), 0};
  EXPECT_LT(length(scene.conveyor_velocity({1, 1}, n) - Vec3d{std::cos(angle), std::sin(angle), 0} * kBelt), 1e-12);
  EXPECT_EQ(scene.conveyor_velocity({2, 1}, n), Vec3d{});
}

/// A belt on a train adds its speed to that of the train, and a belt that runs back keeps what is on it in its place.
TEST(Conveyor, moves_with_its_thing) {
  for (const double train : {3.0, -kBelt}) {
    Scene scene;
    InstanceDef def = belt_in(scene, {kBelt, 0, 0});
    def.motion = SteadyMotion{.velocity = {train, 0, 0}};
    ASSERT_TRUE(scene.add(def));
    World world = make_world(space(), scene);
    const ProjectileId id = *world.spawn(puck(), {.velocity = Vec3d{train, 0, 0}}, laid());
    run_for(world, 2, 1.0 / 60);
    EXPECT_NEAR(world[id].velocity().x, train + kBelt, 1e-9) << train;
    EXPECT_NEAR(world[id].position().x, (train + kBelt) * world.time() - kBelt * kBelt / (2 * kFriction * kG), 1e-3);
  }
}

/// What comes to the end of a belt falls off it with the speed of the belt.
TEST(Conveyor, throws_what_it_carries_off_its_end) {
  for (const double radius : {0.0, 0.1}) {
    World world = make_world(space(), belt({kBelt, 0, 0}, {}, 3));
    BodyDef body = laid(radius, 1);
    if (radius > 0) body.frozen_rotation = Axes::all;
    const ProjectileId id = *world.spawn(puck(), {.position = {0, radius, 0}, .velocity = Vec3d{kBelt, 0, 0}}, body);
    run_for(world, 2, 1.0 / 60);
    EXPECT_NEAR(world[id].velocity().x, kBelt, radius > 0 ? 0.3 : 1e-9);
    EXPECT_LT(world[id].position().y, -0.3);
  }
}

/// What lies on a belt does not sleep, however slow it is; what slept wakes when the belt starts, and stops after it.
TEST(Conveyor, starts_and_stops_by_a_call) {
  World world = make_world(space(), belt({}));
  const ProjectileId id = *world.spawn(puck(), {}, laid());
  run_for(world, 2, 1.0 / 60);
  EXPECT_TRUE(world[id].is_asleep());
  const InstanceId thing{1, 1};
  ASSERT_TRUE(world.set_instance_conveyor(thing, {{0.01, 0, 0}}));
  run_for(world, 2, 1.0 / 60);
  EXPECT_FALSE(world[id].is_asleep());
  EXPECT_NEAR(world[id].velocity().x, 0.01, 1e-12);
  ASSERT_TRUE(world.set_instance_conveyor(thing, {{kBelt, 0, 0}}));
  run_for(world, 2, 1.0 / 60);
  const double there = world[id].position().x;
  EXPECT_NEAR(world[id].velocity().x, kBelt, 1e-9);
  ASSERT_TRUE(world.set_instance_conveyor(thing, {}));
  run_for(world, 3, 1.0 / 60);
  EXPECT_NEAR(world[id].position().x - there, kBelt * kBelt / (2 * kFriction * kG), 1e-6);
  EXPECT_TRUE(world[id].is_asleep());
  WorldDef slow = space();
  slow.ground = {.mode = GroundMode::bounce, .conveyor = {{0.01, 0, 0}}};
  World on_ground = make_world(slow);
  const ProjectileId crept = *on_ground.spawn(puck(), {}, laid());
  run_for(on_ground, 5, 1.0 / 60);
  EXPECT_FALSE(on_ground[crept].is_asleep());
  EXPECT_NEAR(on_ground[crept].velocity().x, 0.01, 1e-12);
}

/// A ball that is pushed by another one on a belt, both carried.
TEST(Conveyor, acts_in_meetings) {
  World world = make_world(space(), belt({kBelt, 0, 0}));
  BodyDef body = laid(0.1, 0.5);
  body.frozen_rotation = Axes::all;
  body.collision.others = 1;
  const ProjectileId behind = *world.spawn(puck(), {.position = {0, 0.1, 0}, .velocity = Vec3d{5, 0, 0}}, body);
  const ProjectileId ahead = *world.spawn(puck(), {.position = {1, 0.1, 0}}, body);
  run_for(world, 4, 1.0 / 60);
  EXPECT_NEAR(world[behind].velocity().x, kBelt, 1e-6);
  EXPECT_NEAR(world[ahead].velocity().x, kBelt, 1e-6);
  EXPECT_GE(world[ahead].position().x - world[behind].position().x, 0.2 - 1e-6);
}

TEST(Conveyor, flights_are_carried_as_worlds_carry) {
  const Scene scene = belt({kBelt, 0, 0});
  Until until = meeting(scene, OnHit::bounce);
  until.time = 2;
  until.contact.restitution = 0;
  until.contact.friction = kFriction;
  until.contact.rolling_resistance = 0;
  const Flight flight = fly(puck(), {.position = {0, 0.1, 0}}, vacuum_of(kG), puck().fidelity, {}, until);
  const double falls = std::sqrt(0.2 / kG), pulled = kFriction * std::sqrt(2 * kG * 0.1);
  EXPECT_EQ(flight.outcome(), Outcome::time_limit);
  const double slides = (kBelt - pulled) / (kFriction * kG);
  EXPECT_NEAR(flight.end().velocity.x, kBelt, 1e-9);
  EXPECT_NEAR(flight.end().position.x, kBelt * (2 - falls) - (kBelt - pulled) * slides / 2, 1e-6);
}

TEST(Conveyor, what_makes_no_sense_is_refused_with_its_place) {
  Scene scene;
  InstanceDef def = belt_in(scene, {2e6, 0, 0});
  EXPECT_EQ(scene.add(def).error().place, "instance.conveyor.velocity");
  def.conveyor.velocity = {0, std::nan(""), 0};
  EXPECT_FALSE(scene.add(def));
  def.conveyor = {};
  const InstanceId thing = *scene.add(def);
  EXPECT_EQ(scene.set_conveyor(thing, {{0, 0, kInfinity}}).error().place, "conveyor.velocity");
  EXPECT_FALSE(scene.set_conveyor({9, 1}, {}));
  WorldDef world;
  world.ground.conveyor.velocity.x = std::nan("");
  EXPECT_EQ(World::create(world).error().place, "ground.conveyor.velocity");
}

TEST(Conveyor, is_kept_by_snapshots_saves_and_recordings) {
  std::vector<std::byte> recording;
  World world = make_world(space());
  ASSERT_TRUE(world.record(record_into(recording)));
  ASSERT_TRUE(world.set_scene(belt({kBelt, 0, 0})));
  const ProjectileId id = *world.spawn(puck(), {}, laid());
  run_for(world, 0.5, 1.0 / 60);
  const Snapshot moment = world.snapshot();
  const std::uint64_t before = world.hash();
  ASSERT_TRUE(world.set_instance_conveyor({1, 1}, {{-kBelt, 0, 0}}));
  EXPECT_NE(world.hash(), before);
  run_for(world, 2, 1.0 / 60);
  EXPECT_NEAR(world[id].velocity().x, -kBelt, 1e-9);
  World loaded = reloaded(world);
  EXPECT_EQ(loaded.hash(), world.hash());
  EXPECT_EQ(loaded.scene()->instance({1, 1})->conveyor.velocity, (Vec3d{-kBelt, 0, 0}));
  ASSERT_TRUE(world.restore(moment));
  EXPECT_EQ(world.hash(), before);
  run_for(world, 2, 1.0 / 60);
  EXPECT_NEAR(world[id].velocity().x, kBelt, 1e-9);
  replayed(world, recording);
}

/// A way around a drum bends two thousand times a second: as often in one long step as in many.
TEST(Conveyor, long_steps_around_a_drum_end_where_short_ones_do) {
  const auto after = [](double step) {
    Scene scene;
    add_thing(scene, CapsuleShape{10, 60},
              {.transform = {.position = {0, -10, 0}, .rotation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0}},
               .material = *scene.add_material({.restitution = 0, .friction = 0.5}),
               .conveyor = {{kBelt, 0, 0}}});
    World world = make_world(space(), scene);
    const ProjectileId id =
        *world.spawn(puck(), {.position = {0, 0.05, 0}, .velocity = Vec3d{0.5, 0, 0}}, laid(0.05, 0.6));
    run_for(world, 1, step);
    return world[id].state();
  };
  const auto right = after(1.0 / 60);
  for (const double step : {1.0 / 3, 0.5, 1.0}) {
    EXPECT_NEAR(length(after(step).position - right.position), 0, 2e-3) << step;
    EXPECT_NEAR(length(after(step).velocity - right.velocity), 0, 2e-3) << step;
  }
}

}  // namespace physim::world_conveyor_test
