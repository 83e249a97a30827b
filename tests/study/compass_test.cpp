// Wind by compass, and numbers of the place, held to fly() in such a wind and at such a place.
#include <numbers>

#include "study_support.hpp"

namespace physim::test::study_compass_test {

Study in_wind() {
  Study study;
  study.projectile = presets::rifle_bullet().projectile;
  study.launch = {.speed = 790, .elevation = 0.003};
  study.fidelity = Fidelity::small_arms();
  study.until = {.ground = std::nullopt, .range = 300};
  study.environment.earth.azimuth = 0.7;
  study.shard_shots = 16;
  study.shots = 16;
  return study;
}

/// To 1e-6 m: a study has a step of its own.
void expect_flights(const Study& study, const std::function<Environment(const std::vector<double>&)>& environment_of) {
  const auto plan = must(plan_study(study));
  for (std::uint64_t shot = 0; shot < 16; ++shot) {
    const Flight flight = fly(study.projectile, study.launch, environment_of(draws_of(plan, shot)), study.fidelity,
                              study.tolerance, study.until);
    const std::vector<double> ends = fly_shot_of(plan, shot);
    EXPECT_NEAR(ends[0], flight.end().position.z, 1e-5) << shot;
    EXPECT_NEAR(ends[2], flight.duration(), 1e-7) << shot;
  }
}

/// Components of a wind of a speed that comes from a side, x pointing to the azimuth.
Vec3d blowing(double speed, double from, double azimuth) {
  return {-speed * std::cos(from - azimuth), 0, -speed * std::sin(from - azimuth)};
}

TEST(StudyCompass, a_west_wind_blows_a_shot_to_the_north_aside) {
  Study study = in_wind();
  study.environment.earth.azimuth = 0;  // x to the north, z to the east
  study.inputs = {
      input("environment.wind.speed", UniformDistribution{4, 4.001}),
      input("environment.wind.from", UniformDistribution{1.5 * std::numbers::pi, 1.5 * std::numbers::pi + 1e-6})};
  const auto plan = must(plan_study(study));
  EXPECT_GT(fly_shot_of(plan, 0)[0], 0.1) << "to the east, which is to the right";
}

TEST(StudyCompass, is_that_of_its_components) {
  Study study = in_wind();
  study.rounds = 4;
  study.inputs = {{"environment.wind.speed", LognormalDistribution{4, 1}, DrawnFor::occasion},
                  {"environment.wind.speed", UniformDistribution{0, 3}, DrawnFor::round, true},  // gusts
                  {"environment.wind.from", NormalDistribution{4, 0.3}, DrawnFor::occasion}};
  expect_flights(study, [&](const std::vector<double>& drawn) {
    Environment own = study.environment;
    own.wind.velocity = blowing(drawn[0] + drawn[1], drawn[2], 0.7);
    return own;
  });
}

TEST(StudyCompass, is_seen_from_the_azimuth_that_a_shot_drew) {
  Study study = in_wind();
  study.inputs = {input("environment.earth.azimuth", UniformDistribution{0, 1.5}),
                  input("environment.wind.speed", NormalDistribution{5, 0.1}),
                  input("environment.wind.from", NormalDistribution{4.7, 0.02})};
  expect_flights(study, [&](const std::vector<double>& drawn) {
    Environment own = study.environment;
    own.earth.azimuth = drawn[0];
    own.wind.velocity = blowing(drawn[1], drawn[2], drawn[0]);
    return own;
  });
}

TEST(StudyCompass, what_is_not_drawn_is_that_of_the_environment) {
  Study study = in_wind();
  study.environment.wind.velocity = blowing(5, 2.5, 0.7);
  study.inputs = {{"environment.wind.speed", NormalDistribution{0, 1}, DrawnFor::round, true}};
  expect_flights(study, [&](const std::vector<double>& drawn) {
    Environment own = study.environment;
    own.wind.velocity = blowing(5 + drawn[0], 2.5, 0.7);
    return own;
  });
  study.inputs = {{"environment.wind.from", NormalDistribution{0, 0.2}, DrawnFor::round, true}};
  expect_flights(study, [&](const std::vector<double>& drawn) {
    Environment own = study.environment;
    own.wind.velocity = blowing(5, 2.5 + drawn[0], 0.7);
    return own;
  });
}

TEST(StudyCompass, contradictions_are_refused) {
  Study study = in_wind();
  const auto refusal = [&] {
    const auto plan = plan_study(study);
    return plan ? std::string() : plan.error().text();
  };
  study.inputs = {input("environment.wind.speed", UniformDistribution{1, 2})};
  EXPECT_NE(refusal().find("comes from nowhere"), std::string::npos);
  study.inputs = {input("environment.wind.from", UniformDistribution{1, 2})};
  EXPECT_NE(refusal().find("no wind comes from"), std::string::npos);
  study.inputs = {input("environment.wind.speed", UniformDistribution{1, 2}),
                  input("environment.wind.from", UniformDistribution{1, 2}),
                  input("environment.wind.velocity.x", UniformDistribution{1, 2})};
  EXPECT_NE(refusal().find("by compass and by components"), std::string::npos);
  study.inputs.pop_back();
  study.environment.wind.profile = {{0, {1, 0, 0}}};
  EXPECT_NE(refusal().find("has a profile"), std::string::npos);
}

TEST(StudyPlaces, are_uncertain_too) {
  Study study = in_wind();
  study.fidelity = Fidelity::simulation();
  study.inputs = {input("environment.altitude", NormalDistribution{1000, 300}),
                  input("environment.earth.latitude", UniformDistribution{0, 1})};
  expect_flights(study, [&](const std::vector<double>& drawn) {
    Environment own = study.environment;
    own.altitude = drawn[0], own.earth.latitude = drawn[1];
    return own;
  });
}

/// A g of one's own goes with no flattened field: the mean shot would stand on another rung than the others.
TEST(StudyPlaces, gravity_is_drawn_where_it_is_no_field_of_the_earth) {
  Study study = in_wind();
  study.inputs = {input("environment.gravity.acceleration", NormalDistribution{9.80665, 0.02})};
  expect_flights(study, [&](const std::vector<double>& drawn) {
    Environment own = study.environment;
    own.gravity.acceleration = drawn[0];
    return own;
  });
  study.fidelity.earth = EarthModel::sphere;
  study.fidelity.gravity = GravityModel::inverse_square;
  const auto plan = plan_study(study);
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().text().find("no field of the Earth"), std::string::npos) << plan.error().text();
  study.fidelity.earth = EarthModel::flat;
  EXPECT_TRUE(plan_study(study));
}

TEST(StudyPlaces, that_cannot_be_are_refused_shot_by_shot) {
  Study study = in_wind();
  study.fidelity = Fidelity::simulation();
  study.inputs = {input("environment.earth.latitude", UniformDistribution{1, 2})};
  const auto run = must(run_study(study));
  EXPECT_GT(run.refused, 2U);
  EXPECT_LT(run.refused, 14U);
  EXPECT_EQ(run.quantities[0].cells.count() + run.refused, 16U);
}

}  // namespace physim::test::study_compass_test
