// Settings that another one overrules, and numbers that are unlikely, are told with their place.
#include <fstream>

#include "must.hpp"
#include "physim/scenario.hpp"
#include "scenario/scenario.hpp"

namespace physim::scenario_notes_test {

std::vector<std::string> notes_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return must(parse_scenario("physim = 1\n" + text, "f.toml", overrides)).notes;
}

void expect_note(const std::string& text, const std::string& place, const std::string& words) {
  const std::vector<std::string> notes = notes_of(text);
  ASSERT_EQ(notes.size(), 1U) << text;
  EXPECT_EQ(notes[0].substr(0, place.size() + 2), place + ": ") << notes[0];
  EXPECT_NE(notes[0].find(words), std::string::npos) << notes[0];
}

TEST(Notes, settings_that_another_one_overrules) {
  expect_note("[[shot]]\ndrag = { table = \"g7\", ballistic_coefficient = 150, form_factor = 3 }", "f.toml:3:67",
              "shot.drag.form_factor: has no effect beside shot.drag.ballistic_coefficient");
  expect_note("[[shot]]\ndrag = { table = \"g7\", ballistic_coefficient = 150, coefficient = 5 }", "f.toml:3:67",
              "shot.drag.coefficient: has no effect beside shot.drag.table = \"g7\"");
  expect_note("[[shot]]\ndrag = { table = \"g7\", curve = [[0, 9], [5, 9]] }", "f.toml:3:32",
              "shot.drag.curve: has no effect beside shot.drag.table = \"g7\"");
  expect_note("[environment.wind]\nvelocity = [0, 0, 10]\nprofile = [{ at = 0, velocity = [0, 0, -10] }]\n[[shot]]",
              "f.toml:3:12", "has no effect beside environment.wind.profile");
  EXPECT_TRUE(notes_of("[[shot]]\ndrag = { table = \"g7\", form_factor = 3 }").empty());
  EXPECT_TRUE(notes_of("[[shot]]\ndrag = { table = \"custom\", curve = [[0, 9], [5, 9]] }").empty());
  EXPECT_EQ(
      notes_of("[[shot]]\ndrag = { table = \"g7\", form_factor = 3 }", {"shot.drag.ballistic_coefficient=150 kg/m^2"})
          .size(),
      1U)
      << "what --set gives counts, too";
}

TEST(Notes, numbers_of_joints_of_another_kind_and_places_of_fired_shots) {
  const std::string world = "[world]\n[[shot]]\nname = \"a\"\n";
  expect_note(world + "[[joint]]\na = \"a\"\nkind = \"rod\"\nlength = 1\nstiffness = 5\npoint = [1, 0, 0]\n",
              "f.toml:9:13", "joint.stiffness: has no effect beside joint.kind = \"rod\"");
  EXPECT_TRUE(notes_of(world + "[[joint]]\na = \"a\"\nkind = \"spring\"\nlength = 1\nstiffness = 5\n").empty());
  expect_note(world + "speed = \"500 m/s\"\n[[emitter]]\nname = \"gun\"\nshot = \"a\"\nper_second = 10\n", "f.toml:5:9",
              "shot.speed: has no effect beside the emitter \"gun\", which fires it");
}

TEST(Notes, numbers_far_from_what_is_usual) {
  expect_note("[environment.atmosphere]\npressure = 1013\n[[shot]]", "f.toml:3:12", "as \"1013 hPa\"");
  expect_note("[tolerance]\nrelative = 1e300\n[[shot]]", "f.toml:3:12", "1e-12 to 1e-4");
  expect_note("[environment]\naltitude = 1e9\n[[shot]]", "f.toml:3:12", "height above the sea");
  expect_note("[[shot]]\nspeed = 9e8", "f.toml:3:9", "no relativity");
  expect_note("[[shot]]\ndiameter = \"7.62 mm\"\nmass = \"1 kg\"", "f.toml:4:8", "254 calibres long");
  const std::string bullet = "[[shot]]\nmass = \"168 gr\"\ndiameter = \"0.308 in\"\nlength = \"1.22 in\"\n";
  expect_note(bullet + "speed = \"2600 ft/s\"\ntwist = \"50 cm\"\n", "f.toml:7:9", "stability factor of 0.");
  EXPECT_TRUE(notes_of(bullet + "speed = \"2600 ft/s\"\ntwist = \"12 in\"\n").empty());
  expect_note(bullet + "speed = \"2600 ft/s\"\ntwist = \"24 in\"\n", "f.toml:7:9", "shot.twist: 0.6096 m is unusual");
  EXPECT_TRUE(notes_of("[environment]\ngravity = { model = \"constant\", acceleration = 3.7 }\n"
                       "atmosphere = { pressure = 636 }\n[[shot]]")
                  .empty())
      << "Mars";
  // Pressures of the sea that are given for a high station: records of the sea are 870 and 1085 hPa.
  const auto station = [](const std::string& altitude, const std::string& pressure) {
    return "[environment]\naltitude = \"" + altitude + "\"\natmosphere = { pressure = \"" + pressure + "\" }\n[[shot]]";
  };
  expect_note(station("1600 m", "29.92 inHg"), "f.toml:4:27", "not reduced to the sea");
  expect_note(station("4000 m", "1013 hPa"), "f.toml:4:27", "not reduced to the sea");
  expect_note(station("0 m", "865 hPa"), "f.toml:4:27", "not reduced to the sea");
  for (const auto& [altitude, pressure] : {std::pair{"1600 m", "835 hPa"}, {"4000 m", "630 hPa"}, {"0 m", "875 hPa"}})
    EXPECT_TRUE(notes_of(station(altitude, pressure)).empty()) << altitude;
}

TEST(Notes, shots_that_begin_below_the_ground) {
  const std::string world = "[world]\nground = { height = 0.3 }\n[[shot]]\nname = \"a\"\nposition = [0, ";
  expect_note(world + "0.1, 0]\n", "f.toml:4:1",
              "shot: it begins at a height of 0.1 m, below world.ground.height = 0.3 m");
  EXPECT_TRUE(notes_of(world + "0.3, 0]\n").empty());
  EXPECT_TRUE(notes_of(world + "0.1, 0]\n", {"world.ground.height=0"}).empty());
}

TEST(Notes, shots_that_rise_from_below_the_ground) {
  const std::string shot = "[[shot]]\nposition = [0, -5, 0]\nspeed = 100\n", up = "elevation = \"30 deg\"\n";
  const std::string world = "[world]\n[world.ground]\nheight = 0\n";
  const std::string begins = "shot: it begins at a height of -5 m, below ";
  const std::string rises = ", and rises through it; it lands where it sinks to the ground or below it";
  expect_note(world + shot + up, "f.toml:5:1", begins + "world.ground.height = 0 m" + rises);
  expect_note(shot + up, "f.toml:2:1", begins + "until.ground = 0 m" + rises);
  expect_note(world + shot, "f.toml:5:1", begins + "world.ground.height = 0 m, and has landed there");
  expect_note(shot, "f.toml:2:1", begins + "until.ground = 0 m, and has landed there");
  expect_note("[[shot]]\nposition = [0, -5, 0]\nvelocity = [9, 9, 0]\n", "f.toml:2:1", rises);
  expect_note(shot + "sight = { zero_range = 100 }\n", "f.toml:2:1", "and lands at once unless it rises");
  EXPECT_TRUE(notes_of("[until]\nground = \"off\"\n" + shot).empty());
  EXPECT_TRUE(notes_of("[world]\n[world.ground]\nmode = \"bounce\"\n" + shot).empty());
}

TEST(Notes, motors_that_never_burn) {
  const auto rocket = [](const std::string& more) {
    return "[[shot]]\nmass = 1\nrail_length = 1\nelevation = \"90 deg\"\nmotor = { propellant_mass = 0.1, "
           "ignition_delay = 9, thrust = [[0, "
           "40], [1, 0]] }\n" +
           more;
  };
  expect_note(rocket("[until]\ntime = 8\n"), "f.toml:6:51",
              "shot.motor.ignition_delay: 9 s, and until.time = 8 s: the motor never burns");
  expect_note(rocket("[world]\nduration = 9\n"), "f.toml:6:51", "world.duration = 9 s: the motor never burns");
  expect_note(rocket("[world]\nduration = 12\n[[volley]]\nshot = \"shot-1\"\nstart = 4\n"), "f.toml:6:51",
              "the motor never burns");
  EXPECT_TRUE(notes_of(rocket("[until]\ntime = 9.5\n")).empty());
  EXPECT_TRUE(notes_of(rocket("[world]\nduration = 14\n[[volley]]\nshot = \"shot-1\"\nstart = 4\n")).empty());
}

TEST(Notes, emitters_that_nothing_fires) {
  const auto emitters = [](const std::string& first, const std::string& second) {
    return "[world]\nduration = 2\n[[shot]]\nname = \"a\"\n[[emitter]]\nname = \"x\"\nshot = \"a\"\n" + first +
           "[[emitter]]\nname = \"y\"\nshot = \"a\"\n" + second;
  };
  const std::string idle = "per_second = 0\n", sub = "sub = [{ emitter = \"y\" }]\n";
  EXPECT_TRUE(notes_of(emitters(sub, idle)).empty());
  expect_note(emitters("", idle), "f.toml:9:1",
              "emitter: nothing fires it: it has no rate, burst, gun or rain, and is the sub of no emitter that fires");
  expect_note(emitters("", "cycle = { plays = false }\n"), "f.toml:9:1", "emitter: nothing fires it: it does not play");
  const std::vector<std::string> both = notes_of(emitters(idle + sub, idle));
  ASSERT_EQ(both.size(), 2U) << "a sub of what never fires";
  EXPECT_EQ(both[0].substr(0, 11), "f.toml:6:1:");
}

TEST(Notes, what_is_due_when_the_run_has_ended) {
  const std::string world = "[world]\nduration = 2\n[[shot]]\nname = \"a\"\nspeed = 1\nposition = [0, 99, 0]\n";
  const auto volley = [&](const std::string& more) { return world + "[[volley]]\nshot = \"a\"\n" + more; };
  expect_note(volley("start = 2\n"), "f.toml:10:9", "volley.start: 2 s, and world.duration = 2 s: it never fires");
  EXPECT_TRUE(notes_of(volley("count = 21\ninterval = 0.1\n")).empty()) << "the table says how many it fires";
  expect_note(world + "[[force]]\nconstant_force = { force = [1, 0, 0] }\ndelay = 2\n", "f.toml:10:9",
              "force.delay: 2 s, and world.duration = 2 s: it never acts");
  const auto emitter = [](const std::string& more) {
    return "[world]\nduration = 2\n[[shot]]\nname = \"a\"\n[[emitter]]\nshot = \"a\"\n" + more;
  };
  expect_note(emitter("cycle = { delay = 3 }\n"), "f.toml:8:19",
              "emitter.cycle.delay: 3 s, and world.duration = 2 s: it fires nothing");
  expect_note(emitter("bursts = [{ time = 0.5, count = 2 }, { time = 3, count = 2 }]\n"), "f.toml:8:10",
              "emitter.bursts: burst 2 is due at 3 s, and world.duration = 2 s: it never comes");
  EXPECT_TRUE(notes_of(emitter("bursts = [{ time = 2, count = 2 }]\n")).empty()) << "it comes at the end";
  EXPECT_TRUE(notes_of(emitter("cycle = { delay = 1.5 }\n")).empty());
}

TEST(Notes, rifles_in_units_of_another_kind) {
  const auto rifle = [](const std::string& speed, const std::string& coefficient, const std::string& height) {
    return "[[shot]]\nmass = \"168 gr\"\ndiameter = \"0.308 in\"\nspeed = " + speed +
           "\ndrag = { table = \"g7\", ballistic_coefficient = " + coefficient + " }\nsight = { height = " + height +
           " }\n";
  };
  const std::string speed = "\"2600 ft/s\"", coefficient = "\"0.218 lb/in^2\"", height = "\"1.5 in\"";
  EXPECT_TRUE(notes_of(rifle(speed, coefficient, height)).empty());
  expect_note(rifle("2600", coefficient, height), "f.toml:5:9", "shot.speed: 2600 m/s is unusual; bullets of rifles");
  expect_note(rifle(speed, coefficient, "1.5"), "f.toml:7:20", "shot.sight.height: 1.5 m is unusual");
  expect_note(rifle(speed, "\"218 lb/in^2\"", height), "f.toml:6:48", "the form factor is 0.0012");
  expect_note(rifle(speed, "0.218", height), "f.toml:6:48", "shot.drag.ballistic_coefficient: 0.218 kg/m^2 is unusual");
  EXPECT_TRUE(
      notes_of("[[shot]]\nmass = 1000\ndiameter = 0.4\nspeed = 700\ndrag = { ballistic_coefficient = 6000 }\n").empty())
      << "a shell of this sectional density";
  EXPECT_TRUE(notes_of("[[shot]]\nmass = 0.001\ndiameter = 0.005\nspeed = 7000\n").empty()) << "no bullet";
  EXPECT_EQ(notes_of(rifle(speed, coefficient, height), {"shot.speed=2600"}).size(), 1U);
}

TEST(Notes, hits_of_what_is_only_passed) {
  const auto scene = [](const std::string& thing, const std::string& body, const std::string& quantity) {
    return "[[shape]]\nname = \"b\"\nbox = [1, 1, 1]\n[[thing]]\nname = \"zone\"\nshape = \"b\"\n" + thing +
           "[[shot]]\nvelocity = [10, 0, 0]\nposition = [-9, 0, 0]\n" + body +
           "[[expect]]\nthing = \"zone\"\nquantity = \"" + quantity + "\"\nequals = 1\nwithin = 0\n";
  };
  const std::string sensor = "sensor = true\n", passes = "body = { collision = { on_hit = \"pass\" } }\n";
  for (const std::string world : {"", "[world]\nground = \"none\"\n"}) {
    const auto notes = notes_of(world + scene(sensor, "", "hits"));
    ASSERT_EQ(notes.size(), 1U) << testing::PrintToString(notes);
    EXPECT_NE(notes[0].find("expect.quantity: \"hits\" is of hits, and the sensor \"zone\" is passed without one: "
                            "\"passages\" counts ways into it"),
              std::string::npos)
        << notes[0];
    EXPECT_EQ(notes_of(world + scene("", passes, "hit_speed")).size(), 1U);
    EXPECT_TRUE(notes_of(world + scene("", "", "hits")).empty());
    EXPECT_TRUE(notes_of(world + scene(sensor, "", "passages")).empty());
  }
}

TEST(Notes, shots_whose_rules_of_despawning_end_them_at_once) {
  const std::string shot = "[world]\n[[shot]]\nspeed = 3\nposition = [0, 1, 0]\nbody = { despawn = { ";
  expect_note(shot + "below = 1.5 } }\n", "f.toml:3:1", "below shot.body.despawn.below = 1.5 m, and leaves at once");
  expect_note(shot + "slower = 11 } }\n", "f.toml:3:1",
              "it begins with 3 m/s, below shot.body.despawn.slower = 11 m/s");
  EXPECT_TRUE(notes_of(shot + "below = 0.5, slower = 1 } }\n").empty());
}

TEST(Notes, a_motor_that_is_too_weak) {
  const std::string rocket = "[[shot]]\nmass = \"350 g\"\nrail_length = 1\nelevation = \"90 deg\"\n";
  expect_note(rocket + "motor = { propellant_mass = \"30 g\", thrust = [[0, 3], [1, 0]] }\n", "f.toml:6:9",
              "never exceeds the weight along the rail");  // 3.138 N are left of it
  EXPECT_TRUE(notes_of(rocket + "motor = { propellant_mass = \"30 g\", thrust = [[0, 4], [1, 0]] }\n").empty());
}

TEST(Notes, joints_whose_ends_are_elsewhere) {
  const std::string shots =
      "[world]\n[[shot]]\nname = \"a\"\nposition = [0, 5, 0]\n[[shot]]\nname = \"b\"\nposition = [1, 5, 0]\n"
      "[[joint]]\na = \"a\"\nb = \"b\"\n";
  expect_note(shots + "length = \"3 m\"\n", "f.toml:12:10", "joint.length: 3 m, and its ends are 1 m apart at launch");
  expect_note(shots + "kind = \"cable\"\nlength = \"0.5 m\"\n", "f.toml:13:10", "0.5 m, and its ends are 1 m apart");
  expect_note(shots + "kind = \"slider\"\naxis = [0, 2, 0]\n", "f.toml:13:8",
              "joint.axis: its ends are 1 m beside it at");
  EXPECT_TRUE(notes_of(shots + "kind = \"slider\"\naxis = [2, 0, 0]\nlow = \"-1 m\"\n").empty());
  for (const char* fine : {"", "length = \"1 m\"\n", "kind = \"cable\"\nlength = \"3 m\"\n",
                           "kind = \"spring\"\nlength = \"3 m\"\nstiffness = 5\n"})
    EXPECT_TRUE(notes_of(shots + fine).empty()) << fine;
}

TEST(Notes, rods_that_contradict_each_other) {
  const std::string shots =
      "[world]\n[[shot]]\nname = \"a\"\nposition = [0, 5, 0]\n[[shot]]\nname = \"b\"\nposition = [1, 5, 0]\n"
      "[[joint]]\na = \"a\"\nb = \"b\"\nlength = 1\n[[joint]]\na = \"a\"\nb = \"b\"\nlength = 2\n";
  const std::vector<std::string> notes = notes_of(shots);
  ASSERT_EQ(notes.size(), 2U) << "its ends are elsewhere, too";
  EXPECT_EQ(notes[1].substr(0, 13), "f.toml:16:10:");
  EXPECT_NE(notes[1].find("2 m, and other joints let its ends be 1 m apart at most"), std::string::npos) << notes[1];
  // A chain of three rods, and a fourth that is longer than all of them.
  const std::string chain =
      "[world]\n[[shot]]\nname = \"a\"\nposition = [1, 0, 0]\n[[shot]]\nname = \"b\"\nposition = [1, 1, 0]\n"
      "[[joint]]\na = \"a\"\n[[joint]]\na = \"a\"\nb = \"b\"\n[[joint]]\na = \"b\"\npoint = [0, 1, 0]\n";
  EXPECT_TRUE(notes_of(chain).empty());
  const auto far = notes_of(chain + "[[joint]]\na = \"b\"\npoint = [0, 9, 0]\n");
  EXPECT_TRUE(far.empty()) << "it is as long as its ends are apart";
  EXPECT_EQ(notes_of(chain + "[[joint]]\na = \"b\"\npoint = [0, 0, 0]\nlength = 9\n").size(), 2U);
}

TEST(Notes, emitters_that_stop_by_their_number) {
  const std::string world = "[world]\n[[shot]]\nname = \"a\"\n[[emitter]]\nshot = \"a\"\n";
  expect_note(world + "per_second = 1e9\n", "f.toml:7:14", "are 16666667 in a step");
  expect_note(world + "per_second = 0\nbursts = [{ time = 0, count = 5e6 }]\n", "f.toml:8:10", "a burst of 5000000");
  EXPECT_TRUE(notes_of(world + "per_second = 1e7\n").empty());
  EXPECT_TRUE(notes_of(world + "cycle = { prewarm = true, duration = \"1e7 s\" }\n").empty()) << "it is skipped";
  expect_note(world + "bursts = [{ count = 1 }]\ncycle = { prewarm = true, duration = \"1e7 s\" }\n", "f.toml:8:21",
              "one cycle has 100000000 particles");
}

TEST(Notes, a_field_whose_black_is_not_below_its_white) {
  if (!reads_height_maps()) GTEST_SKIP() << "built without stb";
  const std::string file = testing::TempDir() + "notes_field.pgm";
  std::ofstream(file) << "P5\n2 2\n255\n" << std::string("\0\377\0\377", 4);
  const auto field = [&](const std::string& heights) {
    return notes_of("[[shot]]\n[[shape]]\nheight_field = { file = \"" + file + "\", spacing_x = 1, spacing_z = 1, " +
                    heights + " }\n[[thing]]\nshape = \"shape-1\"\n");
  };
  EXPECT_TRUE(field("low = 1, high = 5").empty());
  ASSERT_EQ(field("low = 5, high = 1").size(), 1U);
  EXPECT_NE(field("low = 5, high = 1")[0].find("black is high ground"), std::string::npos);
  EXPECT_NE(field("low = 5, high = 5")[0].find("the field is flat"), std::string::npos);
}

TEST(Notes, shipped_scenarios_need_none) {
  for (const char* name : {"308_168gr_g7", "shot_put", "study_308", "aim_moving_target"}) {
    const auto scenario = must(load_scenario(std::string(PHYSIM_SOURCE_DIR "/scenarios/") + name + ".toml"), name);
    EXPECT_TRUE(scenario.notes.empty()) << name << ": " << scenario.notes.front();
  }
}

}  // namespace physim::scenario_notes_test
