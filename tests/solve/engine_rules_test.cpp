// The rules of other engines that ./dev bench flies beside the library: a step by hand, and where they go when steps
// become small.
#include "../../bench/engine_rules.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace physim::solve_engine_rules_test {

using bench::EngineRule;

double after(EngineRule rule, double v, double a, double c, double h) {
  switch (rule) {
    case EngineRule::unity: return bench::velocity_after<EngineRule::unity>(v, a, c, h);
    case EngineRule::unity_2d: return bench::velocity_after<EngineRule::unity_2d>(v, a, c, h);
    case EngineRule::jolt: return bench::velocity_after<EngineRule::jolt>(v, a, c, h);
    case EngineRule::godot: return bench::velocity_after<EngineRule::godot>(v, a, c, h);
    case EngineRule::box2d: return bench::velocity_after<EngineRule::box2d>(v, a, c, h);
  }
  return 0;
}

constexpr EngineRule kRules[] = {EngineRule::unity, EngineRule::unity_2d, EngineRule::jolt, EngineRule::godot,
                                 EngineRule::box2d};

TEST(EngineRules, a_step_is_what_the_pages_say) {
  // v = 10 m/s, a = -4 m/s^2, c = 0.5/s, h = 0.5 s: 8 m/s after the acceleration, 3/4 kept, or 1/1.25.
  EXPECT_DOUBLE_EQ(after(EngineRule::unity, 10, -4, 0.5, 0.5), 8 * 0.75);
  EXPECT_DOUBLE_EQ(after(EngineRule::jolt, 10, -4, 0.5, 0.5), 8 * 0.75);
  EXPECT_DOUBLE_EQ(after(EngineRule::godot, 10, -4, 0.5, 0.5), 10 * 0.75 - 2);
  EXPECT_DOUBLE_EQ(after(EngineRule::unity_2d, 10, -4, 0.5, 0.5), 8 * 0.8);
  EXPECT_DOUBLE_EQ(after(EngineRule::box2d, 10, -4, 0.5, 0.5), 10 * 0.8 - 2);
  // Damping beyond a step: all is lost, and nothing goes back.
  EXPECT_EQ(after(EngineRule::unity, 10, 0, 60, 0.02), 0);
  EXPECT_EQ(after(EngineRule::godot, 10, -4, 60, 0.02), -0.08);
}

TEST(EngineRules, all_mean_linear_drag_to_first_order) {
  const double v0 = 5, a = -2, c = 0.7, flown = 2;
  const double fall = a / c, exact = fall * flown + (v0 - fall) * (1 - std::exp(-c * flown)) / c;
  for (const EngineRule rule : kRules) {
    SCOPED_TRACE(static_cast<int>(rule));
    double error[2];
    for (int fine = 0; fine < 2; ++fine) {
      const int steps = fine == 0 ? 1000 : 2000;
      const double h = flown / steps;
      double x = 0, v = v0;
      for (int i = 0; i < steps; ++i) v = after(rule, v, a, c, h), x += v * h;
      error[fine] = x - exact;
    }
    EXPECT_LT(std::abs(error[0]), 0.02);
    EXPECT_NEAR(error[0] / error[1], 2, 0.01);
  }
}

}  // namespace physim::solve_engine_rules_test
