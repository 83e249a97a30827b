// Lift and drag by spin: the trochoid of a constant Magnus acceleration, formulas and tables worked by hand, golf and
// baseball against published flights.
#include "model/magnus.hpp"
#include "support.hpp"

namespace physim::flight_magnus_test {

using namespace test;

constexpr double kRpm = 3.14159265358979323846 / 30;
constexpr double kMph = 0.44704, kYard = 0.9144, kFoot = 0.3048;

Fidelity spinning(Integrator integrator = Integrator::dop853) {
  Fidelity f = Fidelity::constant_air();
  f.integrator = integrator;
  f.rotation = RotationModel::magnus;
  return f;
}

Environment air_of(double density) {
  Environment e = constant_gravity();
  e.atmosphere.model = AirModel::constant;
  e.atmosphere.density = density;
  return e;
}

/// A ball whose lift is kappa x v in air of 1.2 kg/m^3, without drag.
ProjectileDef trochoid_ball() {
  return {.mass = 0.4, .diameter = 0.2, .drag = {.coefficient = 0}, .magnus = {.lift = 1.5}};
}
double spin_of_kappa(double kappa) {  // kappa = rho A l r omega / (2 m)
  const double area = 3.14159265358979323846 * 0.01;
  return kappa * 2 * 0.4 / (1.2 * area * 1.5 * 0.1);
}

/// v' = g + kappa x v, exactly: the drift velocity, and the rest turning about kappa.
State<double> trochoid(const Vec3d& kappa, const Vec3d& g, const Vec3d& v0, double t) {
  const double k = length(kappa);
  const Vec3d n = kappa * (1 / k);
  const Vec3d along = n * dot(n, g);
  const Vec3d drift = cross(kappa, g - along) * (1 / (k * k));  // kappa x drift = -(g - along)
  const Vec3d w = v0 - drift;
  const Vec3d w_along = n * dot(n, w);
  const Vec3d w_across = w - w_along;
  const Vec3d side = cross(n, w_across);
  State<double> s;
  s.v = drift + along * t + w_along + w_across * std::cos(k * t) + side * std::sin(k * t);
  s.x = (drift + w_along) * t + along * (0.5 * t * t) + w_across * (std::sin(k * t) / k) +
        side * ((1 - std::cos(k * t)) / k);
  return s;
}

TEST(Magnus, a_constant_one_flies_a_trochoid) {
  const Vec3d g{0, -9.80665, 0};
  const Vec3d v0{30, 20, 0};
  // Spin about the launch: right is z; up and forward lie in the plane of fire.
  for (const auto& [back, side, gyro] :
       {std::tuple{0.5, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.3, -0.4, 1.2}, {-2.0, 0.5, 0.1}}) {
    Launch launch{.velocity = v0, .spin = {spin_of_kappa(back), spin_of_kappa(side), spin_of_kappa(gyro)}};
    const Vec3d forward = v0 * (1 / length(v0));
    const Vec3d up{-forward.y, forward.x, 0};
    const Vec3d kappa = Vec3d{0, 0, back} - up * side + forward * gyro;
    const Flight flight =
        fly(trochoid_ball(), launch, air_of(1.2), spinning(), {1e-13, 1e-13}, {.ground = {}, .time = 4});
    ASSERT_EQ(flight.fidelity_in_use().fidelity.rotation, RotationModel::magnus);
    for (const double t : {0.5, 3.0, 4.0}) {
      const State<double> exact = trochoid(kappa, g, v0, t);
      EXPECT_TRUE(near(flight.at(t).position, exact.x, 1e-11));
      EXPECT_TRUE(near(flight.at(t).velocity, exact.v, 1e-11));
    }
  }
}

TEST(Magnus, the_published_trochoids) {
  // v' = g + kappa x v with g along -z, v0 = (30, 0, 20): kappa, t, x and v (closed form to 20 digits). Their axes
  // (x, y, z) are ours (x, -z, y).
  struct Row {
    Vec3d kappa;
    double t;
    Vec3d x, v;
  };
  const Row rows[] = {
      {{0.5, 0, 0}, 3, {90.0, -17.458948774814485, 3.44797937910049}, {30.0, -1.723989689550246, -18.149424387407244}},
      {{0, -1, 0}, 3, {-7.530214217253189, 0, 43.00701514242395}, {-13.007015142423950, 0, -16.950164217253189}},
      {{0.3, 0.4, 1.2},
       3,
       {-2.4866280913685501, 54.656095837453714, 20.773033410357566},
       {-27.278101640801430, -9.2158637327495300, 7.9715299877835343}},
  };
  for (const Row& row : rows) {
    const auto ours = [](const Vec3d& v) { return Vec3d{v.x, v.z, -v.y}; };
    const State<double> s = trochoid(ours(row.kappa), {0, -9.80665, 0}, {30, 20, 0}, row.t);
    EXPECT_TRUE(near(s.x, ours(row.x), 1e-12));
    EXPECT_TRUE(near(s.v, ours(row.v), 1e-12));
  }
}

TEST(Magnus, backspin_lifts_and_sidespin_turns_right) {
  const auto end = [&](LaunchSpin spin) {
    Launch launch{.position = {0, 1, 0}, .speed = 20, .spin = spin};
    return fly(trochoid_ball(), launch, air_of(1.2), spinning(), {}, {.ground = {}, .time = 0.5}).end().position;
  };
  const Vec3d plain = end({});
  EXPECT_GT(end({.backspin = 50}).y, plain.y + 0.1);
  EXPECT_LT(end({.backspin = -50}).y, plain.y - 0.1);
  EXPECT_GT(end({.sidespin = 50}).z, 0.1);
  EXPECT_LT(end({.sidespin = -50}).z, -0.1);
  EXPECT_NEAR(end({.gyrospin = 50}).z, 0, 0.3);
  EXPECT_NEAR(end({.gyrospin = 50}).y, plain.y, 0.1);
}

TEST(Magnus, gyrospin_lifts_nothing_by_tables_either) {
  for (const auto& preset : {presets::golf_ball(), presets::football(), presets::table_tennis_ball()}) {
    const auto lift = [&](const LaunchSpin& spin) {
      Launch launch{.position = {0, 1, 0}, .speed = 15, .elevation = 0.3, .spin = spin};
      const Flight flight = fly(preset.projectile, launch, air_of(1.2), spinning(), {}, {.ground = {}, .time = 0.01});
      return length(flight.accelerations(0).lift);
    };
    EXPECT_LT(lift({.gyrospin = 300}), 1e-6) << preset.projectile.name;
    // At 45 degrees the part across the path lifts.
    EXPECT_NEAR(lift({.backspin = 200, .gyrospin = 200}), lift({.backspin = 200}), 1e-9) << preset.projectile.name;
    EXPECT_GT(lift({.backspin = 200}), 0.4) << preset.projectile.name;
  }
}

TEST(Magnus, nathans_formula_by_hand) {
  const ProjectileDef p = presets::baseball().projectile;
  Launch launch{.speed = 40, .spin = {.backspin = 2000 * kRpm}};
  const Flight flight = fly(p, launch, air_of(1.2), spinning(), {}, {.ground = {}, .time = 1});
  const Accelerations a = flight.accelerations(0);
  const double r = 0.5 * p.diameter, S = r * 2000 * kRpm / 40;
  const double c = 0.5 * 1.2 * 3.14159265358979323846 * r * r * 1600 / p.mass;
  EXPECT_TRUE(near(a.lift, Vec3d{0, c * 1.120 * S / (0.583 + 2.333 * S), 0}, 1e-12));
  EXPECT_TRUE(near(a.drag, Vec3d{-c * (0.3008 + 0.0292 * 2), 0, 0}, 1e-12));
  EXPECT_TRUE(near(a.total, a.gravity + a.drag + a.lift, 1e-12));
}

TEST(Magnus, the_spin_dies_away) {
  ProjectileDef p = trochoid_ball();
  p.magnus.decay_time = 2;
  Launch launch{.speed = 30, .spin = {.backspin = 20}};
  const Flight flight = fly(p, launch, air_of(1.2), spinning(), {}, {.ground = {}, .time = 3});
  const auto per_speed = [&](double t) { return length(flight.accelerations(t).lift) / flight.at(t).speed; };
  EXPECT_NEAR(per_speed(2) / per_speed(0), std::exp(-1), 1e-12);
}

TEST(Magnus, tables_are_bilinear_and_held) {
  MagnusDef m{.table = {{10, 100, 0.2, 0.1}, {10, 200, 0.4, 0.3}, {20, 100, 0.6, 0.5}, {20, 200, 1.2, 0.9}}};
  const MagnusGrid g = magnus_grid(m);
  ASSERT_TRUE(is_full(g, 4));
  EXPECT_NEAR(magnus_at(g, 10, 100, 9).drag, 0.2, 1e-15);
  EXPECT_NEAR(magnus_at(g, 15, 150, 9).drag, 0.6, 1e-15);
  EXPECT_NEAR(magnus_at(g, 15, 150, 9).lift, 0.45, 1e-15);
  EXPECT_NEAR(magnus_at(g, 5, 500, 9).drag, 0.4, 1e-15);
  EXPECT_NEAR(magnus_at(g, 500, 500, 9).lift, 0.9, 1e-15);
  EXPECT_NEAR(magnus_at(g, 10, 50, 9).lift, 0.05, 1e-15);  // below the lowest spin the lift falls with it
  EXPECT_NEAR(magnus_at(g, 10, 50, 9).drag, 0.2, 1e-15);
  m.measure = SpinMeasure::parameter;
  EXPECT_NEAR(magnus_at(magnus_grid(m), 10, 9, 150).drag, 0.3, 1e-15);
}

/// Carry of a drive [yd]: where it comes down to the height of the tee, in the air that TrackMan states its averages
/// for: 77 degF at sea level.
double carry(double mph, double degrees, double rpm) {
  Environment e = constant_gravity();
  e.atmosphere.model = AirModel::constant;
  e.atmosphere.temperature = 298.15;
  Launch launch{.speed = mph * kMph, .elevation = degrees * kDegree, .spin = {.backspin = rpm * kRpm}};
  return fly(presets::golf_ball().projectile, launch, e, spinning()).end().position.x / kYard;
}

/// Root mean square of what carries are off by [yd]; rows of ball speed [mph], launch [deg], spin [rpm], carry [yd].
double carries_off(std::initializer_list<std::array<double, 4>> rows) {
  double squares = 0;
  for (const auto& [mph, degrees, rpm, yards] : rows) squares += std::pow(carry(mph, degrees, rpm) - yards, 2);
  return std::sqrt(squares / static_cast<double>(rows.size()));
}

TEST(Magnus, golf_tour_averages_untuned) {
  // TrackMan, PGA Tour averages.
  EXPECT_LT(carries_off({{167, 10.9, 2686, 275}, {132, 12.1, 5361, 194}, {109, 20.4, 8647, 148}}), 5);
}

TEST(Magnus, drives_at_little_spin) {
  // TrackMan, Driver Fitting Chart (2010), total optimizer, and averages of the PGA Tour of 2023.
  EXPECT_LT(carries_off({{111, 15.3, 1976, 156},
                         {126, 14, 1964, 189},
                         {141, 13, 1948, 223},
                         {149, 12.4, 1887, 239},
                         {163, 8.7, 2471, 260},
                         {171, 10.4, 2545, 282}}),
            5);
}

TEST(Magnus, golf_lift_at_little_spin_is_measured) {
  // US patent 6 186 002, table of the USGA's indoor range: speed [m/s], S, CD, CL, means of six balls; another set of
  // measurements lies within 0.02 of it.
  constexpr double kMeasured[][4] = {{43.9, 0.088, 0.226, 0.146},
                                     {56.6, 0.090, 0.234, 0.151},
                                     {70.3, 0.092, 0.241, 0.153},
                                     {69.6, 0.044, 0.231, 0.115}};
  for (const auto& [speed, parameter, cd, cl] : kMeasured) {
    const ProjectileDef ball = presets::golf_ball().projectile;
    Launch launch{.speed = speed, .spin = {.backspin = parameter * speed / (ball.diameter / 2)}};
    const Flight flight = fly(ball, launch, air_of(1.2), spinning(), {}, {.ground = {}, .time = 0.01});
    const double area = 3.14159265358979 / 4 * ball.diameter * ball.diameter;
    const double part = ball.mass / (0.5 * 1.2 * area * speed * speed);
    EXPECT_NEAR(length(flight.accelerations(0).drag) * part, cd, 0.025) << speed << " " << parameter;
    EXPECT_NEAR(length(flight.accelerations(0).lift) * part, cl, 0.02) << speed << " " << parameter;
  }
}

TEST(Magnus, a_published_fly_ball) {
  // A. M. Nathan's calculator: 103 mph, 27.5 deg, 2500 rpm of backspin, 70 degF, 29.92 inHg, 50 %, from 3 ft up and 2
  // ft out: after 1, 2 and 4 s at these distances and heights [ft], as published.
  Environment e = constant_gravity();
  e.gravity.acceleration = 32.174 * kFoot;
  e.altitude = 15 * kFoot;
  e.atmosphere.model = AirModel::constant;
  e.atmosphere.temperature = 294.26;
  e.atmosphere.humidity = 0.5;
  Launch launch{.position = {2 * kFoot, 3 * kFoot, 0}, .speed = 103 * kMph, .elevation = 27.5 * kDegree};
  launch.spin.backspin = 2500 * kRpm;
  const Flight flight = fly(presets::baseball().projectile, launch, e, spinning());
  constexpr double kFlyBall[][3] = {{1, 114.880, 58.506}, {2, 200.309, 87.076}};
  for (const auto& [t, x, y] : kFlyBall)
    EXPECT_TRUE(near(flight.at(t).position, Vec3d{x, y, 0} * kFoot, 0, 1.4 * kFoot)) << t;
}

/// Lift coefficient of a table-tennis ball at a speed and a spin, from the accelerations at launch.
double lift_coefficient(double speed, double spin) {
  const ProjectileDef ball = presets::table_tennis_ball().projectile;
  Environment e{.atmosphere = {.model = AirModel::constant}};
  Launch launch{.speed = speed, .spin = {.backspin = spin}};
  const Flight flight = fly(ball, launch, e, spinning(), {}, {.ground = {}, .time = 0.01});
  const double area = 3.14159265358979 / 4 * ball.diameter * ball.diameter;
  return flight.accelerations(0).lift.y * 2 * ball.mass / (1.225 * area * speed * speed);
}

TEST(Magnus, a_table_tennis_ball_has_the_lift_of_its_fit_with_its_crisis) {
  // Cl = 8/3 CM S with CM as published, C. Conti et al. (2026), arXiv:2606.28805, at 10.5 m/s: 0.375 - 6.58e-4 omega
  // below 440 rad/s, -2.604e-7 omega^2 + 3.646e-4 omega - 0.0225 above.
  const auto published = [](double cm, double spin) { return 8.0 / 3 * cm * 0.02 * spin / 10.5; };
  EXPECT_NEAR(lift_coefficient(10.5, 200), published(0.375 - 6.58e-4 * 200, 200), 1e-6);
  EXPECT_NEAR(lift_coefficient(10.5, 600), published((-2.604e-7 * 600 + 3.646e-4) * 600 - 0.0225, 600), 1e-6);
  EXPECT_EQ(lift_coefficient(10.5, 0), 0);
  // More spin, less lift: T. Miyazaki et al., European Journal of Physics 38 (2017) 024001.
  EXPECT_LT(lift_coefficient(17, 650), 0.7 * lift_coefficient(17, 400));
  EXPECT_GT(lift_coefficient(17, 900), lift_coefficient(17, 650));
}

TEST(Magnus, a_table_tennis_ball_without_spin_flies_as_a_smooth_sphere) {
  // Its drag was fitted to play; that of spheres by Reynolds number is another measurement.
  const ProjectileDef ball = presets::table_tennis_ball().projectile;
  ProjectileDef sphere = ball;
  sphere.magnus = {};
  sphere.drag.table = DragTable::sphere;
  for (const double speed : {5.0, 10.0, 20.0}) {
    const Launch launch{.position = {0, 1, 0}, .speed = speed, .elevation = 0.6};
    const double range = fly(ball, launch, {}, spinning()).end().position.x;
    EXPECT_NEAR(fly(sphere, launch, {}, spinning()).end().position.x / range, 1, 0.13) << speed;
    ProjectileDef in_vacuum = sphere;
    in_vacuum.drag = {.coefficient = 0};
    EXPECT_GT(fly(in_vacuum, launch, {}, spinning()).end().position.x / range, 1.13) << speed;
  }
}

TEST(Magnus, batches_and_float32_agree) {
  std::vector<Shot> shots;
  for (int i = 0; i < 21; ++i) {
    Shot s;
    s.projectile = (i % 4 == 0   ? presets::golf_ball()
                    : i % 4 == 1 ? presets::baseball()
                    : i % 4 == 2 ? presets::football()
                                 : presets::table_tennis_ball())
                       .projectile;
    s.launch = {.speed = 20.0 + 2 * i, .elevation = 0.1 + 0.02 * i};
    s.launch.spin = {100.0 + 10 * i, 20.0 * (i % 5), 5.0 * i};
    if (i == 20) s.projectile.magnus = {};
    shots.push_back(s);
  }
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5})
      for (const std::string& kernel : kernels()) {
        ASSERT_TRUE(use_kernel(kernel));
        Fidelity f = spinning(integrator);
        f.precision = precision;
        const Tolerance tolerance{1e-6, 1e-6, 0.01};
        const BatchResult batch = fly_batch(shots, {}, f, tolerance);
        ASSERT_FALSE(batch.error) << batch.error->text();
        for (std::size_t i = 0; i < shots.size(); ++i) {
          const Flight flight = fly(shots[i].projectile, shots[i].launch, {}, f, tolerance);
          EXPECT_TRUE(same_bits(batch.shots[i].position, flight.end().position)) << kernel << " " << i;
        }
      }
  use_kernel("");
}

TEST(Magnus, a_world_flies_the_bits_of_a_flight) {
  WorldDef def;
  auto made = must(World::create(def));
  World world = std::move(made);
  ProjectileDef p = presets::golf_ball().projectile;
  p.fidelity = spinning(Integrator::rk4);
  Launch launch{.speed = 70, .elevation = 0.2, .azimuth = 0.3, .spin = {300, 50, 10}};
  const ProjectileId id = *world.spawn(p, launch);
  const ProjectileId later = *world.spawn(p, launch, {}, 0.25);
  constexpr double kStep = 1.0 / 64;
  const Flight flight = fly(p, launch, {}, p.fidelity, {1e-9, 1e-9, kStep});
  for (int i = 1; i <= 128; ++i) {
    world.step(kStep);
    ASSERT_TRUE(same_bits(world[id].position(), flight.at(i * kStep).position)) << i;
    if (i > 16) {
      ASSERT_TRUE(near(world[later].position(), flight.at((i - 16) * kStep).position, 1e-12)) << i;
    }
    ASSERT_TRUE(near(world[id].accelerations().total, flight.at(i * kStep).acceleration, 1e-12));
  }
}

TEST(Magnus, is_granted_only_where_it_can_be_had) {
  const auto granted = [](const ProjectileDef& p, Fidelity f) {
    return fly(p, {.speed = 10, .elevation = 0.5}, {}, f).fidelity_in_use();
  };
  EXPECT_EQ(granted({}, spinning()).fidelity.rotation, RotationModel::none);
  EXPECT_FALSE(granted({}, spinning()).notes.empty());
  Fidelity f = spinning();
  f.drag = DragModel::linear_quadratic;
  EXPECT_EQ(granted(trochoid_ball(), f).fidelity.rotation, RotationModel::magnus) << "a drag force";
  f.drag = DragModel::damping;
  EXPECT_EQ(granted(trochoid_ball(), f).fidelity.rotation, RotationModel::none);
  f = spinning();
  f.motion = Motion::closed_form;
  EXPECT_EQ(granted(trochoid_ball(), f).fidelity.rotation, RotationModel::none);
}

TEST(Magnus, bad_input_is_refused) {
  const auto place_of = [](void (*spoil)(MagnusDef&)) {
    ProjectileDef p = trochoid_ball();
    spoil(p.magnus);
    const Flight flight = fly(p, {.speed = 10});
    return flight.error() ? flight.error()->place : std::string();
  };
  EXPECT_EQ(place_of([](auto& m) { m.lift = kNan; }), "projectile.magnus.lift");
  EXPECT_EQ(place_of([](auto& m) { m.lift_base = 0; }), "projectile.magnus.lift_base");
  EXPECT_EQ(place_of([](auto& m) { m.lift_saturation = -1; }), "projectile.magnus.lift_saturation");
  EXPECT_EQ(place_of([](auto& m) { m.drag_per_spin = -1; }), "projectile.magnus.drag_per_spin");
  EXPECT_EQ(place_of([](auto& m) { m.decay_time = 0; }), "projectile.magnus.decay_time");
  EXPECT_EQ(place_of([](auto& m) { m.table = {{1, 1, -1, 0}}; }), "projectile.magnus.table[0]");
  EXPECT_EQ(place_of([](auto& m) { m.table = {{1, 1, 1, 0}, {1, 2, 1, 0}, {2, 1, 1, 0}}; }), "projectile.magnus.table");
  EXPECT_EQ(place_of([](auto& m) { m.table = {{1, 1, 1, 0}, {1, 1, 1, 0}}; }), "projectile.magnus.table");
  Launch launch{.speed = 10, .spin = {.sidespin = kInfinity}};
  EXPECT_EQ(fly(trochoid_ball(), launch).error()->place, "launch.spin.sidespin");
}

}  // namespace physim::flight_magnus_test
