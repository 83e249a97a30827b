// The air of a sounding: levels, what lies between them, and flights through it.
#include "model/air_levels.hpp"

#include "model/humid_air.hpp"
#include "world/world_support.hpp"

namespace physim::model_air_levels_test {

Environment with_levels(std::vector<AirPoint> profile) { return {.atmosphere = {.profile = std::move(profile)}}; }

/// A morning with an inversion below a humid layer; pressures as a radiosonde measures them, to 10 Pa.
std::vector<AirPoint> morning() {
  return {{100, 279.2, 100800, 0.9},          {350, 284.6, 97800, 0.75},         {1000, 282.1, 90450, 0.7},
          {1500, 279.0, 85090, 0.95},         {3000, 270.4, 70490, 0.3},         {5600, 253.1, 50020, 0.2},
          {9200, 227.9, 30010, 0.1},          {11000, 216.0, 22810, 0.02},       {13500, 218.2, 15400, std::nullopt},
          {18500, 212.4, 7000, std::nullopt}, {26000, 220.9, 2180, std::nullopt}};
}

/// A ball of steel that a drag coefficient slows down, falling straight down from `height`.
Flight fall(const Environment& e, double height, Precision precision = Precision::float64,
            Integrator integrator = Integrator::dop853) {
  ProjectileDef ball{.mass = 10, .diameter = 0.15, .drag = {.table = DragTable::constant, .coefficient = 0.47}};
  Fidelity f = Fidelity::simulation();
  f.integrator = integrator, f.precision = precision, f.gravity = GravityModel::constant, f.earth = EarthModel::flat;
  const double error = precision == Precision::float32 ? 1e-5 : 1e-11;
  return fly(ball, {.position = {0, height, 0}}, e, f, {.relative = error, .absolute = error}, {.ground = 0.0});
}

/// All levels have what was measured there, with the density and the sound speed of moist air.
TEST(AirLevels, have_what_was_measured) {
  const Environment e = with_levels(morning());
  for (const AirPoint& p : morning()) {
    const AirSample air = *air_at(e, p.altitude);
    EXPECT_NEAR(air.temperature, p.temperature, 1e-10);
    EXPECT_NEAR(air.pressure, *p.pressure, 1e-9 * *p.pressure);
    const double humidity = p.humidity.value_or(0);
    EXPECT_NEAR(air.density, moist_density(p.temperature, *p.pressure, humidity), 1e-12);
    EXPECT_NEAR(air.sound_speed, moist_sound_speed(p.temperature, *p.pressure, humidity), 1e-10);
  }
}

/// Between levels, below the first and above the last nothing jumps, and temperatures lie on straight lines.
TEST(AirLevels, are_joined_without_a_jump) {
  const Environment e = with_levels(morning());
  AirSample before = *air_at(e, -4999);
  for (double z = -4998; z < 85999; z += 1) {
    const AirSample air = *air_at(e, z);
    ASSERT_LT(std::abs(air.density / before.density - 1), 4e-4) << z;
    ASSERT_LT(air.density, before.density * 1.00001) << z;
    ASSERT_LT(std::abs(air.sound_speed - before.sound_speed), 0.02) << z;
    ASSERT_LT(std::abs(air.temperature - before.temperature), 0.03) << z;
    before = air;
  }
  EXPECT_NEAR(air_at(e, 225)->temperature, 0.5 * (279.2 + 284.6), 1e-3);  // but for geopotential height
}

/// How far falls of pressure are from equilibrium, dp/dH = -rho g0, here by Simpson's rule over 2.5 km [-].
double off_balance(const Environment& e) {
  double fall = 0, from = air_at(e, 0)->pressure, worst = 0;
  const double r0 = 6356766, step = 5;
  for (double z = 0; z < 60000; z += step) {
    const double low = air_at(e, z)->density, middle = air_at(e, z + 0.5 * step)->density,
                 high = air_at(e, z + step)->density;
    const double rise = r0 * (z + step) / (r0 + z + step) - r0 * z / (r0 + z);
    fall += 9.80665 * rise * (low + 4 * middle + high) / 6;
    if (std::fmod(z + step, 2500) != 0) continue;
    const double to = air_at(e, z + step)->pressure;
    worst = std::max(worst, std::abs((from - to) / fall - 1));
    from = to, fall = 0;
  }
  return worst;
}

/// Temperatures alone: pressures are in equilibrium, but for the change of f between levels far apart.
TEST(AirLevels, without_pressures_are_in_equilibrium) {
  const std::vector<AirPoint> few = {{0, 300}, {2000, 280}, {2500, 285}, {12000, 215}, {20000, 215}, {40000, 260}};
  EXPECT_NEAR(air_at(with_levels(few), 0)->pressure, 101325, 1e-6);
  EXPECT_LT(off_balance(with_levels(few)), 2e-4);
  std::vector<AirPoint> many;
  for (double z = 0; z <= 40000; z += 500) many.push_back({z, air_at(with_levels(few), z)->temperature});
  EXPECT_LT(off_balance(with_levels(many)), 2e-6);
}

/// Levels of the standard are the standard, but that the density of real gas is 4e-4 above that of an ideal one.
TEST(AirLevels, of_the_standard_are_the_standard) {
  std::vector<AirPoint> profile;
  for (double z = 0; z <= 80000; z += 500) {
    const AirSample air = *air_at({}, z);
    profile.push_back({z, air.temperature, air.pressure});
  }
  const Environment e = with_levels(profile);
  for (double z = -4000; z <= 85000; z += 333) {
    const AirSample standard = *air_at({}, z), air = *air_at(e, z);
    EXPECT_NEAR(air.temperature, standard.temperature, 0.4) << z;  // corners of layers between levels
    EXPECT_NEAR(air.density / standard.density, 1, 1e-3) << z;
    EXPECT_NEAR(air.pressure / standard.pressure, 1, 1e-3) << z;
  }
  const double there = fall(e, 9000).end().time, here = fall({}, 9000).end().time;
  EXPECT_NEAR(there / here, 1, 3e-4);
}

/// One level of the standard, wherever it lies, is the standard: its corners lie below that, too.
TEST(AirLevels, that_begin_high_have_the_standard_below) {
  for (const double first : {-5000.0, 0.0, 12000.0, 20000.0, 50000.0, 86000.0}) {
    const AirSample there = *air_at({}, first);
    const Environment e = with_levels({{first, there.temperature, there.pressure}});
    for (double z = -4900; z <= 85900; z += 700) {
      EXPECT_NEAR(air_at(e, z)->density / air_at({}, z)->density, 1, 5e-3) << first << " " << z;
      EXPECT_NEAR(air_at(e, z)->temperature, air_at({}, z)->temperature, 1e-6) << first << " " << z;
    }
  }
}

/// It is as humid below the first level as there, and dry above the last one.
TEST(AirLevels, are_humid_below_and_dry_above) {
  const Environment e = with_levels({{1000, 290, 90000, 0.8}});
  const AirSample low = *air_at(e, 0), high = *air_at(e, 5000);
  EXPECT_NEAR(low.density, moist_density(low.temperature, low.pressure, 0.8), 2e-5);
  EXPECT_NEAR(high.density, moist_density(high.temperature, high.pressure, 0.0), 1e-6);
}

/// A fall through the morning's air against an integration of its own by small steps of the classical Runge-Kutta rule.
TEST(AirLevels, slow_what_falls_through_them) {
  const Environment e = with_levels(morning());
  const double area = 0.25 * std::acos(-1.0) * 0.15 * 0.15, g = 9.80665;
  double z = 8000, v = 0, t = 0;
  const double h = 0.01;
  const auto rate = [&](double at, double speed) {
    return g - 0.5 * air_at(e, at)->density * 0.47 * area * speed * speed / 10;
  };
  double z_before = z, t_before = t, v_before = v;
  while (z > 0) {
    z_before = z, t_before = t, v_before = v;
    const double a1 = rate(z, v), v2 = v + 0.5 * h * a1, a2 = rate(z - 0.5 * h * v, v2);
    const double v3 = v + 0.5 * h * a2, a3 = rate(z - 0.5 * h * v2, v3);
    const double v4 = v + h * a3, a4 = rate(z - h * v3, v4);
    z -= h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    t += h;
  }
  const double part = z_before / (z_before - z), landed = t_before + (t - t_before) * part;
  const Flight flight = fall(e, 8000);
  EXPECT_NEAR(flight.end().time, landed, 1e-6);
  EXPECT_NEAR(-flight.end().velocity.y, v_before + (v - v_before) * part, 1e-5);
  EXPECT_NEAR(fall(e, 8000, Precision::float32).end().time, landed, 1e-3);
  EXPECT_NEAR(fall(e, 8000, Precision::float64, Integrator::rk43).end().time, landed, 1e-6);
}

/// Flights, batches and worlds fly through the same air, before and after a save.
TEST(AirLevels, are_the_same_behind_every_door) {
  const Environment e = with_levels(morning());
  ProjectileDef shell = bullet();
  shell.fidelity = Fidelity::small_arms();
  const Launch launch{.speed = 800, .elevation = 0.9};
  const Until until{.ground = std::nullopt, .time = 10};
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    Fidelity f = shell.fidelity;
    f.precision = precision;
    f.rotation = RotationModel::none;
    shell.fidelity = f;
    const Flight flight = fly(shell, launch, e, f, {}, until);
    std::vector<Launch> launches(5, launch);
    const BatchResult batch = fly_batch(shell, launches, e, f, {}, until);
    ASSERT_EQ(batch.shots.size(), 5u);
    EXPECT_EQ(batch.shots[3].position, flight.end().position);
    const Flight standard = fly(shell, launch, {}, f, {}, until);
    EXPECT_GT(std::abs(standard.end().position.y - flight.end().position.y), 5) << "it is not the standard";
    World world = make_world({.environment = e, .ground = {.mode = GroundMode::none}});
    const ProjectileId id = *world.spawn(shell, launch);
    for (int i = 0; i < 320; ++i) world.step(1.0 / 64);
    auto loaded = reloaded(world);
    for (int i = 0; i < 320; ++i) world.step(1.0 / 64), loaded.step(1.0 / 64);
    EXPECT_EQ(loaded.hash(), world.hash());
    EXPECT_LT(length(world[id].position() - flight.end().position), precision == Precision::float64 ? 0.01 : 1.0);
    ASSERT_TRUE(world.set_environment(0, Environment{}));
    ASSERT_TRUE(world.set_environment(0, e));
    for (int i = 0; i < 10; ++i) world.step(1.0 / 64), loaded.step(1.0 / 64);
    EXPECT_EQ(loaded.hash(), world.hash());
  }
}

/// A thousand levels on the standard's lapse are two of them.
TEST(AirLevels, may_be_many) {
  std::vector<AirPoint> many;
  const auto temperature = [](double z) { return 288.15 - 0.0065 * 6356766 * z / (6356766 + z); };
  for (double z = 0; z <= 10000; z += 5) many.push_back({z, temperature(z)});
  const double two = fall(with_levels({many.front(), many.back()}), 8000).end().time;
  EXPECT_NEAR(fall(with_levels(many), 8000).end().time / two, 1, 3e-6);
}

/// Air that is constant or falls exponentially is that at the origin.
TEST(AirLevels, give_simpler_air_its_origin) {
  Environment e = with_levels(morning());
  e.altitude = 1000;
  const AirSample there = *air_at(e, 1000);
  e.atmosphere.model = AirModel::constant;
  EXPECT_NEAR(air_at(e, 4000)->density, there.density, 1e-12);
  EXPECT_NEAR(air_at(e, 4000)->sound_speed, there.sound_speed, 1e-10);
  e.atmosphere.model = AirModel::exponential;
  EXPECT_NEAR(air_at(e, 1000)->density, there.density, 1e-12);
}

TEST(AirLevels, that_contradict_themselves_are_refused) {
  const auto refused = [](const Environment& e) {
    const Flight flight = fly({}, {.speed = 10}, e);
    EXPECT_EQ(flight.outcome(), Outcome::refused);
    return flight.error() ? flight.error()->text() : std::string();
  };
  std::vector<AirPoint> profile = morning();
  std::swap(profile[3], profile[4]);
  EXPECT_NE(refused(with_levels(profile)).find("environment.atmosphere.profile[4]"), std::string::npos);
  profile = morning();
  profile[2].pressure = 98000;
  EXPECT_NE(refused(with_levels(profile)).find("less pressure than the level below"), std::string::npos);
  profile = {{0, 288, 100000}, {3000, 273}, {3100, 273, 99000}};
  EXPECT_NE(refused(with_levels(profile)).find("profile[2]"), std::string::npos) << "a rise over a level without one";
  profile = {{0, 293, 100000}, {1, 293, 100}};
  EXPECT_NE(refused(with_levels(profile)).find("cannot make"), std::string::npos);
  EXPECT_FALSE(fly({}, {.speed = 10}, with_levels({{200, 288}, {200.01, 288}})).error());
  EXPECT_NE(refused(with_levels({{200, 288}, {200.009, 288}})), "");
  profile = morning();
  profile[0].pressure.reset();
  EXPECT_NE(refused(with_levels(profile)).find("its first level has none"), std::string::npos);
  profile = morning();
  profile[10] = {26000, 350, 2180, 1.0};
  EXPECT_NE(refused(with_levels(profile)).find("more vapour"), std::string::npos);
  Environment e = with_levels(morning());
  e.atmosphere.temperature = 280;
  EXPECT_NE(refused(e).find("a station gives it, too"), std::string::npos);
  e = with_levels(morning());
  const std::vector<double> damp(3, 0.5);
  const std::vector<Launch> launches(3, {.speed = 100});
  const BatchResult batch = fly_batch(ProjectileDef{}, launches, e, {}, {}, {}, nullptr, {.humidity = damp});
  ASSERT_TRUE(batch.error);
  EXPECT_EQ(batch.error->place, "weather.humidity");
  EXPECT_NE(batch.error->text().find("is that of a station"), std::string::npos);
}

}  // namespace physim::model_air_levels_test
