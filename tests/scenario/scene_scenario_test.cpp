// Scenes in scenario files: what is read, what is refused and where, and what is written back.
#include <cstring>

#include "cli/program.hpp"
#include "physim/scenario.hpp"
#include "scenario/gltf_nodes.hpp"
#include "scenario/revise.hpp"
#include "scenario/world_run.hpp"
#include "support.hpp"

namespace physim::scenario_scene_scenario_test {

constexpr double kDegreeOfScene = 3.14159265358979323846 / 180;

/// All that a scene may say, once.
const std::string kEverything = R"(physim = 1
[[material]]
name = "mine"
restitution = 0.25
friction = 0.125
grip_restitution = 0.5
density = "700 kg/m^3"
ricochet = { critical_angle = "10 deg", restitution = 0.5, friction = 0.25 }
poncelet = { strength = "20 MPa", inertia = 1, crater = 2 }
spread = { deflection = "1 deg", yaw = "2 deg" }
[[material]]
name = "oak"
preset = "oak"
friction = 0.75
[[material]]
name = "rock"
young = { s_number = 0.9, hard = true }
[[material]]
name = "armour"
de_marre = { quality = 0.95, plug = 0.5 }
[[material]]
name = "plate"
density = 7850
lambert = 3900
[[material]]
name = "sheet"
ballistic_limit = { speed = "300 m/s", a = 0.875, p = 2.5 }
[[material]]
name = "hard water"
preset = "water"
penetration = "none"
[[material]]
name = "bunker"
concrete = "40 MPa"

[[shape]]
name = "ground"
kind = "plane"
[[shape]]
name = "ball"
sphere = "1 m"
[[shape]]
name = "crate"
box = ["1 m", "2 m", "3 m"]
[[shape]]
name = "pill"
capsule = { radius = "10 cm", half_height = "50 cm" }
[[shape]]
name = "drum"
cylinder = { radius = 0.25, half_height = 0.5 }
[[shape]]
name = "wedge"
hull = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, "1 m"]]
[[shape]]
name = "sail"
mesh = { vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]] }
[[shape]]
name = "hill"
height_field = { columns = 3, rows = 2, spacing_x = "10 m", spacing_z = "20 m", heights = [0, 1, 2, 3, 4, 5] }

[[thing]]
shape = "ground"
[[thing]]
name = "target"
shape = "crate"
material = "oak"
position = ["10 m", 0, "-1 m"]
rotation = { axis = [0, 0, 1], angle = "30 deg" }
scale = 0.5
layers = 6
sensor = true
[[thing]]
name = "cart"
shape = "ball"
rotation = { yaw = "90 deg", pitch = "10 deg", roll = "-20 deg" }
start = "1 s"
velocity = ["1 m/s", 0, 0]
angular_velocity = [0, "30 deg/s", 0]
[[thing]]
name = "lift"
shape = "drum"
layers = 8
curve = "smooth"
keys = [{ time = 0 }, { time = "2 s", position = [0, "4 m", 0], rotation = { yaw = "45 deg" }, velocity = [0, 1, 0] }]
[[shot]]
[world]
)";

const ScenarioThing& thing_of(const Scenario& scenario, const std::string& name) {
  for (const ScenarioThing& thing : scenario.things)
    if (thing.name == name) return thing;
  ADD_FAILURE() << name;
  return scenario.things.front();
}

TEST(SceneScenario, ReadsMaterials) {
  const Scenario s = parse_scenario(kEverything, "f.toml").value();
  ASSERT_EQ(s.materials.size(), 8u);
  const Material mine{.name = "mine",
                      .restitution = 0.25,
                      .friction = 0.125,
                      .grip_restitution = 0.5,
                      .density = 700,
                      .ricochet = {10 * kDegreeOfScene, 0.5, 0.25, false},
                      .penetration = PonceletDef{20e6, 1, 2},
                      .spread = {1 * kDegreeOfScene, 2 * kDegreeOfScene}};
  EXPECT_EQ(s.materials[0], mine);
  Material oak = materials::oak();
  oak.friction = 0.75;
  EXPECT_EQ(s.materials[1], oak);
  EXPECT_EQ(s.materials[2].penetration, PenetrationDef(YoungDef{0.9, true}));
  EXPECT_EQ(s.materials[3].penetration, PenetrationDef(DeMarreDef{0.95, 0.5}));
  EXPECT_EQ(s.materials[4].penetration, PenetrationDef(LambertDef{3900}));
  EXPECT_EQ(s.materials[5].penetration, PenetrationDef(BallisticLimitDef{300, 0.875, 2.5}));
  EXPECT_EQ(s.materials[6].penetration, PenetrationDef(ImpenetrableDef{}));
  EXPECT_EQ(s.materials[6].density, materials::water().density);
  EXPECT_TRUE(s.materials[6].ricochet.liquid);
  EXPECT_EQ(s.materials[7].penetration, materials::concrete(40e6).penetration);
}

TEST(SceneScenario, MakesTheSceneThatItSays) {
  const Scenario s = parse_scenario(kEverything, "f.toml").value();
  const Scene scene = scene_of(s).value();
  EXPECT_EQ(scene.size(), 4u);
  EXPECT_EQ(s.things[0].name, "thing-1");
  // The crate: half edges of 1, 2, 3 m, halved, turned by 30 degrees about z. A ray down its turned x axis meets it
  // half a metre from its middle.
  const double c = std::cos(30 * kDegreeOfScene), sin = std::sin(30 * kDegreeOfScene);
  const Vec3d middle{10, 0, -1}, along{c, sin, 0};
  const SceneHit hit = scene.first_hit({middle - along * 5, middle, 0, 0, 0}, {.layers = 2});
  ASSERT_TRUE(hit);
  EXPECT_LT(length(hit.position - (middle - along * 0.5)), 1e-12);
  EXPECT_EQ(scene.material(hit.material).name, "oak");
  const InstanceDef crate = scene.instance(hit.instance).value();
  EXPECT_EQ(crate.name, "target");
  EXPECT_EQ(crate.user_data, 1u);
  EXPECT_TRUE(crate.sensor);
  // The cart is at its place at 1 s, and moves on at 1 m/s.
  for (const auto& [time, x] : {std::pair{1.0, 0.0}, std::pair{4.0, 3.0}}) {
    const SceneHit cart = scene.first_hit({{x, 10, 0}, {x, -10, 0}, 0, time, 0}, {.layers = 1});
    EXPECT_NEAR(cart.position.y, 1, 1e-12) << time;
  }
  const SceneHit low = scene.first_hit({{0, 9, 0}, {0, 0, 0}, 0, 2, 0}, {.layers = 8});
  EXPECT_NEAR(low.position.y, 4.5, 1e-12);  // the lift, up by 4 m with its half height of 0.5 m
  EXPECT_EQ(scene.instance(low.instance)->name, "lift");
}

TEST(SceneScenario, TurnsByYawPitchAndRollAsLaunchesDo) {
  const Scenario s = parse_scenario(kEverything, "f.toml").value();
  const Quatd q = thing_of(s, "cart").rotation.quaternion();
  EXPECT_EQ(q, quat_from_yaw_pitch_roll(90 * kDegreeOfScene, 10 * kDegreeOfScene, -20 * kDegreeOfScene));
}

TEST(SceneScenario, FindsPublishedMaterialsByTheirName) {
  const std::string text =
      "physim = 1\n[[shot]]\n[world]\n[[shape]]\nname = \"a\"\nsphere = 1\n"
      "[[thing]]\nshape = \"a\"\nmaterial = \"fir\"\n[[thing]]\nshape = \"a\"\nmaterial = \"fir\"\n";
  const Scenario s = parse_scenario(text, "f.toml").value();
  ASSERT_EQ(s.materials.size(), 1u);
  EXPECT_EQ(s.materials[0], materials::fir());
  EXPECT_EQ(parse_scenario(scenario_text(s), "g.toml").value().materials, s.materials);
  const Scenario own = parse_scenario(text + "[[material]]\nname = \"fir\"\nfriction = 0.125\n", "f.toml").value();
  ASSERT_EQ(own.materials.size(), 1u) << "one's own material of that name comes first";
  EXPECT_EQ(own.materials[0].friction, 0.125);
}

TEST(SceneScenario, ReadsBackWhatIsWritten) {
  const Scenario before = parse_scenario(kEverything, "f.toml").value();
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "g.toml"), text);
  EXPECT_EQ(effective_settings(after), effective_settings(before));
  EXPECT_EQ(scenario_text(after), text);
  EXPECT_EQ(after.materials, before.materials);
  EXPECT_NE(text.find("preset = \"oak\"\nfriction = 0.75\n"), text.npos) << text;
  EXPECT_EQ(text.find("preset = \"concrete\""), text.npos) << "neither is the usual concrete\n" << text;
  EXPECT_NE(text.find("kind = \"plane\"\n"), text.npos) << text;
  EXPECT_NE(text.find("sphere = \"1 m\"\n"), text.npos) << "a shape of nothing but defaults\n" << text;
  const Scene scene = scene_of(after).value();
  EXPECT_EQ(scene.size(), 4u);
}

TEST(SceneScenario, SettingsAsOverridesReproduceIt) {
  const Scenario before = parse_scenario(kEverything, "f.toml").value();
  std::vector<std::string> overrides;
  for (const auto& [path, value] : effective_settings(before)) overrides.push_back(path + "=" + value);
  const Scenario after = must(parse_scenario("physim = 1\n[[shot]]\n[world]\n", "g.toml", overrides));
  EXPECT_EQ(effective_settings(after), effective_settings(before));
  EXPECT_EQ(after.materials, before.materials);
}

// ------------------------------------------------------------------------------------------------------------- refused
struct BadScene {
  std::string text, error;
  friend std::ostream& operator<<(std::ostream& out, const BadScene& bad) { return out << bad.error; }
};

class BadSceneTest : public testing::TestWithParam<BadScene> {};
TEST_P(BadSceneTest, SaysWhereAndWhy) {
  const Result<Scenario> scenario = parse_scenario("physim = 1\n[[shot]]\n[world]\n" + GetParam().text, "f.toml");
  EXPECT_EQ(scenario.ok() ? "no error" : scenario.error().text(), GetParam().error) << GetParam().text;
}

// The text begins on line 4.
INSTANTIATE_TEST_SUITE_P(
    Scenes, BadSceneTest,
    testing::Values(
        BadScene{"[[shape]]\nspere = 1",
                 "f.toml:5:1: error: unknown key \"spere\" in [shape]; did you mean \"sphere\"?"},
        BadScene{"[[shape]]\nname = \"a\"",
                 "f.toml:4:1: error: shape: it is no shape; give one of plane, sphere, box, capsule, cylinder, hull, "
                 "mesh, height_field, compound"},
        BadScene{"[[shape]]\nsphere = \"1 kg\"",
                 "f.toml:5:10: error: shape.sphere.radius: \"1 kg\" is a mass; expected a length such as \"7.82 mm\""},
        BadScene{"[[shape]]\nsphere = 0",
                 "f.toml:5:10: error: shape.sphere.radius: 0 is out of range; must be > 0 m; a bare number is in m"},
        BadScene{"[[shape]]\nsphere = 1\nbox = [1, 1, 1]",
                 "f.toml:6:1: error: shape: it is of two kinds, sphere and box; give one of them"},
        BadScene{"[[shape]]\nbox = [1, 1, 1]\nkind = \"sphere\"",
                 "f.toml:6:1: error: shape: it is of two kinds, box and kind; give one of them"},
        BadScene{"[[shape]]\nmesh = { vertices = [[0, 0, 0]], triangles = [[0, 1]] }",
                 "f.toml:5:47: error: shape.mesh.triangles: this is no triangle; expected triangles [[a, b, c], ...] "
                 "of numbers of vertices, from 0"},
        BadScene{"[[shape]]\nhull = [[0, 0, 0], [1, 0]]",
                 "f.toml:5:20: error: shape.hull.points: found 2 components; expected three components [x, y, z]"},
        BadScene{"[[shape]]\nname = \"a\"\nsphere = 1\n[[shape]]\nname = \"a\"\nsphere = 1",
                 "f.toml:8:8: error: shape.name: two shapes are named \"a\""},
        BadScene{"[[thing]]\nshape = \"a\"",
                 "f.toml:5:9: error: thing.shape: no shape is named \"a\"; write a [[shape]]"},
        BadScene{"[[thing]]\nname = \"a\"", "f.toml:4:1: error: missing key \"shape\" in [thing]; name of its shape"},
        BadScene{"[[shape]]\nname = \"crate\"\nsphere = 1\n[[thing]]\nshape = \"crat\"",
                 "f.toml:8:9: error: thing.shape: no shape is named \"crat\"; did you mean \"crate\"?"},
        BadScene{"[[shape]]\nname = \"a\"\nsphere = 1\n[[thing]]\nshape = \"a\"\nmaterial = \"oaks\"",
                 "f.toml:9:12: error: thing.material: no material is named \"oaks\"; did you mean \"oak\"?"},
        BadScene{"[[shape]]\nname = \"a\"\nsphere = 1\n[[thing]]\nshape = \"a\"\nrotation = { angle = 1, yaw = 1 }",
                 "f.toml:9:12: error: thing.rotation: given by an angle and by yaw, pitch and roll; give one of them"},
        BadScene{"[[shape]]\nname = \"a\"\nsphere = 1\n[[thing]]\nshape = \"a\"\nvelocity = [1, 0, 0]\nkeys = [{}]",
                 "f.toml:9:12: error: thing.velocity: given together with keys; the keys say where it is and how it "
                 "moves"},
        BadScene{"[[material]]\npreset = \"oaks\"",
                 "f.toml:5:10: error: material.preset: unknown value \"oaks\"; did you mean \"oak\"?"},
        BadScene{"[[material]]\nrestitution = 1.1",
                 "f.toml:5:15: error: material.restitution: 1.1 is out of range; must be 0 .. 1"},
        BadScene{"[[material]]\npreset = \"oak\"\nconcrete = \"30 MPa\"",
                 "f.toml:6:12: error: material.concrete: given together with preset; give one of them"},
        BadScene{"[[material]]\nyoung = 1\nlambert = 4000",
                 "f.toml:6:1: error: material: it is of two kinds, young and lambert; give one of them"}));

/// Things stand in a world, or in the way of single flights.
TEST(SceneScenario, NeedsNoWorld) {
  for (const std::string list : {"material", "shape"}) {
    const std::string more = list == "shape" ? "sphere = 1\n" : "";
    const auto s = parse_scenario("physim = 1\n[[shot]]\n[[" + list + "]]\n" + more, "f.toml");
    EXPECT_TRUE(s) << s.error().text();
  }
  const auto lone = parse_scenario("physim = 1\n[[shot]]\n[[thing]]\nshape = \"a\"\n", "f.toml");
  EXPECT_EQ(lone.error().text(), "f.toml:4:9: error: thing.shape: no shape is named \"a\"; write a [[shape]]");
}

/// What the scene refuses is told at the table that is wrong.
TEST(BadSceneScenario, TellsWhatTheSceneRefuses) {
  const std::string head = "physim = 1\n[[shot]]\n[world]\n";
  const auto flat = parse_scenario(head + "[[shape]]\nhull = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]\n", "f.toml");
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().place, "f.toml:4:1") << flat.error().text();
  const auto keys = parse_scenario(
      head + "[[shape]]\nname = \"a\"\nsphere = 1\n[[thing]]\nshape = \"a\"\nkeys = [{ time = 1 }, { time = 1 }]\n",
      "f.toml");
  ASSERT_FALSE(keys);
  EXPECT_EQ(keys.error().place, "f.toml:7:1") << keys.error().text();
  EXPECT_NE(keys.error().message.find("keys[1]"), std::string::npos) << keys.error().text();
}

// -------------------------------------------------------------------------------------------------------- mesh files
TEST(MeshFile, IsReadOrTheBuildSaysThatItCannot) {
  const testing_cli::Folder folder;
  // A cube of 2 m about the origin, as OBJ has it: with quadrilaterals, from 1.
  std::ofstream(folder / "cube.obj") << "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\n"
                                        "v -1 1 1\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  std::ofstream(folder / "bad.obj") << "this is no mesh\n";
  const std::string text =
      "physim = 1\n[[shot]]\n[world]\n[[shape]]\nname = \"cube\"\nmesh = \"cube.obj\"\n"
      "[[thing]]\nshape = \"cube\"\nposition = [5, 0, 0]\n";
  const auto scenario = parse_scenario(text, folder / "f.toml");
  if (!reads_mesh_files()) {
    ASSERT_FALSE(scenario);
    EXPECT_NE(scenario.error().message.find("this build reads no meshes from files"), std::string::npos);
    return;
  }
  ASSERT_TRUE(scenario) << scenario.error().text();
  const MeshShape& mesh = std::get<MeshShape>(scenario->shapes[0].shape);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  const Scene scene = scene_of(*scenario).value();
  const auto hits = scene.all_hits({{0, 0.25, 0.125}, {10, 0.25, 0.125}, 0, 0, 0});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].position.x, 4, 1e-12);
  EXPECT_NEAR(hits[1].position.x, 6, 1e-12);
  EXPECT_FALSE(hits[1].entering);
  // The file is said again, not what was in it.
  const std::string written = scenario_text(*scenario);
  EXPECT_NE(written.find("mesh = \"cube.obj\""), written.npos) << written;
  EXPECT_EQ(written.find("vertices"), written.npos);

  EXPECT_EQ(read_mesh_file(folder / "none.obj").error().message, "there is no such file");
  EXPECT_FALSE(read_mesh_file(folder / "bad.obj"));
  const std::string missing = "physim = 1\n[[shot]]\n[world]\n[[shape]]\nmesh = \"none.obj\"\n";
  EXPECT_EQ(parse_scenario(missing, "f.toml").error().text(),
            "f.toml:5:8: error: shape.mesh.file: there is no such file");
}

/// A file of glTF with one wedge between (0, 0, 0), (1, 0, 0), (0, 1, 0) and (0, 0, 1), which two nodes have.
std::string two_wedges(const std::string& node, const std::string& other) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"mesh": 0, )" +
         node + R"(}, {"mesh": 0, )" + other +
         R"(}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"buffers": [{"byteLength": 72, "uri": "data:application/octet-stream;base64,)"
         "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAACAAEAAAABAAMAAAADAAIAAQACAAMA"
         R"("}],
"bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
{"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}]})";
}

TEST(MeshFile, MirroredNodesGiveTheSameHitsMirrored) {
  if (!reads_mesh_files()) GTEST_SKIP() << "this build reads no meshes from files";
  const testing_cli::Folder folder;
  // One, two and three mirrored axes; two of them are a turn. All scales are powers of 2, so that places are exact.
  for (const Vec3d mirror : {Vec3d{-1, 1, 1}, Vec3d{1, -1, 1}, Vec3d{1, 1, -1}, Vec3d{-1, -1, 1}, Vec3d{-1, -1, -1}}) {
    const std::string scale = "\"scale\": [" + std::to_string(2 * mirror.x) + ", " + std::to_string(2 * mirror.y) +
                              ", " + std::to_string(2 * mirror.z) + "]";
    std::ofstream(folder / "pair.gltf") << two_wedges("\"scale\": [2, 2, 2], \"translation\": [8, 0, 0]",
                                                      scale + ", \"translation\": [-8, 0, 0]");
    const auto scenario = must(parse_scenario(
        "physim = 1\n[[shot]]\n[[shape]]\nname = \"pair\"\nmesh = \"pair.gltf\"\n[[thing]]\nshape = \"pair\"\n",
        folder / "f.toml"));
    const Scene scene = scene_of(scenario).value();
    const auto mirrored = [&](const Vec3d& v) { return Vec3d{v.x * mirror.x, v.y * mirror.y, v.z * mirror.z}; };
    const auto cast = [&](const Vec3d& from, const Vec3d& to) { return scene.all_hits({from, to, 0, 0, 0}); };
    for (const auto& [from, to] :
         {std::pair{Vec3d{-1, 0.5, 0.25}, Vec3d{3, 0.5, 0.25}}, std::pair{Vec3d{0.25, 3, 0.5}, Vec3d{0.25, -1, 0.5}},
          std::pair{Vec3d{0.5, 0.25, -1}, Vec3d{0.25, 0.5, 3}}}) {
      const Vec3d there{8, 0, 0}, here{-8, 0, 0};
      const auto plain = cast(from + there, to + there), turned = cast(mirrored(from) + here, mirrored(to) + here);
      ASSERT_EQ(plain.size(), 2U);
      ASSERT_EQ(turned.size(), 2U) << scale;
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(turned[i].entering, plain[i].entering) << scale << ' ' << i;
        EXPECT_EQ(plain[i].entering, i == 0);
        EXPECT_NEAR(turned[i].part, plain[i].part, 1e-15);
        EXPECT_NEAR(length(turned[i].position - here - mirrored(plain[i].position - there)), 0, 1e-14) << scale;
        EXPECT_NEAR(length(turned[i].normal - mirrored(plain[i].normal)), 0, 1e-15) << scale;
      }
    }
  }
}

/// Places of nodes are numbers in text: floats would put them 31 mm off at 500 km.
TEST(MeshFile, NodesOfGltfLieWhereTheFileSays) {
  if (!reads_mesh_files()) GTEST_SKIP() << "this build reads no meshes from files";
  const testing_cli::Folder folder;
  const std::string far = "\"translation\": [500000.0, 0.03, -1000000.01]";
  std::string text = two_wedges("\"children\": [2], " + far, "\"matrix\": [2,0,0,0, 0,2,0,0, 0,0,2,0, 5e5,0.07,3,1]");
  // A third, below the first: a quarter of a turn about y takes its x axis to -z.
  const std::string third =
      "{\"mesh\": 0, \"translation\": [0.011, 0, 0], \"rotation\": [0, 0.7071067811865476, 0, "
      "0.7071067811865476], \"scale\": [1, 3, 1]}],\n\"meshes\"";
  text.replace(text.find("],\n\"meshes\""), 11, ", " + third);
  std::ofstream(folder / "far.gltf") << text;
  // The same as a binary file, whose second chunk is the buffer.
  std::string json = text;
  const std::size_t uri = json.find(", \"uri\"");
  json.erase(uri, json.find('}', uri) - uri);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto bytes_of = [](const auto& number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
  };
  std::string buffer;
  for (const float number : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) buffer += bytes_of(number);
  for (const std::uint16_t corner : {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}) buffer += bytes_of(corner);
  const auto word = [&](std::size_t number) { return bytes_of(static_cast<std::uint32_t>(number)); };
  std::ofstream(folder / "far.glb", std::ios::binary)
      << "glTF" << word(2) << word(28 + json.size() + buffer.size()) << word(json.size()) << "JSON" << json
      << word(buffer.size()) << std::string("BIN\0", 4) << buffer;
  for (const char* name : {"far.gltf", "far.glb"}) {
    const MeshShape mesh = must(read_mesh_file(folder / name));
    ASSERT_EQ(mesh.vertices.size(), 12U) << name;
    EXPECT_EQ(mesh.triangles.size(), 12U) << name;
    const auto nearest = [&](const Vec3d& place) {
      double least = kInfinity;
      for (const Vec3d& v : mesh.vertices) least = std::min(least, length(v - place));
      return least;
    };
    for (const Vec3d& place :
         {Vec3d{500000, 0.03, -1000000.01}, Vec3d{500001, 0.03, -1000000.01}, Vec3d{500000, 0.07, 3},
          Vec3d{500002, 0.07, 3}, Vec3d{500000.011, 0.03, -1000001.01}, Vec3d{500000.011, 3.03, -1000000.01}})
      EXPECT_LT(nearest(place), 1e-9) << name << ": " << place.x << ' ' << place.y << ' ' << place.z;
  }
}

TEST(GltfNodes, AreTreesOfAnyDepth) {
  const auto file = [](const std::string& nodes) { return R"({"asset": {}, "nodes": [)" + nodes + "]}"; };
  constexpr int kNodes = 50'000;
  std::string chain;
  for (int i = 0; i < kNodes; ++i)
    chain += (i > 0 ? ", " : "") + std::string(R"({"translation": [1, 0, 0])") +
             (i + 1 < kNodes ? R"(, "children": [)" + std::to_string(i + 1) + "]}" : "}");
  const auto deep = must(gltf_nodes(file(chain)));
  EXPECT_EQ(deep.nodes.back().origin, (Vec3d{kNodes, 0, 0}));
  EXPECT_EQ(deep.find("7"), &deep.nodes[7]);
  for (const char* name : {"", "x", "7x", "50000", "-1"}) EXPECT_EQ(deep.find(name), nullptr) << name;
  for (const char* wrong : {R"({"children": [1]}, {"children": [0]})", R"({"children": [0]})",
                            R"({"children": [2]}, {"children": [2]}, {})", R"({"children": [9]})",
                            R"({"children": [-1]})", R"({"scale": [1, 2]})", R"({"rotation": "none"})", "7"})
    EXPECT_FALSE(gltf_nodes(file(wrong))) << wrong;
  EXPECT_FALSE(gltf_nodes(file(R"({"extras": )" + std::string(2000, '[') + std::string(2000, ']') + "}")));
  EXPECT_FALSE(gltf_nodes("{\"nodes\": []"));
  EXPECT_FALSE(gltf_nodes("glTF"));
}

TEST(HeightMap, IsReadOrTheBuildSaysThatItCannot) {
  const testing_cli::Folder folder;
  // 3 columns by 2 rows of 16 bits, from black to white in steps of a fifth, as zlib packs them.
  constexpr unsigned char kPicture[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
      0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x02, 0x10, 0x00, 0x00, 0x00, 0x00, 0xe8, 0x8f, 0xe5,
      0x85, 0x00, 0x00, 0x00, 0x16, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x60, 0x60, 0x30, 0x36,
      0x4e, 0x4b, 0x63, 0x98, 0x39, 0xf3, 0xcc, 0x99, 0xff, 0xff, 0x01, 0x1a, 0x27, 0x05, 0xfb, 0x9b,
      0x54, 0x5d, 0x6e, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const std::string bytes(kPicture, kPicture + sizeof kPicture);
  std::ofstream(folder / "hill.png", std::ios::binary) << bytes;
  std::ofstream(folder / "cut.png", std::ios::binary) << bytes.substr(0, 50);
  const std::string text =
      "physim = 1\n[[shot]]\n[world]\n[[shape]]\nname = \"hill\"\n"
      "height_field = { file = \"hill.png\", low = \"100 m\", high = \"150 m\", spacing_x = 10, spacing_z = 20 }\n"
      "[[thing]]\nshape = \"hill\"\n";
  const auto scenario = parse_scenario(text, folder / "f.toml");
  if (!reads_height_maps()) {
    ASSERT_FALSE(scenario);
    EXPECT_NE(scenario.error().message.find("this build reads no heights from pictures"), std::string::npos);
    return;
  }
  ASSERT_TRUE(scenario) << scenario.error().text();
  const Scene scene = scene_of(*scenario).value();
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) {
      const double x = 10.0 * column + 1e-9, z = 20.0 * row + (row == 0 ? 1e-9 : -1e-9);
      const SceneHit hit = scene.first_hit({{x, 200, z}, {x, 0, z}, 0, 0, 0});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit.position.y, 100 + 10 * (3 * row + column), 1e-6) << row << " " << column;
    }
  const std::string written = scenario_text(*scenario);
  EXPECT_NE(written.find("file = \"hill.png\", low = \"100 m\", high = \"150 m\""), written.npos) << written;
  EXPECT_EQ(written.find("heights"), written.npos);
  EXPECT_EQ(read_height_map(folder / "none.png", 0, 1).error().message, "there is no such file");
  EXPECT_FALSE(read_height_map(folder / "cut.png", 0, 1));
  EXPECT_FALSE(read_height_map(folder / "f.toml", 0, 1));
}

TEST(BadSceneScenario, TakesAFileOrTheNumbersThatAreInIt) {
  const std::string head = "physim = 1\n[[shot]]\n[world]\n[[shape]]\n";
  EXPECT_EQ(parse_scenario(head + "height_field = { file = \"a.png\", rows = 3 }\n", "f.toml").error().place,
            "f.toml:5:25");
  EXPECT_EQ(parse_scenario(head + "mesh = { file = \"a.obj\", triangles = [[0, 1, 2]] }\n", "f.toml").error().place,
            "f.toml:5:17");
}

}  // namespace physim::scenario_scene_scenario_test
