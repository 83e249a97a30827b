// Worlds that users of other engines reported: bounces, seams and emitters at any frame rate, by closed forms.
#include "collide/scene_support.hpp"
#include "math/quat.hpp"
#include "scene_support.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_cases_world_test {

using namespace test_scene;

ProjectileDef by_rk4(double diameter = 0.2, Precision precision = Precision::float64) {
  return {.mass = 1, .diameter = diameter, .fidelity = rung(Integrator::rk4, precision)};
}
BodyDef stopping() { return {.collision = {.on_hit = OnHit::stop}}; }
World world_in(const Scene& scene, const WorldDef& def = space()) { return make_world(def, scene); }
MaterialId hard(Scene& scene) { return *scene.add_material({.restitution = 1, .friction = 1}); }

// ------------------------------------------------------------------------------------------------------------ bounces
/// dimforge/bevy_rapier #129: a ball of 400 m/s that a paddle throws back does not set off the line behind it.
/// Right: 9.85 - 400 (t - 9.85 / 400), in steps of 1/60 s and in one of 1 s.
TEST(CasesOfBounces, a_fast_ball_that_is_thrown_back_is_not_told_by_the_line_behind) {
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (const double step : {1.0 / 60, 1.0}) {
      Scene scene;
      add_thing(scene, BoxShape{{0.05, 1, 1}}, {.transform = {.position = {10, 0, 0}}, .material = hard(scene)});
      add_thing(scene, BoxShape{{0.05, 5, 5}}, {.transform = {.position = {10.5, 0, 0}}, .sensor = true});
      World world = world_in(scene, space(0));
      const ProjectileId id = *world.spawn(by_rk4(0.2, precision), {.velocity = Vec3d{400, 0, 0}}, bouncing(0.1, 1, 0));
      const auto events = run_for(world, step < 1 ? 0.05 : 1, step);
      EXPECT_EQ(of_kind(events, EventKind::hit).size(), 1u) << step;
      EXPECT_TRUE(of_kind(events, EventKind::sensed).empty()) << step;
      EXPECT_NEAR(world[id].position().x, 9.85 - 400 * (world.time() - 9.85 / 400),
                  precision == Precision::float64 ? 1e-9
                  : step < 1                      ? 1e-4
                                                  : 4e-4)
          << step;
    }
}

/// bulletphysics/bullet3 #1530, planck.js #223: a ball of restitution 1 from 10 m. Right: bounce n comes at
/// (2 n - 1) sqrt(2 * 9.5 m / g), each of a hundred, and no apex is above 10 m.
TEST(CasesOfBounces, a_hundred_bounces_keep_their_height) {
  for (const Integrator integrator : {Integrator::rk4, Integrator::semi_implicit_euler})
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      Scene scene;
      add_thing(scene, BoxShape{{5, 1, 5}}, {.transform = {.position = {0, -1, 0}}, .material = hard(scene)});
      WorldDef def = space();
      def.apex_events = true;
      World world = world_in(scene, def);
      ProjectileDef ball = by_rk4(1, precision);
      ball.fidelity.integrator = integrator;
      ASSERT_TRUE(world.spawn(ball, {.position = {0, 10, 0}}, bouncing(0.5, 1, 0)));
      const double half = std::sqrt(2 * 9.5 / kG);
      const auto events = run_for(world, 200 * half, 1.0 / 60);
      const auto bounces = of_kind(events, EventKind::bounced), apexes = of_kind(events, EventKind::apex);
      ASSERT_EQ(bounces.size(), 100u);
      ASSERT_GE(apexes.size(), 99u);
      const bool is_exact = integrator == Integrator::rk4 && precision == Precision::float64;
      for (std::size_t i = 0; is_exact && i < bounces.size(); ++i)
        EXPECT_NEAR(bounces[i].time, (2 * static_cast<double>(i) + 1) * half, 1e-6) << i;
      for (const Event& apex : apexes)  // energy within 1e-4 a hundred bounces; steps of order one see g h^2 / 8 less
        EXPECT_NEAR(apex.position.y, 10, is_exact ? 1e-6 : 9.5e-4 + kG / 3600) << name(integrator);
    }
}

/// Scirra/Construct-bugs #5617: a bounce off a slope of 45 degrees. Right: contact where 4.903325 t^2 + 20 t =
/// 22 - 0.25 sqrt 2, and the parabola behind it with 0.8 of the normal speed, at every frame rate.
TEST(CasesOfBounces, a_bounce_off_a_slope_is_the_same_at_every_frame_rate) {
  const double fall = kG / 2, met = (-20 + std::sqrt(400 + 4 * fall * (22 - 0.25 * std::sqrt(2.0)))) / (2 * fall);
  EXPECT_NEAR(met, 0.888695155, 1e-9);
  for (const double rate : {0.5, 30.0, 60.0, 90.0, 144.0}) {
    Scene scene;
    add_thing(
        scene, PlaneShape{},
        {.transform = {.position = {12, 0, 0}, .rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, 45 * test::kDegree)},
         .material = hard(scene)});
    World world = world_in(scene);
    const ProjectileId id =
        *world.spawn(by_rk4(0.5), {.position = {0, 10, 0}, .velocity = Vec3d{20, 0, 0}}, bouncing(0.25, 0.8, 0));
    const auto bounces = of_kind(run_for(world, 2, 1 / rate), EventKind::bounced);
    ASSERT_EQ(bounces.size(), 1u) << rate;
    EXPECT_NEAR(bounces[0].time, met, 1e-9) << rate;
    EXPECT_NEAR(world.time(), 2, 1e-12) << rate;
    EXPECT_NEAR(world[id].position().x, 11.279870880, 1e-8) << rate;
    EXPECT_NEAR(world[id].position().y, 19.106829120, 1e-8) << rate;
  }
}

/// liabru/matter-js #1158, dimforge/nphysics #204: down a slope of 10 degrees. Right: 5/7 of g sin 10 of a solid ball,
/// 3/5 of a hollow one, and all of it without friction.
TEST(CasesOfBounces, balls_roll_down_a_slope_by_their_inertia) {
  const double angle = 10 * test::kDegree;
  struct Case {
    double friction, inertia, part;
  };
  for (const auto& [friction, inertia, part] : {Case{0.5, 0.4, 5.0 / 7}, {0.5, 2.0 / 3, 0.6}, {0, 0.4, 1}}) {
    Scene scene;
    const Quatd turn = quat_from_axis_angle(Vec3d{0, 0, 1}, -angle);
    add_thing(scene, BoxShape{{20, 1, 5}},
              {.transform = {.position = rotate(turn, Vec3d{0, -1, 0}), .rotation = turn}, .material = hard(scene)});
    World world = world_in(scene);
    BodyDef body = bouncing(0.1, 0, friction);
    body.collision.inertia = inertia;
    const Vec3d start = rotate(turn, Vec3d{0, 0.1, 0});
    const ProjectileId id = *world.spawn(by_rk4(), {.position = start}, body);
    run_for(world, 2, 1.0 / 60);
    const double right = 2 * part * kG * std::sin(angle);  // m/s after 2 s, and as many metres
    EXPECT_NEAR(length(world[id].velocity()), right, 2e-3) << friction << ' ' << inertia;
    EXPECT_NEAR(length(world[id].position() - start), right, 2e-3) << friction << ' ' << inertia;
  }
}

// -------------------------------------------------------------------------------------------------------------- seams
/// dimforge/rapier #182, cannon.js #301: two height fields that join at x = 16 m. Right: points on the seam stop at
/// y = 0, balls lie at their radius there and a quarter of a cell from the edge, and beyond the edge a point falls.
TEST(CasesOfSeams, nothing_falls_between_height_fields) {
  Scene scene;
  HeightFieldShape flat{.columns = 17, .rows = 17, .spacing_x = 1, .spacing_z = 1};
  flat.heights.assign(17 * 17, 0);
  const ShapeId chunk = *scene.add_shape(flat);
  for (const double x : {0.0, 16.0}) ASSERT_TRUE(scene.add({.shape = chunk, .transform = {.position = {x, 0, 0}}}));
  test::Random random(3);
  for (int i = 0; i < 10'000; ++i) {
    const double z = i < 17 ? i : random.in(0, 16);
    const SceneHit hit = scene.first_hit({{16, 5, z}, {16, -5, z}});
    ASSERT_TRUE(hit) << z;
    EXPECT_EQ(hit.position.y, 0) << z;
  }
  EXPECT_FALSE(scene.first_hit({{32.000001, 5, 8}, {32.000001, -5, 8}}));
  World world = world_in(scene);
  std::vector<ProjectileId> points, balls, edges;
  for (int i = 0; i < 50; ++i) {
    const double z = 0.5 + 15.0 * i / 49;
    points.push_back(*world.spawn(by_rk4(), {.position = {16, 5, z}}, stopping()));
    balls.push_back(*world.spawn(by_rk4(), {.position = {16, 5, z}}, bouncing(0.1, 0, 0.5)));
    edges.push_back(*world.spawn(by_rk4(), {.position = {31.75, 5, z}}, bouncing(0.4, 0, 0.5)));
  }
  std::size_t stops = 0;
  for (const Event& e : of_kind(run_for(world, 4, 1.0 / 60), EventKind::hit)) {
    if (std::ranges::find(points, e.id) == points.end()) continue;
    ++stops;
    EXPECT_NEAR(e.position.y, 0, 1e-9);
  }
  EXPECT_EQ(stops, 50u);
  for (const ProjectileId id : balls) EXPECT_NEAR(world[id].position().y, 0.1, 1e-6);
  for (const ProjectileId id : edges) EXPECT_NEAR(world[id].position().y, 0.4, 1e-6);
}

/// TokisanGames/Terrain3D #1007, gazebo-classic #2838: heights of +-1 m like a chess board, whose two diagonals differ
/// by 2 m in the middle of each cell. Right: the one diagonal everywhere, never a height of 0, whoever asks.
TEST(CasesOfSeams, every_question_about_a_chess_board_of_heights_knows_one_diagonal) {
  Scene scene;
  HeightFieldShape board{.columns = 5, .rows = 5, .spacing_x = 4, .spacing_z = 4};
  for (int i = 0; i < 25; ++i) board.heights.push_back(i % 2 == 0 ? 1 : -1);
  add_thing(scene, board);
  World world = world_in(scene);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const double x = 4 * column + 2, z = 4 * row + 2, y = (row + column) % 2 == 0 ? -1 : 1;
      EXPECT_NEAR(scene.first_hit({{x, 10, z}, {x, -10, z}}).position.y, y, 1e-12) << row << column;
      EXPECT_NEAR(scene.first_hit({{x, -10, z}, {x, 10, z}}).position.y, y, 1e-12) << "from below";
      EXPECT_NEAR(scene.nearest({x, y, z}).distance, 0, 1e-12) << row << column;
      ASSERT_TRUE(world.spawn(by_rk4(0.01), {.position = {x, 10, z}}, stopping()));
    }
  const auto stops = of_kind(run_for(world, 2, 1.0 / 60), EventKind::hit);
  ASSERT_EQ(stops.size(), 16u);
  for (const Event& e : stops) {
    const long cell = std::lround((e.position.x - 2) / 4) + std::lround((e.position.z - 2) / 4);
    EXPECT_NEAR(e.position.y, cell % 2 == 0 ? -1 : 1, 1e-9);
  }
}

/// mrdoob/three.js #11449, dimforge/parry #444: a ray onto the very diagonal of a square of two triangles. Right: one
/// hit at x = y = 3.375, and 10 000 rays from random places onto the diagonal hit once each.
TEST(CasesOfSeams, rays_onto_the_diagonal_of_a_square_hit_it_once) {
  Scene scene;
  add_thing(scene, MeshShape{{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}});
  const Vec3d way{0.30458447, 0.30458447, -0.9024725};
  const SceneHit hit = scene.first_hit({{0, 0, 10}, Vec3d{0, 0, 10} + way * 20});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit.position.x, 10 * 0.30458447 / 0.9024725, 1e-12);
  EXPECT_NEAR(hit.position.x, 3.375, 2e-7);
  test::Random random(7);
  for (int i = 0; i < 10'000; ++i) {
    const double s = random.in(-4.9, 4.9);
    const Vec3d from{random.in(-20, 20), random.in(-20, 20), random.in(1, 20)}, to = from + (Vec3d{s, s, 0} - from) * 2;
    ASSERT_EQ(scene.all_hits({from, to, 0, 0, 0}).size(), 1u) << s;
  }
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    World world = world_in(scene, space(0));
    ASSERT_TRUE(world.spawn(by_rk4(1e-3, precision), {.position = {0, 0, 10}, .velocity = way * 1000}, stopping()));
    EXPECT_EQ(of_kind(run_for(world, 0.1, 1.0 / 60), EventKind::hit).size(), 1u);
  }
}

// ----------------------------------------------------------------------------------------------------------- emitters
/// djeedai/bevy_hanabi #65, galacean/engine PR 3011: smoke of a rocket at 60 m/s, 120 puffs a second that rise at 1
/// m/s. Right: after 1 s puff k of 120 is at x = 0.5 (k + 1) m and y = 1 - x / 60, whatever the step.
TEST(CasesOfEmitters, puffs_behind_a_fast_emitter_are_as_old_as_their_places_say) {
  for (const bool by_metre : {false, true})
    for (const double step : {1.0 / 60, 0.1, 1.0}) {
      World world = make_world(space(0));
      ProjectileDef puff = by_rk4(0.01);
      EmitterDef def{.kind = *world.add_kind(puff)};
      def.rotation = {0.7071067811865476, 0, 0, 0.7071067811865476};  // forwards is up
      def.motion = SteadyMotion{.velocity = {60, 0, 0}};
      def.per_second = {by_metre ? 0.0 : 120.0};
      def.per_metre = by_metre ? 2 : 0;
      def.from = {.shape = EmitShape::point};
      def.start.speed = {1};
      def.start.lifetime = {10};
      added(world, def);
      const auto born = of_kind(run_for(world, 1, step), EventKind::spawned);
      ASSERT_EQ(born.size(), 120u) << by_metre << ' ' << step;
      for (std::size_t k = 0; k < born.size(); ++k) {
        const double x = 0.5 * (static_cast<double>(k) + 1);
        EXPECT_NEAR(born[k].time, x / 60, 1e-12) << by_metre << ' ' << step;
        EXPECT_NEAR(world[born[k].id].position().x, x, 1e-9) << by_metre << ' ' << step;
        EXPECT_NEAR(world[born[k].id].position().y, 1 - x / 60, 1e-9) << by_metre << ' ' << step;
      }
    }
}

/// Low-Drag-MC/Photon #57, friking-shark #6: an emitter that lives 10 ms between two frames. Right: 10 by its rate of
/// 1000 a second and 7 at each of two moments of its burst, at steps of 1/60 s and of 1 s.
TEST(CasesOfEmitters, what_begins_and_ends_between_two_frames_fires_all) {
  for (const double step : {1.0 / 60, 1.0}) {
    World world = make_world(space(0));
    EmitterDef def{.kind = *world.add_kind(by_rk4(1e-3)),
                   .cycle = {.duration = 0.01, .looping = false, .delay = {0.003}},
                   .per_second = {1000},
                   .bursts = {{.time = 0.005, .count = {7}, .cycles = 2, .interval = 0.002}},
                   .start = {.lifetime = {10}}};
    added(world, def);
    const auto born = of_kind(run_for(world, 1, step), EventKind::spawned);
    ASSERT_EQ(born.size(), 24u) << step;
    std::vector<double> right(7, 0.008);
    right.insert(right.end(), 7, 0.010);
    for (int k = 1; k <= 10; ++k) right.push_back(0.003 + 0.001 * k);
    std::ranges::sort(right);
    for (std::size_t i = 0; i < born.size(); ++i) EXPECT_NEAR(born[i].time, right[i], 1e-12) << step << ' ' << i;
  }
}

}  // namespace physim::world_cases_world_test
