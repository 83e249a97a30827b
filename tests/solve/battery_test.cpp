// One battery that every integrator must pass: order, dense output, reversal, events.
#include "solve/problems.hpp"

namespace physim::solve_battery_test {

using namespace test;

/// What an integrator promises, and steps at which its error is far above rounding and below the onset of its order.
struct Promise {
  int order;
  int dense_order;  // of the interpolant alone; 0: Hermite, no less accurate than the method
  int steps_fall, steps_orbit, steps_air;
};

constexpr Promise promise_of(Integrator integrator) {
  switch (integrator) {
    case Integrator::heun: return {2, 0, 64, 64, 64};
    case Integrator::rk4:
    case Integrator::rk43: return {4, 0, 16, 32, 32};
    case Integrator::tsit5: return {5, 4, 32, 64, 64};
    case Integrator::dop853: return {8, 7, 4, 8, 8};
    case Integrator::classic:
    case Integrator::explicit_euler:
    case Integrator::semi_implicit_euler:
    case Integrator::automatic:
    case Integrator::adaptive: break;
  }
  return {1, 0, 256, 512, 256};
}

/// The observed order over n and 2n steps. With e(h) = A h^p + B h^(p+1) + ..., 2^(p+1) e(h/2) - e(h) is rid of the
/// second term, which hides the first one until rounding does: Tsit5's A is very small.
double order_of(const Prepared& p, double duration, int n, const State<double>& exact, int nominal) {
  const auto error = [&](int steps_taken) { return steps(p, duration, steps_taken) - exact; };
  const auto leading = [&](int m) {
    const State<double> e = error(2 * m) * std::pow(2.0, nominal + 1) - error(m);
    return length(e.x) + length(e.v);
  };
  return observed_order(leading(n), leading(2 * n), 2);
}

template <class T>
class Battery : public testing::Test {
 protected:
  static constexpr Integrator kIntegrator = T::value;
  static constexpr Promise kPromise = promise_of(T::value);
  static constexpr bool kClassic = T::value == Integrator::classic;
};

template <Integrator I>
using Is = std::integral_constant<Integrator, I>;
using Integrators = testing::Types<Is<Integrator::classic>, Is<Integrator::explicit_euler>,
                                   Is<Integrator::semi_implicit_euler>, Is<Integrator::heun>, Is<Integrator::rk4>,
                                   Is<Integrator::rk43>, Is<Integrator::tsit5>, Is<Integrator::dop853>>;
struct Names {
  template <class T>
  static std::string GetName(int) {
    return text(T::value);
  }
};
TYPED_TEST_SUITE(Battery, Integrators, Names);

TYPED_TEST(Battery, order_on_a_fall_with_quadratic_drag) {
  const int order = this->kPromise.order;
  EXPECT_NEAR(order_of(prepare_tanh_fall(this->kIntegrator), 2, this->kPromise.steps_fall, tanh_fall(2), order), order,
              0.1);
}

TYPED_TEST(Battery, order_on_an_orbit) {
  if (this->kClassic) GTEST_SKIP() << "the original loop knows only constant gravity";
  const int order = this->kPromise.order;
  const Prepared p = prepare_kepler(this->kIntegrator, 0.7);
  EXPECT_NEAR(order_of(p, 4, this->kPromise.steps_orbit, kepler(4.7), order), order, 0.1);
}

/// A smooth ball with Cd by Reynolds number in the standard atmosphere, a wind that changes with height and a turning
/// Earth: whatever were held fixed over a step instead of being evaluated in every stage would spoil the order.
Prepared prepare_air_flight(Integrator integrator, double diameter, double mass) {
  ProjectileDef ball{.mass = mass, .diameter = diameter, .drag = {.table = DragTable::sphere}};
  Environment e{.wind = {.profile = {{-1000, {-30, 3, -10}}, {3000, {10, -3, 20}}}},
                .earth = {.latitude = 0.8, .azimuth = 1, .rotation_rate = 0.05}};
  Fidelity f = Fidelity::simulation();
  f.integrator = integrator;
  f.rotation = RotationModel::none;
  return Prepared(ball, {.velocity = Vec3d{30, 60, -5}}, e, f);
}

TYPED_TEST(Battery, order_with_every_effect_at_work) {
  if (this->kClassic) GTEST_SKIP() << "the original loop knows only constant gravity over a flat Earth";
  // The large ball flies at the foot of the drag crisis, which is too steep for order 8 to show before rounding does.
  const bool small = this->kIntegrator == Integrator::dop853;
  const auto prepared = [&](Integrator i) { return prepare_air_flight(i, small ? 0.01 : 0.04, small ? 0.001 : 0.01); };
  const double duration = small ? 2 : 1;
  const State<double> exact = steps(prepared(Integrator::dop853), duration, 150);
  const Prepared p = prepared(this->kIntegrator);
  const int order = this->kPromise.order;
  EXPECT_NEAR(order_of(p, duration, this->kPromise.steps_air, exact, order), order, 0.1);
}

TYPED_TEST(Battery, dense_output_meets_both_ends) {
  const Prepared p = prepare_tanh_fall(this->kIntegrator);
  steps(p, 2, 10, [&](const DenseStep& s) {
    EXPECT_LT(distance(s.at(0), s.n0.y), 1e-15);
    EXPECT_LT(distance(s.at(1), s.n1.y), 1e-14);
  });
}

/// Largest error anywhere inside the steps.
template <class Exact>
double dense_error(const Prepared& p, double duration, int n, const Exact& exact) {
  double worst = 0;
  steps(p, duration, n, [&](const DenseStep& s) {
    for (double theta = 0.1; theta < 0.95; theta += 0.1)
      worst = std::max(worst, distance(s.at(theta), exact(s.n0.t + theta * (s.n1.t - s.n0.t))));
  });
  return worst;
}

TYPED_TEST(Battery, dense_output_is_no_less_accurate_than_the_steps) {
  const Prepared fall = prepare_tanh_fall(this->kIntegrator);
  int n = 2 * this->kPromise.steps_fall;
  EXPECT_GE(observed_order(dense_error(fall, 2, n, tanh_fall), dense_error(fall, 2, 2 * n, tanh_fall), 2),
            this->kPromise.order - 0.1);
  if (this->kClassic) return;
  const Prepared orbit = prepare_kepler(this->kIntegrator, 0.7);
  const auto exact = [](double t) { return kepler(0.7 + t); };
  n = 4 * this->kPromise.steps_orbit;
  EXPECT_GE(observed_order(dense_error(orbit, 4, n, exact), dense_error(orbit, 4, 2 * n, exact), 2),
            this->kPromise.order - 0.1);
}

TYPED_TEST(Battery, interpolants_have_their_own_order) {
  if (this->kPromise.dense_order == 0) GTEST_SKIP() << "Hermite interpolation: the test before this one says it all";
  // Inside a single step the error is that of the interpolant: h^(order + 1).
  const Prepared p = prepare_kepler(this->kIntegrator, 0.7);
  const auto error = [&](double h) { return dense_error(p, h, 1, [](double t) { return kepler(0.7 + t); }); };
  const double h = this->kIntegrator == Integrator::dop853 ? 0.2 : 0.04;
  EXPECT_NEAR(observed_order(error(h), error(h / 2), 2), this->kPromise.dense_order + 1, 0.1)
      << error(h) << ' ' << error(h / 2);
}

TYPED_TEST(Battery, velocity_of_the_dense_output_follows_its_position) {
  const Prepared p =
      prepare_kepler(this->kIntegrator == Integrator::classic ? Integrator::rk4 : this->kIntegrator, 0.7);
  const int n = this->kPromise.steps_orbit;
  // Both come within the method's error of the solution; slopes inside a step are an order less accurate.
  const double gate = 10 * dense_error(p, 4, n, [](double t) { return kepler(0.7 + t); }) * n;
  double worst = 0;
  steps(p, 4, n, [&](const DenseStep& s) {
    const double h = s.n1.t - s.n0.t, d = 1e-2;
    const Vec3d slope =
        ((s.at(0.5 + d).x - s.at(0.5 - d).x) * 8.0 - (s.at(0.5 + 2 * d).x - s.at(0.5 - 2 * d).x)) * (1 / (12 * d * h));
    worst = std::max(worst, length(slope - s.at(0.5).v));
  });
  EXPECT_LT(worst, gate);
}

TYPED_TEST(Battery, a_step_there_and_back_returns) {
  // No explicit method is its own inverse; what holds is that a step of h followed by one of -h misses the start by
  // h^(order + 1) or less, since both steps miss the solution by that much.
  if (this->kClassic) GTEST_SKIP() << "the original loop carries its acceleration from frame to frame";
  const Prepared p = prepare_kepler(this->kIntegrator, 0.7);
  const auto miss = [&](double h) {
    Step<double> s = first_step_of(p);
    s.h = h;
    step_once(p, s);
    Step<double> back{};
    back.t = h;
    back.h = -h;
    back.start = s.end;
    back.slope[0] = {s.end.v, p.acceleration(h, s.end)};
    step_once(p, back);
    return distance(back.end, s.start);
  };
  const double h = this->kIntegrator == Integrator::dop853 ? 0.6 : this->kPromise.order >= 4 ? 0.05 : 0.01;
  EXPECT_GE(observed_order(miss(h), miss(h / 2), 2), this->kPromise.order + 1 - 0.1) << miss(h) << ' ' << miss(h / 2);
}

/// How far the time of landing of a tanh fall is off, and how far the event lies off the ground it watches.
struct Landing {
  double time_error;
  double residual;
};
Landing land(Integrator integrator, const Tolerance& tolerance) {
  ProjectileDef p{.drag = {.k2 = 1}};
  Environment e = constant_gravity();
  e.gravity.acceleration = 1;
  Fidelity f = vacuum(integrator);
  f.drag = DragModel::linear_quadratic;
  const Flight flight = fly(p, {.position = {0, 1.5, 0}}, e, f, tolerance, {.ground = 0.25});
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  EXPECT_EQ(flight.events().back().kind, EventKind::ground);
  return {std::abs(flight.duration() - std::acosh(std::exp(1.25))), std::abs(flight.end().position.y - 0.25)};
}

TYPED_TEST(Battery, events_are_located_to_the_accuracy_of_the_dense_output) {
  if (is_adaptive(this->kIntegrator)) {
    for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
      const Landing landing = land(this->kIntegrator, {tolerance, tolerance});
      EXPECT_LT(landing.time_error, 20 * tolerance);
      EXPECT_LT(landing.residual, 1e-15);
    }
    return;
  }
  // An odd ratio, so that the event lies elsewhere in its step.
  const double h = this->kPromise.order == 1 ? 1.0 / 4001 : this->kPromise.order == 2 ? 1.0 / 401 : 1.0 / 61;
  const Landing coarse = land(this->kIntegrator, {.step = h});
  const Landing fine = land(this->kIntegrator, {.step = h / 3.17});
  EXPECT_NEAR(observed_order(coarse.time_error, fine.time_error, 3.17), this->kPromise.order, 0.15)
      << coarse.time_error << ' ' << fine.time_error;
  EXPECT_LT(coarse.residual, 1e-15);
}

// the closed forms of analytic/vacuum_parabola.csv: methods of order 2 and above are exact in vacuum, whatever the
// step.
TYPED_TEST(Battery, parabolas_are_exact_from_order_2_on) {
  if (this->kPromise.order < 2) GTEST_SKIP() << "order 1";
  for (const double step : {0.001, 0.7, 20.0, 1000.0}) {
    const Flight flight = fly({}, {.speed = 100, .elevation = 75 * kDegree}, constant_gravity(),
                              vacuum(this->kIntegrator), {.step = step, .max_step = step});
    EXPECT_TRUE(near(flight.duration(), 19.699404512021297523, 1e-12)) << step;
    EXPECT_TRUE(near(flight.end().position, {509.85810648896412129, 0, 0}, 1e-12)) << step;
    ASSERT_EQ(flight.events().size(), 2u) << step;
    EXPECT_TRUE(near(flight.events()[0].position.y, 475.70408951691929628, 1e-12)) << step;
  }
}

TYPED_TEST(Battery, conservative_flights_run_backwards) {
  if (this->kPromise.order < 4) GTEST_SKIP() << "would need very small steps";
  Fidelity f = vacuum(this->kIntegrator);
  f.gravity = GravityModel::inverse_square;
  f.earth = EarthModel::sphere;
  const Tolerance tolerance{1e-12, 1e-9, 0.5};
  const Launch launch{.position = {0, 5000, 0}, .speed = 2500, .elevation = 0.9};
  const Flight there = fly({}, launch, {}, f, tolerance);
  Launch turned{.position = there.end().position, .velocity = -there.end().velocity};
  const Flight back = fly({}, turned, {}, f, tolerance, {.ground = {}, .time = there.duration()});
  EXPECT_EQ(back.outcome(), Outcome::time_limit);
  EXPECT_LT(length(back.end().position - launch.position), 1e-4);
  EXPECT_LT(length(back.end().velocity + there.at(0).velocity), 1e-6);
}

/// Largest relative error of the energy in each of some turns of the orbit.
std::vector<double> energy_errors(Integrator integrator, int turns) {
  const Prepared p = prepare_kepler(integrator, 0);
  const auto energy = [](const State<double>& s) {
    return 0.5 * dot(s.v, s.v) - 1 / length(Vec3d{s.x.x, s.x.y + 1, s.x.z});
  };
  const double period = 2 * 3.14159265358979323846 * std::pow(1 / (1 - kEccentricity), 1.5);
  const double exact = energy(p.body.launch);
  std::vector<double> worst(static_cast<std::size_t>(turns), 0.0);
  steps(p, turns * period, turns * 1000, [&](const DenseStep& s) {
    const auto turn = std::min(static_cast<std::size_t>(s.n0.t / period), worst.size() - 1);
    worst[turn] = std::max(worst[turn], std::abs(energy(s.n1.y) / exact - 1));
  });
  return worst;
}

TEST(SemiImplicitEuler, keeps_the_energy_of_an_orbit_bounded) {
  const auto symplectic = energy_errors(Integrator::semi_implicit_euler, 50);
  EXPECT_LT(symplectic.back(), 1.1 * symplectic.front());
  const auto plain = energy_errors(Integrator::explicit_euler, 5);
  EXPECT_GT(plain.back(), 2 * plain.front()) << "the plain one must drift, or this test could not fail";
}

TEST(Classic, frame_is_position_then_velocity_then_damping_then_next_acceleration) {
  // The original's loop, written out: p += v dt; v += a dt; v *= d^dt; a = g from the next frame on.
  ProjectileDef p{.drag = {.damping = 0.9}};
  const double dt = 1.0 / 60;
  Fidelity f = Fidelity::classic();
  f.precision = Precision::float64;
  const Flight flight =
      fly(p, {.speed = 40, .elevation = 0.6}, constant_gravity(), f, {.step = dt}, {.ground = {}, .time = 2});
  Vec3d x{}, v{40 * std::cos(0.6), 40 * std::sin(0.6), 0}, a{};
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(near(flight.at(i * dt).position, x, 1e-13, 1e-13)) << i;
    EXPECT_TRUE(near(flight.at(i * dt).velocity, v, 1e-13)) << i;
    x += v * dt;
    v += a * dt;
    v *= std::pow(0.9, dt);
    a = {0, -9.80665, 0};
  }
}

}  // namespace physim::solve_battery_test
