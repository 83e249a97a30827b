// Shapes made of shapes, and meshes made of several materials, in scenario files: held to the scene that the library
// makes of the same, and to places known in closed form; what is written back, and what is refused and where.
#include "scenario/compound_support.hpp"
#include "scenario/revise.hpp"
#include "scenario/run_support.hpp"
#include "scenario/slope_scene.hpp"

namespace physim::scenario_compound_scenario_test {

using test::kDegree;

/// A table, named before the shapes that it is made of: a plate, and two legs, of which one is twice as large and lies.
const std::string kTable = R"(physim = 1
[[shape]]
name = "table"
compound = [
  { shape = "plate", position = [0, "1 m", 0] },
  { shape = "leg", position = ["-80 cm", "50 cm", 0] },
  { shape = "leg", position = ["2 m", 0, 0], rotation = { axis = [0, 0, 1], angle = "90 deg" }, scale = 2 },
]
[[shape]]
name = "plate"
box = ["1 m", "10 cm", "50 cm"]
[[shape]]
name = "leg"
cylinder = { radius = "5 cm", half_height = "40 cm" }
[[shape]]
name = "pair"
compound = [{ shape = "leg" }, { shape = "leg", position = [0, 1, 0], rotation = { pitch = "30 deg" } }]
[[thing]]
name = "desk"
shape = "table"
material = "oak"
position = ["10 m", 0, 0]
[[thing]]
name = "far"
shape = "pair"
position = ["20 m", 0, "1 m"]
rotation = { yaw = "30 deg" }
scale = 3
[[shot]]
[world]
)";

/// What kTable says, said to the library.
Scene scene_of_table() {
  Scene scene;
  const MaterialId oak = scene.add_material(materials::oak()).value();
  const ShapeId plate = scene.add_shape(BoxShape{{1, 0.1, 0.5}}).value();
  const ShapeId leg = scene.add_shape(CylinderShape{0.05, 0.4}).value();
  const Quatd lying = quat_from_axis_angle({0, 0, 1}, 90 * kDegree);
  const ShapeId table =
      scene
          .add_shape(CompoundShape{
              {{plate, {.position = {0, 1, 0}}}, {leg, {.position = {-0.8, 0.5, 0}}}, {leg, {{2, 0, 0}, lying, 2}}}})
          .value();
  const Quatd pitched = quat_from_yaw_pitch_roll(0.0, 30 * kDegree, 0.0);
  const ShapeId pair = scene.add_shape(CompoundShape{{{leg, {}}, {leg, {{0, 1, 0}, pitched, 1}}}}).value();
  const auto add = [&scene](const InstanceDef& thing) { EXPECT_TRUE(scene.add(thing)); };
  add({.shape = table, .transform = {.position = {10, 0, 0}}, .material = oak, .user_data = 0, .name = "desk"});
  add({.shape = pair,
       .transform = {{20, 0, 1}, quat_from_yaw_pitch_roll(30 * kDegree, 0.0, 0.0), 3},
       .user_data = 1,
       .name = "far"});
  return scene;
}

TEST(CompoundScenario, is_the_scene_that_the_library_makes_of_it) {
  const Scenario scenario = must(parse_scenario(kTable, "f.toml"));
  const Scene said = scene_of(scenario).value(), made = scene_of_table();
  EXPECT_EQ(said.hash(), made.hash());
  EXPECT_GT(expect_same_hits(said, made), 1000u);
}

TEST(CompoundScenario, has_its_parts_where_they_are_put) {
  const Scene scene = scene_of(parse_scenario(kTable, "f.toml").value()).value();
  const auto top_at = [&scene](double x) { return scene.first_hit({{x, 5, 0}, {x, -5, 0}}); };
  EXPECT_NEAR(top_at(10.5).position.y, 1.1, 1e-12);
  EXPECT_EQ(top_at(10.5).primitive, 0u);
  EXPECT_EQ(scene.material(top_at(10.5).material).name, "oak");
  EXPECT_NEAR(top_at(12.1).position.y, 0.1, 1e-12) << "twice the radius of the leg that lies";
  EXPECT_EQ(top_at(12.1).primitive, 2u);
  const SceneHit end = scene.first_hit({{15, 0, 0}, {11.9, 0, 0}});
  EXPECT_NEAR(end.position.x, 12.8, 1e-12) << "and twice its length, along x";
  const SceneHit foot = scene.first_hit({{9.2, -5, 0}, {9.2, 5, 0}});
  EXPECT_NEAR(foot.position.y, 0.1, 1e-12);
}

TEST(CompoundScenario, is_written_as_it_was_read) {
  const Scenario before = parse_scenario(kTable, "f.toml").value();
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "g.toml"), text);
  EXPECT_EQ(scenario_text(after), text);
  EXPECT_TRUE(say_the_same(after, before)) << text;
  EXPECT_EQ(scene_of(after).value().hash(), scene_of_table().hash());
  EXPECT_EQ(text.find("kind ="), text.npos) << "the parts say it\n" << text;
  EXPECT_NE(text.find("compound = [{ shape = \"leg\" }, {"), text.npos) << text;

  std::vector<std::string> overrides;
  for (const auto& [path, value] : effective_settings(before)) overrides.push_back(path + "=" + value);
  const Scenario set = must(parse_scenario("physim = 1\n[[shot]]\n[world]\n", "g.toml", overrides));
  EXPECT_EQ(effective_settings(set), effective_settings(before));
}

/// Overrides go to the parts of every compound, and leave other shapes as they are.
TEST(CompoundScenario, is_changed_by_overrides) {
  const std::vector<std::string> larger = {"shape.compound.scale=3"};
  const Scenario scenario = must(parse_scenario(kTable, "f.toml", larger));
  for (const ScenarioShape& shape : scenario.shapes)
    for (const ScenarioPart& part : shape.parts) EXPECT_EQ(part.scale, 3) << shape.name;
  const std::string box = "physim = 1\n[[shot]]\n[world]\n[[shape]]\nbox = [1, 1, 1]\n";
  EXPECT_EQ(parse_scenario(box, "f.toml", larger).error().text(),
            "--set shape.compound.scale=3: error: there is no [[shape.compound]] to change; set the list as a whole");
}

// ------------------------------------------------------------------------------------------------- several materials
/// A floor of two triangles, of which the second is of another material; a sail is all of one.
const std::string kFloor = R"(
[[material]]
name = "rubber"
restitution = 0.75
[[material]]
name = "clay"
restitution = 0.25
[[shape]]
name = "floor"
[shape.mesh]
vertices = [[-2, 0, -2], [2, 0, -2], [2, 0, 2], [-2, 0, 2]]
triangles = [[0, 2, 1], [0, 3, 2]]
materials = ["rubber", "clay"]
[[shape]]
name = "sail"
mesh = { vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]], materials = "fir" }
[[thing]]
name = "floor"
shape = "floor"
material = "oak"
[[thing]]
name = "sail"
shape = "sail"
position = [20, 0, 0]
)";

Scene scene_of_floor() {
  Scene scene;
  const auto material = [&scene](const Material& m) { return scene.add_material(m).value(); };
  const MaterialId rubber = material({.name = "rubber", .restitution = 0.75});
  const MaterialId clay = material({.name = "clay", .restitution = 0.25});
  const MaterialId oak = material(materials::oak()), fir = material(materials::fir());
  const MeshShape floor{{{-2, 0, -2}, {2, 0, -2}, {2, 0, 2}, {-2, 0, 2}}, {{{0, 2, 1}}, {{0, 3, 2}}}, {rubber, clay}};
  const MeshShape sail{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}, {fir}};
  const ShapeId shapes[] = {scene.add_shape(floor).value(), scene.add_shape(sail).value()};
  EXPECT_TRUE(scene.add({.shape = shapes[0], .material = oak, .user_data = 0, .name = "floor"}));
  EXPECT_TRUE(scene.add({.shape = shapes[1], .transform = {.position = {20, 0, 0}}, .user_data = 1, .name = "sail"}));
  return scene;
}

TEST(MeshMaterials, are_those_of_the_scene_that_the_library_makes) {
  const Scenario scenario = must(parse_scenario(kHead + kFloor, "f.toml"));
  const Scene said = scene_of(scenario).value(), made = scene_of_floor();
  EXPECT_EQ(said.hash(), made.hash());
  EXPECT_GT(expect_same_hits(said, made), 100u);
}

TEST(MeshMaterials, are_written_as_they_were_read) {
  const Scenario before = parse_scenario(kHead + kFloor, "f.toml").value();
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "g.toml"), text);
  EXPECT_EQ(scenario_text(after), text);
  EXPECT_TRUE(say_the_same(after, before)) << text;
  EXPECT_EQ(scene_of(after).value().hash(), scene_of_floor().hash());
  EXPECT_NE(text.find("materials = [\"rubber\", \"clay\"]"), text.npos) << text;
}

/// A published material that meshes name needs no lines of its own where a file is changed.
TEST(MeshMaterials, are_added_to_a_file_by_their_names) {
  const std::size_t sail = kFloor.find("[[shape]]\nname = \"sail\"");
  const std::string added = kFloor.substr(sail, kFloor.find("[[thing]]") - sail);
  const auto text = must(revised_text(kHead, "f.toml", parse_scenario(kHead + added, "f.toml").value()));
  EXPECT_EQ(text.find("[[material]]"), text.npos) << text;
  EXPECT_NE(text.find("materials = [\"fir\"]"), text.npos) << text;
}

/// A name of nothing is the material of every scene, whatever the thing is made of.
TEST(MeshMaterials, may_be_that_of_every_scene) {
  const std::string text = kHead + kFloor;
  const std::size_t at = text.find("\"clay\"]");
  const Scene scene = scene_of(parse_scenario(std::string(text).replace(at, 6, "\"\""), "f.toml").value()).value();
  EXPECT_EQ(scene.first_hit({{-1, 1, 1}, {-1, -1, 1}}).material, MaterialId{});
}

/// Balls that fall on a triangle each come off it as its own material says.
TEST(MeshMaterials, are_what_a_ball_bounces_off) {
  const std::string balls = R"(
[[shot]]
name = "on rubber"
position = ["1 m", "5 m", "-1 m"]
speed = 0
fidelity = { preset = "game", integrator = "rk4", precision = "float64", drag = "off" }
body = { restitution = 1, friction = 0, collision = { on_hit = "bounce" } }
[[shot]]
name = "on clay"
position = ["-1 m", "5 m", "1 m"]
speed = 0
fidelity = { preset = "game", integrator = "rk4", precision = "float64", drag = "off" }
body = { restitution = 1, friction = 0, collision = { on_hit = "bounce" } }
[world]
duration = "1.2 s"
ground = "none"
)";
  const Scenario scenario = must(parse_scenario(kVacuum + kFloor + balls, "f.toml"));
  WorldRun run = WorldRun::create(scenario).value();
  const std::vector<ThingHit> hits = hits_of(run);
  ASSERT_EQ(hits.size(), 2u);
  for (const ThingHit& hit : hits) {
    const bool on_rubber = hit.position.x > 0;
    EXPECT_EQ(scenario.materials.at(hit.material).name, on_rubber ? "rubber" : "clay");
    const double fall = std::sqrt(2 * 9.80665 * 5);
    EXPECT_NEAR(hit.velocity_after.y, (on_rubber ? 0.75 : 0.25) * fall, 1e-9);
  }
}

/// A run among such shapes goes on from a save as if it had not stopped; where a part or a material is another one,
/// the save is of another scenario.
TEST(CompoundScenario, goes_on_from_a_save_of_its_run) {
  const std::string head = "physim = 1\n[world]\nduration = \"1 s\"\nground = \"none\"\n";
  const std::string shots = R"(
[[shot]]
position = [0, "1 m", 0]
speed = "40 m/s"
fidelity = "game"
body = { restitution = 0.5, collision = { on_hit = "bounce" } }
[[volley]]
shot = "shot-1"
count = 20
rate = "1200 rpm"
spread = { horizontal = "5 deg", vertical = "2 deg" }
)";
  const std::string table = kTable.substr(kTable.find("[[shape]]"), kTable.find("[[shot]]") - kTable.find("[[shape]]"));
  const auto parsed = [&](const std::vector<std::string>& overrides = {}) {
    return parse_scenario(head + kFloor + table + shots, "f.toml", overrides).value();
  };
  WorldRun whole = WorldRun::create(parsed()).value(), first = WorldRun::create(parsed()).value();
  for (std::uint64_t i = 0; i < whole.steps(); ++i) whole.step();
  for (std::uint64_t i = 0; i < first.steps() / 2; ++i) first.step();
  const std::vector<std::byte> save = first.save().value();
  WorldRun rest = must(WorldRun::load(parsed(), save));
  for (std::uint64_t i = first.steps() / 2; i < whole.steps(); ++i) rest.step();
  EXPECT_EQ(rest.world().hash(), whole.world().hash());
  EXPECT_EQ(rest.groups()[0].bounces, whole.groups()[0].bounces);
  EXPECT_GT(whole.groups()[0].hits + whole.groups()[0].bounces, 0u);
  EXPECT_FALSE(WorldRun::load(parsed({"shape.compound.scale=2"}), save));
  Scenario other = parsed();
  std::swap(other.shapes[0].materials[0], other.shapes[0].materials[1]);
  EXPECT_FALSE(WorldRun::load(other, save));
}

// ------------------------------------------------------------------------------------------------------------- refused
struct BadShape {
  std::string text, error;
  friend std::ostream& operator<<(std::ostream& out, const BadShape& bad) { return out << bad.error; }
};

class BadShapeTest : public testing::TestWithParam<BadShape> {};
TEST_P(BadShapeTest, SaysWhereAndWhy) {
  const Result<Scenario> scenario = parse_scenario(kHead + GetParam().text, "f.toml");
  EXPECT_EQ(scenario.ok() ? "no error" : scenario.error().text(), GetParam().error) << GetParam().text;
}

// The text begins on line 4; a compound after a ball stands on line 8.
const std::string kBall = "[[shape]]\nname = \"ball\"\nsphere = 1\n[[shape]]\n";
const std::string kSheet =
    "[[shape]]\nname = \"sheet\"\nmesh = { vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]], ";

INSTANTIATE_TEST_SUITE_P(
    Compounds, BadShapeTest,
    testing::Values(
        BadShape{kBall + "compound = []",
                 "f.toml:8:12: error: shape.compound: 0 entries are too few; allowed are 1 .. 10000"},
        BadShape{"[[shape]]\nkind = \"compound\"",
                 "f.toml:4:1: error: shape: it is no shape; give one of plane, sphere, box, capsule, cylinder, hull, "
                 "mesh, height_field, compound"},
        BadShape{kBall + "compound = [{ position = [0, 1, 0] }]",
                 "f.toml:8:13: error: missing key \"shape\" in [compound]; name of another shape, no plane and no "
                 "compound"},
        BadShape{kBall + "compound = [{ shape = \"ball\" }, { shape = \"bell\" }]",
                 "f.toml:8:43: error: shape.compound.shape: no shape is named \"bell\"; did you mean \"ball\"?"},
        BadShape{kBall + "compound = [{ shape = \"ball\", scael = 2 }]",
                 "f.toml:8:31: error: unknown key \"scael\" in [compound]; did you mean \"scale\"?"},
        BadShape{kBall + "compound = [{ shape = \"ball\", scale = 0 }]",
                 "f.toml:8:39: error: shape.compound.scale: 0 is out of range; must be 1e-09 .. 1e+09"},
        BadShape{kBall + "compound = [{ shape = \"ball\", material = \"oaks\" }]",
                 "f.toml:8:42: error: shape.compound.material: no material is named \"oaks\"; did you mean \"oak\"?"},
        BadShape{
            kBall + "compound = [{ shape = \"ball\" },\n  { shape = \"ball\", material = \"steal\" }]\n"
                    "[[material]]\nname = \"steel\"",
            "f.toml:9:32: error: shape.compound.material: no material is named \"steal\"; did you mean \"steel\"?"},
        BadShape{kBall + "compound = [{ shape = \"ball\", material = 7 }]",
                 "f.toml:8:42: error: shape.compound.material: found a number; expected a text in quotes"},
        BadShape{kBall + "compound = [{ shape = \"ball\", materials = \"oak\" }]",
                 "f.toml:8:31: error: unknown key \"materials\" in [compound]; did you mean \"material\"?"},
        BadShape{kBall + "name = \"a\"\ncompound = [{ shape = \"a\" }]",
                 "f.toml:9:23: error: shape.compound.shape: it names itself; name shapes of other kinds, such as the "
                 "parts of that one"},
        BadShape{kBall + "name = \"a\"\ncompound = [{ shape = \"b\" }]\n[[shape]]\nname = \"b\"\ncompound = [{ shape = "
                         "\"ball\" }]",
                 "f.toml:9:23: error: shape.compound.shape: \"b\" is a compound, too; name shapes of other kinds, such "
                 "as the parts of that one"},
        BadShape{"[[shape]]\nname = \"sea\"\nkind = \"plane\"\n[[shape]]\ncompound = [{ shape = \"sea\" }]",
                 "f.toml:8:23: error: shape.compound.shape: \"sea\" is a plane, which has no end; give it a thing of "
                 "its own"},
        BadShape{kBall + "compound = [{ shape = \"ball\" }]\nbox = [1, 1, 1]",
                 "f.toml:9:1: error: shape: it is of two kinds, compound and box; give one of them"},
        BadShape{kBall + "compound = [{ shape = \"ball\", rotation = { angle = 1, yaw = 1 } }]",
                 "f.toml:8:42: error: shape.compound.rotation: given by an angle and by yaw, pitch and roll; give one "
                 "of them"},
        BadShape{kBall + "name = \"ball\"\ncompound = [{ shape = \"ball\" }]",
                 "f.toml:8:8: error: shape.name: two shapes are named \"ball\""}));

INSTANTIATE_TEST_SUITE_P(
    Materials, BadShapeTest,
    testing::Values(
        BadShape{kSheet + "materials = [\"oak\", \"fir\"] }",
                 "f.toml:6:93: error: shape.mesh.materials: 2 materials for 1 triangles; give one for each triangle, "
                 "or one for all"},
        BadShape{kSheet + "materials = [\"oaks\"] }",
                 "f.toml:6:94: error: shape.mesh.materials: no material is named \"oaks\"; did you mean \"oak\"?"},
        BadShape{kSheet + "materials = \"oaks\" }",
                 "f.toml:6:93: error: shape.mesh.materials: no material is named \"oaks\"; did you mean \"oak\"?"},
        BadShape{kSheet + "materials = [7] }",
                 "f.toml:6:94: error: shape.mesh.materials: found a number; expected a "
                 "text in quotes"}));

/// A scenario that was put together in memory has no lines: the shape and what of it is wrong are named.
TEST(CompoundScenario, is_refused_by_name_where_there_is_no_file) {
  Scenario scenario;
  scenario.shapes.resize(1);
  scenario.shapes[0].name = "a";
  scenario.shapes[0].parts = {{.shape = "b"}};
  const Result<Scene> scene = scene_of(scenario);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().place, "shape \"a\": compound[0].shape");
}

/// Particles come out of triangles, and a compound tells of none.
TEST(CompoundScenario, lets_no_particles_out) {
  const Result<Scenario> scenario = parse_scenario(
      kTable + "[[emitter]]\nshot = \"shot-1\"\nfrom = { shape = \"mesh\", surface = \"table\" }\n", "f.toml");
  ASSERT_FALSE(scenario);
  EXPECT_EQ(scenario.error().message, "emitter.from.surface.of: is neither a mesh nor a height field");
}

}  // namespace physim::scenario_compound_scenario_test
