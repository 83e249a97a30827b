// What follows from coming to the ground, asked by who knows nothing but gravity: bounces, rolling, lying, leaving.
#include "world/step/ground_contact.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "prepare/conditions.hpp"

namespace physim::world_ground_contact_test {

constexpr double kG = 9.80665, kStep = 0.02;

/// A stone on a flat Earth.
struct Stone {
  Conditions<double> known = prepare_conditions({}, Fidelity{});
  Vec3d pull{0, -kG, 0};
  OwnSurface own{1, 1, 0, {}};
  std::vector<EventKind> told;

  [[nodiscard]] const Conditions<double>& conditions() const { return known; }
  [[nodiscard]] OwnSurface surface() const { return own; }
  [[nodiscard]] static double step_length() { return kStep; }
  [[nodiscard]] Vec3d acceleration_at(const State<double>&, double) const { return pull; }
  void tell(EventKind kind, Reason, double, const State<double>&) { told.push_back(kind); }
};

/// A stone that came to a ground at height 2 with some velocity.
struct Landing {
  explicit Landing(const Ground& of, const Vec3d& velocity, const Stone& who = {}) : stone(who), ground(of) {
    const Vec3d x{7, 2, 0};
    after = contacts.struck({x, velocity}, contacts.up_at(x), 0.005);
  }
  Stone stone;
  Ground ground;
  StepParts parts{kStep, false};
  GroundContacts<Stone> contacts{stone, ground, parts};
  GroundContacts<Stone>::After after{};
};
using Then = GroundContacts<Stone>::Then;
constexpr Ground kHard{GroundMode::bounce, 2, 0.5, 0};

TEST(GroundContacts, what_falls_fast_bounces_by_restitution_and_friction) {
  const Landing landing({GroundMode::bounce, 2, 0.5, 0.2}, {10, -4, 0});
  EXPECT_EQ(landing.after.then, Then::flies_on);
  EXPECT_NEAR(landing.after.state.v.y, 2, 1e-12);             // 0.5 of it
  EXPECT_NEAR(landing.after.state.v.x, 10 - 0.2 * 6, 1e-12);  // the impulse along is mu times that across, (1 + e) v
  EXPECT_EQ(landing.stone.told, std::vector{EventKind::bounced});
}

TEST(GroundContacts, a_bounce_that_is_over_within_the_step_rolls) {
  const double least = 0.5 * kG * kStep;  // a throw straight up with v is back after 2 v / g
  EXPECT_EQ(Landing(kHard, {3, -2 * least * 1.01, 0}).after.then, Then::flies_on);
  const Landing rolls(kHard, {3, -2 * least * 0.99, 0});
  EXPECT_EQ(rolls.after.then, Then::rolls);
  EXPECT_EQ(rolls.after.state.v, (Vec3d{3, 0, 0}));
  EXPECT_NEAR(rolls.after.rolled.x.x, 7 + 3 * (kStep - 0.005), 1e-12);
  EXPECT_NEAR(rolls.after.rolled.x.y, 2, 1e-12);
  EXPECT_TRUE(rolls.stone.told.empty());  // it fell no higher than in a step
}

TEST(GroundContacts, rolling_resistance_takes_its_part) {
  Stone stone;
  stone.own.rolling_resistance = 0.3;
  const Landing rolls(kHard, {3, 0, 0}, stone);
  EXPECT_EQ(rolls.after.then, Then::rolls);
  EXPECT_NEAR(rolls.after.rolled.v.x, 3 - 0.3 * kG * (kStep - 0.005), 1e-12);
}

TEST(GroundContacts, what_is_lifted_flies_on_without_a_bounce) {
  Stone stone;
  stone.pull = {0, 1, 0};
  const Landing lifted({GroundMode::bounce, 2, 0, 0}, {3, -1, 0}, stone);
  EXPECT_EQ(lifted.after.then, Then::flies_on);
  EXPECT_EQ(lifted.after.state.v.y, 0);
}

TEST(GroundContacts, land_and_stick_tell_that_it_landed) {
  const Landing stops({GroundMode::land, 2}, {3, -1, 0}), sticks({GroundMode::stick, 2}, {3, -1, 0});
  EXPECT_EQ(stops.after.then, Then::stops);
  EXPECT_EQ(sticks.after.then, Then::sticks);
  EXPECT_EQ(stops.stone.told, std::vector{EventKind::landed});
  EXPECT_EQ(sticks.stone.told, std::vector{EventKind::landed});
}

TEST(GroundContacts, who_may_bounce_no_more_rolls) {
  Landing landing(kHard, {3, -4, 0});
  for (int i = 0; landing.after.then == Then::flies_on; ++i) {
    ASSERT_LT(i, 16);
    landing.after = landing.contacts.struck({{7, 2, 0}, {3, -4, 0}}, {0, 1, 0}, 0.005);
  }
  EXPECT_EQ(landing.after.then, Then::rolls);
}

TEST(GroundContacts, a_step_begins_in_the_ground_only_on_the_way_down) {
  const Landing on(kHard, {0, -1, 0}), none({GroundMode::none, 2}, {0, -1, 0});
  const auto begins = [](const Landing& l, double y, double v) {
    return l.contacts.is_met_at_start({{0, y, 0}, {0, v, 0}});
  };
  EXPECT_TRUE(begins(on, 2, -1));
  EXPECT_TRUE(begins(on, 1, 0));  // gravity pulls it down
  EXPECT_FALSE(begins(on, 1, 1));
  EXPECT_FALSE(begins(on, 2.001, -1));
  EXPECT_FALSE(begins(none, 1, -1));
}

TEST(GroundContacts, what_slid_below_the_ground_lies_on_it) {
  const Landing on(kHard, {0, -1, 0});
  const State<double> lying = on.contacts.lying({{5, 1.999, 0}, {1, -2, 0}});
  EXPECT_NEAR(lying.x.y, 2, 1e-12);
  EXPECT_EQ(lying.v, (Vec3d{1, 0, 0}));
  const State<double> above{{5, 2.5, 0}, {1, -2, 0}};
  EXPECT_EQ(on.contacts.lying(above).v, above.v);
}

}  // namespace physim::world_ground_contact_test
