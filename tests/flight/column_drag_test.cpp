// Columns of ballistic coefficients and form factors: each shot is that of fly() with a projectile of its own.
#include "flight/batch_support.hpp"

namespace physim::flight_column_drag_test {

using namespace test;

constexpr std::size_t kShots = 67;

struct Drawn {
  std::vector<double> speed, coefficient, form_factor, temperature;
};

Drawn draw(std::size_t count) {
  Random r(41);
  Drawn d;
  for (std::size_t i = 0; i < count; ++i) {
    d.speed.push_back(r.in(200, 900)), d.coefficient.push_back(r.in(40, 400));
    d.form_factor.push_back(r.in(0.3, 3)), d.temperature.push_back(r.in(250, 310));
  }
  return d;
}

struct Ends {
  std::vector<double> time, x, y, z;
  std::vector<Outcome> outcome;

  EndColumns of(std::size_t count) {
    for (auto* column : {&time, &x, &y, &z}) column->assign(count, 7);
    outcome.assign(count, Outcome::refused);
    return {.outcome = outcome, .time = time, .x = x, .y = y, .z = z};
  }
};

void expect_as_flights(const ProjectileDef& projectile, const LaunchColumns& from, const Environment& environment,
                       const Fidelity& fidelity, const Tolerance& tolerance, const Until& until,
                       const std::string& what, const Weather& weather = {}, TaskRunner* runner = nullptr) {
  Ends ends;
  const ColumnsResult result =
      fly_columns(projectile, from, environment, fidelity, tolerance, until, ends.of(from.size()), runner, weather);
  ASSERT_FALSE(result.error) << what << ": " << result.error->text();
  const std::size_t stride = from.size() > 1000 ? 37 : 1;
  for (std::size_t i = 0; i < from.size() && !testing::Test::HasFailure(); i += stride) {
    ProjectileDef own = projectile;
    from.put(i, own);
    const Flight flight = fly(own, from.at(i), weather.at(i, environment), fidelity, tolerance, until);
    const Sample end = flight.end();
    EXPECT_EQ(ends.outcome[i], flight.outcome()) << what << ' ' << i;
    EXPECT_TRUE(same_bits(Vec3d{ends.x[i], ends.y[i], ends.z[i]}, end.position) &&
                same_bits(ends.time[i], flight.duration()))
        << what << ' ' << i << ": " << ends.x[i] - end.position.x;
  }
}

TEST(ColumnDrag, each_shot_flies_as_alone_with_its_own) {
  const Drawn d = draw(kShots);
  ProjectileDef by_form = bullet_308();
  by_form.drag.ballistic_coefficient = 0;
  const LaunchColumns coefficients{
      .common = {.position = {0, 2, 0}, .elevation = 0.03}, .speed = d.speed, .ballistic_coefficient = d.coefficient};
  LaunchColumns factors = coefficients;
  factors.ballistic_coefficient = {};
  factors.form_factor = d.form_factor;
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::rk43})
      for (const Precision precision : {Precision::float32, Precision::float64})
        for (const RotationModel rotation : {RotationModel::none, RotationModel::spin_drift}) {  // as columns, and not
          Fidelity f = Fidelity::simulation();
          f.integrator = integrator, f.precision = precision, f.rotation = rotation;
          const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-5, .step = 0.03};
          const std::string what = kernel + ' ' + test::text(integrator);
          const Until until{.time = 3, .range = 300};
          expect_as_flights(bullet_308(), coefficients, {}, f, tolerance, until, what);
          expect_as_flights(bullet_308(), coefficients, {}, f, tolerance, until, what, {.temperature = d.temperature});
          expect_as_flights(by_form, factors, {}, f, tolerance, until, what + " form");
        }
  }
  use_kernel("");
}

/// Who cannot fly as columns: zeros found for each drag, rails, steps found by pilots, drag that stands for another.
TEST(ColumnDrag, holds_on_every_way) {
  const Drawn d = draw(kShots);
  LaunchColumns from{.common = {.position = {0, 2, 0}, .sight = {.height = 0.05, .zero_range = 100}},
                     .speed = d.speed,
                     .ballistic_coefficient = d.coefficient};
  const Tolerance fixed{.step = 0.01};
  expect_as_flights(bullet_308(), from, {}, Fidelity::small_arms(), fixed, {.range = 150}, "zeroed");
  from.common.sight = {}, from.common.elevation = 0.02, from.common.rail_length = 1;
  expect_as_flights(bullet_308(), from, {}, Fidelity::simulation(), fixed, {.range = 150}, "on a rail");
  from.common.rail_length = 0;
  Fidelity quadratic = Fidelity::game();
  quadratic.drag = DragModel::linear_quadratic;
  expect_as_flights(bullet_308(), from, {}, quadratic, fixed, {.range = 150}, "k2 from the drag equation");
  Fidelity damped = Fidelity::game();
  damped.drag = DragModel::damping;
  expect_as_flights(bullet_308(), from, {}, damped, fixed, {.range = 150}, "drag that nobody asks for");
  ProjectileDef banded = bullet_308();
  banded.drag.bands = {{0, 150}, {500, 170}};
  expect_as_flights(banded, from, {}, Fidelity::simulation(), fixed, {.range = 150}, "bands");
  ProjectileDef ball = bullet_308();
  ball.drag = {.table = DragTable::constant, .coefficient = 0.4};
  expect_as_flights(ball, from, {}, Fidelity::simulation(), fixed, {.range = 150}, "a constant coefficient");
  from.form_factor = d.form_factor;
  expect_as_flights(ball, from, {}, Fidelity::simulation(), fixed, {.range = 150}, "both");
}

/// More than a part, on threads; the last shots are of another kind, and their parts do not fly as columns.
TEST(ColumnDrag, threads_change_nothing) {
  Drawn d = draw(5000);
  const auto pool = make_thread_pool(3);
  const LaunchColumns from{
      .common = {.position = {0, 2, 0}, .elevation = 0.03}, .speed = d.speed, .ballistic_coefficient = d.coefficient};
  for (int round = 0; round < 2; ++round) {
    for (TaskRunner* runner : {static_cast<TaskRunner*>(nullptr), pool.get()})
      expect_as_flights(bullet_308(), from, {}, Fidelity::simulation(), {.step = 0.02}, {.time = 2, .range = 300},
                        "threads", {}, runner);
    d.coefficient[4800] = 1e-8;  // as light as nothing
  }
}

/// Drag of a constant coefficient without gravity has a closed form: v = v0 / (1 + v0 t rho Cd pi / (8 BC)).
TEST(ColumnDrag, slows_by_the_closed_form) {
  const std::vector<double> coefficient{20, 50, 100, 400}, speed(4, 100);
  ProjectileDef ball{.mass = 0.1, .diameter = 0.05, .drag = {.coefficient = 0.5}};
  Environment thick{.atmosphere = {.density = 1.2}};
  Fidelity f = Fidelity::simulation();
  f.air = AirModel::constant, f.gravity = GravityModel::off;
  std::vector<double> vx(4);
  const ColumnsResult result = fly_columns(ball, {.speed = speed, .ballistic_coefficient = coefficient}, thick, f, {},
                                           {.ground = {}, .time = 2}, {.vx = vx});
  ASSERT_FALSE(result.error);
  for (std::size_t i = 0; i < vx.size(); ++i) {
    const double k = 1.2 * 0.5 * 3.14159265358979 / (8 * coefficient[i]);
    EXPECT_NEAR(vx[i], 100 / (1 + 100 * 2 * k), 1e-6) << i;
  }
}

TEST(ColumnDrag, bad_drag_is_refused_alone_and_bad_columns_together) {
  const std::vector<double> speed(5, 300), coefficient{171, kNan, 171, 0, -1}, form{1, 1, kInfinity, 1, 1};
  const LaunchColumns from{.common = {.position = {0, 2, 0}}, .speed = speed, .ballistic_coefficient = coefficient};
  Ends ends;
  const auto fly_from = [&](const LaunchColumns& launches) {
    return fly_columns(bullet_308(), launches, {}, Fidelity::small_arms(), {}, {}, ends.of(5));
  };
  ColumnsResult result = fly_from(from);
  ASSERT_TRUE(result.error);
  EXPECT_EQ(result.error->place, "launches.ballistic_coefficient[1]");
  EXPECT_EQ(result.refused, 3U);
  EXPECT_EQ(ends.outcome[0], Outcome::landed);
  EXPECT_EQ(ends.outcome[2], Outcome::landed);
  for (const std::size_t i : {1U, 3U, 4U}) {
    EXPECT_EQ(ends.outcome[i], Outcome::refused);
    EXPECT_TRUE(std::isnan(ends.time[i]));
  }
  result = fly_from({.common = from.common, .speed = speed, .form_factor = form});
  ASSERT_TRUE(result.error);
  EXPECT_EQ(result.error->place, "launches.form_factor[2]");
  EXPECT_EQ(result.refused, 1U);
  LaunchColumns shorter = from;
  shorter.ballistic_coefficient = shorter.ballistic_coefficient.subspan(1);
  result = fly_from(shorter);
  ASSERT_TRUE(result.error);
  EXPECT_EQ(result.error->place, "launches.ballistic_coefficient");
  EXPECT_EQ(result.refused, 5U);
  EXPECT_EQ(ends.time[0], 7) << "nothing is written";
}

}  // namespace physim::flight_column_drag_test
