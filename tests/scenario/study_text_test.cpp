// Studies as scenarios write them.
#include <filesystem>
#include <fstream>

#include "must.hpp"
#include "scenario/scenario.hpp"

namespace physim::scenario_study_text_test {

Distribution distribution_of(const char* text) { return must(parse_study_input(text)).distribution; }

std::string refusal(const char* text) {
  const auto input = parse_study_input(text);
  return input ? "" : input.error().text();
}

TEST(StudyText, distributions) {
  EXPECT_EQ(distribution_of("shot.speed = 800 m/s +- 3 m/s"), Distribution(NormalDistribution{800, 3}));
  EXPECT_EQ(distribution_of("shot.speed = 1000 ft/s +- 10 ft/s"), Distribution(NormalDistribution{304.8, 3.048}));
  EXPECT_EQ(distribution_of("environment.wind.velocity.z = -2 m/s .. 3 m/s"), Distribution(UniformDistribution{-2, 3}));
  EXPECT_EQ(distribution_of("shot.mass = 0.01 kg .. 0.013 kg peak 0.012 kg"),
            Distribution(TriangularDistribution{0.01, 0.012, 0.013}));
  EXPECT_EQ(distribution_of("shot.drag.form_factor = lognormal 1 +- 0.05"),
            Distribution(LognormalDistribution{1, 0.05}));
  EXPECT_EQ(distribution_of("shot.speed = 1 m/s +- 2 m/s within 0 m/s .. 4 m/s"),
            Distribution(TruncatedNormalDistribution{1, 2, 0, 4}));
  EXPECT_EQ(distribution_of("shot.speed = 1 m/s +- 2 m/s within 0 m/s .."),
            Distribution(TruncatedNormalDistribution{1, 2, 0, kInfinity}));
  EXPECT_EQ(distribution_of("shot.mass = one of 1 kg, 2 kg, 4 kg"), Distribution(DiscreteDistribution{{1, 2, 4}, {}}));
}

TEST(StudyText, what_is_added_and_how_often) {
  const auto added = must(parse_study_input("shot.elevation = +- 1 mrad per occasion"));
  EXPECT_TRUE(added.added);
  EXPECT_EQ(added.drawn_for, DrawnFor::occasion);
  EXPECT_EQ(added.distribution, Distribution(NormalDistribution{0, 1e-3}));
  const auto between = must(parse_study_input("shot.speed = added -1 m/s .. 1 m/s"));
  EXPECT_TRUE(between.added);
  EXPECT_FALSE(parse_study_input("shot.speed = -1 m/s .. 1 m/s")->added);
}

/// 15 degC are 288.15 K, but 3 degC more are 3 K more.
TEST(StudyText, differences_of_temperature_have_no_zero) {
  const char* path = "environment.atmosphere.temperature = ";
  const auto temperature = [&](const char* text) { return distribution_of((std::string(path) + text).c_str()); };
  EXPECT_EQ(temperature("15 degC +- 3 K"), Distribution(NormalDistribution{288.15, 3}));
  const auto celsius = std::get<NormalDistribution>(temperature("15 degC +- 3 degC"));
  EXPECT_NEAR(celsius.deviation, 3, 1e-12);
  const auto added = std::get<UniformDistribution>(temperature("added -9 degF .. 9 degF"));
  EXPECT_NEAR(added.low, -5, 1e-12);
  EXPECT_NEAR(added.high, 5, 1e-12);
}

TEST(StudyText, bad_texts_are_refused_with_how_to_write_them) {
  EXPECT_NE(refusal("shot.speed").find("names no number"), std::string::npos);
  EXPECT_NE(refusal("shot.sped = 800 m/s +- 3 m/s").find("did you mean \"shot.speed\""), std::string::npos);
  EXPECT_NE(refusal("shot.speed = 800 m/s").find("no distribution"), std::string::npos);
  EXPECT_NE(refusal("shot.speed = 800 kg +- 3 m/s").find("kg"), std::string::npos);
  EXPECT_NE(refusal("shot.speed = lognormal 3 m/s").find("no distribution"), std::string::npos);
  EXPECT_NE(refusal("shot.speed = 1 m/s +- 1 m/s within 3 m/s").find("no distribution"), std::string::npos);
  EXPECT_FALSE(parse_study_target("square 1 m"));
  EXPECT_FALSE(parse_study_target("circle 1 kg"));
  EXPECT_FALSE(parse_study_target("rectangle 1 m"));
  EXPECT_FALSE(parse_study_target("circle 1 m at 3 m"));
}

/// "45 x 75 cm" would be 45 m wide.
TEST(StudyText, all_numbers_have_a_unit_or_none) {
  const auto target = parse_study_target("rectangle 45 x 75 cm");
  ASSERT_FALSE(target);
  EXPECT_NE(target.error().text().find("\"45\" has no unit, and \"75 cm\" has one"), std::string::npos);
  EXPECT_TRUE(parse_study_target("rectangle 0.45 x 0.75"));
  EXPECT_TRUE(parse_study_target("circle 10 cm at 0, 0"));
  EXPECT_NE(refusal("shot.speed = 2650 +- 10 ft/s").find("give all of them a unit"), std::string::npos);
  EXPECT_NE(refusal("environment.wind.velocity.z = -2 .. 2 mph").find("has no unit"), std::string::npos);
  EXPECT_EQ(distribution_of("shot.speed = 800 +- 3"), Distribution(NormalDistribution{800, 3}));
  EXPECT_EQ(distribution_of("environment.wind.velocity.z = 0 .. 1 m/s"), Distribution(UniformDistribution{0, 1}));
}

TEST(StudyText, targets) {
  const auto circle = must(parse_study_target("plate: circle 10 cm at 1 m, -2 m"));
  EXPECT_EQ(circle, (StudyTarget{"plate", CircleTarget{{1, -2}, 0.1}}));
  const auto rectangle = must(parse_study_target("rectangle 30 cm x 50 cm"));
  EXPECT_EQ(rectangle, (StudyTarget{"", RectangleTarget{{}, 0.3, 0.5}}));
  const auto polygon = must(parse_study_target("polygon 0 m, 0 m; 1 m, 0 m; 0 m, 1 m at 5 m, 0 m"));
  EXPECT_EQ(polygon, (StudyTarget{"", PolygonTarget{{{5, 0}, {6, 0}, {5, 1}}}}));
}

constexpr const char* kScenario = R"(
physim = 1
[[shot]]
speed = "30 m/s"
elevation = "30 deg"
[study]
inputs = ["shot.speed = +- 1 m/s", "shot.elevation = 30 deg +- 1 deg", "shot.azimuth = +- 1 deg",
          "shot.mass = 1 kg .. 2 kg"]
correlated = ["shot.speed with shot.mass = 0.5", "shot.mass with shot.azimuth = -0.25"]
targets = ["circle 1 m"]
aim = "1 m, 80 m"
shots = 5000
)";

TEST(StudyText, of_a_scenario) {
  const auto scenario = must(parse_scenario(kScenario, "test.toml"));
  const auto study = must(study_of(scenario, scenario.shots[0]));
  ASSERT_EQ(study.correlated.size(), 1U) << "pairs that share an input";
  EXPECT_EQ(study.correlated[0].inputs, (std::vector<std::size_t>{0, 3, 2}));
  EXPECT_EQ(study.correlated[0].matrix, (std::vector<double>{1, 0.5, 0, 0.5, 1, -0.25, 0, -0.25, 1}));
  EXPECT_EQ(study.targets[0].name, "target-1");
  EXPECT_EQ(study.aim, (PlanePoint{1, 80}));
  EXPECT_EQ(study.shots, 5000U);
  const auto again = must(parse_scenario(scenario_text(scenario), "again.toml"));
  EXPECT_EQ(again.study.inputs, scenario.study.inputs);
  EXPECT_EQ(again.study.aim, scenario.study.aim);

  Scenario bad = scenario;
  bad.study.correlated = {"shot.speed with shot.diameter = 0.5"};
  EXPECT_NE(study_of(bad, bad.shots[0]).error().text().find("shot.diameter is none"), std::string::npos);
  bad.study.correlated = {"shot.speed with shot.mass = 0.5", "shot.mass with shot.speed = -0.5"};
  EXPECT_NE(study_of(bad, bad.shots[0]).error().text().find("a correlation already"), std::string::npos);
  bad = scenario;
  bad.study.inputs = {"shot.speed = fast"};
  EXPECT_NE(study_of(bad, bad.shots[0]).error().text().find("study.inputs[0]"), std::string::npos);
  bad = scenario;
  bad.study.aim = "1 m";
  EXPECT_NE(study_of(bad, bad.shots[0]).error().text().find("study.aim"), std::string::npos);
}

/// Every path of a study is a setting, or a component or a factor of one; but a wind by compass is none of a place.
TEST(StudyText, paths_are_settings) {
  for (const StudyPath& path : study_paths()) {
    if (path.path == "environment.wind.speed" || path.path == "environment.wind.from") continue;
    std::string own = path.path;
    if (const std::size_t point = own.find(".N"); point != own.npos) own.erase(point, 2);
    const std::string whole = own.substr(0, own.size() - 2);
    const std::string list = path.path.substr(0, path.path.find(".N"));  // of points [place, number]
    const bool is_setting = std::ranges::any_of(settings(), [&](const Setting& setting) {
      return setting.path == own || setting.path == whole || setting.path == list;
    });
    EXPECT_TRUE(is_setting) << path.path;
  }
}

// --------------------------------------------------------------------------------- distributions in the place of
// numbers
constexpr const char* kHead = "physim = 1\n[[shot]]\nname = \"a\"\n";

Result<Study> study_of_text(const std::string& text, std::size_t shot = 0,
                            std::span<const std::string> overrides = {}) {
  const auto scenario = parse_scenario(text, "test.toml", overrides);
  if (!scenario) return scenario.error();
  return study_of(*scenario, scenario->shots[shot]);
}

TEST(StudyText, all_wrong_targets_are_told) {
  const auto scenario = parse_scenario(
      "physim = 1\n[[shot]]\nname = \"a\"\n[study]\ntargets = [\"circle 10 cm\", \"rect 1 cm\", \"circle 5 cm\", "
      "\"rectangle 10 cm\"]\n",
      "f.toml");
  ASSERT_FALSE(scenario);
  const std::string text = scenario.error().text();
  EXPECT_TRUE(text.starts_with("f.toml:5:28: error: study.targets[1]: \"rect 1 cm\" is no target")) << text;
  EXPECT_NE(text.find("\nf.toml:5:56: error: study.targets[3]: \"rectangle 10 cm\" is no target"), std::string::npos)
      << text;
}

TEST(StudyInPlace, a_number_is_a_distribution_and_its_mean_is_flown) {
  const std::string text = std::string(kHead) +
                           "speed = \"800 m/s +- 3 m/s\"\nposition = [0, \"1 m .. 3 m\", 0]\n"
                           "[environment]\nwind = { velocity = [0, 0, \"lognormal 2 m/s +- 1 m/s per occasion\"] }\n"
                           "[study]\nrounds = 16\ninputs = [\"shot.azimuth = +- 1 deg\"]\n";
  const auto scenario = must(parse_scenario(text, "test.toml"));
  EXPECT_EQ(scenario.shots[0].launch.speed, 800);
  EXPECT_EQ(scenario.shots[0].launch.position.y, 2);
  EXPECT_EQ(scenario.environment.wind.velocity.z, 2);
  const auto study = must(study_of(scenario, scenario.shots[0]));
  ASSERT_EQ(study.inputs.size(), 4U);
  EXPECT_EQ(study.inputs[0], (StudyInput{"shot.speed", NormalDistribution{800, 3}}));
  EXPECT_EQ(study.inputs[1], (StudyInput{"shot.position.y", UniformDistribution{1, 3}}));
  EXPECT_EQ(study.inputs[2],
            (StudyInput{"environment.wind.velocity.z", LognormalDistribution{2, 1}, DrawnFor::occasion}));
  EXPECT_EQ(study.inputs[3].path, "shot.azimuth") << "those of [study] stand behind";
  const auto again = must(parse_scenario(scenario_text(scenario), "again.toml"));
  EXPECT_EQ(again.study.inputs, scenario.study.inputs);
  EXPECT_EQ(again.shots[0].launch.speed, 800);
}

TEST(StudyInPlace, tables_and_overrides_say_it_too) {
  const auto distribution = [](const std::string& value) {
    const std::string override = "shot.speed=" + value;
    const auto study = study_of_text(kHead, 0, {&override, 1});
    EXPECT_TRUE(study) << value << ": " << study.error().text();
    return study && study->inputs.size() == 1 ? study->inputs[0].distribution : Distribution{};
  };
  EXPECT_EQ(distribution("800 m/s +- 3 m/s"), Distribution(NormalDistribution{800, 3}));
  EXPECT_EQ(distribution("{ mean = \"800 m/s\", deviation = \"3 m/s\" }"), Distribution(NormalDistribution{800, 3}));
  EXPECT_EQ(distribution("{ mean = 800, deviation = 3, low = 790.0 }"),
            Distribution(TruncatedNormalDistribution{800, 3, 790, kInfinity}));
  EXPECT_EQ(distribution("{ low = 790, high = 810, peak = 805 }"), Distribution(TriangularDistribution{790, 805, 810}));
  EXPECT_EQ(distribution("{ low = \"1 m/s\", high = \"2 m/s\" }"), Distribution(UniformDistribution{1, 2}));
  EXPECT_EQ(distribution("{ lognormal = true, mean = 800, deviation = 3 }"),
            Distribution(LognormalDistribution{800, 3}));
  EXPECT_EQ(distribution("{ values = [\"799 m/s\", \"801 m/s\"] }"),
            Distribution(DiscreteDistribution{{799, 801}, {}}));
}

TEST(StudyInPlace, each_of_several_shots_has_its_own) {
  const std::string text =
      std::string(kHead) + "speed = \"800 m/s +- 3 m/s\"\n[[shot]]\nname = \"b.c\"\nspeed = \"700 m/s .. 710 m/s\"\n";
  const auto a = study_of_text(text, 0), b = study_of_text(text, 1);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->inputs, (std::vector<StudyInput>{{"shot.speed", NormalDistribution{800, 3}}}));
  EXPECT_EQ(b->inputs, (std::vector<StudyInput>{{"shot.speed", UniformDistribution{700, 710}}}));
}

TEST(StudyInPlace, what_is_wrong_is_told_where_it_stands) {
  const auto refusal_of = [](const std::string& speed) {
    const auto study = study_of_text(std::string(kHead) + "speed = " + speed + "\n");
    return study ? std::string("none") : study.error().text();
  };
  const auto tells = [&](const char* speed, const char* what) {
    const std::string said = refusal_of(speed);
    EXPECT_NE(said.find("test.toml:4:9: error: shot.speed: "), std::string::npos) << said;
    EXPECT_NE(said.find(what), std::string::npos) << said;
  };
  tells("\"+- 3 m/s\"", "has no number of its own to be about");
  tells("\"800 m/s +- 3\"", "give all of them a unit");
  tells("\"800 m/s +- -3 m/s\"", "must be a positive number");
  tells("\"800 m/s +- 3 kg\"", "kg");
  tells("{ mean = 800 }", "the table is no distribution");
  EXPECT_NE(refusal_of("{ mean = 800, deviaton = 3 }").find("did you mean \"deviation\""), std::string::npos);
  const auto says = [&](const char* speed, const char* what) {
    EXPECT_NE(refusal_of(speed).find(what), std::string::npos) << refusal_of(speed);
  };
  says("{ mean = 800, deviation = 3, lognormal = 1 }", "shot.speed.lognormal: must be true or false");
  says("{ mean = 800, deviation = 3, per_occasion = \"yes\" }", "must be true or false");
  says("{ mean = 800, deviation = 3, peak = 1 }", "\"peak\" says nothing beside \"mean\"");
  says("{ values = [1, 2], low = 0 }", "\"low\" says nothing beside \"values\"");
  says("{ low = 1, high = 2, lognormal = true }", "\"lognormal\" says nothing beside \"low\"");
}

// ---------------------------------------------------------------------------------------------------------- CSV
// columns
TEST(StudyColumn, is_read_from_the_folder_of_the_scenario) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "physim-study-column";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "speeds.csv") << "# a chronograph\nshot, speed [ft/s]\n1, 2640\n2, 2650\n\n3,\n4, 2655\n";
  const std::string file = (folder / "rifle.toml").string();
  const auto study_with = [&](const std::string& input) -> Result<Study> {
    const auto scenario = parse_scenario(std::string(kHead) + "[study]\ninputs = [\"" + input + "\"]\n", file);
    return scenario ? study_of(*scenario, scenario->shots[0]) : scenario.error();
  };
  const auto study = must(study_with("shot.speed = column speed of speeds.csv"));
  EXPECT_EQ(study.inputs[0].distribution,
            Distribution(DiscreteDistribution{{2640 * 0.3048, 2650 * 0.3048, 2655 * 0.3048}, {}}));
  // As spreadsheets write it: a byte order mark, quotes around what has commas; and differences of temperatures.
  std::ofstream(folder / "days.csv") << "\xef\xbb\xbfremark,dT [degC]\r\n\"cold, wet\",-2\r\n\"\",0\r\nwarm,3\r\n";
  const auto days = must(study_with("environment.atmosphere.temperature = added column dT of days.csv"));
  const auto& changes = std::get<DiscreteDistribution>(days.inputs[0].distribution).values;
  ASSERT_EQ(changes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(changes[i], std::vector<double>({-2, 0, 3})[i], 1e-12);
  const auto in_place =
      must(parse_scenario(std::string(kHead) + "speed = { column = \"speed\", file = \"speeds.csv\" }\n", file));
  EXPECT_NEAR(in_place.shots[0].launch.speed, 0.3048 * 7945 / 3, 1e-9);
  const auto refused = [&](const std::string& input) {
    const auto with = study_with(input);
    return with ? std::string("none") : with.error().text();
  };
  EXPECT_NE(refused("shot.speed = column sped of speeds.csv").find("did you mean \"speed\""), std::string::npos);
  EXPECT_NE(refused("shot.mass = column speed of speeds.csv").find("speeds.csv:2:7: "), std::string::npos);
  EXPECT_NE(refused("shot.speed = column speed of none.csv").find("none.csv"), std::string::npos);
  EXPECT_NE(refused("shot.speed = column speed").find("no distribution"), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(StudyText, places) {
  using Q = StudyQuantity;
  const auto event = [](const char* text) { return must(parse_study_place(text)).event; };
  EXPECT_EQ(event("800 m").kind, EventKind::range);
  EXPECT_EQ(event("0.5 km").value, 500);
  EXPECT_EQ(event("range 800 m").value, 800);
  EXPECT_EQ(event("800").value, 800);
  EXPECT_EQ(event("apex").direction, Crossing::any) << "plan_study() makes it the highest point";
  EXPECT_EQ(event("height 100 ft falling").value, 30.48);
  EXPECT_EQ(event("height 100 ft falling").direction, Crossing::falling);
  EXPECT_EQ(event("time 2 s").direction, Crossing::any);
  EXPECT_EQ(event("mach 1").value, 1);
  EXPECT_EQ(event("ground").value, 0);
  const auto with = must(parse_study_place("apex : y, time"));
  EXPECT_EQ(with.quantities, (std::vector<Q>{Q::y, Q::time}));
  for (const char* text : {"800 m", "apex", "apex rising", "height 100 m falling", "time 2 s rising", "speed 340 m/s",
                           "mach 1.2", "ground", "ground 5 m", "burnout", "rail_exit"})
    EXPECT_EQ(place_text(event(text)), text);
  const auto refused = [](const char* text) {
    const auto place = parse_study_place(text);
    return place ? std::string("none") : place.error().text();
  };
  EXPECT_NE(refused("apxe").find("did you mean \"apex\""), std::string::npos) << refused("apxe");
  EXPECT_NE(refused("landed").find("no place"), std::string::npos);
  EXPECT_NE(refused("800 kg").find("length"), std::string::npos);
  EXPECT_NE(refused("height").find("length"), std::string::npos);
  EXPECT_NE(refused("apex 3 m").find("leave it out"), std::string::npos);
  EXPECT_NE(refused("apexrising").find("no place"), std::string::npos);
  for (const char* text : {"height 3 mfalling", "height 3 m falling rising", "falling"})
    EXPECT_NE(refused(text), "none") << text;
  EXPECT_NE(refused("apex: hight").find("no quantity of a place"), std::string::npos);
  EXPECT_NE(refused("").find("is no place"), std::string::npos);
  EXPECT_NE(refused(": y").find("is no place"), std::string::npos);
}

}  // namespace physim::scenario_study_text_test
