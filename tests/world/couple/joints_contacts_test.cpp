// Joints and what there is to meet: nets move nobody through the ground or through things.
#include <random>

#include "world/joints_support.hpp"

namespace physim::world_joints_contacts_test {

using namespace test_joints;
using test::near;

BodyDef ball(double radius) {
  BodyDef body = bob();
  body.restitution = 0.3;
  body.collision = {.on_hit = OnHit::bounce, .radius = radius};
  return body;
}

/// Walls of boxes of 20 cm around the origin, their faces 2 m from it.
Scene room() {
  Scene scene;
  for (const double side : {-1.0, 1.0})
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d at = axis == 0   ? Vec3d{2.1 * side, 0, 0}
                       : axis == 1 ? Vec3d{0, 2.1 * side, 0}
                                   : Vec3d{0, 0, 2.1 * side};
      const Vec3d half = axis == 0 ? Vec3d{0.1, 3, 3} : axis == 1 ? Vec3d{3, 0.1, 3} : Vec3d{3, 3, 0.1};
      const auto shape = scene.add_shape(BoxShape{half});
      EXPECT_TRUE(shape && scene.add({.shape = *shape, .transform = {.position = at}}));
    }
  return scene;
}

TEST(JointContacts, a_joint_pulls_nobody_through_a_wall) {
  for (const double radius : {0.0, 0.1})
    for (const JointKind kind : {JointKind::rod, JointKind::cable})
      for (const Precision precision : {Precision::float64, Precision::float32}) {
        World world = make_world(falling(), room());
        const ProjectileId one = put(world, mass_of(1, precision), ball(radius), {0, -1, 0});
        join(world, {.kind = kind, .a = one, .point = {0.3, -4, 0}, .length = 0.5});
        for (int i = 0; i < 240; ++i) {
          world.step(1.0 / 60);
          ASSERT_TRUE(world[one].is_alive());
          ASSERT_GT(world[one].position().y, -2 + radius - 1e-6) << radius << ' ' << int(kind) << ' ' << i;
        }
        EXPECT_LT(world[one].position().y, -1.9 + radius);
        EXPECT_LT(length(world[one].velocity()), 2);
      }
}

/// Held to the floor by 2e5 N it swings along it, as nothing rubs there: in steps of 1/10000 s with 27.8 m/s after 3.5
/// s.
TEST(JointContacts, a_spring_pulls_nobody_through_a_wall) {
  for (const double radius : {0.0, 0.1})
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      World world = make_world(falling(), room());
      const ProjectileId one = put(world, mass_of(1, precision), ball(radius), {0, -1, 0});
      join(world, {.kind = JointKind::spring,
                   .a = one,
                   .point = {0.3, -4, 0},
                   .length = 0.5,
                   .stiffness = 1e5,
                   .damping = 300});
      double fastest = 0;
      for (int i = 0; i < 240; ++i) {
        world.step(1.0 / 60);
        ASSERT_TRUE(world[one].is_alive());
        ASSERT_GT(world[one].position().y, -2 + radius - 1e-6) << radius << ' ' << i;
        if (i > 210) fastest = std::max(fastest, length(world[one].velocity()));
      }
      EXPECT_LT(world[one].position().y, -1.9 + radius);
      EXPECT_TRUE(near(fastest, 29, 0.2));
    }
}

TEST(JointContacts, a_wrecking_ball_stays_on_its_side_of_the_wall) {
  World world = make_world(falling(), room());
  const ProjectileId one = put(world, mass_of(100), ball(0.2), {-1.5, 1, 0});
  join(world, {.kind = JointKind::cable, .a = one, .point = {1.5, 1, 0}});
  double farthest = -2;
  for (int i = 0; i < 600; ++i) {
    world.step(1.0 / 60);
    farthest = std::max(farthest, world[one].position().x);
    ASSERT_LT(world[one].position().x, 1.8 + 1e-6);
    ASSERT_GT(world[one].position().y, -1.8 - 1e-6);
  }
  EXPECT_GT(farthest, 1.7);  // it met the wall
}

TEST(JointContacts, a_dumb_bell_falls_on_the_ground_and_comes_to_rest_on_it) {
  WorldDef def = falling();
  def.ground = {GroundMode::bounce, 0, 1, 1};
  World world = World::create(def).value();
  BodyDef body{.restitution = 0.4};
  const ProjectileId a = put(world, mass_of(1), body, {0, 1, 0}, {1, 0, 0.5});
  const ProjectileId b = put(world, mass_of(2), body, {0.6, 1.8, 0});
  const JointId rod = join(world, {.a = a, .b = b});
  for (int i = 0; i < 900; ++i) {
    world.step(1.0 / 60);
    for (const ProjectileId id : {a, b}) ASSERT_GT(world[id].position().y, -1e-9) << i;
    ASSERT_TRUE(near(world.joint_state(rod).length, 1, 1e-9)) << i;
  }
  for (const ProjectileId id : {a, b}) {
    EXPECT_TRUE(world[id].is_asleep());
    EXPECT_LT(world[id].position().y, 1e-6);
  }
}

/// What bounces in its flight alone bounces where its net brings it to the same plane, and the net takes its share of
/// the blow: a ball on a spring of 100 N/m had four times its energy after 20 s, and one on a rod stood still.
TEST(JointContacts, what_bounces_with_all_of_its_speed_keeps_its_energy) {
  const auto ground = [] {
    WorldDef def = falling();
    def.ground = {GroundMode::bounce, 0, 1, 0};
    return World::create(def).value();
  };
  const auto box = [] {
    Scene scene;
    const ShapeId shape = *scene.add_shape(BoxShape{{50, 1, 50}});
    const MaterialId hard = *scene.add_material({.restitution = 1, .friction = 0});
    EXPECT_TRUE(scene.add({.shape = shape, .transform = {.position = {0, -1, 0}}, .material = hard}));
    return make_world(falling(), std::move(scene));
  };
  for (const bool on_box : {false, true})
    for (const double dt : {1.0 / 60, 1.0 / 240})
      for (const double k : {0.0, 20.0, 100.0, 1e3, 1e4, -20.0, -100.0}) {  // 0: a rod; below 0: it pulls down
        World world = on_box ? box() : ground();
        BodyDef body = bob();
        body.restitution = 1, body.friction = 0;
        body.collision.on_hit = OnHit::bounce;
        const ProjectileId id = put(world, mass_of(1), body, {0.3, 1, 0});
        const Joint spring{.kind = JointKind::spring,
                           .a = id,
                           .point = {0, k > 0 ? 1.5 : -1, 0},
                           .length = 1,
                           .stiffness = std::abs(k)};
        const JointId joint = join(world, k == 0 ? Joint{.a = id, .point = {0, 0.2, 0}} : spring);
        const std::vector<ProjectileId> all{id};
        const auto whole = [&] {
          return energy(world, all) + std::abs(k) / 2 * std::pow(world.joint_state(joint).length - 1, 2);
        };
        const double begun = whole();
        std::size_t bounces = 0;
        for (int i = 0; i < 20 / dt; ++i) {
          world.step(dt);
          for (const Event& e : world.events()) bounces += e.kind == EventKind::bounced;
        }
        EXPECT_TRUE(near(whole(), begun, k == 0 ? 2e-3 : 1e-5)) << on_box << ' ' << dt << ' ' << k;
        EXPECT_EQ(world.joint_counts().unsolved, 0u) << on_box << ' ' << dt << ' ' << k;
        EXPECT_GE(bounces, k < 1000 ? 3u : 0u) << on_box << ' ' << dt << ' ' << k;
      }
}

/// A rod between two equal masses comes down on one end with speed u, a long way off the level: the blow is
/// J = (1 + e) u / w, with w = (1 + cos^2)/(2 m) what it gives to the end that is struck.
TEST(JointContacts, a_blow_on_one_end_of_a_dumb_bell_turns_it_as_a_rigid_body) {
  for (const double angle : {0.0, 0.5, 1.2})
    for (const double restitution : {0.3, 1.0}) {
      WorldDef def = space();
      def.ground = {GroundMode::bounce, 0, 1, 0};
      World world = World::create(def).value();
      BodyDef body = weightless();
      body.restitution = restitution;
      const double u = 3, m = 2;
      const ProjectileId low = put(world, mass_of(m), body, {0, 0.11, 0}, {0, -u, 0});
      const ProjectileId high =
          put(world, mass_of(m), body, {std::cos(angle), 0.11 + 1e-3 + std::sin(angle), 0}, {0, -u, 0});
      join(world, {.a = low, .b = high});
      for (int i = 0; i < 400 && world[low].velocity().y < 0; ++i) world.step(1.0 / 4000);
      const double c2 = std::cos(angle) * std::cos(angle), blow = (1 + restitution) * u * 2 * m / (1 + c2);
      EXPECT_TRUE(near(world[low].velocity().y, restitution * u, 0.03)) << angle;
      EXPECT_TRUE(near((world[low].velocity().y + world[high].velocity().y) * m, blow - 2 * m * u, 0, 0.03 * blow))
          << angle;
    }
}

/// Rough ground takes energy and gives none: friction of the flights alone made it, as the blow had turned the net
/// already.
TEST(JointContacts, rough_ground_makes_no_energy) {
  for (const bool is_spring : {false, true})
    for (const double angle : {0.0, 0.4, 0.8, 1.2})
      for (const double along : {-3.0, 0.0, 3.0})
        for (const double friction : {0.1, 0.5, 1.0}) {
          WorldDef def = falling();
          def.ground = {GroundMode::bounce, 0, 1, 1};
          World world = World::create(def).value();
          BodyDef body = bob();
          body.restitution = 0.9, body.friction = friction;
          const std::vector<ProjectileId> all{
              put(world, mass_of(1), body, {0, 1, 0}, {along, 0, 0}),
              put(world, mass_of(1), body, {std::cos(angle), 1 + std::sin(angle), 0}, {along, 0, 0})};
          const JointKind kind = is_spring ? JointKind::spring : JointKind::rod;
          const JointId joint = join(world, {.kind = kind, .a = all[0], .b = all[1], .stiffness = 200});
          const double begun = energy(world, all);
          for (int i = 0; i < 600; ++i) {
            world.step(1.0 / 60);
            const double stored = is_spring ? 100 * std::pow(world.joint_state(joint).length - 1, 2) : 0;
            ASSERT_LT(energy(world, all) + stored, begun * 1.01)
                << is_spring << ' ' << angle << ' ' << along << ' ' << i;
          }
        }
}

/// The blow of a landing is in the force of what holds: the upper ball gives (1 + e) m v in a step.
TEST(JointContacts, a_landing_breaks_what_is_too_weak_for_it) {
  for (const double limit : {520.0, 540.0}) {
    WorldDef def = falling();
    def.ground = {GroundMode::bounce, 0, 1, 0};
    World world = World::create(def).value();
    BodyDef body = bob();
    body.restitution = 1;
    const ProjectileId low = put(world, mass_of(1), body, {0, 1, 0}), high = put(world, mass_of(1), body, {0, 2, 0});
    const JointId rod = join(world, {.a = low, .b = high, .break_force = limit});
    const double blow = 2 * std::sqrt(2 * kGravity) * 60;  // 531.5 N
    double most = 0;
    for (int i = 0; i < 40 && (world.joint(rod) != nullptr); ++i)
      world.step(1.0 / 60), most = std::max(most, world.joint_state(rod).force);
    EXPECT_EQ((world.joint(rod) != nullptr), limit > blow) << most;
    if (limit > blow) {
      EXPECT_TRUE(near(most, blow, 5e-3));
    }
  }
}

/// Each of a long row bounces, also where all come down in one step, and balls that meet two walls in one step do so
/// twice.
TEST(JointContacts, all_of_a_net_bounce_however_many_do_so_in_a_step) {
  for (const JointKind kind : {JointKind::rod, JointKind::cable, JointKind::spring})
    for (const double slope : {0.0, 0.002}) {
      WorldDef def = falling();
      def.ground = {GroundMode::bounce, 0, 1, 0};
      World world = World::create(def).value();
      BodyDef body = bob();
      body.restitution = 1;
      std::vector<ProjectileId> all;
      for (int i = 0; i < 40; ++i) {
        all.push_back(put(world, mass_of(1), body, {0.5 * i, 1 + slope * i, 0}));
        if (i > 0) join(world, {.kind = kind, .a = all[i - 1], .b = all[i], .stiffness = 10});
      }
      const double begun = energy(world, all);
      for (int i = 0; i < 45; ++i) world.step(1.0 / 60);
      for (const ProjectileId id : all) EXPECT_GT(world[id].velocity().y, 0) << int(kind) << ' ' << slope;
      EXPECT_TRUE(near(energy(world, all), begun, 1e-2)) << int(kind) << ' ' << slope;
    }
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (int start = 0; start < 30; ++start) {
      Scene scene = room();
      World world = make_world(space(), std::move(scene));
      BodyDef body = ball(0.1);
      body.restitution = 1, body.friction = 0;
      body.combine = {Combine::maximum, Combine::minimum};
      const ProjectileId id = put(world, mass_of(1, precision), body, {0.05 * start, 0.03 * start, 0},
                                  {20.0 + start, 25.0, 31.0 - 0.5 * start});
      join(world, {.kind = JointKind::spring, .a = id, .stiffness = 1e-6});
      const std::vector<ProjectileId> alone{id};
      const double begun = energy(world, alone);
      for (int i = 0; i < 600; ++i) world.step(1.0 / 60);
      EXPECT_TRUE(near(energy(world, alone), begun, 2e-2)) << start;
    }
}

class NetsInRoom : public testing::TestWithParam<unsigned> {};

TEST_P(NetsInRoom, nets_that_fly_about_in_a_room_stay_in_it) {
  for (const double radius : {0.0, 0.05})
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      World world = make_world(falling(), room());
      std::mt19937 random(GetParam());
      const auto real = [&](double size) { return size * (static_cast<double>(random() % 20001) / 10000 - 1); };
      std::vector<ProjectileId> all;
      for (int i = 0; i < 30; ++i)
        all.push_back(put(world, mass_of(0.2 + i % 4, precision), ball(radius), {real(1.5), real(1.5), real(1.5)},
                          {real(20), real(20), real(20)}));
      for (std::size_t i = 0; i < 40; ++i) {
        Joint joint{.kind = static_cast<JointKind>(i % 3), .a = all[random() % 30], .b = all[random() % 30]};
        if (joint.kind == JointKind::cable) joint.length = 1.5;
        if (joint.kind == JointKind::spring) joint.length = 0.5, joint.stiffness = 300;
        if (joint.a != joint.b) static_cast<void>(world.add_joint(joint));
      }
      for (int i = 0; i < 600; ++i) {
        world.step(1.0 / 60);
        for (const ProjectileId id : all) {
          const Vec3d at = world[id].position();
          ASSERT_LT(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}), 2 - radius + 1e-5)
              << id.index << ' ' << i;
        }
      }
      EXPECT_EQ(world.size(), 30u);
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, NetsInRoom, testing::Values(11, 5, 12, 15, 16));

}  // namespace physim::world_joints_contacts_test
