// Searches that odd input would keep busy end with an error, after a bounded amount of work.
#include <gtest/gtest.h>

#include "flight/step_budget.hpp"
#include "physim/physim.hpp"

namespace physim::flight_search_bounds_test {

/// It falls at half a metre a second, and never comes near a target far away.
const ProjectileDef kDust{.mass = 1e-6, .diameter = 0.01, .drag = {.coefficient = 1}};

/// It falls at half a metre a second in steps of 0.6 ms, and never comes near a target far away.
TEST(SearchBounds, of_an_aim) {
  const ProjectileDef dust{.mass = 1e-6, .diameter = 0.01, .drag = {.k2 = 4e-5}};
  const AimOptions options{.tolerance = 1e-9, .time = 600, .flight = {.step = 6e-4}};
  Fidelity frames = Fidelity::game();
  frames.integrator = Integrator::semi_implicit_euler;
  const auto answer = aim(dust, {.speed = 30}, {}, frames, {{1000, 0, 0}}, options);
  ASSERT_FALSE(answer);
  EXPECT_NE(answer.error().message.find("the aim takes more than five million steps"), std::string::npos)
      << answer.error().text();
}

TEST(SearchBounds, count_what_is_tried) {
  StepBudget budget;
  const Flight flight = fly(kDust, {.speed = 30, .elevation = 1}, {}, Fidelity::reference());
  ASSERT_GT(flight.cost().evaluations, 0);
  const std::int64_t flights = kMostSearchEvaluations / flight.cost().evaluations;
  for (std::int64_t i = 0; i < flights; ++i) budget.spend(flight);
  EXPECT_FALSE(budget.is_spent());
  budget.spend(flight);
  EXPECT_TRUE(budget.is_spent());
}

TEST(Flight, of_no_record_is_refused) {
  const Flight none{std::shared_ptr<const FlightRecord>()};
  EXPECT_EQ(none.outcome(), Outcome::refused);
  ASSERT_TRUE(none.error());
  EXPECT_FALSE(none.at_range(1));
  EXPECT_FALSE(none.at_height(1));
  EXPECT_EQ(none.duration(), 0);
  static_cast<void>(none.end());
  EXPECT_EQ(StudyPart(nullptr).shards(), 0U);
}

}  // namespace physim::flight_search_bounds_test
