// When emitters fire: rates and bursts counted over a million seconds, moments against their closed forms, the order of
// sources, and what never fires.
#include "emit/timeline.hpp"

#include "emit/statistics.hpp"
#include "random_shots.hpp"
#include "support.hpp"

namespace physim::emit_timeline_test {

using test::kInfinity;
using test::near;

constexpr double kMillion = 1e6;  // [s]

/// An emitter with no rate of its own.
EmitterDef silent() { return {.per_second = {0}}; }

/// The moments of a play up to a time, the time included.
struct Played {
  std::vector<EmitMoment> moments;
  bool over = false;

  Played(const EmitterDef& def, double until, std::uint64_t play = 0, std::uint64_t seed = 5) {
    const Emission emission(def, seed);
    const Timeline timeline(emission);
    TimelineState state = timeline.begin(play);
    double before = 0;
    for (;;) {
      const auto next = timeline.next(state);
      over = !next;
      if (over || next->time > until) return;
      EXPECT_GE(next->time, before);
      EXPECT_TRUE(next->phase >= 0 && next->phase <= 1 && next->count > 0);
      before = next->time;
      moments.push_back(*next);
      timeline.take(state);
    }
  }
  [[nodiscard]] std::uint64_t count() const {
    std::uint64_t sum = 0;
    for (const EmitMoment& m : moments) sum += m.count;
    return sum;
  }
};

TEST(Timeline, constant_rates_are_counted_exactly_over_a_million_seconds) {
  const std::pair<double, std::uint64_t> rates[] = {
      {1, 1'000'000}, {7.3, 7'300'000}, {0.37, 370'000}, {1.0 / 3, 333'333}, {0.1, 100'000}, {3e-6, 3}, {9e-7, 0}};
  for (const auto& [rate, births] : rates) {
    EmitterDef def = silent();
    def.per_second = {rate};
    def.cycle.duration = 3;
    const Played played(def, kMillion);
    EXPECT_EQ(played.count(), births) << rate;
    EXPECT_FALSE(played.over);
    for (std::size_t k = 0; k < played.moments.size(); k += 997)
      ASSERT_EQ(played.moments[k].time, (double(k) + 1) / rate);
  }
}

TEST(Timeline, a_rate_ends_with_the_duration_where_it_does_not_loop) {
  for (const double rate : {10.0, 7.3, 0.1}) {
    EmitterDef def = silent();
    def.per_second = {rate};
    def.cycle.looping = false;
    def.cycle.duration = 10'000;
    const Played played(def, kInfinity);
    EXPECT_EQ(played.count(), std::uint64_t(std::floor(rate * 10'000 + 1e-9))) << rate;
    EXPECT_TRUE(played.over);
    EXPECT_EQ(played.moments.back().phase, 1);
  }
}

TEST(Timeline, a_rate_by_a_curve_fires_where_its_integral_is_whole) {
  EmitterDef def = silent();
  def.per_second = {7.3, {}, test::parabola()};
  def.cycle.duration = 5;
  const double of_cycle = 7.3 * 5 * 2 / 3;
  const Played played(def, 3000);
  EXPECT_EQ(played.count(), std::uint64_t(of_cycle * 600 + 1e-9));
  for (std::size_t k = 0; k < played.moments.size(); ++k) {
    const double cycle = std::floor(played.moments[k].time / 5), x = played.moments[k].time / 5 - cycle;
    ASSERT_NEAR(cycle * of_cycle + 7.3 * 5 * test::under_parabola(x), double(k) + 1, 1e-9) << k;
    ASSERT_NEAR(played.moments[k].phase, x, 1e-9);
  }
}

TEST(Timeline, a_rate_by_a_curve_is_counted_exactly_over_a_million_seconds) {
  EmitterDef def = silent();
  def.per_second = {0.3, {}, test::parabola()};
  def.cycle.duration = 2;  // 0.4 births in a cycle
  EXPECT_EQ(Played(def, kMillion).count(), 200'000u);
  def.cycle.looping = false;
  def.per_second.value = 15;  // 20
  const Played once(def, kInfinity);
  EXPECT_EQ(once.count(), 20u);
  EXPECT_TRUE(once.over);
}

TEST(Timeline, births_of_a_pulse_wait_for_the_next_one) {
  // Five in the first half of each cycle of 5 s, nothing in the other: the fifth is at the end of the first half, and
  // not at the start of the next cycle, where rounding lets the sum of the rate fall short of it.
  EmitterDef def = silent();
  def.per_second = {8.0 / 3, {}, {{0, 1}, {0.25, 1}, {0.5, 0}, {1, 0}}};
  def.cycle.duration = 5;
  const Played played(def, 50'000);
  ASSERT_EQ(played.count(), 50'000u);
  for (std::size_t k = 0; k < played.moments.size(); ++k) {
    const double into = played.moments[k].time - 5 * double(k / 5);
    ASSERT_TRUE(k % 5 == 4 ? std::abs(into - 2.5) < 0.01 : into > 0 && into < 2) << k << " " << into;
    ASSERT_TRUE(k % 5 > 2 || near(into, double(k % 5 + 1) * 3 / 8, 1e-9)) << k << " " << into;
  }
}

TEST(Timeline, a_rate_between_two_is_drawn_once_a_cycle) {
  EmitterDef def = silent();
  def.per_second = {40, 80};
  const Played played(def, 50'000);
  std::vector<double> rates;
  double before = -1, sum = 0;
  for (std::size_t i = 1; i < played.moments.size(); ++i) {
    const EmitMoment &a = played.moments[i - 1], &b = played.moments[i];
    const double cycle = std::floor(b.time / 5);
    if (std::floor(a.time / 5) != cycle) continue;
    const double rate = 1 / (b.time - a.time);
    if (cycle != before) rates.push_back((rate - 40) / 40);
    ASSERT_NEAR((rate - 40) / 40, rates.back(), 1e-6) << b.time;
    before = cycle;
  }
  ASSERT_EQ(rates.size(), 10'000u);
  for (double& part : rates) sum += 5 * (40 + 40 * part), part = std::clamp(part, 0.0, 1.0);
  EXPECT_TRUE(test::evenly(rates));
  EXPECT_NEAR(double(played.count()), sum, 1.001);  // nothing is lost between cycles
  EXPECT_NE(Played(def, 10, 1).moments[0].time, played.moments[0].time);
}

TEST(Timeline, a_rate_between_two_curves_goes_on_from_cycle_to_cycle) {
  EmitterDef def = silent();
  def.per_second = {0, 3, {}, test::parabola()};
  const Played played(def, 100'000);  // each cycle has 10 u births
  EXPECT_NEAR(double(played.count()), 100'000, 5 * 10 * std::sqrt(20'000 / 12.0));
  EXPECT_NEAR(played.moments[0].time, Played(def, 1000).moments[0].time, 0);
}

TEST(Timeline, bursts_are_counted_exactly_over_a_million_seconds) {
  EmitterDef def = silent();
  def.cycle.duration = 2;
  def.bursts = {{.time = 0.5, .count = {5}, .cycles = 3, .interval = 0.1}};
  const Played played(def, kMillion);
  EXPECT_EQ(played.count(), 7'500'000u);
  for (std::size_t i = 0; i < played.moments.size(); i += 7)
    ASSERT_NEAR(played.moments[i].time, 2 * double(i / 3) + 0.5 + 0.1 * double(i % 3), 1e-9);
  def.cycle.looping = false;
  EXPECT_EQ(Played(def, kInfinity).count(), 15u);
}

TEST(Timeline, burst_cycles_of_0_go_on_to_the_end_of_the_cycle) {
  EmitterDef def = silent();
  def.cycle.duration = 2;
  def.bursts = {{.time = 0.5, .cycles = 0, .interval = 0.1}};
  EXPECT_EQ(Played(def, 1.9999).count(), 15u);  // 0.5, 0.6 ... 1.9
  EXPECT_EQ(Played(def, 2000 - 1e-6).count(), 15'000u);
  def.bursts[0].cycles = 100;  // those behind the end do not happen
  EXPECT_EQ(Played(def, 2000 - 1e-6).count(), 15'000u);
  def.bursts[0].time = 2;
  EXPECT_TRUE(Played(def, 1000).over);
}

TEST(Timeline, burst_probability_is_that_of_each_moment) {
  EmitterDef def = silent();
  def.cycle.duration = 1;
  def.bursts = {{.probability = 0.3}};
  const double n = kMillion;
  EXPECT_NEAR(double(Played(def, n - 0.5).count()), 0.3 * n, 4 * std::sqrt(0.21 * n));
  const auto first_of = [&def](std::uint64_t play) {  // the first hundred times, as one number
    double sum = 0;
    for (const EmitMoment& m : Played(def, 100, play).moments) sum = 1.01 * sum + m.time;
    return sum;
  };
  EXPECT_EQ(first_of(1), first_of(1));
  EXPECT_NE(first_of(1), first_of(2));
  def.bursts[0].probability = 1e-5;
  EXPECT_NEAR(double(Played(def, n - 0.5).count()), 10, 13);
  def.bursts[0].probability = 0;
  EXPECT_TRUE(Played(def, n).over);
}

TEST(Timeline, burst_count_is_drawn_and_rounded) {
  EmitterDef def = silent();
  def.cycle.duration = 1;
  def.bursts = {{.count = {-0.0, 3}}};  // 0 and 3 by half of what 1 and 2 come by
  const double n = 300'000;
  std::vector<double> counts(4);
  const Played played(def, n - 0.5);
  for (const EmitMoment& m : played.moments) ++counts[m.count];
  counts[0] = n - double(played.moments.size());
  EXPECT_TRUE(test::as_expected(counts, {n / 6, n / 3, n / 3, n / 6}));
  // Over the cycle by its curve.
  def.bursts = {{.count = {10, {}, {{0, 0}, {1, 1}}}, .cycles = 0, .interval = 0.1}};
  const Played rising(def, 0.99);
  ASSERT_EQ(rising.moments.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(rising.moments[i].count, i + 1);
}

TEST(Timeline, what_never_fires_is_over_at_once) {
  EmitterDef def = silent();
  EXPECT_TRUE(Played(def, kInfinity).over);
  def.bursts = {{.count = {0}}, {.count = {0.4}}, {.count = {5}, .probability = 0}, {.time = 9}};
  EXPECT_TRUE(Played(def, kInfinity).over);
  def.per_second = {10, {}, {{0, 0}, {1, 0}}};
  EXPECT_TRUE(Played(def, kInfinity).over);
  def.per_second = {0, 0.0};
  EXPECT_TRUE(Played(def, kInfinity).over);
  // One chance in 1e9 that a moment has something: it is given up, not searched for without end.
  def.bursts = {{.count = {0, 0.5000000001}}};
  EXPECT_TRUE(Played(def, kInfinity).over);
}

/// A count that follows a curve may be nothing at the moments of the burst, cycle after cycle: no search finds another.
TEST(Timeline, a_burst_whose_curve_is_nothing_at_its_moments_is_not_searched) {
  EmitterDef def = silent();
  def.cycle.duration = 1;
  const Curve fades{{0, 1}, {0.5, 0}, {1, 0}};
  for (const DrawnNumber& count : {DrawnNumber{10, {}, fades}, DrawnNumber{10, 20, fades, fades}}) {
    def.bursts = {{.time = 0.9, .count = count, .cycles = 2, .interval = 0.05}};
    const Emission emission(def, 5);
    const TimelineState state = Timeline(emission).begin(0);
    EXPECT_FALSE(Timeline(emission).next(state));
    EXPECT_EQ(state.taken[1], 0U);
    def.bursts[0].time = 0.4;
    EXPECT_FALSE(Played(def, 2).over);
  }
}

TEST(Timeline, sources_of_one_time_come_in_their_order) {
  EmitterDef def = silent();
  def.per_second = {1};
  def.cycle.duration = 10;
  def.bursts = {{.time = 1, .count = {7}, .cycles = 2, .interval = 1}, {.time = 1, .count = {8}}};
  def.gun.rounds_per_minute = 60;
  const Played played(def, 2);
  std::string order;
  for (const EmitMoment& m : played.moments)
    order += std::to_string(int(m.time)) + (m.is_round ? "g" : m.count > 1 ? std::to_string(m.count) : "r") + " ";
  EXPECT_EQ(order, "0g 1r 17 18 1g 2r 27 2g ");
}

TEST(Timeline, a_delay_moves_all_and_is_drawn_for_each_play) {
  EmitterDef def = silent();
  def.per_second = {4};
  def.bursts = {{.time = 0, .count = {3}}};
  def.gun.rounds_per_minute = 90;
  const Played prompt(def, 20);
  def.cycle.delay = {1.25};
  const Played late(def, 21.25);
  ASSERT_EQ(late.moments.size(), prompt.moments.size());
  for (std::size_t i = 0; i < late.moments.size(); ++i) {
    EXPECT_EQ(late.moments[i].time, 1.25 + prompt.moments[i].time);
    EXPECT_EQ(late.moments[i].phase, prompt.moments[i].phase);
  }
  def = silent();
  def.bursts = {{}};
  def.cycle.delay = {2, 6.0, {{0, 0}}};  // a curve does not count
  const Emission emission(def, 9);
  const Timeline timeline(emission);
  std::vector<double> parts;
  for (std::uint64_t play = 0; play < 20'000; ++play)
    parts.push_back((timeline.next(timeline.begin(play))->time - 2) / 4);
  EXPECT_TRUE(test::evenly(parts));
}

TEST(Timeline, cycles_begin_at_phase_0_whatever_rounding_does) {
  EmitterDef def = silent();
  def.bursts = {{.time = 0}};
  for (const double duration : {0.1, 0.3, 1.1, 3.3333}) {
    def.cycle.duration = duration;
    def.cycle.delay = {0.7};
    for (const EmitMoment& m : Played(def, 0.7 + 20'000 * duration).moments) ASSERT_EQ(m.phase, 0) << m.time;
  }
  const Emission emission(def, 1);
  const Timeline timeline(emission);
  EXPECT_NEAR(timeline.phase_at(0, 0.7 + 3.3333 * 5.25), 0.25, 1e-12);
  EXPECT_EQ(timeline.phase_at(0, 0.1), 0);
  def.cycle.looping = false;
  const Emission once(def, 1);
  EXPECT_EQ(Timeline(once).phase_at(0, 50), 1);
}

TEST(Timeline, a_state_goes_on_where_it_was_copied) {
  EmitterDef def = silent();
  def.per_second = {3, 5.0, test::parabola()};
  def.bursts = {{.count = {1, 4.0}, .cycles = 0, .interval = 0.37, .probability = 0.5}};
  def.gun = {.rounds_per_minute = 200, .magazine = 7, .reload = 2};
  const Emission emission(def, 77), again(def, 77);
  const Timeline timeline(emission), twin(again);
  TimelineState state = timeline.begin(2);
  for (int i = 0; i < 500; ++i) timeline.take(state);
  TimelineState copy = state;
  for (int i = 0; i < 500; ++i) {
    const EmitMoment a = *timeline.next(state), b = *twin.next(copy);
    ASSERT_TRUE(a.time == b.time && a.phase == b.phase && a.count == b.count && a.round == b.round) << i;
    timeline.take(state), twin.take(copy);
  }
  EXPECT_EQ(state, copy);
}

TEST(Timeline, steady_moments_taken_together_are_those_taken_one_by_one) {
  test::Random r(4);
  for (int round = 0; round < 300; ++round) {
    EmitterDef def{.per_second = {r.one_in(9) ? 0 : r.in(1, 500)}};
    if (r.one_in(6)) def.per_second.curve = {{0, 1}, {1, 2}};
    def.cycle.duration = r.in(0.1, 2), def.cycle.looping = r.one_in(2), def.cycle.delay = {r.one_in(2) ? 0.3 : 0};
    if (r.one_in(2)) def.bursts = {{.time = 0.05, .count = {3}, .cycles = 4, .interval = 0.01}};
    const Emission emission(def, 5);
    const Timeline timeline(emission);
    TimelineState one = timeline.begin(0), many = one;
    for (int part = 0; part < 20; ++part) {
      std::array<double, 32> time, phase;
      const std::size_t most = 1 + r.below(32);
      const std::size_t found = timeline.steady(many, std::span(time).first(most), std::span(phase).first(most));
      const std::size_t taken = found > 0 ? r.below(static_cast<int>(found) + 1) : 0;
      timeline.take_steady(many, taken);
      for (std::size_t i = 0; i < taken; ++i) {
        const auto next = timeline.next(one);
        ASSERT_TRUE(next && next->count == 1 && !next->is_round);
        ASSERT_EQ(next->time, time[i]);
        ASSERT_EQ(next->phase, phase[i]);
        timeline.take(one);
      }
      ASSERT_EQ(one, many);
      if (found == 0 && timeline.next(one)) timeline.take(one), timeline.take(many);
    }
  }
}

}  // namespace physim::emit_timeline_test
