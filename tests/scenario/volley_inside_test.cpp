// Launches of a volley fly from their own moments, wherever those lie in the steps of a world.
#include <cmath>

#include "scenario/run_support.hpp"

namespace physim::scenario_volley_inside_test {

constexpr double kG = 9.80665;

/// Shots at 30 m/s and 45 degrees from 1 m above the ground, without air.
std::string scenario(const std::string& fidelity, const std::string& world, const std::string& volley) {
  return "physim = 1\n[environment]\ngravity = { model = \"constant\", acceleration = \"9.80665 m/s^2\" }\n"
         "[[shot]]\nname = \"a\"\nmass = \"1 kg\"\nspeed = \"30 m/s\"\nelevation = \"45 deg\"\n"
         "position = [\"0 m\", \"1 m\", \"0 m\"]\nfidelity = " +
         fidelity + "\n[world]\n" + world + "[[volley]]\nshot = \"a\"\n" + volley;
}
const char* const kClosed =
    R"({ motion = "closed_form", gravity = "constant", drag = "off", air = "vacuum", wind = "off" })";
const char* const kRk4 =
    R"({ integrator = "rk4", gravity = "constant", drag = "off", air = "vacuum", wind = "off", rotation = "none" })";

TEST(VolleyInside, each_lands_as_a_shot_from_its_own_moment) {
  const double up = 30 / std::sqrt(2.0), flies = (up + std::sqrt(up * up + 2 * kG)) / kG;
  for (const char* const fidelity : {kClosed, kRk4}) {
    WorldRun run = run_of(scenario(fidelity, "duration = \"8 s\"\nstep = \"0.1 s\"\n",
                                   "count = 7\ninterval = \"0.1234 s\"\nstart = \"0.0371 s\"\n"));
    std::vector<double> landed;
    for (std::uint64_t i = 0; i < run.steps(); ++i) {
      run.step();
      for (const RunEvent& e : run.events())
        if (e.event.kind == EventKind::landed) landed.push_back(e.event.time);
    }
    const WorldGroup& group = run.groups()[0];
    EXPECT_EQ(group.spawned, 7u);
    ASSERT_EQ(landed.size(), 7u);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(landed[i], 0.0371 + 0.1234 * double(i) + flies, 1e-9) << i;
    EXPECT_NEAR(group.time.mean, flies, 1e-9);
    EXPECT_NEAR(group.range.mean, up * flies, 1e-8);
  }
}

TEST(VolleyInside, launches_of_the_last_step_come) {
  WorldRun run = run_of(scenario(kRk4, "duration = \"1 s\"\nstep = \"0.1 s\"\n",
                                 "count = 3\ninterval = \"0.03 s\"\nstart = \"0.91 s\"\n"));
  finish(run);
  EXPECT_EQ(run.groups()[0].spawned, 3u);
  const std::vector<ProjectileId> ids = run.world().ids();
  ASSERT_EQ(ids.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(run.world()[ids[i]].position().x, 30 / std::sqrt(2.0) * (0.09 - 0.03 * double(i)), 1e-12) << i;
}

TEST(VolleyInside, a_run_that_is_saved_between_steps_goes_on_to_the_bit) {
  const std::string text = scenario(kRk4, "duration = \"3 s\"\nstep = \"0.1 s\"\n",
                                    "count = 20\ninterval = \"0.0917 s\"\nspread = { speed = \"1 m/s\" }\n");
  WorldRun going = run_of(text), broken = run_of(text);
  for (std::uint64_t i = 0; i < going.steps(); ++i) {
    going.step(), broken.step();
    broken = std::move(*WorldRun::load(*parse_scenario(text, "f.toml"), *broken.save()));
    ASSERT_EQ(going.world().hash(), broken.world().hash()) << i;
  }
  EXPECT_EQ(going.groups()[0].spawned, 20u);
}

}  // namespace physim::scenario_volley_inside_test
