// Asking backwards: aim(), against closed forms and against flights.
#include "support.hpp"

namespace physim::flight_aim_test {

using namespace test;

constexpr double kG = 9.80665;

/// The two elevations with which a parabola of a speed passes a point at a horizontal distance and a height.
std::pair<double, double> elevations_in_vacuum(double speed, double distance, double height) {
  const double v2 = speed * speed;
  const double root = std::sqrt(v2 * v2 - kG * (kG * distance * distance + 2 * height * v2));
  return {std::atan2(v2 - root, kG * distance), std::atan2(v2 + root, kG * distance)};
}

Aim aimed(const ProjectileDef& p, const Launch& l, const Environment& e, const Fidelity& f, const Target& t,
          const AimOptions& o = {}) {
  return must(aim(p, l, e, f, t, o));
}

/// How near a solution comes to the target when it is flown by itself.
double miss_of(const ProjectileDef& p, const AimSolution& s, const Environment& e, const Fidelity& f, const Target& t) {
  const Flight flight = fly(p, s.launch, e, f, {.relative = 1e-12, .absolute = 1e-12}, {.ground = {}, .time = s.time});
  return length(flight.end().position - t.at(s.time));
}

TEST(Aim, in_vacuum_both_solutions_are_those_of_the_parabola) {
  for (const double distance : {50.0, 2000.0, 9000.0})
    for (const double height : {-300.0, 0.0, 40.0})
      for (const double azimuth : {0.0, 1.5707963267948966, -2.5}) {
        const Launch launch{.position = {10, 5, -3}, .speed = 300};
        const Target target{launch.position +
                            Vec3d{distance * std::cos(azimuth), height, distance * std::sin(azimuth)}};
        const auto [low, high] = elevations_in_vacuum(300, distance, height);
        const Aim answer = aimed({}, launch, constant_gravity(), vacuum(), target, {.tolerance = 1e-7});
        ASSERT_TRUE(answer.low && answer.high) << distance << ' ' << height;
        EXPECT_NEAR(answer.low->launch.elevation, low, 1e-9);
        EXPECT_NEAR(answer.high->launch.elevation, high, 1e-9);
        EXPECT_NEAR(answer.low->launch.azimuth, azimuth, 1e-9);
        EXPECT_NEAR(answer.low->time, distance / (300 * std::cos(low)), 1e-8);
        EXPECT_LE(answer.flights, 6);
      }
}

TEST(Aim, holds_under_the_aerodynamic_jump) {
  Environment e{.wind = {.velocity = {2, 0, -8}}};
  Fidelity f = Fidelity::small_arms();
  f.aerodynamic_jump = true;
  const ProjectileDef p = bullet_308();
  const Target target{{600, 12, 40}};
  const Aim answer = aimed(p, {.speed = 800}, e, f, target, {.arc = Arc::low});
  ASSERT_TRUE(answer.low);
  EXPECT_LT(miss_of(p, *answer.low, e, f, target), 0.01);
  EXPECT_LE(answer.flights, 6);
  f.aerodynamic_jump = false;
  const Aim flat = aimed(p, {.speed = 800}, e, f, target, {.arc = Arc::low});
  ASSERT_TRUE(flat.low);
  EXPECT_GT(flat.low->launch.elevation - answer.low->launch.elevation, 1e-4);
}

TEST(Aim, straight_up_and_down_azimuth_does_not_matter) {
  const Launch launch{.speed = 100};
  const double below = 100;
  const Aim up = aimed({}, launch, constant_gravity(), vacuum(), {{0, 300, 0}});
  ASSERT_TRUE(up.low && up.high);
  EXPECT_NEAR(up.low->launch.elevation, 90 * test::kDegree, 1e-4);
  EXPECT_NEAR(up.low->time, (100 - std::sqrt(1e4 - 2 * kG * 300)) / kG, 1e-3);
  EXPECT_NEAR(up.high->time, (100 + std::sqrt(1e4 - 2 * kG * 300)) / kG, 1e-3);
  const Aim down = aimed({}, {.position = {0, below, 0}, .speed = 100}, constant_gravity(), vacuum(), {{}});
  ASSERT_TRUE(down.low && down.high);
  EXPECT_NEAR(down.low->launch.elevation, -90 * test::kDegree, 1e-4);
  EXPECT_NEAR(down.low->time, (-100 + std::sqrt(1e4 + 2 * kG * below)) / kG, 1e-3);
  EXPECT_NEAR(down.high->time, (100 + std::sqrt(1e4 + 2 * kG * below)) / kG, 1e-3);
}

TEST(Aim, next_to_the_farthest_range_is_found_and_beyond_it_is_not) {
  const double farthest = 300 * 300 / kG;
  const Launch launch{.speed = 300};
  for (const double short_of : {1e-3, 0.1, 10.0}) {
    const Aim answer = aimed({}, launch, constant_gravity(), vacuum(), {{farthest - short_of, 0, 0}});
    ASSERT_TRUE(answer.low) << short_of;
    EXPECT_LE(miss_of({}, *answer.low, constant_gravity(), vacuum(), {{farthest - short_of, 0, 0}}), 0.0101);
  }
  const Aim beyond = aimed({}, launch, constant_gravity(), vacuum(), {{farthest + 20, 0, 0}});
  EXPECT_FALSE(beyond.in_reach());
  // The envelope of all parabolas, y = v^2/(2g) - g x^2/(2 v^2), falls with slope 1 at its foot: next to it the nearest
  // point of the envelope to a target 20 m beyond the foot is 20/sqrt(2) away, a little more for its bend.
  EXPECT_NEAR(beyond.nearest.miss, 20 / std::sqrt(2.0), 0.05);
  EXPECT_NE(beyond.explanation().find("out of reach"), std::string::npos);
}

TEST(Aim, a_moving_target_is_led) {
  // Without gravity: |T + V t| = v t has a positive root t; the direction is (T + V t) / (v t).
  Environment empty{.gravity = {.model = GravityModel::off}};
  const Target target{{400, 50, -100}, {-30, 5, 60}};
  const double v = 200, a = v * v - length_squared(target.velocity), b = dot(target.position, target.velocity);
  const double time = (b + std::sqrt(b * b + a * length_squared(target.position))) / a;
  const Aim answer = aimed({}, {.speed = v}, empty, vacuum(), target, {.arc = Arc::low, .tolerance = 1e-7});
  ASSERT_TRUE(answer.low);
  EXPECT_NEAR(answer.low->time, time, 1e-8);
  const Vec3d direction = normalized(target.at(time));
  EXPECT_NEAR(answer.low->launch.elevation, std::asin(direction.y), 1e-8);
  EXPECT_NEAR(answer.low->launch.azimuth, std::atan2(direction.z, direction.x), 1e-8);
}

TEST(Aim, an_accelerating_target_is_led_through_air_and_wind) {
  Environment windy{.wind = {.velocity = {2, 0, -9}}};
  const Target target{{500, 30, 80}, {-12, 1, 15}, {0.5, -0.2, -1}};
  const Aim answer = aimed(bullet_308(), {.speed = 800}, windy, Fidelity::simulation(), target);
  ASSERT_TRUE(answer.low);
  EXPECT_LE(miss_of(bullet_308(), *answer.low, windy, Fidelity::simulation(), target), 0.0101);
}

TEST(Aim, with_linear_drag_it_is_the_closed_form) {
  // x = v cos(e) (1 - exp(-k t)) / k, y = (v sin(e) + g/k) (1 - exp(-k t)) / k - g t / k with k = k1 / m.
  ProjectileDef p{.mass = 2, .drag = {.k1 = 0.3}};
  const double k = 0.15, v = 120, distance = 300, height = 20;
  Fidelity f = vacuum();
  f.drag = DragModel::linear_quadratic;
  f.air = AirModel::constant;
  const Aim answer = aimed(p, {.speed = v}, constant_gravity(), f, {{distance, height, 0}}, {.tolerance = 1e-6});
  ASSERT_TRUE(answer.low && answer.high);
  for (const AimSolution& s : {*answer.low, *answer.high}) {
    const double part = -std::expm1(-k * s.time) / k;
    EXPECT_NEAR(v * std::cos(s.launch.elevation) * part, distance, 1e-5);
    EXPECT_NEAR((v * std::sin(s.launch.elevation) + kG / k) * part - kG * s.time / k, height, 1e-5);
  }
  EXPECT_GT(answer.high->time, answer.low->time + 1);
}

TEST(Aim, hits_on_every_rung) {
  Environment e{.wind = {.profile = {{0, {1, 0, -3}}, {500, {4, 0, -8}}}}, .earth = {.latitude = 0.8}};
  ProjectileDef p = bullet_308();
  p.drag.k2 = 2e-6;
  const Target target{{900, 60, 25}};
  for (const EarthModel earth :
       {EarthModel::flat, EarthModel::flat_coriolis, EarthModel::sphere_rotating, EarthModel::ellipsoid})
    for (const Fidelity& preset : {Fidelity::game(), Fidelity::constant_air(), Fidelity::small_arms(),
                                   Fidelity::artillery(), Fidelity::simulation(), Fidelity::reference()}) {
      Fidelity f = preset;
      f.precision = Precision::float64;
      f.earth = earth;
      const Aim answer = aimed(p, {.speed = 800}, e, f, target);
      ASSERT_TRUE(answer.low && answer.high) << answer.explanation();
      const Flight flight = fly(p, answer.low->launch, e, f, {.step = 0}, {.ground = {}, .time = answer.low->time});
      EXPECT_LE(length(flight.end().position - target.position), 0.012) << int(f.integrator) << ' ' << int(earth);
      EXPECT_LE(answer.low->miss, 0.01);
    }
}

TEST(Aim, over_a_round_earth_reaches_across_a_tenth_of_it) {
  ProjectileDef p{.mass = 100, .diameter = 0.3};
  Environment e{.earth = {.latitude = 0.6, .longitude = 0.2, .azimuth = 1}};
  Fidelity f = vacuum();
  f.gravity = GravityModel::j2;
  f.earth = EarthModel::ellipsoid;
  const EarthFrames frames(e, f.earth);
  const Target target{frames.position({.latitude = 0.75, .longitude = 0.9, .height = 0})};
  const Aim answer = aimed(p, {.speed = 6500}, e, f, target, {.time = 7200});
  ASSERT_TRUE(answer.in_reach()) << answer.explanation();
  EXPECT_LE(miss_of(p, *answer.low, e, f, target), 0.02);
}

TEST(Aim, the_ground_stands_between) {
  // Shooting down through it at a target beyond an edge is no solution; lobbing over is not stopped.
  const Launch launch{.position = {0, 1, 0}, .speed = 60};
  const Aim through = aimed({}, launch, constant_gravity(), vacuum(), {{50, -20, 0}}, {.ground = 0.0});
  EXPECT_FALSE(through.in_reach());
  EXPECT_TRUE(through.behind_ground);
  EXPECT_NE(through.explanation().find("behind the ground"), std::string::npos);
  const Aim on_it = aimed({}, launch, constant_gravity(), vacuum(), {{150, 0, 0}}, {.ground = 0.0});
  EXPECT_TRUE(on_it.low && on_it.high);
}

TEST(Aim, one_arc_may_be_asked_for) {
  const Target target{{3000, 0, 0}};
  const auto asked = [&](Arc arc) {
    return aimed({}, {.speed = 300}, constant_gravity(), vacuum(), target, {.arc = arc});
  };
  const Aim low = asked(Arc::low), high = asked(Arc::high), both = asked(Arc::both);
  EXPECT_TRUE(low.low && !low.high);
  EXPECT_TRUE(high.high && !high.low);
  EXPECT_EQ(low.low->launch.elevation, both.low->launch.elevation);
  EXPECT_EQ(high.high->launch.elevation, both.high->launch.elevation);
  EXPECT_EQ(both.flights, low.flights + high.flights);
}

TEST(Aim, the_nearest_is_a_solution_where_there_is_one) {
  const Aim answer = aimed({}, {.speed = 300}, constant_gravity(), vacuum(), {{3000, 0, 0}});
  ASSERT_TRUE(answer.low && answer.high);
  const AimSolution& best = answer.low->miss < answer.high->miss ? *answer.low : *answer.high;
  EXPECT_EQ(answer.nearest.miss, best.miss);
  EXPECT_EQ(answer.nearest.time, best.time);
  EXPECT_EQ(answer.nearest.launch.elevation, best.launch.elevation);
  EXPECT_EQ(answer.nearest.flights, best.flights) << "it tells what it took to find it";
}

TEST(Aim, a_velocity_gives_its_magnitude_and_the_sight_is_not_read) {
  Launch launch{.velocity = Vec3d{0, 0, 300}, .sight = {.height = 1, .look_angle = 0.4, .cant = 1, .zero_range = 0}};
  const Aim answer = aimed({}, launch, constant_gravity(), vacuum(), {{3000, 0, 0}});
  ASSERT_TRUE(answer.low);
  EXPECT_EQ(answer.low->launch.speed, 300);
  EXPECT_EQ(answer.low->launch.sight.cant, 0);
  EXPECT_NEAR(answer.low->launch.elevation, elevations_in_vacuum(300, 3000, 0).first, 1e-5);
}

TEST(Aim, bad_input_is_refused_with_its_place) {
  const auto place = [](const Launch& launch, const Target& target, const AimOptions& options) {
    const Result<Aim> answer = aim({}, launch, {}, {}, target, options);
    return answer ? std::string("none") : answer.error().place;
  };
  const Launch good{.speed = 100};
  const Target there{{50, 0, 0}};
  EXPECT_EQ(place({}, there, {}), "launch.speed");
  EXPECT_EQ(place({.speed = 1e-200}, there, {}), "launch.speed") << "its square is 0";
  EXPECT_EQ(place({.speed = 1e200}, there, {}), "launch.speed");
  EXPECT_EQ(place({.position = {1e200, 0, 0}, .speed = 300}, there, {}), "launch.position");
  EXPECT_EQ(place({.speed = 300}, {{1e200, 0, 0}}, {}), "target.position");
  EXPECT_EQ(place({.speed = 300}, {there.position, {0, 1e200, 0}}, {}), "target.velocity");
  EXPECT_EQ(place({.speed = 300}, {there.position, {}, {0, 0, 1e200}}, {}), "target.acceleration");
  EXPECT_EQ(place(good, {{kNan, 0, 0}}, {}), "target.position");
  EXPECT_EQ(place(good, {{50, 0, 0}, {kInfinity, 0, 0}}, {}), "target.velocity");
  EXPECT_EQ(place(good, {}, {}), "target.position");
  EXPECT_EQ(place(good, there, {.tolerance = 0}), "options.tolerance");
  EXPECT_EQ(place(good, there, {.time = -1}), "options.time");
  EXPECT_EQ(place(good, there, {.ground = kNan}), "options.ground");
  const Result<Aim> refused = aim({.mass = -1}, good, {}, {}, there);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "projectile.mass");
  Environment stormy;
  stormy.wind.profile.resize(100001);
  EXPECT_EQ(aim({}, good, stormy, {}, there).error().place, "environment.wind.profile");
  EXPECT_EQ(aim({}, good, {}, {}, there, {.flight = {.max_steps = 0}}).error().place, "tolerance.max_steps");
  Environment deep;
  const Result<Aim> buried = aim({}, {.position = {0, -6000, 0}, .speed = 100}, deep, {}, there);
  EXPECT_FALSE(buried);
}

// ------------------------------------------------------------------------------------------------------------- ranges
TEST(MaxRange, in_vacuum_it_is_at_half_the_right_angle_over_the_slope) {
  for (const double slope : {-0.5, 0.0, 0.3}) {
    const auto far = must(max_range({}, {.speed = 100}, constant_gravity(), vacuum(), 0, slope));
    // R = v^2 / (g (1 + sin a)) at e = 45 deg + a / 2; a flat top hides the last digits of e.
    EXPECT_NEAR(far.elevation, 45 * test::kDegree + slope / 2, 2e-5);
    EXPECT_NEAR(far.range, 1e4 / (kG * (1 + std::sin(slope))), 1e-6);
    EXPECT_NEAR(far.time, 2 * 100 * std::sin(far.elevation - slope) / (kG * std::cos(slope)), 1e-6);
  }
}

TEST(MaxRange, from_a_height_it_is_lower_than_half_the_right_angle) {
  // tan e = v / sqrt(v^2 + 2 g h), R = v/g sqrt(v^2 + 2 g h).
  const auto far = must(max_range({}, {.position = {0, 30, 0}, .speed = 20}, constant_gravity(), vacuum()));
  const double root = std::sqrt(400 + 2 * kG * 30);
  EXPECT_NEAR(far.elevation, std::atan(20 / root), 2e-5);
  EXPECT_NEAR(std::hypot(far.position.x, far.position.z), 20 / kG * root, 1e-5);
}

TEST(MaxRange, with_drag_no_other_elevation_carries_farther) {
  const auto far = must(max_range(bullet_308(), {.speed = 800}, {}, Fidelity::simulation()));
  EXPECT_GT(far.elevation, 25 * test::kDegree);
  EXPECT_LT(far.elevation, 40 * test::kDegree);
  for (const double turn : {-0.02, 0.02}) {
    const Flight other =
        fly(bullet_308(), {.speed = 800, .elevation = far.elevation + turn}, {}, Fidelity::simulation());
    EXPECT_LT(length(other.end().position), far.range);
  }
}

TEST(MaxRange, steps_that_pilots_find_carry_as_far_as_adaptive_ones) {
  Fidelity f = Fidelity::small_arms();
  for (const double slope : {0.0, 0.1}) {
    f.integrator = Integrator::tsit5;
    const auto exact = max_range(bullet_308(), {.speed = 300}, {}, f, 0, slope);
    f.integrator = Integrator::rk4;
    const auto fixed = max_range(bullet_308(), {.speed = 300}, {}, f, 0, slope);
    ASSERT_TRUE(exact && fixed) << slope;
    EXPECT_NEAR(fixed->range, exact->range, 0.02) << slope;
    EXPECT_NEAR(fixed->elevation, exact->elevation, 1e-3) << slope;
  }
}

/// 100 g of 10 cm at 20 m/s into a wind that carries what is shot straight up farther back than anything flies ahead.
/// Source of the figures: RK4 of steps of 0.1 ms over all elevations.
TEST(MaxRange, is_ahead_of_a_wind_that_blows_shots_back) {
  const ProjectileDef ball{.mass = 0.1, .diameter = 0.1, .drag = {.table = DragTable::constant, .coefficient = 1}};
  Fidelity f = Fidelity::simulation();
  f.air = AirModel::constant;
  const struct {
    double wind, range, elevation;
  } cases[] = {{-10, 8.41, 16}, {-14, 6.11, 8}, {-20, 4.01, 0}, {-30, 2.25, -9}};
  for (const auto& c : cases) {
    const Environment environment{.atmosphere = {.model = AirModel::constant, .density = 1.225},
                                  .wind = {.velocity = {c.wind, 0, 0}}};
    const auto far = must(max_range(ball, {.position = {0, 1, 0}, .speed = 20}, environment, f));
    EXPECT_NEAR(far.range, c.range, 0.006) << c.wind;
    EXPECT_NEAR(far.elevation / test::kDegree, c.elevation, 0.6) << c.wind;
    EXPECT_NEAR(far.range, far.position.x, 1e-9);
  }
}

/// Kepler: with q = v^2 / (g R) the farthest shot comes down at the angle s from the muzzle, sin(s / 2) = q / (2 - q).
TEST(MaxRange, over_a_round_earth_it_is_the_way_along_the_ground) {
  constexpr double kRadius = 6371000;
  const Environment round{.gravity = {.acceleration = wgs84::kGM / (kRadius * kRadius), .radius = kRadius}};
  Fidelity f = vacuum(Integrator::dop853);
  f.earth = EarthModel::sphere;
  f.gravity = GravityModel::inverse_square;
  for (const double speed : {300.0, 5000.0}) {
    const double q = speed * speed * kRadius / wgs84::kGM;
    const auto far = must(max_range({}, {.speed = speed}, round, f));
    EXPECT_NEAR(far.range / (kRadius * 2 * std::asin(q / (2 - q))), 1, 1e-9) << speed;
  }
}

TEST(MaxRange, what_does_not_come_down_is_refused) {
  const auto far = max_range({}, {.speed = 100}, {.gravity = {.model = GravityModel::off}}, vacuum(), 0, 0, 60);
  ASSERT_FALSE(far);
  EXPECT_NE(far.error().message.find("does not come down"), std::string::npos);
  EXPECT_FALSE(max_range({}, {.speed = 0}, {}, {}));
  EXPECT_FALSE(max_range({}, {.position = {0, -1, 0}, .speed = 10}, {}, {}));
  EXPECT_FALSE(max_range({}, {.speed = 10}, {}, {}, 0, 1.6));
}

TEST(DangerSpace, of_a_parabola) {
  // y = x tan e - g x^2 / (2 v^2 cos^2 e): around x0 the height differs by half the target's.
  const double e = 2 * test::kDegree, v = 300, x0 = 600, h = 1.7;
  const Flight flight = fly({}, {.speed = v, .elevation = e}, constant_gravity(), vacuum(), {}, {.ground = -50});
  const double k = kG / (2 * v * v * std::cos(e) * std::cos(e)), y0 = x0 * std::tan(e) - k * x0 * x0;
  const auto place = [&](double y) {  // on the falling branch
    const double t = std::tan(e);
    return (t + std::sqrt(t * t - 4 * k * y)) / (2 * k);
  };
  const auto space = must(danger_space(flight, x0, h));
  EXPECT_NEAR(space.from, place(y0 + h / 2), 1e-6);
  EXPECT_NEAR(space.to, place(y0 - h / 2), 1e-6);
  const auto all = must(danger_space(flight, x0, 1000));
  EXPECT_EQ(all.from, 0);
  EXPECT_NEAR(all.to, flight.end().range, 1e-9);
  EXPECT_FALSE(danger_space(flight, 1e6, 1));
  EXPECT_FALSE(danger_space(flight, x0, 0));
}

TEST(TimeToRange, of_a_parabola) {
  const auto time = must(time_to_range({}, {.speed = 300, .elevation = 0.1}, constant_gravity(), vacuum(), 500));
  EXPECT_NEAR(time, 500 / (300 * std::cos(0.1)), 1e-9);
  EXPECT_FALSE(time_to_range({}, {.speed = 300}, {}, {}, -1));
  EXPECT_FALSE(time_to_range(bullet_308(), {.speed = 300}, {}, {}, 1e7));
}

/// A rocket that starts from rest, with a tail that needs no attitude.
ProjectileDef rocket_from_rest() {
  return {.mass = 0.2,
          .diameter = 0.03,
          .drag = {.table = DragTable::constant, .coefficient = 0.5},
          .motor = {.thrust = {{0, 12}, {1.5, 12}, {1.8, 0}}, .propellant_mass = 0.02}};
}

TEST(AimRocket, from_rest_hits_where_flown_rockets_came_by) {
  const ProjectileDef p = rocket_from_rest();
  Environment e{.wind = {.velocity = {1, 0, -3}}};
  for (const Fidelity& f : {Fidelity::constant_air(), Fidelity::small_arms()})
    for (const double elevation : {0.3, 0.8, 1.3})
      for (const double azimuth : {0.0, -2.2}) {
        Launch launch{.position = {3, 1, -2}, .elevation = elevation, .azimuth = azimuth, .rail_length = 1.5};
        const Flight before = fly(p, launch, e, f);
        for (const double part : {0.6, 1.0}) {  // of the way to the ground
          const Sample there = before.at(part * before.duration());
          const Target target{there.position};
          launch.elevation = launch.azimuth = 0;
          const Aim answer = aimed(p, launch, e, f, target, {.tolerance = 1e-3});
          ASSERT_TRUE(answer.low && answer.high) << answer.explanation();
          EXPECT_LE(answer.low->time, answer.high->time);
          EXPECT_LT(miss_of(p, *answer.low, e, f, target), 2e-3);
          EXPECT_LT(miss_of(p, *answer.high, e, f, target), 2e-3);
          const double apart =
              std::min(std::abs(answer.low->time - there.time), std::abs(answer.high->time - there.time));
          EXPECT_LT(apart, 1e-2) << "the way that was flown is one of them";
        }
      }
}

/// In a vacuum a flight takes a few long steps: the ways up and down are found between their ends. The steep way is
/// that of a bisection over flights to the ground.
TEST(AimRocket, the_steep_way_is_found_between_long_steps) {
  ProjectileDef p = rocket_from_rest();
  p.motor.thrust = {{0, 40}, {1.8, 40}, {1.8, 0}};
  Environment e{.atmosphere = {.model = AirModel::vacuum}};
  const Fidelity f = Fidelity::constant_air();
  const auto carry = [&](double elevation) {
    return fly(p, {.elevation = elevation, .rail_length = 1}, e, f).end().position.x;
  };
  for (const double range : {100.0, 200.0, 500.0}) {
    double low = 80 * test::kDegree, high = 90 * test::kDegree;
    for (int i = 0; i < 60; ++i) (carry((low + high) / 2) > range ? low : high) = (low + high) / 2;
    const Target target{{range, 0, 0}};
    const Aim answer = aimed(p, {.rail_length = 1}, e, f, target, {});
    ASSERT_TRUE(answer.low && answer.high) << range;
    EXPECT_NEAR(answer.high->launch.elevation, low, 1e-4) << range;
    EXPECT_LT(answer.low->launch.elevation, 0.7) << range;
    const Aim soon = aimed(p, {.rail_length = 1}, e, f, target, {.time = 6});
    ASSERT_TRUE(soon.low && soon.high) << range;
    EXPECT_EQ(soon.low->launch.elevation, soon.high->launch.elevation) << "one way is told once";
  }
}

TEST(AimRocket, what_is_too_far_is_told_and_balls_still_need_a_speed) {
  const ProjectileDef p = rocket_from_rest();
  const Fidelity f = Fidelity::constant_air();
  const auto far = must(aim(p, {.rail_length = 1}, {}, f, {.position = {5000, 0, 0}}));
  EXPECT_FALSE(far.in_reach());
  EXPECT_GT(far.nearest.miss, 1000);
  const auto without_rail = aim(p, {}, {}, f, {.position = {50, 0, 0}});
  ASSERT_FALSE(without_rail);
  EXPECT_EQ(without_rail.error().place, "launch.rail_length");
  const auto ball = aim({}, {}, {}, f, {.position = {50, 0, 0}});
  ASSERT_FALSE(ball);
  EXPECT_EQ(ball.error().place, "launch.speed");
}

// ------------------------------------------------------------------------------------------- through a scene
/// A wall from the ground up, across the way to a target on level ground.
struct Walled {
  Scene scene;
  InstanceId wall;
  Walled(double at, double height) {
    wall = add_thing(scene, BoxShape{{0.5, height, 500}}, {.transform = {.position = {at, 0, 0}}});
  }
};

TEST(Aim, finds_the_arcs_that_clear_a_wall_as_parabolas_do) {
  const double speed = 120, distance = 1000;
  const Launch launch{.speed = speed};
  const Target target{{distance, 0, 0}};
  const auto [low, high] = elevations_in_vacuum(speed, distance, 0);
  const auto height_at = [&](double elevation, double x) {
    const double t = x / (speed * std::cos(elevation));
    return x * std::tan(elevation) - 0.5 * kG * t * t;
  };
  // The sides of the wall that a path passes lowest.
  const auto lowest = [&](double elevation, double at) {
    return std::min(height_at(elevation, at - 0.5), height_at(elevation, at + 0.5));
  };
  for (const double at : {100.0, 500.0, 900.0})
    for (const double radius : {0.0, 0.5}) {
      for (const double part : {0.9, 0.999, 1.001, 1.1}) {
        const Walled low_wall(at, part * lowest(low, at)), high_wall(at, part * lowest(high, at));
        AimOptions options{.tolerance = 1e-6, .scene = &low_wall.scene, .contact = {.collision = {.radius = radius}}};
        const bool clear = radius == 0 ? part < 1 : part * lowest(low, at) < lowest(low, at) - 2;
        const bool surely = radius == 0 || clear || part > 1;
        const Aim over_low = aimed({}, launch, constant_gravity(), vacuum(), target, options);
        if (!surely) continue;
        EXPECT_EQ(over_low.low.has_value(), clear) << at << ' ' << part;
        ASSERT_TRUE(over_low.high);
        EXPECT_NEAR(over_low.high->launch.elevation, high, 1e-7);
        ASSERT_EQ(over_low.blocked.size(), clear ? 0u : 1u);
        EXPECT_TRUE(over_low.sight_ends);
        if (clear) continue;
        EXPECT_NEAR(over_low.blocked[0].solution.launch.elevation, low, 1e-7);
        EXPECT_EQ(over_low.blocked[0].hit.instance, low_wall.wall);
        EXPECT_NEAR(over_low.blocked[0].hit.position.x, at, 0.6 + radius);
        EXPECT_NE(over_low.explanation().find("blocked at elevation"), std::string::npos);
        options.scene = &high_wall.scene;
        if (radius > 0) continue;
        const Aim over_high = aimed({}, launch, constant_gravity(), vacuum(), target, options);
        EXPECT_FALSE(over_high.in_reach());
        EXPECT_EQ(over_high.blocked.size(), 2u);
      }
    }
}

TEST(Aim, what_is_aimed_at_is_in_nobodys_way) {
  Walled walled(1000, 30);
  const Target target{{1000, 5, 0}};  // inside of it
  AimOptions options{.tolerance = 1e-3, .scene = &walled.scene};
  EXPECT_FALSE(aimed({}, {.speed = 120}, constant_gravity(), vacuum(), target, options).in_reach());
  options.target_thing = walled.wall;
  const Aim answer = aimed({}, {.speed = 120}, constant_gravity(), vacuum(), target, options);
  EXPECT_TRUE(answer.low && answer.high);
  EXPECT_TRUE(answer.blocked.empty());
  EXPECT_FALSE(answer.sight_ends);
  // On the ground itself the path ends at the target.
  Scene ground;
  add_thing(ground, PlaneShape{});
  options = {.tolerance = 1e-3, .scene = &ground};
  EXPECT_TRUE(
      aimed({}, {.position = {0, 1, 0}, .speed = 120}, constant_gravity(), vacuum(), {{900, 0, 0}}, options).low);
  options.contact.collision.radius = -1;
  const auto bad = aim({}, {.speed = 120}, constant_gravity(), vacuum(), target, options);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().place, "options.contact.collision.radius");
}

TEST(MaxRange, between_a_steep_slope_and_the_vertical) {
  for (const double degrees : {80.0, 85.0, 89.0, 89.9}) {
    const double slope = degrees * test::kDegree;
    const auto far = must(max_range({}, {.speed = 100}, constant_gravity(), vacuum(), 0, slope));
    // R = v^2 / (g (1 + sin a)) at e = 45 deg + a / 2.
    EXPECT_NEAR(far.range, 1e4 / (kG * (1 + std::sin(slope))), 1e-6) << degrees;
    EXPECT_GT(far.elevation, slope);
  }
}

TEST(Aim, a_target_that_only_goes_away_is_out_of_reach) {
  const Target target{.position = {100, 0, 0}, .velocity = {100, 0, 0}};
  const Aim answer = aimed({}, {.speed = 50}, constant_gravity(), vacuum(), target);
  EXPECT_FALSE(answer.in_reach());
  EXPECT_NEAR(answer.nearest.miss, 100, 1e-9) << "at the muzzle";
  EXPECT_EQ(answer.nearest.time, 0);
  EXPECT_EQ(answer.explanation(), "out of reach: no path comes nearer than the muzzle, 100 m from the target");
}

TEST(Aim, two_solutions_may_have_one_elevation) {
  // Straight up: 50 t - g t^2 / 2 = 50 on the way up and on the way down.
  const Aim answer = aimed({}, {.speed = 50}, constant_gravity(), vacuum(), {{0, 50, 0}});
  ASSERT_TRUE(answer.low && answer.high);
  const double root = std::sqrt(2500 - 2 * kG * 50);
  EXPECT_NEAR(answer.low->time, (50 - root) / kG, 1e-6);
  EXPECT_NEAR(answer.high->time, (50 + root) / kG, 1e-6);
  EXPECT_NE(answer.explanation().find("; high: "), std::string::npos) << answer.explanation();
}

}  // namespace physim::flight_aim_test
