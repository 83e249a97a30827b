// Histograms of what studies counted, against the bell curve, lists of values and shots counted one by one.
#include "study_support.hpp"

namespace physim::study_histogram_test {

using namespace test;

double below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

TEST(StudyHistograms, are_those_of_the_bell_curve) {
  const StudyResult run = result_of(scatter(5, -3), scattered);
  const auto n = static_cast<double>(run.shots);
  for (std::size_t q = 0; q < 2; ++q) {
    const std::vector<HistogramBar> bars = run.quantities[q].cells.histogram(40);
    ASSERT_EQ(bars.size(), 40U);
    const double mean = q == 0 ? 5 : -3, width = 2 * 3.0902 / 38;
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < bars.size(); ++i) {
      const HistogramBar& bar = bars[i];
      const double p = below(bar.high - mean) - below(bar.low - mean);
      EXPECT_NEAR(static_cast<double>(bar.count), n * p, 4.5 * std::sqrt(n * p)) << q << ' ' << i;
      EXPECT_TRUE(i == 0 || bar.low == bars[i - 1].high);
      if (i > 0 && i + 1 < bars.size()) {
        EXPECT_NEAR(bar.high - bar.low, width, run.quantities[q].cells.error_at(bar.low) + 0.01 * width);
      }
      all += bar.count;
    }
    EXPECT_EQ(all, run.shots);
    EXPECT_LE(bars.front().low, run.quantities[q].least);
    EXPECT_GE(bars.back().high, run.quantities[q].most);
  }
}

/// Counts are exact: those of shots that are flown again and counted one by one.
TEST(StudyHistograms, count_each_shot_once) {
  Study study = scatter();
  study.shots = study.shard_shots = 4096;
  const StudyPlan plan = plan_study(study, scattered).value();
  const std::vector<double> right = fly_shots_of(plan, 0).quantities[0];
  for (const std::size_t asked : {3u, 12u, 100u}) {
    const std::vector<HistogramBar> bars = run_study(plan)->quantities[0].cells.histogram(asked);
    EXPECT_EQ(bars.size(), asked);
    for (const HistogramBar& bar : bars) {
      const auto inside = [&](double x) { return x >= bar.low && x < bar.high; };
      EXPECT_EQ(bar.count, static_cast<std::uint64_t>(std::ranges::count_if(right, inside))) << bar.low;
    }
  }
}

/// Bars at the ends have what lies beyond; where an outermost cell has more there is none.
TEST(StudyHistograms, have_two_thousandths_at_most_at_each_end) {
  CountedCells cells{.counts = {19, 4990, 4991}};
  EXPECT_EQ(cells.histogram(3).front().count, 19U);
  cells.counts = {21, 4990, 4989};
  EXPECT_EQ(cells.histogram(3).size(), 1U);
  cells.counts = {4990, 4991, 19};
  EXPECT_EQ(cells.histogram(3).back().count, 19U);
  cells.counts = {8, 8, 4992, 4992};
  EXPECT_EQ(cells.histogram(3).front().count, 8U);
}

TEST(StudyHistograms, of_few_values_have_their_bars) {
  Study study = scatter();
  study.inputs[0].distribution = DiscreteDistribution{{1, 2, 4}, {1, 2, 1}};
  study.shots = 40'960;
  const StudyResult run = result_of(study, scattered);
  std::vector<std::uint64_t> counts;
  for (const HistogramBar& bar : run.quantities[0].cells.histogram(30))
    if (bar.count > 0) counts.push_back(bar.count);
  ASSERT_EQ(counts.size(), 3U);
  EXPECT_NEAR(static_cast<double>(counts[1]), 20'480, 4 * std::sqrt(10'240.0));
  study.inputs[0].distribution = DiscreteDistribution{{7}};
  const std::vector<HistogramBar> one = result_of(study, scattered).quantities[0].cells.histogram(30);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].count, 40'960U);
  EXPECT_TRUE(one[0].low <= 7 && 7 <= one[0].high);
  EXPECT_TRUE(CountedCells{}.histogram(10).empty());
  const CountedCells& cells = run.quantities[1].cells;
  EXPECT_EQ(cells.histogram(SIZE_MAX), cells.histogram(CountedCells::kMostBars)) << "no more than cells";
  EXPECT_LE(cells.histogram(SIZE_MAX).size(), cells.counts.size());
  EXPECT_EQ(run.quantities[1].cells.histogram(0), run.quantities[1].cells.histogram(3)) << "fewer are none";
}

/// Quantiles are those of the shots, however far from the aim they come down, and never beyond the least and the most.
TEST(StudyHistograms, radii_from_a_far_aim_are_as_fine_as_from_a_near_one) {
  const StudyResult far = result_of(scatter(0, 8000), scattered);
  ASSERT_TRUE(far.from_aim);
  EXPECT_NEAR(far.from_aim->r50, 8000, 0.02);
  EXPECT_NEAR(far.from_aim->r95, 8000 + 1.645, 0.03);  // of the bell curve along the direction from the aim
  Study rolls = scatter();
  rolls.inputs = {input("right", UniformDistribution{1, 7}), input("up", UniformDistribution{0, 1e-9})};
  const StudyResult run = result_of(rolls, scattered);
  for (const QuantityResult& q : run.quantities)
    for (const double p : {0.0, 0.05, 0.95, 1.0}) {
      EXPECT_GE(q.cells.quantile(p), q.least);
      EXPECT_LE(q.cells.quantile(p), q.most);
    }
}

}  // namespace physim::study_histogram_test
