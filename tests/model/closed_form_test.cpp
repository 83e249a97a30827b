// Closed forms against exact figures and a series summed in long double.
#include "model/closed_form.hpp"

#include "support.hpp"

namespace physim::model_closed_form_test {

using test::kDegree;
using test::near;
using test::Prepared;

Fidelity closed(DragModel drag, WindModel wind = WindModel::constant) {
  Fidelity f = test::vacuum();
  f.motion = Motion::closed_form;
  f.drag = drag;
  f.wind = wind;
  return f;
}

// the closed forms of analytic/vacuum_parabola.csv
TEST(ClosedForm, parabola) {
  const struct {
    double v, elevation, time, range, apex;
  } rows[] = {{10, 15, 0.52784395303701215471, 5.0985810648896412129, 0.34154016972044825},
              {300, 45, 43.262894944953527927, 9177.4459168013541831, 2294.3614792003385458},
              {1000, 75, 196.99404512021297523, 50985.810648896412129, 47570.408951691929628}};
  for (const auto& row : rows) {
    const Flight flight = fly({}, {.speed = row.v, .elevation = row.elevation * kDegree}, test::constant_gravity(),
                              closed(DragModel::off));
    EXPECT_EQ(flight.outcome(), Outcome::landed);
    EXPECT_TRUE(near(flight.duration(), row.time, 1e-12));
    EXPECT_TRUE(near(flight.end().position, {row.range, 0, 0}, 1e-12));
    EXPECT_TRUE(near(flight.events()[0].position.y, row.apex, 1e-12));
  }
}

// the closed forms of analytic/linear_drag.csv (Lambert W)
TEST(ClosedForm, linear_drag_with_wind) {
  const struct {
    double v, elevation, k, wind, time, range, t_apex, apex, x_half, y_half, vx, vy;
  } rows[] = {
      {100, 45, 0.1, 0, 12.055447604995009673, 495.30794713484958352, 5.4293355232889570984, 174.67084909193101311,
       320.11273497219054347, 172.94962522276990125, 21.179883405169794088, -47.512877136869559172},
      {300, 45, 0.05, 0, 34.04203622019407919, 3469.2074551495625112, 14.662471139708394241, 1366.8462350748586588,
       2431.1773839511217366, 1340.6116083096458314, 38.671661598486131761, -121.70630014280200937},
      {100, 45, 0.1, 10, 12.055447604995009673, 545.8153015458716536, 5.4293355232889570984, 174.67084909193101311,
       335.11919586856398825, 172.94962522276990125, 28.184595569062596754, -47.512877136869559172},
      {30, 70, 2, -5, 3.3706737447986720528, -9.232078377753174621, 0.95472079091717385804, 9.4140829896646742533,
       -1.0586088025360476518, 7.7146335444259021124, -4.9819763927103092951, -4.8642390558526457654}};
  for (const auto& row : rows) {
    ProjectileDef p{.mass = 0.25};
    p.drag.k1 = row.k * p.mass;
    Environment e = test::constant_gravity();
    e.wind.velocity = {row.wind, 0, 0};
    const Launch launch{.speed = row.v, .elevation = row.elevation * kDegree};
    const Flight flight = fly(p, launch, e, closed(DragModel::linear_quadratic));
    EXPECT_TRUE(near(flight.duration(), row.time, 1e-12));
    EXPECT_TRUE(near(flight.end().position, {row.range, 0, 0}, 1e-12, 1e-12));
    EXPECT_TRUE(near(flight.end().velocity, {row.vx, row.vy, 0}, 1e-12));
    EXPECT_TRUE(near(flight.at(flight.duration() / 2).position, {row.x_half, row.y_half, 0}, 1e-12));
    EXPECT_TRUE(near(flight.events()[0].time, row.t_apex, 1e-10));
    EXPECT_TRUE(near(flight.events()[0].position.y, row.apex, 1e-12));
    // Integrators must find the same.
    Fidelity force = closed(DragModel::linear_quadratic);
    force.motion = Motion::force;
    for (const Integrator integrator : test::kAdaptive) {
      force.integrator = integrator;
      const Flight flown = fly(p, launch, e, force, {1e-13, 1e-13});
      EXPECT_TRUE(near(flown.end().position, {row.range, 0, 0}, 1e-9, 1e-9)) << test::text(integrator);
      EXPECT_TRUE(near(flown.duration(), row.time, 1e-9)) << test::text(integrator);
    }
  }
}

TEST(ClosedForm, damping_is_linear_drag) {
  ProjectileDef damped, linear;
  damped.drag.damping = 0.8;
  linear.drag.k1 = -std::log(0.8);
  const Launch launch{.speed = 50, .elevation = 1};
  const Flight a = fly(damped, launch, test::constant_gravity(), closed(DragModel::damping));
  const Flight b = fly(linear, launch, test::constant_gravity(), closed(DragModel::linear_quadratic));
  EXPECT_TRUE(near(a.end().position, b.end().position, 1e-13));
}

/// The exact state by the power series in long double: nothing cancels for k t below 1.
State<double> exact(double k, double t, const Vec3d& v0, double g) {
  long double e1 = 0, e2 = 0, term = 1;  // sums of (-z)^n / (n+1)! and (-z)^n / (n+2)!
  const long double z = static_cast<long double>(k) * t;
  for (int n = 0; n < 60; ++n) {
    e1 += term / (n + 1);
    e2 += term / ((n + 1.0L) * (n + 2));
    term *= -z / (n + 1);
  }
  const double decayed = static_cast<double>(t * e1),
               fallen = static_cast<double>(static_cast<long double>(t) * t * e2);
  const double kept = static_cast<double>(1 - z * e1);
  Vec3d x = v0 * decayed, v = v0 * kept;
  x.y -= g * fallen;
  v.y -= g * decayed;
  return {x, v};
}

TEST(ClosedForm, keeps_its_digits_for_weak_drag) {
  const Vec3d v0{30, 40, -5};
  for (const double k : {1e-18, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 0.0999, 0.1, 0.1001, 0.3}) {
    ProjectileDef p{.drag = {.k1 = k}};
    const Prepared prepared(p, {.velocity = v0}, test::constant_gravity(), closed(DragModel::linear_quadratic));
    for (const double t : {1e-3, 1.0, 10.0}) {
      const State<double> s = closed_form(prepared.conditions(), prepared.body, t);
      const State<double> e = exact(k, t, v0, 9.80665);
      EXPECT_TRUE(near(s.x, e.x, 2e-15)) << k << ' ' << t;
      EXPECT_TRUE(near(s.v, e.v, 2e-15)) << k << ' ' << t;
    }
  }
}

TEST(ClosedForm, without_drag_is_the_limit_of_weak_drag) {
  ProjectileDef weak{.drag = {.k1 = 1e-15}};
  const Launch launch{.speed = 100, .elevation = 0.7};
  const Flight a = fly(weak, launch, test::constant_gravity(), closed(DragModel::linear_quadratic));
  const Flight b = fly({}, launch, test::constant_gravity(), closed(DragModel::off));
  EXPECT_TRUE(near(a.end().position, b.end().position, 1e-12));
}

TEST(ClosedForm, strong_drag_ends_at_the_terminal_velocity) {
  ProjectileDef p{.drag = {.k1 = 50}};
  Environment e = test::constant_gravity();
  e.wind.velocity = {3, 0, -2};
  const Flight flight =
      fly(p, {.speed = 1000}, e, closed(DragModel::linear_quadratic), {}, {.ground = {}, .time = 100});
  EXPECT_TRUE(near(flight.end().velocity, {3, -9.80665 / 50, -2}, 1e-13));
}

TEST(ClosedForm, velocity_is_the_derivative_of_position) {
  ProjectileDef p{.drag = {.k1 = 0.3}};
  Environment e = test::constant_gravity();
  e.wind.velocity = {3, 1, -2};
  const Prepared prepared(p, {.velocity = Vec3d{20, 30, 5}}, e, closed(DragModel::linear_quadratic));
  const auto at = [&](double t) { return closed_form(prepared.conditions(), prepared.body, t); };
  for (const double t : {0.5, 3.2, 3.4, 9.0}) {  // k t = 1 lies between the second and the third
    const double h = 1e-3;
    EXPECT_TRUE(near((at(t + h).x - at(t - h).x) * (1 / (2 * h)), at(t).v, 1e-7)) << t;
    EXPECT_TRUE(near((at(t + h).v - at(t - h).v) * (1 / (2 * h)), prepared.acceleration(t, at(t)), 1e-6)) << t;
  }
}

TEST(ClosedForm, float32_stays_within_half_a_millimetre_at_100_seconds) {
  Fidelity f = closed(DragModel::off);
  const Launch launch{.speed = 500, .elevation = 80 * kDegree};
  const Flight d = fly({}, launch, test::constant_gravity(), f);
  f.precision = Precision::float32;
  const Flight s = fly({}, launch, test::constant_gravity(), f);
  // Positions of 12 km in float32 have a spacing of 1 mm: one rounding per operation.
  EXPECT_TRUE(near(s.at(100).position, d.at(100).position, 4 * 6e-8, 0));
}

}  // namespace physim::model_closed_form_test
