// Batches whose shots have weather of their own: each flies as fly() lets it fly in its own environment.
#include "flight/batch_support.hpp"

namespace physim::flight_weather_test {

using namespace test;

struct Days {
  std::vector<double> wind_x, wind_y, wind_z, temperature, pressure, humidity, density;

  [[nodiscard]] Weather all() const {
    return {.wind_x = wind_x,
            .wind_y = wind_y,
            .wind_z = wind_z,
            .temperature = temperature,
            .pressure = pressure,
            .humidity = humidity,
            .density = density};
  }
};

Days random_days(std::size_t count) {
  Random r(5);
  Days d;
  for (std::size_t i = 0; i < count; ++i) {
    d.wind_x.push_back(r.in(-9, 9)), d.wind_y.push_back(r.in(-1, 1)), d.wind_z.push_back(r.in(-9, 9));
    d.temperature.push_back(r.in(250, 310)), d.pressure.push_back(r.in(8e4, 1.05e5)), d.humidity.push_back(r.in(0, 1));
    d.density.push_back(r.in(0.5, 1.5));
  }
  return d;
}

/// Each kind of weather alone, and all of it.
std::vector<std::pair<std::string, Weather>> kinds_of(const Days& d) {
  return {{"wind", {.wind_x = d.wind_x, .wind_y = d.wind_y, .wind_z = d.wind_z}},
          {"crosswind", {.wind_z = d.wind_z}},
          {"temperature", {.temperature = d.temperature}},
          {"pressure", {.pressure = d.pressure}},
          {"humidity", {.humidity = d.humidity}},
          {"density", {.density = d.density}},
          {"all", d.all()}};
}

void expect_as_flights(const BatchResult& batch, const ProjectileDef& projectile, const std::vector<Launch>& launches,
                       const Environment& environment, const Weather& weather, const Fidelity& fidelity,
                       const Tolerance& tolerance, const Until& until, const std::string& what) {
  ASSERT_EQ(batch.shots.size(), launches.size()) << what;
  for (std::size_t i = 0; i < launches.size() && !testing::Test::HasFailure(); ++i) {
    const Flight flight = fly(projectile, launches[i], weather.at(i, environment), fidelity, tolerance, until);
    const ShotResult& shot = batch.shots[i];
    const Sample end = flight.end();
    ASSERT_EQ(shot.outcome, flight.outcome()) << what << ' ' << i;
    EXPECT_EQ(shot.cost.steps, flight.cost().steps) << what << ' ' << i;
    EXPECT_TRUE(same_bits(shot.time, flight.duration()) && same_bits(shot.position, end.position) &&
                same_bits(shot.velocity, end.velocity))
        << what << ' ' << i << ": " << shot.position.x - end.position.x;
  }
}

std::vector<Launch> random_launches(std::size_t count, double speed, double elevation) {
  Random r(8);
  std::vector<Launch> launches(count);
  for (Launch& l : launches) {
    l.position = {r.in(-5, 5), r.in(1, 3), 0};
    l.speed = r.in(0.7, 1) * speed, l.elevation = r.in(0.5, 1) * elevation, l.azimuth = r.in(-0.1, 0.1);
  }
  return launches;
}

TEST(Weather, each_shot_flies_as_alone_in_its_own) {
  const Days days = random_days(37);
  const auto launches = random_launches(37, 800, 0.2);
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::rk43})
      for (const Precision precision : {Precision::float32, Precision::float64})
        for (const AirModel air : {AirModel::constant, AirModel::exponential, AirModel::isa}) {
          Fidelity f = Fidelity::simulation();
          f.integrator = integrator, f.precision = precision, f.air = air;
          const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-5, .step = 0.05};
          const Until until{.time = 2};
          for (const auto& [name, weather] : kinds_of(days))
            expect_as_flights(
                fly_batch(bullet_308(), launches, {.altitude = 300}, f, tolerance, until, nullptr, weather),
                bullet_308(), launches, {.altitude = 300}, weather, f, tolerance, until,
                kernel + ' ' + name + ' ' + test::text(integrator));
        }
  }
  use_kernel("");
}

/// A wind of columns that moves the environment's profile: by height and by range, straight and in steps, for those
/// that read the profile and for those that know one wind.
TEST(Weather, winds_move_a_profile) {
  Days days = random_days(23);
  days.wind_y.clear();
  const auto launches = random_launches(23, 300, 0.6);
  ProjectileDef rocket = bullet_308();
  rocket.mass = 20, rocket.diameter = 0.15, rocket.drag = {.coefficient = 0.45};
  rocket.inertia.moments = {0.06, 12, 12};
  rocket.aero.lift = {{.value = 9}}, rocket.aero.pitching = {{.value = -18}};
  rocket.aero.pitch_damping = {{.value = -400}};
  for (const bool is_rigid : {false, true})
    for (const WindModel wind : {WindModel::profile, WindModel::constant})
      for (const WindAxis by : {WindAxis::height, WindAxis::range})
        for (const WindInterpolation interpolation : {WindInterpolation::linear, WindInterpolation::step})
          for (const Vec3d& common : {Vec3d{}, Vec3d{2, 0, 1}})
            for (const std::size_t points : {1U, 3U}) {
              Fidelity f = Fidelity::simulation();
              f.wind = wind, f.rotation = is_rigid ? RotationModel::rigid_body : RotationModel::none;
              Environment e{.wind = {.velocity = common, .by = by, .interpolation = interpolation}};
              e.wind.profile = {{0, {2, 0, 1}}, {90.3, {4.1, 0.3, -1}}, {200, {7, 0, 0}}};
              e.wind.profile.resize(points);
              const Weather weather{.wind_x = days.wind_x, .wind_z = days.wind_z, .moves_profile = true};
              const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-5};
              const Until until{.time = 4};
              const ProjectileDef& p = is_rigid ? rocket : bullet_308();
              expect_as_flights(fly_batch(p, launches, e, f, tolerance, until, nullptr, weather), p, launches, e,
                                weather, f, tolerance, until, is_rigid ? "rigid" : "point");
              LaunchColumns columns{.common = launches[0]};
              columns.common.speed = 0;
              std::vector<double> speed, x(23), z(23);
              for (const Launch& l : launches) speed.push_back(l.speed);
              columns.speed = speed;
              const auto ends = fly_columns(p, columns, e, f, tolerance, until, {.x = x, .z = z}, nullptr, weather);
              ASSERT_FALSE(ends.error) << ends.error->text();
              for (std::size_t i = 0; i < 23; ++i) {
                Launch launch = launches[0];
                launch.speed = speed[i];
                const Vec3d end = fly(p, launch, weather.at(i, e), f, tolerance, until).end().position;
                EXPECT_TRUE(same_bits(x[i], end.x) && same_bits(z[i], end.z)) << i << ": " << x[i] - end.x;
              }
            }
  // What it should come to: a profile that is moved is another profile.
  Environment e{.wind = {.velocity = {1, 0, 2}, .profile = {{0, {2, 0, 1}}, {100, {4, 0, 0}}}}};
  const std::vector<double> gust = {4};
  const Environment moved = Weather{.wind_x = gust, .moves_profile = true}.at(0, e);
  EXPECT_EQ(moved.wind.profile[0].velocity, (Vec3d{5, 0, 1}));
  EXPECT_EQ(moved.wind.profile[1].velocity, (Vec3d{7, 0, 0}));
  EXPECT_EQ(moved.wind.velocity, (Vec3d{4, 0, 2}));
}

/// Above the lowest layer of the atmosphere lanes have layers of their own.
TEST(Weather, holds_at_all_heights) {
  const Days days = random_days(21);
  auto launches = random_launches(21, 1500, 1.5);
  launches[3].position.y = 40e3;
  ProjectileDef shell = bullet_308();
  shell.mass = 40;
  shell.diameter = 0.155;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Fidelity f = Fidelity::simulation();
    f.integrator = Integrator::tsit5, f.precision = precision;
    const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-3};
    const Environment mountain{.altitude = 1000, .atmosphere = {.station_altitude = 12e3}};
    for (const auto& [name, weather] : kinds_of(days)) {
      const BatchResult batch = fly_batch(shell, launches, mountain, f, tolerance, {.time = 90}, nullptr, weather);
      expect_as_flights(batch, shell, launches, mountain, weather, f, tolerance, {.time = 90}, name);
    }
  }
}

/// What reads the air elsewhere: spheres by their Reynolds number, spin drift and jump, bodies that turn, closed forms,
/// zeros, events by Mach number, an automatic step.
TEST(Weather, every_rung_reads_its_own) {
  const Days days = random_days(9);
  const auto launches = random_launches(9, 300, 0.5);
  const auto expect = [&](const ProjectileDef& projectile, const std::vector<Launch>& from, const Fidelity& f,
                          const Tolerance& tolerance, const Until& until, const std::string& what) {
    for (const auto& [name, weather] : kinds_of(days))
      for (const WindModel wind : {f.wind, WindModel::off}) {  // off: a rung that knows no wind reads none
        Fidelity g = f;
        g.wind = wind;
        expect_as_flights(fly_batch(projectile, from, {}, g, tolerance, until, nullptr, weather), projectile, from, {},
                          weather, g, tolerance, until, what + ", " + name);
      }
  };
  ProjectileDef ball = bullet_308();
  ball.mass = 0.046, ball.diameter = 0.043, ball.drag = {.table = DragTable::sphere};
  expect(ball, launches, Fidelity::simulation(), {}, {.time = 2}, "a ball");
  Fidelity drifting = Fidelity::small_arms();
  drifting.rotation = RotationModel::spin_drift, drifting.aerodynamic_jump = true;
  expect(bullet_308(), launches, drifting, {.step = 0.01}, {.time = 1}, "spin drift");
  expect(bullet_308(), launches, Fidelity::game(), {.step = 0.01}, {.time = 1}, "k2 of the drag equation at launch");
  ProjectileDef damped = bullet_308();
  damped.drag.damping = 0.7;
  expect(damped, launches, Fidelity::arcade(), {}, {.time = 1}, "closed form");
  ProjectileDef body = bullet_308();
  body.inertia.moments = {1e-7, 8e-7, 8e-7};
  body.aero.lift = {{0, 0, 2}};
  Fidelity turning = Fidelity::simulation();
  turning.rotation = RotationModel::rigid_body;
  expect(body, launches, turning, {.max_steps = 60}, {.time = 0.05}, "rigid body");
  auto zeroed = launches;
  for (Launch& l : zeroed) l = {.speed = 800, .sight = {.height = 0.05, .zero_range = 100}};
  expect(bullet_308(), zeroed, Fidelity::small_arms(), {.step = 0.01}, {.range = 200}, "zeroed");
  Until slow{.time = 1};
  slow.events.push_back({.kind = EventKind::mach, .value = 0.7, .terminal = true});
  expect(bullet_308(), launches, Fidelity::simulation(), {}, slow, "to Mach 0.7");
}

/// Sent through columns and lent threads the numbers stay.
TEST(Weather, columns_and_threads_change_nothing) {
  const std::size_t count = 2100;  // two parts
  Days days = random_days(count);
  std::vector<double> speed, elevation, x(count), y(count), z(count), time(count);
  Random r(2);
  for (std::size_t i = 0; i < count; ++i) speed.push_back(r.in(200, 800)), elevation.push_back(r.in(0.01, 0.2));
  const LaunchColumns from{.common = {.position = {0, 2, 0}}, .speed = speed, .elevation = elevation};
  std::vector<Launch> launches;
  for (std::size_t i = 0; i < count; ++i) launches.push_back(from.at(i));
  const auto pool = make_thread_pool(3);
  const Until until{.time = 2, .range = 300};
  const auto expect_same_ends = [&](const Fidelity& f, const Weather& weather, const std::string& what) {
    const Tolerance tolerance{.relative = 1e-5, .step = 0.02};
    const Environment hill{.altitude = 500};
    const BatchResult batch = fly_batch(bullet_308(), launches, hill, f, tolerance, until, nullptr, weather);
    const BatchResult lent = fly_batch(bullet_308(), launches, hill, f, tolerance, until, pool.get(), weather);
    expect_same(batch, lent, what);
    for (TaskRunner* runner : {static_cast<TaskRunner*>(nullptr), pool.get()}) {
      const ColumnsResult result = fly_columns(bullet_308(), from, hill, f, tolerance, until,
                                               {.time = time, .x = x, .y = y, .z = z}, runner, weather);
      EXPECT_EQ(result.error ? result.error->text() : "", batch.error ? batch.error->text() : "") << what;
      for (std::size_t i = 0; i < count && !HasFailure(); ++i) {
        if (batch.shots[i].outcome == Outcome::refused) continue;
        EXPECT_TRUE(same_bits(Vec3d{x[i], y[i], z[i]}, batch.shots[i].position) &&
                    same_bits(time[i], batch.shots[i].time))
            << what << ' ' << i;
      }
    }
  };
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Fidelity f = Fidelity::simulation();
      f.integrator = Integrator::rk4, f.precision = precision, f.rotation = RotationModel::none;  // so lanes compute it
      for (const auto& [name, weather] : kinds_of(days)) expect_same_ends(f, weather, kernel + ' ' + name);
      for (f.air = AirModel::vacuum; f.air != AirModel::isa; f.air = static_cast<AirModel>(static_cast<int>(f.air) + 1))
        expect_same_ends(f, days.all(), kernel + ' ' + std::string(name(f.air)));
    }
  }
  use_kernel("");
  days.temperature[100] = 400, days.humidity[2000] = kNan, days.density[2099] = 0;
  expect_same_ends(Fidelity::simulation(), days.all(), "some refused");
}

/// Lanes hold the lowest layer's air alone where all shots seem to stay in it. Here an upwind of a gale's strength, a
/// parachute and a place near its upper end carry some out of it, and flat shots near it do so at a trial step alone.
TEST(Weather, is_that_of_all_layers_for_who_is_blown_out_of_the_lowest) {
  const std::size_t count = 70;
  Random r(7);
  std::vector<double> speed, elevation, upwards, temperature;
  for (std::size_t i = 0; i < count; ++i) {
    speed.push_back(r.in(20, 60)), elevation.push_back(r.in(-0.2, 0.3));
    upwards.push_back(i % 7 == 0 ? r.in(20, 60) : r.in(-1, 1)), temperature.push_back(r.in(250, 310));
  }
  ProjectileDef chute{.mass = 1, .diameter = 0.6, .drag = {.coefficient = 1}};
  ProjectileDef bullet = bullet_308();
  std::vector<double> x(count), y(count), z(count), time(count);
  int left = 0;
  for (const ProjectileDef& flown : {chute, bullet})
    for (const double height : {9000.0, 10900.0, 10995.0})
      for (const Integrator integrator :
           {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::rk43, Integrator::tsit5})
        for (const Precision precision : {Precision::float32, Precision::float64}) {
          Fidelity f = Fidelity::simulation();
          f.integrator = integrator, f.precision = precision, f.rotation = RotationModel::none;
          f.interpolation = Interpolation::cubic;
          const LaunchColumns from{.common = {.position = {0, height, 0}}, .speed = speed, .elevation = elevation};
          const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-4, .step = 0.1};
          const Until until{.time = 60};
          const ColumnsResult result =
              fly_columns(flown, from, {}, f, tolerance, until, {.time = time, .x = x, .y = y, .z = z}, nullptr,
                          {.wind_y = upwards, .temperature = temperature});
          ASSERT_EQ(result.refused, 0U);
          for (std::size_t i = 0; i < count; ++i) {
            Environment own;
            own.wind.velocity.y = upwards[i], own.atmosphere.temperature = temperature[i];
            const Flight flight = fly(flown, from.at(i), own, f, tolerance, until);
            ASSERT_TRUE(same_bits(Vec3d{x[i], y[i], z[i]}, flight.end().position) &&
                        same_bits(time[i], flight.duration()))
                << i << ' ' << height << ' ' << test::text(integrator) << ' ' << y[i] - flight.end().position.y;
            left += flight.end().position.y > 11020;
          }
        }
  EXPECT_GT(left, 50);
}

/// Stages of one long step pass above the lowest layer, and its end lies below again.
TEST(Weather, is_that_of_all_layers_for_a_stage_above_the_lowest) {
  const std::size_t count = 40;
  Random r(9);
  std::vector<double> speed, upwards, temperature;
  for (std::size_t i = 0; i < count; ++i)
    speed.push_back(r.in(22, 23)), upwards.push_back(r.in(48, 52)), temperature.push_back(r.in(250, 310));
  ProjectileDef ball{.mass = 0.5, .diameter = 0.1, .drag = {.coefficient = 0.5}};
  const LaunchColumns from{.common = {.position = {0, 10990, 0}, .elevation = 1.5}, .speed = speed};
  const Tolerance tolerance{.step = 7};
  std::vector<double> y(count), vy(count);
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Fidelity f = Fidelity::simulation();
    f.integrator = Integrator::rk4, f.precision = precision, f.rotation = RotationModel::none;
    const ColumnsResult result = fly_columns(ball, from, {}, f, tolerance, {.time = 7}, {.y = y, .vy = vy}, nullptr,
                                             {.wind_y = upwards, .temperature = temperature});
    ASSERT_EQ(result.refused, 0U);
    int below = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Environment own;
      own.wind.velocity.y = upwards[i], own.atmosphere.temperature = temperature[i];
      const Sample end = fly(ball, from.at(i), own, f, tolerance, {.time = 7}).end();
      below += end.position.y < 10999 ? 1 : 0;
      ASSERT_TRUE(same_bits(y[i], end.position.y) && same_bits(vy[i], end.velocity.y))
          << i << ' ' << y[i] - end.position.y;
    }
    EXPECT_EQ(below, 40);
  }
}

/// In float32 steps are cut at corners that are found with weather rounded to float. Where nothing has corners that
/// weather moves, or where rounding changes no number of it, flights are those of fly() to the bit; others differ, by
/// some times their tolerance.
TEST(Weather, in_float32_moves_corners_by_its_rounding_alone) {
  const std::size_t count = 60;
  const auto launches = random_launches(count, 800, 0.1);
  Random r(4);
  Days exact, days;
  for (std::size_t i = 0; i < count; ++i) {
    exact.wind_x.push_back(std::round(r.in(-36, 36)) / 4), exact.wind_z.push_back(std::round(r.in(-36, 36)) / 4);
    days.wind_x.push_back(r.in(-9, 9)), days.wind_z.push_back(r.in(-9, 9)), days.temperature.push_back(r.in(250, 310));
  }
  ProjectileDef banded = bullet_308();
  banded.drag.bands = {{700, 100}, {500, 110}, {0, 120}};
  Fidelity cubic = Fidelity::simulation();
  cubic.integrator = Integrator::rk43, cubic.precision = Precision::float32, cubic.interpolation = Interpolation::cubic;
  cubic.rotation = RotationModel::none;
  Fidelity linear = cubic;
  linear.interpolation = Interpolation::linear;
  const Tolerance tolerance{.relative = 1e-5, .absolute = 1e-5};
  const Until until{.time = 1.5};
  const Weather windy{.wind_x = exact.wind_x, .wind_z = exact.wind_z},
      of_days{.wind_x = days.wind_x, .wind_z = days.wind_z, .temperature = days.temperature};
  const auto fly_all = [&](const ProjectileDef& projectile, const Fidelity& f, const Weather& weather) {
    return fly_batch(projectile, launches, {}, f, tolerance, until, nullptr, weather);
  };
  const auto expect_equal = [&](const ProjectileDef& projectile, const Fidelity& f, const Weather& weather,
                                const char* what) {
    expect_as_flights(fly_all(projectile, f, weather), projectile, launches, {}, weather, f, tolerance, until, what);
  };
  expect_equal(bullet_308(), cubic, of_days, "no corners");
  expect_equal(bullet_308(), linear, windy, "knots, a wind that is a float");
  expect_equal(banded, cubic, windy, "bands, a wind that is a float");
  Fidelity wide = linear;
  wide.precision = Precision::float64;
  expect_equal(bullet_308(), wide, of_days, "float64");
  int differ = 0, far = 0;
  for (const ProjectileDef& projectile : {bullet_308(), banded}) {
    const BatchResult batch = fly_all(projectile, linear, of_days);
    for (std::size_t i = 0; i < count; ++i) {
      const Sample end = fly(projectile, launches[i], of_days.at(i, {}), linear, tolerance, until).end();
      EXPECT_TRUE(near(batch.shots[i].position, end.position, 1e-4)) << i;
      EXPECT_TRUE(near(batch.shots[i].velocity, end.velocity, 1e-4)) << i;
      differ += same_bits(batch.shots[i].position, end.position) ? 0 : 1;
      far += near(batch.shots[i].position, end.position, 3e-5) ? 0 : 1;
    }
  }
  EXPECT_GT(differ, 0) << "then weather.hpp may promise more";
  // Steps that begin some roundings before a corner, and had part of their slopes from before it, went 50 mm astray.
  EXPECT_LE(far, 2);
}

/// Drag is proportional to density: in constant air without gravity a projectile of Cd constant slows down as
/// v = v0 / (1 + v0 t rho Cd A / (2 m)).
TEST(Weather, density_slows_by_the_closed_form) {
  const std::vector<double> density{0.3, 0.9, 1.2, 1.8};
  ProjectileDef ball{.mass = 0.1, .diameter = 0.05, .drag = {.coefficient = 0.5}};
  Fidelity f = Fidelity::simulation();
  f.air = AirModel::constant, f.gravity = GravityModel::off;
  const std::vector<Launch> launches(density.size(), Launch{.speed = 100});
  const BatchResult batch =
      fly_batch(ball, launches, {}, f, {}, {.ground = {}, .time = 2}, nullptr, {.density = density});
  for (std::size_t i = 0; i < density.size(); ++i) {
    const double k = density[i] * 0.5 * (3.14159265358979 * 0.05 * 0.05 / 4) / (2 * 0.1);
    EXPECT_NEAR(batch.shots[i].velocity.x, 100 / (1 + 100 * 2 * k), 1e-6) << i;
  }
}

TEST(Weather, bad_days_are_refused_alone_and_bad_columns_together) {
  std::vector<double> temperature{290, kNan, 290, 500}, short_column{1, 2, 3};
  const std::vector<Launch> launches(4, Launch{.position = {0, 2, 0}, .speed = 300});
  const auto fly_in = [&](const Weather& weather) {
    return fly_batch(bullet_308(), launches, {}, Fidelity::small_arms(), {}, {}, nullptr, weather);
  };
  const BatchResult some = fly_in({.temperature = temperature});
  ASSERT_TRUE(some.error);
  EXPECT_EQ(some.error->place, "environment.atmosphere.temperature");
  EXPECT_EQ(some.shots[1].outcome, Outcome::refused);
  EXPECT_EQ(some.shots[3].outcome, Outcome::refused);
  EXPECT_EQ(some.shots[0].outcome, Outcome::landed);
  EXPECT_EQ(some.shots[2].outcome, Outcome::landed);
  const BatchResult all = fly_in({.wind_z = short_column});
  ASSERT_TRUE(all.error);
  EXPECT_EQ(all.error->place, "weather.wind_z");
  for (const ShotResult& shot : all.shots) EXPECT_EQ(shot.outcome, Outcome::refused);
  const std::vector<double> vacuum{0, 1, 1, -1};
  const BatchResult thin = fly_in({.density = vacuum});
  ASSERT_TRUE(thin.error);
  EXPECT_EQ(thin.error->place, "weather.density[0]");
  EXPECT_EQ(thin.shots[3].outcome, Outcome::refused);
  EXPECT_EQ(thin.shots[1].outcome, Outcome::landed);
}

}  // namespace physim::flight_weather_test
