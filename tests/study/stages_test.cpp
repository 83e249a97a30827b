// What studies keep for pictures: stages on the way to their figures, and shots one by one.
#include "study_support.hpp"

namespace physim::study_stages_test {

using namespace test;

/// A stage is what a study of so many shots comes to.
TEST(StudyStages, are_studies_of_fewer_shots) {
  Study study = scatter(0.5, 0);
  study.targets = {{"circle", CircleTarget{{}, 1}}, {"left", RectangleTarget{{-1, 0}, 2, 4}}};
  study.shard_shots = 64;
  study.shots = 64 * 200;
  const StudyResult whole = result_of(study, scattered);
  ASSERT_GT(whole.stages.size(), 20U);
  EXPECT_EQ(whole.stages.front().shots, 64U);
  EXPECT_EQ(whole.stages.back().shots, whole.shots);
  EXPECT_EQ(whole.stages.back().hits, whole.hits);
  std::uint64_t before = 0;
  for (const StudyStage& stage : whole.stages) {
    EXPECT_GE(10 * stage.shots, stage.shots == whole.shots ? 0 : 11 * before);
    before = stage.shots;
    study.shots = stage.shots;
    const StudyResult fewer = result_of(study, scattered);
    EXPECT_EQ(stage.hits, fewer.hits) << stage.shots;
    EXPECT_TRUE(near(stage.distance.value, fewer.from_aim->mean.value, 1e-12)) << stage.shots;
    EXPECT_TRUE(near(stage.distance.error, fewer.from_aim->mean.error, 1e-10)) << stage.shots;
  }
}

TEST(StudyStages, stay_few_in_large_studies) {
  Study study = scatter();
  study.shard_shots = 16;
  study.shots = 16 * 20'000;
  const StudyResult run = result_of(study, scattered);
  EXPECT_LT(run.stages.size(), 110U) << "log(20000) / log(1.1) = 104";
  EXPECT_GT(run.stages.size(), 60U);
}

/// Replicates alone tell errors of evenly spread draws.
TEST(StudyStages, of_evenly_spread_draws_claim_no_error) {
  Study study = scatter();
  study.sampling = Sampling::sobol;
  study.shots = 16 * 4096;
  study.targets = {{"circle", CircleTarget{{}, 1}}};
  const StudyResult run = result_of(study, scattered);
  EXPECT_TRUE(std::isnan(run.stages.back().distance.error));
  EXPECT_TRUE(std::isnan(run.stages.back().hits[0].low));
  EXPECT_LT(run.hits[0].low, run.hits[0].probability.value);
}

TEST(StudyShots, are_those_that_numbers_give_again) {
  Study study = scatter();
  study.shard_shots = 32;
  study.shots = 128;
  const auto plan = must(plan_study(study, scattered));
  const StudyShots shots = fly_shots_of(plan, 2);
  ASSERT_EQ(shots.inputs.size(), 2U);
  ASSERT_EQ(shots.quantities[1].size(), 32U);
  for (const std::size_t i : {0U, 7U, 31U}) {
    const std::vector<double> drawn = draws_of(plan, 64 + i), flown = fly_shot_of(plan, 64 + i);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(shots.inputs[k][i], drawn[k]);
      EXPECT_EQ(shots.quantities[k][i], flown[k]);
    }
  }
}

/// An uncertain wind that is added to a profile moves all of it: each shot is a flight in such an environment.
TEST(StudyShots, fly_in_profiles_of_wind_of_their_own) {
  Study study{
      .projectile = {.mass = 0.145, .diameter = 0.0737, .drag = {.coefficient = 0.4}},
      .launch = {.position = {0, 1, 0}, .speed = 40, .elevation = 0.6},
      .environment = {.wind = {.profile = {{0, {-1, 0, 2}}, {30, {-3, 0, 5}}}}},
      .fidelity = Fidelity::simulation(),
      .tolerance = {.step = 1e-3},
      .until = {.events = {{.kind = EventKind::apex, .terminal = true}}},
      .inputs = {{.path = "environment.wind.velocity.x", .distribution = NormalDistribution{0, 2}, .added = true},
                 {.path = "environment.wind.velocity.z", .distribution = NormalDistribution{0, 2}, .added = true},
                 {.path = "environment.atmosphere.temperature", .distribution = NormalDistribution{290, 5}}},
      .shots = 32,
      .shard_shots = 16,
      .quantities = {StudyQuantity::z, StudyQuantity::y}};
  const auto plan = must(plan_study(study));
  const StudyShots shots = fly_shots_of(plan, 1);
  for (const std::size_t i : {0U, 5U, 15U}) {
    Environment own = study.environment;
    for (WindPoint& point : own.wind.profile)
      point.velocity.x += shots.inputs[0][i], point.velocity.z += shots.inputs[1][i];
    own.atmosphere.temperature = shots.inputs[2][i];
    const Flight flight = fly(study.projectile, study.launch, own, study.fidelity, plan.study().tolerance, study.until);
    ASSERT_EQ(flight.outcome(), Outcome::event);
    EXPECT_EQ(shots.quantities[0][i], flight.end().position.z) << i;
    EXPECT_EQ(shots.quantities[1][i], flight.end().position.y) << i;
  }
  study.inputs[0].added = false;
  const auto refused = plan_study(study);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("added"), std::string::npos) << refused.error().text();
}

}  // namespace physim::study_stages_test
