#include "world/core/step_list.hpp"

#include <gtest/gtest.h>

namespace physim::world_step_list_test {

/// Fills it with so many, and empties it, step after step.
template <class List>
void use(List& list, int steps, int many) {
  for (int step = 0; step < steps; ++step) {
    for (int i = 0; i < many; ++i) list.emplace_back();
    list.clear();
  }
}

TEST(StepList, KeepsTheMemoryThatStepsNeed) {
  StepList<double> list;
  use(list, 10 * ListUse::kSteps, 1000);
  const std::size_t held = list.capacity();
  EXPECT_GE(held, 1000u);
  const double* place = list.data();
  use(list, 10 * ListUse::kSteps, 1000);
  EXPECT_EQ(list.data(), place);
  EXPECT_EQ(list.capacity(), held);
}

TEST(StepList, GivesBackWhatOneStepAloneNeeded) {
  StepList<double> list;
  use(list, 10, 100);
  use(list, 1, 1000000);
  EXPECT_GE(list.capacity(), 1000000u);
  use(list, ListUse::kSteps, 100);
  EXPECT_GE(list.capacity(), 1000000u) << "given back within the steps that it is watched for";
  use(list, ListUse::kSteps, 100);
  EXPECT_LE(list.capacity(), 400u);
  EXPECT_GE(list.capacity(), 100u);
}

TEST(StepList, KeepsWhatIsNotWorthGivingBack) {
  StepList<char> list;
  use(list, 1, 1000);
  use(list, 3 * ListUse::kSteps, 0);
  EXPECT_GE(list.capacity(), 1000u);
}

}  // namespace physim::world_step_list_test
