// Launch rails against closed forms: a constant push along a rail, the moment at which thrust overcomes weight.
#include "flight/motor_support.hpp"

namespace physim::flight_rail_test {

using namespace test;

TEST(Rail, a_constant_push_along_it) {
  ProjectileDef p{.mass = 2, .force = {}};
  p.motor.thrust = {{0, 50}, {10, 50}};  // no propellant: the mass stays
  const double elevation = 40 * kDegree;
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::heun, Integrator::rk4,
                                      Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    SCOPED_TRACE(text(integrator));
    const Flight flight = fly(p, {.position = {5, 1, 2}, .elevation = elevation, .azimuth = 0.5, .rail_length = 7},
                              constant_gravity(), vacuum(integrator), {1e-12, 1e-12, 1.0 / 64}, {.time = 3});
    const auto exit = of_kind(flight, EventKind::rail_exit);
    ASSERT_EQ(exit.size(), 1u);
    const double a = 25 - kG * std::sin(elevation);
    const Vec3d bore{std::cos(elevation) * std::cos(0.5), std::sin(elevation), std::cos(elevation) * std::sin(0.5)};
    const bool exact = integrator != Integrator::semi_implicit_euler;
    EXPECT_NEAR(exit[0].time, std::sqrt(14 / a), exact ? 1e-9 : 0.02);
    EXPECT_TRUE(near(exit[0].velocity, bore * std::sqrt(14 * a), exact ? 1e-9 : 0.02));
    EXPECT_TRUE(near(exit[0].position, Vec3d{5, 1, 2} + bore * 7.0, 1e-9));
    const Vec3d held = flight.accelerations(0.5 * exit[0].time).constraint;
    EXPECT_NEAR(dot(held, bore), 0, 1e-12);
    EXPECT_NEAR(length(held), kG * std::cos(elevation), 1e-12);
  }
}

TEST(Rail, holds_until_thrust_overcomes_weight) {
  ProjectileDef p{.mass = 3};
  p.motor.thrust = {{0, 0}, {4, 80}, {5, 80}};  // 20 N/s; no propellant
  const double elevation = 75 * kDegree;
  const double pull = kG * std::sin(elevation);
  const double freed = 3 * pull / 20;
  for (const Integrator integrator :
       {Integrator::heun, Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    SCOPED_TRACE(text(integrator));
    const Flight flight = fly(p, {.elevation = elevation, .rail_length = kFar}, constant_gravity(), vacuum(integrator),
                              {1e-12, 1e-12, 0.0371}, {.time = 4});
    EXPECT_EQ(flight.at(0.99 * freed).velocity, Vec3d());
    EXPECT_EQ(flight.at(0.99 * freed).position, Vec3d());
    EXPECT_EQ(flight.accelerations(0.9 * freed).total, Vec3d());
    const double t = 3.5 - freed;  // a = 20 t / 3 from then on
    EXPECT_NEAR(flight.at(3.5).speed, 20 * t * t / 6, 1e-9);
    EXPECT_NEAR(length(flight.at(3.5).position), 20 * t * t * t / 18, integrator == Integrator::heun ? 1e-2 : 1e-9);
  }
}

TEST(Rail, too_weak_a_motor_never_leaves_it) {
  ProjectileDef p = rocket();
  p.motor.thrust = {{0, 30}, {kBurn, 30}};
  const Flight flight =
      fly(p, {.elevation = 1.5, .rail_length = 1}, {}, vacuum(Integrator::rk4), {1e-9, 1e-9, 0.1}, {.time = 20});
  EXPECT_EQ(flight.outcome(), Outcome::time_limit);
  EXPECT_EQ(flight.end().position, Vec3d());
  EXPECT_TRUE(of_kind(flight, EventKind::rail_exit).empty());
}

TEST(Rail, a_shot_that_comes_to_rest_on_it_stays_there) {
  const Flight flight = fly({}, {.speed = 5, .elevation = 1.2, .rail_length = 10}, constant_gravity(), vacuum(),
                            {1e-12, 1e-12}, {.time = 30});
  const double pull = kG * std::sin(1.2);
  EXPECT_NEAR(length(flight.end().position), 25 / (2 * pull), 1e-9);
  EXPECT_EQ(flight.end().velocity, Vec3d());
}

TEST(Rail, falling_past_its_end_is_free) {
  // Straight up and down again past the rail: only the way up is on it.
  const Flight flight =
      fly({}, {.speed = 30, .elevation = 90 * kDegree, .rail_length = 4}, constant_gravity(), vacuum(), {1e-12, 1e-12});
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  EXPECT_NEAR(flight.duration(), 60 / kG, 1e-9);
}

}  // namespace physim::flight_rail_test
