// Things in the way of single flights, on the command line: what `physim run` tells of them, what other commands leave
// aside, and how `physim aim` finds its way.
#include <cmath>

#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_scene_cli_test {

constexpr double kDegree = 3.14159265358979323846 / 180;
const std::string kMortar = PHYSIM_SOURCE_DIR "/scenarios/mortar_over_hill.toml";

TEST(CliScene, RunTellsWhatFlightsHit) {
  const Ran ran = physim({"run", kMortar});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "\n  hit            at 3.9774 s: ")) << ran.out;
  EXPECT_TRUE(has(ran.out, "hit at [s]  what  thing")) << ran.out;
  EXPECT_TRUE(has(ran.out, "12 of 12 met")) << ran.out;
}

TEST(CliScene, RunSaysWhichShotsBeginInsideOfThings) {
  const Folder folder;
  const std::string flight = R"(physim = 1
[[shot]]
name = "b"
mass = "10 g"
diameter = "8 mm"
position = [0, "1 m", 0]
speed = "300 m/s"
fidelity = "game"
body.collision.on_hit = "impact"
[[shape]]
name = "s"
box = ["5 m", "5 m", "5 m"]
[[thing]]
name = "t"
shape = "s"
)";
  const std::string world = flight + "[world]\nduration = \"0.5 s\"\nground = \"none\"\n";
  for (const std::string& text : {flight, world}) {
    const Ran ran = physim({"run", folder.write("inside.toml", text)});
    EXPECT_TRUE(has(ran.err, "warning: shot \"b\" begins inside of the thing \"t\"\n")) << ran.err;
    const Ran outside =
        physim({"run", folder.write("inside.toml", text), "--set", "shot.position=[\"-9 m\", \"1 m\", \"0 m\"]"});
    EXPECT_FALSE(has(outside.err, "begins inside")) << outside.err;
  }
}

/// A ball through a sensor, in a world and as a flight, with an expectation.
std::string sensor_scene(const std::string& quantity, double equals) {
  return "physim = 1\n[environment]\ngravity = \"off\"\natmosphere = \"vacuum\"\n[[shape]]\nname = \"s\"\nbox = [1, 1, "
         "1]\n"
         "[[thing]]\nname = \"zone\"\nshape = \"s\"\nsensor = true\nposition = [10, 0, 0]\n[[shot]]\nname = "
         "\"b\"\nmass = 1\n"
         "diameter = 0.2\nvelocity = [10, 0, 0]\nposition = [0.137, 0, 0]\nfidelity = { preset = \"game\", air = "
         "\"vacuum\" }\n"
         "[[expect]]\nthing = \"zone\"\nquantity = \"" +
         quantity + "\"\nequals = " + std::to_string(equals) + "\nwithin = 0\n";
}

TEST(CliScene, RunCountsPassagesOfSensors) {
  const Folder folder;
  const std::string flight = "[until]\nground = \"off\"\ntime = 2\n",
                    world = "[world]\nduration = 2\nground = \"none\"\n";
  for (const std::string& end : {flight, world}) {
    const Ran one = physim({"run", folder.write("s.toml", sensor_scene("passages", 1) + end)});
    EXPECT_EQ(one.code, 0) << one.out << one.err;
    EXPECT_EQ(one.err, "");
    EXPECT_EQ(physim({"run", folder.write("s.toml", sensor_scene("passages", 0) + end)}).code, 1) << "it can fail";
    const Ran hits = physim({"run", folder.write("s.toml", sensor_scene("hits", 0) + end)});
    EXPECT_TRUE(has(hits.err, "\"passages\" counts ways into it")) << hits.err;
  }
  const std::string file = folder.write("s.toml", sensor_scene("passages", 1) + world), save = folder / "s.sav";
  ASSERT_EQ(physim({"run", file, "--steps", "90", "--save", save}).code, 0);
  EXPECT_EQ(physim({"run", file, "--load", save}).code, 0) << "those before the save are counted, too";
}

/// Things are hit wherever they stand: they lie on no plane, which quantities could lack.
TEST(CliScene, StudyOfImpactsAloneCountsHitsOnThings) {
  const File file("s.toml",
                  "physim = 1\n[environment]\natmosphere = \"vacuum\"\n[[shape]]\nname = \"b\"\nbox = [1, 1, "
                  "1]\n[[thing]]\nname = \"wall\"\n"
                  "shape = \"b\"\nposition = [100, 0, 0]\n[[shot]]\nname = \"s\"\nmass = 1\nspeed = "
                  "800\ngravity_scale = 0\nfidelity = { preset = "
                  "\"simulation\", drag = \"off\", air = \"vacuum\", earth = \"flat\" }\n[until]\nground = "
                  "\"off\"\ntime = 1\n[study]\nshots = 4096\n"
                  "inputs = [\"shot.elevation = 0 mrad +- 5 mrad\", \"shot.azimuth = 0 mrad +- 5 mrad\"]\n"
                  "quantities = [\"impact_speed\", \"obliquity\", \"impact_energy\"]\n");
  const Ran ran = physim({"study", file, "--json", "-"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << ran.out;
  double on_wall = 0;
  for (const auto& figure : json["figures"])
    if (figure["name"] == "hit.wall") on_wall = figure["value"];
  EXPECT_NEAR(on_wall, 0.9151, 0.02) << "(2 Phi(1 m / 0.495 m) - 1)^2 at its front";
  const Ran plane = physim({"study", file, "--set", "study.targets=[\"circle 10 cm\"]"});
  EXPECT_TRUE(
      has(plane.err,
          "--set study.targets=[\"circle 10 cm\"]: error: study.targets: lie on a plane: ask for two lengths first"))
      << plane.err;
}

TEST(CliScene, RunSaysWhichTrianglesAreLeftOut) {
  const File path("sliver.toml", R"(physim = 1
[[shape]]
name = "sheet"
mesh = { vertices = [[0, -9, -9], [0, 9, -9], [0, 0, 9], [0, 9, -9]], triangles = [[0, 1, 2], [0, 1, 3], [1, 1, 2]] }
[[thing]]
name = "target"
shape = "sheet"
position = ["5 m", 0, 0]
[[shot]]
speed = "100 m/s"
position = [0, "1 m", 0]
mass = "1 g"
diameter = "5 mm"
)");
  const Ran ran = physim({"run", path});
  EXPECT_EQ(ran.err, "warning: 2 of 3 triangles of the shape \"sheet\" have no area and are left out\n");
  EXPECT_TRUE(has(ran.out, "target")) << ran.out;
}

TEST(CliScene, RunWritesHits) {
  const Folder folder;
  const auto json = json_of(physim({"run", kMortar, "--json", "-", "--hits", folder / "hits.csv"}));
  ASSERT_EQ(json["hits"].size(), 2u);
  const auto& low = json["hits"][0];
  EXPECT_EQ(low["what"], "low");
  EXPECT_EQ(low["thing"], "hill");
  EXPECT_EQ(low["then"], "stopped");
  EXPECT_NEAR(low["position [m]"][0], 448.499602, 1e-5);
  EXPECT_EQ(json["hits"][1]["material"], "ice");
  EXPECT_EQ(json["shots"][0]["outcome"], "hit");
  EXPECT_EQ(json["shots"][1]["outcome"], "landed");
  EXPECT_EQ(json["settings"]["shot.back.body.collision.on_hit"], "bounce");
  EXPECT_EQ(std::ranges::count(read(folder / "hits.csv"), '\n'), 3);
}

TEST(CliScene, OthersSayThatTheyLeaveThingsAside) {
  const Ran table = physim({"table", kMortar, "--ranges", "900 m"});
  EXPECT_EQ(table.code, 0);
  EXPECT_TRUE(has(table.err, "the things of the scenario are left aside: a range card is of")) << table.err;
  EXPECT_FALSE(has(table.out, "not reached")) << "through the hill: " << table.out;
  const Ran far = physim({"max-range", kMortar});
  EXPECT_EQ(far.code, 0);
  EXPECT_TRUE(has(far.err, "left aside")) << far.err;
  const std::string plank = PHYSIM_SOURCE_DIR "/scenarios/bullet_through_plank.toml";  // in a world
  const Ran in_world = physim({"table", plank}), compared = physim({"compare", plank}),
            study = physim({"study", plank, "--vary", "shot.speed = +- 1 m/s", "--shots", "64"});
  EXPECT_TRUE(has(in_world.err, "things of the scenario are left aside: a range card is of")) << in_world.err;
  EXPECT_TRUE(has(compared.err, "left aside: a comparison is of")) << compared.err;
  EXPECT_TRUE(has(study.err, "left aside: a study of a scenario with a [world] is of")) << study.err;
}

/// The low shot strikes the hill; from some elevation on it goes over the top. Elevations lie evenly within 18 and 40
/// degrees.
TEST(CliScene, StudiesTellHowLikelyEachThingIsHit) {
  const std::vector<std::string> command = {"study",   kMortar, "--vary",    "shot.elevation = 18 deg .. 40 deg",
                                            "--shots", "4096",  "--set",     "study.sampling=sobol",
                                            "--json",  "-",     "--threads", "2"};
  const auto json = json_of(physim(command));
  double hill = -1, wall = -1;
  for (const auto& figure : json["figures"]) {
    if (figure["name"] == "hit.hill") hill = figure["value"];
    if (figure["name"] == "hit.wall") wall = figure["value"];
  }
  // Over the top: 560 tan(e) - g 560^2 / (2 v^2 cos(e)^2) >= 150, a quadratic equation of tan(e).
  const double a = 9.80665 * 560 * 560 / (2 * 120 * 120), root = std::sqrt(560.0 * 560 - 4 * a * (a + 150));
  const double over = std::atan((560 - root) / (2 * a)) / kDegree;
  EXPECT_NEAR(hill, (over - 18) / 22, 2e-3);
  EXPECT_EQ(wall, 0);
  const Ran text = physim({"study", kMortar, "--vary", "shot.elevation = 18 deg .. 40 deg", "--shots", "4096",
                           "--over-inputs", "4", "--target", "low: thing hill"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_TRUE(has(text.out, "hits over an input") && has(text.out, "shot.elevation")) << text.out;
  const Ran unknown = physim({"study", kMortar, "--vary", "shot.speed = +- 3 m/s", "--target", "thing hil"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(has(unknown.err, "\"hil\"") && has(unknown.err, "hill, wall")) << unknown.err;
}

TEST(CliScene, AimTellsBlockedWaysAndByWhat) {
  const Ran ran = physim({"aim", kMortar});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "\"hill\" hides the target")) << ran.out;
  const auto json = json_of(physim({"aim", kMortar, "--json", "-"}));
  EXPECT_TRUE(json["in_reach"]);
  EXPECT_NEAR(json["high"]["elevation [rad]"], 70 * kDegree, 1e-3);
  ASSERT_EQ(json["blocked"].size(), 1u);
  const auto& blocked = json["blocked"][0];
  EXPECT_NEAR(blocked["elevation [rad]"], 20 * kDegree, 2e-3);
  EXPECT_EQ(blocked["hit"]["thing"], "hill");
  // On the face of the hill, and on the parabola of that elevation.
  const double x = blocked["hit"]["position [m]"][0], y = blocked["hit"]["position [m]"][1];
  const double e = blocked["elevation [rad]"], across = 120 * std::cos(e);
  EXPECT_NEAR(y, (x - 300) * 150 / 260, 1e-6);
  EXPECT_NEAR(y, x * std::tan(e) - 9.80665 * x * x / (2 * across * across), 1e-6);
  EXPECT_EQ(json["sight_ends"]["thing"], "hill");
}

TEST(CliScene, AimFindsNothingBehindWhatIsTooHigh) {
  const Ran ran = physim({"aim", kMortar, "--arc", "low"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(has(ran.out, "blocked at elevation 20 deg")) << ran.out;
}

TEST(CliScene, AimsAtAThing) {
  const std::string wall = "300 m, 80 m, 0 m";  // in the face of nothing: before the hill
  const auto at_wall = json_of(physim({"aim", kMortar, "--shot", "back", "--thing", "wall", "--json", "-"}));
  EXPECT_TRUE(at_wall["in_reach"]);
  EXPECT_TRUE(at_wall["blocked"].empty()) << "the thing that is aimed at is in nobody's way";
  EXPECT_EQ(at_wall["target"]["position [m]"][0], -101);
  EXPECT_EQ(at_wall["target"]["position [m]"][1], 50);
  const auto beside = json_of(physim({"aim", kMortar, "--target", wall, "--json", "-"}));
  EXPECT_TRUE(beside["sight_ends"].is_null());
  const Ran unknown = physim({"aim", kMortar, "--thing", "wal"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(has(unknown.err, "--thing: error: there is no thing \"wal\"; its things are \"hill\", \"wall\""))
      << unknown.err;
}

/// A parabola over the slope of the hill: they are 2 m apart at the smaller root of its quadratic, and meet at the end.
TEST(CliScene, DangerSpaceOnTheSlopeOfTheHill) {
  const auto json =
      json_of(physim({"danger-space", kMortar, "--range", "447 m", "--height", "2 m", "--terrain", "--json", "-"}));
  const double e = 20 * kDegree, a = 150.0 / 260, k = 9.80665 / (2 * 120 * 120 * std::cos(e) * std::cos(e));
  const double b = std::tan(e) - a, c = 300 * a;  // x b - k x^2 + c is the height over the slope
  const auto place = [&](double h) { return (b + std::sqrt(b * b + 4 * k * (c - h))) / (2 * k); };
  EXPECT_NEAR(json["from [m]"], place(2), 1e-6);
  EXPECT_NEAR(json["to [m]"], place(0), 1e-5);
  const Ran high = physim({"danger-space", kMortar, "--range", "400 m", "--height", "2 m", "--terrain"});
  EXPECT_EQ(high.code, 2);
  EXPECT_TRUE(has(high.err, "above the ground there; it hits nothing there that is 2 m high")) << high.err;
  const Ran bare = physim({"danger-space", PHYSIM_SOURCE_DIR "/scenarios/308_168gr_g7.toml", "--range", "400 m",
                           "--height", "2 m", "--terrain"});
  EXPECT_EQ(bare.code, 2);
  EXPECT_TRUE(has(bare.err, "--terrain: error: the scenario has nothing to stand on")) << bare.err;
}

}  // namespace physim::testing_cli::cli_scene_cli_test
#endif
