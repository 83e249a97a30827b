// Scenarios written as text: what is read back is what was written, setting by setting.
#include "must.hpp"
#include "scenario/revise.hpp"
#include "scenario/scenario.hpp"
#include "shipped.hpp"

namespace physim::scenario_writer_test {

class WrittenScenario : public testing::TestWithParam<std::string> {};

TEST_P(WrittenScenario, ReadsBackAsItWas) {
  const std::string file = PHYSIM_SOURCE_DIR "/scenarios/" + GetParam() + ".toml";
  const Scenario before = must(load_scenario(file));
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "written.toml"), text);
  EXPECT_EQ(effective_settings(after), effective_settings(before));
  EXPECT_EQ(scenario_text(after), text);
  EXPECT_EQ(after.expect.size(), before.expect.size());
  for (std::size_t i = 0; i < before.shots.size(); ++i) EXPECT_EQ(after.shots[i].body, before.shots[i].body);
}

TEST_P(WrittenScenario, IsNoLongerThanPeopleWroteIt) {
  const std::string file = PHYSIM_SOURCE_DIR "/scenarios/" + GetParam() + ".toml";
  const std::string text = scenario_text(load_scenario(file).value());
  const auto room = static_cast<std::size_t>(1.2 * static_cast<double>(std::filesystem::file_size(file)));
  const bool holds_a_motor = text.find("motor = ") != text.npos;  // which people keep in a file of its own
  EXPECT_LT(text.size(), room + (holds_a_motor ? 4000 : 0)) << text;
}

INSTANTIATE_TEST_SUITE_P(Shipped, WrittenScenario, testing::ValuesIn(test::shipped_scenarios()),
                         [](const auto& scenario) {
                           std::string name = scenario.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

TEST(ScenarioText, KeepsTextThatNeedsQuotes) {
  Scenario scenario{.title = "a \"quoted\" title\nof two lines"};
  scenario.shots.resize(1);
  scenario.shots[0].projectile.name = "one.two";
  const Scenario after = must(parse_scenario(scenario_text(scenario), "written.toml"));
  EXPECT_EQ(after.title, scenario.title);
  EXPECT_EQ(after.shots[0].projectile.name, "one.two");
}

/// Within a block a quote is a quote; only one that would end the block is escaped.
TEST(ScenarioText, EscapesNoMoreQuotesThanItMust) {
  const Scenario scenario = must(parse_scenario("physim = 1\n[[shot]]\nspeed = \"30 m/s\"\n", "plain.toml"));
  Scenario titled = scenario;
  titled.title = "a \"quoted\" title\nof \"\" two lines, \"the end\"";
  const std::string said = scenario_text(titled);
  EXPECT_NE(said.find("a \"quoted\" title\nof \"\\\" two lines, \"the end\\\"\"\"\""), std::string::npos) << said;
  EXPECT_EQ(parse_scenario(said, "written.toml")->title, titled.title);
}

/// Digits alone are an integer of TOML, which ends below 2^63.
TEST(ScenarioText, HasRealNumbersBeyondIntegers) {
  const std::string said =
      "physim = 1\n[[shot]]\ndrag = { table = \"constant\", coefficient = 9223372036854775808.0 }\n";
  const Scenario scenario = must(parse_scenario(said, "said.toml"));
  const Scenario after = must(parse_scenario(scenario_text(scenario), "written.toml"));
  EXPECT_EQ(effective_settings(after), effective_settings(scenario));
}

TEST(ScenarioText, SaysWhatDiffersFromDefaultsAndPresets) {
  const std::string said =
      "physim = 1\n"
      "title = \"a ball\"\n"
      "\n[environment]\n"
      "altitude = \"500 m\"\n"
      "gravity = \"constant\"\n"
      "\n[[shot]]\n"
      "name = \"drive\"\n"
      "preset = \"golf_ball\"\n"
      "mass = \"0.05 kg\"\n"
      "fidelity = { preset = \"constant_air\", rotation = \"magnus\" }\n"
      "\n[[shot]]\n"
      "name = \"stone\"\n"
      "speed = \"20 m/s\"\n"
      "fidelity = \"game\"\n"
      "\n[until]\n"
      "ground = \"off\"\n"
      "time = \"3 s\"\n"
      "\n[[expect]]\n"
      "shot = \"stone\"\n"
      "at = { time = \"1 s\" }\n"
      "quantity = \"mach\"\n"
      "equals = 0.05\n"
      "within = 0.01\n";
  EXPECT_EQ(scenario_text(parse_scenario(said, "said.toml").value()), said);
}

/// Rungs are flown against the reference; a fidelity that says nothing beside would be lost with other defaults.
TEST(ScenarioText, KeepsWhatDefaultsOfOtherSettingsWouldChange) {
  const std::string texts[] = {
      "physim = 1\n[[shot]]\nfidelity = { cheapest_within = \"1 m\", air = \"isa\", integrator = \"tsit5\" }\n",
      "physim = 1\n[[shot]]\npreset = \"golf_ball\"\nvelocity = [1, 2, 3]\n",
      "physim = 1\n[world]\n[[shot]]\n[[force]]\npoint_attractor = { strength = 0 }\n",
      "physim = 1\n[world]\n[[shot]]\n",
      "physim = 1\n[[shot]]\n[[until.events]]\nkind = \"speed\"\nvalue = \"3 m/s\"\n[[until.events]]\nkind = "
      "\"height\"\n",
  };
  for (const std::string& text : texts) {
    const Scenario before = must(parse_scenario(text, "a.toml"));
    const Result<Scenario> after = parse_scenario(scenario_text(before), "b.toml");
    ASSERT_TRUE(after) << after.error().text() << scenario_text(before);
    EXPECT_TRUE(say_the_same(*after, before)) << scenario_text(before);
    EXPECT_EQ(after->world.given, before.world.given);
  }
}

// ------------------------------------------------------------------------------------------------------------- revised
constexpr const char* kCommented =
    "physim = 1  # the format\n"
    "title = \"\u00e4 b\u00b0\"  # keeps its letters\n"
    "\n"
    "[environment]  # where\n"
    "gravity = \"constant\"\n"
    "\n"
    "[[shot]]  # the first\n"
    "name = \"a\"\n"
    "drag = { table = \"g7\", ballistic_coefficient = \"0.218 lb/in^2\" }  # Litz\n"
    "speed = \"2700 ft/s\" # as loaded\n"
    "\n"
    "[[shot]]\n"
    "name = \"a.b\"\n"
    "[shot.sight]\n"
    "height = \"1.5 in\" # high\n";

std::string revised(const char* replaced, const char* by) {
  std::string text = kCommented;
  text.replace(text.find(replaced), std::string(replaced).size(), by);
  return text;
}

TEST(RevisedText, ChangesWhatChangedAndKeepsAllElse) {
  const struct {
    const char *change, *replaced, *by;
  } changes[] = {
      {"shot.a.speed=853.44 m/s", "\"2700 ft/s\"", "\"2800 ft/s\""},
      {"shot.a.drag.table=g1", "\"g7\"", "\"g1\""},
      {"shot.a.drag.form_factor=1.1", "lb/in^2\" }", "lb/in^2\", form_factor = 1.1 }"},
      {"shot.a.mass=2 kg", "as loaded\n", "as loaded\nmass = \"2 kg\"\n"},
      {"shot.a.fidelity.drag=off", "as loaded\n", "as loaded\nfidelity.drag = \"off\"\n"},
      {"shot.a.b.sight.height=0.0508 m", "\"1.5 in\"", "\"2 in\""},
      {"shot.a.b.sight.cant=30 deg", "# high\n", "# high\ncant = \"30 deg\"\n"},
      {"shot.a.b.mass=2 kg", "name = \"a.b\"\n", "name = \"a.b\"\nmass = \"2 kg\"\n"},
      {"environment.gravity.model=off", "\"constant\"", "\"off\""},
      {"environment.gravity.acceleration=5 m/s^2", "\"constant\"",
       "{ model = \"constant\", acceleration = \"5 m/s^2\" }"},
      {"environment.wind.velocity=[1, 0, 0]", "\"constant\"\n",
       "\"constant\"\nwind.velocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]\n"},
      {"until.time=5 s", "# high\n", "# high\n\n[until]\ntime = \"5 s\"\n"},
      {"title=another", "\"\u00e4 b\u00b0\"", "\"another\""},
      {"source=a \"b\"", "letters\n", "letters\nsource = \"a \\\"b\\\"\"\n"},
  };
  for (const auto& each : changes) {
    const Scenario now = parse_scenario(kCommented, "a.toml", std::vector<std::string>{each.change}).value();
    EXPECT_EQ(revised_text(kCommented, "a.toml", now), revised(each.replaced, each.by)) << each.change;
  }
}

TEST(RevisedText, HasNumbersAsTheyWereTyped) {
  const struct {
    const char *path, *typed, *replaced, *by;
  } changes[] = {
      {"shot.a.speed", "800 m/s", "\"2700 ft/s\"", "\"800 m/s\""},
      {"shot.a.speed", "3 km/s", "\"2700 ft/s\"", "\"3 km/s\""},
      {"shot.a.mass", "170 gr", "as loaded\n", "as loaded\nmass = \"170 gr\"\n"},
      {"shot.a.b.sight.cant", "1 rad", "# high\n", "# high\ncant = \"1 rad\"\n"},
      {"shot.a.drag.form_factor", "110 %", "lb/in^2\" }", "lb/in^2\", form_factor = \"110 %\" }"},
      {"environment.wind.velocity", "[\"1 kn\", 0, 0]", "\"constant\"\n",
       "\"constant\"\nwind.velocity = [\"1 kn\", \"0 m/s\", \"0 m/s\"]\n"},
  };
  for (const auto& each : changes) {
    const std::string change = std::string(each.path) + "=" + each.typed;
    TypedNumbers typed;
    typed.take(each.path, "7 m, 7 kg");
    typed.take(each.path, each.typed);
    const Scenario now = parse_scenario(kCommented, "a.toml", std::vector<std::string>{change}).value();
    EXPECT_EQ(revised_text(kCommented, "a.toml", now, typed), revised(each.replaced, each.by)) << change;
  }
}

TEST(RevisedText, TakesManyChangesAndShotsAtTheEnd) {
  Scenario now = parse_scenario(kCommented, "a.toml",
                                std::vector<std::string>{"shot.mass=2 kg", "shot.speed=10 m/s", "shot.twist=1 m"})
                     .value();
  now.shots.push_back(now.shots[0]);
  now.shots[2].projectile.name = "c";
  now.shots[2].launch.elevation = 0.5;
  const auto text = must(revised_text(kCommented, "a.toml", now));
  EXPECT_TRUE(say_the_same(parse_scenario(text, "a.toml").value(), now));
  for (const char* comment : {"# the format", "# Litz", "# as loaded", "# high"})
    EXPECT_NE(text.find(comment), text.npos) << comment;
}

/// What is made of a published material has it by its name; one that nothing is made of is written down.
TEST(RevisedText, LeavesOutPublishedMaterialsThatThingsAreMadeOf) {
  const std::string world = "physim = 1\n[[shot]]\n[world]\n";
  const auto now_with = [&](const std::string& material) {
    return parse_scenario(
               world + "[[shape]]\nname = \"a\"\nbox = [1, 1, 1]\n[[thing]]\nname = \"b\"\nshape = \"a\"\n" + material,
               "a.toml")
        .value();
  };
  const Scenario oak = now_with("material = \"oak\"\n");
  ASSERT_EQ(oak.materials.size(), 1U);
  const auto text = must(revised_text(world, "a.toml", oak));
  EXPECT_EQ(text.find("[[material]]"), text.npos) << text;
  Scenario spare = now_with("");
  spare.materials = oak.materials;
  const auto more = must(revised_text(world, "a.toml", spare));
  EXPECT_NE(more.find("[[material]]\nname = \"oak\""), more.npos) << more;
}

TEST(RevisedText, IsNothingWhereTheTextCannotSayIt) {
  Scenario now = parse_scenario(kCommented, "a.toml").value();
  EXPECT_EQ(revised_text(kCommented, "a.toml", now), kCommented);
  EXPECT_EQ(revised_text("no scenario", "a.toml", now), std::nullopt);
  now.shots[0].body.restitution = 0.123;
  EXPECT_EQ(revised_text(kCommented, "a.toml", now), std::nullopt) << "flights have no bodies";
  now = parse_scenario(kCommented, "a.toml").value();
  now.shots.pop_back();
  EXPECT_EQ(revised_text(kCommented, "a.toml", now), std::nullopt) << "a shot is gone";
}

}  // namespace physim::scenario_writer_test
