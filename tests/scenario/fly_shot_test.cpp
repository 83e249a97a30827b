// Shots of scenarios that ask for a fidelity by its error.

#include "must.hpp"
#include "scenario/scenario.hpp"

namespace physim::scenario_fly_shot_test {

Scenario bullet(const std::string& fidelity, const std::string& until, const std::string& more = "") {
  return must(parse_scenario(
      "physim = 1\n[[shot]]\nmass = \"168 gr\"\ndiameter = \"0.308 in\"\nspeed = 800\nelevation = 0.01\n"
      "position = [0, 1, 0]\ndrag = { table = \"g7\", ballistic_coefficient = \"0.218 lb/in^2\" }\nfidelity = " +
          fidelity + "\n[until]\n" + until + "\n" + more,
      "f.toml"));
}

Flight flown(const Scenario& scenario) { return fly_shot(scenario, scenario.shots.at(0)); }

TEST(FlyShot, CheapestWithinStaysThatNear) {
  for (const char* until : {"range = 600\nground = \"off\"", "time = 0.5", "ground = 0"})
    for (const char* more : {"", "[tolerance]\nstep = \"10 ms\"\n"}) {
      const Flight truth = flown(bullet("\"reference\"", until, more));
      const Flight near = flown(bullet("{ cheapest_within = \"1 cm\" }", until, more));
      ASSERT_FALSE(near.error()) << until << ": " << near.error()->text();
      EXPECT_EQ(near.outcome(), truth.outcome());
      EXPECT_LT(near.cost().evaluations, truth.cost().evaluations) << until;
      for (int i = 0; i <= 100; ++i) {
        const double time = truth.duration() * i / 100;
        EXPECT_LE(length(near.at(time).position - truth.at(time).position), 0.01) << until << " at " << time << " s";
      }
      EXPECT_EQ(near.fidelity_in_use().notes.back().asked, "cheapest_within 1 cm");
    }
}

TEST(FlyShot, TheOtherKeysAreTheTruth) {
  const Scenario scenario = bullet("{ preset = \"arcade\", cheapest_within = \"1 mm\" }", "time = 1");
  EXPECT_EQ(scenario.shots[0].projectile.fidelity, Fidelity::arcade());
  EXPECT_EQ(flown(scenario).fidelity_in_use().fidelity.motion, Motion::closed_form);
  EXPECT_EQ(bullet("{ cheapest_within = \"1 mm\" }", "time = 1").shots[0].projectile.fidelity, Fidelity::reference());
  EXPECT_EQ(bullet("{ cheapest_within = \"none\" }", "time = 1").shots[0].projectile.fidelity, Fidelity{});
}

TEST(FlyShot, RefusalsSayWhy) {
  const Flight flight = flown(bullet("{ cheapest_within = 1e-15 }", "time = 1"));
  EXPECT_EQ(flight.outcome(), Outcome::refused);
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.error()->place, "purpose.error");
}

}  // namespace physim::scenario_fly_shot_test
