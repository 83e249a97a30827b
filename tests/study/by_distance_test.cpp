// Points whose correlations follow from their distance: against the law, and against the impulse of a motor.
#include "study_support.hpp"

namespace physim::study_by_distance_test {

using namespace test;

constexpr double kDeviation = 2;  // of each point [N]

/// Straight up on a motor that has burned out after 3 s; its points are off by as much each.
Study burning(double length) {
  Study study{.projectile = {.mass = 2, .motor = {.thrust = {{0, 40}, {0.5, 60}, {1, 50}, {2, 45}, {2.5, 0}}}},
              .launch = {.speed = 100, .elevation = 90 * kDegree},
              .environment = {.gravity = {.model = GravityModel::constant}},
              .fidelity = vacuum(),
              .until = {.time = 3},
              .quantities = {StudyQuantity::vy}};
  study.shard_shots = study.shots = 1 << 14;
  for (const char* path : {"shot.motor.thrust.2", "shot.motor.thrust.4", "shot.motor.thrust.1", "shot.motor.thrust.3"})
    study.inputs.push_back({.path = path, .distribution = NormalDistribution{0, kDeviation}, .added = true});
  study.correlated = {correlated_by_distance(study, "shot.motor.thrust.N", length).value()};
  return study;
}
constexpr double kTimes[] = {0.5, 2, 0, 1};             // where the points stand, in the order of the inputs [s]
constexpr double kWeights[] = {0.5, 0.75, 0.25, 0.75};  // in the impulse, of straight lines between the points [s]

/// Of the speed that the impulse gives.
double expected_deviation(double length) {
  double squares = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      squares += kWeights[i] * kWeights[j] * std::exp(-std::abs(kTimes[i] - kTimes[j]) / length);
  return kDeviation * std::sqrt(squares) / 2;
}

TEST(StudyByDistance, draws_are_the_more_alike_the_nearer_their_points) {
  constexpr double kLength = 0.8;
  const StudyShots shots = fly_shots_of(plan_of(burning(kLength)), 0);
  const auto count = static_cast<double>(shots.inputs[0].size());
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      double sum = 0;
      for (std::size_t shot = 0; shot < shots.inputs[0].size(); ++shot)
        sum += shots.inputs[i][shot] * shots.inputs[j][shot];
      const double expected = std::exp(-std::abs(kTimes[i] - kTimes[j]) / kLength);
      // The mean product of n pairs of correlation C has the error sqrt((1 + C^2) / n).
      const double error = std::sqrt((1 + expected * expected) / count);
      EXPECT_NEAR(sum / count / (kDeviation * kDeviation), expected, 4 * error) << i << ' ' << j;
    }
}

TEST(StudyByDistance, an_impulse_varies_as_its_points_do_together) {
  double before = 0;
  for (const double length : {0.01, 0.5, 3.0, 1e6}) {
    const StudyPlan plan = plan_of(burning(length));
    const double expected = expected_deviation(length);
    const auto linear = must(propagate_linearly(plan));
    EXPECT_NEAR(std::sqrt(linear.covariance[0]), expected, 1e-5) << length;
    const auto result = must(run_study(plan));
    EXPECT_NEAR(result.quantities[0].deviation, expected, 4 * expected / std::sqrt(2.0 * (1 << 14))) << length;
    EXPECT_GT(expected, before) << "what is off alike does not cancel";
    before = expected;
  }
}

/// A point that is drawn twice, for occasions and rounds, goes by the first.
TEST(StudyByDistance, names_the_points_that_are_drawn) {
  Study study{.environment = {.wind = {.profile = {{0, {}}, {10, {}}, {40, {}}, {100, {}}}}}};
  const auto wind = [](const char* path) { return input(path, NormalDistribution{0, 1}); };
  study.inputs = {wind("shot.speed"), wind("environment.wind.profile.4.velocity.z"),
                  wind("environment.wind.profile.2.velocity.z"), wind("environment.wind.profile.1.velocity.x"),
                  wind("environment.wind.profile.2.velocity.z")};
  const auto with = must(correlated_by_distance(study, "environment.wind.profile.N.velocity.z", 45));
  EXPECT_EQ(with.inputs, (std::vector<std::size_t>{1, 2}));
  ASSERT_EQ(with.matrix.size(), 4u);
  EXPECT_EQ(with.matrix[0], 1);
  EXPECT_NEAR(with.matrix[1], std::exp(-2), 1e-15);
  EXPECT_EQ(with.matrix[1], with.matrix[2]);
}

TEST(StudyByDistance, refuses_what_has_no_distance) {
  Study study{.projectile = {.drag = {.table = DragTable::custom, .curve = {{0.5, 0.2}, {1, 0.4}, {2, 0.3}}},
                             .magnus = {.table = {{10, 1, 0.4, 0.1}, {20, 1, 0.4, 0.1}}},
                             .aero = {.magnus_force = {{1, 0, 0.5}, {1, 0.01, 0.6}}}}};
  const auto draw = [](const char* path) { return input(path, NormalDistribution{0.3, 0.01}); };
  study.inputs = {draw("shot.drag.curve.2"), draw("shot.magnus.table.1.lift"), draw("shot.magnus.table.2.lift"),
                  draw("shot.aero.magnus_force.1"), draw("shot.aero.magnus_force.2")};
  const auto refused = [&](const char* list, double length = 1) {
    const auto with = correlated_by_distance(study, list, length);
    return with ? "accepted" : with.error().place + ": " + with.error().message;
  };
  EXPECT_EQ(refused("shot.speed"), "list: \"shot.speed\" is no list of points, each at a place");
  EXPECT_EQ(refused("shot.drag.curve"), "list: \"shot.drag.curve\" is no list of points, each at a place");
  EXPECT_EQ(refused("shot.drag.curve.2"), "list: \"shot.drag.curve.2\" is no list of points, each at a place");
  EXPECT_EQ(refused("shot.magnus.table.N.lift"),
            "list: \"shot.magnus.table.N.lift\" is no list of points, each at a place")
      << "a speed and a spin";
  EXPECT_EQ(refused("shot.drag.curve.N"), "list: fewer than two points of shot.drag.curve.N are drawn");
  EXPECT_EQ(refused("shot.aero.magnus_force.N"),
            "list: shot.aero.magnus_force.2 stands where shot.aero.magnus_force.1 does");
  for (const double length : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_TRUE(refused("shot.drag.curve.N", length).starts_with("length: must be a positive number")) << length;
  study.inputs.push_back(draw("shot.drag.curve.7"));
  EXPECT_EQ(refused("shot.drag.curve.N"), "list: shot.drag.curve.7 names no point of its list");
}

}  // namespace physim::study_by_distance_test
