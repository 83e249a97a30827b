// Shares of the misses, by closed forms of normal impacts and beside sampling.
#include "study/misses.hpp"

#include "study/study_support.hpp"

namespace physim::test::study_misses_test {

/// The part of normal numbers farther than `from` from 0.
double beyond(double from, double deviation) { return std::erfc(from / (deviation * std::sqrt(2.0))); }

/// Wind and aim move the impact aside, the rifle in height.
Study three_inputs(double aside = 0) {
  return {.inputs = {input("wind", NormalDistribution{aside, 0.4}), input("aim", NormalDistribution{0, 0.3}),
                     input("rifle", NormalDistribution{0, 0.2})},
          .quantities = {StudyQuantity::right, StudyQuantity::up}};
}
void moved(std::span<const std::span<const double>> in, std::span<const std::span<double>> out) {
  for (std::size_t i = 0; i < out[0].size(); ++i) {
    out[0][i] = in[0][i] + in[1][i];
    out[1][i] = in[2][i] + 0.5 * in[0][i];
  }
}

LinearResult linear_of(const Study& study) {
  const auto plan = must(plan_study(study, moved));
  const auto linear = must(propagate_linearly(plan));
  return linear;
}

TEST(StudyMisses, of_a_strip_are_those_of_the_error_function) {
  Study study = three_inputs();
  study.targets = {{"strip", RectangleTarget{{}, 1, 1e6}}};
  const LinearResult linear = linear_of(study);
  EXPECT_NEAR(linear.rows[0].misses[0], 1 - beyond(0.5, 0.3) / beyond(0.5, 0.5), 1e-3);
  EXPECT_NEAR(linear.rows[1].misses[0], 1 - beyond(0.5, 0.4) / beyond(0.5, 0.5), 1e-3);
  EXPECT_EQ(linear.rows[2].misses[0], 0) << "what moves impacts along the strip alone costs no hit";
}

TEST(StudyMisses, parts_beside_circles_are_rayleighs) {
  Study study;
  for (const double radius : {0.5, 1.0, 2.0, 3.0}) study.targets.push_back({"circle", CircleTarget{{}, radius}});
  const std::vector<double> parts = Misses(study, {}, {1, 0, 1}).parts_beside();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double radius = std::get<CircleTarget>(study.targets[i].shape).radius;
    EXPECT_NEAR(parts[i], std::exp(-0.5 * radius * radius), 3e-4) << radius;
  }
}

/// One and the same draws with an input and without: the share is what sampling counts.
TEST(StudyMisses, are_those_that_sampling_counts) {
  Study study = three_inputs(0.1);
  study.targets = {{"triangle", PolygonTarget{{{-0.6, -0.4}, {0.7, -0.3}, {0.1, 0.8}}}}};
  study.sampling = Sampling::sobol;
  study.shots = 1 << 18;
  const LinearResult linear = linear_of(study);
  const double all = 1 - result_of(study, moved).hits[0].probability.value;
  for (std::size_t i = 0; i < study.inputs.size(); ++i) {
    Study without = study;
    auto& normal = std::get<NormalDistribution>(without.inputs[i].distribution);
    normal.deviation = 1e-9;
    const double left = 1 - result_of(without, moved).hits[0].probability.value;
    EXPECT_NEAR(linear.rows[i].misses[0], 1 - left / all, 2e-3) << study.inputs[i].path;
  }
}

TEST(StudyMisses, of_a_correlated_group_stand_in_its_first_row) {
  Study study = three_inputs();
  study.targets = {{"strip", RectangleTarget{{}, 1, 1e6}}};
  study.correlated = {{.inputs = {0, 1}, .matrix = {1, 0.5, 0.5, 1}}};
  const LinearResult linear = linear_of(study);
  EXPECT_EQ(linear.rows[0].misses[0], 1) << "nothing else moves impacts aside";
  EXPECT_EQ(linear.rows[1].misses[0], 0);
}

TEST(StudyMisses, are_negative_where_the_spread_brings_hits) {
  Study study = three_inputs(1);
  study.targets = {{"strip", RectangleTarget{{}, 1, 1e6}}};
  const auto beside = [](double deviation) { return 1 - 0.5 * (beyond(0.5, deviation) - beyond(1.5, deviation)); };
  EXPECT_NEAR(linear_of(study).rows[0].misses[0], 1 - beside(0.3) / beside(0.5), 1e-3);
  EXPECT_LT(linear_of(study).rows[0].misses[0], 0);
}

TEST(StudyMisses, are_not_told_where_hardly_any_miss) {
  Study study = three_inputs();
  study.targets = {{"barn", RectangleTarget{{}, 20, 20}}};
  for (const LinearRow& row : linear_of(study).rows) EXPECT_TRUE(std::isnan(row.misses[0]));
  study.targets.clear();
  for (const LinearRow& row : linear_of(study).rows) EXPECT_TRUE(row.misses.empty());
}

}  // namespace physim::test::study_misses_test
