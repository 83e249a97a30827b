// IeeeMode: computes by the book while it lives, and leaves the thread as it was.
#include "base/ieee_mode.hpp"

#include <limits>

#include "processor_mode.hpp"

namespace physim::base_ieee_mode_test {

// Computed where they are called, from numbers that the compiler does not know.
volatile double least = std::numeric_limits<double>::denorm_min();
volatile double one = 1;
volatile double three = 3;

TEST(IeeeMode, RoundsToNearestKeepsSubnormalsAndTrapsNothing) {
  const double third = one / three;
  for (const test::CallersMode mode : test::kCallersModes) {
    const test::InMode in_mode(mode);
    double quotient = 0, subnormal = 0, none = 0;
    {
      const IeeeMode ieee;
      quotient = one / three;
      subnormal = least * three;
      none = (one - one) / (one - one);
    }
    const bool good = std::memcmp(&quotient, &third, sizeof third) == 0;
    EXPECT_TRUE(in_mode.holds());
    EXPECT_TRUE(good);
    const IeeeMode compares;
    EXPECT_GT(subnormal, least);
    EXPECT_NE(none, none);
  }
}

TEST(IeeeMode, InsideAnotherOneChangesNothing) {
  const test::InMode upward(test::CallersMode::upward);
  const IeeeMode outer;
  { const IeeeMode inner; }
  const double quotient = one / three;
  EXPECT_LT(quotient * three, 1.0000000000000002);
  EXPECT_LT(quotient, 0.33333333333333337);
}

}  // namespace physim::base_ieee_mode_test
