#include "base/assert.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "physim/result.hpp"

namespace base_assert_test {

void log_of_an_engine(const char* text) { std::fprintf(stderr, "engine: %s\n", text); }

TEST(FailureHandler, ReceivesTheTextOfWhatEndsTheProgram) {
  using physim::Result;
  const Result<int> none = physim::Error{"no such thing", "thing.name", ""};
  EXPECT_EQ(physim::set_failure_handler(log_of_an_engine), nullptr);
  EXPECT_DEATH(static_cast<void>(none.value()), "engine: physim: .*\nthing.name: error: no such thing");
#if PHYSIM_ASSERTS
  EXPECT_DEATH(PHYSIM_ASSERT(none.ok()), "engine: .*assert_test.cpp:[0-9]+: a bug in PhySim: none.ok");
#endif
  EXPECT_EQ(physim::set_failure_handler(nullptr), log_of_an_engine);
  EXPECT_DEATH(static_cast<void>(none.value()), "^physim: .*\nthing.name: error: no such thing");
}

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
