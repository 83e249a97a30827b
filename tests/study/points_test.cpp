// Points of curves that are uncertain: against numbers that are uncertain as a whole, and against closed forms.
#include <set>

#include "study/paths.hpp"
#include "study_support.hpp"

namespace physim {
namespace {

using namespace test;

Study shot_at(double range) {
  Study study;
  study.projectile.mass = 0.01;
  study.projectile.diameter = 0.008;
  study.launch = {.position = {0, 2, 0}, .speed = 600, .elevation = 0.01};
  study.environment.gravity.model = GravityModel::constant;
  study.until = {.range = range};
  study.tolerance.position_error = 1e-5;
  study.shard_shots = study.shots = 64;
  return study;
}

/// Studies that draw the same numbers, and fly them along two ways through the program.
void expect_same_shots(const Study& a, const Study& b) {
  const StudyShots one = fly_shots_of(plan_of(a), 0), other = fly_shots_of(plan_of(b), 0);
  ASSERT_EQ(one.quantities.size(), other.quantities.size());
  for (std::size_t q = 0; q < one.quantities.size(); ++q) {
    std::set<double> values;
    for (std::size_t i = 0; i < one.quantities[q].size(); ++i) {
      EXPECT_NEAR(one.quantities[q][i], other.quantities[q][i], 3e-5) << q << ' ' << i;
      values.insert(one.quantities[q][i]);
    }
    EXPECT_TRUE(values.size() > 60 || q == 0) << q << ": nothing was drawn";
  }
}

TEST(StudyPoints, a_constant_curve_is_a_form_factor) {
  Study points = shot_at(300), factor = points;
  points.projectile.drag.table = DragTable::custom;
  points.projectile.drag.curve = {{0, 0.25}};
  factor.projectile.drag = points.projectile.drag;
  points.inputs = {input("shot.drag.curve.1", NormalDistribution{0.25, 0.01})};
  factor.inputs = {input("shot.drag.form_factor", NormalDistribution{1, 0.04})};
  expect_same_shots(points, factor);
  points.inputs[0] = {.path = "shot.drag.curve.1", .distribution = NormalDistribution{0, 0.01}, .added = true};
  expect_same_shots(points, factor);
}

TEST(StudyPoints, one_band_is_a_ballistic_coefficient) {
  Study band = shot_at(300), whole = band;
  band.projectile.drag.table = whole.projectile.drag.table = DragTable::g7;
  band.projectile.drag.bands = {{0, 150}};
  whole.projectile.drag.ballistic_coefficient = 150;
  band.inputs = {input("shot.drag.bands.1.ballistic_coefficient", NormalDistribution{150, 5})};
  whole.inputs = {input("shot.drag.ballistic_coefficient", NormalDistribution{150, 5})};
  expect_same_shots(band, whole);
}

/// Beside a wind that is added to all points, and a temperature.
TEST(StudyPoints, a_profile_of_one_point_is_a_wind) {
  Study profile = shot_at(300), wind = profile;
  profile.environment.wind.profile = {{0, {0, 0, 2}}};
  wind.environment.wind.velocity = {0, 0, 2};
  const StudyInput warm = input("environment.atmosphere.temperature", NormalDistribution{288, 3});
  const StudyInput gust{
      .path = "environment.wind.velocity.z", .distribution = UniformDistribution{-1, 1}, .added = true};
  profile.inputs = {input("environment.wind.profile.1.velocity.z", NormalDistribution{2, 1}), warm, gust};
  wind.inputs = {input("environment.wind.velocity.z", NormalDistribution{2, 1}), warm, gust};
  expect_same_shots(profile, wind);
}

/// v = v0 - g t + J / m: the impulse of a triangle of 2 s is its highest force times 1 s, and a factor is one of all.
TEST(StudyPoints, a_point_of_thrust_is_its_part_of_the_impulse) {
  Study study;
  study.projectile.mass = 2;
  study.projectile.motor.thrust = {{0, 0}, {1, 40}, {2, 0}};
  study.launch = {.speed = 100, .elevation = 90 * kDegree};
  study.environment.gravity.model = GravityModel::constant;
  study.fidelity = vacuum();
  study.until = {.time = 3};
  study.quantities = {StudyQuantity::vy};
  study.shard_shots = study.shots = 64;
  study.inputs = {input("shot.motor.thrust.2", NormalDistribution{40, 2}),
                  input("shot.motor.thrust", NormalDistribution{1, 0.03})};
  const StudyPlan plan = plan_of(study);
  for (std::uint64_t shot = 0; shot < 64; ++shot) {
    const std::vector<double> drawn = draws_of(plan, shot);
    const double expected = 100 - 3 * study.environment.gravity.acceleration + drawn[0] * drawn[1] / 2;
    EXPECT_NEAR(fly_shot_of(plan, shot)[0], expected, 1e-6) << shot;
  }
  const StudyShots block = fly_shots_of(plan, 0);
  for (std::uint64_t shot = 0; shot < 64; ++shot) EXPECT_EQ(fly_shot_of(plan, shot)[0], block.quantities[0][shot]);
  const auto slopes = propagate_linearly(plan);
  ASSERT_TRUE(slopes) << slopes.error().text();
  EXPECT_NEAR(slopes->rows[0].slope[0], 0.5, 1e-6);
  EXPECT_NEAR(slopes->rows[1].slope[0], 20, 1e-5);
}

TEST(StudyPoints, what_breaks_a_curve_is_refused_shot_by_shot) {
  Study study = shot_at(300);
  study.projectile.drag.table = DragTable::custom;
  study.projectile.drag.curve = {{0, 0.2}, {3, 0.2}};
  study.inputs = {input("shot.drag.curve.2", UniformDistribution{-0.2, 0.2})};
  const StudyPlan plan = plan_of(study);
  const auto run = run_study(plan);
  ASSERT_TRUE(run) << run.error().text();
  std::uint64_t negative = 0;
  for (std::uint64_t shot = 0; shot < 64; ++shot) negative += draws_of(plan, shot)[0] < 0 ? 1 : 0;
  EXPECT_GT(negative, 0U);
  EXPECT_EQ(run->refused, negative);
}

TEST(StudyPoints, points_that_are_not_there) {
  const auto refusal = [](const char* path, auto change) {
    Study study = shot_at(300);
    study.inputs = {input(path, NormalDistribution{0.2, 0.01})};
    return refusal_of(study, change);
  };
  const auto expect = [&](const char* path, const char* words, auto change) {
    const std::string said = refusal(path, change);
    EXPECT_NE(said.find("inputs[0].path"), std::string::npos) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  const auto with_curve = [](Study& study) {
    study.projectile.drag.table = DragTable::custom;
    study.projectile.drag.curve = {{0, 0.2}, {1, 0.4}, {2, 0.3}};
  };
  EXPECT_EQ(refusal("shot.drag.curve.3", with_curve), "");
  expect("shot.drag.curve.4", "shot.drag.curve has no point 4", with_curve);
  expect("shot.drag.curve.4", "its points are 1 to 3", with_curve);
  expect("shot.drag.curve.0", "has no point 0", with_curve);
  expect("shot.drag.curve.03", "no number of a shot is called", with_curve);
  expect("shot.drag.curve.", "no number of a shot is called", with_curve);
  expect("shot.drag.curve.N", "no number of a shot is called", with_curve);
  expect("shot.drag.curve.99999999999999999999999", "no number of a shot is called", with_curve);
  expect("shot.drag.curve.1", "no drag curve of its own", [](Study& s) { s.projectile.drag.table = DragTable::g7; });
  expect("shot.motor.thrust.1", "shot.motor.thrust has no points", [](Study&) {});
  expect("environment.wind.profile.2.velocity.z", "it has one, with the number 1", [](Study& s) {
    s.environment.wind.profile = {{0, {}}};
  });
}

/// Each row of a list has a number of its own, that of its point.
TEST(StudyPoints, rows_have_numbers_of_their_own) {
  Shot shot;
  DragDef& drag = shot.projectile.drag;
  MotorDef& motor = shot.projectile.motor;
  AeroDef& aero = shot.projectile.aero;
  drag.table = DragTable::custom;
  drag.curve.resize(2), drag.bands.resize(2), shot.projectile.magnus.table.resize(2);
  motor.thrust.resize(2), motor.propellant.resize(2), motor.drag_curve.resize(2);
  for (AeroCoefficient* list :
       {&aero.drag_yaw, &aero.lift, &aero.lift_cubic, &aero.pitching, &aero.pitching_cubic, &aero.pitch_damping,
        &aero.yaw_damping, &aero.roll_damping, &aero.magnus_force, &aero.magnus_moment})
    list->resize(2);
  Environment place;
  place.wind.profile.resize(2);
  std::set<const double*> numbers;
  std::size_t rows = 0;
  for (const StudyPath& known : study_paths()) {
    const std::size_t at = known.path.find(".N");
    if (at == known.path.npos) continue;
    const FoundPath second = find_path(known.path.substr(0, at) + ".2" + known.path.substr(at + 2));
    ASSERT_TRUE(second) << known.path;
    EXPECT_EQ(second.points(shot, place), 2U) << known.path;
    numbers.insert(second.point_of(shot, place));
    ++rows;
  }
  EXPECT_EQ(numbers.size(), rows);
  EXPECT_EQ(find_path("shot.aero.pitching_cubic.2").point_of(shot, place), &aero.pitching_cubic[1].value);
  EXPECT_EQ(find_path("shot.magnus.table.1.lift").point_of(shot, place), &shot.projectile.magnus.table[0].lift);
  EXPECT_EQ(find_path("shot.motor.drag_curve.1").point_of(shot, place), &motor.drag_curve[0].coefficient);
  EXPECT_EQ(find_path("shot.motor.propellant.2").point_of(shot, place), &motor.propellant[1].mass);
  EXPECT_EQ(find_path("environment.wind.profile.2.velocity.y").point_of(shot, place),
            &place.wind.profile[1].velocity.y);
  const auto told = study_path("shot.motor.thrust.7");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->unit, "N");
  EXPECT_EQ(told->path, "shot.motor.thrust.7");
}

}  // namespace
}  // namespace physim
