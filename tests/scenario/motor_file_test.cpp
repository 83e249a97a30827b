// Motor files and [shot.motor]: what is read, and that every mistake names its line.
#include "must.hpp"
#include "physim/scenario.hpp"

#include <cstdio>
#include <fstream>

#include "scenario/scenario.hpp"

namespace physim::scenario_motor_file_test {

constexpr const char* kTwo = R"(; two motors
A8 18 70 3-5 0.00312 0.01642 Estes
 0.1 8  ; a peak
	0.4 2
0.7 0.0

; the second
C6 18 70 0-3-5-7 .0108 0.0231 Estes
0.2 14.1
1.8 4.4
1.86 0
)";

TEST(MotorFile, a_byte_order_mark_is_no_part_of_a_name_and_xml_is_told_as_such) {
  const std::string file = testing::TempDir() + "physim_mark.eng";
  std::ofstream(file) << "\xef\xbb\xbf"
                      << "C6 18 70 0-3-5-7 .0108 0.0231 Estes\n0.2 14.1\n1.8 4.4\n1.86 0\n";
  const auto motors = must(read_motor_file(file));
  std::remove(file.c_str());
  EXPECT_EQ(motors.front().motor.name, "C6");
  EXPECT_TRUE(pick_motor(motors, "C6", file));
  const auto xml = parse_motor_file("<engine-database>\n", "f.rse");
  ASSERT_FALSE(xml);
  EXPECT_EQ(xml.error().text(), "f.rse:1: error: this is XML, as RockSim writes it; only RASP files (.eng) are read");
}

TEST(MotorFile, lines_end_as_any_program_ends_them) {
  const auto motors = must(parse_motor_file(kTwo, "two.eng"));
  for (const char* end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : std::string(kTwo)) text += c == '\n' ? std::string(end) : std::string(1, c);
    const auto others = must(parse_motor_file(text, "two.eng"));
    ASSERT_EQ(others.size(), motors.size());
    for (std::size_t i = 0; i < motors.size(); ++i) {
      EXPECT_EQ(others[i].motor, motors[i].motor);
      EXPECT_EQ(others[i].line, motors[i].line);
    }
  }
}

TEST(MotorFile, reads_motors_with_their_thrust_from_zero) {
  const auto motors = must(parse_motor_file(kTwo, "two.eng"));
  ASSERT_EQ(motors.size(), 2u);
  const MotorFileEntry& c6 = motors[1];
  EXPECT_EQ(c6.motor.name, "C6");
  EXPECT_EQ(c6.motor.propellant_mass, 0.0108);
  EXPECT_EQ(c6.mass, 0.0231);
  EXPECT_EQ(c6.diameter, 0.018);
  EXPECT_EQ(c6.length, 0.07);
  EXPECT_EQ(c6.delays, "0-3-5-7");
  EXPECT_EQ(c6.manufacturer, "Estes");
  const std::vector<ThrustPoint> thrust = {{0, 0}, {0.2, 14.1}, {1.8, 4.4}, {1.86, 0}};
  EXPECT_EQ(c6.motor.thrust, thrust);
  EXPECT_EQ(pick_motor(motors, "A8", "two.eng")->motor.thrust.size(), 4u);
}

TEST(MotorFile, the_certified_c6_has_its_impulse) {
  const auto motors = must(read_motor_file(PHYSIM_SOURCE_DIR "/scenarios/motors/estes_c6.eng"));
  ASSERT_EQ(motors.size(), 1u);
  const MotorDef& m = motors.front().motor;
  EXPECT_NEAR(total_impulse(m), 8.82, 0.01);  // N s; certified: 8.8
  EXPECT_EQ(burn_time(m), 1.86);
  EXPECT_EQ(thrust_at(m, 0.192), 14.09);
}

TEST(MotorFile, a_header_of_six_or_eight_words_leaves_its_neighbours_alone) {
  const std::string good = "GOOD 18 70 5 .010 .020 T\n 0.2 60\n 1 0\n";
  for (const char* header : {"BAD 18 70 .010 .020 T\n", "BAD 18 70 5 .010 .020 T too\n"}) {
    const std::string bad = std::string(header) + " 0.1 10\n 0.2 0\n";
    for (const std::string& text : {good + bad, bad + good}) {
      const auto motors = must(parse_motor_file(text, "f.eng"), text);
      const auto picked = must(pick_motor(motors, "GOOD", "f.eng"), text);
      EXPECT_NEAR(total_impulse(picked.motor), 30, 1e-12);
      const auto refused = pick_motor(motors, "BAD", "f.eng");
      ASSERT_FALSE(refused);
      EXPECT_EQ(refused.error().place, text.starts_with("BAD") ? "f.eng:1" : "f.eng:4");
      EXPECT_NE(refused.error().message.find("words are no header"), std::string::npos);
    }
  }
}

TEST(MotorFile, thrust_that_ends_above_zero_falls_at_its_last_point) {
  // 38 N s: 2 to 0.1 s and 36 from there, as OpenRocket and RocketPy read it.
  const std::string text = "B 18 70 P .010 .020 T\n0.1 40\n1 40\n";
  for (const std::string& file : {text, text + ";\nC6 18 70 0-3 .0108 .0231 E\n0.2 5\n1 0\n"}) {
    const auto motors = must(parse_motor_file(file, "f.eng"));
    const auto b = must(pick_motor(motors, "B", "f.eng"));
    EXPECT_NEAR(total_impulse(b.motor), 38, 1e-12);
    EXPECT_EQ(burn_time(b.motor), 1);
  }
}

/// Two pulses of 10 N s and 11 N s, each as a step or with a slope, and rows that say nothing behind the end.
TEST(MotorFile, zeros_inside_are_a_pause_and_those_behind_the_end_are_left_out) {
  const auto motors = must(
      parse_motor_file("P 18 70 0 .021 .030 E\n0 0\n0.1 0\n0.1 20\n0.6 20\n0.6 0\n1 0\n1 20\n1.5 20\n1.6 0\n2 0\n3 0\n"
                       "Q 18 70 0 .010 .020 E\n1 20\n2 0\n",
                       "f.eng"));
  ASSERT_EQ(motors.size(), 2u);
  const MotorDef motor = pick_motor(motors, "P", "f.eng")->motor;
  EXPECT_NEAR(total_impulse(motor), 21, 1e-12);
  EXPECT_EQ(burn_time(motor), 1.6);
  EXPECT_EQ(thrust_at(motor, 0.8), 0);
  EXPECT_EQ(thrust_at(motor, 0.05), 0);
  EXPECT_NEAR(propellant_left(motor, 0.8), .021 * 11 / 21, 1e-15);
  EXPECT_NEAR(total_impulse(pick_motor(motors, "Q", "f.eng")->motor), 20, 1e-12);
}

struct Bad {
  const char* text;
  const char* place;
  const char* message;
};

TEST(MotorFile, mistakes_name_their_line) {
  constexpr Bad kBad[] = {
      {"", "f.eng", "no motor"},
      {"; only words\n", "f.eng", "no motor"},
      {"0.1 5\n", "f.eng:1", "before any motor"},
      {"C6 18 70 0-3 .0108 .0231\n", "f.eng:1", "6 words"},
      {";\nC6 18 70 0-3 .0108 heavy E\n", "f.eng:2", "\"heavy\" is no mass"},
      {"C6 18 70 0-3 -1 .0231 E\n", "f.eng:1", "\"-1\" is no propellant"},
      {"C6 18 70 0-3 .0308 .0231 E\n0.1 5\n1 0\n", "f.eng:1", "more propellant"},
      {"C6 18 70 0-3 .0108 .0231 E\n0.1 five\n", "f.eng:2", "\"five\" is no number"},
      {"C6 18 70 0-3 .0108 .0231 E\n0.1 nan\n", "f.eng:2", "\"nan\" is no number"},
      {"C6 18 70 0-3 .0108 .0231 E\n0.1\n", "f.eng:2", "1 words"},
      {"C6 18 70 0-3 .0108 .0231 E\n0.2 5\n0.1 4\n1 0\n", "f.eng:3", "time 0.1 after 0.2"},
      {"C6 18 70 0-3 .0108 .0231 E\n0.2 5\n0.2 4\n0.2 3\n1 0\n", "f.eng:4", "three points at time 0.2"},
      {"C6 18 70 0-3 .0108 .0231 E\n0.2 -5\n", "f.eng:2", "not negative"},
      {"C6 18 70 0-3 .0108 .0231 E\n", "f.eng:1", "has no points"},
      {"C6 18 70 0-3 .0108 .0231 E\nB6 18 70 0-3 .0108 .0231 E\n", "f.eng:2", "has no points"},
      {"C6 18 70 0-3 .0108 .0231 E\n1 0\n", "f.eng:2", "no impulse"},
      {"C6 18 70 0-3 .0108 .0231 E\n1 0\n; B6 follows\nB6 18 70 0-3 .0108 .0231 E\n", "f.eng:2", "no impulse"},
      {"C6 18 70 0-3 .0108 .0231 E\n0.2 5\n1 0\n0.9 2\n", "f.eng:4", "time 0.9 after 1"},
  };
  for (const Bad& bad : kBad) {
    SCOPED_TRACE(bad.text);
    const auto motors = parse_motor_file(bad.text, "f.eng");
    ASSERT_FALSE(motors);
    EXPECT_EQ(motors.error().place, bad.place);
    EXPECT_NE(motors.error().message.find(bad.message), std::string::npos) << motors.error().message;
    EXPECT_FALSE(motors.error().hint.empty());
  }
}

TEST(MotorFile, one_of_several_is_asked_for_by_name) {
  const auto motors = parse_motor_file(kTwo, "two.eng");
  EXPECT_NE(pick_motor(*motors, "", "two.eng").error().text().find("A8"), std::string::npos);
  EXPECT_NE(pick_motor(*motors, "C5", "two.eng").error().text().find("A8, C6"), std::string::npos);
}

TEST(MotorFile, names_that_several_makers_use_are_told_with_them) {
  const std::string points = " 0.1 5\n 2 0\n";
  const auto motors = must(parse_motor_file(
      "A 18 70 0 0.01 0.02 X\n" + points + "A 18 70 0 0.01 0.03 Y\n" + points + "C 18 70 0 0.01 0.03 Y\n" + points,
      "f.eng"));
  EXPECT_NE(pick_motor(motors, "B", "f.eng").error().text().find("motors: X A, Y A, C"), std::string::npos)
      << pick_motor(motors, "B", "f.eng").error().text();
}

TEST(MotorFile, two_of_one_name_are_told_apart_by_their_makers) {
  const std::string estes = "C6 18 70 5 0.0108 0.0231 Estes\n0.2 14\n1.9 0\n",
                    quest = "; other\nC6 18 70 5 0.0120 0.0226 Quest\n0.2 30\n1.9 0\n";
  const auto motors = must(parse_motor_file(estes + quest, "makers.eng"));
  const auto either = pick_motor(motors, "C6", "makers.eng");
  ASSERT_FALSE(either);
  EXPECT_EQ(either.error().text(),
            "makers.eng: error: two motors are named \"C6\", in lines 1 and 5; name its maker, too: "
            "\"Estes C6\" or \"Quest C6\"");
  const auto picked = must(pick_motor(motors, "Quest C6", "makers.eng"));
  EXPECT_EQ(picked.manufacturer, "Quest");
  EXPECT_EQ(picked.motor.name, "C6");
  EXPECT_EQ(pick_motor(motors, "Estes C6", "makers.eng")->manufacturer, "Estes");
  EXPECT_TRUE(pick_motor(*parse_motor_file(estes + estes, "f.eng"), "C6", "f.eng")) << "a copy is no other motor";
  std::string other = estes;
  other.replace(other.find("0.2 14"), 6, "0.2 15");
  const auto same_maker = pick_motor(*parse_motor_file(estes + other, "f.eng"), "Estes C6", "f.eng");
  ASSERT_FALSE(same_maker);
  EXPECT_NE(same_maker.error().text().find("in lines 1 and 4; take one of them out of the file"), std::string::npos);
}

std::string rocket(const std::string& motor) {
  return "physim = 1\n[[shot]]\nname = \"r\"\nmass = \"0.1 kg\"\nrail_length = \"1 m\"\nelevation = \"80 deg\"\n" +
         motor;
}

Error error_of(const std::string& motor) {
  const auto scenario = parse_scenario(rocket(motor), PHYSIM_SOURCE_DIR "/scenarios/r.toml");
  EXPECT_FALSE(scenario) << motor;
  return scenario ? Error{} : scenario.error();
}

TEST(MotorSettings, a_table_in_the_scenario) {
  const auto scenario = parse_scenario(rocket(R"([shot.motor]
name = "own"
thrust = [[0, 0], ["100 ms", "10 N"], [1, 0]]
propellant_mass = "10 g"
propellant = [[0, "10 g"], [0.5, "4 g"], [1, 0]]
ignition_delay = "0.5 s"
drag_factor = 0.9
drag_curve = [[0, 0.4], [1, 0.7]]
)"),
                                       "r.toml");
  ASSERT_TRUE(scenario) << scenario.error().text();
  const MotorDef& m = scenario->shots[0].projectile.motor;
  const std::vector<ThrustPoint> thrust = {{0, 0}, {0.1, 10}, {1, 0}};
  EXPECT_EQ(m.thrust, thrust);
  EXPECT_EQ(m.propellant_mass, 0.01);
  EXPECT_EQ(m.propellant[1].mass, 0.004);
  EXPECT_EQ(m.ignition_delay, 0.5);
  EXPECT_EQ(m.drag_factor, 0.9);
  EXPECT_EQ(m.drag_curve[1].coefficient, 0.7);
  EXPECT_EQ(scenario->shots[0].launch.rail_length, 1);
  EXPECT_EQ(fly_shot(*scenario, scenario->shots[0]).error(), std::nullopt);
}

TEST(MotorSettings, a_file_from_the_scenarios_folder_and_changes_to_it) {
  const auto scenario = must(parse_scenario(
      rocket("motor = { file = \"motors/estes_c6.eng\", ignition_delay = \"1 s\" }\n"
             "[[expect]]\nat = \"burnout\"\nquantity = \"mass\"\nequals = \"89.2 g\"\nwithin = \"1e-9 kg\"\n"),
      PHYSIM_SOURCE_DIR "/scenarios/r.toml"));
  const MotorDef& m = scenario.shots[0].projectile.motor;
  EXPECT_EQ(m.name, "C6");
  EXPECT_EQ(m.thrust.size(), 25u);
  EXPECT_EQ(m.ignition_delay, 1);
  const Flight flight = fly_shot(scenario, scenario.shots[0]);
  EXPECT_NEAR(*measure(flight, scenario.expect[0]), 0.0892, 1e-12);
  // What is written reads back without the file.
  std::vector<std::string> overrides;
  for (const auto& [path, value] : effective_settings(scenario))
    if (path.starts_with("shot.r.")) overrides.push_back(path + "=" + value);
  const auto again = must(parse_scenario(rocket(""), "elsewhere.toml", overrides));
  EXPECT_EQ(again.shots[0].projectile, scenario.shots[0].projectile);
}

TEST(MotorSettings, thrust_may_step) {
  // Tsiolkovsky: v = (120 N s / 0.1 kg) ln(2 / 1.9) at burnout.
  const auto scenario = parse_scenario(R"(physim = 1
[environment]
gravity = { model = "off" }
atmosphere = { model = "vacuum" }
[[shot]]
mass = "2 kg"
elevation = "90 deg"
rail_length = "1 m"
motor = { propellant_mass = "0.1 kg", thrust = [["0 s", "60 N"], ["2 s", "60 N"], ["2 s", "0 N"], ["3 s", "0 N"]] }
fidelity = { preset = "simulation", gravity = "off", air = "vacuum", wind = "off", earth = "flat" }
[until]
time = "4 s"
)",
                                       "r.toml");
  ASSERT_TRUE(scenario) << scenario.error().text();
  EXPECT_NEAR(fly_shot(*scenario, scenario->shots[0]).end().speed, 61.551953, 1e-5);
  EXPECT_NE(error_of("[shot.motor]\nthrust = [[0, 1], [1, 1], [1, 2], [1, 0]]\n").hint.find("are a step"),
            std::string::npos)
      << "three are none";
}

TEST(MotorSettings, a_loaded_rocket_weighs_as_much_as_its_motor) {
  const std::string text = rocket("motor = { file = \"motors/estes_c6.eng\" }\n");
  const auto light =
      parse_scenario(text, PHYSIM_SOURCE_DIR "/scenarios/r.toml", std::vector<std::string>{"shot.mass=20 g"});
  ASSERT_FALSE(light);
  EXPECT_NE(light.error().message.find("the motor alone weighs"), std::string::npos) << light.error().text();
}

TEST(MotorSettings, mistakes_name_their_place) {
  const Error missing = error_of("motor = { file = \"motors/none.eng\" }\n");
  EXPECT_NE(missing.text().find("none.eng"), std::string::npos);
  EXPECT_NE(missing.message.find("no such file"), std::string::npos);
  const Error unsorted = error_of("[shot.motor]\nthrust = [[0, 1], [2, 1], [1, 0]]\n");
  EXPECT_NE(unsorted.place.find(":8:"), std::string::npos);
  EXPECT_NE(unsorted.message.find("time 1 after 2"), std::string::npos);
  EXPECT_NE(error_of("[shot.motor]\nthrust = [[0, \"5 kg\"]]\n").text().find("force"), std::string::npos);
  EXPECT_NE(error_of("[shot.motor]\nthrust = [[0, -5], [1, 0]]\n").message.find("out of range"), std::string::npos);
  EXPECT_NE(error_of("[shot.motor]\nignition_delay = 1\n").message.find("no thrust"), std::string::npos);
  EXPECT_NE(error_of("[shot.motor]\nthrust = [[0, 5], [1, 0]]\npropellant_mass = 1\n").message.find("not less"),
            std::string::npos);
  const auto no_rail = parse_scenario(rocket("motor = { thrust = [[0, 5], [1, 0]] }\n"), "r.toml",
                                      std::vector<std::string>{"shot.rail_length=0"});
  ASSERT_FALSE(no_rail);
  EXPECT_NE(no_rail.error().message.find("needs a rail"), std::string::npos);
}

}  // namespace physim::scenario_motor_file_test
