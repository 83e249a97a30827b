// Six rockets that flew: tables of drag and thrust with many corners, and winds, cost few steps that are taken twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scenario/scenario.hpp"

namespace physim {
namespace solve_flown_rockets_test {

std::vector<std::string> rockets() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(PHYSIM_SOURCE_DIR "/bench/rockets"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

class FlownRocket : public testing::TestWithParam<std::string> {};

TEST_P(FlownRocket, rejects_a_tenth_of_its_steps_at_most_and_flies_as_rocketpy_says) {
  const auto scenario = load_scenario(PHYSIM_SOURCE_DIR "/bench/rockets/" + GetParam() + ".toml");
  ASSERT_TRUE(scenario) << scenario.error().text();
  for (const ScenarioShot& shot : scenario->shots) {
    const Flight flight = fly_shot(*scenario, shot);
    ASSERT_FALSE(flight.error()) << flight.error()->text();
    EXPECT_EQ(flight.fidelity_in_use().fidelity.rotation, RotationModel::rigid_body);
    const FlightCost& cost = flight.cost();
    EXPECT_LT(10 * cost.rejected, cost.steps + cost.rejected);
    ASSERT_FALSE(scenario->expect.empty());
    for (const Expectation& expect : scenario->expect) {
      if (!expect.shot.empty() && expect.shot != shot.projectile.name) continue;
      const Result<double> value = measure(flight, expect);
      ASSERT_TRUE(value) << value.error().text();
      EXPECT_NEAR(*value, expect.equals, expect.within) << expect.quantity << ": " << expect.source;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Six, FlownRocket, testing::ValuesIn(rockets()),
                         [](const auto& rocket) { return rocket.param; });

TEST(FlownRockets, AreSix) { EXPECT_EQ(rockets().size(), 6U); }

}  // namespace solve_flown_rockets_test
}  // namespace physim
