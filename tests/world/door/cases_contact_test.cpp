// Contacts that users of other engines complained of, by closed forms at several frame rates.
#include "math/quat.hpp"
#include "scene_support.hpp"
#include "world/joints_support.hpp"

namespace physim::world_cases_contact_test {

using namespace test_scene;
using test_joints::falling;
using test_joints::join;
using test_pairs::put;

constexpr Axes kAllAxes = Axes::x | Axes::y | Axes::z;
constexpr Vec3d kAboutZ{0, 0, 1};

ProjectileDef by_rk4(double radius, double mass = 1, Precision precision = Precision::float64) {
  return {.mass = mass, .diameter = 2 * radius, .fidelity = rung(Integrator::rk4, precision)};
}
/// A ball that falls, does not sleep and meets others.
BodyDef body_of(double radius, double restitution, double friction) {
  BodyDef body = test_pairs::ball(radius, restitution, friction);
  body.gravity_scale = 1;
  body.rolling_resistance = 0;
  return body;
}
MaterialId material(Scene& scene, double restitution, double friction) {
  return *scene.add_material({.restitution = restitution, .friction = friction});
}
void add(Scene& scene, const ShapeDef& shape, const Vec3d& at, MaterialId made_of, const Quatd& turn = {1, 0, 0, 0},
         const SceneMotion& motion = {}) {
  add_thing(scene, shape, {.transform = {.position = at, .rotation = turn}, .material = made_of, .motion = motion});
}
World world_in(const Scene& scene) { return make_world(falling(), scene); }
std::string at(double rate, const char* what = "") { return what + (" at " + std::to_string(rate)) + " Hz"; }

// ------------------------------------------------------------------------------------------------- sliding and rolling
enum class Floor { tiles, turned_tiles, mesh, box };
Scene floor_of(Floor kind, double height) {
  Scene scene;
  const MaterialId wood = material(scene, 1, 1);
  if (kind == Floor::box) {
    add(scene, BoxShape{{20, 1, 1}}, {0, height - 1, 0}, wood);
  } else if (kind == Floor::mesh) {
    MeshShape mesh;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 33; ++i) mesh.vertices.push_back({0.5 * i - 6, height, 0.5 * j - 0.5});
    for (std::uint32_t k = 0; k < 2 * 33; ++k)
      if (k % 33 != 32) mesh.triangles.insert(mesh.triangles.end(), {{k, k + 33, k + 34}, {k, k + 34, k + 1}});
    add(scene, mesh, {}, wood);
  } else {
    const Quatd turn = quat_from_axis_angle(Vec3d{0, 1, 0}, kind == Floor::turned_tiles ? test::kDegree * 30 : 0);
    const ShapeId tile = *scene.add_shape(BoxShape{{0.25, 0.25, 0.25}});
    for (int i = -12; i < 20; ++i)
      for (int j = -12; j < 12; ++j) {
        const Vec3d place = rotate(turn, Vec3d{0.5 * i + 0.25, height - 0.25, 0.5 * j});
        EXPECT_TRUE(scene.add({.shape = tile, .transform = {.position = place, .rotation = turn}, .material = wood}));
      }
  }
  return scene;
}

/// JoltPhysics #717, rapier #95, reactphysics3d #266: balls jump or are braked where tiles or triangles join. Right: a
/// ball of 2 m/s slides, then rolls at 5/7 of that, 4.341209 m in 3 s, and meets each tile at most once.
TEST(CasesOfContacts, seams_of_a_flat_floor_are_not_felt) {
  const double r = 0.02, height = 1.3, v = 2, a = 0.3 * kG, slides = 2 * v / 7 / a;
  const double right = v * slides - a * slides * slides / 2 + 5.0 / 7 * v * (3 - slides);
  EXPECT_NEAR(right, 4.341209, 1e-6);
  for (const Floor kind : {Floor::tiles, Floor::turned_tiles, Floor::mesh, Floor::box})
    for (const Precision precision : {Precision::float64, Precision::float32})
      for (const double rate : {60.0, 1000.0}) {
        World world = world_in(floor_of(kind, height));
        BodyDef body = body_of(r, 0.5, 0.3);
        const ProjectileId id = put(world, by_rk4(r, 1, precision), body, {0, height + r, 0}, {v, 0, 0});
        const auto hits = of_kind(run_for(world, 3, 1 / rate), EventKind::hit);
        const Vec3d p = world[id].position();
        const double within = precision == Precision::float32 ? 1e-3 : 1e-6;
        EXPECT_NEAR(p.x, right, within) << int(kind) << at(rate);
        EXPECT_NEAR(p.y, height + r, within) << int(kind) << at(rate);
        EXPECT_NEAR(p.z, 0, within) << int(kind) << at(rate);
        EXPECT_LE(hits.size(), kind < Floor::mesh ? 20u : 1u) << int(kind) << at(rate);
      }
}

/// cannon.js #327: a ball on a belt that moves at u. Right: friction takes it along at mu g until it rolls at
/// k / (1 + k) u: 2/7 of a solid ball, 2/5 of a hollow one, u of what cannot turn.
TEST(CasesOfContacts, a_belt_takes_balls_along_until_they_roll) {
  struct Case {
    double part, inertia;
    Axes frozen;
  };
  const double u = 2, a = 0.2 * kG;
  for (const auto& [part, inertia, frozen] :
       {Case{2.0 / 7, 0.4, Axes::none}, {0.4, 2.0 / 3, Axes::none}, {1, 0.4, kAllAxes}})
    for (const double rate : {60.0, 1000.0}) {
      Scene scene;
      add(scene, BoxShape{{20, 0.1, 1}}, {0, -0.1, 0}, material(scene, 0, 1), {1, 0, 0, 0},
          SteadyMotion{.velocity = {u, 0, 0}});
      World world = world_in(scene);
      BodyDef body = body_of(0.1, 0, 0.2);
      body.collision.inertia = inertia;
      body.frozen_rotation = frozen;
      const ProjectileId id = put(world, by_rk4(0.1), body, {0, 0.1, 0});
      run_for(world, 2, 1 / rate);
      const double time = part * u / a;
      EXPECT_NEAR(world[id].velocity().x, part * u, 1e-3) << part << at(rate);
      EXPECT_NEAR(world[id].position().x, a * time * time / 2 + part * u * (2 - time), 2e-3) << part << at(rate);
    }
}

/// planck.js #229, Teardown #563: on a slope of 60 degrees a ball slips, since 0.2 is less than 2/7 tan 60. Right: it
/// goes down at g (sin - mu cos) and turns at 5/2 mu g cos / r: 24.5166 rad/s after 1 s.
TEST(CasesOfContacts, a_ball_on_a_steep_slope_slips_and_turns_by_friction) {
  const double angle = 60 * test::kDegree, c = std::cos(angle), d = std::sin(angle), r = 0.1, mu = 0.2;
  EXPECT_NEAR(2.5 * mu * kG * c / r, 24.5166, 1e-4);
  for (const double rate : {60.0, 1000.0}) {
    Scene scene;
    add(scene, BoxShape{{60, 0.5, 5}}, {0.5 * d, -0.5 * c, 0}, material(scene, 0, 1),
        quat_from_axis_angle(kAboutZ, angle));
    World world = world_in(scene);
    const ProjectileId id = put(world, by_rk4(r), body_of(r, 0, mu), {-r * d, r * c, 0});
    run_for(world, 1, 1 / rate);
    const double speed = kG * (d - mu * c);
    EXPECT_NEAR(length(world[id].velocity()), speed, 1e-3) << rate;
    EXPECT_NEAR(length(world[id].position() - Vec3d{-r * d, r * c, 0}), speed / 2, 2e-3) << rate;
    EXPECT_NEAR(world[id].angular_velocity().z, 2.5 * mu * kG * c / r, 0.01) << rate;
  }
}

/// pooltool #39, matter-js #361: a cue ball that rolls at v strikes another one that does not sleep. Right: it follows
/// at 2/7 v, the other one rolls at 5/7 v; after 2.5 s they are at 2.779695 and 4.383460 m.
TEST(CasesOfContacts, a_cue_ball_follows_at_two_sevenths) {
  for (const double rate : {60.0, 240.0, 1000.0}) {
    const double r = 0.028575;
    Scene scene;
    add(scene, BoxShape{{9, 1, 1}}, {0, -1, 0}, material(scene, 0, 2000));  // with 1e-4 of the balls friction is 0.2
    World world = world_in(scene);
    const BodyDef body = body_of(r, 1, 1e-4);
    const ProjectileId cue = put(world, by_rk4(r, 0.17), body, {0, r, 0}, {2.8, 0, 0});
    const ProjectileId other = put(world, by_rk4(r, 0.17), body, {2, r, 0});
    run_for(world, 2.5, 1 / rate);
    EXPECT_NEAR(world[cue].velocity().x, 4.0 / 7, 1e-3) << rate;
    EXPECT_NEAR(world[other].velocity().x, 10.0 / 7, 1e-3) << rate;
    EXPECT_NEAR(world[cue].position().x, 2.779695, 2e-3) << rate;
    EXPECT_NEAR(world[other].position().x, 4.383460, 2e-3) << rate;
  }
}

/// box2d #117: a wall pushes a ball against rolling resistance, too. Right: it lies at the wall and goes as fast.
TEST(CasesOfContacts, a_wall_pushes_a_ball_against_rolling_resistance) {
  for (const double rate : {60.0, 240.0, 1000.0}) {
    const double r = 0.1;
    Scene scene;
    const MaterialId soft = material(scene, 0, 1);
    add(scene, BoxShape{{20, 1, 2}}, {0, -1, 0}, soft);
    add(scene, BoxShape{{0.1, 0.5, 1}}, {-0.5, 0, 0}, soft, {1, 0, 0, 0}, SteadyMotion{.velocity = {1, 0, 0}});
    World world = world_in(scene);
    BodyDef body = body_of(r, 0, 0);
    body.rolling_resistance = 0.02;
    const ProjectileId id = put(world, by_rk4(r), body, {0, r, 0});
    run_for(world, 2, 1 / rate);
    EXPECT_NEAR(world[id].position().x, -0.4 + 2 + r, 1e-6) << rate;
    EXPECT_NEAR(world[id].velocity().x, 1, 0.01) << rate;
  }
}

/// A ball rolls to rest at any frame rate and height, in float32 as well. Right: 0.100 m sliding, then
/// (10/7)^2 / (2 * 5/7 * 0.05 g) = 2.914 m.
TEST(CasesOfContacts, a_ball_rolls_to_rest_as_far_in_single_precision) {
  for (const double height : {0.0, 100.0, 1000.0})
    for (const double rate : {30.0, 144.0, 1000.0}) {
      Scene scene;
      add(scene, BoxShape{{100, 1, 100}}, {0, height - 1, 0}, material(scene, 0, 1));
      World world = world_in(scene);
      ProjectileDef ball{.mass = 1, .diameter = 0.2, .fidelity = Fidelity::game()};
      ball.fidelity.drag = DragModel::off;
      BodyDef body = body_of(0.1, 0, 1);
      body.rolling_resistance = 0.05;
      const ProjectileId id = put(world, ball, body, {0, height + 0.1, 0}, {2, 0, 0});
      run_for(world, 6, 1 / rate);
      const double right = (4 - 100.0 / 49) / (2 * kG) + 100.0 / 49 / (2 * 5.0 / 7 * 0.05 * kG);
      EXPECT_NEAR(world[id].position().x, right, 0.01 * right) << height << at(rate);
      EXPECT_NEAR(length(world[id].velocity()), 0, 1e-3) << height << at(rate);
    }
}

// ------------------------------------------------------------------------------------------------------------- bounces
/// godot-proposals #2332: a lift of smooth keys, 1 m in 0.5 s, brakes so hard that what lies on it is let go at
/// 0.35107 s. Right: it is 1.15784 m high at most and down on the lift at 0.75529 s, where it stays.
TEST(CasesOfContacts, what_a_lift_throws_comes_down_on_it) {
  for (const double rate : {30.0, 60.0, 1000.0})
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      Scene scene;
      const KeyedMotion up{.keys = {{.time = 0, .position = {0, -0.1, 0}}, {.time = 0.5, .position = {0, 0.9, 0}}},
                           .curve = MotionCurve::smooth};
      add(scene, BoxShape{{1, 0.1, 1}}, {}, material(scene, 0, 1), {1, 0, 0, 0}, up);
      World world = world_in(scene);
      const ProjectileId id = put(world, by_rk4(0.05, 1, precision), body_of(0.05, 0, 0.5), {0, 0.05, 0});
      double top = 0, down = 0;
      std::size_t hits = 0;
      for (int i = 0; i < 1.2 * rate; ++i) {
        ASSERT_TRUE(world.step(1 / rate));
        for (const Event& e : events_of(world, EventKind::hit)) ++hits, down = e.time;
        top = std::max(top, world[id].position().y);
      }
      EXPECT_NEAR(top, 1.15784, 0.003) << rate;
      EXPECT_NEAR(down, 0.75529, 1e-3) << rate;
      EXPECT_LE(hits, 2u) << rate;
      EXPECT_NEAR(world[id].position().y, 1.05, 1e-5) << rate;
    }
}

/// poolvr.py PR 4, InfiniTime #1084: an elastic ball that goes into a corner along its bisector, or onto an outer edge
/// at 45 degrees. Right: straight back as fast as it came.
TEST(CasesOfContacts, a_smooth_corner_throws_straight_back) {
  enum { two_boxes, mesh, three_boxes, outer_edge };
  for (const int kind : {two_boxes, mesh, three_boxes, outer_edge})
    for (const double rate : {60.0, 1000.0}) {
      const double r = 0.1, v = 3;
      Scene scene;
      const MaterialId smooth = material(scene, 1, 0);
      if (kind == mesh) {
        add(scene,
            MeshShape{{{0, -2, -4}, {0, 2, -4}, {0, 2, 0}, {0, -2, 0}, {-4, -2, 0}, {-4, 2, 0}},
                      {{0, 1, 2}, {0, 2, 3}, {3, 2, 5}, {3, 5, 4}},
                      {}},
            {}, smooth);
      } else if (kind == outer_edge) {
        add(scene, BoxShape{{2, 2, 2}}, {2, 0, 2}, smooth);
      } else {
        add(scene, BoxShape{{2, 2, 2}}, {2, 0, 0}, smooth);
        add(scene, BoxShape{{2, 2, 2}}, {0, 0, 2}, smooth);
        if (kind == three_boxes) add(scene, BoxShape{{2, 2, 2}}, {0, 2, 0}, smooth);
      }
      World world = world_in(scene);
      BodyDef body = body_of(r, 1, 0);
      body.gravity_scale = 0;
      const double up = kind == three_boxes ? 1 : 0, d = kind == outer_edge ? r / std::sqrt(2.0) : r;
      const Vec3d go = Vec3d{1, up, 1} * v, touch = Vec3d{1, up, 1} * -d;
      const ProjectileId id = put(world, by_rk4(r), body, touch - go * 0.25, go);
      run_for(world, 0.5, 1 / rate);
      EXPECT_LT(length(world[id].velocity() + go), 1e-9) << kind << at(rate);
      EXPECT_LT(length(world[id].position() - (touch - go * (world.time() - 0.25))), 1e-6) << kind << at(rate);
    }
}

/// ball2box #10, react-three-rapier #322, avian #990: an elastic ball falls where six triangles, four boxes or two
/// height fields meet, or 1 mm inside of the edge of a box. Right: it comes straight up, 8 times in 5 s, and what falls
/// half a millimetre beside a wall knows nothing of it.
TEST(CasesOfContacts, where_triangles_and_tiles_meet_a_ball_bounces_as_off_a_plane) {
  const double r = 0.0135, h = 0.5, period = 2 * std::sqrt(2 * h / kG);
  const double since = std::fmod(5 + period / 2, period) - period / 2, right = r + h - kG / 2 * since * since;
  EXPECT_NEAR(right, 0.4549447, 1e-7);
  for (const int kind : {0, 1, 2, 3})
    for (const double friction : {0.0, 0.5})
      for (const double rate : {60.0, 240.0}) {
        Scene scene;
        const MaterialId hard = material(scene, 1, 1);
        if (kind == 0) {
          add(scene,
              MeshShape{
                  {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0.9}, {-0.5, 0, 0.9}, {-1, 0, 0}, {-0.5, 0, -0.9}, {0.5, 0, -0.9}},
                  {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 5, 4}, {0, 6, 5}, {0, 1, 6}},
                  {}},
              {}, hard);
        } else if (kind == 1) {
          for (const double x : {-0.5, 0.5})
            for (const double z : {-0.5, 0.5}) add(scene, BoxShape{{0.5, 0.5, 0.5}}, {x, -0.5, z}, hard);
        } else if (kind == 2) {
          for (const double x : {-1.0, 0.0})
            add(scene, HeightFieldShape{.columns = 2, .rows = 2, .heights = {0, 0, 0, 0}}, {x, 0, -0.5}, hard);
        } else {
          add(scene, BoxShape{{0.5, 0.5, 0.5}}, {-0.499, -0.5, 0}, hard);
        }
        World world = world_in(scene);
        BodyDef body = body_of(r, 1, friction);
        body.collision.others = 0;
        const ProjectileId id = put(world, by_rk4(r), body, {0, r + h, 0});
        const ProjectileId past = put(world, by_rk4(r), body, {1 + r + 0.0005, 1, 0});
        std::size_t bounces = 0;
        for (const Event& e : of_kind(run_for(world, 5, 1 / rate), EventKind::hit)) {
          EXPECT_EQ(e.id, id) << kind << at(rate);
          ++bounces;
        }
        EXPECT_EQ(bounces, 8u) << kind << at(rate);
        const Vec3d p = world[id].position();
        EXPECT_NEAR(std::hypot(p.x, p.z), 0, 1e-9) << kind << at(rate);
        EXPECT_NEAR(p.y, right, 1e-6) << kind << at(rate);
        EXPECT_EQ(world[past].velocity().x, 0) << kind << at(rate);
      }
}

/// godot-jolt #374: there is no least speed of bouncing, of balls of 27 and 1 mm. Right: bounce n has e^n of the first
/// speed, as long as its flight is longer than a step, and comes at sqrt(2h/g) (1 + 2 (e - e^n) / (1 - e)).
TEST(CasesOfContacts, the_last_bounces_are_as_the_first) {
  for (const double r : {0.0135, 0.0005})
    for (const double floor : {0.0, 100.3})
      for (const double rate : {60.0, 1000.0}) {
        const double e = 0.8, down = std::sqrt(2 * 20 * r / kG), still = down * (1 + e) / (1 - e);
        Scene scene;
        add(scene, BoxShape{{1, 1, 1}}, {0, floor - 1, 0}, material(scene, 1, 1));
        World world = world_in(scene);
        const ProjectileId id = put(world, by_rk4(r), body_of(r, e, 0.5), {0, floor + 21 * r, 0});
        int n = 0, told = 0;
        for (const Event& bounce : of_kind(run_for(world, 2 * still, 1 / rate), EventKind::bounced)) {
          const double part = std::pow(e, ++n);
          if (part * 2 * down * rate <= 1) continue;
          EXPECT_NEAR(bounce.velocity.y / (part * kG * down), 1, 1e-4) << r << at(rate);
          EXPECT_NEAR(bounce.time / (down * (1 + 2 * (e - part) / (1 - e))), 1, 1e-5) << r << at(rate);
          ++told;
        }
        EXPECT_GE(told, 7) << r << at(rate);
        EXPECT_NEAR(world[id].position().y, floor + r, 1e-8) << r << at(rate);
        EXPECT_LT(length(world[id].velocity()), 1e-3) << r << at(rate);
      }
}

/// planck.js #217, box2d #501: an elastic ball goes along a channel, slowly across, and keeps both of its speeds.
TEST(CasesOfContacts, the_slowest_approach_is_thrown_back) {
  for (const double across : {0.5, 1e-2, 1e-4, 1e-6})
    for (const double rate : {60.0, 240.0}) {
      const double r = 0.05, width = 10 * across;  // a bounce every 10 s
      Scene scene;
      const MaterialId hard = material(scene, 1, 1);
      for (const double side : {-1.0, 1.0}) add(scene, BoxShape{{100, 1, 1}}, {0, 0, side * (width / 2 + r + 1)}, hard);
      World world = world_in(scene);
      BodyDef body = body_of(r, 1, 0);
      body.gravity_scale = 0;
      const ProjectileId id = put(world, by_rk4(r), body, {-20, 0, 0}, {1, 0, across});
      EXPECT_EQ(of_kind(run_for(world, 32, 1 / rate), EventKind::hit).size(), 3u) << across << at(rate);
      EXPECT_NEAR(world[id].velocity().z, -across, 1e-12) << across << at(rate);
      EXPECT_NEAR(world[id].velocity().x, 1, 1e-6) << across << at(rate);
    }
}

/// avian #200, VRCBilliards #8: dropped with spin about z a ball comes up as high and goes off at 2/7 r W; spin about
/// the vertical does nothing to a bounce nor to rolling, and stays.
TEST(CasesOfContacts, spin_moves_a_bounce_aside_and_stays_about_the_vertical) {
  const double r = 0.1, turn = 30;
  for (const RotationModel model : {RotationModel::none, RotationModel::magnus})
    for (const int kind : {0, 1, 2}) {
      const bool rolls = kind == 2;
      Scene scene;
      add(scene, PlaneShape{}, {}, material(scene, 1, 100));
      World world = world_in(scene);
      ProjectileDef ball = by_rk4(r);
      ball.fidelity.rotation = model;
      const ProjectileId id = put(world, ball, body_of(r, rolls ? 0 : 1, rolls ? 0.5 : 1), {0, rolls ? r : r + 0.5, 0},
                                  {rolls ? 2.0 : 0.0, 0, 0});
      ASSERT_TRUE(world[id].set_angular_velocity(kind == 0 ? Vec3d{0, 0, turn} : Vec3d{0, turn, 0}));
      double top = 0;
      for (int i = 0; i < 38; ++i) {
        ASSERT_TRUE(world.step(1.0 / 60));
        if (world.time() > 0.4) top = std::max(top, world[id].position().y);
      }
      const Vec3d goes[] = {{-2.0 / 7 * r * turn, 0, 0}, {0, 0, 0}, {10.0 / 7, 0, 0}};
      const Vec3d turns[] = {{0, 0, 2.0 / 7 * turn}, {0, turn, 0}, {0, turn, -10.0 / 7 / r}};
      const Vec3d v = world[id].velocity();
      EXPECT_LT(length(Vec3d{v.x, 0, v.z} - goes[kind]), 1e-2) << kind;
      EXPECT_LT(length(world[id].angular_velocity() - turns[kind]), 0.1) << kind;
      if (!rolls) {
        EXPECT_NEAR(top, r + 0.5, 1e-3) << kind;
      }
    }
}

/// pico8-pinball #6: a paddle that turns at W strikes a ball at rest. Right: twice W s along its normal, s from the
/// pivot, and 2/7 of W h along it; a bat half way on a smooth way of 1 m in 0.5 s gives twice 3 m/s.
TEST(CasesOfContacts, a_paddle_and_a_bat_give_twice_their_speed) {
  for (const double rate : {2.0, 10.0, 60.0, 1000.0}) {
    const double turn = 10, h = 0.05, r = 0.05, far = 0.8, along = std::sqrt(far * far - (h + r) * (h + r));
    Scene scene;
    const MaterialId hard = material(scene, 1, 1);
    add(scene, BoxShape{{1, 0.5, h}}, {}, hard, {std::cos(0.5), 0, std::sin(0.5), 0},
        SteadyMotion{.angular_velocity = {0, -turn, 0}});
    add(scene, BoxShape{{h, 0.5, 0.5}}, {}, hard, {1, 0, 0, 0},
        KeyedMotion{.keys = {{.time = 0, .position = {10, 0, 0}}, {.time = 0.5, .position = {11, 0, 0}}},
                    .curve = MotionCurve::smooth});
    World world = world_in(scene);
    BodyDef body = body_of(r, 1, 1);
    body.gravity_scale = 0;
    const ProjectileId struck = put(world, by_rk4(r), body, {far, 0, 0});
    const ProjectileId batted = put(world, by_rk4(r), body, {10.5 + h + r, 0, 0});
    run_for(world, 0.5, 1 / rate);
    // The paddle comes towards +z; where it strikes its normal is +z, turned by this angle.
    const double angle = std::asin((h + r) / far);
    const Vec3d v = world[struck].velocity();
    EXPECT_NEAR(v.x * std::sin(angle) + v.z * std::cos(angle), 2 * turn * along, 1e-4) << rate;
    EXPECT_NEAR(std::abs(v.x * std::cos(angle) - v.z * std::sin(angle)), 2.0 / 7 * turn * h, 1e-4) << rate;
    EXPECT_NEAR(world[batted].velocity().x, 6, 1e-6) << rate;
  }
}

/// box2d #867, sbox #4419: an elastic ball falls through a sensor and comes back, for 4 s. Right: nine ways in and nine
/// out at the moments of the closed form, in steps of 1 ms to 4 s.
TEST(CasesOfContacts, sensors_tell_each_way_in_and_out_whatever_the_step) {
  const double r = 0.05, h = 1, down = std::sqrt(2 * h / kG);
  for (const double rate : {0.25, 1.0, 30.0, 60.0, 1000.0}) {
    Scene scene;
    add(scene, PlaneShape{}, {}, material(scene, 1, 1));
    const InstanceId gate =
        add_thing(scene, BoxShape{{1, 0.05, 1}}, {.transform = {.position = {0, 0.4, 0}}, .sensor = true});
    World world = world_in(scene);
    put(world, by_rk4(r), body_of(r, 1, 0), {0, r + h, 0});
    // The k-th time that its middle is y above its lowest place.
    const auto when = [&](double y, std::size_t k) {
      const double t = std::sqrt(2 * (h - y) / kG);
      return k % 2 == 0 ? static_cast<double>(k) * down + t : static_cast<double>(k + 1) * down - t;
    };
    std::size_t in = 0, out = 0;
    for (const Event& e : run_for(world, 4, 1 / rate)) {
      if (e.instance != gate) continue;
      const bool enters = e.kind == EventKind::sensed;
      std::size_t& passages = enters ? in : out;
      EXPECT_NEAR(e.time, when((passages % 2 == 0) == enters ? 0.4 : 0.3, passages), 1e-4) << rate;
      ++passages;
    }
    EXPECT_EQ(in, 9u) << rate;
    EXPECT_EQ(out, 9u) << rate;
  }
}

// -------------------------------------------------------------------------------------------------------------- joints
/// edyn PR 49, matter-js #216: a cradle of five elastic balls on rods of 1 m. Right: as many as are let go swing out on
/// the other side, as far, and the others hang still, for ten half periods.
TEST(CasesOfContacts, a_hanging_cradle_passes_on_as_many_as_came) {
  for (const int many : {1, 2, 3})
    for (const double rate : {60.0, 240.0}) {
      const double r = 0.03, swing = 0.2, period = test_joints::pendulum_period(1, swing);
      World world = make_world(falling());
      std::vector<ProjectileId> row;
      for (int i = 0; i < 5; ++i) {
        const double angle = i < many ? swing : 0;
        const Vec3d from{2 * r * i, 0, 0};
        row.push_back(
            put(world, by_rk4(r, 0.76), body_of(r, 1, 0), from + Vec3d{-std::sin(angle), -std::cos(angle), 0}));
        join(world, {.a = row.back(), .point = from, .length = 1});
      }
      const auto out = [&](int i) { return (world[row[static_cast<std::size_t>(i)]].position().x - 2 * r * i); };
      for (int half = 1; half <= 10; ++half) {
        while (world.time() + 0.5 / rate < half * period / 2) ASSERT_TRUE(world.step(1 / rate));
        for (int i = 0; i < 5; ++i) {
          const bool is_out = half % 2 == 0 ? i < many : i >= 5 - many;
          const double side = half % 2 == 0 ? -std::sin(swing) : std::sin(swing);
          EXPECT_NEAR(out(i), is_out ? side : 0, 0.05 * std::sin(swing)) << many << ' ' << half << ' ' << i << at(rate);
        }
      }
    }
}

/// wos-issues #114: a ballistic pendulum of 2 kg on a rod and on a cable of 2 m. Right: (1 + e) m u / (m + M) from 8 g
/// at 400 m/s, and a rise of V^2 / 2g.
TEST(CasesOfContacts, a_ballistic_pendulum_takes_the_momentum) {
  for (const OnHit then : {OnHit::stop, OnHit::bounce})
    for (const JointKind kind : {JointKind::rod, JointKind::cable})
      for (const double rate : {60.0, 240.0}) {
        const double m = 0.008, block_mass = 2, u = 400, e = then == OnHit::stop ? 0 : 1;
        World world = make_world(falling());
        const ProjectileId block = put(world, by_rk4(0.1, block_mass), body_of(0.1, 1, 0), {0, -2, 0});
        join(world, {.kind = kind, .a = block, .length = 2});
        BodyDef bullet = body_of(0.004, e, 0);
        bullet.gravity_scale = 0;
        bullet.collision.on_hit = then;
        put(world, by_rk4(0.004, m), bullet, {-0.104 - u * 0.05, -2, 0}, {u, 0, 0});
        double top = -2, fastest = 0;
        for (int i = 0; i < 1.5 * rate; ++i) {
          ASSERT_TRUE(world.step(1 / rate));
          top = std::max(top, world[block].position().y);
          fastest = std::max(fastest, length(world[block].velocity()));
        }
        const double right = (1 + e) * m * u / (m + block_mass), rise = right * right / (2 * kG);
        EXPECT_NEAR(fastest, right, 0.002 * right) << int(kind) << at(rate);
        EXPECT_NEAR(top + 2, rise, 0.002 * rise) << int(kind) << at(rate);
      }
}

/// JoltPhysics #1686: fifteen balls that touch lie in a rack without sleep. Right: none moves in ten seconds.
TEST(CasesOfContacts, a_rack_lies_still) {
  const double r = 0.028575;
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (const double away : {0.0, 1000.0})
      for (const bool is_mesh : {false, true}) {
        Scene scene;
        const MeshShape quad{{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}}, {{0, 2, 1}, {0, 3, 2}}, {}};
        add(scene, is_mesh ? ShapeDef(quad) : ShapeDef(BoxShape{{9, 1, 9}}), {away, is_mesh ? 0.0 : -1.0, 0}, {});
        World world = world_in(scene);
        std::vector<ProjectileId> ids;
        std::vector<Vec3d> from;
        for (int i = 0; i < 5; ++i)
          for (int j = 0; j <= i; ++j) {
            ids.push_back(put(world, by_rk4(r, 0.17, precision), body_of(r, 0.95, 0.2),
                              {away + i * r * std::sqrt(3.0), r, (2 * j - i) * r}));
            from.push_back(world[ids.back()].position());
          }
        const auto hits = of_kind(run_for(world, 10, 1.0 / 60), EventKind::hit);
        EXPECT_LE(hits.size(), 45u) << away;
        for (std::size_t i = 0; i < ids.size(); ++i) {
          EXPECT_LT(length(world[ids[i]].position() - from[i]), precision == Precision::float32 ? 1e-3 : 1e-6) << away;
          EXPECT_LT(length(world[ids[i]].velocity()), 1e-3) << away;
        }
      }
}

}  // namespace physim::world_cases_contact_test
