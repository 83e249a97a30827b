#include "base/assert.hpp"

#include <gtest/gtest.h>

namespace base_assert_test {

TEST(Assert, EndsTheProgramWithTheConditionAndItsPlace) {
#if PHYSIM_ASSERTS
  const int lane = 9;
  EXPECT_DEATH(PHYSIM_ASSERT(lane < 8), "assert_test.cpp:[0-9]+: a bug in PhySim: lane < 8 does not hold");
#else
  GTEST_SKIP() << "this build has no asserts";
#endif
}

TEST(Assert, PassesWhatHolds) { PHYSIM_ASSERT(2 + 2 == 4); }

}  // namespace base_assert_test
