// The cache of auto fidelity: one computation for each kind of projectile, the same answer however it is asked.
#include <random>
#include <thread>

#include "support.hpp"

namespace physim::flight_auto_fidelity_cache_test {

using namespace test;

const Launch kLaunch{.position = {0, 1.5, 0}, .speed = 810, .elevation = 0.03};
const Purpose kPurpose{.error = 0.05, .time = 0.5};

TEST(AutoFidelityCache, ComputesOnceForAKind) {
  AutoFidelityCache cache;
  const auto first = must(cache.cheapest_within(bullet_308(), kLaunch, {}, kPurpose));
  ProjectileDef renamed = bullet_308();
  renamed.name = "another name";
  renamed.fidelity = Fidelity::arcade();
  Launch alike = kLaunch;
  alike.speed = 805;
  alike.elevation = 0.05;
  alike.position = {100, 2, -30};
  const auto again = must(cache.cheapest_within(renamed, alike, {}, kPurpose));
  EXPECT_EQ(first.get(), again.get());
  EXPECT_EQ(cache.computed(), 1U);
  EXPECT_EQ(cache.size(), 1U);
}

TEST(AutoFidelityCache, ALaunchFasterThanNumbersAreIsAClassOfItsOwn) {
  for (const double v : {1e200, 1e308}) {
    const auto launches = launch_class({.velocity = Vec3d{v, v, v}}, 0.0);
    ASSERT_EQ(launches.size(), 1U);
    EXPECT_EQ(launches[0].velocity->x, v);
  }
}

TEST(AutoFidelityCache, EverythingElseIsAnotherKind) {
  AutoFidelityCache cache;
  const auto ask = [&](const auto& change) {
    ProjectileDef p = bullet_308();
    Launch l = kLaunch;
    Environment e;
    Purpose q = kPurpose;
    change(p, l, e, q);
    ASSERT_TRUE(cache.cheapest_within(p, l, e, q).ok());
  };
  ask([](auto&, auto&, auto&, auto&) {});
  ask([](auto& p, auto&, auto&, auto&) { p.mass *= 2; });
  ask([](auto& p, auto&, auto&, auto&) { p.drag.ballistic_coefficient *= 2; });
  ask([](auto& p, auto&, auto&, auto&) { p.drag.bands = {{300, 150}}; });
  ask([](auto& p, auto&, auto&, auto&) { p.force = {0, 0, 1e-3}; });
  ask([](auto&, auto& l, auto&, auto&) { l.speed = 500; });
  ask([](auto&, auto& l, auto&, auto&) { l.elevation = 1; });
  ask([](auto&, auto& l, auto&, auto&) { l.azimuth = 1; });
  ask([](auto&, auto& l, auto&, auto&) { l.position.x = 1e5; });
  ask([](auto&, auto&, auto& e, auto&) { e.wind.velocity.z = 1; });
  ask([](auto&, auto&, auto& e, auto&) { e.wind.profile = {{0, {0, 0, 1}}, {9, {0, 0, 2}}}; });
  ask([](auto&, auto&, auto& e, auto&) { e.atmosphere.temperature = 300; });
  ask([](auto&, auto&, auto&, auto& q) { q.error *= 2; });
  ask([](auto&, auto&, auto&, auto& q) { q.time *= 2; });
  ask([](auto&, auto&, auto&, auto& q) { q.ground = 0; });
  ask([](auto&, auto&, auto&, auto& q) { q.truth.rotation = RotationModel::none; });
  EXPECT_EQ(cache.computed(), 16U);
  EXPECT_EQ(cache.size(), 16U);
}

TEST(AutoFidelityCache, IsBoundedAndForgetsTheLongestUnasked) {
  AutoFidelityCache cache(2);
  const auto ask = [&](double error) {
    const auto answer = cache.cheapest_within(bullet_308(), kLaunch, {}, {.error = error, .time = 0.1});
    ASSERT_TRUE(answer.ok());
  };
  ask(1), ask(2), ask(1), ask(3);  // 2 makes room
  EXPECT_EQ(cache.size(), 2U);
  ask(1);
  EXPECT_EQ(cache.computed(), 3U);
  ask(2);
  EXPECT_EQ(cache.computed(), 4U);
  cache.clear();
  EXPECT_EQ(cache.size(), 0U);
}

TEST(AutoFidelityCache, RefusalsAreRememberedToo) {
  AutoFidelityCache cache;
  for (int i = 0; i < 2; ++i) {
    const auto answer = cache.cheapest_within(bullet_308(), {.speed = kNan}, {}, kPurpose);
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().place, "launch.speed");
  }
  EXPECT_EQ(cache.computed(), 1U);
}

TEST(AutoFidelityCache, ThreadsGetOneAnswer) {
  AutoFidelityCache cache;
  const AutoFidelity* seen[8] = {};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      const Purpose purpose{.error = i % 2 == 0 ? 0.1 : 1.0, .time = 0.2};
      const auto answer = cache.cheapest_within(bullet_308(), kLaunch, {}, purpose);
      if (answer) seen[i] = answer->get();
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(cache.computed(), 2U);
  ASSERT_NE(seen[0], nullptr);
  ASSERT_NE(seen[1], nullptr);
  EXPECT_NE(seen[0], seen[1]);
  for (int i = 2; i < 8; ++i) EXPECT_EQ(seen[i], seen[i % 2]);
}

TEST(AutoFidelityCache, AClassHoldsItsLaunches) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 500; ++i) {
    const Launch launch{.position = {0, 100 * unit(random), 0},
                        .speed = 1000 * unit(random),
                        .elevation = 3 * unit(random) - 1.5,
                        .azimuth = 6 * unit(random) - 3};
    const std::vector<Launch> corners = launch_class(launch, 0.0);
    ASSERT_EQ(corners.size(), 9U) << "eight corners and the middle";
    const Launch &low = corners[0], &high = corners[7];
    EXPECT_LE(low.speed, launch.speed);
    EXPECT_GE(high.speed, launch.speed);
    EXPECT_LE(high.speed, 1.13 * launch.speed);
    EXPECT_LE(low.elevation, launch.elevation);
    EXPECT_GE(high.elevation, launch.elevation);
    EXPECT_NEAR(low.azimuth, launch.azimuth, 1.0 / 32 + 1e-12);
    EXPECT_LE(low.position.y, launch.position.y);
    EXPECT_GE(high.position.y, launch.position.y);
  }
  EXPECT_EQ(launch_class({.position = {0, 1, 0}}, {}).size(), 5U) << "dropped: without speed";
  EXPECT_EQ(launch_class({.speed = 100, .sight = {.zero_range = 50}}, {}).size(), 5U) << "a zero elevates it";
  EXPECT_EQ(launch_class({.speed = kNan}, {}).size(), 1U);
}

TEST(AutoFidelityCache, AVelocityIsOfTheClassOfItsAngles) {
  const Launch by_angles{.speed = 300, .elevation = 0.3, .azimuth = -0.4};
  const Launch by_velocity{.velocity = fly(bullet_308(), by_angles).at(0).velocity};
  const auto expected = launch_class(by_angles, {}), found = launch_class(by_velocity, {});
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_FALSE(found[i].velocity);
    EXPECT_EQ(found[i].speed, expected[i].speed);
    EXPECT_EQ(found[i].elevation, expected[i].elevation);
    EXPECT_EQ(found[i].azimuth, expected[i].azimuth);
  }
}

TEST(AutoFidelityCache, LaunchesBetweenTheCornersKeepTheWord) {
  AutoFidelityCache cache;
  const auto choice = must(cache.cheapest_within(bullet_308(), kLaunch, {}, kPurpose));
  const std::vector<Launch> corners = launch_class(kLaunch, {});
  for (const double part : {0.2, 0.5, 0.9}) {
    Launch launch = kLaunch;
    launch.speed = corners[0].speed + part * (corners[7].speed - corners[0].speed);
    launch.elevation = corners[0].elevation + part * (corners[7].elevation - corners[0].elevation);
    const Until until{.ground = std::nullopt, .time = kPurpose.time};
    const Flight truth = fly(bullet_308(), launch, {}, Fidelity::reference(), {}, until);
    const Flight flight = fly_chosen(bullet_308(), launch, {}, *choice, until);
    double error = 0;
    for (int i = 0; i <= 200; ++i) {
      const double time = kPurpose.time * i / 200;
      error = std::max(error, length(flight.at(time).position - truth.at(time).position));
    }
    EXPECT_LE(error, kPurpose.error);
  }
}

}  // namespace physim::flight_auto_fidelity_cache_test
