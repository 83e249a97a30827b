// Flights that users of other programs reported, with right values by closed forms or by integrations of their own.
#include <numbers>

#include "rifles.hpp"
#include "scenario/run_support.hpp"
#include "settings/units.hpp"
#include "support.hpp"

namespace physim::scenario_cases_flight_test {

constexpr double kG = 9.80665, kPi = std::numbers::pi;
using test::kDegree;

Flight flown(const Scenario& scenario) {
  Flight flight = fly_shot(scenario, scenario.shots.at(0));
  EXPECT_FALSE(flight.error()) << (flight.error() ? flight.error()->text() : "");
  return flight;
}
Flight flown(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return flown(parsed(text, overrides));
}

const std::string kSimple = "fidelity = { preset = \"simulation\", gravity = \"constant\", earth = \"flat\", ";
const std::string kGravity = "[environment]\ngravity = { model = \"constant\", acceleration = \"9.80665 m/s^2\" }\n";

// ------------------------------------------------------------------------------------------------------------ rockets
/// RocketPy-Team/RocketPy #103: rows that are indented and a lone semicolon behind them.
constexpr const char* kK1100T = R"(; Motor Data From RocketReviews.com
K1100T 54.0000 398.0000 0 0.7616 1.32518 AT
   0.034 1234.653
   0.105 1233.429
   0.176 1192.393
   0.247 1163.041
   0.318 1147.963
   0.389 1146.319
   0.460 1140.958
   0.532 1132.640
   0.603 1123.824
   0.674 1108.921
   0.745 1090.974
   0.816 1073.937
   0.887 1049.133
   0.959 1021.216
   1.030 994.559
   1.101 966.571
   1.172 940.194
   1.243 909.792
   1.315 880.264
   1.386 844.477
   1.457 643.599
   1.528 401.861
   1.599 145.498
   1.670 28.372
   1.742 0.000
   ;)";

MotorDef motor_of(const std::string& text, const std::string& name = "") {
  const auto motors = parse_motor_file(text, "f.eng");
  EXPECT_TRUE(motors) << (motors ? "" : motors.error().text());
  if (!motors) return {};
  return must(pick_motor(*motors, name, "f.eng")).motor;
}

/// Right: 1585.876 N s by trapezoids from (0, 0); 5 kg have 327.0270 m/s at 328.657 m, 4.2384 kg and an apex of
/// 5781.42 m by Tsiolkovsky's equation with gravity, from a lift-off at 1.355 ms.
TEST(CasesOfRockets, a_motor_file_with_indented_rows_and_a_lone_semicolon) {
  ProjectileDef rocket{.mass = 5, .diameter = 0.054, .motor = motor_of(kK1100T)};
  EXPECT_NEAR(total_impulse(rocket.motor), 1585.87586, 1e-5);
  rocket.fidelity = test::vacuum();
  const Flight flight = fly(rocket, {.elevation = kPi / 2, .rail_length = 1}, test::constant_gravity());
  const auto burnout = test::of_kind(flight, EventKind::burnout), apex = test::of_kind(flight, EventKind::apex);
  ASSERT_EQ(burnout.size(), 1u);
  ASSERT_EQ(apex.size(), 1u);
  EXPECT_NEAR(length(burnout[0].velocity), 327.0270, 0.002);
  EXPECT_NEAR(burnout[0].position.y, 328.6565, 0.01);
  EXPECT_NEAR(flight.at(burnout[0].time).mass, 4.2384, 1e-6);
  EXPECT_NEAR(apex[0].position.y, 5781.42, 0.1);
}

/// openrocket/openrocket PR 519, #987, #2150: A begins above 0, B ends above 0, C has two points at 0 s, D two steps,
/// tabs and a comment behind data, E has a header of six words. Right: areas by trapezoids, and E alone is refused.
TEST(CasesOfRockets, odd_motors_of_one_file_are_read_each_for_itself) {
  const std::string odd =
      "; words\nODD-A 18 70 3-5-7 0.010 0.020 TEST\n 0 50\n 0.5 50\n 1 0\n;\n"
      "ODD-B 18 70 P 0.010 0.020 TEST\n 0.1 40\n 1 40\n;\nODD-C 18 70 0 0.010 0.020 TEST\n 0 0\n 0 30\n 1 30\n 1 0\n;\n"
      "ODD-D 18 70 5 0.010 0.020 TEST\n\t0.2\t60\n\t0.6\t60\n\t0.6\t20\n\t1.2\t20\n\t1.2\t0 ; behind data\n;\n"
      "ODD-E 18 70 0.010 0.020 TEST\n 0.1 10\n 0.2 0\n";
  for (const auto& [name, impulse] : {std::pair{"ODD-A", 37.5}, {"ODD-B", 38.0}, {"ODD-C", 30.0}, {"ODD-D", 42.0}})
    EXPECT_NEAR(total_impulse(motor_of(odd, name)), impulse, 1e-12) << name;
  const auto refused = pick_motor(*parse_motor_file(odd, "f.eng"), "ODD-E", "f.eng");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "f.eng:24");
}

/// Two points at one time are a step of the thrust, in a scenario as in a file. Right: 60 N for exactly 2 s; 120 N s of
/// 0.1 kg give v = (120 / 0.1) ln(2 / 1.9) without gravity and drag (Tsiolkovsky).
TEST(CasesOfRockets, two_points_of_thrust_at_one_time_are_a_step) {
  const std::string rocket =
      "[environment]\ngravity = \"off\"\natmosphere = \"vacuum\"\n[[shot]]\nmass = 2\nelevation = \"90 deg\"\n"
      "rail_length = 1\nmotor = { propellant_mass = 0.1, thrust = [[0, 60], [2, 60], [2, 0], [3, 0]] }\n"
      "fidelity = { preset = \"simulation\", gravity = \"off\", air = \"vacuum\", earth = \"flat\" }\n[until]\ntime = "
      "4\n";
  EXPECT_NEAR(flown(rocket).end().speed, 1200 * std::log(2 / 1.9), 1e-5);
}

// ----------------------------------------------------------------------------------------------------------- descents
/// openrocket #1910, #2892: one, two and three parachutes of 60 cm under 1 kg, without wind and in 5 m/s.
/// Right: v = sqrt(2 m g / (rho n Cd A)) down, and the wind beside it.
TEST(CasesOfDescents, speeds_under_parachutes_fall_with_the_root_of_their_number) {
  for (const int count : {1, 2, 3}) {
    const std::string chute =
        kGravity + "atmosphere = { model = \"constant\", density = 1.225 }\n[[shot]]\nmass = 1\n" +
        "diameter = " + std::to_string(0.6 * std::sqrt(count)) +
        "\ndrag = { coefficient = 0.8 }\nposition = [0, 200, 0]\n" + kSimple + "air = \"constant\" }\n";
    const double down = std::sqrt(2 * kG / (1.225 * count * 0.8 * kPi * 0.09));
    EXPECT_NEAR(flown(chute).end().speed, down, 1e-4) << count;
    EXPECT_NEAR(flown(chute, {"environment.wind.velocity=[0, 0, 5]"}).end().speed, std::hypot(down, 5), 1e-4) << count;
  }
}

/// openrocket #1445: air of 3 mbar. Right: v sqrt(1 - exp(-2 g h / v^2)) of its density of an ideal gas.
TEST(CasesOfDescents, air_of_three_millibars_hardly_slows) {
  const Flight flight = flown(kGravity +
                              "atmosphere = { model = \"constant\", temperature = \"288.15 K\", pressure = \"3 mbar\" "
                              "}\n[[shot]]\nmass = 1\ndiameter = 0.6\ndrag = { coefficient = 0.8 }\n"
                              "position = [0, 200, 0]\n" +
                              kSimple + "air = \"constant\" }\n");
  const double density = 300 / (287.0528742 * 288.15), terminal = 2 * kG / (density * 0.8 * kPi * 0.09);
  EXPECT_NEAR(flight.end().speed, std::sqrt(terminal * (1 - std::exp(-2 * kG * 200 / terminal))), 1e-3);
  EXPECT_NEAR(flight.end().speed, 60.148, 0.05);
}

/// projecthorus/sondehub-infra #64, sondehub-tracker #172: from a burst at 30 and 32 km under a parachute of 5 and 25
/// m/s at sea level. Right: an RK4 through the standard atmosphere; terminal velocity all the way is 1 % off.
TEST(CasesOfDescents, from_thirty_kilometres_through_the_standard_atmosphere) {
  struct Case {
    double diameter, height, time, speed, within;
  };
  for (const auto& [diameter, height, time, speed, within] :
       {Case{0.737304, 30e3, 2750.89, 5.0003, 0.1}, {0.147461, 32e3, 564.75, 25.0385, 0.05}}) {
    const Flight flight =
        flown(kGravity + "[[shot]]\nmass = 1\ndrag = { coefficient = 1.5 }\ndiameter = " + std::to_string(diameter) +
              "\nposition = [0, " + std::to_string(height) + ", 0]\n" +
              "fidelity = { preset = \"simulation\", gravity = \"constant\", earth = \"flat\" }\n");
    EXPECT_NEAR(flight.duration(), time, within);
    EXPECT_NEAR(flight.end().speed, speed, 1e-3);
  }
}

/// RocketPy #253, EnergyPlus #5682: a wind from 350 degrees at the ground and from 10 degrees at 1 km is one from the
/// north between them. Right: an RK4 of 200.460 s, 1969.75 m to the south (z) and 1.79 m to the west.
TEST(CasesOfDescents, a_wind_that_turns_through_north_stays_in_the_north) {
  const Flight flight = flown(kGravity + R"(atmosphere = { model = "constant", density = "1.225 kg/m^3" }
[[environment.wind.profile]]
at = "0 m"
velocity = ["1.736481776669 m/s", "0 m/s", "9.848077530122 m/s"]
[[environment.wind.profile]]
at = "1000 m"
velocity = ["-1.736481776669 m/s", "0 m/s", "9.848077530122 m/s"]
[[shot]]
mass = "1 kg"
diameter = "0.737304 m"
drag = { coefficient = 1.5 }
position = ["0 m", "1000 m", "0 m"]
)" + kSimple + "air = \"constant\" }\n");
  EXPECT_NEAR(flight.duration(), 200.460, 0.002);
  EXPECT_NEAR(flight.end().position.x, -1.789, 0.01);
  EXPECT_NEAR(flight.end().position.z, 1969.75, 0.02);
}

// ----------------------------------------------------------------------------------------------------------- gunnery
std::string mortar(double speed, double mil) {
  return "[environment]\ngravity = { model = \"constant\", acceleration = \"9.8 m/s^2\" }\n[[shot]]\nmass = 1\n"
         "drag = { k1 = 0, k2 = 1e-4 }\nspeed = " +
         std::to_string(speed) + "\nelevation = " + std::to_string(mil * kPi / 3200) +
         "\nfidelity = { preset = \"simulation\", gravity = \"constant\", drag = \"linear_quadratic\", "
         "air = \"constant\", earth = \"flat\" }\n";
}

/// acemod/ACE3 #1625, #10009: the range table of an 82 mm mortar by a = -9.8 - 1e-4 |u| u. Right: an RK4 of steps of
/// 10 ms; elevations in mil of 6400.
TEST(CasesOfGuns, a_mortar_reaches_the_ranges_of_its_table) {
  struct Row {
    double speed, mil, range, time;
  };
  for (const auto& [speed, mil, range, time] : {Row{70, 1256, 300.438, 13.3164},
                                                {140, 1060, 1500.949, 23.5825},
                                                {200, 1434, 1001.643, 36.8945},
                                                {200, 1242, 2000.240, 35.1329},
                                                {200, 927, 3002.534, 29.7263}}) {
    const Flight flight = flown(mortar(speed, mil));
    EXPECT_NEAR(flight.end().position.x, range, 0.005) << speed << ' ' << mil;
    EXPECT_NEAR(flight.duration(), time, 1e-3) << speed << ' ' << mil;
  }
}

TEST(CasesOfGuns, a_mortar_is_aimed_at_the_elevations_of_its_table) {
  struct Row {
    double range, mil, time;
  };
  const Scenario scenario = parsed(mortar(200, 1242));
  const ScenarioShot& shot = scenario.shots[0];
  for (const auto& [range, mil, time] :
       {Row{2000, 1242.05, 35.134}, {1000, 1434.29, 36.896}, {2500, 1118.49, 33.366}, {3000, 928.49, 29.759}}) {
    const auto answer = must(aim(shot.projectile, shot.launch, scenario.environment, shot.projectile.fidelity,
                                 {.position = {range, 0, 0}}, {.arc = Arc::high, .tolerance = 1e-3}));
    ASSERT_TRUE(answer.high) << range;
    EXPECT_NEAR(answer.high->launch.elevation * 3200 / kPi, mil, 0.05) << range;
    EXPECT_NEAR(answer.high->time, time, 2e-3) << range;
  }
}

/// acemod/ACE3 PR 7820: a bullet by G7 of 0.21 lb/in^2, and by the friction that was fitted to it. Right: RK4 with G7
/// through its points by PCHIP; level fire against k u |u| is 890 exp(-k s).
TEST(CasesOfGuns, a_bullet_by_g7_and_by_the_friction_that_was_fitted_to_it) {
  const std::string bullet =
      kGravity + "[[shot]]\nmass = \"4.15 g\"\ndiameter = \"6 mm\"\nspeed = 890\n" +
      "drag = { table = \"g7\", ballistic_coefficient = \"0.21 lb/in^2\" }\n" + kSimple +
      "rotation = \"none\", interpolation = \"pchip\" }\n[until]\nground = \"off\"\nrange = 950\n";
  struct Row {
    double range, speed, y, time;
  };
  const Flight by_g7 = flown(bullet);
  for (const auto& [range, speed, y, time] :
       {Row{300, 676.070, -0.6710, 0.38686}, {700, 438.686, -4.9402, 1.12096}, {950, 324.041, -11.5153, 1.79129}}) {
    const auto there = must(by_g7.at_range(range));
    EXPECT_NEAR(there.speed, speed, 0.05) << range;
    EXPECT_NEAR(there.position.y, y, 2e-3) << range;
    EXPECT_NEAR(there.time, time, 5e-5) << range;
  }
  const Flight by_friction = flown(bullet, {"shot.mass=1 kg", "shot.drag={ k1 = 0, k2 = 0.00096786 }",
                                            "shot.fidelity.drag=linear_quadratic", "shot.fidelity.air=constant"});
  for (const auto& [range, speed, y, time] : {Row{300, 665.724, -0.6826, 0}, {950, 355.036, -11.4024, 0}}) {
    const auto there = must(by_friction.at_range(range));
    EXPECT_NEAR(there.speed, speed, 0.01) << range;
    EXPECT_NEAR(there.position.y, y, 1e-3) << range;
  }
}

/// o-murphy/py-ballisticcalc #97: the height of a bullet of much drag began to grow at the end. Right: RK4 with G7 by
/// PCHIP, apex 0.6511 m, and only down behind it, on every rung.
TEST(CasesOfGuns, a_bullet_of_much_drag_only_falls_behind_its_apex) {
  const std::string bullet = kGravity + "[[shot]]\nmass = \"188.5 g\"\ndiameter = \"23 mm\"\nspeed = 930\n" +
                             "elevation = \"0.416666666666667 deg\"\n" +
                             "drag = { table = \"g7\", ballistic_coefficient = \"0.02 lb/in^2\" }\n" + kSimple +
                             "rotation = \"none\", interpolation = \"pchip\" }\n[until]\nground = \"off\"\ntime = 4\n";
  struct Row {
    double range, y, speed, time;
  };
  const Flight flight = flown(bullet);
  for (const auto& [range, y, speed, time] : {Row{100, 0.6003, 314.758, 0.1904},
                                              {200, 0.2501, 205.066, 0.5897},
                                              {300, -2.5637, 136.451, 1.1920},
                                              {500, -32.063, 62.424, 3.4703}}) {
    const auto there = must(flight.at_range(range));
    EXPECT_NEAR(there.position.y, y, 1e-3 + 5e-4 * std::abs(y)) << range;
    EXPECT_NEAR(there.speed, speed, 0.1) << range;
    EXPECT_NEAR(there.time, time, 1e-3) << range;
  }
  const auto apex = test::of_kind(flight, EventKind::apex);
  ASSERT_EQ(apex.size(), 1u);
  EXPECT_NEAR(apex[0].position.y, 0.6511, 5e-4);
  for (const char* preset : {"simulation", "game", "constant_air", "small_arms"})
    for (const char* integrator : {"rk43", "rk4", "semi_implicit_euler"}) {
      const Flight rung = flown(bullet, {"shot.fidelity=" + std::string(preset), "tolerance.step=16.6667 ms",
                                         "shot.fidelity.integrator=" + std::string(integrator)});
      double before = kInfinity;
      for (double time = 0.5; time <= 4; time += 0.01) {
        const double y = rung.at(time).position.y;
        ASSERT_LT(y, before) << preset << ' ' << integrator << ' ' << time;
        before = y;
      }
    }
}

/// acemod/ACE3 #8123: a shot to the south drifts to the right, too, in the northern hemisphere. Right: an RK4 of
/// -2 Omega x v at 2000 m and 42 degrees of latitude.
TEST(CasesOfGuns, the_turning_earth_moves_shots_in_all_directions_to_the_right) {
  const std::string shot = kGravity + "earth = { latitude = \"42 deg\" }\n[[shot]]\nmass = 1\nspeed = 900\n" +
                           "elevation = \"2 deg\"\ndrag = { k1 = 0, k2 = 4e-4 }\n" +
                           "fidelity = { preset = \"simulation\", gravity = \"constant\", drag = \"linear_quadratic\", "
                           "air = \"constant\", earth = \"flat_coriolis\", rotation = \"none\" }\n"
                           "[until]\nground = \"off\"\nrange = 2000\n";
  struct Case {
    const char* azimuth;
    double right, height;
  };
  for (const auto& [azimuth, right, height] : {Case{"0 deg", 0.28221, 25.26400},
                                               {"90 deg", 0.28859, 25.58435},
                                               {"180 deg", 0.29497, 25.26394},
                                               {"270 deg", 0.28859, 24.94359}}) {
    const Vec3d end = flown(shot, {std::string("environment.earth.azimuth=") + azimuth}).end().position;
    EXPECT_NEAR(end.z, right, 2e-5) << azimuth;
    EXPECT_NEAR(end.y, height, 2e-4) << azimuth;
  }
  EXPECT_NEAR(flown(shot, {"environment.earth.latitude=-42 deg"}).end().position.z, -0.29497, 2e-5);
}

/// gehtsoft-usa/go_ballisticcalc #3: out of a rifling to the left a bullet drifts to the left. Right: Litz's
/// 1.25 (Sg + 1.2) t^1.83 inches with Sg = 2.1354 by Miller, and mirror images to the bit.
TEST(CasesOfGuns, rifling_to_the_left_gives_the_mirror_image) {
  const std::string bullet =
      kGravity +
      "[[shot]]\nmass = \"168 gr\"\ndiameter = \"0.308 in\"\nlength = \"1.272 in\"\ntwist = \"10 in\"\n"
      "drag = { table = \"g7\", ballistic_coefficient = \"0.218 lb/in^2\" }\nspeed = \"2580 ft/s\"\n"
      "elevation = \"0.5 deg\"\nfidelity = \"small_arms\"\n[until]\nground = \"off\"\ntime = 1.7\n";
  const Vec3d right = flown(bullet).end().position, left = flown(bullet, {"shot.twist=-10 in"}).end().position;
  EXPECT_NEAR(right.z, 1.25 * (2.1354 + 1.2) * std::pow(1.7, 1.83) * 0.0254, 5e-4);
  EXPECT_EQ(left.z, -right.z);
  EXPECT_EQ(left.x, right.x);
  EXPECT_EQ(left.y, right.y);
}

/// In a scenario whose flight ends at 1000 yd the row of 1000 yd is there. Right: an RK4 of 1.900113 s, 12.1342 m below
/// the line of sight and 312.546 m/s.
TEST(CasesOfGuns, the_last_yard_of_a_card_is_on_it) {
  const Scenario scenario = parsed(test::rifle308() + "[output]\nranges = \"100 yd .. 1000 yd step 100 yd\"\n");
  ASSERT_EQ(scenario.ranges.size(), 10u);
  const auto last = must(flown(scenario).at_range(scenario.ranges.back()));
  EXPECT_NEAR(last.time, 1.900113, 2e-6);
  EXPECT_NEAR(last.drop, -12.1342, 1e-4);
  EXPECT_NEAR(last.speed, 312.546, 1e-3);
}

/// A shot in a vacuum lands after v^2 / g sin(2 e); a wall stands at a range, too. Both are rows of a card, though the
/// end of the flight is found but for rounding.
TEST(CasesOfGuns, the_range_of_a_landing_or_a_wall_is_on_the_card) {
  for (const double degrees : {45.0, 30.0, 15.0, 71.0, 3.0})
    for (const double speed : {100.0, 333.3, 70.0}) {
      const double range = speed * speed / kG * std::sin(2 * degrees * kDegree);
      const std::string text =
          kGravity + "atmosphere = \"vacuum\"\n[[shot]]\nmass = 1\nspeed = " + std::to_string(speed) +
          "\nelevation = \"" + std::to_string(degrees) + " deg\"\n" + kSimple + "drag = \"off\", air = \"vacuum\" }\n";
      const auto row = flown(text).at_range(range);
      ASSERT_TRUE(row) << degrees << " deg, " << speed << " m/s: " << row.error().text();
      EXPECT_NEAR(row->time, 2 * speed * std::sin(degrees * kDegree) / kG, 1e-9);
      EXPECT_FALSE(flown(text).at_range(range * (1 + 1e-9)));
    }
}

/// A flight to until.time is there at that time: the end of its last step is found but for rounding.
TEST(CasesOfGuns, an_expectation_at_the_end_of_the_time_is_met) {
  int off = 0;
  for (const double end : {10.0, 0.7, 1.86, 3.3, 7.7, 12.1, 0.1}) {
    const std::string time = number_text(end);
    const Scenario scenario =
        parsed(kGravity + "atmosphere = \"vacuum\"\n[[shot]]\nmass = 1\nspeed = 100\nelevation = \"30 deg\"\n" +
               kSimple + "drag = \"off\", air = \"vacuum\" }\n[until]\nground = \"off\"\ntime = " + time +
               "\n[[expect]]\nat = { time = " + time + " }\nquantity = \"x\"\nequals = 0\nwithin = 1\n");
    const Flight flight = flown(scenario);
    off += flight.duration() != end;
    const auto x = must(measure(flight, scenario.expect[0]), end);
    EXPECT_NEAR(x, 100 * std::cos(30 * kDegree) * end, 1e-9);
    Expectation later = scenario.expect[0];
    later.at_value = end * (1 + 1e-9);
    EXPECT_FALSE(measure(flight, later));
  }
  EXPECT_GT(off, 0) << "some ends are off by a rounding, or this tests nothing";
}

// ------------------------------------------------------------------------------------------------ steps, balls, globes
/// schteppe/cannon.js #353: a second of fall in N steps. Right: -g/2 (1 + 1/N) of semi-implicit Euler, -g/2 (1 - 1/N)
/// of explicit Euler, -g/2 of what is of second order or more; with steps of 1/60 s Euler is off by g/120.
TEST(CasesOfSteps, a_second_of_fall_in_so_many_steps) {
  for (const int count : {10, 60})
    for (const auto& [integrator, part] :
         {std::pair{"semi_implicit_euler", 1.0}, {"explicit_euler", -1.0}, {"heun", 0.0}, {"rk4", 0.0}}) {
      Scenario scenario = parsed(
          "[environment]\ngravity = \"constant\"\natmosphere = \"vacuum\"\n[[shot]]\n"
          "fidelity = { preset = \"game\", drag = \"off\", air = \"vacuum\", "
          "precision = \"float64\", integrator = \"" +
          std::string(integrator) + "\" }\n[until]\nground = \"off\"\ntime = 1\n");
      scenario.tolerance.step = 1.0 / count;
      EXPECT_NEAR(flown(scenario).end().position.y, -kG / 2 * (1 + part / count), 1e-12) << integrator << ' ' << count;
    }
}

/// phetsims/projectile-motion #45, #153: 10 g, 3 m across, Cd 1, at 30 m/s. Right: an RK4 with an apex of 10.00822 m
/// after 18.9 ms, 11.11 mm along the ground and 66.530 s; at the ground sqrt(2 m g / (rho Cd A)) = 0.1505016 m/s.
/// Speeds are within the tolerance of each rung.
TEST(CasesOfSteps, a_large_light_ball_is_slowed_at_once) {
  const std::string ball = kGravity + "atmosphere = { model = \"constant\", density = 1.225 }\n[[shot]]\n" +
                           "mass = \"10 g\"\ndiameter = 3\ndrag = { coefficient = 1 }\nposition = [0, 10, 0]\n"
                           "speed = 30\nelevation = \"45 deg\"\nfidelity = ";
  const double terminal = std::sqrt(2 * 0.01 * kG / (1.225 * kPi * 2.25));
  for (const auto& [rung, relative] :
       {std::pair{"{ preset = \"simulation\", gravity = \"constant\", air = \"constant\", earth = \"flat\" }", 1e-6},
        {"\"constant_air\"", 1e-6},
        {"{ preset = \"game\", precision = \"float64\" }", 1e-4}}) {
    const Flight flight = flown(ball + rung + "\n");
    EXPECT_EQ(flight.outcome(), Outcome::landed) << rung;
    EXPECT_NEAR(flight.duration(), 66.530, 0.02) << rung;
    EXPECT_NEAR(flight.end().position.x, 0.01111, 1e-4) << rung;
    EXPECT_NEAR(flight.end().position.y, 0, 1e-3) << rung;
    EXPECT_NEAR(flight.end().speed, terminal, relative * terminal) << rung;
    const auto apex = test::of_kind(flight, EventKind::apex);
    ASSERT_EQ(apex.size(), 1u) << rung;
    EXPECT_NEAR(apex[0].position.y, 10.00822, 5e-5) << rung;
    EXPECT_NEAR(apex[0].time, 0.0189, 5e-5) << rung;
  }
  // With steps of 1/60 s, in which its drag would take 216 times its speed, it is slowed and never turned around.
  for (const char* integrator : {"semi_implicit_euler", "explicit_euler", "heun", "rk4"}) {
    const Flight braked =
        flown(ball + "{ preset = \"game\", precision = \"float64\", integrator = \"" + integrator + "\" }\n",
              {"tolerance.step=16.6667 ms"});
    EXPECT_EQ(braked.outcome(), Outcome::landed) << integrator;
    EXPECT_NEAR(braked.end().position.y, 0, 1e-3) << integrator;
    EXPECT_NEAR(braked.end().speed, terminal, 1e-4 * terminal) << integrator;
    for (const double time : braked.step_times()) {
      EXPECT_GE(braked.at(time).velocity.x, 0) << integrator;
      EXPECT_LE(length(braked.at(time).velocity), 30 * (1 + 1e-12)) << integrator;
    }
  }
}

/// bdilday/pybbda: Nathan's fly ball of 100 mph. Right: an RK4 of Cd = 0.3008 + 0.0292 per 1000 rpm and
/// Cl = 1.120 S / (0.583 + 2.333 S): 123.666 m, 5.6188 s and 29.656 m; 93.188 m at 20 degrees without spin.
TEST(CasesOfBalls, a_fly_ball_by_nathans_model) {
  const std::string ball = kGravity +
                           "atmosphere = { model = \"constant\", density = \"1.1937672240826775 kg/m^3\" }\n[[shot]]\n"
                           "mass = \"5.125 oz\"\ndiameter = \"0.07377627 m\"\nposition = [0, \"3 ft\", 0]\n"
                           "speed = \"100 mph\"\nelevation = \"30 deg\"\nspin = { backspin = \"2500 rpm\" }\n"
                           "magnus = { lift = 1.120, lift_base = 0.583, lift_saturation = 2.333, "
                           "drag_per_spin = \"0.0002788394603 s\" }\n"
                           "drag = { table = \"constant\", coefficient = 0.3008 }\n" +
                           kSimple + "rotation = \"magnus\", air = \"constant\" }\n";
  const Flight flight = flown(ball);
  EXPECT_NEAR(flight.end().position.x, 123.666, 0.005);
  EXPECT_NEAR(flight.duration(), 5.6188, 1e-3);
  EXPECT_NEAR(test::of_kind(flight, EventKind::apex).at(0).position.y, 29.656, 0.005);
  EXPECT_NEAR(flown(ball, {"shot.elevation=20 deg", "shot.spin.backspin=0 rpm"}).end().position.x, 93.188, 0.005);
  // Tilted by 10 degrees it goes 7 m to the right: 7.01 m by the spin across the path, 7.03 m by all of it.
  const Vec3d tilted = flown(ball, {"shot.spin.backspin=2462.02 rpm", "shot.spin.sidespin=434.12 rpm"}).end().position;
  EXPECT_NEAR(tilted.x, 123.26, 0.05);
  EXPECT_NEAR(tilted.z, 7.02, 0.02);
}

/// cuspaceflight/tawhiri #107: longitudes beyond 180 degrees. Right: 30 km are 0.2814 degrees at 16.8 S, so that a shot
/// from 179.99 E comes down at 179.729 W.
TEST(CasesOfGlobes, a_shot_to_the_east_over_the_antimeridian_lands_in_the_west) {
  const Scenario scenario = parsed(R"([environment]
atmosphere = "vacuum"
earth = { latitude = "-16.8 deg", longitude = "179.99 deg", azimuth = "90 deg" }
[[shot]]
speed = "542.5 m/s"
elevation = "45 deg"
fidelity = { preset = "simulation", drag = "off", air = "vacuum", gravity = "wgs84", earth = "ellipsoid" }
[[expect]]
at = "end"
quantity = "longitude"
equals = "-179.729 deg"
within = "0.02 deg"
)");
  const auto longitude = must(measure(flown(scenario), scenario.expect.at(0)));
  EXPECT_NEAR(longitude, scenario.expect[0].equals, scenario.expect[0].within);
}

}  // namespace physim::scenario_cases_flight_test
