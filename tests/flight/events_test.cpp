// Events: each kind, direction and terminal flag, against times worked by hand.
#include "support.hpp"

namespace physim::flight_events_test {

using namespace test;

constexpr double kG = 9.80665;

/// 50 m/s up and 20 m/s downrange in vacuum from 10 m: x = 20 t, y = 10 + 50 t - g t^2 / 2.
Flight lob(const Until& until, Integrator integrator = Integrator::tsit5,
           const Tolerance& tolerance = {1e-9, 1e-9, 0.01}, Precision precision = Precision::float64) {
  Launch launch{.position = {0, 10, 0}, .velocity = Vec3d{20, 50, 0}};
  Fidelity f = vacuum(integrator);
  f.precision = precision;
  return fly({}, launch, constant_gravity(), f, tolerance, until);
}

double time_at_height(double y, bool rising) {
  const double root = std::sqrt(2500 + 2 * kG * (10 - y));
  return (50 + (rising ? -root : root)) / kG;
}

TEST(Events, each_kind_is_found_where_it_should_be) {
  Until until{.events = {{EventKind::height, 100},
                         {EventKind::range, 100},
                         {EventKind::speed, 30},
                         {EventKind::time, 3.25},
                         {EventKind::mach, 0.1}}};
  const Flight flight = lob(until);
  const auto heights = of_kind(flight, EventKind::height);
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_NEAR(heights[0].time, time_at_height(100, true), 1e-12);
  EXPECT_EQ(heights[0].direction, Crossing::rising);
  EXPECT_NEAR(heights[1].time, time_at_height(100, false), 1e-12);
  EXPECT_EQ(heights[1].direction, Crossing::falling);
  const auto range = of_kind(flight, EventKind::range);
  ASSERT_EQ(range.size(), 1u);
  EXPECT_NEAR(range[0].time, 5, 1e-12);
  EXPECT_NEAR(range[0].position.x, 100, 1e-12);
  const auto speeds = of_kind(flight, EventKind::speed);  // vy = +-sqrt(900 - 400)
  ASSERT_EQ(speeds.size(), 2u);
  EXPECT_NEAR(speeds[0].time, (50 - std::sqrt(500)) / kG, 1e-11);
  EXPECT_EQ(speeds[0].direction, Crossing::falling);
  EXPECT_NEAR(speeds[1].time, (50 + std::sqrt(500)) / kG, 1e-11);
  EXPECT_EQ(speeds[1].direction, Crossing::rising);
  const auto times = of_kind(flight, EventKind::time);
  ASSERT_GE(times.size(), 1u);
  EXPECT_NEAR(times[0].time, 3.25, 1e-14);
  EXPECT_TRUE(of_kind(flight, EventKind::mach).empty()) << "there is no sound in a vacuum: Mach is 0, as in samples";
  const auto apex = of_kind(flight, EventKind::apex);
  ASSERT_EQ(apex.size(), 1u);
  EXPECT_NEAR(apex[0].time, 50 / kG, 1e-12);
  const auto ground = of_kind(flight, EventKind::ground);
  ASSERT_EQ(ground.size(), 1u);
  EXPECT_NEAR(ground[0].time, time_at_height(0, false), 1e-12);
  EXPECT_TRUE(std::is_sorted(flight.events().begin(), flight.events().end(),
                             [](const Event& a, const Event& b) { return a.time < b.time; }));
}

TEST(Events, direction_chooses_among_the_crossings) {
  for (const auto& [direction, expected] :
       {std::pair{Crossing::any, 2u}, {Crossing::rising, 1u}, {Crossing::falling, 1u}}) {
    const Flight flight = lob({.events = {{EventKind::height, 60, direction}, {EventKind::speed, 40, direction}}});
    const auto heights = of_kind(flight, EventKind::height);
    ASSERT_EQ(heights.size(), expected);
    EXPECT_EQ(of_kind(flight, EventKind::speed).size(), expected);
    const bool rises = direction != Crossing::falling;
    EXPECT_EQ(heights[0].direction, rises ? Crossing::rising : Crossing::falling);
    EXPECT_NEAR(heights[0].time, time_at_height(60, rises), 1e-12);
  }
}

TEST(Events, a_terminal_one_ends_the_flight_and_later_ones_do_not_happen) {
  const struct {
    EventSpec spec;
    double time;
  } cases[] = {{{EventKind::height, 60, Crossing::any, true}, time_at_height(60, true)},
               {{EventKind::height, 60, Crossing::falling, true}, time_at_height(60, false)},
               {{EventKind::apex, 0, Crossing::falling, true}, 50 / kG},
               {{EventKind::speed, 40, Crossing::rising, true}, (50 + std::sqrt(1200)) / kG},
               {{EventKind::time, 1.5, Crossing::any, true}, 1.5},
               {{EventKind::range, 77, Crossing::rising, true}, 77.0 / 20}};
  for (const auto& c : cases) {
    const Flight flight = lob({.events = {c.spec, {EventKind::time, 9.9}}});
    EXPECT_EQ(flight.outcome(), Outcome::event) << name(c.spec.kind);
    EXPECT_NEAR(flight.duration(), c.time, 1e-11) << name(c.spec.kind);
    EXPECT_EQ(flight.events().back().kind, c.spec.kind);
    EXPECT_EQ(flight.events().back().time, flight.duration());
    for (const Event& e : flight.events()) EXPECT_LE(e.time, flight.duration());
    EXPECT_TRUE(same_bits(flight.events().back().position, flight.end().position));
    EXPECT_TRUE(same_bits(flight.events().back().velocity, flight.end().velocity));
  }
}

TEST(Events, mach_is_crossed_where_there_is_air) {
  Fidelity f = vacuum();
  f.air = AirModel::constant;  // of the standard's sea level; nothing drags
  for (const bool terminal : {false, true}) {
    const Flight flight =
        fly({}, {.position = {0, 10, 0}, .speed = std::sqrt(2900.0), .elevation = std::atan2(50.0, 20.0)},
            constant_gravity(), f, {},
            {.events = {{EventKind::mach, 40 / 340.29410778693532873, Crossing::any, terminal}}});
    const auto machs = of_kind(flight, EventKind::mach);
    ASSERT_EQ(machs.size(), terminal ? 1u : 2u);
    EXPECT_NEAR(machs[0].time, (50 - std::sqrt(1200)) / kG, 1e-11);
    EXPECT_NEAR(length(machs[0].velocity), 40, 1e-9);
    EXPECT_EQ(flight.outcome(), terminal ? Outcome::event : Outcome::landed);
  }
}

TEST(Events, the_earliest_terminal_event_wins) {
  Until until;
  until.range = 60;  // 3 s
  until.time = 2.5;
  EXPECT_EQ(lob(until).outcome(), Outcome::time_limit);
  EXPECT_NEAR(lob(until).duration(), 2.5, 1e-14);
  until.time = 3.5;
  EXPECT_EQ(lob(until).outcome(), Outcome::reached_range);
  EXPECT_NEAR(lob(until).duration(), 3, 1e-12);
  until.range = 1e5;
  until.time = 3600;
  EXPECT_EQ(lob(until).outcome(), Outcome::landed);
}

TEST(Events, a_step_may_cross_a_height_twice) {
  // One step far longer than the flight: up through the height and down again inside it, then the ground.
  Until until{.events = {{EventKind::height, 120, Crossing::any}, {EventKind::height, 20, Crossing::falling}}};
  for (const Integrator integrator :
       {Integrator::heun, Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    const Flight flight = lob(until, integrator, {.step = 500});
    const auto heights = of_kind(flight, EventKind::height);
    ASSERT_EQ(heights.size(), 3u) << text(integrator);
    EXPECT_NEAR(heights[0].time, time_at_height(120, true), 1e-11) << text(integrator);
    EXPECT_NEAR(heights[1].time, time_at_height(120, false), 1e-11) << text(integrator);
    EXPECT_NEAR(heights[2].time, time_at_height(20, false), 1e-11) << text(integrator);
    EXPECT_EQ(flight.outcome(), Outcome::landed);
    EXPECT_NEAR(flight.duration(), time_at_height(0, false), 1e-11) << text(integrator);
  }
}

TEST(Events, a_step_over_the_apex_that_ends_where_it_began_still_lands) {
  // From the ground: both ends of the huge step are below it or on it.
  for (const double step : {10.0, 10.2, 40.0}) {
    const Flight flight =
        fly({}, {.speed = 50, .elevation = 90 * kDegree}, constant_gravity(), vacuum(Integrator::rk4), {.step = step});
    EXPECT_EQ(flight.outcome(), Outcome::landed) << step;
    EXPECT_NEAR(flight.duration(), 100 / kG, 1e-11) << step;
  }
}

TEST(Events, a_flight_from_the_ground_upwards_does_not_land_at_once) {
  const Flight up = fly({}, {.speed = 10, .elevation = 0.5}, constant_gravity(), vacuum());
  EXPECT_NEAR(up.duration(), 20 * std::sin(0.5) / kG, 1e-12);
}

TEST(Events, a_flight_that_starts_at_or_below_the_ground_downwards_lands_at_once) {
  for (const double y : {0.0, -3.0}) {
    const Flight down = fly({}, {.position = {7, y, 0}, .speed = 10, .elevation = -0.5}, constant_gravity(), vacuum());
    EXPECT_EQ(down.outcome(), Outcome::landed);
    EXPECT_EQ(down.duration(), 0);
    EXPECT_EQ(down.end().position, (Vec3d{7, y, 0}));
    ASSERT_EQ(down.events().size(), 1u);
    EXPECT_EQ(down.events()[0].kind, EventKind::ground);
  }
}

TEST(Events, a_flight_from_below_the_ground_may_rise_through_it_and_land) {
  const Flight flight = fly({}, {.position = {0, -5, 0}, .speed = 50, .elevation = 1}, constant_gravity(), vacuum());
  const double vy = 50 * std::sin(1.0);
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  EXPECT_NEAR(flight.duration(), (vy + std::sqrt(vy * vy - 2 * kG * 5)) / kG, 1e-11);
}

TEST(Events, a_range_event_follows_the_line_of_sight) {
  Launch launch{.position = {3, 2, 1}, .speed = 300, .elevation = 0.6, .azimuth = 0.8, .sight = {.look_angle = 0.4}};
  const Flight flight = fly({}, launch, constant_gravity(), vacuum(), {}, {.ground = {}, .range = 500});
  ASSERT_EQ(flight.outcome(), Outcome::reached_range);
  EXPECT_NEAR(flight.end().range, 500, 1e-11);
  const Vec3d f{std::cos(0.4) * std::cos(0.8), std::sin(0.4), std::cos(0.4) * std::sin(0.8)};
  EXPECT_NEAR(dot(flight.end().position - launch.position, f), 500, 1e-11);
}

TEST(Events, mach_is_through_the_air_and_speed_is_over_the_ground) {
  Environment e = constant_gravity();
  e.wind.velocity = {-50, 0, 0};
  Fidelity f = Fidelity::small_arms();
  const Flight flight = fly(bullet_308(), {.position = {0, 100, 0}, .speed = 800}, e, f, {},
                            {.events = {{EventKind::mach, 1.5}, {EventKind::speed, 500}}});
  const auto mach = of_kind(flight, EventKind::mach);
  ASSERT_EQ(mach.size(), 1u);
  EXPECT_NEAR(flight.at(mach[0].time).mach, 1.5, 1e-7);  // Flight::at() adds the spin drift's rate
  EXPECT_NEAR(length(of_kind(flight, EventKind::speed)[0].velocity), 500, 1e-3);
  EXPECT_LT(mach[0].velocity.x, 1.5 * 341 - 49);
}

// The end of a fixed step and the start of the next one must be the same to every event, or one that falls between them
// is lost and the flight never ends.
TEST(Events, no_event_falls_between_two_steps) {
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const Integrator integrator : {Integrator::classic, Integrator::semi_implicit_euler, Integrator::rk4})
      for (const double step : {1.0 / 60, 0.1, 0.05, 0.01, 1.0 / 128})
        for (int i = 1; i <= 60; ++i) {
          Until until{.ground = {}, .time = i * step * (i % 2 ? 1 : 3)};
          const Flight flight = lob(until, integrator, {.step = step, .max_steps = 2000}, precision);
          ASSERT_EQ(flight.outcome(), Outcome::time_limit) << text(integrator) << ' ' << step << ' ' << i;
          ASSERT_NEAR(flight.duration(), until.time, 3e-7 * until.time);
        }
}

TEST(Events, no_place_falls_between_two_steps) {
  // Uniform motion that ends its steps on, or a rounding beside, the watched place.
  Environment none = constant_gravity();
  none.gravity.acceleration = 0;
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const Integrator integrator : {Integrator::explicit_euler, Integrator::rk4})
      for (const double speed : {1.0, 3.0, 7.0})
        for (int i = 1; i <= 100; ++i) {
          Fidelity f = vacuum(integrator);
          f.precision = precision;
          const double place = 0.1 * i;
          Launch launch{.position = {0, 20, 0}, .speed = speed};
          Flight flight = fly({}, launch, none, f, {.step = 0.1}, {.ground = {}, .time = 12, .range = place});
          ASSERT_EQ(flight.outcome(), Outcome::reached_range) << place << ' ' << speed;
          launch = {.position = {0, 20, 0}, .speed = speed, .elevation = -90 * kDegree};
          flight = fly({}, launch, none, f, {.step = 0.1}, {.ground = 20 - place, .time = 12});
          ASSERT_EQ(flight.outcome(), Outcome::landed) << place << ' ' << speed;
        }
}

}  // namespace physim::flight_events_test
