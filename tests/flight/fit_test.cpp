// Fitting drag to measurements: what made the data must come back.
#include "support.hpp"

namespace physim::flight_fit_test {

using namespace test;

Launch zeroed() { return {.speed = 800, .sight = {.height = 0.05, .zero_range = 100}}; }

std::vector<Measurement> measured(const ProjectileDef& p, const Launch& launch, const Environment& e, const Fidelity& f,
                                  std::initializer_list<double> ranges) {
  const Flight flight = fly(p, launch, e, f, {}, {.ground = {}, .range = 1200});
  std::vector<Measurement> list;
  for (const double range : ranges) {
    const Result<Sample> there = flight.at_range(range);
    EXPECT_TRUE(there);
    if (there) list.push_back({.range = range, .speed = there->speed, .drop = there->drop, .time = there->time});
  }
  return list;
}

void keep(std::vector<Measurement>& list, bool speed, bool drop, bool time) {
  for (Measurement& m : list) {
    if (!speed) m.speed.reset();
    if (!drop) m.drop.reset();
    if (!time) m.time.reset();
  }
}

ProjectileDef with_bc(double factor) {
  ProjectileDef p = bullet_308();
  p.drag.ballistic_coefficient *= factor;
  return p;
}

TEST(Fit, finds_the_ballistic_coefficient_that_made_the_data) {
  const double truth = bullet_308().drag.ballistic_coefficient;
  for (int kind = 0; kind < 3; ++kind)
    for (const double guess : {0.3, 1.0, 4.0}) {
      auto data = measured(bullet_308(), zeroed(), {}, Fidelity::simulation(), {200, 500, 900});
      keep(data, kind == 0, kind == 1, kind == 2);
      const auto fit = must(fit_drag(with_bc(guess), zeroed(), {}, Fidelity::simulation(), data));
      EXPECT_TRUE(near(fit.projectile.drag.ballistic_coefficient, truth, 1e-6)) << kind << ' ' << guess;
      EXPECT_TRUE(near(fit.scale, guess, 1e-6));
      EXPECT_LT(fit.rms, 1e-3);
      EXPECT_EQ(fit.residuals.size(), 3u);
    }
}

TEST(Fit, one_speed_is_enough_and_has_no_standard_error) {
  auto data = measured(bullet_308(), zeroed(), {}, Fidelity::simulation(), {300});
  keep(data, true, false, false);
  const auto fit = must(fit_drag(with_bc(2), zeroed(), {}, Fidelity::simulation(), data));
  EXPECT_TRUE(near(fit.scale, 2, 1e-6));
  EXPECT_EQ(fit.scale_error, 0);
}

TEST(Fit, finds_the_muzzle_speed_too) {
  auto data = measured(bullet_308(), zeroed(), {}, Fidelity::simulation(), {100, 400, 800});
  keep(data, true, false, false);
  Launch slower = zeroed();
  slower.speed = 720;
  const auto fit = must(fit_drag(with_bc(1.5), slower, {}, Fidelity::simulation(), data, {.muzzle_speed = true}));
  EXPECT_NEAR(fit.launch.speed, 800, 1e-3);
  EXPECT_TRUE(near(fit.scale, 1.5, 1e-5));
}

TEST(Fit, linear_drag_is_recovered_in_closed_form) {
  // v = v0 - k x along a level path without gravity, k = k1 / m.
  Environment weightless{.gravity = {.model = GravityModel::off}};
  ProjectileDef p{.mass = 0.5, .drag = {.k1 = 0.05}};
  Fidelity f = vacuum();
  f.drag = DragModel::linear_quadratic;
  f.air = AirModel::constant;
  const std::vector<Measurement> data{{.range = 50, .speed = 100 - 0.24 * 50},
                                      {.range = 150, .speed = 100 - 0.24 * 150}};
  const auto fit = must(fit_drag(p, {.speed = 100}, weightless, f, data));
  EXPECT_NEAR(fit.projectile.drag.k1, 0.24 * 0.5, 1e-7);
}

TEST(Fit, without_a_ballistic_coefficient_the_form_factor_is_fitted) {
  ProjectileDef p{.mass = 0.0459, .diameter = 0.0427, .drag = {.coefficient = 0.3}};
  const Launch launch{.speed = 60, .elevation = 0.2};
  auto data = measured(p, launch, {}, Fidelity::constant_air(), {20, 60, 100});
  p.drag.form_factor = 2.5;
  const auto fit = must(fit_drag(p, launch, {}, Fidelity::constant_air(), data));
  EXPECT_TRUE(near(fit.projectile.drag.form_factor, 1, 1e-4));
}

TEST(Fit, the_standard_error_is_that_of_repeated_fits) {
  // Speeds with errors of 2 m/s, many times over: the spread of the fitted scales is what each of them claims.
  const auto exact = measured(bullet_308(), zeroed(), {}, Fidelity::simulation(), {100, 200, 300, 400, 500, 600});
  std::uint64_t state = 12345;
  const auto uniform = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 33) / 2147483648.0;
  };
  double sum = 0, squares = 0, claimed = 0;
  constexpr int kFits = 60;
  for (int i = 0; i < kFits; ++i) {
    auto data = exact;
    keep(data, true, false, false);
    for (Measurement& m : data) {
      double error = -6;
      for (int k = 0; k < 12; ++k) error += uniform();  // about normal, deviation 1
      *m.speed += 2 * error;
    }
    const auto fit = must(fit_drag(bullet_308(), zeroed(), {}, Fidelity::simulation(), data, {.speed_error = 2}));
    sum += fit.scale;
    squares += fit.scale * fit.scale;
    claimed += fit.scale_error / kFits;
  }
  const double spread = std::sqrt((squares - sum * sum / kFits) / (kFits - 1));
  EXPECT_TRUE(near(spread, claimed, 0.35)) << spread << ' ' << claimed;
  EXPECT_NEAR(sum / kFits, 1, 4 * spread / std::sqrt(double(kFits)));
}

TEST(Fit, a_published_table_gives_the_ballistic_coefficient_it_was_made_with) {
  // py-ballisticcalc, tests/test_trajectory.py (G7 case): 168 gr, 2750 ft/s, G7 0.223 lb/in^2, wind 5 mph at 45
  // degrees, ICAO air; its rows at 500 and 1000 yd, speeds to 1 ft/s, drops to 0.1 in.
  constexpr double kFoot = 0.3048, kInch = 0.0254, kPerSquareInch = 0.45359237 / (0.0254 * 0.0254);
  ProjectileDef p = bullet_308();
  p.drag = {.table = DragTable::g7, .ballistic_coefficient = 100};
  Environment e{.wind = {.velocity = {1.580525, 0, -1.580525}}};
  const Launch launch{.speed = 2750 * kFoot, .elevation = 1.2278391e-3, .sight = {.height = 2 * kInch}};
  const std::vector<Measurement> table{{.range = 1500 * kFoot, .speed = 1814 * kFoot, .drop = -56.2 * kInch},
                                       {.range = 3000 * kFoot, .drop = -399.9 * kInch}};
  const auto fit =
      must(fit_drag(p, launch, e, Fidelity::small_arms(), table, {.speed_error = 0.3, .drop_error = 0.01}));
  EXPECT_TRUE(near(fit.projectile.drag.ballistic_coefficient, 0.223 * kPerSquareInch, 2e-3));
  EXPECT_GT(fit.scale_error, 0);
}

TEST(Fit, what_makes_no_sense_is_refused_with_its_place) {
  const auto place = [](std::vector<Measurement> data, FitOptions options = {}, Fidelity f = Fidelity::simulation()) {
    const auto fit = fit_drag(bullet_308(), {.speed = 800}, {}, f, data, options);
    return fit ? "fitted " + std::to_string(fit->scale) : fit.error().place + ": " + fit.error().message;
  };
  EXPECT_EQ(place({}), "measurements: are none");
  EXPECT_EQ(place({{.range = 0, .speed = 800}}), "measurements: lie at the muzzle, all of them");
  EXPECT_EQ(place({{.range = 100}}), "measurements[0]: has no figure");
  EXPECT_EQ(place({{.range = -5, .speed = 700}}).find("measurements[0].range"), 0u);
  EXPECT_EQ(place({{.range = 100, .speed = -700}}).find("measurements[0].speed"), 0u);
  EXPECT_EQ(place({{.range = 100, .speed = 700}}, {.muzzle_speed = true}), "measurements: are fewer than the unknowns");
  EXPECT_EQ(place({{.range = 100, .speed = 700}}, {.speed_error = 0}).find("options.speed_error"), 0u);
  EXPECT_EQ(place({{.range = 100, .speed = 820}, {.range = 300, .speed = 850}}),
            "measurements: the measurements ask for less than a thousandth of the drag");
  EXPECT_EQ(place({{.range = 100, .speed = 500}, {.range = 300, .speed = 650}, {.range = 500, .speed = 500}}),
            "measurements[1].speed: the speed rises from 500 to 650 m/s");
  EXPECT_EQ(place({{.range = 100, .speed = 700}}, {}, vacuum()),
            "measurements: the measurements do not depend on drag");
  EXPECT_EQ(place({{.range = 1e6, .speed = 700}}).find("measurements: no scale"), 0u);
  ProjectileDef bad = bullet_308();
  bad.mass = 0;
  const std::vector<Measurement> good{{.range = 100, .speed = 700}};
  EXPECT_EQ(fit_drag(bad, {.speed = 800}, {}, {}, good).error().place, "projectile.mass");
}

}  // namespace physim::flight_fit_test
