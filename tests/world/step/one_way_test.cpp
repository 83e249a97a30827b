// One-way things: they stop what comes from their front, and nothing else.
#include "math/quat.hpp"
#include "scene_support.hpp"
#include "world/pairs_support.hpp"

namespace physim::world_one_way_test {

using namespace test_scene;

constexpr double kTop = 2;  // of platforms [m]

BodyDef landing(double radius = 0, OnHit on_hit = OnHit::bounce) {
  return {.restitution = 0, .friction = 1, .collision = {.on_hit = on_hit, .radius = radius}};
}
HeightFieldShape field() {
  HeightFieldShape shape{.columns = 9, .rows = 9, .spacing_x = 1, .spacing_z = 1};
  shape.heights.assign(81, 0);
  return shape;
}
MeshShape sheet() {
  return {.vertices = {{-4, 0, -4}, {4, 0, -4}, {4, 0, 4}, {-4, 0, 4}}, .triangles = {{0, 2, 1}, {0, 3, 2}}};
}
struct Platform {
  std::string name;
  ShapeDef shape;
  Vec3d position;  // so that its upper side is at kTop
};
std::vector<Platform> platforms() {
  ConvexHullShape hull;
  for (const double x : {-4.0, 4.0})
    for (const double y : {-0.25, 0.25})
      for (const double z : {-4.0, 4.0}) hull.points.push_back({x, y, z});
  return {{"box", BoxShape{{4, 0.25, 4}}, {0, kTop - 0.25, 0}},
          {"hull", hull, {0, kTop - 0.25, 0}},
          {"cylinder", CylinderShape{4, 0.25}, {0, kTop - 0.25, 0}},
          {"field", field(), {-4, kTop, -4}},
          {"sheet", sheet(), {0, kTop, 0}}};
}
Scene with(const Platform& platform, const SceneMotion& motion = AtRest{}) {
  Scene scene;
  add_thing(scene, platform.shape,
            {.transform = {.position = platform.position},
             .material = *scene.add_material({.restitution = 0}),
             .motion = motion,
             .passage = {.front = {0, 3, 0}}});
  return scene;
}

/// Up through the platform as if it were not there, and down onto it when the closed form says so.
TEST(OneWay, is_passed_from_below_and_lands_what_falls_on_it) {
  for (const Platform& platform : platforms())
    for (const double radius : {0.0, 0.1})
      for (const double rate : {24.0, 60.0, 1000.0})
        for (const Precision precision : {Precision::float64, Precision::float32}) {
          const std::string label = platform.name + ' ' + std::to_string(radius) + ' ' + std::to_string(rate);
          World world = make_world(space(), with(platform));
          constexpr double kUp = 8;
          const ProjectileId id =
              *world.spawn(puck(precision), {.position = {0.3, 0, 0.4}, .velocity = Vec3d{0, kUp, 0}}, landing(radius));
          const auto hits = of_kind(run_for(world, 3, 1 / rate), EventKind::hit);
          ASSERT_EQ(hits.size(), 1u) << label;
          const double end = kTop + radius, time = (kUp + std::sqrt(kUp * kUp - 2 * kG * end)) / kG;
          const double close = precision == Precision::float64 ? 1e-8 : 1e-4;
          EXPECT_NEAR(hits[0].time, time, close) << label;
          EXPECT_NEAR(world[id].position().y, end, close) << label;
          EXPECT_TRUE(world[id].is_asleep()) << label;
        }
}

TEST(OneWay, is_passed_from_the_sides_and_by_what_turns_back_inside) {
  for (const double radius : {0.0, 0.1}) {
    World world = make_world(space(0)), free = make_world(space(0)), falls = make_world(space());
    const Platform box = platforms().front();
    ASSERT_TRUE(world.set_scene(with(box)) && falls.set_scene(with(box)));
    const Launch across{.position = {-9, kTop - 0.2, 0}, .velocity = Vec3d{10, 0, 0}};
    const ProjectileId through = *world.spawn(puck(), across, landing(radius)),
                       alone = *free.spawn(puck(), across, landing(radius));
    EXPECT_TRUE(of_kind(run_for(world, 2, 1.0 / 60), EventKind::hit).empty());
    run_for(free, 2, 1.0 / 60);
    EXPECT_LT(length(world[through].position() - free[alone].position()), 1e-9);
    // It comes up into the platform, not out of it, and falls out below.
    const double up = std::sqrt(2 * kG * (kTop - 0.2));
    const ProjectileId back = *falls.spawn(puck(), {.velocity = Vec3d{0, up, 0}}, landing(radius));
    EXPECT_TRUE(of_kind(run_for(falls, 2, 1.0 / 60), EventKind::hit).empty());
    const double t = falls.time();
    EXPECT_NEAR(falls[back].position().y, up * t - kG / 2 * t * t, 1e-6);
  }
}

/// The front turns with the thing: a shield stops what comes against it, and lets out what is shot from behind it.
TEST(OneWay, turns_with_its_thing) {
  Scene scene;
  const double half = std::sqrt(0.5);
  add_thing(scene, BoxShape{{4, 0.25, 4}},
            {.transform = {.rotation = {half, 0, 0, half}},  // y becomes -x
             .passage = {.front = {0, 1, 0}}});
  for (const OnHit on_hit : {OnHit::stop, OnHit::stick, OnHit::bounce}) {
    World world = make_world(space(0), scene);
    const ProjectileId comes =
        *world.spawn(puck(), {.position = {-5, 0, 0}, .velocity = Vec3d{20, 0, 0}}, landing(0, on_hit));
    const ProjectileId goes =
        *world.spawn(puck(), {.position = {5, 0, 1}, .velocity = Vec3d{-20, 0, 0}}, landing(0, on_hit));
    const auto hits = of_kind(run_for(world, 0.5, 1.0 / 60), EventKind::hit);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].id, comes);
    EXPECT_NEAR(hits[0].position.x, -0.25, 1e-9);
    EXPECT_NEAR(world[goes].position().x, 5 - 20 * world.time(), 1e-9);
  }
  const SceneSegment ray{.from = {5, 0, 0}, .to = {-5, 0, 0}};
  EXPECT_TRUE(scene.first_hit(ray)) << "queries meet it from all sides";
  EXPECT_FALSE(scene.first_hit(ray, {.from_front = true}));
  EXPECT_TRUE(scene.first_hit({.from = {-5, 0, 0}, .to = {5, 0, 0}}, {.from_front = true}));
  std::vector<SceneHit> hits(1);
  scene.first_hits({&ray, 1}, hits, {.from_front = true});
  EXPECT_FALSE(hits[0]);
}

/// A lift takes along what stands on it, and lets through what comes from below.
TEST(OneWay, moves_with_its_thing) {
  World world = make_world(space(), with(platforms().front(), SteadyMotion{.velocity = {0, 0.5, 0}}));
  const ProjectileId stands = *world.spawn(puck(), {.position = {1, kTop + 0.1, 0}}, landing(0.1));
  const ProjectileId comes = *world.spawn(puck(), {.position = {-1, 0, 0}, .velocity = Vec3d{0, 9, 0}}, landing(0.1));
  run_for(world, 3, 1.0 / 60);
  EXPECT_NEAR(world[stands].position().y, kTop + 0.1 + 0.5 * world.time(), 1e-6);
  EXPECT_NEAR(world[comes].position().y, kTop + 0.1 + 0.5 * world.time(), 1e-6);
}

/// Two in a pile stay on it; one that comes from below through the platform is not pushed out of it.
TEST(OneWay, carries_piles) {
  World world = make_world(space(), with(platforms().front()));
  BodyDef body = landing(0.1);
  body.collision.others = 1;
  const ProjectileId low = *world.spawn(puck(), {.position = {0, kTop + 0.1, 0}}, body);
  const ProjectileId high = *world.spawn(puck(), {.position = {0, kTop + 0.35, 0}}, body);
  run_for(world, 2, 1.0 / 60);
  EXPECT_NEAR(world[low].position().y, kTop + 0.1, 1e-6);
  EXPECT_NEAR(world[high].position().y, kTop + 0.3, 1e-6);
}

TEST(OneWay, stops_flights_from_its_front_alone) {
  const Scene scene = with(platforms().front());
  Until until = meeting(scene, OnHit::stop);
  until.time = 5;
  const Flight flight = fly(puck(), {.velocity = Vec3d{0, 8, 0}}, vacuum_of(kG), puck().fidelity, {}, until);
  EXPECT_EQ(flight.outcome(), Outcome::hit);
  EXPECT_NEAR(flight.end().time, (8 + std::sqrt(64 - 2 * kG * kTop)) / kG, 1e-8);
}

TEST(OneWay, what_makes_no_sense_is_refused_with_its_place) {
  Scene scene;
  InstanceDef def{.shape = *scene.add_shape(SphereShape{1}), .passage = {.front = {0, std::nan(""), 0}}};
  EXPECT_EQ(scene.add(def).error().place, "instance.passage.front");
  def.passage.front = {0, 1e-20, 0};
  EXPECT_EQ(scene.add(def).error().place, "instance.passage.front");
  def.passage.front = {0, 1, 0};
  def.sensor = true;
  EXPECT_EQ(scene.add(def).error().message, "a sensor stops nothing");
  def.sensor = false;
  EXPECT_TRUE(scene.add(def));
  def.passage = {.tells_stay = true};
  EXPECT_EQ(scene.add(def).error().place, "instance.passage.tells_stay");
}

TEST(OneWay, is_kept_by_saves_and_recordings) {
  std::vector<std::byte> recording;
  World world = make_world(space());
  ASSERT_TRUE(world.record(record_into(recording)));
  ASSERT_TRUE(world.set_scene(with(platforms().front())));
  ASSERT_TRUE(world.spawn(puck(), {.velocity = Vec3d{0, 8, 0}}, landing(0.1)));
  run_for(world, 0.4, 1.0 / 60);
  World loaded = reloaded(world);
  run_for(world, 2, 1.0 / 60), run_for(loaded, 2, 1.0 / 60);
  EXPECT_EQ(loaded.hash(), world.hash());
  EXPECT_NEAR(loaded[loaded.ids().front()].position().y, kTop + 0.1, 1e-8);
  replayed(world, recording);
}

// ------------------------------------------------------------------------------------------------------- sensors
/// A stone at 8 m/s through a sensor of 2 m: in, a stay in each step that begins and ends in it, and out.
TEST(SensorStays, are_told_between_in_and_out) {
  for (const bool tells : {true, false})
    for (const double rate : {24.0, 60.0, 240.0}) {
      Scene scene;
      const InstanceId gate =
          add_thing(scene, BoxShape{{1, 1, 1}},
                    {.transform = {.position = {5.03, 0, 0}}, .sensor = true, .passage = {.tells_stay = tells}});
      World world = make_world(space(0), scene);
      ASSERT_TRUE(world.spawn(puck(), {.velocity = Vec3d{8, 0, 0}}, landing()));
      const auto all = run_for(world, 1, 1 / rate);
      const auto in = of_kind(all, EventKind::sensed), stays = of_kind(all, EventKind::stayed),
                 out = of_kind(all, EventKind::left);
      ASSERT_EQ(in.size(), 1u);
      ASSERT_EQ(out.size(), 1u);
      const double enters = 4.03 / 8, leaves = 6.03 / 8;
      EXPECT_NEAR(in[0].time, enters, 1e-9);
      EXPECT_NEAR(out[0].time, leaves, 1e-9);
      const double first = std::ceil(enters * rate), last = std::floor(leaves * rate);
      ASSERT_EQ(stays.size(), tells ? static_cast<std::size_t>(last - first) : 0u) << rate;
      for (std::size_t i = 0; i < stays.size(); ++i) {
        EXPECT_NEAR(stays[i].time, (first + 1 + static_cast<double>(i)) / rate, 1e-9);
        EXPECT_NEAR(stays[i].position.x, 8 * stays[i].time, 1e-9);
        EXPECT_EQ(stays[i].instance, gate);
      }
    }
}

/// What leaves a sensor within rounding of a step's end has left it: nothing tells of a stay behind that.
TEST(SensorStays, end_before_the_way_out_at_the_end_of_a_step) {
  for (const double rate : {10.0, 20.0, 30.0, 60.0, 120.0, 240.0})
    for (const double speed : {1.0, 4.0, 8.0, 10.0, 20.0}) {
      Scene scene;
      add_thing(scene, SphereShape{1},
                {.transform = {.position = {10, 0, 0}}, .sensor = true, .passage = {.tells_stay = true}});
      World world = make_world(space(0), scene);
      ASSERT_TRUE(world.spawn(puck(), {.velocity = Vec3d{speed, 0, 0}}, landing()));
      const auto all = run_for(world, 12 / speed, 1 / rate);
      const auto in = of_kind(all, EventKind::sensed), stays = of_kind(all, EventKind::stayed),
                 out = of_kind(all, EventKind::left);
      ASSERT_EQ(in.size(), 1u) << rate << " Hz, " << speed << " m/s";
      ASSERT_EQ(out.size(), 1u) << rate << " Hz, " << speed << " m/s";
      EXPECT_NEAR(out[0].time, 11 / speed, 1e-9);
      for (const Event& stay : stays) EXPECT_LT(stay.time, out[0].time) << rate << " Hz, " << speed << " m/s";
    }
}

}  // namespace physim::world_one_way_test
