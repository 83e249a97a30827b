// What contacts do in worlds: spin and velocity, things that move, ways into and through materials.
#include <array>

#include "scene_support.hpp"

namespace physim::world_scene_contact_test {

using test_scene::bouncing;

constexpr double kG = 9.80665;

WorldDef open_space(AirModel air = AirModel::vacuum) {
  return {.environment = {.atmosphere = {.model = air}}, .ground = {.mode = GroundMode::none}};
}

Scene floor_of(const Material& material, double slope = 0) {
  Scene scene;
  const MaterialId made_of = *scene.add_material(material);
  add_thing(scene, PlaneShape{},
            {.transform = {.rotation = {std::cos(slope / 2), 0, 0, -std::sin(slope / 2)}}, .material = made_of});
  return scene;
}

/// A ball that is thrown down, spinning about z, at a floor that grips it: R. Cross, "Grip-slip behavior of a bouncing
/// ball", Am. J. Phys. 70 (2002): what rolls without slip after the bounce has v' = (v - k r w) / (1 + k).
struct Bounce {
  double speed_along;
  double spin;  // about z [rad/s]
};
Bounce gripped(const Bounce& before, double radius, double k) {
  const double v = (before.speed_along - k * radius * before.spin) / (1 + k);
  return {v, -v / radius};
}
/// It slides through the whole bounce: friction times the impulse.
Bounce slid(const Bounce& before, double radius, double k, double impulse) {
  const double sign = before.speed_along + radius * before.spin > 0 ? 1 : -1;
  return {before.speed_along - sign * impulse, before.spin - sign * impulse / (k * radius)};
}

class SpinOfBounce : public testing::TestWithParam<RotationModel> {
 protected:
  /// Throws a ball and gives how it went on from the floor.
  static Bounce thrown(const Bounce& before, double down, double friction, double k, double radius) {
    ProjectilePreset golf = *projectile_preset("golf_ball");
    ProjectileDef p = golf.projectile;
    p.fidelity = Fidelity::simulation();
    p.fidelity.precision = Precision::float64;
    p.fidelity.rotation = GetParam();
    p.fidelity.earth = EarthModel::flat;
    p.diameter = 2 * radius;
    p.inertia.moments = {1e-5, 1e-5, 1e-5};
    World world = make_world(open_space(AirModel::isa), floor_of({.restitution = 0.8, .friction = friction}));
    BodyDef body = bouncing(radius);
    body.collision.inertia = k;
    Launch launch{.position = {0, radius + 1e-3, 0}, .velocity = Vec3d{before.speed_along, -down, 0}};
    const ProjectileId id = *world.spawn(p, launch, body);
    EXPECT_TRUE(world[id].set_angular_velocity({0, 0, before.spin}));
    if (GetParam() == RotationModel::magnus) {  // its spin is that of its launch
      world.despawn(std::array{id});
      launch.spin.backspin = before.speed_along > 0 ? before.spin : -before.spin;  // seen along its way
      EXPECT_TRUE(world.spawn(p, launch, body));
    }
    Bounce after{};
    for (int i = 0; i < 10; ++i) {
      world.step(1e-3);
      for (const Event& e : events_of(world, EventKind::bounced)) {
        after = {e.velocity.x, world[e.id].angular_velocity().z};
        EXPECT_NEAR(e.velocity.y, 0.8 * down, 0.02);
        return after;
      }
    }
    ADD_FAILURE() << "it did not bounce";
    return after;
  }
};

TEST_P(SpinOfBounce, a_floor_that_grips_leaves_no_slip) {
  for (const double k : {0.4, 2.0 / 3})
    for (const Bounce before : {Bounce{5, 0}, Bounce{5, 300}, Bounce{5, -400}, Bounce{-2, 100}}) {
      const Bounce after = thrown(before, 8, 5, k, 0.02);
      const Bounce right = gripped(before, 0.02, k);
      EXPECT_NEAR(after.speed_along, right.speed_along, 0.02);
      EXPECT_NEAR(after.spin, right.spin, 1);
    }
}

TEST_P(SpinOfBounce, a_slippery_floor_takes_what_friction_gives) {
  for (const Bounce before : {Bounce{9, 0}, Bounce{9, 300}, Bounce{-9, 100}}) {
    const Bounce after = thrown(before, 8, 0.1, 0.4, 0.02);
    const Bounce right = slid(before, 0.02, 0.4, 0.1 * 1.8 * 8);
    EXPECT_NEAR(after.speed_along, right.speed_along, 0.02);
    EXPECT_NEAR(after.spin, right.spin, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Rungs, SpinOfBounce,
                         testing::Values(RotationModel::none, RotationModel::magnus, RotationModel::rigid_body));

TEST(SceneContact, a_ball_on_a_slope_slides_or_rolls_as_friction_lets_it) {
  constexpr double kSlope = 30 * test::kDegree;
  struct Case {
    double friction;
    double acceleration;
  };
  const double g_along = kG * std::sin(kSlope), g_on = kG * std::cos(kSlope);
  for (const auto& [friction, acceleration] :
       {Case{1, g_along / 1.4}, Case{0.1, g_along - 0.1 * g_on}, Case{0, g_along}}) {
    World world = make_world(open_space(), floor_of({.restitution = 0, .friction = friction}, kSlope));
    const Vec3d normal{std::sin(kSlope), std::cos(kSlope), 0};
    const ProjectileId id = *world.spawn(stone(), {.position = normal * (0.05 + 1e-9)}, bouncing(0.05, 0));
    run_for(world, 2, 1.0 / 60);
    const double time = world.time();
    EXPECT_NEAR(length(world[id].velocity()), acceleration * time, 1e-3 * acceleration * time);
    EXPECT_NEAR(length(world[id].position() - normal * 0.05), 0.5 * acceleration * time * time, 0.01 * acceleration);
    if (friction == 1) {
      EXPECT_NEAR(world[id].angular_velocity().z, -acceleration * time / 0.05, 0.01 * acceleration * time / 0.05);
    }
  }
}

/// Two slopes of 45 degrees, and a groove between them that falls along z: down it without friction, at rest across.
TEST(SceneContact, a_ball_in_a_groove_goes_along_it) {
  constexpr double kFall = 20 * test::kDegree;
  Scene scene;
  const MaterialId ice = *scene.add_material({.restitution = 0, .friction = 0});
  const ShapeId plane = *scene.add_shape(PlaneShape{});
  const Quatd fall{std::cos(kFall / 2), std::sin(kFall / 2), 0, 0};  // about x
  for (const double side : {-1.0, 1.0}) {
    const double a = side * 45 * test::kDegree / 2;
    ASSERT_TRUE(scene.add(
        {.shape = plane, .transform = {.rotation = fall * Quatd{std::cos(a), 0, 0, std::sin(a)}}, .material = ice}));
  }
  World world = make_world(open_space(), scene);
  const Vec3d up{0, std::cos(kFall), std::sin(kFall)}, down{0, -std::sin(kFall), std::cos(kFall)};
  const ProjectileId id = *world.spawn(stone(), {.position = up * 0.2}, bouncing(0.1, 0));
  run_for(world, 3, 1.0 / 60);
  const Vec3d x = world[id].position(), v = world[id].velocity();
  const double a = kG * std::sin(kFall);
  EXPECT_NEAR(dot(v, down), a * world.time(), 0.05 * a);
  EXPECT_NEAR(dot(x, down), 0.5 * a * world.time() * world.time(), 0.2 * a);
  EXPECT_NEAR(x.x, 0, 0.01);
  EXPECT_NEAR(dot(x, up), 0.1 * std::sqrt(2.0), 0.01);
}

/// A ball that slides, without spin at first, rolls with 5/7 of its speed in the end.
TEST(SceneContact, sliding_becomes_rolling_with_five_sevenths_of_the_speed) {
  World world = make_world(open_space(), floor_of({.restitution = 0, .friction = 0.2}));
  Launch launch{.position = {0, 0.03 + 1e-9, 0}, .velocity = Vec3d{7, 0, 0}};
  const ProjectileId id = *world.spawn(stone(), launch, bouncing(0.03, 0));
  const double rolls_after = 7 * 2.0 / 7 / (0.2 * kG);  // u / (mu g (1 + 1/k))
  run_for(world, 0.5 * rolls_after, 1.0 / 240);
  EXPECT_NEAR(world[id].velocity().x, 7 - 0.2 * kG * world.time(), 0.02);
  run_for(world, rolls_after, 1.0 / 240);
  EXPECT_NEAR(world[id].velocity().x, 5, 0.01);
  EXPECT_NEAR(world[id].angular_velocity().z, -5 / 0.03, 0.5);
}

TEST(SceneContact, a_wall_that_moves_strikes_what_stands) {
  for (const double radius : {0.0, 0.1})
    for (const bool keyed : {false, true}) {
      Scene scene;
      const MaterialId hard = *scene.add_material({.restitution = 1, .friction = 0});
      SceneMotion motion = SteadyMotion{.velocity = {50, 0, 0}};
      if (keyed) motion = KeyedMotion{{{.time = 0, .position = {-10, 0, 0}}, {.time = 10, .position = {490, 0, 0}}}};
      add_thing(scene, BoxShape{{0.0005, 5, 5}},
                {.transform = {.position = {-10, 0, 0}}, .material = hard, .motion = motion});
      World world = make_world(open_space(), scene);
      BodyDef body = bouncing(radius);
      body.gravity_scale = 0;
      body.can_sleep = true;
      body.sleep_time = 0.05;
      const ProjectileId id = *world.spawn(stone(), {}, body);
      std::vector<Event> bounced;
      for (const Event& e : run_for(world, 0.5, 1.0 / 60))
        if (e.kind == EventKind::bounced) bounced.push_back(e);
      ASSERT_EQ(bounced.size(), 1u);
      EXPECT_NEAR(bounced[0].time, (10 - 0.0005 - radius) / 50, 1e-8);
      EXPECT_LT(length(world[id].velocity() - Vec3d{100, 0, 0}), 1e-9);
    }
}

TEST(SceneContact, a_platform_carries_what_lies_on_it) {
  Scene scene;
  const MaterialId rough = *scene.add_material({.restitution = 0, .friction = 1});
  const InstanceId lift =
      add_thing(scene, BoxShape{{50, 0.5, 5}}, {.material = rough, .motion = SteadyMotion{.velocity = {1, 0.5, 0}}});
  World world = make_world(open_space(), scene);
  BodyDef body = bouncing(0, 0);
  body.rolling_resistance = 0.3;
  body.can_sleep = true;
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 0.6, 0}}, body);
  run_for(world, 4, 1.0 / 60);
  EXPECT_LT(length(world[id].velocity() - Vec3d{1, 0.5, 0}), 1e-6);
  EXPECT_NEAR(world[id].position().y, world.scene()->state(lift, world.time())->position.y + 0.5, 1e-6);
  EXPECT_FALSE(world[id].is_asleep());
}

/// R. F. Recht, T. W. Ipson (1963): what comes out behind has v_r^2 = v^2 - limit^2 here.
TEST(SceneContact, a_bullet_goes_through_a_plank_and_stops_in_a_wall) {
  Scene scene;
  const MaterialId plank =
      *scene.add_material({.name = "plank", .penetration = BallisticLimitDef{.speed = 300, .a = 1, .p = 2}});
  const MaterialId wall = *scene.add_material(materials::oak());
  const InstanceId first =
      add_thing(scene, BoxShape{{0.01, 1, 1}}, {.transform = {.position = {10, 0, 0}}, .material = plank});
  const InstanceId second =
      add_thing(scene, BoxShape{{5, 10, 10}}, {.transform = {.position = {25, 0, 0}}, .material = wall});
  World world = make_world(open_space(), scene);
  BodyDef body{.gravity_scale = 0, .collision = {.on_hit = OnHit::impact}};
  ProjectileDef p = bullet();
  p.fidelity = stone().fidelity;
  const ProjectileId id = *world.spawn(p, {.speed = 500}, body);
  const auto events = run_for(world, 0.2, 1.0 / 60);
  std::vector<Event> told;
  for (const Event& e : events)
    if (e.kind != EventKind::spawned) told.push_back(e);
  ASSERT_EQ(told.size(), 4u);
  EXPECT_EQ(told[0].kind, EventKind::hit);
  EXPECT_EQ(told[0].instance, first);
  EXPECT_EQ(told[1].kind, EventKind::penetrated);
  EXPECT_NEAR(told[1].velocity.x, 400, 1e-9);
  EXPECT_NEAR(told[1].position.x, 10.01, 1e-8);
  EXPECT_NEAR(told[1].value, 0.02, 1e-8);
  EXPECT_NEAR(told[1].energy, 0.5 * p.mass * (500 * 500 - 400 * 400), 1e-6);
  EXPECT_EQ(told[2].kind, EventKind::hit);
  EXPECT_EQ(told[2].instance, second);
  EXPECT_NEAR(told[2].time, 9.99 / 500 + 9.99 / 400, 1e-8);
  EXPECT_EQ(told[3].kind, EventKind::stopped);
  EXPECT_NEAR(told[3].position.x, 20 + told[3].value, 1e-8);
  EXPECT_GT(told[3].value, 0.01);
  EXPECT_EQ(world[id].status(), LifeStatus::landed);
  EXPECT_NEAR(world[id].position().x, told[3].position.x, 1e-9);
}

TEST(SceneContact, a_ball_skips_off_water_and_a_steep_one_does_not) {
  Scene scene = floor_of(materials::water());
  for (const double angle : {4 * test::kDegree, 60 * test::kDegree}) {
    World world = make_world(open_space(), scene);
    BodyDef body{.collision = {.on_hit = OnHit::impact}};
    ProjectileDef p = stone();
    p.mass = 5;
    p.diameter = 0.1;
    Launch launch{.position = {0, 1e-3, 0}, .velocity = Vec3d{std::cos(angle), -std::sin(angle), 0} * 200.0};
    ASSERT_TRUE(world.spawn(p, launch, body));
    world.step(1.0 / 60);
    const bool skips = angle < 0.2;
    EXPECT_EQ(events_of(world, EventKind::ricocheted).size(), skips ? 1u : 0u);
    for (const Event& e : events_of(world, EventKind::ricocheted)) {
      EXPECT_GT(e.velocity.y, 0);
      EXPECT_LT(length(e.velocity), 200);
    }
  }
}

/// Solids and surfaces whose highest place is the origin, where a face or a round top looks upwards.
std::vector<std::pair<const char*, ShapeDef>> shapes_below_origin() {
  const std::vector<Vec3d> corners = {{-9, -2, -9}, {9, -2, -9}, {9, -2, 9}, {-9, -2, 9},
                                      {-9, 0, -9},  {9, 0, -9},  {9, 0, 9},  {-9, 0, 9}};
  MeshShape open{.vertices = corners, .triangles = {{4, 7, 6}, {4, 6, 5}}};
  MeshShape closed = open;
  for (const std::array<std::uint32_t, 4>& side :
       {std::array<std::uint32_t, 4>{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}})
    closed.triangles.push_back({side[0], side[1], side[2]}), closed.triangles.push_back({side[0], side[2], side[3]});
  return {{"plane", PlaneShape{}},    {"hull", ConvexHullShape{corners}}, {"mesh", open},
          {"closed mesh", closed},    {"box", BoxShape{{9, 1, 9}}},       {"cylinder", CylinderShape{9, 1}},
          {"sphere", SphereShape{1}}, {"capsule", CapsuleShape{0.5, 0.5}}};
}
/// How far the middle of a shape lies below its top.
double depth_of(const ShapeDef& shape) {
  const bool about_middle = std::holds_alternative<BoxShape>(shape) || std::holds_alternative<CylinderShape>(shape) ||
                            std::holds_alternative<SphereShape>(shape) || std::holds_alternative<CapsuleShape>(shape);
  return about_middle ? 1 : 0;
}

/// The first hit of a ball of 0.2 m that is launched with its middle at a place.
Event first_hit_of_ball(const Scene& scene, const Vec3d& middle, const Vec3d& velocity) {
  World world = make_world(open_space(), scene);
  ProjectileDef ball = stone();
  ball.fidelity = Fidelity::constant_air();
  const auto id = world.spawn(ball, {.position = middle, .velocity = velocity}, bouncing(0.2));
  EXPECT_TRUE(id);
  EXPECT_TRUE(world.step(1e-3));
  for (const Event& event : world.events())
    if (event.kind == EventKind::hit) return event;
  ADD_FAILURE() << "it meets nothing";
  return {};
}

TEST(SceneContact, a_ball_whose_middle_lies_at_a_surface_is_pushed_out_by_its_radius) {
  for (const auto& [name, shape] : shapes_below_origin())
    for (const Vec3d& where : {Vec3d{}, Vec3d{0.1, 0.3, -0.7}, Vec3d{1234.5, 77.7, -3210.1}}) {
      SCOPED_TRACE(name);
      Scene scene;
      const Vec3d place = where - Vec3d{0, depth_of(shape), 0};
      add_thing(scene, shape, {.transform = {.position = place}});
      for (const double above : {1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, -1e-16, -1e-15, -1e-14, -1e-13}) {
        const Vec3d middle = where + Vec3d{0, above, 0};
        const Event hit = first_hit_of_ball(scene, middle, {1e-3, -1, 3e-4});
        EXPECT_NEAR(length(hit.normal), 1, 1e-12) << above;
        EXPECT_NEAR(hit.normal.y, 1, 1e-9) << above;
        EXPECT_NEAR(hit.position.y - where.y, 0.2, 1e-9) << above;
      }
    }
}

TEST(SceneContact, a_ball_whose_middle_lies_at_a_surface_is_pushed_out_wherever_it_moves) {
  Scene scene;
  add_thing(scene, BoxShape{{9, 1, 9}}, {.transform = {.position = {0.1, -0.7, 0}}});
  for (const double above : {0.0, 1e-14, -1e-14, -1e-12})
    for (const Vec3d& velocity : {Vec3d{1, 0, 0.5}, Vec3d{}, Vec3d{0, 1e-3, 0}}) {
      World world = make_world(open_space(), scene);
      ProjectileDef ball = stone();
      ball.fidelity = Fidelity::constant_air();
      const ProjectileId id =
          *world.spawn(ball, {.position = {0.2, 0.3 + above, 0.1}, .velocity = velocity}, bouncing(0.2));
      ASSERT_TRUE(world.step(1e-3));
      EXPECT_NEAR(world[id].position().y, 0.5, 1e-5) << above << ' ' << velocity.x << ' ' << velocity.y;
      EXPECT_NEAR(world[id].position().x, 0.2 + 1e-3 * velocity.x, 1e-4) << above << ' ' << velocity.x;
    }
}

TEST(SceneContact, a_ball_whose_middle_lies_at_an_edge_or_a_corner_is_pushed_out_by_its_radius) {
  Scene scene;
  add_thing(scene, BoxShape{{1, 1, 1}});
  for (const Vec3d& out : {Vec3d{0, 1, 1}, Vec3d{1, 1, 1}})
    for (const double away : {1e-16, 1e-15, 1e-14, 1e-13, 1e-12}) {
      const Event hit = first_hit_of_ball(scene, out + normalized(out) * away, -out);
      EXPECT_NEAR(length(hit.normal), 1, 1e-12) << away;
      EXPECT_NEAR(length(hit.position - out), 0.2, 1e-9) << away;
    }
}

}  // namespace physim::world_scene_contact_test
