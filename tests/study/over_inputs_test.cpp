// How likely targets are hit over each input, held to integrals; the bits and bytes of it.
#include "study_support.hpp"

namespace physim::study_over_inputs_test {

using namespace test;

constexpr std::uint32_t kParts = 8;

/// Normal impacts on a circle of one deviation, and a half-plane that depends on the first input alone.
Study circle(Sampling sampling = Sampling::random) {
  Study study = scatter();
  study.sampling = sampling;
  study.targets = {{"circle", CircleTarget{{}, 1}}, {"right half", RectangleTarget{{500, 0}, 1000, 1000}}};
  study.over_inputs = kParts;
  study.shots = 400'000;
  return study;
}

/// P(x^2 + y^2 <= 1) of normal y, over x normal within two ends: by Simpson's rule.
double within_circle(double low, double high) {
  low = std::max(low, -8.0), high = std::min(high, 8.0);
  constexpr int kSteps = 4000;
  double hits = 0, all = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = low + (high - low) * i / kSteps, weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
    const double density = weight * std::exp(-0.5 * x * x);
    all += density;
    if (x * x < 1) hits += density * std::erf(std::sqrt(1 - x * x) / std::sqrt(2.0));
  }
  return hits / all;
}

TEST(StudyOverInputs, are_integrals_over_parts) {
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    const StudyResult run = result_of(circle(sampling), scattered);
    ASSERT_EQ(run.over_inputs.size(), 2U);
    const HitsOverInput& over = run.over_inputs[0];
    ASSERT_EQ(over.parts.size(), kParts);
    EXPECT_EQ(over.parts.front().low, -kInfinity);
    EXPECT_EQ(over.parts.back().high, kInfinity);
    EXPECT_NEAR(over.parts[4].low, 0, 1e-12);
    for (const InputPart& part : over.parts) {
      const HitResult& hit = part.hits[0];
      EXPECT_TRUE(within_4_errors(hit.probability.value, within_circle(part.low, part.high),
                                  std::max(hit.probability.error, 1e-6)))
          << name(sampling) << ' ' << part.middle;
      EXPECT_LE(hit.low, hit.probability.value);
      EXPECT_GE(hit.high, hit.probability.value);
      EXPECT_EQ(part.hits[1].probability.value, part.low >= -1e-12 ? 1 : 0) << "the half-plane begins between parts";
      EXPECT_NEAR(0.5 * std::erfc(-part.middle / std::sqrt(2.0)),
                  (0.5 + static_cast<double>(&part - &over.parts[0])) / 8, 1e-9);
    }
  }
}

/// Wilson's interval holds the true value in 95 % of studies.
TEST(StudyOverInputs, have_intervals_that_hold) {
  int held = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Study study = circle();
    study.seed = seed;
    study.shots = 2048;
    study.shard_shots = 256;
    const StudyResult run = result_of(study, scattered);
    for (const InputPart& part : run.over_inputs[1].parts) {
      const double expected = within_circle(part.low, part.high);
      held += part.hits[0].low <= expected && expected <= part.hits[0].high ? 1 : 0;
      ++all;
    }
  }
  EXPECT_NEAR(static_cast<double>(held) / all, 0.95, 4 * std::sqrt(0.95 * 0.05 / all));
}

TEST(StudyOverInputs, add_up_to_all_shots) {
  const StudyResult run = result_of(circle(), scattered);
  for (const HitsOverInput& over : run.over_inputs) {
    std::uint64_t shots = 0, hits = 0;
    for (const InputPart& part : over.parts) shots += part.shots, hits += part.hits[0].hits;
    EXPECT_EQ(shots, run.shots);
    EXPECT_EQ(hits, run.hits[0].hits);
  }
}

/// A list of measurements has as many parts as values that shots have.
TEST(StudyOverInputs, of_lists_are_their_values) {
  Study study = circle();
  study.inputs[0].distribution = DiscreteDistribution{{0, 0.5, 2}};
  study.shots = 40'000;
  const StudyResult run = result_of(study, scattered);
  const HitsOverInput& over = run.over_inputs[0];
  ASSERT_EQ(over.parts.size(), 3U);
  EXPECT_EQ(over.parts[0].low, 0);
  EXPECT_EQ(over.parts[1].low, 0.5);
  EXPECT_EQ(over.parts[2].low, 2);
  EXPECT_EQ(over.parts[2].hits[0].hits, 0U);
  EXPECT_NEAR(static_cast<double>(over.parts[1].shots), 40'000 / 3.0, 4 * std::sqrt(40'000 / 3.0));
}

TEST(StudyOverInputs, have_the_same_bits_however_they_are_flown) {
  Study study = circle(Sampling::latin_hypercube);
  study.shard_shots = 256;
  study.shots = 48 * 256;
  const StudyPlan plan = plan_study(study, scattered).value();
  StudyPart all;
  expect_one_set_of_bits(plan, all);
  EXPECT_EQ(result_of(plan, all, 48)->over_inputs, run_study(plan)->over_inputs);
}

/// Parts of studies that do not ask for it are smaller, and are no parts of those that do.
TEST(StudyOverInputs, are_told_apart_from_studies_without) {
  Study study = circle();
  study.shard_shots = 64;
  study.shots = 128;
  const StudyPlan with = plan_study(study, scattered).value();
  study.over_inputs.reset();
  const StudyPlan without = plan_study(study, scattered).value();
  const StudyPart a = run_shard(with, 0), b = run_shard(without, 1);
  EXPECT_FALSE(merge(a, b));
  EXPECT_LT(save_part(run_shard(without, 0)).size(), save_part(a).size());
  EXPECT_TRUE(run_study(without)->over_inputs.empty());
  const std::vector<std::byte> bytes = save_part(a);
  for (std::size_t i = 0; i < bytes.size(); i += 1 + bytes.size() / 300) {
    std::vector<std::byte> damaged = bytes;
    damaged[i] ^= std::byte{4};
    EXPECT_FALSE(load_part(damaged)) << i;
    EXPECT_FALSE(load_part(std::span(bytes).first(i))) << i;
  }
}

TEST(StudyOverInputs, bad_input) {
  const auto refusal = [](auto change) {
    Study study = circle();
    change(study);
    const auto plan = plan_study(study, scattered);
    return plan ? std::string() : plan.error().text();
  };
  EXPECT_NE(refusal([](Study& s) { s.over_inputs = 1; }).find("from 2 to 100"), std::string::npos);
  EXPECT_NE(refusal([](Study& s) { s.over_inputs = 101; }).find("over_inputs"), std::string::npos);
  EXPECT_NE(refusal([](Study& s) { s.targets.clear(); }).find("no target"), std::string::npos);
}

}  // namespace physim::study_over_inputs_test
