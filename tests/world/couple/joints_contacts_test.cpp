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
    for (const JointKind kind : {JointKind::rod, JointKind::cable, JointKind::spring})
      for (const Precision precision : {Precision::float64, Precision::float32}) {
        World world = make_world(falling(), room());
        const ProjectileId one = put(world, mass_of(1, precision), ball(radius), {0, -1, 0});
        join(world, {.kind = kind, .a = one, .point = {0.3, -4, 0}, .length = 0.5, .stiffness = 1e5, .damping = 10});
        for (int i = 0; i < 240; ++i) {
          world.step(1.0 / 60);
          ASSERT_TRUE(world[one].is_alive());
          ASSERT_GT(world[one].position().y, -2 + radius - 1e-6) << radius << ' ' << int(kind) << ' ' << i;
        }
        EXPECT_LT(world[one].position().y, -1.9 + radius);
        EXPECT_LT(length(world[one].velocity()), 2);
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
