// fly_columns() gives the numbers of fly_batch(), column by column.
#include "flight/batch_support.hpp"

namespace physim::flight_columns_test {

using namespace test;

struct Launches {
  std::vector<double> x, y, z, speed, elevation, azimuth;

  [[nodiscard]] LaunchColumns columns() const {
    return {.x = x, .y = y, .z = z, .speed = speed, .elevation = elevation, .azimuth = azimuth};
  }
};

/// Random launches, of which some are refused and some end at once.
Launches random_launches(int count) {
  Random r(11);
  Launches l;
  for (int i = 0; i < count; ++i) {
    l.x.push_back(r.in(-5, 5)), l.y.push_back(r.one_in(40) ? -1 : r.in(1, 3)), l.z.push_back(r.in(-9, 9));
    l.speed.push_back(r.one_in(40) ? kNan : r.in(50, 800));
    l.elevation.push_back(r.in(-0.05, 0.3)), l.azimuth.push_back(r.in(-3, 3));
  }
  l.speed[0] = -1;
  return l;
}

/// All columns of ends, with their memory.
struct Ends {
  std::vector<Outcome> outcome;
  std::vector<double> number[10];

  EndColumns of(std::size_t count) {
    outcome.resize(count);
    for (auto& column : number) column.resize(count);
    auto& n = number;
    return {.outcome = outcome,
            .time = n[0],
            .x = n[1],
            .y = n[2],
            .z = n[3],
            .vx = n[4],
            .vy = n[5],
            .vz = n[6],
            .speed = n[7],
            .drop = n[8],
            .windage = n[9]};
  }
};

void expect_as_batch(const ProjectileDef& projectile, const LaunchColumns& from, const Environment& environment,
                     const Fidelity& fidelity, const Tolerance& tolerance, const Until& until, TaskRunner* runner,
                     const std::string& what) {
  std::vector<Launch> launches;
  for (std::size_t i = 0; i < from.size(); ++i) launches.push_back(from.at(i));
  const BatchResult batch = fly_batch(projectile, launches, environment, fidelity, tolerance, until);
  Ends ends;
  const ColumnsResult result =
      fly_columns(projectile, from, environment, fidelity, tolerance, until, ends.of(launches.size()), runner);
  EXPECT_EQ(result.error ? result.error->text() : "", batch.error ? batch.error->text() : "") << what;
  EXPECT_EQ(result.kernel, batch.kernel) << what;
  EXPECT_EQ(result.fidelity_in_use.fidelity, batch.fidelity_in_use.fidelity) << what;
  EXPECT_EQ(result.fidelity_in_use.notes.size(), batch.fidelity_in_use.notes.size()) << what;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < launches.size() && !testing::Test::HasFailure(); ++i) {
    const ShotResult& shot = batch.shots[i];
    EXPECT_EQ(ends.outcome[i], shot.outcome) << what << ' ' << i;
    if (shot.outcome == Outcome::refused) {
      ++refused;
      for (const auto& column : ends.number) EXPECT_TRUE(std::isnan(column[i])) << what << ' ' << i;
      continue;
    }
    const auto& n = ends.number;
    const Vec3d place{n[1][i], n[2][i], n[3][i]}, velocity{n[4][i], n[5][i], n[6][i]};
    EXPECT_TRUE(same_bits(n[0][i], shot.time) && same_bits(place, shot.position) && same_bits(velocity, shot.velocity))
        << what << ' ' << i;
    EXPECT_EQ(n[7][i], length(shot.velocity)) << what << ' ' << i;
    if (launches.size() > 100 && i % 100 != 0) continue;
    const Sample end = fly(projectile, launches[i], environment, fidelity, tolerance, until).end();
    EXPECT_NEAR(n[8][i], end.drop, 1e-2) << what << ' ' << i;
    EXPECT_NEAR(n[9][i], end.windage, 1e-2) << what << ' ' << i;
  }
  EXPECT_EQ(result.refused, refused) << what;
}

TEST(Columns, ends_are_those_of_a_batch) {
  const Launches l = random_launches(5000);
  Environment windy{.wind = {.velocity = {2, 0, -4}}};
  Fidelity steps_by_pilots = Fidelity::simulation();
  steps_by_pilots.integrator = Integrator::rk4;
  Fidelity drifting = Fidelity::small_arms();
  drifting.rotation = RotationModel::spin_drift;
  const auto pool = make_thread_pool(3);
  for (TaskRunner* runner : {static_cast<TaskRunner*>(nullptr), pool.get()}) {
    const Until line{.time = 3, .range = 200};
    expect_as_batch(bullet_308(), l.columns(), windy, Fidelity::game(), {}, line, runner, "game");
    expect_as_batch(bullet_308(), l.columns(), windy, Fidelity::small_arms(), {}, line, runner, "small arms");
    expect_as_batch(bullet_308(), l.columns(), windy, drifting, {}, line, runner, "spin drift");
    expect_as_batch(bullet_308(), l.columns(), windy, Fidelity::arcade(), {}, {}, runner, "arcade");
    expect_as_batch(bullet_308(), l.columns(), windy, Fidelity::game(), {.step = 0.02}, line, runner, "game, a step");
    expect_as_batch(bullet_308(), l.columns(), windy, steps_by_pilots, {.position_error = 0.1}, line, runner, "pilots");
  }
}

/// Where no shot is special, lanes compute the launches themselves: every integrator, precision and kernel.
TEST(Columns, plain_launches_are_those_of_a_batch) {
  Random r(3);
  Launches l;
  for (int i = 0; i < 2500; ++i) {
    l.x.push_back(r.in(-5, 5)), l.y.push_back(r.in(1, 3)), l.z.push_back(r.in(-9, 9)), l.speed.push_back(r.in(50, 800));
    l.elevation.push_back(i % 7 == 0 ? 0 : r.in(-0.05, 0.3)), l.azimuth.push_back(i % 5 == 0 ? -0.0 : r.in(-3, 3));
  }
  LaunchColumns from = l.columns();
  from.common.sight = {.height = 0.05, .look_angle = 0.1, .cant = -0.2};
  Environment windy{.wind = {.velocity = {2, 0, -4}}};
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5, Integrator::rk43, Integrator::dop853})
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        Fidelity f = Fidelity::simulation();
        f.integrator = integrator, f.precision = precision, f.rotation = RotationModel::none;  // drift comes afterwards
        const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-5, .step = 0.03};
        expect_as_batch(bullet_308(), from, windy, f, tolerance, {.time = 3, .range = 150}, nullptr,
                        kernel + ' ' + test::text(integrator));
      }
  }
  use_kernel("");
}

/// Flights that take about as many steps are launched and judged together; behind them come some that take very
/// different ones, so that lanes stop waiting for each other.
TEST(Columns, flights_that_wait_for_each_other_are_those_flown_alone) {
  Random r(21);
  std::vector<Launch> launches;
  for (int i = 0; i < 700; ++i) {
    const bool alike = i < 200 || i >= 600;
    launches.push_back({.position = {0, 1, 0},
                        .speed = alike ? r.in(800, 840) : r.in(20, 900),
                        .elevation = alike ? r.in(0.01, 0.012) : r.in(-0.3, 1.2)});
  }
  Until until{.ground = -50, .time = 30, .range = 900};
  until.events = {{.kind = EventKind::apex}, {.kind = EventKind::mach, .value = 1}};
  for (const Integrator integrator : {Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::heun})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Fidelity f = Fidelity::small_arms();
      f.integrator = integrator, f.precision = precision;
      const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-5, .step = 0.05, .max_steps = 400};
      const BatchResult batch = fly_batch(bullet_308(), launches, {}, f, tolerance, until);
      for (std::size_t i = 0; i < launches.size() && !HasFailure(); ++i) {
        SCOPED_TRACE(test::text(integrator) + ' ' + std::to_string(i));
        const Flight alone = fly(bullet_308(), launches[i], {}, f, tolerance, until);
        const ShotResult& shot = batch.shots[i];
        EXPECT_EQ(shot.outcome, alone.outcome());
        EXPECT_TRUE(same_bits(shot.time, alone.duration()));
        EXPECT_TRUE(same_bits(shot.position, alone.end().position) && same_bits(shot.velocity, alone.end().velocity));
        EXPECT_EQ(shot.cost.steps, alone.cost().steps);
        EXPECT_EQ(shot.cost.rejected, alone.cost().rejected);
        EXPECT_EQ(shot.cost.evaluations, alone.cost().evaluations);
      }
    }
}

TEST(Columns, bodies_that_turn_fly_as_in_a_batch) {
  const std::vector<double> speed(300, 200), elevation(300, 0.1);
  ProjectileDef shell = bullet_308();
  shell.inertia.moments = {1e-7, 8e-7, 8e-7};
  shell.aero.lift = {{0, 0, 2}};
  Fidelity turning = Fidelity::simulation();
  turning.rotation = RotationModel::rigid_body;
  const LaunchColumns from{.common = {.position = {0, 2, 0}}, .speed = speed, .elevation = elevation};
  expect_as_batch(shell, from, {}, turning, {.max_steps = 60}, {.time = 0.05}, nullptr, "rigid body");
}

TEST(Columns, what_no_column_gives_stands_in_common) {
  const std::vector<double> speed{300, 400, 500};
  LaunchColumns from{.common = {.position = {1, 2, 3}, .azimuth = 0.2, .sight = {.height = 0.05, .zero_range = 100}},
                     .speed = speed};
  expect_as_batch(bullet_308(), from, {}, Fidelity::small_arms(), {}, {.range = 150}, nullptr, "zeroed");
  from.common.sight = {};
  from.common.spin.backspin = 100;
  Fidelity spinning = Fidelity::constant_air();
  expect_as_batch(bullet_308(), from, {}, spinning, {}, {}, nullptr, "spinning");
  from.common.rail_length = 1;
  expect_as_batch(bullet_308(), from, {}, Fidelity::simulation(), {}, {}, nullptr, "on a rail");
}

/// Each shot is seen from its own sight, whichever column sets it apart.
TEST(Columns, one_column_of_a_place_is_enough) {
  const std::vector<double> speed{300, 400, 500}, differs{1, 2, 3};
  for (const auto column : {&LaunchColumns::azimuth, &LaunchColumns::x, &LaunchColumns::y, &LaunchColumns::z}) {
    LaunchColumns from{.common = {.position = {0, 2, 0}, .elevation = 0.1}, .speed = speed};
    from.*column = differs;
    expect_as_batch(bullet_308(), from, {}, Fidelity::small_arms(), {}, {.range = 150}, nullptr, "one column");
  }
}

TEST(Columns, only_what_is_asked_for_is_written) {
  const Launches l = random_launches(10);
  std::vector<double> drop(10, 7);
  const ColumnsResult result = fly_columns(bullet_308(), l.columns(), {}, Fidelity::game(), {}, {}, {.drop = drop});
  EXPECT_TRUE(std::isnan(drop[0])) << "refused";
  EXPECT_NE(drop[1], 7);
  EXPECT_GE(result.refused, 1U);
}

TEST(Columns, bad_columns_refuse_all_and_write_nothing) {
  const Launches l = random_launches(10);
  std::vector<double> time(10, 7), other(9, 7);
  const auto refusal = [&](const LaunchColumns& from, const EndColumns& into, const ProjectileDef& projectile) {
    const ColumnsResult result = fly_columns(projectile, from, {}, Fidelity::game(), {}, {}, into);
    EXPECT_EQ(result.refused, 10U);
    for (const double t : time) EXPECT_EQ(t, 7);
    return result.error ? result.error->place : std::string("none");
  };
  LaunchColumns from = l.columns();
  from.z = from.z.subspan(1);
  EXPECT_EQ(refusal(from, {.time = time}, bullet_308()), "launches.z");
  EXPECT_EQ(refusal(l.columns(), {.time = time, .windage = other}, bullet_308()), "into.windage");
  from = l.columns();
  from.common.velocity = Vec3d{1, 2, 3};
  EXPECT_EQ(refusal(from, {.time = time}, bullet_308()), "launches.common.velocity");
  ProjectileDef nothing = bullet_308();
  nothing.mass = 0;
  EXPECT_EQ(refusal(l.columns(), {.time = time}, nothing), "projectile.mass");
  EXPECT_EQ(fly_columns(bullet_308(), {}, {}, Fidelity::game(), {}, {}, {}).refused, 0U) << "no shots";
}

}  // namespace physim::flight_columns_test
