// Zeroing, and the step that a pilot flight finds.
#include "support.hpp"

namespace physim::flight_zero_test {

using namespace test;

double drop_at(const ProjectileDef& p, Launch launch, const Environment& e, const Fidelity& f, double elevation,
               double range) {
  launch.sight.zero_range = 0;
  launch.elevation = elevation;
  return fly(p, launch, e, f, {1e-12, 1e-12}, {.ground = {}, .range = range}).end().drop;
}

TEST(Zero, in_vacuum_is_the_lower_solution_of_the_range_equation) {
  // sin 2e = g R / v^2.
  const auto e = must(zero_elevation({}, {.speed = 300}, constant_gravity(), vacuum(), 2000));
  EXPECT_NEAR(e, 0.5 * std::asin(9.80665 * 2000 / 90000), 1e-11);
}

TEST(Zero, the_shot_crosses_the_line_of_sight_at_the_range) {
  for (const double look : {0.0, 0.35, -0.5})
    for (const double range : {25.0, 100.0, 300.0, 900.0}) {
      const Launch launch{.speed = 800, .azimuth = 0.7, .sight = {.height = 0.05, .look_angle = look}};
      const Fidelity f{.integrator = Integrator::tsit5, .tolerance = 1e-9};
      const auto elevation = zero_elevation(bullet_308(), launch, {}, f, range);
      ASSERT_TRUE(elevation) << look << ' ' << range;
      // The zero is found with flights at a tolerance of 1e-9 of the range per step.
      EXPECT_NEAR(drop_at(bullet_308(), launch, {}, f, *elevation, range), 0, 1e-9 * range) << look << ' ' << range;
      EXPECT_GT(*elevation, look - 0.01);
      EXPECT_LT(*elevation, look + 0.05);
    }
}

TEST(Zero, fly_uses_the_zero_range) {
  const Launch launch{.speed = 800, .sight = {.height = 0.04, .zero_range = 200}};
  const Flight flight = fly(bullet_308(), launch, {}, {}, {1e-11, 1e-11}, {.ground = {}, .range = 500});
  EXPECT_NEAR(flight.at_range(200)->drop, 0, 1e-7);
  EXPECT_NEAR(flight.elevation(), *zero_elevation(bullet_308(), launch, {}, {}, 200), 1e-15);
  EXPECT_NEAR(flight.at(0).drop, -0.04, 1e-15);
}

TEST(Zero, is_shot_on_the_level_and_the_look_angle_comes_afterwards) {
  // Uphill a bullet zeroed on the level strikes high, by about (1 - cos L) of its drop below the bore.
  Launch launch{.speed = 800, .sight = {.height = 0.05, .zero_range = 300}};
  const Flight level = fly(bullet_308(), launch, {}, {}, {}, {.ground = {}, .range = 300});
  for (const double look : {30 * kDegree, -30 * kDegree, 60 * kDegree}) {
    launch.sight.look_angle = look;
    const Flight flight = fly(bullet_308(), launch, {}, {}, {}, {.ground = {}, .range = 300});
    EXPECT_NEAR(flight.elevation(), level.elevation() + look, 1e-15) << look;
    const double below_bore = 300 * std::tan(level.elevation()) - 0.05;
    EXPECT_NEAR(flight.end().drop, (1 - std::cos(look)) * below_bore, 0.02 * below_bore) << look;
    EXPECT_EQ(fly_batch(bullet_308(), {&launch, 1}, {}, {}, {}, {.ground = {}, .range = 300}).shots[0].position,
              flight.end().position);
  }
}

/// In vacuum on the level: drop = x tan e - g x^2 / (2 v^2 cos^2 e), with e the zero and what is dialled.
TEST(Zero, what_is_dialled_raises_the_bore_above_it_at_every_door) {
  const double range = 900, g = 9.80665, v = 300, dial = 0.003;
  Launch launch{.speed = v, .sight = {.zero_range = 400}};
  const Until until{.ground = {}, .range = range};
  const double zero = fly({}, launch, constant_gravity(), vacuum(), {}, until).elevation();
  launch.sight.dial = dial;
  const Flight flight = fly({}, launch, constant_gravity(), vacuum(), {}, until);
  EXPECT_EQ(flight.elevation(), zero + dial);
  const double c = std::cos(zero + dial);
  EXPECT_NEAR(flight.end().drop, range * std::tan(zero + dial) - g * range * range / (2 * v * v * c * c), 1e-9);
  EXPECT_EQ(fly_batch({}, {&launch, 1}, constant_gravity(), vacuum(), {}, until).shots[0].position,
            flight.end().position);
  World world = World::create({.environment = constant_gravity(), .ground = {.mode = GroundMode::none}}).value();
  const ProjectileId id = world.spawn({.fidelity = vacuum()}, launch).value();
  EXPECT_EQ(world[id].velocity(), flight.at(0).velocity);
  launch.sight.zero_range = 0;
  EXPECT_EQ(fly({}, launch, constant_gravity(), vacuum(), {}, until).elevation(), 0) << "a dial is that of a zero";
  for (const double wrong : {2.0, -2.0, std::nan("")}) {
    launch.sight.dial = wrong;
    EXPECT_EQ(fly({}, launch, constant_gravity(), vacuum(), {}, until).error().value().place, "launch.sight.dial");
  }
}

TEST(Zero, from_a_tower_may_lie_below_the_horizon) {
  // A sight a metre above the bore at a very short range: the bore has to point up steeply, one below the bore, down.
  const auto up = must(zero_elevation({}, {.speed = 300, .sight = {.height = 1}}, constant_gravity(), vacuum(), 10));
  const auto down = must(zero_elevation({}, {.speed = 300, .sight = {.height = -1}}, constant_gravity(), vacuum(), 10));
  EXPECT_NEAR(std::tan(up) * 10 - 0.5 * 9.80665 * std::pow(10 / (300 * std::cos(up)), 2), 1, 1e-9);
  EXPECT_NEAR(std::tan(down) * 10 - 0.5 * 9.80665 * std::pow(10 / (300 * std::cos(down)), 2), -1, 1e-9);
}

TEST(Zero, is_shot_upright_and_cant_comes_afterwards) {
  Launch launch{.speed = 800, .sight = {.height = 0.05, .zero_range = 300}};
  const Flight upright = fly(bullet_308(), launch, {}, {}, {}, {.ground = {}, .range = 300});
  launch.sight.cant = 10 * kDegree;
  const Flight canted = fly(bullet_308(), launch, {}, {}, {}, {.ground = {}, .range = 300});
  EXPECT_EQ(canted.elevation(), upright.elevation());
  EXPECT_GT(canted.end().windage, 0.02) << "a clockwise cant shoots right";
  EXPECT_LT(canted.end().drop, upright.end().drop) << "and low";
}

TEST(Elevation, of_a_given_velocity_is_its_own) {
  const auto elevation_of = [](const Launch& launch) {
    return fly({}, launch, constant_gravity(), vacuum(), {}, {.time = 0.1}).elevation();
  };
  EXPECT_NEAR(elevation_of({.velocity = Vec3d{30, 30, 0}}), 45 * kDegree, 1e-15);
  EXPECT_NEAR(elevation_of({.velocity = Vec3d{-3, -4, 4}}), -std::atan2(4.0, 5.0), 1e-15);
  EXPECT_EQ(elevation_of({.elevation = 0.3, .velocity = Vec3d{}}), 0.3) << "what rests points where the launcher does";
}

TEST(Zero, in_calm_air_or_in_the_wind_as_asked) {
  Environment headwind{.wind = {.velocity = {-20, 0, 0}}};
  Launch launch{.speed = 400, .sight = {.zero_range = 300, .zero_in_calm_air = true}};
  const double calm = fly(bullet_308(), launch, headwind, {}).elevation();
  launch.sight.zero_in_calm_air = false;
  const double windy = fly(bullet_308(), launch, headwind, {}).elevation();
  EXPECT_NEAR(calm, *zero_elevation(bullet_308(), {.speed = 400}, {}, {}, 300), 1e-12);
  EXPECT_GT(windy, calm);
}

TEST(Zero, out_of_reach_is_an_error) {
  for (const double range : {1e4, 1e6}) {
    const auto e = zero_elevation(bullet_308(), {.speed = 100}, {}, {}, range);
    ASSERT_FALSE(e);
    EXPECT_EQ(e.error().place, "launch.sight.zero_range");
  }
  for (const double range : {0.0, -5.0, kNan, kInfinity})
    EXPECT_FALSE(zero_elevation(bullet_308(), {.speed = 800}, {}, {}, range)) << range;
}

TEST(Zero, every_motion_and_precision_is_zeroed_by_its_own_physics) {
  Fidelity f = Fidelity::arcade();
  const auto e = must(zero_elevation({}, {.speed = 300}, constant_gravity(), f, 2000));
  EXPECT_NEAR(e, 0.5 * std::asin(9.80665 * 2000 / 90000), 1e-11);
}

TEST(PilotStep, keeps_the_position_error) {
  const Launch launch{.speed = 800, .elevation = 0.01};
  const Until until{.ground = {}, .range = 800};
  Fidelity f{.integrator = Integrator::dop853};
  const Flight exact = fly(bullet_308(), launch, {}, f, {1e-13, 1e-13}, until);
  for (const auto& [integrator, error] : {std::pair{Integrator::semi_implicit_euler, 0.1},
                                          {Integrator::heun, 1e-3},
                                          {Integrator::heun, 1e-5},
                                          {Integrator::rk4, 1e-3},
                                          {Integrator::rk4, 1e-6}}) {
    f.integrator = integrator;
    Tolerance tolerance{.position_error = error};
    const auto step = pilot_step(bullet_308(), launch, {}, f, tolerance, until);
    ASSERT_TRUE(step) << text(integrator) << ' ' << error;
    if (integrator != Integrator::semi_implicit_euler) {
      EXPECT_EQ(fly(bullet_308(), launch, {}, f, tolerance, until).step(), *step);
    }
    tolerance.step = *step;
    const auto worst_at = [&](double fixed) {  // in place at equal times, and in time where it ends
      tolerance.step = fixed;
      const Flight flight = fly(bullet_308(), launch, {}, f, tolerance, until);
      const double common = std::min(flight.duration(), exact.duration());
      double worst = 800 * std::abs(flight.duration() - exact.duration());
      for (int i = 0; i <= 100; ++i)
        worst = std::max(worst, length(flight.at(common * i / 100).position - exact.at(common * i / 100).position));
      return worst;
    };
    EXPECT_LE(worst_at(*step), 1.001 * error) << text(integrator) << ' ' << error;
    // And no smaller than it has to be: three times the step misses the goal.
    EXPECT_GT(worst_at(3 * *step), error) << text(integrator);
  }
}

TEST(PilotStep, is_not_flown_where_a_step_is_given_or_none_is_needed) {
  Fidelity f;
  EXPECT_EQ(fly(bullet_308(), {.speed = 800}, {}, f).step(), 0);
  f.integrator = Integrator::rk4;
  EXPECT_EQ(fly(bullet_308(), {.position = {0, 1, 0}, .speed = 800}, {}, f, {.step = 0.0125}).step(), 0.0125);
  for (const Integrator integrator :
       {Integrator::classic, Integrator::explicit_euler, Integrator::semi_implicit_euler}) {
    f.integrator = integrator;
    EXPECT_EQ(fly(bullet_308(), {.position = {0, 1, 0}, .speed = 800}, {}, f).step(), 1.0 / 60) << "a game's frame";
  }
  f.motion = Motion::closed_form;
  EXPECT_EQ(fly(bullet_308(), {.position = {0, 1, 0}, .speed = 800}, {}, f).step(), 0);
}

TEST(Zero, near_the_end_of_the_reach_lies_between_the_steps_of_the_search) {
  // Right: an own DOP853 at 1e-11, US76 and G7 by PCHIP; the shot carries 4300.97 m.
  ProjectileDef bullet{
      .mass = 168 * 6.479891e-5,
      .diameter = 0.308 * 0.0254,
      .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218 * 0.45359237 / (0.0254 * 0.0254)}};
  const Launch launch{.speed = 2600 * 0.3048, .sight = {.height = 1.5 * 0.0254}};
  for (const auto& [range, degrees] : {std::pair{4250.0, 30.2035}, {4290.0, 33.2455}, {4300.0, 35.1172}}) {
    const auto e = must(zero_elevation(bullet, launch, {}, Fidelity::small_arms(), range), range);
    EXPECT_NEAR(e / kDegree, degrees, 5e-4) << range;
  }
  const auto beyond = zero_elevation(bullet, launch, {}, Fidelity::small_arms(), 4310);
  ASSERT_FALSE(beyond);
  EXPECT_NE(beyond.error().message.find("it is hit up to 4301 m"), std::string::npos) << beyond.error().text();
}

TEST(Zero, down_a_slope_may_take_more_than_45_degrees_above_the_line_of_sight) {
  // Along a line of sight at an angle a a parabola comes down at R = 2 v^2 cos(e) sin(e - a) / (g cos(a)^2).
  const double look = -0.5, range = 17500, v = 300;
  const auto e =
      must(zero_elevation({}, {.speed = v, .sight = {.look_angle = look}}, constant_gravity(), vacuum(), range));
  const double cosine = std::cos(look);
  const double low = 0.5 * (std::asin(range * 9.80665 * cosine * cosine / (v * v) + std::sin(look)) + look);
  EXPECT_GT(low - look, 45 * kDegree);
  EXPECT_NEAR(e, low, 1e-9);
}

}  // namespace physim::flight_zero_test
