// Points of curves that are uncertain: against numbers that are uncertain as a whole, and against closed forms.
#include <set>

#include "study/paths.hpp"
#include "study_support.hpp"

namespace physim::study_points_test {

using namespace test;

Study shot_at(double range) {
  Study study{.projectile = {.mass = 0.01, .diameter = 0.008},
              .launch = {.position = {0, 2, 0}, .speed = 600, .elevation = 0.01},
              .environment = {.gravity = {.model = GravityModel::constant}},
              .tolerance = {.position_error = 1e-5},
              .until = {.range = range}};
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

/// Straight up on a motor that has burned out after 3 s.
Study burning(const std::vector<ThrustPoint>& thrust) {
  Study study{.projectile = {.mass = 2, .motor = {.thrust = thrust}},
              .launch = {.speed = 100, .elevation = 90 * kDegree},
              .environment = {.gravity = {.model = GravityModel::constant}},
              .fidelity = vacuum(),
              .until = {.time = 3},
              .quantities = {StudyQuantity::vy}};
  study.shard_shots = study.shots = 64;
  return study;
}
/// v = v0 - g t + J / m, J the impulse of what was drawn.
template <class F>
void expect_impulses(const StudyPlan& plan, const F& impulse) {
  const double fallen = 3 * plan.study().environment.gravity.acceleration;
  for (std::uint64_t shot = 0; shot < 64; ++shot)
    EXPECT_NEAR(fly_shot_of(plan, shot)[0], 100 - fallen + impulse(draws_of(plan, shot)) / 2, 1e-6) << shot;
}

/// The impulse of a triangle of 2 s is its highest force times 1 s, and a factor is one of all.
TEST(StudyPoints, a_point_of_thrust_is_its_part_of_the_impulse) {
  Study study = burning({{0, 0}, {1, 40}, {2, 0}});
  study.inputs = {input("shot.motor.thrust.2", NormalDistribution{40, 2}),
                  input("shot.motor.thrust", NormalDistribution{1, 0.03})};
  const StudyPlan plan = plan_of(study);
  expect_impulses(plan, [](const std::vector<double>& drawn) { return drawn[0] * drawn[1]; });
  const StudyShots block = fly_shots_of(plan, 0);
  for (std::uint64_t shot = 0; shot < 64; ++shot) EXPECT_EQ(fly_shot_of(plan, shot)[0], block.quantities[0][shot]);
  const auto slopes = must(propagate_linearly(plan));
  EXPECT_NEAR(slopes.rows[0].slope[0], 0.5, 1e-6);
  EXPECT_NEAR(slopes.rows[1].slope[0], 20, 1e-5);
}

/// The impulse of a plateau that falls off, (0, F), (t, F), (T, 0), is F (t + T) / 2.
TEST(StudyPoints, a_time_of_thrust_is_its_part_of_the_impulse) {
  Study study = burning({{0, 40}, {1, 40}, {2, 0}});
  study.inputs = {input("shot.motor.thrust.2.time", NormalDistribution{1, 0.1}),
                  input("shot.motor.thrust.3.time", UniformDistribution{1.9, 2.1})};
  const StudyPlan plan = plan_of(study);
  expect_impulses(plan, [](const std::vector<double>& drawn) { return 40 * (drawn[0] + drawn[1]) / 2; });
  const auto slopes = must(propagate_linearly(plan));
  EXPECT_NEAR(slopes.rows[0].slope[0], 10, 1e-5);
  study.inputs = {input("shot.motor.thrust.1.time", NormalDistribution{0, 0.1})};
  EXPECT_FALSE(plan_study(study)) << "a table starts at ignition: none of the shots is right";
}

/// A straight line from (0, a) to (M, b) is that from (0, a) to (3, a + 3 (b - a) / M).
TEST(StudyPoints, a_mach_number_turns_the_line_that_ends_there) {
  Study study = shot_at(300);
  study.projectile.drag.table = DragTable::custom;
  study.projectile.drag.curve = {{0, 0.1}, {3, 0.4}};
  study.fidelity.interpolation = Interpolation::linear;
  study.inputs = {input("shot.drag.curve.2.mach", UniformDistribution{2.6, 3.4})};
  const StudyPlan plan = plan_of(study);
  for (std::uint64_t shot = 0; shot < 16; ++shot) {
    Study known = study;
    known.projectile.drag.curve[1] = {3, 0.1 + 0.9 / draws_of(plan, shot)[0]};
    known.inputs = {input("shot.speed", DiscreteDistribution{{600}})};
    const auto turned = fly_shot_of(plan, shot), expected = fly_shot_of(plan_of(known), 0);
    for (std::size_t q = 0; q < 4; ++q) EXPECT_NEAR(turned[q], expected[q], 3e-5) << shot << ' ' << q;
  }
}

TEST(StudyPoints, a_border_between_bands_decides_nothing_where_they_are_alike) {
  Study study = shot_at(300);
  study.projectile.drag.table = DragTable::g7;
  study.projectile.drag.bands = {{500, 150}, {0, 150}};
  study.inputs = {input("shot.drag.bands.1.above", UniformDistribution{450, 550})};
  study.quantities = {StudyQuantity::speed};
  const StudyShots alike = fly_shots_of(plan_of(study), 0);
  for (const double speed : alike.quantities[0]) EXPECT_NEAR(speed, alike.quantities[0][0], 2e-3);
  study.projectile.drag.bands[1].ballistic_coefficient = 100;
  const StudyPlan plan = plan_of(study);
  const StudyShots apart = fly_shots_of(plan, 0);
  for (std::size_t i = 1; i < 64; ++i) {
    const bool earlier = apart.inputs[0][i] > apart.inputs[0][0];
    EXPECT_EQ(apart.quantities[0][i] < apart.quantities[0][0], earlier) << "longer in the band of more drag";
  }
}

/// In a wind that is 0 below a height and w above it, a shot straight up in linear drag: the drift follows from the
/// height at which the wind begins, by w (t - (1 - exp(-k t)) / k) over the time t that it spends above.
TEST(StudyPoints, a_height_of_wind_is_where_the_wind_begins) {
  Study study = shot_at(300);
  study.until = {.time = 4};
  study.projectile.mass = 1;
  study.projectile.drag.k1 = 0.5;
  study.launch = {.speed = 100, .elevation = 90 * kDegree};
  study.fidelity = Fidelity::simulation();
  study.fidelity.drag = DragModel::linear_quadratic, study.fidelity.earth = EarthModel::flat;
  study.environment.wind.profile = {{0, {}}, {100, {}}, {100.001, {0, 0, 10}}};
  study.environment.wind.interpolation = WindInterpolation::step;
  study.quantities = {StudyQuantity::z};
  study.inputs = {input("environment.wind.profile.2.at", UniformDistribution{50, 90}),
                  input("environment.wind.profile.3.at", UniformDistribution{100, 110})};
  const StudyPlan plan = plan_of(study);
  const double k = 0.5, g = study.environment.gravity.acceleration;
  const auto height = [&](double t) { return ((100 + g / k) * (1 - std::exp(-k * t)) - g * t) / k; };
  for (std::uint64_t shot = 0; shot < 8; ++shot) {
    const double begins = draws_of(plan, shot)[1];
    double low = 0, high = 3;
    for (int i = 0; i < 60; ++i) (height((low + high) / 2) < begins ? low : high) = (low + high) / 2;
    const double above = 4 - low;
    ASSERT_GT(height(4), 110) << "it is still above";
    EXPECT_NEAR(fly_shot_of(plan, shot)[0], 10 * (above - (1 - std::exp(-k * above)) / k), 1e-3) << shot;
  }
}

TEST(StudyPoints, places_out_of_order_are_refused_shot_by_shot) {
  Study study = shot_at(300);
  study.environment.wind.profile = {{0, {0, 0, 1}}, {10, {0, 0, 2}}};
  study.inputs = {input("environment.wind.profile.2.at", UniformDistribution{-5, 20})};
  const auto expect_refused = [&](auto is_wrong) {
    const StudyPlan plan = plan_of(study);
    const auto run = must(run_study(plan));
    std::uint64_t wrong = 0;
    for (std::uint64_t shot = 0; shot < 64; ++shot) wrong += is_wrong(draws_of(plan, shot)[0]) ? 1 : 0;
    EXPECT_GT(wrong, 0U);
    EXPECT_EQ(run.refused, wrong);
    EXPECT_EQ(plan.notes().size(), 1U) << "told before it is flown";
    for (const auto& note : plan.notes()) EXPECT_NE(note.find("must rise"), note.npos) << note;
  };
  expect_refused([](double at) { return at <= 0; });
  study.projectile.drag.table = DragTable::custom;
  study.projectile.drag.curve = {{0, 0.2}, {1, 0.3}, {2, 0.2}};
  study.inputs = {input("shot.drag.curve.2.mach", UniformDistribution{0.5, 2.5})};
  expect_refused([](double mach) { return mach >= 2; });
}

TEST(StudyPoints, what_breaks_a_curve_is_refused_shot_by_shot) {
  Study study = shot_at(300);
  study.projectile.drag.table = DragTable::custom;
  study.projectile.drag.curve = {{0, 0.2}, {3, 0.2}};
  study.inputs = {input("shot.drag.curve.2", UniformDistribution{-0.2, 0.2})};
  const StudyPlan plan = plan_of(study);
  const auto run = must(run_study(plan));
  std::uint64_t negative = 0;
  for (std::uint64_t shot = 0; shot < 64; ++shot) negative += draws_of(plan, shot)[0] < 0 ? 1 : 0;
  EXPECT_GT(negative, 0U);
  EXPECT_EQ(run.refused, negative);
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
    EXPECT_EQ(second.row->path, known.path);
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
  EXPECT_EQ(find_path("shot.drag.curve.2.mach").point_of(shot, place), &drag.curve[1].mach);
  EXPECT_EQ(find_path("environment.wind.profile.1.at").point_of(shot, place), &place.wind.profile[0].at);
  EXPECT_EQ(find_path("shot.aero.magnus_force.2.angle_squared").point_of(shot, place),
            &aero.magnus_force[1].angle_squared);
  const auto told = must(study_path("shot.motor.thrust.7"));
  EXPECT_EQ(told.unit, "N");
  EXPECT_EQ(told.path, "shot.motor.thrust.7");
}

}  // namespace physim::study_points_test
