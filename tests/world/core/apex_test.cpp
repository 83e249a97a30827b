// Apexes of what does not only fly: of pendulums, springs and what slides, against closed forms.
#include "world/joints_support.hpp"

namespace physim::world_apex_test {

using namespace test_joints;

WorldDef telling() {
  WorldDef def = falling();
  def.apex_events = true;
  return def;
}

std::vector<Event> apexes(World& world, double dt, double until) {
  std::vector<Event> all;
  while (world.time() < until) {
    world.step(dt);
    for (const Event& event : world.events())
      if (event.kind == EventKind::apex) all.push_back(event);
  }
  return all;
}

void expect_every(const std::vector<Event>& tops, double first, double period, double height, double dt) {
  for (std::size_t i = 0; i < tops.size(); ++i) {
    EXPECT_NEAR(tops[i].time, first + static_cast<double>(i) * period, 8 * dt * dt * static_cast<double>(i + 1));
    EXPECT_NEAR(tops[i].position.y, height, 2 * dt * dt);
    EXPECT_NEAR(tops[i].velocity.y, 0, 1e-9);
  }
}

/// A pendulum let go at 1 rad is highest twice in a period of 4 K(sin 1/2) sqrt(l / g).
TEST(Apexes, a_pendulum_is_highest_where_it_turns) {
  for (const double rate : {60.0, 240.0})
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      World world = make_world(telling());
      const ProjectileId one = put(world, mass_of(1, precision), bob(), {std::sin(1.0), -std::cos(1.0), 0});
      join(world, {.a = one, .point = {}});
      const double half = kPi / (std::sqrt(kGravity) * agm(1, std::cos(0.5)));
      const std::vector<Event> tops = apexes(world, 1 / rate, 5);
      ASSERT_EQ(tops.size(), 4u) << rate;
      expect_every(tops, half, half, -std::cos(1.0), 1 / rate);
    }
}

TEST(Apexes, a_bob_on_a_spring_is_highest_once_in_a_period) {
  constexpr double kStiffness = 50, kLength = 1, kDrop = 1.5;
  for (const double rate : {60.0, 240.0}) {
    World world = make_world(telling());
    const ProjectileId one = put(world, mass_of(1), bob(), {0, -kDrop, 0});
    join(world, {.kind = JointKind::spring, .a = one, .point = {}, .length = kLength, .stiffness = kStiffness});
    const double half = kPi / std::sqrt(kStiffness), rest = -kLength - kGravity / kStiffness;
    const std::vector<Event> tops = apexes(world, 1 / rate, 3);
    ASSERT_EQ(tops.size(), 3u) << rate;
    expect_every(tops, half, 2 * half, 2 * rest + kDrop, 1 / rate);
  }
}

TEST(Apexes, what_a_slack_cable_holds_is_highest_as_if_free) {
  World world = make_world(telling());
  const ProjectileId one = put(world, mass_of(1), bob(), {}, {1, 4, 0});
  join(world, {.kind = JointKind::cable, .a = one, .point = {}, .length = 100});
  const std::vector<Event> tops = apexes(world, 1.0 / 60, 1);
  ASSERT_EQ(tops.size(), 1u);
  EXPECT_NEAR(tops[0].time, 4 / kGravity, 1e-12);
  EXPECT_NEAR(tops[0].position.x, 4 / kGravity, 1e-12);
  EXPECT_NEAR(tops[0].position.y, 8 / kGravity, 1e-12);
}

TEST(Apexes, a_held_particle_fires_its_sub_emitter_where_it_is_highest) {
  World world = make_world(telling());
  const KindId kind = must(world.add_kind(mass_of(1), bob()));
  EmitterDef sparks{.kind = kind, .cycle = {.plays = false}, .start = {.lifetime = {100}}};
  const EmitterId sub = must(world.add_emitter(sparks));
  EmitterDef def{.kind = kind, .start = {.lifetime = {100}, .speed = {0}}};
  def.bursts = {{.count = {1}}};
  def.position = {std::sin(1.0), -std::cos(1.0), 0};
  def.subs = {{.on = SubEvent::apex, .emitter = sub}};
  must(world.add_emitter(def));
  world.step(1.0 / 60);
  const std::vector<Event> born = events_of(world, EventKind::spawned);
  ASSERT_EQ(born.size(), 1u);
  join(world, {.a = born[0].id, .point = {}});
  const std::vector<Event> tops = apexes(world, 1.0 / 60, 3);
  EXPECT_EQ(tops.size(), 2u);
  EXPECT_EQ(world.emitter_counts(sub).born, 2u);
}

BodyDef puck(double radius) {
  BodyDef body = bob();
  body.restitution = body.friction = body.rolling_resistance = 0;
  body.collision = {.on_hit = OnHit::bounce, .radius = radius};
  return body;
}

TEST(Apexes, what_slides_up_a_slope_is_highest_once) {
  constexpr double kSlope = 0.3, kSpeed = 3;
  const Vec3d normal{-std::sin(kSlope), std::cos(kSlope), 0}, along{std::cos(kSlope), std::sin(kSlope), 0};
  for (const double rate : {60.0, 240.0})
    for (const double radius : {0.0, 0.1}) {
      Scene scene;
      const auto shape = scene.add_shape(PlaneShape{});
      const Quatd turned = quat_from_axis_angle(Vec3d{0, 0, 1}, kSlope);
      must(scene.add({.shape = *shape, .transform = {.rotation = turned}}));
      World world = make_world(telling(), scene);
      put(world, mass_of(1), puck(radius), normal * (radius + 1e-9), along * kSpeed);
      const std::vector<Event> tops = apexes(world, 1 / rate, 2);
      ASSERT_EQ(tops.size(), 1u) << rate << ' ' << radius;
      EXPECT_NEAR(tops[0].time, kSpeed / (kGravity * std::sin(kSlope)), 1e-6);
      EXPECT_NEAR(tops[0].position.y, kSpeed * kSpeed / (2 * kGravity) + radius * normal.y, 1e-6);
    }
}

TEST(Apexes, what_slides_over_a_hill_is_highest_once) {
  for (const double rate : {60.0, 240.0})
    for (const double radius : {0.0, 0.1}) {
      Scene scene;
      must(scene.add({.shape = *scene.add_shape(SphereShape{10}), .transform = {.position = {0, -10, 0}}}));
      World world = make_world(telling(), scene);
      const Vec3d outward{-std::sin(0.3), std::cos(0.3), 0}, uphill{std::cos(0.3), std::sin(0.3), 0};
      put(world, mass_of(1), puck(radius), Vec3d{0, -10, 0} + outward * (10 + radius + 1e-6), uphill * 3.12);
      const std::vector<Event> tops = apexes(world, 1 / rate, 4);
      ASSERT_EQ(tops.size(), 1u) << rate << ' ' << radius;
      EXPECT_NEAR(tops[0].position.x, 0, 3.12 / rate);
      EXPECT_NEAR(tops[0].position.y, radius, 1e-3);
    }
}

}  // namespace physim::world_apex_test
