// Materials of the parts of a compound in scenario files: held to the scene that the library makes of the same, and to
// places that are known; what is written back, and what a run tells.
#include "scenario/compound_support.hpp"
#include "scenario/revise.hpp"
#include "scenario/run_support.hpp"
#include "scenario/slope_scene.hpp"

namespace physim::scenario_part_materials_test {

using test::kDegree;

/// A wall of the thing's oak with a door of steel in it, named first, and a painted sheet that keeps its own.
const std::string kHouse = R"(
[[material]]
name = "steel"
ballistic_limit = { speed = "1200 m/s" }
[[shape]]
name = "house"
compound = [
  { shape = "door", material = "steel", position = [0, 1, 0] },
  { shape = "wall", position = [0, "1.5 m", 0] },
  { shape = "sheet", material = "steel", position = ["1 m", 0, 0], rotation = { yaw = "90 deg" }, scale = 2 },
  { shape = "door", material = "fir", position = [0, 1, 10] },
]
[[shape]]
name = "wall"
box = ["10 cm", "1.5 m", "4 m"]
[[shape]]
name = "door"
box = ["10 cm", "1 m", "50 cm"]
[[shape]]
name = "sheet"
mesh = { vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]], materials = "fir" }
[[thing]]
name = "house"
shape = "house"
material = "oak"
position = ["20 m", 0, 0]
rotation = { yaw = "10 deg" }
scale = 1.5
)";

Scene scene_of_house() {
  Scene scene;
  const MaterialId steel =
      scene.add_material({.name = "steel", .penetration = BallisticLimitDef{.speed = 1200}}).value();
  const MaterialId oak = scene.add_material(materials::oak()).value(),
                   fir = scene.add_material(materials::fir()).value();
  const ShapeId wall = scene.add_shape(BoxShape{{0.1, 1.5, 4}}).value();
  const ShapeId door = scene.add_shape(BoxShape{{0.1, 1, 0.5}}).value();
  const ShapeId sheet = scene.add_shape(MeshShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}, {fir}}).value();
  const Quatd turned = quat_from_yaw_pitch_roll(90 * kDegree, 0.0, 0.0);
  const ShapeId house = scene
                            .add_shape(CompoundShape{{{door, {.position = {0, 1, 0}}, steel},
                                                      {wall, {.position = {0, 1.5, 0}}, {}},
                                                      {sheet, {{1, 0, 0}, turned, 2}, steel},
                                                      {door, {.position = {0, 1, 10}}, fir}}})
                            .value();
  EXPECT_TRUE(scene.add({.shape = house,
                         .transform = {{20, 0, 0}, quat_from_yaw_pitch_roll(10 * kDegree, 0.0, 0.0), 1.5},
                         .material = oak,
                         .user_data = 0,
                         .name = "house"}));
  return scene;
}

TEST(PartMaterials, are_those_of_the_scene_that_the_library_makes) {
  const Scenario scenario = must(parse_scenario(kHead + kHouse, "f.toml"));
  const Scene said = scene_of(scenario).value(), made = scene_of_house();
  EXPECT_EQ(said.hash(), made.hash());
  EXPECT_GT(expect_same_hits(said, made), 1000u);
  const auto material_at = [&](double y, double z) {
    const double yaw = 10 * kDegree;
    const Vec3d from = Vec3d{20, 0, 0} + rotate(quat_from_yaw_pitch_roll(yaw, 0.0, 0.0), Vec3d{-5, y, z}) * 1.5;
    const Vec3d to = Vec3d{20, 0, 0} + rotate(quat_from_yaw_pitch_roll(yaw, 0.0, 0.0), Vec3d{5, y, z}) * 1.5;
    return said.material(said.first_hit({from, to}).material).name;
  };
  EXPECT_EQ(material_at(1, 0.2), "steel") << "wall and door share their faces";
  EXPECT_EQ(material_at(2.5, 0.2), "oak");
  EXPECT_EQ(material_at(1, 2), "oak");
  EXPECT_EQ(material_at(1, 10), "fir");
}

TEST(PartMaterials, are_written_as_they_were_read) {
  const Scenario before = parse_scenario(kHead + kHouse, "f.toml").value();
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "g.toml"), text);
  EXPECT_EQ(scenario_text(after), text);
  EXPECT_TRUE(say_the_same(after, before)) << text;
  EXPECT_EQ(scene_of(after).value().hash(), scene_of_house().hash());
  EXPECT_NE(text.find("{ shape = \"door\", material = \"fir\", position = "), text.npos) << text;

  std::vector<std::string> overrides;
  for (const auto& [path, value] : effective_settings(before)) overrides.push_back(path + "=" + value);
  const Scenario set = must(parse_scenario("physim = 1\n[[shot]]\n[world]\n", "g.toml", overrides));
  EXPECT_EQ(effective_settings(set), effective_settings(before));
}

/// Changed in C++, written into the file, read again: by itself, and through the file that was.
TEST(PartMaterials, are_edited_and_come_back) {
  const std::string file = kHead + kHouse;
  Scenario changed = parse_scenario(file, "f.toml").value();
  changed.shapes[0].parts[1].material = "steel";
  changed.shapes[0].parts[0].material.clear();
  changed.shapes[0].parts[3].material = "oak";
  const std::uint64_t hash = scene_of(changed).value().hash();
  EXPECT_NE(hash, scene_of_house().hash());
  const auto revised = must(revised_text(file, "f.toml", changed));
  for (const std::string& text : {revised, scenario_text(changed)}) {
    const Scenario after = must(parse_scenario(text, "f.toml"), text);
    EXPECT_EQ(after.shapes[0].parts[0].material, "");
    EXPECT_EQ(after.shapes[0].parts[1].material, "steel");
    EXPECT_EQ(after.shapes[0].parts[3].material, "oak");
  }
  EXPECT_EQ(scene_of(parse_scenario(scenario_text(changed), "f.toml").value()).value().hash(), hash);
}

/// A published material that parts name needs no lines of its own.
TEST(PartMaterials, that_are_published_need_only_their_names) {
  const std::string box = "[[shape]]\nname = \"b\"\nbox = [1, 1, 1]\n";
  const std::string added = box + "[[shape]]\ncompound = [{ shape = \"b\", material = \"rolled_armour\" }]\n";
  const Scenario scenario = parse_scenario(kHead + added, "f.toml").value();
  ASSERT_EQ(scenario.materials.size(), 1u);
  EXPECT_EQ(scenario.materials[0].density, materials::rolled_armour().density);
  const auto text = must(revised_text(kHead, "f.toml", scenario));
  EXPECT_EQ(text.find("[[material]]"), text.npos) << text;
  EXPECT_NE(text.find("material = \"rolled_armour\""), text.npos) << text;
}

/// The table of hits names the part's, and a run saved on the way is of this scenario alone.
TEST(PartMaterials, are_what_a_run_tells) {
  const std::string shots = R"(
[[shot]]
name = "door"
position = [0, "1.5 m", 0]
azimuth = "0.2 deg"
speed = "800 m/s"
body = { collision = { on_hit = "impact" } }
fidelity = { preset = "game", drag = "off", precision = "float64" }
[[shot]]
name = "wall"
position = [0, "1.5 m", "2 m"]
speed = "800 m/s"
body = { collision = { on_hit = "impact" } }
fidelity = { preset = "game", drag = "off", precision = "float64" }
[world]
duration = "0.2 s"
ground = "none"
)";
  const Scenario scenario = must(parse_scenario(kVacuum + kHouse + shots, "f.toml"));
  WorldRun run = WorldRun::create(scenario).value();
  const std::vector<ThingHit> hits = hits_of(run);
  ASSERT_GE(hits.size(), 2u);
  for (const ThingHit& hit : hits) {
    const bool is_door = std::abs(hit.position.z) < 0.7;
    EXPECT_EQ(scenario.materials.at(hit.material).name, is_door ? "steel" : "oak");
    EXPECT_EQ(hit.outcome, is_door ? EventKind::stopped : hit.outcome);
  }
  Scenario other = scenario;
  other.shapes[0].parts[3].material = "oak";
  EXPECT_FALSE(WorldRun::load(other, run.save().value()));
}

/// Part behind part is met at one time: each hit is told with what became of it, not of another one.
TEST(PartMaterials, that_are_met_at_one_time_each_have_their_outcome) {
  const std::string core = R"(
[[material]]
name = "wood"
ballistic_limit = { speed = "300 m/s" }
[[material]]
name = "steel"
ballistic_limit = { speed = "500 m/s" }
[[material]]
name = "armour"
ballistic_limit = { speed = "900 m/s" }
[[shape]]
name = "block"
box = ["5 cm", 1, 1]
[[shape]]
name = "all"
compound = [
  { shape = "block", material = "steel", position = ["10 cm", 0, 0] },
  { shape = "block", material = "wood", position = ["20 cm", 0, 0] },
  { shape = "block", material = "wood" },
  { shape = "block", material = "armour", position = ["30 cm", 0, 0] },
]
[[thing]]
name = "all"
shape = "all"
position = ["50 m", 0, 0]
[[shot]]
mass = "10 g"
diameter = "8 mm"
speed = "780 m/s"
body = { gravity_scale = 0, collision = { on_hit = "impact" } }
fidelity = { preset = "game", drag = "off", precision = "float64" }
[world]
duration = "0.1 s"
ground = "none"
)";
  WorldRun run = WorldRun::create(parse_scenario(kVacuum + core, "f.toml").value()).value();
  const std::vector<ThingHit> hits = hits_of(run);
  ASSERT_EQ(hits.size(), 4u);
  const std::uint32_t parts[] = {2, 0, 1, 3};
  const double limits[] = {300, 500, 300};
  double speed = 780;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(hits[i].primitive, parts[i]);
    EXPECT_NEAR(hits[i].velocity.x, speed, 1e-9) << i;
    EXPECT_EQ(hits[i].outcome, i < 3 ? EventKind::penetrated : EventKind::stopped) << i;
    if (i < 3) speed = std::sqrt(speed * speed - limits[i] * limits[i]);
    EXPECT_NEAR(hits[i].velocity_after.x, i < 3 ? speed : 0, 1e-9) << i;
    EXPECT_NEAR(hits[i].depth, i < 3 ? 0.1 : 0.1 * speed * speed / (900.0 * 900), 1e-9) << i;
  }
}

}  // namespace physim::scenario_part_materials_test
