// Studies that end when a time is up: it chooses how many shots there are, and nothing else.
#include <chrono>

#include "study_support.hpp"

namespace physim::study_until_time_test {

using namespace test;

Study cloud(Sampling sampling) {
  Study study = scatter();
  study.sampling = sampling;
  study.shard_shots = 64;
  study.shots = 64 * 4096;
  study.targets = {{"circle", CircleTarget{{}, 1}}};
  return study;
}

/// The time is up when it was asked for so often.
std::function<bool()> after(int times) {
  return [left = times]() mutable { return --left < 0; };
}

/// All that a study comes to, to be compared.
void expect_same(const StudyResult& a, const StudyResult& b) {
  EXPECT_EQ(a.shots, b.shots);
  EXPECT_EQ(a.quantities, b.quantities);
  EXPECT_EQ(a.hits, b.hits);
  EXPECT_EQ(a.worst, b.worst);
  EXPECT_EQ(a.covariance, b.covariance);
  ASSERT_EQ(a.stages.size(), b.stages.size());
  for (std::size_t i = 0; i < a.stages.size(); ++i) EXPECT_EQ(a.stages[i].distance.value, b.stages[i].distance.value);
}

TEST(StudyTime, chooses_the_count_alone) {
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    Study study = cloud(sampling);
    for (const unsigned threads : {1u, 2u, 7u}) {
      const auto pool = make_thread_pool(threads);
      const StudyPlan plan = plan_study(study, scattered).value();
      const auto ended = must(run_study(plan, pool.get(), {.time_is_up = after(37)}));
      EXPECT_TRUE(ended.time_was_up);
      EXPECT_EQ(ended.shards, sampling == Sampling::random ? 37U : 48U) << "whole rounds of 16 replicates";
      Study fixed = study;
      fixed.shots = ended.shots;
      const StudyResult whole = result_of(fixed, scattered);
      EXPECT_FALSE(whole.time_was_up);
      expect_same(ended, whole);
    }
  }
}

TEST(StudyTime, leaves_one_round_at_least) {
  const StudyPlan random = plan_study(cloud(Sampling::random), scattered).value();
  EXPECT_EQ(run_study(random, nullptr, {.time_is_up = after(0)})->shards, 1U);
  const StudyPlan sobol = plan_study(cloud(Sampling::sobol), scattered).value();
  EXPECT_EQ(run_study(sobol, nullptr, {.time_is_up = after(0)})->shards, 16U);
  EXPECT_EQ(run_study(sobol, nullptr, {.time_is_up = after(16)})->shards, 16U);
}

/// A study that is gone on with, that has holes, and one that comes to its end before.
TEST(StudyTime, is_up_in_studies_that_were_begun) {
  for (const Sampling sampling : {Sampling::random, Sampling::sobol}) {
    const Study study = cloud(sampling);
    const StudyPlan plan = plan_study(study, scattered).value();
    const auto begun = run_shards(plan, 0, 21), apart = run_shards(plan, 24, 76);
    const auto both = must(merge(*begun, *apart));
    const auto ended = must(run_study(plan, nullptr, {.so_far = both, .time_is_up = after(2)}));
    EXPECT_EQ(ended.shards, sampling == Sampling::random ? 23U : 96U) << "0 to 23 and those up to 99 that were there";
    Study fixed = study;
    fixed.shots = ended.shots;
    expect_same(ended, result_of(fixed, scattered));
    Study few = study;
    few.shots = 64 * 16;
    const auto whole = run_study(plan_study(few, scattered).value(), nullptr, {.time_is_up = after(16)});
    EXPECT_FALSE(whole->time_was_up) << "it had as many shots as it wanted";
  }
}

TEST(StudyTime, or_a_width_whichever_is_first) {
  Study study = cloud(Sampling::random);
  study.until_width = StudyWidth{.width = 2 * 1.96 / std::sqrt(64 * 60.0)};
  const StudyPlan plan = plan_study(study, scattered).value();
  const auto width = run_study(plan, nullptr, {.time_is_up = after(1000)});
  EXPECT_TRUE(width->width_reached && !width->time_was_up);
  EXPECT_EQ(width->shards, 64U);
  const auto time = run_study(plan, nullptr, {.time_is_up = after(40)});
  EXPECT_TRUE(time->time_was_up && !time->width_reached);
  EXPECT_EQ(time->shards, 40U);
}

/// By a clock, as a program has one.
TEST(StudyTime, by_a_clock) {
  const StudyPlan plan = plan_study(cloud(Sampling::random), scattered).value();
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
  const StudyOptions options{.time_is_up = [end] { return std::chrono::steady_clock::now() > end; }};
  const auto result = must(run_study(plan, nullptr, options));
  EXPECT_TRUE(result.time_was_up || result.shards == plan.shards());
}

/// What rounding errors alone move has no variance to have a share of.
TEST(StudyIndices, of_what_does_not_vary_are_none) {
  Study study = cloud(Sampling::random);
  study.indices = true;
  study.quantities = {StudyQuantity::right, StudyQuantity::up};
  const StudyResult run =
      result_of(study, [](std::span<const std::span<const double>> in, std::span<const std::span<double>> out) {
        for (std::size_t i = 0; i < out[0].size(); ++i) out[0][i] = in[0][i], out[1][i] = 300 + 1e-15 * in[1][i];
      });
  EXPECT_TRUE(run.quantities[0].varies());
  EXPECT_FALSE(run.quantities[1].varies());
  EXPECT_NEAR(run.indices[0].first[0].value, 1, 0.05);
  EXPECT_TRUE(std::isnan(run.indices[0].first[1].value) && std::isnan(run.indices[1].total[1].error));
}

}  // namespace physim::study_until_time_test
