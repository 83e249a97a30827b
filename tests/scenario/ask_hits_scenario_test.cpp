// Hits that ask: a file has nobody who answers.
#include "must.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_ask_hits_scenario_test {

constexpr const char* kFile = R"(physim = 1
[[shot]]
body.collision.on_hit = "ask"
[world]
duration = "1 s"
)";

TEST(AskHitsScenario, a_file_cannot_ask) {
  const Result<Scenario> scenario = parse_scenario(kFile, "ask.toml");
  ASSERT_FALSE(scenario);
  EXPECT_EQ(scenario.error().place, "ask.toml:3:25");
  EXPECT_NE(scenario.error().text().find("known values: pass, stop, stick, bounce, impact"), std::string::npos)
      << scenario.error().text();
}

/// Nor one that a program makes, since its run has no function.
TEST(AskHitsScenario, nor_can_a_run) {
  std::string bounces = kFile;
  bounces.replace(bounces.find("ask"), 3, "bounce");
  Scenario scenario = must(parse_scenario(bounces, "ask.toml"));
  scenario.shots[0].body.collision.on_hit = OnHit::ask;
  const Result<WorldRun> run = WorldRun::create(scenario);
  ASSERT_FALSE(run);
  EXPECT_NE(run.error().text().find("nobody answers"), std::string::npos) << run.error().text();
  EXPECT_EQ(scenario_text(scenario).find("\"ask\""), std::string::npos);
}

}  // namespace physim::scenario_ask_hits_scenario_test
