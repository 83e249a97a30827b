// The view looks at what a scenario is about: in all shipped scenarios, and until a hand moves it.
#include <nlohmann/json.hpp>

#include "client/support.hpp"
#include "math/angles.hpp"
#include "model/ladder.hpp"
#include "shipped.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/state_log.hpp"
#include "simclient/core/subject.hpp"

namespace physim::client::client_framing {
namespace {

class Framed : public testing::TestWithParam<std::string> {};

bool is_above_ground(Client& client) {
  const auto ground = client.session.ground();
  const bool is_round = row(client.launcher.shot().projectile.fidelity.earth).shape != EarthShape::flat;
  return !ground || is_round || client.camera.eye().y > client.camera.shown({0, *ground, 0}).y;
}

/// A quarter of the picture's width or height at least, when it opens, in flight, and in a narrow window.
TEST_P(Framed, ItsSubjectIsLarge) {
  Client client = client_of(GetParam());
  const bool fires = !client.session.scenario().world.given;
  for (const auto& [width, height] : {std::pair{640.0, 746.0}, {1280.0, 746.0}, {235.0, 546.0}, {208.0, 174.0}}) {
    client.camera.set_viewport(width, height);
    client.keep_view();
    const nlohmann::json state = nlohmann::json::parse(state_line(client, 1));
    EXPECT_GE(state["subject"], 0.25) << width << " pixels wide";
    EXPECT_LE(state["subject"], 0.95) << width << " pixels wide";
    EXPECT_TRUE(is_above_ground(client));
    for (const Vec3d& place : client.subject()) {
      const auto seen = client.camera.project(place);
      ASSERT_TRUE(seen) << width << " pixels wide";
      EXPECT_TRUE(seen->x >= 0 && seen->x <= width && seen->y >= 0 && seen->y <= height) << width << " pixels wide";
    }
  }
  if (fires) {
    ASSERT_TRUE(client.fire());
  }
  for (int i = 0; i < 90; ++i) {
    client.advance(1.0 / 60);
    client.keep_view();
  }
  EXPECT_GE(client.camera.cover(client.subject()), 0.25) << "in flight";
  EXPECT_TRUE(is_above_ground(client));
}

INSTANTIATE_TEST_SUITE_P(Shipped, Framed, testing::ValuesIn(test::shipped_scenarios()),
                         [](const auto& test) { return test.param; });

TEST(Framing, TheWholeOfALongFlightIsInView) {
  for (const char* scenario : {"105mm_m1_six_dof", "low_orbit", "intercontinental_lob"}) {
    Client client = client_of(scenario);
    const Flight whole = fly_shot(client.session.scenario(), client.launcher.shot());
    for (int i = 0; i <= 20; ++i) {
      const auto seen = client.camera.project(whole.at(whole.duration() * i / 20).position);
      ASSERT_TRUE(seen) << scenario << " " << i;
      EXPECT_GE(std::min(seen->x, seen->y), 0) << scenario << " " << i;
      EXPECT_LE(seen->x, client.camera.width()) << scenario << " " << i;
      EXPECT_LE(seen->y, client.camera.height()) << scenario << " " << i;
    }
  }
}

/// A table from near, where perspective is strong, in windows of all proportions.
TEST(Framing, EveryCornerOfThingsIsInView) {
  Client client = client_of("billiards");
  for (const auto& [width, height] : {std::pair{960.0, 386.0}, {640.0, 746.0}, {1280.0, 300.0}, {240.0, 700.0}}) {
    client.camera.set_viewport(width, height);
    client.fit_view();
    const Scenery& things = client.scenery();
    for (int i = 0; i < 8; ++i) {
      const auto seen = must(client.camera.project({(i & 1) != 0 ? things.high.x : things.low.x,
                                                    (i & 2) != 0 ? things.high.y : things.low.y,
                                                    (i & 4) != 0 ? things.high.z : things.low.z}));
      EXPECT_GE(std::min(seen.x, seen.y), 0) << width;
      EXPECT_LE(seen.x, width);
      EXPECT_LE(seen.y, height);
    }
  }
}

TEST(Framing, FollowsTheWindowUntilAHandMovesTheView) {
  Client client = client_of("golf_drive");
  client.camera.set_viewport(640, 700);
  client.keep_view();
  const double before = client.camera.distance;
  client.camera.set_viewport(640, 300);
  client.keep_view();
  EXPECT_NE(client.camera.distance, before);
  ASSERT_TRUE(run(client, "zoom-in"));
  const double chosen = client.camera.distance;
  client.camera.set_viewport(400, 700);
  client.keep_view();
  EXPECT_EQ(client.camera.distance, chosen);
  ASSERT_TRUE(run(client, "fit"));
  client.camera.set_viewport(640, 700);
  client.keep_view();
  EXPECT_NEAR(client.camera.distance, before, 1e-9 * before);
}

TEST(Framing, TheEyeStaysAboveTheGround) {
  Client client = client_of();
  for (const double pitch : {0.2, -0.3, -1.4}) {
    client.camera.pitch = pitch;
    client.keep_view();
    EXPECT_TRUE(is_above_ground(client)) << pitch;
  }
}

TEST(Framing, GroundIsDrawnWhereThereIsOne) {
  Scene scene;
  Client falls = client_of("nesc_case01"), lands = client_of("golf_drive");
  build_scene(falls, 1, scene);
  EXPECT_FALSE(scene.has_ground);
  for (const SceneLabel& label : scene.labels) EXPECT_EQ(label.text.find(" km"), std::string::npos) << label.text;
  build_scene(lands, 1, scene);
  EXPECT_TRUE(scene.has_ground);
}

TEST(Framing, ARoundEarthIsAGlobe) {
  Client client = client_of("low_orbit");
  Scene scene;
  build_scene(client, 1, scene);
  ASSERT_TRUE(scene.globe);
  EXPECT_NEAR(scene.globe->radius, 6.371e6, 15e3);
  EXPECT_NEAR(length(scene.globe->centre), scene.globe->radius + client.session.scenario().environment.altitude, 25e3);
  // The axis of the Earth goes through latitude 90 degrees.
  const auto& turn = scene.globe->to_geographic;
  const EarthFrames frames(client.session.scenario().environment, client.launcher.shot().projectile.fidelity.earth);
  const Vec3d pole = frames.from_earth_fixed({{0, 0, 7e6}, {}}).position - scene.globe->centre;
  const double north = turn[2] * pole.x + turn[5] * pole.y + turn[8] * pole.z;
  EXPECT_NEAR(north / length(pole), 1, 1e-6);
}

TEST(Framing, WhatIsLongIsSeenFromItsSide) {
  std::vector<Vec3d> row, ring;
  for (int i = 0; i < 36; ++i) {
    const double turn = i * 10 * kDegree, along = i - 18;
    ring.push_back({5 * std::cos(turn), 40, 5 * std::sin(turn)});
    row.push_back({along * std::cos(30 * kDegree) + 7, std::cos(turn), along * std::sin(30 * kDegree)});
  }
  ASSERT_TRUE(long_side_of(row));
  EXPECT_NEAR(std::remainder(*long_side_of(row) - 30 * kDegree, kPi), 0, 1e-12);
  EXPECT_FALSE(long_side_of(ring));
  EXPECT_FALSE(long_side_of({}));
  // The five bursts stand beside each other: their row takes more of the picture's width than of its height.
  Client client = client_of("emit_fireworks");
  client.camera.set_viewport(960, 712);
  client.fit_view();
  const auto left = client.camera.project({-160, 128, 0}), right = client.camera.project({160, 128, 0});
  ASSERT_TRUE(left && right);
  EXPECT_GT(std::abs(right->x - left->x), 0.3 * 960);
}

}  // namespace
}  // namespace physim::client::client_framing
