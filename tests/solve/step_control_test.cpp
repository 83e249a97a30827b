// Step control: the controller itself, and what it makes of whole flights; corners of piecewise data.
#include "solve/step_control.hpp"

#include "support.hpp"

namespace physim::solve_step_control_test {

using namespace test;

double next(double error_squared, bool accepted, double log_previous = 0, Integrator integrator = Integrator::tsit5) {
  StepControl<double> control{log_previous, 1};
  return next_step(integrator, 1.0, error_squared, accepted, control);
}

TEST(StepControl, keeps_a_step_whose_error_is_as_allowed_but_for_safety) {
  EXPECT_NEAR(next(1, true), kSafety, 1e-15);
  EXPECT_NEAR(next(1, false), kSafety, 1e-15);
}

/// Between powers of two their logarithms lie on lines, and so do powers between whole exponents.
double line_log2(double x) {
  const double k = std::floor(std::log2(x));
  return k + x / std::exp2(k) - 1;
}
double line_exp2(double x) { return std::exp2(std::floor(x)) * (1 + x - std::floor(x)); }

TEST(StepControl, changes_with_the_fitting_root_of_the_error) {
  // h e^(-1/q) after a rejection; h e^(-0.7/q) and the memory e_previous^(0.4/q) after acceptance. By lines a power is
  // 6.2 % too much at most, and the logarithm of an error squared 0.0861 too little.
  const auto expect = [](double factor, double by_lines, double exact) {
    EXPECT_NEAR(factor / by_lines, 1, 1e-12);
    EXPECT_LT(factor / exact, 1.08);
    EXPECT_GT(factor / exact, 1 - 1e-12);
  };
  for (const Integrator integrator : kAdaptive) {
    const double q = order_of(integrator);
    for (const double e : {1.3, 2.0, 5.0, 16.0, 77.0})
      expect(next(e * e, false, 0, integrator), kSafety * line_exp2(-0.5 / q * line_log2(e * e)),
             kSafety * std::pow(e, -1 / q));
    for (const double e : {0.9, 0.25, 0.01, 1e-4})
      for (const double before : {1.0, 0.5, 0.03})
        expect(next(e * e, true, 2 * std::log2(before), integrator),
               kSafety * line_exp2(-0.35 / q * line_log2(e * e) + 0.4 / q * std::log2(before)),
               kSafety * std::pow(e, -0.7 / q) * std::pow(before, 0.4 / q));
  }
}

TEST(StepControl, leaves_a_step_where_exact_powers_with_a_safety_of_nine_tenths_would) {
  // An error that stays, e: 0.9 e^(-0.3/q) = 1.
  for (const Integrator integrator : kAdaptive) {
    const double q = order_of(integrator), e = std::pow(0.9, q / 0.3);
    EXPECT_NEAR(next(e * e, true, 2 * std::log2(e), integrator), 1, 0.02) << text(integrator);
  }
}

TEST(StepControl, is_limited_and_survives_bad_numbers) {
  EXPECT_LE(next(0, true), 5);
  EXPECT_GT(next(0, true), 1.5);
  EXPECT_NEAR(next(1e300, false), 0.1, 1e-15);
  EXPECT_NEAR(next(kNan, false), 0.1, 1e-15);
  EXPECT_NEAR(next(kInfinity, false), 0.1, 1e-15);
}

TEST(StepControl, remembers_accepted_steps_only) {
  StepControl<double> control{-3, 1};
  next_step(Integrator::tsit5, 1.0, 4.0, false, control);
  EXPECT_EQ(control.log_previous, -3);
  next_step(Integrator::tsit5, 1.0, 0.5, true, control);
  EXPECT_EQ(control.log_previous, -1);  // log2(0.5)
}

/// A bullet through the speed of sound in the standard atmosphere.
Flight transonic(Integrator integrator, double tolerance, Interpolation interpolation = Interpolation::cubic,
                 double speed = 800) {
  Fidelity f = Fidelity::simulation();
  f.integrator = integrator;
  f.interpolation = interpolation;
  f.rotation = RotationModel::none;
  return fly(bullet_308(), {.speed = speed, .elevation = 0.02}, {}, f, {tolerance, tolerance},
             {.ground = -200, .time = 3});
}

double miss(const Flight& a, const Flight& b) { return length(a.end().position - b.end().position); }

/// Misses at a tolerance of shots at 40 speeds: the ratio of two misses of one shot is a matter of luck.
struct Misses {
  double mean_square = 0, worst = 0;
};
Misses misses(Integrator integrator, double tolerance) {
  constexpr int kShots = 40;
  Misses all;
  for (int i = 0; i < kShots; ++i) {
    const auto shoot = [&](Integrator by, double within) {
      return transonic(by, within, Interpolation::cubic, 800 - 2 * i);
    };
    const double off = miss(shoot(integrator, tolerance), shoot(Integrator::dop853, 1e-14));
    all.mean_square += off * off / kShots;
    all.worst = std::max(all.worst, off);
  }
  return all;
}

TEST(AdaptiveFlight, error_follows_the_tolerance) {
  for (const Integrator integrator : kAdaptive) {
    const Misses coarse = misses(integrator, 1e-5), middle = misses(integrator, 1e-7), fine = misses(integrator, 1e-9);
    const double ratio = std::sqrt(coarse.mean_square / fine.mean_square);
    // Error per step is controlled: 100 times the tolerance means 100 ^ (p / (p + 1)) to 100 times the error.
    EXPECT_GT(ratio, 1000) << text(integrator);
    EXPECT_LT(ratio, 100000) << text(integrator);
    // 1300 m far; some tens of steps add up.
    EXPECT_LT(middle.worst, 100 * 1e-7 * 1500) << text(integrator);
    EXPECT_LT(fine.worst, 100 * 1e-9 * 1500) << text(integrator);
  }
}

std::int64_t stages_of(Integrator integrator) {
  if (integrator == Integrator::rk43) return 4;
  return integrator == Integrator::tsit5 ? 6 : 12;
}

TEST(AdaptiveFlight, rejects_steps_that_are_too_long) {
  for (const Integrator integrator : kAdaptive) {
    const Flight flight = transonic(integrator, 1e-8);
    EXPECT_GT(flight.cost().rejected, 0) << text(integrator);
    EXPECT_LT(flight.cost().rejected, flight.cost().steps / 2) << text(integrator);
    EXPECT_EQ(flight.cost().evaluations, 1 + (flight.cost().steps + flight.cost().rejected) * stages_of(integrator));
    EXPECT_EQ(static_cast<std::int64_t>(flight.step_times().size()), flight.cost().steps + 1);
  }
}

TEST(AdaptiveFlight, higher_order_takes_fewer_steps) {
  EXPECT_LT(transonic(Integrator::tsit5, 1e-10).cost().steps, transonic(Integrator::rk43, 1e-10).cost().steps);
  EXPECT_LT(transonic(Integrator::dop853, 1e-10).cost().steps, transonic(Integrator::tsit5, 1e-10).cost().steps);
}

TEST(AdaptiveFlight, never_steps_further_than_max_step) {
  for (const Integrator integrator : kAdaptive) {
    const Flight flight =
        fly({}, {.speed = 100, .elevation = 1}, constant_gravity(), vacuum(integrator), {.max_step = 0.125});
    const auto times = flight.step_times();
    for (std::size_t i = 1; i < times.size(); ++i) EXPECT_LE(times[i] - times[i - 1], 0.125 + 1e-12);
    EXPECT_GE(flight.cost().steps, static_cast<std::int64_t>(flight.duration() / 0.125));
  }
}

TEST(AdaptiveFlight, turning_the_axes_changes_nothing) {
  // Errors are measured by lengths: the same shot in another direction takes the same steps, but for rounding.
  ProjectileDef p = bullet_308();
  p.drag.table = DragTable::constant;
  Environment e{.atmosphere = {.model = AirModel::constant}};
  for (const Integrator integrator : kAdaptive) {
    Fidelity f{.integrator = integrator};
    const auto shoot = [&](double azimuth) {
      return fly(p, {.position = {0, 2, 0}, .speed = 800, .elevation = 0.5, .azimuth = azimuth}, e, f, {1e-8, 1e-8});
    };
    const Flight a = shoot(0), b = shoot(0.8);
    EXPECT_NEAR(a.cost().steps, b.cost().steps, 1) << text(integrator);
    EXPECT_NEAR(a.end().range, b.end().range, 1e-6) << text(integrator);
  }
}

/// Distance of the nearest end of a step to a Mach number [-].
double nearest(const Flight& flight, double mach) {
  double closest = 1e9;
  for (const double t : flight.step_times()) closest = std::min(closest, std::abs(flight.at(t).mach - mach));
  return closest;
}

TEST(Corners, steps_end_at_every_point_of_a_linear_drag_curve) {
  for (const Integrator integrator : kAdaptive) {
    const Flight flight = transonic(integrator, 1e-10, Interpolation::linear);
    const double from = flight.at(0).mach, to = flight.end().mach;
    ASSERT_GT(from, 2.2);
    ASSERT_LT(to, 0.95);
    int met = 0;
    for (const DragPoint& p : drag_points(DragTable::g7)) {
      if (p.mach >= from || p.mach <= to) continue;
      // To the accuracy of the dense output, by which the corner is found: an order less than that of the steps.
      EXPECT_LT(nearest(flight, p.mach), 1e-7) << text(integrator) << ' ' << p.mach;
      ++met;
    }
    EXPECT_GT(met, 20);
  }
}

TEST(Corners, linear_curves_are_as_accurate_as_smooth_ones) {
  for (const Integrator integrator : kAdaptive) {
    const double smooth = miss(transonic(integrator, 1e-10), transonic(Integrator::dop853, 1e-14));
    const double linear = miss(transonic(integrator, 1e-10, Interpolation::linear),
                               transonic(Integrator::dop853, 1e-13, Interpolation::linear));
    EXPECT_LT(linear, std::max(3 * smooth, 1e-8)) << text(integrator) << ' ' << smooth;
  }
}

TEST(Corners, custom_curves_on_odd_points_count_too) {
  ProjectileDef p = bullet_308();
  p.drag.table = DragTable::custom;
  p.drag.curve = {{0.1, 0.12}, {0.8718281, 0.14}, {1.0314159, 0.4}, {1.6180339, 0.33}, {3.3, 0.24}};
  Fidelity f{.interpolation = Interpolation::linear};
  f.rotation = RotationModel::none;  // drift by formula changes the speed, and the march does not know it
  const auto shoot = [&](Integrator integrator, double tolerance) {
    f.integrator = integrator;
    return fly(p, {.speed = 800}, {}, f, {tolerance, tolerance}, {.ground = {}, .time = 3});
  };
  const Flight flight = shoot(Integrator::tsit5, 1e-10);
  for (const double mach : {1.0314159, 1.6180339}) EXPECT_LT(nearest(flight, mach), 1e-7) << mach;
  EXPECT_LT(miss(flight, shoot(Integrator::dop853, 1e-13)), 1e-6);
}

TEST(Corners, layers_of_the_atmosphere_and_edges_of_bands_are_met) {
  ProjectileDef p = bullet_308();
  p.drag.bands = {{0, 120}, {250, 140}, {500, 160}};
  const Flight flight =
      fly(p, {.position = {0, 12000, 0}, .speed = 800, .elevation = -0.6}, {},
          {.integrator = Integrator::tsit5, .rotation = RotationModel::none}, {1e-10, 1e-10}, {.ground = 9000});
  double layer = 1e9, band = 1e9;
  for (const double t : flight.step_times()) {
    layer = std::min(layer, std::abs(flight.at(t).position.y - 11019.067832000108));
    band = std::min(band, std::abs(flight.at(t).speed - 500));
  }
  EXPECT_LT(layer, 1e-6);
  EXPECT_LT(band, 1e-6);
}

TEST(Corners, jumps_never_stall_a_flight) {
  // Drag jumps at the edge of a band, wind at a step of its profile: wherever the edge lies, the flight goes on.
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const Integrator integrator : kAdaptive)
      for (int i = 0; i < 40; ++i) {
        ProjectileDef p = bullet_308();
        p.drag.bands = {{0, 160}, {200 + 13.7 * i, 110}, {760, 160}};
        Environment e{.wind = {.profile = {{0, {1, 0, 0}}, {3.3 + 17.1 * i, {-7, 1, 5}}},
                               .by = WindAxis::range,
                               .interpolation = WindInterpolation::step}};
        Fidelity f{.integrator = integrator, .precision = precision};
        const double tolerance = precision == Precision::float32 ? 1e-5 : 1e-9;
        const Flight flight =
            fly(p, {.position = {0, 1, 0}, .speed = 800, .elevation = 0.03}, e, f, {tolerance, tolerance});
        ASSERT_EQ(flight.outcome(), Outcome::landed) << text(integrator) << ' ' << name(precision) << ' ' << i;
        EXPECT_NEAR(flight.end().position.y, 0, 1e-3);
        EXPECT_LT(flight.cost().steps + flight.cost().rejected, 2000);
      }
}

TEST(Corners, errors_at_jumps_are_within_the_tolerance) {
  ProjectileDef p = bullet_308();
  p.drag.bands = {{0, 160}, {450, 110}, {700, 160}};
  const auto shoot = [&](Integrator integrator, double tolerance) {
    return fly(p, {.speed = 800}, {}, {.integrator = integrator}, {tolerance, tolerance}, {.ground = {}, .time = 1.5});
  };
  const Flight exact = shoot(Integrator::dop853, 1e-13);
  for (const Integrator integrator : kAdaptive)
    for (const double tolerance : {1e-6, 1e-8, 1e-10})
      EXPECT_LT(miss(shoot(integrator, tolerance), exact), 100 * tolerance * 1000)
          << text(integrator) << ' ' << tolerance;
}

TEST(Corners, the_end_of_a_burn_is_met_exactly) {
  ProjectileDef p{.force = {0, 30, 0}, .force_duration = 1.2345};
  for (const Integrator integrator : kAdaptive) {
    const Flight flight = fly(p, {}, constant_gravity(), vacuum(integrator), {1e-12, 1e-12});
    double closest = 1e9;
    for (const double t : flight.step_times()) closest = std::min(closest, std::abs(t - 1.2345));
    EXPECT_LT(closest, 1e-11) << text(integrator);
  }
}

}  // namespace physim::solve_step_control_test
