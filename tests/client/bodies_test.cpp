// What projectiles look like: their shapes by what they are, their meshes, and how they are turned.
#include "simclient/core/bodies.hpp"

#include <algorithm>
#include <cmath>

#include "client/support.hpp"
#include "math/angles.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client::client_bodies {
namespace {

BodyShape shape_in(const std::string& scenario) {
  return look_of(client_of(scenario).launcher.shot().projectile).shape;
}

TEST(Bodies, AreWhatScenariosFire) {
  const std::pair<const char*, BodyShape> wanted[] = {{"308_168gr_g7", BodyShape::bullet},
                                                      {"308_168gr_six_dof", BodyShape::bullet},
                                                      {"22lr", BodyShape::bullet},
                                                      {"105mm_m1_six_dof", BodyShape::shell},
                                                      {"arrow", BodyShape::arrow},
                                                      {"model_rocket", BodyShape::rocket},
                                                      {"sounding_rocket", BodyShape::rocket},
                                                      {"golf_drive", BodyShape::golf_ball},
                                                      {"golf_ball_no_spin", BodyShape::golf_ball},
                                                      {"curve_ball", BodyShape::baseball},
                                                      {"baseball_no_spin", BodyShape::baseball},
                                                      {"free_kick", BodyShape::football},
                                                      {"tennis_ball", BodyShape::tennis_ball},
                                                      {"nesc_case01", BodyShape::ball},
                                                      {"nesc_case02", BodyShape::brick},
                                                      {"nesc_case03", BodyShape::brick},
                                                      {"cannonball_galileo", BodyShape::ball},
                                                      {"original_artillery", BodyShape::shell},
                                                      {"original_bullet", BodyShape::bullet},
                                                      {"billiards", BodyShape::ball},
                                                      {"table_tennis", BodyShape::ball}};
  for (const auto& [scenario, shape] : wanted)
    EXPECT_EQ(static_cast<int>(shape_in(scenario)), static_cast<int>(shape)) << scenario;
  ProjectileDef cock{.name = "Shuttlecock"};
  EXPECT_EQ(look_of(cock).shape, BodyShape::shuttlecock);
}

/// NASA's brick is 8 in by 4 in by 2.25 in; its inertia says so.
TEST(Bodies, ABrickHasTheSidesThatItsInertiaSays) {
  const Vec3d size = look_of(client_of("nesc_case02").launcher.shot().projectile).size;
  double sides[] = {size.x, size.y, size.z};
  std::ranges::sort(sides);
  EXPECT_NEAR(sides[0], 2.25 * 0.0254, 0.002);
  EXPECT_NEAR(sides[1], 4 * 0.0254, 0.002);
  EXPECT_NEAR(sides[2], 8 * 0.0254, 0.002);
}

TEST(Bodies, MeshesStayInTheirBoxAndFaceOutwards) {
  for (std::size_t i = 0; i < kBodyShapes; ++i) {
    const auto shape = static_cast<BodyShape>(i);
    const auto mesh = mesh_of(shape);
    EXPECT_EQ(mesh.empty(), shape == BodyShape::ball);
    EXPECT_EQ(mesh.size() % 3, 0U);
    float most = 0;
    for (const LitVertex& v : mesh) {
      for (const float x : v.at) {
        EXPECT_LE(std::abs(x), 0.5001F) << i;
        most = std::max(most, std::abs(x));
      }
      const float* n = v.normal;
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5) << i;
    }
    if (!mesh.empty()) {
      EXPECT_NEAR(most, 0.5, 1e-3) << "it fills its box";
    }
  }
}

TEST(Bodies, NosesPointAlongTheirPaths) {
  for (const Vec3d& way : {Vec3d{1, 0, 0}, Vec3d{0, 0, 2}, Vec3d{-3, 1, 0.5}, Vec3d{0.1, -5, 0.2}, Vec3d{0, 1, 0}}) {
    const Quatd q = nose_along(way);
    const Vec3d nose = rotate(q, Vec3d{1, 0, 0}), right = rotate(q, Vec3d{0, 0, 1});
    EXPECT_LT(length(nose - normalized(way)), 1e-12);
    EXPECT_NEAR(right.y, 0, 1e-12) << "its right side is level";
  }
}

/// Backspin lifts, sidespin turns the path to the right: the lift of a ball goes with its spin across its velocity.
TEST(Bodies, BallsSpinAsTheyAreLaunched) {
  Launch launch{.speed = 30, .elevation = 0.3, .azimuth = 0.8};
  const Vec3d v{std::cos(0.3) * std::cos(0.8), std::sin(0.3), std::cos(0.3) * std::sin(0.8)};
  launch.spin.backspin = 5;
  EXPECT_GT(cross(spin_in_world(launch), v).y, 4.7);
  launch.spin = {.sidespin = 5};
  const Vec3d right{-std::sin(0.8), 0, std::cos(0.8)};
  EXPECT_NEAR(dot(cross(spin_in_world(launch), v), right), 5, 1e-9);
  launch.spin = {.gyrospin = 5};
  EXPECT_NEAR(dot(spin_in_world(launch), v), 5, 1e-9);
}

const SceneBody* only_body(Client& client, Scene& scene) {
  build_scene(client, 1, scene);
  return scene.bodies.size() == 1 ? scene.bodies.data() : nullptr;
}

TEST(Bodies, AreDrawnAsTheyFly) {
  Scene scene;
  Client rocket = client_of("model_rocket");
  ASSERT_TRUE(run(rocket, "fire; wait 40"));
  const SceneBody* body = only_body(rocket, scene);
  ASSERT_NE(body, nullptr);
  const Track& track = rocket.session.tracks()[0];
  const Vec3d nose = rotate(body->attitude, Vec3d{1, 0, 0});
  EXPECT_GT(dot(nose, normalized(track.samples.back().velocity)), 0.9999);
  EXPECT_GE(scene.sprites.size(), 5U) << "its motor burns: a flame";
  ASSERT_TRUE(run(rocket, "wait 120"));
  ASSERT_GT(rocket.session.time(), *track.burnout);
  ASSERT_NE(only_body(rocket, scene), nullptr);
  EXPECT_TRUE(scene.sprites.empty()) << "burned out";

  Client golf = client_of("golf_drive");
  ASSERT_TRUE(run(golf, "fire-whole; wait 30; pause"));
  ASSERT_NE(only_body(golf, scene), nullptr);
  const Quatd before = scene.bodies[0].attitude;
  ASSERT_TRUE(run(golf, "step; wait 1"));
  ASSERT_NE(only_body(golf, scene), nullptr);
  EXPECT_FALSE(scene.bodies[0].attitude == before) << "it spins";
}

/// The brick's attitude is the one that is flown; a plain ball is no mesh.
TEST(Bodies, ATumblingBrickTurns) {
  Client client = client_of("nesc_case02");
  Scene scene;
  ASSERT_TRUE(run(client, "fire-whole; wait 60; pause"));
  const SceneBody* body = only_body(client, scene);
  ASSERT_NE(body, nullptr);
  const Track& track = client.session.tracks()[0];
  const Quatd flown = track.whole->at(client.session.shown_time() - track.born).orientation;
  EXPECT_NEAR(std::abs(flown.w * body->attitude.w + flown.x * body->attitude.x + flown.y * body->attitude.y +
                       flown.z * body->attitude.z),
              1, 1e-9);
  Client ball = client_of("nesc_case01");
  ASSERT_TRUE(run(ball, "fire-whole; wait 60"));
  build_scene(ball, 1, scene);
  EXPECT_TRUE(scene.bodies.empty());
}

bool has_label(const Scene& scene, const char* part) {
  return std::ranges::any_of(scene.labels,
                             [part](const SceneLabel& l) { return l.text.find(part) != std::string::npos; });
}

TEST(Bodies, TheYawOfABulletHasACone) {
  Client client = client_of("308_168gr_six_dof");
  Scene scene;
  ASSERT_TRUE(run(client, "speed 0.05; fire-whole; wait 30"));
  build_scene(client, 1, scene);
  EXPECT_TRUE(has_label(scene, "yaw "));
  const std::size_t lines = scene.lines.size();
  ASSERT_TRUE(run(client, "attitude"));
  build_scene(client, 1, scene);
  EXPECT_FALSE(has_label(scene, "yaw "));
  EXPECT_LT(scene.lines.size(), lines - 40);
}

/// Dust for 0.7 s, then nothing moves any more; a dark spot stays.
TEST(Bodies, DustRisesWhereTheyLandAndSettles) {
  Client client = client_of();
  Scene scene;
  ASSERT_TRUE(run(client, "fire"));
  for (int i = 0; i < 600 && !client.session.tracks()[0].impact; ++i) client.advance(1.0 / 60);
  ASSERT_TRUE(client.session.tracks()[0].impact);
  build_scene(client, 1, scene);
  EXPECT_GE(scene.sprites.size(), 5U);
  EXPECT_TRUE(client.is_changing());
  ASSERT_TRUE(run(client, "wait 60"));
  build_scene(client, 1, scene);
  EXPECT_TRUE(scene.sprites.empty());
  EXPECT_FALSE(client.is_changing()) << "at rest nothing is drawn";
  EXPECT_EQ(scene.discs.size(), 1U);
}

}  // namespace
}  // namespace physim::client::client_bodies
