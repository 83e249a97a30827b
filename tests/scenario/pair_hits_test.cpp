// Runs whose projectiles meet each other.
#include "scenario/world_run.hpp"
#include "support.hpp"

namespace physim::scenario_pair_hits_test {

TEST(PairHits, the_cradle_meets_its_expectations) {
  const Scenario scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/newtons_cradle.toml"));
  WorldRun run = WorldRun::create(scenario).value();
  for (std::uint64_t i = 0; i < run.steps(); ++i) run.step();
  const auto groups = run.groups();
  ASSERT_EQ(scenario.expect.size(), 4u);
  for (const Expectation& expectation : scenario.expect) {
    const auto group = std::ranges::find(groups, expectation.shot, &WorldGroup::name);
    ASSERT_NE(group, groups.end());
    const auto value = must(measure(*group, expectation));
    EXPECT_NEAR(value, expectation.equals, expectation.within) << expectation.shot << " " << expectation.quantity;
  }
}

TEST(PairHits, others_are_read_and_refused_by_their_place) {
  const std::string text =
      "physim = 1\n[[shot]]\nmass = \"1 kg\"\ndiameter = \"1 cm\"\nspeed = \"1 m/s\"\n"
      "body = { collision = { others = 6 } }\n[world]\n";
  const Scenario scenario = must(parse_scenario(text, "f.toml"));
  EXPECT_EQ(scenario.shots[0].body.collision.others, 6u);
  std::string bad = text;
  bad.replace(bad.find("= 6"), 3, "= -1");
  const Result<Scenario> refused = parse_scenario(bad, "f.toml");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("f.toml:6:"), std::string::npos) << refused.error().text();
}

}  // namespace physim::scenario_pair_hits_test
