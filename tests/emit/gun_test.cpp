// Guns: when rounds leave against a loop that simulates the gun, barrels, convergence, dispersion, recoil, tracers.
#include "emit/gun.hpp"

#include "emit/statistics.hpp"
#include "emit/timeline.hpp"
#include "math/normal.hpp"
#include "support.hpp"

namespace physim::emit_gun_test {

using test::kInfinity;
using test::near;

EmitterDef with_gun(const GunDef& gun) { return {.per_second = {0}, .gun = gun}; }

std::vector<double> times_of(const EmitterDef& def, std::size_t most) {
  const Emission emission(def, 1);
  const Timeline timeline(emission);
  TimelineState state = timeline.begin(0);
  std::vector<double> times;
  for (auto next = timeline.next(state); next && times.size() < most; next = timeline.next(state)) {
    EXPECT_TRUE(next->is_round && next->count == 1 && next->round == times.size());
    times.push_back(next->time);
    timeline.take(state);
  }
  return times;
}

/// Pulls the trigger, round by round.
std::vector<double> simulated(const GunDef& gun, std::size_t most) {
  std::vector<double> times;
  double clock = 0;
  std::uint32_t in_burst = 0, in_magazine = 0, magazine = 0;
  while (times.size() < most) {
    times.push_back(clock);
    double wait = 60 / gun.rounds_per_minute;
    if (gun.burst_rounds > 0 && ++in_burst == gun.burst_rounds) wait += gun.burst_pause, in_burst = 0;
    if (gun.magazine > 0 && ++in_magazine == gun.magazine) {
      wait = std::max(wait, gun.reload);
      in_magazine = in_burst = 0;
      if (++magazine == gun.magazines) break;
    }
    clock += wait;
  }
  return times;
}

TEST(Gun, rounds_leave_as_a_simulated_gun_fires_them) {
  const GunDef guns[] = {{.rounds_per_minute = 600},
                         {.rounds_per_minute = 733, .burst_rounds = 3, .burst_pause = 0.4},
                         {.rounds_per_minute = 900, .magazine = 30, .reload = 2.1},
                         {.rounds_per_minute = 900, .magazine = 30, .reload = 2.1, .magazines = 7},
                         {.rounds_per_minute = 450, .burst_rounds = 4, .burst_pause = 0.7, .magazine = 30, .reload = 3},
                         {.rounds_per_minute = 450, .burst_rounds = 5, .burst_pause = 0.7, .magazine = 30, .reload = 0},
                         {.rounds_per_minute = 60, .magazine = 1, .reload = 0.1, .magazines = 4}};
  for (const GunDef& gun : guns) {
    const auto times = times_of(with_gun(gun), 3000), expected = simulated(gun, 3000);
    ASSERT_EQ(times.size(), expected.size()) << gun.rounds_per_minute;
    for (std::size_t i = 0; i < times.size(); ++i) ASSERT_TRUE(near(times[i], expected[i], 1e-12, 1e-12)) << i;
  }
}

TEST(Gun, rounds_per_minute_are_counted_exactly_over_a_million_seconds) {
  EmitterDef def = with_gun({.rounds_per_minute = 100});
  def.cycle = {.duration = 1e6, .looping = false};
  const auto times = times_of(def, 10'000'000);
  ASSERT_EQ(times.size(), 1'666'667u);  // the first at 0, the last 0.4 s before the end
  EXPECT_EQ(times.back(), 999'999.6);
}

TEST(Gun, magazines_and_the_duration_end_it) {
  EmitterDef def = with_gun({.rounds_per_minute = 60, .magazine = 3, .magazines = 2});
  EXPECT_EQ(times_of(def, 100).size(), 6u);
  def.cycle = {.duration = 4, .looping = false};
  EXPECT_EQ(times_of(def, 100).size(), 4u);  // 0, 1, 2, 3
  def.gun.magazines = 0;
  def.cycle.looping = true;
  EXPECT_EQ(times_of(def, 100).size(), 100u);
}

TEST(Gun, every_so_manyth_round_is_a_tracer) {
  EmitterDef def = with_gun({.rounds_per_minute = 60, .tracer_every = 5});
  const Emission emission(def, 1);
  for (std::uint64_t k = 0; k < 20; ++k) {
    EXPECT_EQ(emission.newborn({.number = k, .is_round = true, .round = k}).tracer, k % 5 == 4) << k;
    EXPECT_FALSE(emission.newborn({.number = k}).tracer);
  }
}

TEST(Gun, barrels_fire_in_turn) {
  const Emission emission(
      with_gun({.rounds_per_minute = 60, .barrels = {{{0, 0.1, -0.2}}, {{0.3, 0, 0.2}}, {{0, -1, 0}}}}), 1);
  for (std::uint64_t k = 0; k < 9; ++k) {
    const Newborn n = emission.newborn({.number = k, .is_round = true, .round = k});
    EXPECT_EQ(n.place, emission.def().gun.barrels[k % 3].position);
    EXPECT_EQ(n.direction, (Vec3d{1, 0, 0}));
  }
}

TEST(Gun, the_lines_of_all_barrels_meet_at_the_convergence) {
  const Emission emission(with_gun({.rounds_per_minute = 60,
                                    .barrels = {{{0, 0.1, -2}}, {{0.3, 0, 2}}, {{0, -90, 40}}, {{}}},
                                    .convergence = 250}),
                          1);
  for (std::uint64_t k = 0; k < 4; ++k) {
    const Newborn n = emission.newborn({.number = k, .is_round = true, .round = k});
    const Vec3d way = Vec3d{250, 0, 0} - n.place;
    EXPECT_LT(length(cross(n.direction, way)), 1e-12) << k;
    EXPECT_GT(dot(n.direction, way), 0);
    EXPECT_NEAR(length(n.direction), 1, 1e-15);
  }
}

TEST(Gun, dispersion_is_normal_to_each_side_and_up_and_down) {
  for (const double sigma : {0.002, 0.2}) {
    const Emission emission(with_gun({.rounds_per_minute = 60, .dispersion = sigma}), 8);
    std::vector<std::array<double, 2>> parts;
    double squares[2] = {};
    for (std::uint64_t k = 0; k < test::kSamples; ++k) {
      const Vec3d d = emission.newborn({.number = k, .is_round = true, .round = k}).direction;
      ASSERT_NEAR(length(d), 1, 4e-15);
      const double across = std::hypot(d.y, d.z), off = std::atan2(across, d.x);
      const double up = off * d.y / across, right = off * d.z / across;
      squares[0] += up * up, squares[1] += right * right;
      parts.push_back({normal_cdf(up / sigma), normal_cdf(right / sigma)});
    }
    EXPECT_TRUE(test::evenly_together(parts)) << sigma;
    // A variance of a normal number has the relative deviation sqrt(2 / n).
    for (const double sum : squares)
      EXPECT_NEAR(std::sqrt(sum / test::kSamples) / sigma, 1, 4 * std::sqrt(0.5 / test::kSamples));
  }
}

TEST(Gun, recoil_climbs_over_a_burst_or_a_magazine) {
  GunDef gun{.rounds_per_minute = 600, .burst_rounds = 5, .recoil_up = {{0, 0}, {1, 1}}, .recoil = 0.02};
  const auto direction = [&gun](std::uint64_t k) {
    return Emission(with_gun(gun), 1).newborn({.number = k, .is_round = true, .round = k}).direction;
  };
  for (std::uint64_t k = 0; k < 12; ++k) {
    EXPECT_NEAR(std::atan2(direction(k).y, direction(k).x), 0.02 * double(k % 5) / 4, 1e-15) << k;
    EXPECT_EQ(direction(k).z, 0);
  }
  gun.burst_rounds = 0;
  gun.magazine = 11;
  gun.recoil_right = {{0, 1}};
  for (std::uint64_t k = 0; k < 25; ++k) {
    const Vec3d d = direction(k);
    const double off = std::acos(std::min(d.x, 1.0)), across = std::hypot(d.y, d.z);
    EXPECT_NEAR(off * d.y / across, 0.02 * double(k % 11) / 10, 1e-9) << k;
    EXPECT_NEAR(off * d.z / across, 0.02, 1e-9) << k;
  }
}

TEST(Gun, rounds_come_out_of_the_shape_at_their_barrel) {
  EmitterDef def = with_gun({.rounds_per_minute = 60, .barrels = {{{1, 2, 3}}}, .convergence = 50});
  def.from = {.shape = EmitShape::cone, .radius = 0.5, .angle = 0.1, .thickness = 0};
  const Vec3d line = normalized(Vec3d{50, 0, 0} - Vec3d{1, 2, 3});
  const Emission emission(def, 4);
  for (std::uint64_t k = 0; k < 100; ++k) {
    const Newborn n = emission.newborn({.number = k, .is_round = true, .round = k});
    EXPECT_NEAR(dot(n.direction, line), std::cos(0.1), 1e-14);
    EXPECT_NEAR(length(n.place - Vec3d{1, 2, 3}), 0.5, 1e-14);
    EXPECT_NEAR(dot(n.place - Vec3d{1, 2, 3}, line), 0, 1e-14);
  }
}

}  // namespace physim::emit_gun_test
