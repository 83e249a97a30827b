// Settings by path: elements of lists by number, shots by name or number, at the doors of --set and of ScenarioFile.
#include "scenario/by_path.hpp"

#include "cli/program.hpp"
#include "scenario/overrides.hpp"
#include "scenario/scenario.hpp"

namespace physim::scenario_by_path_test {

constexpr const char* kScene = R"(physim = 1
[[shot]]
name = "a.b"
mass = "1 kg"
speed = "50 m/s"
[[shot]]
name = "1"
mass = "2 kg"
speed = "60 m/s"
[[shot.drag.bands]]
above = 0
ballistic_coefficient = 300
[[shot.drag.bands]]
above = 500
ballistic_coefficient = 400
[[shape]]
name = "ball"
sphere = { radius = 1 }
[[thing]]
name = "near"
shape = "ball"
position = [10, 0, 0]
[[thing]]
name = "far"
shape = "ball"
position = [100, 0, 0]
)";

ScenarioFile read(const std::string& text, std::vector<std::string> overrides = {}) {
  const ScenarioFile file = must(ScenarioFile::parse(text, "test.toml", overrides));
  return file;
}

std::string error_of(const std::string& override_text) {
  const std::vector<std::string> one{override_text};
  const Result<ScenarioFile> file = ScenarioFile::parse(kScene, "test.toml", one);
  return file.ok() ? "" : file.error().message;
}

TEST(ByPath, elements_of_lists_go_by_number) {
  ScenarioFile file = read(kScene);
  EXPECT_EQ(*file.get("thing.2.position"), "[\"100 m\", \"0 m\", \"0 m\"]");
  ASSERT_TRUE(file.set("thing.2.position", "[200, 0, 0]"));
  EXPECT_EQ(*file.get("thing.2.position"), "[\"200 m\", \"0 m\", \"0 m\"]");
  EXPECT_EQ(*file.get("thing.1.position"), "[\"10 m\", \"0 m\", \"0 m\"]") << "the other one stays";
  EXPECT_EQ(*file.get("shot.1.drag.bands.2.ballistic_coefficient"), "400 kg/m^2");
  ASSERT_TRUE(file.set("shot.1.drag.bands.1.above", "100 m/s"));
  EXPECT_EQ(*file.get("shot.1.drag.bands.1.above"), "100 m/s");
  EXPECT_EQ(*file.get("shape.sphere.radius"), "1 m") << "the only one needs no number";
}

TEST(ByPath, names_of_shots_come_before_numbers) {
  const ScenarioFile file = read(kScene, {"shot.1.mass=7", "shot.a.b.mass=8"});
  EXPECT_EQ(*file.get("shot.1.mass"), "7 kg") << "the shot of the name 1, which is the second";
  EXPECT_EQ(*file.get("shot.2.mass"), "7 kg");
  EXPECT_EQ(*file.get("shot.a.b.mass"), "8 kg");
}

TEST(ByPath, the_next_number_adds_an_element) {
  ScenarioFile file = read(kScene, {"thing.3.shape=ball", "thing.3.name=third"});
  EXPECT_EQ(*file.get("thing.3.name"), "third");
  const ScenarioFile made = read("physim = 1\n[[shot]]\n",
                                 {"shape.1.name=box", "shape.1.box.half=[1, 1, 1]", "environment.wind.profile.1.at=0",
                                  "environment.wind.profile.1.velocity=[1, 0, 0]", "environment.wind.profile.2.at=10",
                                  "environment.wind.profile.2.velocity=[2, 0, 0]"});
  EXPECT_EQ(*made.get("shape.1.box.half"), "[\"1 m\", \"1 m\", \"1 m\"]");
  EXPECT_EQ(*made.get("environment.wind.profile.2.at"), "10 m");
  EXPECT_EQ(error_of("thing.4.shape=ball"), "there are 2 [[thing]]");
  EXPECT_EQ(error_of("thing.0.shape=ball"), "unknown setting \"thing.0.shape\"");
  EXPECT_NE(error_of("thing.99999999999.shape=ball"), "");
  EXPECT_FALSE(file.get("thing.4.shape").ok());
  EXPECT_FALSE(file.get("thing.shape").ok()) << "of which thing?";
  EXPECT_FALSE(file.set("thing.9.shape", "ball"));
  EXPECT_EQ(*file.get("thing.3.name"), "third") << "an error changes nothing";
}

TEST(ByPath, a_path_that_begins_with_no_table_is_one_of_shots) {
  ScenarioFile file = read("physim = 1\n[[shot]]\n", {"drag.table=g7", "mass=10 g"});
  EXPECT_EQ(*file.get("shot.drag.table"), "g7");
  EXPECT_EQ(*file.get("drag.table"), "g7");
  EXPECT_EQ(*file.get("shot.1.mass"), "0.01 kg");
  EXPECT_EQ(error_of("gibberish=1"), "unknown setting \"gibberish\"");
}

TEST(ByPath, the_command_line_takes_the_same_paths) {
  const testing_cli::File path("scene.toml", kScene);
  const auto ran = testing_cli::physim({"run", path, "--set", "thing.2.shape=bull"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(testing_cli::has(ran.err, "bull")) << ran.err;
  EXPECT_EQ(testing_cli::physim({"run", path, "--set", "thing.2.position=[300, 0, 0]"}).code, 0);
}

TEST(ByPath, an_error_leaves_the_document_as_it_was) {
  Value document = *parse_document("physim = 1\n[[shot]]\nname = \"x\"\n", "f.toml");
  const Place place{std::make_shared<const std::string>("here"), 0, 0};
  EXPECT_FALSE(put_setting(document, "thing.2.name", "x", place));
  EXPECT_FALSE(put_setting(document, "environment.wind.profile.3.at", "1", place));
  EXPECT_FALSE(put_setting(document, "emitter.1.bursts.2.time", "1", place));
  EXPECT_EQ(document.get<Table>()->size(), 2U);
  EXPECT_TRUE(put_setting(document, "emitter.1.bursts.1.time", "1", place));
  EXPECT_EQ(document.get<Table>()->size(), 3U);
}

TEST(ByPath, lists_tell_their_length) {
  Scenario scenario = *parse_scenario(kScene, "test.toml");
  EXPECT_EQ(*length_at(scenario, "thing"), 2U);
  EXPECT_EQ(*length_at(scenario, "shot.1.drag.bands"), 2U);
  EXPECT_EQ(*length_at(scenario, "emitter"), 0U);
  EXPECT_FALSE(length_at(scenario, "shot.1.mass").ok());
}

}  // namespace physim::scenario_by_path_test
