// What starts at surfaces, goes along them, and through several that touch.
#include <array>

#include "random_shots.hpp"
#include "world/thing_support.hpp"

namespace physim::world_scene_surface_test {

using namespace test_things;

constexpr double kG = 9.80665;
constexpr double kStep = 1.0 / 60;

/// Flies exactly.
ProjectileDef thrown() {
  ProjectileDef p = stone();
  p.fidelity.integrator = Integrator::rk4;
  return p;
}

InstanceId put(Scene& scene, const ShapeDef& shape, const Vec3d& at, const Material& material,
               const SceneMotion& motion = {}) {
  return add_thing(scene, shape,
                   {.transform = {.position = at}, .material = *scene.add_material(material), .motion = motion});
}

World world_with(const Scene& scene, const WorldDef& def = nothing_but_things()) { return make_world(def, scene); }

std::size_t count(const std::vector<Event>& events, EventKind kind) {
  return static_cast<std::size_t>(
      std::count_if(events.begin(), events.end(), [kind](const Event& e) { return e.kind == kind; }));
}
bool some_inside(const std::vector<Event>& events) {
  return std::any_of(events.begin(), events.end(), [](const Event& e) { return e.reason == Reason::inside; });
}

/// Speed behind some planks of softwood, by impact() alone.
double speed_behind(double speed, std::initializer_list<double> thicknesses) {
  for (const double thickness : thicknesses) {
    const Impact hit{
        .mass = 0.0109, .diameter = 0.00782, .velocity = {speed, 0, 0}, .normal = {-1, 0, 0}, .thickness = thickness};
    speed = impact(hit, materials::fir())->velocity.x;
  }
  return speed;
}

// --------------------------------------------------------------------------------------------- at a surface
TEST(SceneSurface, what_starts_on_a_surface_flies_off) {
  const MeshShape sheet{{{-50, 0, -50}, {-50, 0, 50}, {50, 0, 50}, {50, 0, -50}}, {{0, 1, 2}, {0, 2, 3}}, {}};
  const std::pair<ShapeDef, Vec3d> surfaces[] = {
      {PlaneShape{}, {}},
      {BoxShape{{50, 1, 50}}, {0, -1, 0}},
      {BoxShape{{50, 0.1, 50}}, {0, -0.1, 0}},
      {sheet, {}},
      {HeightFieldShape{3, 3, 50, 50, std::vector<double>(9, 0.0)}, {-50, 0, -50}}};
  for (const auto& [shape, at] : surfaces)
    for (const OnHit on_hit : {OnHit::bounce, OnHit::impact, OnHit::stop})
      for (const Vec3d& v : {Vec3d{0, 10, 0}, Vec3d{10, 10, 0}, Vec3d{20, 3, 1}}) {
        Scene scene;
        put(scene, shape, at, materials::water());
        World world = world_with(scene);
        const ProjectileId id = *world.spawn(thrown(), launched({0.3, 0, 0.1}, v), body_that(on_hit));
        const auto events = run_for(world, 0.5, kStep);
        EXPECT_EQ(count(events, EventKind::hit), 0u) << shape.index();
        const double t = world.time();
        const Vec3d right = Vec3d{0.3, 0, 0.1} + v * t - Vec3d{0, 0.5 * kG * t * t, 0};
        EXPECT_LT(length(world[id].position() - right), 1e-9) << shape.index();
      }
}

/// It touches a floor without restitution, and flies at a wall that throws it back, which it overlaps more.
TEST(SceneSurface, a_ball_that_overlaps_meets_the_nearest_as_it_is) {
  for (const double wall_speed : {0.0, -2.0}) {
    Scene scene;
    put(scene, PlaneShape{}, {}, {.restitution = 0, .friction = 0});
    const InstanceId wall = put(scene, BoxShape{{0.5, 5, 5}}, {0.55, 0, 0}, {.restitution = 1, .friction = 0},
                                SteadyMotion{.velocity = {wall_speed, 0, 0}});
    World world = world_with(scene);
    BodyDef body = body_that(OnHit::bounce, 0.1);
    body.gravity_scale = 0;
    const ProjectileId id = *world.spawn(stone(), launched({0, 0.0999, 0}, {5, 0, 0}), body);
    world.step(kStep);
    ASSERT_FALSE(events_of(world, EventKind::bounced).empty());
    EXPECT_EQ(events_of(world, EventKind::bounced).front().instance, wall);
    EXPECT_LT(length(world[id].velocity() - Vec3d{2 * wall_speed - 5, 0, 0}), 1e-9);
  }
}

// --------------------------------------------------------------------------------------------- through things
TEST(SceneSurface, planks_face_to_face_are_gone_through_one_by_one) {
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (const double radius : {0.0, 0.003}) {
      int came_through = 0;
      for (int i = 0; i < 20; ++i) {
        Scene scene;
        for (int k = 0; k < 4; ++k)
          put(scene, BoxShape{{0.009, 1, 1}}, {50 + 0.137 * i + 0.018 * k, 0, 0}, materials::fir());
        World world = world_with(scene);
        BodyDef body = body_that(OnHit::impact, radius);
        body.gravity_scale = 0;
        const ProjectileId id = *world.spawn(shot(precision), launched({0, 0.3, 0}, {780, 0, 0}), body);
        const auto events = run_for(world, 0.2, kStep);
        EXPECT_FALSE(some_inside(events));
        if (count(events, EventKind::hit) != 4 || count(events, EventKind::penetrated) != 4) continue;
        const double right = speed_behind(780, {0.018, 0.018, 0.018, 0.018});
        EXPECT_NEAR(world[id].velocity().x, right, precision == Precision::float32 ? 0.05 : 1e-5);
        ++came_through;
      }
      EXPECT_EQ(came_through, 20) << radius;
    }
}

TEST(SceneSurface, boards_of_one_thing_are_as_thick_as_they_are_together) {
  for (const double overlap : {0.0, 0.002, 0.009}) {
    Scene scene;
    const ShapeId board = *scene.add_shape(BoxShape{{0.0045, 1, 1}});
    const ShapeId both = *scene.add_shape(CompoundShape{
        {{board, {.position = {(overlap - 0.009) / 2, 0, 0}}}, {board, {.position = {(0.009 - overlap) / 2, 0, 0}}}}});
    ASSERT_TRUE(scene.add(
        {.shape = both, .transform = {.position = {50, 0, 0}}, .material = *scene.add_material(materials::fir())}));
    World world = world_with(scene);
    BodyDef body = body_that(OnHit::impact);
    body.gravity_scale = 0;
    ASSERT_TRUE(world.spawn(shot(), launched({0, 0.1, 0}, {780, 0, 0}), body));
    std::vector<Event> through;
    for (const Event& e : run_for(world, 0.2, kStep))
      if (e.kind == EventKind::penetrated) through.push_back(e);
    ASSERT_EQ(through.size(), 1u) << overlap;
    EXPECT_NEAR(through[0].value, 0.018 - overlap, 1e-9);
    EXPECT_NEAR(through[0].velocity.x, speed_behind(780, {0.018 - overlap}), 1e-5);
  }
}

TEST(SceneSurface, a_ball_hits_a_plank_once_and_comes_out_behind_it) {
  Scene scene;
  put(scene, BoxShape{{0.009, 1, 1}}, {50, 0, 0}, materials::fir());
  World world = world_with(scene);
  ASSERT_TRUE(world.spawn(shot(), launched({0, 0.1, 0}, {780, 0, 0}), body_that(OnHit::impact, 0.004)));
  const auto events = run_for(world, 0.2, kStep);
  EXPECT_EQ(count(events, EventKind::hit), 1u);
  EXPECT_EQ(count(events, EventKind::penetrated), 1u);
  EXPECT_EQ(count(events, EventKind::bounced), 0u);
  const auto out = std::ranges::find(events, EventKind::penetrated, &Event::kind);
  ASSERT_NE(out, events.end());
  EXPECT_NEAR(out->position.x, 50.009 + 0.004, 1e-6) << "a radius behind it";
}

/// Over the upper edge of a plank, by a part of its radius.
TEST(SceneSurface, a_ball_that_grazes_an_edge_does_not_stay_in_the_air) {
  for (const double above : {0.0005, 0.001, 0.002, 0.003, 0.0039}) {
    Scene scene;
    put(scene, BoxShape{{0.009, 1, 1}}, {50, 0, 0}, materials::fir());
    World world = world_with(scene);
    BodyDef body = body_that(OnHit::impact, 0.004);
    body.gravity_scale = 0;
    const ProjectileId id = *world.spawn(shot(), launched({0, 1 + above, 0}, {780, 0, 0}), body);
    const auto events = run_for(world, 0.2, kStep);
    EXPECT_EQ(count(events, EventKind::hit), 1u) << above;
    EXPECT_EQ(world[id].status(), LifeStatus::in_flight) << above;
  }
}

TEST(SceneSurface, a_sheet_is_met_from_its_back_as_from_its_front) {
  for (const double radius : {0.0, 0.003}) {
    std::vector<EventKind> told[2];
    for (const bool front : {false, true}) {
      MeshShape sheet{{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}, {{0, 1, 2}, {0, 2, 3}}, {}};
      if (front) sheet.triangles = {{0, 2, 1}, {0, 3, 2}};
      for (int i = 0; i < 20; ++i) {
        Scene scene;
        Material material = materials::fir();
        if (i % 2 == 0) material.penetration = BallisticLimitDef{.speed = 300, .a = 1, .p = 2};
        put(scene, sheet, {50 + 0.01 * i, 0, 0}, material);
        World world = world_with(scene);
        ASSERT_TRUE(world.spawn(shot(), launched({0, 0.1, 0}, {780, 0, 0}), body_that(OnHit::impact, radius)));
        for (const Event& e : run_for(world, 0.1, kStep)) told[front ? 1 : 0].push_back(e.kind);
      }
    }
    EXPECT_EQ(told[0], told[1]) << radius;
    EXPECT_EQ(std::ranges::count(told[0], EventKind::bounced), 0) << radius;
    EXPECT_EQ(std::ranges::count(told[0], EventKind::penetrated), 10) << radius;
  }
}

TEST(SceneSurface, a_plate_that_overtakes_lets_a_bullet_through) {
  for (int i = 0; i < 60; ++i) {
    Scene scene;
    put(scene, BoxShape{{0.009, 1, 1}}, {-50 - 0.137 * i, 0, 0}, materials::fir(),
        SteadyMotion{.velocity = {800, 0, 0}});
    World world = world_with(scene);
    BodyDef body = body_that(OnHit::impact);
    body.gravity_scale = 0;
    ASSERT_TRUE(world.spawn(shot(Precision::float32), launched({0, 0.1, 0}, {100, 0, 0}), body));
    const auto events = run_for(world, 0.25, kStep);
    EXPECT_EQ(count(events, EventKind::penetrated), 1u) << i;
    EXPECT_EQ(count(events, EventKind::hit), 1u) << i;
  }
}

/// What comes out of the first is inside of the second: each is gone through by what of it lies ahead.
TEST(SceneSurface, things_that_overlap_are_gone_through_one_by_one) {
  for (const double radius : {0.0, 0.003})
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (int i = 0; i < 20; ++i) {
        Scene scene;
        const double x = 50 + 0.137 * i;
        put(scene, BoxShape{{0.009, 1, 1}}, {x, 0, 0}, materials::fir());
        put(scene, BoxShape{{0.009, 1, 1}}, {x + 0.014, 0, 0}, materials::oak());
        put(scene, SphereShape{2}, {x + 3, 0, 0}, materials::fir());
        World world = world_with(scene);
        ASSERT_TRUE(world.spawn(shot(precision), launched({0, 0.1, 0}, {780, 0, 0}), body_that(OnHit::impact, radius)));
        const auto events = run_for(world, 0.2, kStep);
        std::vector<double> through;
        for (const Event& e : events)
          if (e.kind == EventKind::penetrated) through.push_back(e.value);
        ASSERT_EQ(through.size(), 2u) << i;
        EXPECT_NEAR(through[0], 0.018, 2e-5);
        EXPECT_NEAR(through[1], 0.014 - (radius > 0 ? 2 * radius : 0), 2e-5) << "what lies ahead of a ball's front";
        EXPECT_EQ(count(events, EventKind::hit), 3u) << "each of them, and the last thing";
        EXPECT_EQ(count(events, EventKind::stopped), 1u);
      }
}

/// The corner of a house: where walls overlap, nobody stands still without a word.
TEST(SceneSurface, what_goes_through_the_corner_of_two_walls_is_told) {
  for (int i = 0; i < 60; ++i) {
    Scene scene;
    put(scene, BoxShape{{0.1, 2, 5}}, {50, 0, 5}, materials::fir());
    put(scene, BoxShape{{5, 2, 0.1}}, {55, 0, 0.1}, materials::fir());
    World world = world_with(scene);
    const ProjectileId id =
        *world.spawn(shot(i % 2 == 0 ? Precision::float32 : Precision::float64),
                     launched({30, 0.1, -8 + 0.25 * i}, {600, 0, 300 - 10.0 * i}), body_that(OnHit::impact));
    const auto events = run_for(world, 0.3, kStep);
    const auto kinds = {EventKind::penetrated, EventKind::stopped, EventKind::ricocheted, EventKind::bounced};
    std::size_t told = 0;
    for (const EventKind kind : kinds) told += count(events, kind);
    EXPECT_EQ(told, count(events, EventKind::hit)) << i;
    EXPECT_EQ(count(events, EventKind::stopped), world[id].status() == LifeStatus::landed ? 1u : 0u) << i;
  }
}

TEST(SceneSurface, what_comes_out_without_speed_is_a_number) {
  Scene scene;
  put(scene, BoxShape{{0.009, 1, 1}}, {50, 0, 0}, {.penetration = BallisticLimitDef{.speed = 300, .a = 0}});
  World world = world_with(scene);
  const ProjectileId id = *world.spawn(shot(), launched({0, 0.1, 0}, {780, 0, 0}), body_that(OnHit::impact));
  const auto events = run_for(world, 0.5, kStep);
  EXPECT_EQ(count(events, EventKind::penetrated), 1u);
  ASSERT_TRUE(world[id].is_alive());
  EXPECT_NEAR(world[id].position().x, 50.009, 1e-6);
  EXPECT_LT(world[id].position().y, -0.5) << "it falls down behind";
}

// --------------------------------------------------------------------------------------------- along a surface
/// Surfaces that turn slip around do so in bounces; what stays on them rolls, as on any other.
TEST(SceneSurface, a_ball_rolls_on_what_turns_its_slip_around) {
  constexpr double kSlope = 0.1;
  for (const double dt : {kStep, 1.0 / 240}) {
    Scene scene;
    const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = 1, .grip_restitution = 0.5});
    add_thing(scene, PlaneShape{},
              {.transform = {.rotation = {std::cos(kSlope / 2), 0, 0, -std::sin(kSlope / 2)}}, .material = made_of});
    World world = world_with(scene);
    const Vec3d normal{std::sin(kSlope), std::cos(kSlope), 0};
    const ProjectileId id = *world.spawn(stone(), {.position = normal * 0.05000001}, body_that(OnHit::bounce, 0.05));
    const auto events = run_for(world, 2, dt);
    EXPECT_LT(events.size(), 10 * 2 / dt);
    EXPECT_NEAR(length(world[id].velocity()), kG * std::sin(kSlope) / 1.4 * world.time(), 0.01);
  }
  WorldDef windy{.ground = {.mode = GroundMode::none}};
  Scene floor;
  put(floor, PlaneShape{}, {}, {.restitution = 0.5, .friction = 1, .grip_restitution = 0.5});
  World world = world_with(floor, windy);
  ProjectileDef p = stone();
  p.fidelity.drag = DragModel::equation;
  const ProjectileId id = *world.spawn(p, launched({0, 0.0500001, 0}, {5, 0, 0}), body_that(OnHit::bounce, 0.05));
  const auto events = run_for(world, 3, kStep);
  EXPECT_LT(events.size(), 600u);
  EXPECT_EQ(world[id].status(), LifeStatus::in_flight);
  EXPECT_GT(world[id].velocity().x, 2);
}

TEST(SceneSurface, sensors_are_told_of_what_slides_and_rolls) {
  for (const double radius : {0.0, 0.05})
    for (const bool ground : {false, true}) {
      Scene scene;
      if (!ground) put(scene, PlaneShape{}, {}, {.restitution = 0, .friction = 0});
      add_thing(scene, BoxShape{{0.3, 1, 1}}, {.transform = {.position = {2, 0.5, 0}}, .sensor = true});
      WorldDef def = nothing_but_things();
      if (ground) def.ground.mode = GroundMode::bounce;
      World world = world_with(scene, def);
      BodyDef body = body_that(OnHit::bounce, radius);
      body.friction = 0;
      body.restitution = 0;
      const double height = ground ? 0 : radius + 1e-7;
      ASSERT_TRUE(world.spawn(stone(), launched({0, height, 0}, {10, 0, 0}), body));
      std::vector<Event> told;
      for (const Event& e : run_for(world, 0.5, kStep))
        if (e.kind == EventKind::sensed || e.kind == EventKind::left) told.push_back(e);
      ASSERT_EQ(told.size(), 2u) << radius << ground;
      EXPECT_EQ(told[0].kind, EventKind::sensed);
      EXPECT_EQ(told[1].kind, EventKind::left);
      EXPECT_NEAR(told[0].time, 0.17, 1e-6);
      EXPECT_NEAR(told[1].position.x, 2.3, 1e-6);
    }
}

TEST(SceneSurface, what_rolls_on_the_ground_of_the_world_meets_things) {
  for (const double restitution : {0.0, 0.5})
    for (const double radius : {0.0, 0.1})
      for (const double dt : {kStep, 0.25}) {
        Scene scene;
        put(scene, BoxShape{{0.05, 3, 5}}, {2, 0, 0}, {.restitution = 1});
        WorldDef def = nothing_but_things();
        def.ground.mode = GroundMode::bounce;
        World world = world_with(scene, def);
        BodyDef body = body_that(OnHit::bounce, radius);
        body.restitution = restitution;
        body.friction = 0;
        const ProjectileId id = *world.spawn(stone(), launched({0, 0, 0}, {10, 0, 0}), body);
        const auto events = run_for(world, 1, dt);
        ASSERT_GE(count(events, EventKind::hit), 1u) << radius;
        const Event hit = *std::ranges::find(events, EventKind::hit, &Event::kind);
        EXPECT_NEAR(hit.time, (1.95 - radius) / 10, 1e-6);
        EXPECT_NEAR(world[id].velocity().x, -10 * restitution, 1e-9);
        EXPECT_NEAR(world[id].position().x, 1.95 - radius - 10 * restitution * (world.time() - hit.time), 1e-5);
        EXPECT_NEAR(world[id].position().y, 0, 1e-6);
      }
}

/// A wall that leans towards where the ball may not go throws it back in its plane, and takes none of its energy.
TEST(SceneSurface, what_is_held_in_a_plane_stays_in_it) {
  const double half = 15 * test::kDegree;
  for (const OnHit on_hit : {OnHit::bounce, OnHit::impact})
    for (const double radius : {0.0, 0.1})
      for (const bool planar : {false, true}) {
        Scene scene;
        const MaterialId hard = *scene.add_material({.restitution = 1, .friction = 0});
        ASSERT_TRUE(
            scene.add({.shape = *scene.add_shape(BoxShape{{0.5, 50, 50}}),
                       .transform = {.position = {10, 0, 0}, .rotation = {std::cos(half), 0, std::sin(half), 0}},
                       .material = hard}));
        World world = world_with(scene);
        ProjectileDef p = stone();
        p.fidelity.planar = planar;
        BodyDef body = body_that(on_hit, radius);
        body.gravity_scale = 0;
        if (!planar) body.frozen = Axes::z;
        const ProjectileId id = *world.spawn(p, {.speed = 50}, body);
        const auto events = run_for(world, 1, kStep);
        EXPECT_EQ(count(events, EventKind::hit), 1u);
        EXPECT_LT(length(world[id].velocity() - Vec3d{-50, 0, 0}), 1e-9);
        EXPECT_NEAR(world[id].position().z, 0, 1e-12);
      }
}

/// Down the line in which triangles of one plane meet, of which the way from the nearest place is rounding alone.
TEST(SceneSurface, what_slides_along_an_edge_of_triangles_stays_on_them) {
  const double slope = 20 * test::kDegree, friction = 0.1, a = kG * (std::sin(slope) - friction * std::cos(slope));
  const Quatd turn{std::cos(slope / 2), 0, 0, std::sin(slope / 2)};
  HeightFieldShape field{.columns = 3, .rows = 3, .spacing_x = 60, .spacing_z = 60};
  field.heights.assign(9, 0);
  const MeshShape mesh{.vertices = {{0, 0, 0}, {120, 0, 0}, {120, 0, 60}, {0, 0, 60}, {120, 0, 120}, {0, 0, 120}},
                       .triangles = {{0, 2, 1}, {0, 3, 2}, {3, 4, 2}, {3, 5, 4}}};
  for (const ShapeDef& shape : {ShapeDef(field), ShapeDef(mesh)})
    for (const double radius : {0.0, 0.1})
      for (const double hz : {60.0, 1000.0}) {
        Scene scene;
        add_thing(scene, shape,
                  {.transform = {.position = rotate(turn, Vec3d{-60, 0, -60}), .rotation = turn},
                   .material = *scene.add_material({.restitution = 0, .friction = 1})});
        World world = world_with(scene);
        BodyDef body{.frozen_rotation = Axes::x | Axes::y | Axes::z,
                     .can_sleep = false,
                     .restitution = 0,
                     .friction = friction,
                     .rolling_resistance = 0,
                     .collision = {.on_hit = OnHit::bounce, .radius = radius}};
        ProjectileDef p = thrown();
        p.diameter = 0.2;
        const Vec3d along = rotate(turn, Vec3d{-1, 0, 0}), up = rotate(turn, Vec3d{0, 1, 0});
        const ProjectileId id = *world.spawn(p, {.position = up * (radius + 1e-9), .velocity = along}, body);
        std::size_t hits = 0;
        for (const Event& e : run_for(world, 2, 1 / hz)) hits += e.kind == EventKind::hit;
        EXPECT_LE(hits, 1u) << radius << " " << hz;
        EXPECT_NEAR(dot(world[id].position(), along), 2 + a * 2, 1e-4) << radius << " " << hz;
        EXPECT_NEAR(dot(world[id].velocity(), along), 1 + a * 2, 1e-4) << radius << " " << hz;
        EXPECT_NEAR(dot(world[id].velocity(), up), 0, 1e-9) << radius << " " << hz;
      }
}

/// Adaptive steps look for contacts by spheres as small as a path bends, which the next ones follow.
TEST(SceneSurface, points_that_slide_far_from_the_origin_stay_on_large_triangles) {
  test::Random r(5);
  MeshShape slope{.vertices = {{-3000, 900, -3000}, {-3000, 700, 3000}, {3000, 100, -3000}, {3000, -100, 3000}},
                  .triangles = {{0, 1, 2}, {2, 1, 3}}};
  Scene scene;
  put(scene, slope, {}, {.restitution = 0.5, .friction = 0.05});
  World world = world_with(scene, {.ground = {.mode = GroundMode::none}});  // through air
  ProjectileDef p = stone();
  p.fidelity = Fidelity::small_arms();
  BodyDef body{.restitution = 0.5, .collision = {.on_hit = OnHit::bounce}};
  std::vector<ProjectileId> points;
  const Vec3d normal = normalized(Vec3d{0.8 / 6, 1, 0.2 / 6});
  const auto height = [&](const Vec3d& x) { return dot(normal, x - slope.vertices[0]); };
  for (int i = 0; i < 100; ++i) {
    Vec3d at{r.in(-2500, 2500), 0, r.in(-2500, 2500)};
    at.y = -height(at) / normal.y + 0.01;
    points.push_back(*world.spawn(*world.add_kind(p, body), launched(at, {r.in(-1, 3), 0, r.in(-2, 2)})));
  }
  for (int step = 0; step < 400; ++step) ASSERT_TRUE(world.step(kStep));
  for (const ProjectileId id : points) EXPECT_GT(height(world[id].position()), -1e-9) << id.index;
}

}  // namespace physim::world_scene_surface_test
