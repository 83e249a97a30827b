// Bad input is refused with a place and a message; nothing throws, nothing hangs.
#include <functional>

#include "model/conditions.hpp"
#include "prepare/check.hpp"
#include "support.hpp"

namespace physim::prepare_check_test {

using namespace test;

struct Input {
  ProjectileDef projectile = bullet_308();
  Launch launch{.position = {0, 1.5, 0}, .speed = 800};
  Environment environment;
  Fidelity fidelity;
  Tolerance tolerance;
  Until until;
};

Flight fly(const Input& in) {
  return physim::fly(in.projectile, in.launch, in.environment, in.fidelity, in.tolerance, in.until);
}

struct BadInput {
  const char* what;
  const char* place;
  const char* message;  // part of it
  std::function<void(Input&)> spoil;
};

/// The first value behind those of an enumeration.
template <class Enum>
void spoil(Enum& value) {
  value = static_cast<Enum>(names_of<Enum>().size());
}

const BadInput kBad[] = {
    {"mass NaN", "projectile.mass", "positive", [](Input& i) { i.projectile.mass = kNan; }},
    {"mass infinite", "projectile.mass", "positive", [](Input& i) { i.projectile.mass = kInfinity; }},
    {"mass negative", "projectile.mass", "positive", [](Input& i) { i.projectile.mass = -0.01; }},
    {"mass zero", "projectile.mass", "positive", [](Input& i) { i.projectile.mass = 0; }},
    {"mass of nothing", "projectile.mass", "too small",
     [](Input& i) { i.projectile.drag.ballistic_coefficient = 0, i.projectile.mass = 5e-324; }},
    {"diameter zero", "projectile.diameter", "positive", [](Input& i) { i.projectile.diameter = 0; }},
    {"length negative", "projectile.length", "zero or positive", [](Input& i) { i.projectile.length = -1; }},
    {"twist NaN", "projectile.twist", "finite", [](Input& i) { i.projectile.twist = kNan; }},
    {"Cd negative", "projectile.drag.coefficient", "zero or positive",
     [](Input& i) { i.projectile.drag.coefficient = -1; }},
    {"BC negative", "projectile.drag.ballistic_coefficient", "zero or positive",
     [](Input& i) { i.projectile.drag.ballistic_coefficient = -5; }},
    {"form factor zero", "projectile.drag.form_factor", "positive",
     [](Input& i) { i.projectile.drag.form_factor = 0; }},
    {"damping zero", "projectile.drag.damping", "above 0", [](Input& i) { i.projectile.drag.damping = 0; }},
    {"damping above one", "projectile.drag.damping", "not above 1", [](Input& i) { i.projectile.drag.damping = 1.1; }},
    {"damping NaN", "projectile.drag.damping", "above 0", [](Input& i) { i.projectile.drag.damping = kNan; }},
    {"k1 negative", "projectile.drag.k1", "zero or positive", [](Input& i) { i.projectile.drag.k1 = -1; }},
    {"k2 infinite", "projectile.drag.k2", "zero or positive", [](Input& i) { i.projectile.drag.k2 = kInfinity; }},
    {"empty curve", "projectile.drag.curve", "empty", [](Input& i) { i.projectile.drag.table = DragTable::custom; }},
    {"unsorted curve", "projectile.drag.curve[2]", "rise",
     [](Input& i) {
       i.projectile.drag = {.table = DragTable::custom, .curve = {{0, 1}, {2, 1}, {1, 1}}};
     }},
    {"doubled Mach number", "projectile.drag.curve[1]", "rise",
     [](Input& i) {
       i.projectile.drag = {.table = DragTable::custom, .curve = {{1, 1}, {1, 2}}};
     }},
    {"NaN in a curve", "projectile.drag.curve[1]", "zero or positive",
     [](Input& i) {
       i.projectile.drag = {.table = DragTable::custom, .curve = {{0, 1}, {1, kNan}}};
     }},
    {"Mach numbers a rounding apart", "projectile.drag.curve[1]", "rise",
     [](Input& i) {
       i.projectile.drag = {.table = DragTable::custom, .curve = {{0, 1}, {1e-300, 2}}};
     }},
    {"thrust that lasts no time", "projectile.motor.thrust[1]", "rise",
     [](Input& i) {
       i.projectile.motor.thrust = {{0, 5}, {1e-308, 1}, {1, 1}};
     }},
    {"thrust beyond all numbers", "projectile.motor.thrust", "exceeds",
     [](Input& i) {
       i.projectile.motor.thrust = {{0, 1e18}, {1, 1}};
     }},
    {"thrust that is none", "projectile.motor.thrust", "no impulse",
     [](Input& i) {
       i.projectile.motor.thrust = {{0, 1e-308}, {1, 1e-308}};
     }},
    {"a burn of years", "projectile.motor.thrust[1]", "beyond",
     [](Input& i) {
       i.projectile.motor.thrust = {{0, 1}, {1e300, 1}};
     }},
    {"aerodynamics beyond all Mach numbers", "projectile.aero.lift[1]", "beyond 100",
     [](Input& i) {
       i.projectile.aero.lift = {{0, 0, 1}, {1e18, 0, 2}};
     }},
    {"aerodynamics at no angle", "projectile.aero.magnus_force[1]", "beyond 10 rad",
     [](Input& i) {
       i.projectile.aero.magnus_force = {{0, 0, 1}, {0, 1e18, 2}};
     }},
    {"nine bands", "projectile.drag.bands", "too many",
     [](Input& i) {
       i.projectile.drag.bands.assign(9, {100, 200});
     }},
    {"band without a coefficient", "projectile.drag.bands[0]", "positive",
     [](Input& i) {
       i.projectile.drag.bands = {{100, 0}};
     }},
    {"force NaN", "projectile.force", "finite", [](Input& i) { i.projectile.force.y = kNan; }},
    {"force duration negative", "projectile.force_duration", "zero or positive",
     [](Input& i) { i.projectile.force_duration = -1; }},
    {"position infinite", "launch.position", "finite", [](Input& i) { i.launch.position.z = kInfinity; }},
    {"speed negative", "launch.speed", "zero or positive", [](Input& i) { i.launch.speed = -800; }},
    {"speed NaN", "launch.speed", "zero or positive", [](Input& i) { i.launch.speed = kNan; }},
    {"elevation NaN", "launch.elevation", "finite", [](Input& i) { i.launch.elevation = kNan; }},
    {"azimuth infinite", "launch.azimuth", "finite", [](Input& i) { i.launch.azimuth = kInfinity; }},
    {"velocity NaN", "launch.velocity", "finite",
     [](Input& i) {
       i.launch.speed = 0, i.launch.velocity = Vec3d{1, kNan, 0};
     }},
    {"velocity and speed", "launch.velocity", "together",
     [](Input& i) {
       i.launch.velocity = Vec3d{1, 2, 3};
     }},
    {"elevation and zero range", "launch.elevation", "together with a zero range",
     [](Input& i) { i.launch.elevation = 0.1, i.launch.sight.zero_range = 100; }},
    {"velocity and zero range", "launch.velocity", "together with a zero range",
     [](Input& i) {
       i.launch.speed = 0, i.launch.velocity = Vec3d{9, 0, 0}, i.launch.sight.zero_range = 100;
     }},
    {"zero range out of reach", "launch.sight.zero_range", "no elevation",
     [](Input& i) { i.launch.sight.zero_range = 20000; }},
    {"zero range of a shot at rest", "launch.speed", "zero range is given",
     [](Input& i) { i.launch.speed = 0, i.launch.sight.zero_range = 100; }},
    {"zero range negative", "launch.sight.zero_range", "zero or positive",
     [](Input& i) { i.launch.sight.zero_range = -1; }},
    {"look angle in degrees", "launch.sight.look_angle", "between", [](Input& i) { i.launch.sight.look_angle = 30; }},
    {"cant NaN", "launch.sight.cant", "finite", [](Input& i) { i.launch.sight.cant = kNan; }},
    {"altitude too low", "environment.altitude", "between", [](Input& i) { i.environment.altitude = -6000; }},
    {"gravity NaN", "environment.gravity.acceleration", "finite",
     [](Input& i) { i.environment.gravity.acceleration = kNan; }},
    {"gravity beyond all numbers", "environment.gravity.acceleration", "exceeds",
     [](Input& i) { i.environment.gravity.acceleration = 1e300; }},
    {"wind beyond all numbers", "environment.wind.velocity", "exceeds",
     [](Input& i) { i.environment.wind.velocity.z = -1e308; }},
    {"a profile's wind beyond all numbers", "environment.wind.profile[0]", "exceeds",
     [](Input& i) {
       i.environment.wind.profile = {{0, {1e300, 0, 0}}};
     }},
    {"radius zero", "environment.gravity.radius", "positive", [](Input& i) { i.environment.gravity.radius = 0; }},
    {"temperature in Celsius", "environment.atmosphere.temperature", "between",
     [](Input& i) { i.environment.atmosphere.temperature = 15; }},
    {"pressure in hectopascal", "environment.atmosphere.pressure", "between",
     [](Input& i) { i.environment.atmosphere.pressure = 29.9; }},
    {"humidity in percent", "environment.atmosphere.humidity", "between",
     [](Input& i) { i.environment.atmosphere.humidity = 60; }},
    {"more vapour than the thin air of a height", "environment.atmosphere.humidity", "more vapour",
     [](Input& i) {
       i.environment.altitude = 20000;
       i.environment.atmosphere.temperature = 310, i.environment.atmosphere.humidity = 1;
     }},
    {"station in space", "environment.atmosphere.station_altitude", "between",
     [](Input& i) { i.environment.atmosphere.station_altitude = 1e6; }},
    {"density negative", "environment.atmosphere.density", "zero or positive",
     [](Input& i) { i.environment.atmosphere.density = -1; }},
    {"sound speed zero", "environment.atmosphere.sound_speed", "positive",
     [](Input& i) { i.environment.atmosphere.sound_speed = 0; }},
    {"scale height zero", "environment.atmosphere.scale_height", "positive",
     [](Input& i) { i.environment.atmosphere.scale_height = 0; }},
    {"wind NaN", "environment.wind.velocity", "finite", [](Input& i) { i.environment.wind.velocity.x = kNan; }},
    {"unsorted wind", "environment.wind.profile[1]", "rise",
     [](Input& i) {
       i.environment.wind.profile = {{10, {}}, {5, {}}};
     }},
    {"wind that jumps within a rounding", "environment.wind.profile[1]", "rise",
     [](Input& i) {
       i.environment.wind.profile = {{0, {}}, {1e-300, {1, 0, 0}}};
     }},
    {"too many wind points", "environment.wind.profile", "too many",
     [](Input& i) {
       for (int k = 0; k <= kMostLevels; ++k) i.environment.wind.profile.push_back({double(k), {}});
     }},
    {"latitude infinite", "environment.earth.latitude", "finite",
     [](Input& i) { i.environment.earth.latitude = kInfinity; }},
    {"latitude in degrees", "environment.earth.latitude", "between -90 and 90",
     [](Input& i) { i.environment.earth.latitude = 45; }},
    {"longitude NaN", "environment.earth.longitude", "finite", [](Input& i) { i.environment.earth.longitude = kNan; }},
    {"tolerance below rounding", "tolerance.relative", "below rounding",
     [](Input& i) { i.tolerance.relative = 1e-16; }},
    {"tolerance zero", "tolerance.relative", "below rounding", [](Input& i) { i.tolerance.relative = 0; }},
    {"tolerance below float32's rounding", "tolerance.relative", "below rounding",
     [](Input& i) { i.fidelity.precision = Precision::float32, i.tolerance.relative = 1e-7; }},
    {"absolute tolerance negative", "tolerance.absolute", "zero or positive",
     [](Input& i) { i.tolerance.absolute = -1; }},
    {"step negative", "tolerance.step", "zero or positive",
     [](Input& i) { i.fidelity.integrator = Integrator::rk4, i.tolerance.step = -0.01; }},
    {"step NaN", "tolerance.step", "zero or positive", [](Input& i) { i.tolerance.step = kNan; }},
    {"step infinite", "tolerance.step", "zero or positive", [](Input& i) { i.tolerance.step = kInfinity; }},
    {"step too short", "tolerance.step", "shorter", [](Input& i) { i.tolerance.step = 1e-30; }},
    {"longest step too short", "tolerance.max_step", "shorter", [](Input& i) { i.tolerance.max_step = 1e-308; }},
    {"an error that is none", "tolerance.position_error", "smaller",
     [](Input& i) { i.tolerance.position_error = 1e-300; }},
    {"a place too far for float32", "position", "too large for float32",
     [](Input& i) { i.fidelity.precision = Precision::float32, i.launch.position.x = 1e300; }},
    {"a speed too large for float32", "velocity", "too large for float32",
     [](Input& i) { i.fidelity.precision = Precision::float32, i.launch.speed = 1e300; }},
    {"no error allowed", "tolerance.position_error", "positive",
     [](Input& i) { i.fidelity.integrator = Integrator::rk4, i.tolerance.position_error = 0; }},
    {"max step zero", "tolerance.max_step", "positive", [](Input& i) { i.tolerance.max_step = 0; }},
    {"max step NaN", "tolerance.max_step", "positive", [](Input& i) { i.tolerance.max_step = kNan; }},
    {"no steps", "tolerance.max_steps", "between", [](Input& i) { i.tolerance.max_steps = 0; }},
    {"ground NaN", "until.ground", "finite", [](Input& i) { i.until.ground = kNan; }},
    {"time infinite", "until.time", "positive", [](Input& i) { i.until.time = kInfinity; }},
    {"time zero", "until.time", "positive", [](Input& i) { i.until.time = 0; }},
    {"range negative", "until.range", "positive", [](Input& i) { i.until.range = -100; }},
    {"event at NaN", "until.events[1].value", "finite",
     [](Input& i) { i.until.events = {{EventKind::height, 1}, {EventKind::mach, kNan}}; }},
    {"no such rung", "fidelity.integrator", "named", [](Input& i) { spoil(i.fidelity.integrator); }},
    {"no such drag", "fidelity.drag", "named", [](Input& i) { spoil(i.fidelity.drag); }},
    {"no such rung of its own", "fidelity.earth", "named", [](Input& i) { spoil(i.projectile.fidelity.earth); }},
    {"no such table", "projectile.drag.table", "named", [](Input& i) { spoil(i.projectile.drag.table); }},
    {"no such wind", "environment.wind.by", "named", [](Input& i) { spoil(i.environment.wind.by); }},
    {"no such frame", "launch.attitude.frame", "named", [](Input& i) { spoil(i.launch.attitude.frame); }},
    {"no such event", "until.events[0].kind", "named", [](Input& i) { spoil(i.until.events.emplace_back().kind); }},
    {"25 events", "until.events", "too many", [](Input& i) { i.until.events.assign(25, {}); }},
};

TEST(Check, every_bad_input_is_refused_with_its_place_and_a_message) {
  ASSERT_EQ(fly(Input{}).outcome(), Outcome::landed) << "the input that is spoilt must be good";
  for (const BadInput& bad : kBad) {
    Input input;
    bad.spoil(input);
    const Flight flight = fly(input);
    EXPECT_EQ(flight.outcome(), Outcome::refused) << bad.what;
    ASSERT_TRUE(flight.error()) << bad.what;
    EXPECT_EQ(flight.error()->place, bad.place) << bad.what;
    EXPECT_NE(flight.error()->message.find(bad.message), std::string::npos)
        << bad.what << ": " << flight.error()->text();
  }
}

TEST(Check, a_batch_refuses_the_same) {
  for (const BadInput& bad : kBad) {
    Input input;
    bad.spoil(input);
    const Shot shots[] = {{input.projectile, input.launch}};
    const BatchResult batch = fly_batch(shots, input.environment, input.fidelity, input.tolerance, input.until);
    EXPECT_EQ(batch.shots[0].outcome, Outcome::refused) << bad.what;
    ASSERT_TRUE(batch.error) << bad.what;
    EXPECT_EQ(batch.error->place, bad.place) << bad.what;
  }
}

template <class Enum>
void expect_all_but_one_more_known(Enum Fidelity::*field, const char* what) {
  Input input;
  const auto count = names_of<Enum>().size();
  for (std::size_t i = 0; i <= count; ++i) {
    input.fidelity.*field = static_cast<Enum>(i);
    const auto error = fly(input).error();
    EXPECT_EQ(error && error->place == std::string("fidelity.") + what, i == count) << what << ' ' << i;
  }
}

TEST(Check, every_rung_that_has_a_name_is_known_and_no_other) {
  expect_all_but_one_more_known(&Fidelity::motion, "motion");
  expect_all_but_one_more_known(&Fidelity::integrator, "integrator");
  expect_all_but_one_more_known(&Fidelity::gravity, "gravity");
  expect_all_but_one_more_known(&Fidelity::drag, "drag");
  expect_all_but_one_more_known(&Fidelity::air, "air");
  expect_all_but_one_more_known(&Fidelity::wind, "wind");
  expect_all_but_one_more_known(&Fidelity::earth, "earth");
  expect_all_but_one_more_known(&Fidelity::rotation, "rotation");
  expect_all_but_one_more_known(&Fidelity::body_form, "body_form");
  expect_all_but_one_more_known(&Fidelity::precision, "precision");
  expect_all_but_one_more_known(&Fidelity::interpolation, "interpolation");
}

TEST(Check, errors_read_place_error_message_hint) {
  Input input;
  input.environment.atmosphere.humidity = 60;
  EXPECT_EQ(fly(input).error()->text(),
            "environment.atmosphere.humidity: error: must lie between 0 and 1; 60 % is 0.6");
}

TEST(Check, unreachable_accuracy_of_fixed_steps_is_told_and_no_loop) {
  Input input;
  input.fidelity.integrator = Integrator::heun;
  input.tolerance.position_error = 1e-15;
  input.tolerance.max_steps = 20000;
  const Flight flight = fly(input);
  ASSERT_FALSE(flight.error()) << flight.error()->text();
  ASSERT_FALSE(flight.fidelity_in_use().notes.empty());
  const FidelityNote& note = flight.fidelity_in_use().notes.back();
  EXPECT_EQ(note.effect, "tolerance.position_error");
  EXPECT_EQ(note.asked, "1e-15");
  EXPECT_GT(std::stod(note.granted), 1e-15) << "what was reached";
  const auto step =
      pilot_step(input.projectile, input.launch, input.environment, input.fidelity, input.tolerance, input.until);
  ASSERT_FALSE(step);
  EXPECT_EQ(step.error().place, "tolerance.position_error");
}

TEST(Check, pilot_step_refuses_a_tolerance_as_flights_do) {
  Input input;
  input.fidelity.integrator = Integrator::rk4;
  input.tolerance.position_error = -1;
  const auto step =
      pilot_step(input.projectile, input.launch, input.environment, input.fidelity, input.tolerance, input.until);
  ASSERT_FALSE(step);
  EXPECT_EQ(step.error().place, "tolerance.position_error");
}

TEST(Check, strong_gravity_ends_a_flight_that_steps_by_frames) {
  Input input;
  input.fidelity.integrator = Integrator::semi_implicit_euler;
  for (const double gravity : {1e6, 1e9, 1e12}) {
    input.environment.gravity.acceleration = gravity;
    const Flight flight = fly(input);
    EXPECT_NE(flight.outcome(), Outcome::refused) << gravity;
    EXPECT_GT(flight.step(), 0) << gravity;
  }
}

TEST(Check, odd_but_sound_input_flies) {
  const std::function<void(Input&)> fine[] = {
      [](Input& i) { i.launch.speed = 0; },
      [](Input& i) { i.projectile.drag.coefficient = 0, i.projectile.drag.table = DragTable::constant; },
      [](Input& i) {
        i.projectile.drag = {.table = DragTable::custom, .curve = {{1, 0.3}}};
      },
      [](Input& i) { i.environment.altitude = 5e6; },
      [](Input& i) { i.environment.gravity.acceleration = -1, i.until.time = 5; },
      [](Input& i) { i.until.ground.reset(), i.until.time = 1; },
      [](Input& i) { i.tolerance.absolute = 0; },
      [](Input& i) { i.projectile.force_duration = 0; },
      [](Input& i) { i.launch.elevation = 1.5707963267948966; },
      [](Input& i) { i.fidelity.integrator = Integrator::rk4, i.tolerance.relative = 0, i.tolerance.step = 0.01; },
  };
  int number = 0;
  for (const auto& change : fine) {
    Input input;
    change(input);
    const Flight flight = fly(input);
    EXPECT_FALSE(flight.error()) << number << ' ' << flight.error()->text();
    EXPECT_TRUE(flight.outcome() == Outcome::landed || flight.outcome() == Outcome::time_limit)
        << number << ' ' << name(flight.outcome());
    ++number;
  }
}

TEST(Check, every_number_of_a_launch_is_looked_at) {
  double Launch::*const own[] = {&Launch::speed, &Launch::elevation, &Launch::azimuth, &Launch::rail_length};
  double Sight::*const sight[] = {&Sight::height, &Sight::look_angle, &Sight::cant, &Sight::zero_range};
  double LaunchAttitude::*const attitude[] = {&LaunchAttitude::yaw, &LaunchAttitude::pitch, &LaunchAttitude::roll};
  double LaunchSpin::*const spin[] = {&LaunchSpin::backspin, &LaunchSpin::sidespin, &LaunchSpin::gyrospin};
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    const auto refuses = [bad](const auto& number_of) {
      Launch launch;
      EXPECT_TRUE(check(launch));
      number_of(launch) = bad;
      EXPECT_FALSE(check(launch)) << bad;
    };
    for (const auto member : own) refuses([=](Launch& l) -> double& { return l.*member; });
    for (const auto member : sight) refuses([=](Launch& l) -> double& { return l.sight.*member; });
    for (const auto member : attitude) refuses([=](Launch& l) -> double& { return l.attitude.*member; });
    for (const auto member : spin) refuses([=](Launch& l) -> double& { return l.spin.*member; });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      refuses([=](Launch& l) -> double& { return l.position[axis]; });
      refuses([=](Launch& l) -> double& { return l.attitude.rates[axis]; });
      refuses([=](Launch& l) -> double& { return l.velocity.emplace()[axis]; });
    }
  }
  // A sum that overflows says nothing.
  Launch far{.position = {1.5e308, 1.5e308, 0}};
  EXPECT_TRUE(check(far));
}

TEST(Check, numbers_that_float32_cannot_hold_are_found_wherever_they_stand) {
  constexpr double kMost = std::numeric_limits<float>::max();
  const Vec3d large{kMost, -kMost, kMost};  // each of them fits, whatever their sum is
  EXPECT_TRUE(check_fits(large, large, Precision::float32));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double bad : {2 * kMost, -2 * kMost, kInfinity, kNan}) {
      Vec3d v{1, 2, 3};
      v[axis] = bad;
      const Status position = check_fits(v, {}, Precision::float32), velocity = check_fits({}, v, Precision::float32);
      ASSERT_FALSE(position || velocity) << bad;
      EXPECT_EQ(position.error().place, "position");
      EXPECT_EQ(velocity.error().place, "velocity");
    }
  }
  EXPECT_TRUE(check_fits({2 * kMost, 0, 0}, {}, Precision::float64));
}

}  // namespace physim::prepare_check_test
