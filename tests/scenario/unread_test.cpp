// Each setting that is given and that nothing reads is told, by its path and the reason; one that is read is not.
#include <algorithm>

#include "must.hpp"
#include "scenario/reader.hpp"
#include "scenario/scenario.hpp"
#include "scenario/unread.hpp"

namespace physim::scenario_unread_test {

/// Notes made when they are asked for, as in Python, are those made with the scenario.
void expect_same_notes_later(const std::string& text, const std::vector<std::string>& notes) {
  const Value document = must(parse_document(text, "f.toml"));
  Scenario without;
  ASSERT_TRUE(read_scenario(document, "f.toml", Checks::together, without));
  EXPECT_TRUE(without.notes.empty());
  EXPECT_EQ(*physim::notes_of(without, document), notes) << text;
}

std::vector<std::string> notes_of(const std::string& text) {
  const std::string whole = "physim = 1\n" + text;
  const auto scenario = parse_scenario(whole, "f.toml");
  EXPECT_TRUE(scenario) << text << ": " << (scenario ? "" : scenario.error().text());
  if (!scenario) return {};
  expect_same_notes_later(whole, scenario->notes);
  return scenario->notes;
}

bool says(const std::string& text, const std::string& words) {
  return std::ranges::any_of(notes_of(text), [&](const std::string& note) { return note.find(words) != note.npos; });
}

/// The setting has no effect in the first text, and has one in the second.
void expect_unread(const std::string& path, const std::string& why, const std::string& unread,
                   const std::string& read) {
  EXPECT_TRUE(says(unread, ": " + path + ": has no effect" + why))
      << unread << testing::PrintToString(notes_of(unread));
  EXPECT_FALSE(says(read, ": " + path + ": has no effect")) << read << testing::PrintToString(notes_of(read));
}

const std::string kShot = "[[shot]]\nmass = 1\ndiameter = 0.1\n";

TEST(Unread, settings_of_the_air_and_the_earth) {
  const auto air = [](const std::string& keys, const std::string& rung) {
    return "[environment.atmosphere]\n" + keys + "\n" + kShot + "fidelity = { air = \"" + rung + "\" }\n";
  };
  expect_unread("environment.atmosphere.scale_height", ": only air \"exponential\"", air("scale_height = 7000", "isa"),
                air("scale_height = 7000", "exponential"));
  expect_unread("environment.atmosphere.density", ": only air \"constant\"", air("density = 1", "isa"),
                air("density = 1", "constant"));
  expect_unread("environment.atmosphere.pressure", " beside environment.atmosphere.density",
                air("density = 1\npressure = 9e4", "constant"), air("density = 1\npressure = 9e4", "isa"));
  expect_unread("environment.atmosphere.station_altitude", " without environment.atmosphere.temperature",
                air("station_altitude = 500", "isa"), air("station_altitude = 500\ntemperature = 280", "isa"));
  expect_unread("environment.atmosphere.temperature", ": no shot flies in air", air("temperature = 280", "vacuum"),
                air("temperature = 280", "isa"));
  for (const char* world : {"", "[world]\n"})
    expect_unread("environment.atmosphere.sound_speed", ": only air \"constant\"",
                  world + air("sound_speed = 300", "vacuum"), world + air("sound_speed = 300", "constant"));
  const auto earth = [](const std::string& model) {
    return "[environment.earth]\nrotation_rate = 1e-4\n" + kShot + "fidelity = { earth = \"" + model + "\" }\n";
  };
  expect_unread("environment.earth.rotation_rate", ": only shots over an Earth that turns", earth("flat"),
                earth("flat_coriolis"));
}

/// What an override is said to be without effect for; empty: it has one.
std::string unread_override(const std::string& text, const std::string& setting) {
  const std::vector<std::string> overrides = {setting};
  const auto scenario = parse_scenario("physim = 1\n" + text, "f.toml", overrides);
  EXPECT_TRUE(scenario) << (scenario ? "" : scenario.error().text());
  for (const std::string& note : scenario ? scenario->notes : std::vector<std::string>{})
    if (note.starts_with("--set " + setting) && note.find("has no effect") != note.npos) return note;
  return "";
}

TEST(Unread, places_on_an_earth_that_is_flat_and_still) {
  const auto earth = [](const std::string& keys, const std::string& model, const std::string& more = "") {
    return "[environment.earth]\n" + keys + "\n" + kShot + "fidelity = { earth = \"" + model + "\" }\n" + more;
  };
  expect_unread("environment.earth.latitude", ": only shots over an Earth that turns read it",
                earth("latitude = 0.5", "flat"), earth("latitude = 0.5", "flat_coriolis"));
  EXPECT_FALSE(says(earth("latitude = 0.5", "sphere"), "has no effect")) << "heights are over a round Earth";
  const std::string flat = earth("", "flat"), turning = earth("", "flat_coriolis"), round = earth("", "sphere");
  const std::string longitude = "environment.earth.longitude=0.5", azimuth = "environment.earth.azimuth=0.5";
  EXPECT_NE(unread_override(flat, azimuth).find(": only shots over an Earth that turns read it"), std::string::npos);
  EXPECT_EQ(unread_override(turning, azimuth), "");
  const std::string weighed =
      kShot +
      "speed = 9\nfidelity = { earth = \"flat\", gravity = \"wgs84\" }\n[environment.gravity]\nmodel = \"wgs84\"\n";
  EXPECT_NE(unread_override(weighed, azimuth).find(": only shots over an Earth that turns read it"), std::string::npos)
      << "weight points down whichever way x does";
  for (const char* of_weight : {"environment.earth.latitude=0.5", "environment.earth.rotation_rate=1e-4"})
    EXPECT_EQ(unread_override(weighed, of_weight), "");
  EXPECT_NE(unread_override(turning, longitude).find(": only shots over a round Earth read it"), std::string::npos);
  EXPECT_EQ(unread_override(round, longitude), "");
  EXPECT_FALSE(says(earth("longitude = 0.5\nazimuth = 0.5", "flat"), "has no effect")) << "in a file they describe";
  const std::string checked = "[[expect]]\nquantity = \"longitude\"\nequals = 0.5\nwithin = 1\n";
  EXPECT_EQ(unread_override(flat + checked, longitude), "") << "a figure is checked by it";
  const std::string compass =
      "[study]\ninputs = [\"environment.wind.speed = +- 1 m/s\", \"environment.wind.from = 0 deg .. 9 deg\"]\n";
  EXPECT_EQ(unread_override(flat + compass, azimuth), "") << "north is where it says";
}

TEST(Unread, wind_that_a_zero_leaves_out_where_there_is_none) {
  const std::string zeroed = kShot + "speed = 800\nsight = { zero_range = 100, zero_in_calm_air = true }\n";
  expect_unread("shot.sight.zero_in_calm_air", " without environment.wind", zeroed,
                zeroed + "[environment.wind]\nvelocity = [0, 0, 3]\n");
}

TEST(Unread, altitude_of_shots_that_fly_in_no_air) {
  const auto shot = [](const std::string& air) { return kShot + "fidelity = { air = \"" + air + "\" }\n"; };
  EXPECT_NE(unread_override(shot("vacuum"), "environment.altitude=3000").find(": no shot flies in air"),
            std::string::npos);
  EXPECT_EQ(unread_override(shot("constant"), "environment.altitude=3000"), "")
      << "its density is that of the altitude";
  EXPECT_EQ(unread_override(shot("isa"), "environment.altitude=3000"), "");
  EXPECT_FALSE(says("[environment]\naltitude = 3000\n" + shot("vacuum"), "has no effect")) << "in a file it describes";
}

TEST(Unread, real_time_in_runs) {
  const std::string world = "[world]\n" + kShot;
  for (const char* setting : {"world.time_scale=2", "world.max_steps=5"})
    EXPECT_NE(unread_override(world, setting).find(" in a run: only programs that step the world in real time"),
              std::string::npos);
  EXPECT_FALSE(says("[world]\ntime_scale = 2\nmax_steps = 5\n" + kShot, "has no effect")) << "a client reads them";
}

TEST(Unread, cycles_of_emitters_that_fire_only_as_subs) {
  const auto emitter = [](const std::string& keys) {
    return "[world]\n" + kShot +
           "[[emitter]]\nname = \"e\"\nshot = \"shot-1\"\nsub = [{ on = \"death\", emitter = \"k\" }]\n"
           "[[emitter]]\nname = \"k\"\nshot = \"shot-1\"\n" +
           keys + "\n";
  };
  EXPECT_FALSE(says(emitter("cycle = { plays = false }"), "has no effect")) << "it fires otherwise by itself";
  EXPECT_TRUE(says(emitter("per_second = 0\ncycle = { plays = false }"),
                   "emitter.cycle.plays: has no effect: the emitter has no rate, burst, gun or rain"));
  expect_unread("emitter.cycle.duration", ": the emitter fires only as the sub of others",
                emitter("cycle = { plays = false, duration = 3, looping = false }"),
                emitter("cycle = { duration = 3, looping = false }"));
  expect_unread("emitter.cycle.looping", ": the emitter fires only as the sub of others",
                emitter("cycle = { plays = false, looping = false }"), emitter("cycle = { looping = false }"));
}

TEST(Unread, bursts_that_are_due_behind_the_cycle_and_no_others) {
  const std::string text =
      "[world]\n" + kShot +
      "[[emitter]]\nshot = \"shot-1\"\ncycle = { duration = 1 }\nbursts = [{ time = 1, count = 3 }, "
      "{ time = 0, count = 2 }, { time = 2, count = 1 }]\n";
  const std::vector<std::string> notes = notes_of(text);
  ASSERT_EQ(notes.size(), 2U) << testing::PrintToString(notes);
  EXPECT_EQ(notes[0],
            "f.toml:9:20: emitter.bursts.time: has no effect: burst 1 is due at 1 s, and the cycle ends before, see "
            "emitter.cycle.duration = 1 s");
  EXPECT_NE(notes[1].find("burst 3 is due at 2 s"), std::string::npos) << notes[1];
}

TEST(Unread, turning_of_the_earth_beside_planar_flights_along_a_meridian) {
  const auto planar = [](const std::string& azimuth) {
    return "[environment.earth]\nrotation_rate = 1e-4\n" + kShot + "azimuth = " + azimuth +
           "\nfidelity = { earth = \"flat_coriolis\", planar = true }\n";
  };
  expect_unread("environment.earth.rotation_rate", " beside shot.fidelity.planar", planar("0"), planar("0.1"));
}

TEST(Unread, numbers_of_drag_beside_motions_that_no_force_moves) {
  const auto motion = [](const std::string& rung) {
    return kShot + "speed = 5\ndrag = { coefficient = 0.3 }\nfidelity = { motion = \"" + rung +
           "\" }\n[world]\n[[force]]\nwind_zone = { velocity = [3, 0, 0], low = [-9, -9, -9], high = [9, 9, 9] }\n";
  };
  expect_unread("shot.drag.coefficient", ": ", motion("velocity"), motion("force"));
}

/// Whether a wider diameter, given beside a scenario, is said to have no effect.
bool is_diameter_unread(const std::string& text) {
  const std::vector<std::string> wider = {"shot.diameter=0.2"};
  const auto scenario = parse_scenario("physim = 1\n" + text, "f.toml", wider);
  EXPECT_TRUE(scenario) << (scenario ? "" : scenario.error().text());
  return scenario && std::ranges::any_of(scenario->notes, [](const std::string& note) {
           return note.find("shot.diameter: has no effect") != note.npos;
         });
}

TEST(Unread, a_diameter_in_a_wind_zone_beside_a_ballistic_coefficient) {
  const auto blown = [](const std::string& drag) {
    return "[[shot]]\nmass = 1\ndiameter = 0.1\nspeed = 5\ndrag = { table = \"g7\", " + drag +
           " }\nfidelity = { air = \"vacuum\" }\n[world]\n[[force]]\n"
           "wind_zone = { velocity = [3, 0, 0], low = [-9, -9, -9], high = [9, 9, 9] }\n";
  };
  EXPECT_TRUE(is_diameter_unread(blown("ballistic_coefficient = 60")));
  EXPECT_FALSE(is_diameter_unread(blown("form_factor = 1")));
}

TEST(Unread, sizes_of_a_rigid_body_where_there_is_no_air) {
  const auto body = [](const std::string& air) {
    return kShot + "twist = 2\nlength = 0.3\ninertia = { moments = [1, 2, 2] }\n" +
           "fidelity = { rotation = \"rigid_body\", air = \"" + air + "\" }\n[world]\n";
  };
  EXPECT_TRUE(is_diameter_unread(body("vacuum")));
  EXPECT_FALSE(is_diameter_unread(body("isa")));
  expect_unread("shot.length", ": no stability factor is computed from it", body("vacuum"),
                kShot + "length = 0.3\ntwist = 2\n");
}

TEST(Unread, a_cant_about_the_bore) {
  const auto canted = [](const std::string& elevation, const std::string& look) {
    return kShot + "speed = 50\nelevation = " + elevation + "\nsight = { cant = 0.1, look_angle = " + look + " }\n";
  };
  expect_unread("shot.sight.cant", ": the bore points along the line of sight", canted("0.7", "0.7"),
                canted("0.7", "0.6"));
  EXPECT_TRUE(says(canted("0", "0") + "[world]\n", "shot.sight.cant: has no effect"));
}

TEST(Unread, one_shot_forces_of_the_original_loop) {
  const std::string path = "shot.fidelity.original_one_shot_forces";
  const auto loop = [](const std::string& integrator) {
    return kShot + "speed = 50\nfidelity = { integrator = \"" + integrator +
           "\", drag = \"linear_quadratic\", original_one_shot_forces = true }\n";
  };
  EXPECT_TRUE(says(kShot + "fidelity = { preset = \"classic\", original_one_shot_forces = true }\n",
                   path + ": has no effect without a force"));
  expect_unread(path, ": only integrator \"classic\" reads it", loop("rk4"), loop("classic"));
}

TEST(Unread, wind_that_no_shot_feels) {
  const auto wind = [](const std::string& keys, const std::string& rung) {
    return "[environment.wind]\n" + keys + "\n" + kShot + "fidelity = { wind = \"" + rung + "\" }\n";
  };
  const std::string profile = "profile = [{ at = 0, velocity = [1, 0, 0] }, { at = 9, velocity = [2, 0, 0] }]\n";
  expect_unread("environment.wind", ": no shot feels wind", wind("velocity = [0, 0, 4]", "off"),
                wind("velocity = [0, 0, 4]", "constant"));
  expect_unread("environment.wind.by", " without environment.wind.profile",
                wind("velocity = [0, 0, 4]\nby = \"range\"", "profile"), wind(profile + "by = \"range\"", "profile"));
  const std::string wind_levels =
      "[environment.wind]\nprofile = [{ at = 0, velocity = [1, 0, 0] }, { at = 9, velocity = [5, 0, 0] }]\n";
  const std::string air_levels =
      "[environment.atmosphere]\nprofile = [{ altitude = 0, temperature = 300 }, { altitude = 900, temperature = 280 "
      "}]\n";
  for (const char* preset : {"game", "constant_air"}) {
    const std::string cheap = kShot + "fidelity = \"" + preset + "\"\n";
    expect_unread("environment.wind.profile", " but at the origin: no shot flies wind \"profile\"", wind_levels + cheap,
                  wind_levels + kShot + "fidelity = \"simulation\"\n");
    expect_unread("environment.atmosphere.profile", " but at the origin: no shot flies air \"isa\"", air_levels + cheap,
                  air_levels + kShot + "fidelity = \"simulation\"\n");
    EXPECT_FALSE(says("[environment.wind]\nprofile = [{ at = 0, velocity = [1, 0, 0] }]\n" + cheap, "has no effect"))
        << "one level is the wind everywhere";
  }
  expect_unread("environment.wind.profile", " beside environment.wind.velocity",
                wind(profile + "velocity = [0, 0, 4]", "constant"), wind(profile, "profile"));
  expect_unread("shot.fidelity.wind", " without environment.wind", kShot + "fidelity = { wind = \"constant\" }\n",
                kShot +
                    "fidelity = { wind = \"constant\" }\n[study]\n"
                    "inputs = [\"environment.wind.velocity.z = 0 m/s +- 1 m/s\"]\n");
}

TEST(Unread, numbers_of_models_that_do_not_fly) {
  const auto shot = [](const std::string& keys) { return kShot + keys + "\n"; };
  expect_unread("shot.drag.k1", ": only drag \"linear_quadratic\"", shot("drag = { k1 = 0.1 }"),
                shot("drag = { k1 = 0.1 }\nfidelity = { drag = \"linear_quadratic\" }"));
  expect_unread("shot.drag.damping", ": only drag \"damping\"", shot("drag = { damping = 0.9 }"),
                shot("drag = { damping = 0.9 }\nfidelity = { drag = \"damping\" }"));
  expect_unread("shot.spin", ": only rotation \"magnus\"", shot("spin = { backspin = 9 }"),
                shot("spin = { backspin = 9 }\nmagnus = { lift = 1 }\nfidelity = { rotation = \"magnus\" }"));
  const std::string by_table =
      "fidelity = { rotation = \"magnus\" }\nspin = { backspin = 9 }\n"
      "magnus = { lift = 2, table = [{ speed = 1, spin = 1, drag = 0.3, lift = 0.1 }] }";
  expect_unread("shot.magnus.lift", " beside shot.magnus.table", shot(by_table),
                shot("spin = { backspin = 9 }\nmagnus = { lift = 1 }\nfidelity = { rotation = \"magnus\" }"));
  expect_unread("shot.drag.coefficient", " beside shot.magnus.table", shot(by_table + "\ndrag = { coefficient = 0.4 }"),
                shot("drag = { coefficient = 0.4 }"));
  expect_unread("shot.aero", ": only rotation \"rigid_body\"", shot("aero = { lift = [[0, 1]] }"),
                shot("aero = { lift = [[0, 1]] }\ninertia = { moments = [1, 2, 2] }\n"
                     "fidelity = { rotation = \"rigid_body\" }"));
  expect_unread("shot.force", ": only motion \"force\"",
                shot("force = [1, 0, 0]\nfidelity = { motion = \"velocity\" }"), shot("force = [1, 0, 0]"));
  expect_unread("shot.force_duration", " without shot.force", shot("force_duration = 1"),
                shot("force = [1, 0, 0]\nforce_duration = 1"));
  expect_unread("shot.length", " without shot.twist", shot("length = 0.3"), shot("length = 0.3\ntwist = 2"));
  for (const char* setting : {"shot.length", "shot.twist"})  // drift by a formula is added to whole flights
    expect_unread(setting, ": ", "[world]\n" + shot("length = 0.3\ntwist = 2"), shot("length = 0.3\ntwist = 2"));
  expect_unread("shot.sight.dial", " without shot.sight.zero_range", shot("sight = { dial = \"3 mil\" }"),
                shot("sight = { dial = \"3 mil\", zero_range = 5 }\nspeed = 60"));
  expect_unread("shot.sight.zero_in_calm_air", " without shot.sight.zero_range",
                shot("sight = { zero_in_calm_air = true }"),
                "[environment.wind]\nvelocity = [0, 0, 3]\n" +
                    shot("sight = { zero_in_calm_air = true, zero_range = 5 }\nspeed = 60"));
}

TEST(Unread, errors_of_steps) {
  const auto steps = [](const std::string& key, const std::string& integrator) {
    return "[tolerance]\n" + key + "\n" + kShot + "fidelity = { integrator = \"" + integrator + "\" }\n";
  };
  expect_unread("tolerance.relative", ": only adaptive integrators", steps("relative = 1e-6", "rk4"),
                steps("relative = 1e-6", "tsit5"));
  expect_unread("tolerance.step", ": only integrators of a fixed step", steps("step = 0.01", "tsit5"),
                steps("step = 0.01", "rk4"));
  expect_unread("tolerance.position_error", " beside tolerance.step", steps("position_error = 1\nstep = 0.01", "rk4"),
                steps("position_error = 1", "rk4"));
  expect_unread("tolerance.max_step", ": the steps of a [world] are world.step",
                "[world]\n" + steps("max_step = 0.01", "tsit5"), steps("max_step = 0.01", "tsit5"));
  // The flight by which the step of heun and rk4 is found takes steps of its own.
  for (const char* integrator : {"heun", "rk4"})
    expect_unread("tolerance.max_step", ": only adaptive integrators",
                  steps("max_step = 0.01\nstep = 0.01", integrator), steps("max_step = 0.01", integrator));
}

TEST(Unread, settings_of_worlds) {
  const std::string world = "[world]\n", bounce = "[world]\nground = { mode = \"bounce\", friction = 0.3 }\n";
  expect_unread("world.ground.friction", " beside world.ground.mode = \"land\"",
                "[world]\nground = { friction = 0.3 }\n" + kShot, bounce + kShot);
  expect_unread("world.observer", " without world.detail.rungs", "[world]\nobserver = [1, 2, 3]\n" + kShot,
                "[world]\nobserver = [1, 2, 3]\ndetail = { rungs = [{ fidelity = \"artillery\", within = 9 }, "
                "{ fidelity = \"game\" }] }\n" +
                    kShot);
  expect_unread("shot.drag", " beside shot.body.kinematic",
                world + kShot + "drag = { table = \"g7\" }\nbody = { kinematic = true }\n",
                world + kShot + "drag = { table = \"g7\" }\n");
  expect_unread("shot.body.restitution", ": it bounces off nothing", world + kShot + "body = { restitution = 0.3 }\n",
                bounce + kShot + "body = { restitution = 0.3 }\n");
  expect_unread(
      "shot.body.despawn.box_low", " without shot.body.despawn.outside_box",
      world + kShot + "body = { despawn = { box_low = [1, 1, 1] } }\n",
      world + kShot + "body = { despawn = { box_low = [1, 1, 1], box_high = [2, 2, 2], outside_box = true } }\n");
  expect_unread("volley.seed", " without a spread", world + kShot + "[[volley]]\nshot = \"shot-1\"\nseed = 5\n",
                world + kShot + "[[volley]]\nshot = \"shot-1\"\nseed = 5\nspread = { speed = 1 }\n");
  expect_unread("force", ": no shot with motion \"force\"",
                world + kShot + "fidelity = \"arcade\"\n[[force]]\nconstant_force = { force = [1, 0, 0] }\n",
                world + kShot + "[[force]]\nconstant_force = { force = [1, 0, 0] }\n");
  const auto push = [&](const std::string& layers) {
    return world + kShot + "[[force]]\nshots = [\"shot-1\"]\nlayers = " + layers +
           "\nconstant_force = { force = [1, 0, 0] }\n";
  };
  expect_unread("force.layers", ": no shot.body.layers has one of them", push("2"), push("1"));
  const auto spring = [&](const std::string& shots) {
    return world + kShot + kShot + "[[force]]\nshots = " + shots + "\nspring = { other = \"shot-2\", stiffness = 3 }\n";
  };
  expect_unread("force.spring", ": the only shot that it acts on is the one at its other end", spring("[\"shot-2\"]"),
                spring("[\"shot-1\", \"shot-2\"]"));
}

/// Wind of a [[force]] takes a projectile's drag in a world without air, too.
TEST(Unread, drag_in_a_wind_zone) {
  const std::string probe =
      "[world]\n[environment]\natmosphere = \"vacuum\"\n" + kShot + "drag = { coefficient = 0.4 }\n";
  expect_unread("shot.drag.coefficient", ": there is no air", probe,
                probe + "[[force]]\nwind_zone = { velocity = [3, 0, 0], low = [-9, -9, -9], high = [9, 9, 9] }\n");
}

TEST(Unread, things_and_materials_that_nothing_has) {
  const std::string wood = kShot + "[[material]]\nname = \"wood\"\n", slab = "[[shape]]\nname = \"slab\"\nsphere = 1\n";
  expect_unread("material", ": no thing is made of it", wood,
                wood + slab + "[[thing]]\nshape = \"slab\"\nmaterial = \"wood\"\n");
  expect_unread("shape", ": no thing has it", kShot + slab, kShot + slab + "[[thing]]\nshape = \"slab\"\n");
  const std::string thing = slab + "[[thing]]\nshape = \"slab\"\nmaterial = \"wood\"\n";
  const std::string hard = "poncelet = { strength = 1e7 }\n";
  expect_unread(
      "material.poncelet", ": only shots with on_hit \"impact\"", wood + hard + thing,
      kShot + "body = { collision = { on_hit = \"impact\" } }\n[[material]]\nname = \"wood\"\n" + hard + thing);
  const std::string bouncy =
      kShot + "body = { collision = { on_hit = \"bounce\" } }\n" + slab + "[[thing]]\nshape = \"slab\"\n";
  expect_unread("thing.layers", " but that no shot meets it", wood + thing + "layers = 0\n", wood + thing);
  expect_unread("thing.conveyor", " beside thing.sensor = true",
                bouncy + "sensor = true\nconveyor = { velocity = [1, 0, 0] }\n",
                bouncy + "conveyor = { velocity = [1, 0, 0] }\n");
  const auto meets = [&](const std::string& layers) {
    return kShot + "body = { collision = { layers = 2 } }\n[[material]]\nname = \"wood\"\n" + thing +
           "layers = " + layers;
  };
  expect_unread("shot.body.collision.layers", " but that it meets no thing: no thing.layers has one of them",
                meets("1"), meets("6"));
  expect_unread(
      "thing.layers", ": shots meet things of all layers", wood + thing + "layers = 2\n",
      kShot + "body = { collision = { layers = 2 } }\n[[material]]\nname = \"wood\"\n" + thing + "layers = 2\n");
}

TEST(Unread, settings_of_emitters) {
  const auto emitter = [](const std::string& keys) {
    return "[world]\n" + kShot + "[[emitter]]\nshot = \"shot-1\"\n" + keys + "\n";
  };
  expect_unread("emitter.gun", " without emitter.gun.rounds_per_minute", emitter("gun = { magazine = 5 }"),
                emitter("gun = { magazine = 5, rounds_per_minute = 60 }"));
  expect_unread("emitter.from.angle", " beside emitter.from.shape = \"sphere\"",
                emitter("from = { shape = \"sphere\", angle = 0.2 }"),
                emitter("from = { shape = \"cone\", angle = 0.2 }"));
  expect_unread("emitter.flight.noise_size", " without emitter.flight.noise", emitter("flight = { noise_size = 2 }"),
                emitter("flight = { noise_size = 2, noise = 3 }"));
  expect_unread("emitter.trail.time", " without emitter.trail.points", emitter("trail = { time = 2 }"),
                emitter("trail = { time = 2, points = 3 }"));
  expect_unread("emitter.per_metre", ": the emitter does not move", emitter("per_metre = 2"),
                emitter("per_metre = 2\nmotion = { velocity = [1, 0, 0] }"));
  expect_unread("emitter.inherit_velocity", ": the emitter does not move",
                emitter("inherit_velocity = 1\nmotion = { angular_velocity = [0, 1, 0] }"),
                emitter("inherit_velocity = 1\nmotion = { velocity = [1, 0, 0] }"));
  expect_unread("emitter.bursts.interval", " without emitter.bursts.cycles: the burst comes once",
                emitter("bursts = [{ count = 3, interval = 0.2 }]"),
                emitter("bursts = [{ count = 3, interval = 0.2, cycles = 2 }]"));
  expect_unread("emitter.bursts.time",
                ": burst 1 is due at 0.1 s, and the cycle ends before, see emitter.cycle.duration = 0.05 s",
                emitter("bursts = [{ time = 0.1, count = 3 }]\ncycle = { duration = 0.05 }"),
                emitter("bursts = [{ time = 0.1, count = 3 }]\ncycle = { duration = 0.2 }"));
  const std::string rungs =
      "[world]\ndetail = { layers = 1, rungs = [{ fidelity = \"artillery\", within = 9 }, { fidelity = \"game\" }] "
      "}\n" +
      kShot + "fidelity = \"small_arms\"\n";
  expect_unread("shot.fidelity", ": in the world its rung is one of world.detail.rungs", rungs,
                rungs + "body = { layers = 2 }\n");
  expect_unread("world.detail.layers", " but that of all layers: every shot.body.layers has one of them", rungs,
                rungs + "body = { layers = 2 }\n");
  const std::string puffs =
      "per_second = 30\nsub = [{ on = \"death\", emitter = \"puff\" }]\n[[emitter]]\nname = \"puff\"\nshot = "
      "\"shot-1\"\n";
  const std::pair<const char*, const char*> places[] = {
      {"emitter.position", "position = [1, 2, 3]"},
      {"emitter.motion.velocity", "motion = { velocity = [1, 0, 0] }"},
      {"emitter.motion.keys.position", "motion = { keys = [{ position = [0, 1, 0] }, { time = 1 }] }"}};
  const auto sub_on = [&](const std::string& on) {
    return emitter("sub = [{ on = \"" + on +
                   "\", emitter = \"puff\" }]\n[[emitter]]\nname = \"puff\"\nshot = \"shot-1\"\n");
  };
  expect_unread("emitter.sub.on", " but in programs: nothing triggers subs in a run", sub_on("trigger"),
                sub_on("death"));
  for (const auto& [path, own] : places)
    expect_unread(path, ": the emitter fires only as the sub of others", emitter(puffs + "per_second = 0\n" + own),
                  emitter(puffs + "per_second = 5\n" + own));
  expect_unread("emitter.life.fast", " without emitter.life.size_by_speed", emitter("life = { fast = 2 }"),
                emitter("life = { fast = 2, size_by_speed = [[0, 1], [1, 2]] }"));
}

TEST(Unread, inputs_of_a_study_that_nothing_reads) {
  const auto study = [](const std::string& wind) {
    return "[environment.wind]\nvelocity = [0, 0, 1]\n" + kShot + "speed = 50\nfidelity = { wind = \"" + wind +
           "\" }\n[study]\ninputs = [\"environment.wind.velocity.z = 0 m/s +- 1 m/s\"]\n";
  };
  EXPECT_TRUE(says(study("off"), "study.inputs: environment.wind: has no effect: no shot feels wind"));
  EXPECT_FALSE(says(study("constant"), "study.inputs"));
}

/// A list of a table that nothing reads is told once, whatever its length.
TEST(Unread, a_list_is_told_once) {
  const std::string bands =
      "drag = { bands = [{ above = 0, ballistic_coefficient = 100 }, "
      "{ above = 300, ballistic_coefficient = 120 }] }\nfidelity = \"arcade\"\n";
  const auto notes = notes_of(kShot + bands);
  EXPECT_EQ(std::ranges::count_if(notes, [](const std::string& note) { return note.find("bands") != note.npos; }), 1);
}

}  // namespace physim::scenario_unread_test
