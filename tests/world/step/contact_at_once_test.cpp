// Contacts that fall on one moment, and contacts that last: corners, piles, walls that push, edges, rolling.
#include "world/joints_support.hpp"

namespace physim::world_contact_at_once_test {

using test_joints::falling;
using test_joints::join;
using test_joints::kGravity;
using test_pairs::put;
using test_pairs::space;

constexpr double kDegree = 0.017453292519943295;

ProjectileDef by_rk4(double radius, Precision precision = Precision::float64) {
  ProjectileDef p{.mass = 1, .diameter = 2 * radius};
  p.fidelity = test::vacuum(Integrator::rk4);
  p.fidelity.precision = precision;
  return p;
}

BodyDef body_of(double radius, double restitution, double friction) {
  BodyDef body = test_pairs::ball(radius, restitution, friction);
  body.gravity_scale = 1;
  body.rolling_resistance = 0;
  return body;
}

World world_with(const Scene& scene) { return make_world(falling(), scene); }

Quatd turned_about_z(double angle) { return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; }

std::size_t run(World& world, double seconds, double hz) {
  std::size_t hits = 0;
  for (int i = 0; i < seconds * hz; ++i) {
    EXPECT_TRUE(world.step(1 / hz));
    hits += events_of(world, EventKind::hit).size();
  }
  return hits;
}

TEST(ContactAtOnce, a_corner_with_friction_tells_no_wall_from_the_others) {
  for (const bool three : {false, true})
    for (const double hz : {60.0, 1000.0}) {
      Scene scene;
      const MaterialId hard = *scene.add_material({.restitution = 1, .friction = 1});
      const ShapeId box = *scene.add_shape(BoxShape{{2, 2, 2}});
      for (const Vec3d& at : {Vec3d{2, 0, 0}, Vec3d{0, 0, 2}, Vec3d{0, 2, 0}})
        if (three || at.y == 0) {
          ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = at}, .material = hard}));
        }
      World world = world_with(scene);
      const double r = 0.1, v = 3;
      BodyDef body = body_of(r, 1, 0.3);
      body.gravity_scale = 0;
      const Vec3d to{-r, three ? -r : 0, -r}, go{v, three ? v : 0, v};
      const ProjectileId id = put(world, by_rk4(r), body, to - go * 0.25, go);
      run(world, 0.5, hz);
      const Vec3d u = world[id].velocity();
      EXPECT_LT(u.x, -1);
      EXPECT_NEAR(u.x, u.z, 1e-9) << three << " " << hz;
      if (three) {
        EXPECT_NEAR(u.x, u.y, 1e-9) << hz;
      }
      EXPECT_LE(length(u), length(go) * (1 + 1e-12));
    }
}

TEST(ContactAtOnce, a_wall_pushes_a_ball_over_a_floor_and_up_a_ramp) {
  for (const double tilt : {0.0, 10.0})
    for (const double hz : {60.0, 240.0, 1000.0}) {
      const double r = 0.1, a = tilt * kDegree, c = std::cos(a), d = std::sin(a);
      Scene scene;
      const MaterialId soft = *scene.add_material({.restitution = 0, .friction = 1});
      add_thing(scene, BoxShape{{20, 1, 2}},
                {.transform = {.position = {d, -c, 0}, .rotation = turned_about_z(a)}, .material = soft});
      add_thing(scene, BoxShape{{0.1, 0.5, 1}},
                {.transform = {.position = {-0.5 * c, -0.5 * d, 0}, .rotation = turned_about_z(a)},
                 .material = soft,
                 .motion = SteadyMotion{.velocity = {c, d, 0}}});
      World world = world_with(scene);
      const ProjectileId id = put(world, by_rk4(r), body_of(r, 0, 0), {-r * d, r * c, 0});
      const std::size_t hits = run(world, 2, hz);
      const Vec3d p = world[id].position(), v = world[id].velocity();
      EXPECT_NEAR(p.x * c + p.y * d, 1.7, 1e-6) << tilt << " " << hz;  // the wall was 0.4 m behind it and goes 1 m/s
      EXPECT_NEAR(p.y * c - p.x * d, r, 1e-6) << tilt << " " << hz;
      EXPECT_NEAR(v.x * c + v.y * d, 1, 0.01) << tilt << " " << hz;
      EXPECT_LE(hits, 3u) << tilt << " " << hz;
    }
}

TEST(ContactAtOnce, what_falls_on_a_pile_bounces_off_the_floor_below) {
  for (const int below : {1, 2, 3})
    for (const double hz : {60.0, 240.0, 1000.0}) {
      const double r = 0.05, h = 0.3;
      Scene scene;
      const MaterialId hard = *scene.add_material({.restitution = 1, .friction = 1});
      add_thing(scene, PlaneShape{}, {.material = hard});
      World world = world_with(scene);
      const double start = r + 2 * r * below + h;
      const ProjectileId upper = put(world, by_rk4(r), body_of(r, 1, 0), {0, start, 0});
      std::vector<ProjectileId> lower;
      for (int i = 0; i < below; ++i) lower.push_back(put(world, by_rk4(r), body_of(r, 1, 0), {0, r + 2 * r * i, 0}));
      const double down = std::sqrt(2 * h / kGravity);
      double top = 0, moved = 0;
      for (int i = 0; i < 3 * down * hz; ++i) {
        ASSERT_TRUE(world.step(1 / hz));
        if (world.time() > down + 0.02) top = std::max(top, world[upper].position().y);
        for (int k = 0; k < below; ++k)
          moved = std::max(moved, std::abs(world[lower[static_cast<std::size_t>(k)]].position().y - r - 2 * r * k));
      }
      EXPECT_NEAR(top, start, 1e-3) << below << " " << hz;
      EXPECT_LT(moved, 1e-4) << below << " " << hz;
    }
}

TEST(ContactAtOnce, piles_at_rest_stay_at_rest) {
  for (const int count : {2, 5, 10})
    for (const double hz : {60.0, 240.0}) {
      const double r = 0.05;
      Scene scene;
      const MaterialId wood = *scene.add_material({.restitution = 0.5, .friction = 1});
      add_thing(scene, PlaneShape{}, {.material = wood});
      World world = world_with(scene);
      std::vector<ProjectileId> pile;
      for (int i = 0; i < count; ++i)
        pile.push_back(put(world, by_rk4(r), body_of(r, 0.5, 0.5), {0, r + 2 * r * i, 0}));
      const std::size_t hits = run(world, 2, hz);
      EXPECT_EQ(hits, 0u) << count;
      for (int i = 0; i < count; ++i)
        EXPECT_NEAR(world[pile[static_cast<std::size_t>(i)]].position().y, r + 2 * r * i, 1e-5) << count << " " << i;
    }
}

/// A wall that a ball or a point on a floor is a little in, by rounding or as others put it there, stops it as any
/// does.
TEST(ContactAtOnce, what_slides_goes_into_no_wall_that_it_is_in_already) {
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (const double r : {0.0, 0.05, 0.5})
      for (const double deep : {0.0, 1e-9, 2e-8, 2e-7})
        for (const double speed : {0.004, 0.5}) {
          Scene scene;
          const MaterialId soft = *scene.add_material({.restitution = 0, .friction = 0.3});
          const ShapeId box = *scene.add_shape(BoxShape{{3, 3, 3}});
          for (const Vec3d& at : {Vec3d{0, -5, 0}, Vec3d{0, 0, -5}}) {
            ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = at}, .material = soft}));
          }
          World world = world_with(scene);
          const ProjectileId ball = put(world, by_rk4(std::max(r, 0.05), precision), body_of(r, 0, 0.3),
                                        {-0.8, -2 + r, -2 + r - deep}, {0.1, 0, -speed});
          for (int i = 0; i < 20; ++i) {
            world.step(1.0 / 60);
            EXPECT_GT(world[ball].position().z, -2 + r - 5e-7) << r << " " << deep << " " << speed << " " << i;
            EXPECT_NEAR(world[ball].position().y, -2 + r, 5e-7) << r << " " << deep << " " << speed << " " << i;
          }
          EXPECT_NEAR(world[ball].velocity().z, 0, 1e-9);
        }
}

TEST(ContactAtOnce, a_ball_turns_about_an_edge_until_nothing_presses) {
  for (const double v : {2.0, 0.3})
    for (const double hz : {60.0, 240.0, 1000.0}) {
      const double r = 0.05, high = 1, f = v * v / kGravity / r;
      const double c = std::min(1.0, (10 + 7 * f) / 17), d = std::sqrt(1 - c * c);
      const double u = f < 1 ? std::sqrt(kGravity * r * c) : v;
      const double fall = (-u * d + std::sqrt(u * u * d * d + 2 * kGravity * (high - r + r * c))) / kGravity;
      Scene scene;
      const MaterialId grip = *scene.add_material({.restitution = 0, .friction = 1000});
      add_thing(scene, BoxShape{{1, 0.1, 1}}, {.transform = {.position = {-1, -0.1, 0}}, .material = grip});
      const InstanceId floor =
          add_thing(scene, PlaneShape{}, {.transform = {.position = {0, -high, 0}}, .material = grip});
      World world = world_with(scene);
      put(world, by_rk4(r), body_of(r, 0, 1), {-0.2, r, 0}, {1.4 * v, 0, 0});
      double met = 0;
      for (int i = 0; i < 3 * hz && met == 0; ++i) {
        ASSERT_TRUE(world.step(1 / hz));
        for (const Event& e : events_of(world, EventKind::hit)) met = e.instance == floor ? e.position.x : met;
      }
      EXPECT_NEAR(met, r * d + u * c * fall, 1e-3) << v << " " << hz;
    }
}

TEST(ContactAtOnce, a_sleeper_that_is_hit_takes_part_from_that_moment) {
  for (const double hz : {60.0, 1000.0}) {
    const double r = 0.028575, a = 0.2 * kGravity, v = 2, start = 2.8;
    Scene scene;
    const MaterialId cloth = *scene.add_material({.restitution = 0, .friction = 2000});
    add_thing(scene, BoxShape{{9, 1, 1}}, {.transform = {.position = {0, -1, 0}}, .material = cloth});
    World world = world_with(scene);
    BodyDef body = body_of(r, 1, 1e-4);
    body.can_sleep = true;
    const ProjectileId cue = put(world, by_rk4(r), body, {0, r, 0}, {start, 0, 0});
    const ProjectileId other = put(world, by_rk4(r), body, {2, r, 0});
    const double t1 = 2 * start / (7 * a), x1 = start * t1 - a * t1 * t1 / 2, t2 = t1 + (2 - 2 * r - x1) / v;
    for (int i = 0; i < 2.5 * hz; ++i) {
      ASSERT_TRUE(world.step(1 / hz));
      for (const Event& e : events_of(world, EventKind::woke)) EXPECT_NEAR(e.time, t2, 1e-6);
    }
    const double t3 = 2.0 / 7 * v / a;
    EXPECT_NEAR(world[cue].position().x, 2 - 2 * r + a * t3 * t3 / 2 + 2.0 / 7 * v * (2.5 - t2 - t3), 2e-3) << hz;
    EXPECT_NEAR(world[other].position().x, 2 + v * t3 - a * t3 * t3 / 2 + 5.0 / 7 * v * (2.5 - t2 - t3), 2e-3) << hz;
  }
}

TEST(ContactAtOnce, what_spins_in_a_corner_stays_between_its_walls) {
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4})
      for (const double radius : {0.2, 0.3, 0.7}) {
        Scene scene;
        const auto stone = scene.add_material({.restitution = 0.5, .friction = 1}).value();
        const auto wall = scene.add_shape(BoxShape{{1, 20, 20}}).value();
        const double h = std::sqrt(0.5);
        for (const auto& [at, turn] : {std::pair{Vec3d{-11, 0, 0}, Quatd{1, 0, 0, 0}},
                                       {Vec3d{0, -11, 0}, Quatd{h, 0, 0, h}},
                                       {Vec3d{0, 0, 11}, Quatd{h, 0, h, 0}}})
          EXPECT_TRUE(scene.add({.shape = wall, .transform = {.position = at, .rotation = turn}, .material = stone}));
        World world = world_with(scene);
        ProjectileDef p = by_rk4(radius, precision);
        p.fidelity.integrator = integrator;
        const double side = 10 - radius - 1e-5;
        const ProjectileId id = put(world, p, body_of(radius, 0.4, 0.6), {-side, -side, side});
        ASSERT_TRUE(world[id].set_angular_velocity({23.3, -23.9, 26.5}));
        for (int i = 0; i < 400; ++i) {
          ASSERT_TRUE(world.step(1.0 / 240 + (i * 37 % 100) * 0.01 * (1.0 / 30 - 1.0 / 240)));
          const Vec3d x = world[id].position();
          ASSERT_GE(std::min({x.x + 10, x.y + 10, 10 - x.z}), radius - 1e-5) << i << " " << radius;
        }
      }
}

TEST(ContactAtOnce, light_links_hold_a_heavy_ball) {
  for (const double mass : {1.0, 1000.0})
    for (const double degrees : {30.0, 60.0}) {
      World world = make_world(falling());
      const Vec3d along{std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0};
      ProjectileId last{};
      for (int i = 1; i <= 10; ++i) {
        ProjectileDef link = test_joints::mass_of(i == 10 ? mass : 0.001);
        const ProjectileId id = put(world, link, test_joints::bob(), along * (0.1 * i));
        join(world, {.a = id, .b = last, .length = 0.1});
        last = id;
      }
      const auto passes = test_joints::upward_passes(world, 1.0 / 60, 10, [&] {
        EXPECT_NEAR(length(world[last].position()), 1, 0.01) << mass << " " << degrees;
        return world[last].position().x;
      });
      ASSERT_GE(passes.size(), 4u);
      const double period = (passes.back() - passes.front()) / static_cast<double>(passes.size() - 1);
      EXPECT_NEAR(period, test_joints::pendulum_period(1, degrees * kDegree), 0.01 * period) << mass << " " << degrees;
      EXPECT_EQ(world.joint_counts().unsolved, 0u);
    }
}

}  // namespace physim::world_contact_at_once_test
