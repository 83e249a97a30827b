// Emitters that a projectile leads: along its curve, through its bounces, and up to where it turns back.
#include <gtest/gtest.h>

#include <cmath>

#include "world/emitter_support.hpp"

namespace physim {
namespace {

constexpr double kG = 9.80665;

/// Marks that stay where they are born.
EmitterDef marks(World& world) {
  EmitterDef def;
  def.kind = kind_of(world, spark(), {.use_gravity = false});
  def.per_second = {0};
  def.start.speed = {0};
  return def;
}

/// A stone in a vacuum that is thrown up from the ground and bounces off it, by its closed form.
struct Bouncing {
  double along, up, restitution;

  [[nodiscard]] Vec3d at(double time) const {
    double v = up, since = time;
    for (; since > 2 * v / kG; v *= restitution) since -= 2 * v / kG;
    return {along * time, v * since - kG / 2 * since * since, 0};
  }
};

World bouncing_world() { return make_world({.ground = {.mode = GroundMode::bounce, .friction = 0}}); }

ProjectileId thrown(World& world, const Bouncing& stone) {
  const KindId kind = kind_of(world, spark(), {.restitution = stone.restitution, .friction = 0});
  return *world.spawn(kind, {.velocity = Vec3d{stone.along, stone.up, 0}});
}

TEST(EmitterLed, births_are_where_the_bouncing_one_was) {
  const Bouncing stone_at{6, 5, 0.8};
  for (const int rate : {7, 24, 144, 1000}) {
    World world = bouncing_world();
    EmitterDef def = marks(world);
    def.follows = thrown(world, stone_at);
    def.per_second = {50};
    const EmitterId id = added(world, def);
    step_to(world, 3, rate);
    const auto all = alive(world, id);
    ASSERT_GE(all.size(), 149u);
    for (const auto& [number, state] : all) {
      const double time = static_cast<double>(number + 1) / 50;
      EXPECT_LT(length(state.position - stone_at.at(time)), 1e-9) << rate << " frames a second, " << time << " s";
    }
  }
}

/// The length of a stone's way: the integral of sqrt(a^2 + u^2) over each parabola, u the speed upwards [m].
double way_of(const Bouncing& stone, double time) {
  const auto part = [&](double u) {
    const double a = stone.along;
    return (u * std::sqrt(a * a + u * u) + a * a * std::asinh(u / a)) / (2 * kG);
  };
  double sum = 0, up = stone.up, since = time;
  for (; since > 2 * up / kG; up *= stone.restitution) {
    sum += part(up) - part(-up);
    since -= 2 * up / kG;
  }
  return sum + part(up) - part(up - kG * since);
}

TEST(EmitterLed, metres_are_those_of_the_curve) {
  const Bouncing stone_at{6, 5, 0.8};
  for (const int rate : {7, 24, 144}) {
    World world = bouncing_world();
    EmitterDef def = marks(world);
    def.follows = thrown(world, stone_at);
    def.per_metre = 2;
    const EmitterId id = added(world, def);
    step_to(world, 3, rate);
    const auto all = alive(world, id);
    ASSERT_GT(all.size(), 35u);
    for (const auto& [number, state] : all)
      EXPECT_NEAR(way_of(stone_at, state.position.x / stone_at.along), 0.5 * static_cast<double>(number + 1), 1e-6)
          << rate << " frames a second";
  }
}

TEST(EmitterLed, who_is_thrown_straight_up_counts_the_way_up_and_down) {
  constexpr double kUp = 10, kApex = kUp * kUp / (2 * kG);
  for (const int rate : {7, 24, 144}) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = marks(world);
    def.follows = *world.spawn(kind_of(world, spark()), {.velocity = Vec3d{0, kUp, 0}});
    def.per_metre = 4;
    const EmitterId id = added(world, def);
    step_to(world, 2, rate);
    const auto all = alive(world, id);
    ASSERT_GT(all.size(), 35u);
    for (const auto& [number, state] : all) {
      const double way = static_cast<double>(number + 1) / 4;
      // Its speed has a corner where it turns back, which a quadrature over parts of a frame rounds off.
      EXPECT_NEAR(state.position.y, way < kApex ? way : 2 * kApex - way, way < kApex - 0.3 ? 1e-9 : 2e-4) << rate;
    }
  }
}

}  // namespace
}  // namespace physim
