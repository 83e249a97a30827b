// The bracketing root finder on functions that trouble others.
#include "math/root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace physim::math_root_test {

struct Counted {
  double root;
  int calls;
};

Counted root(const std::function<double(double)>& f, double a, double b, double tolerance = 0,
             const EndRates<double>* rates = nullptr) {
  int calls = 0;
  const auto counted = [&](double x) {
    ++calls;
    return f(x);
  };
  const double x = find_roots<double>(counted, a, f(a), b, f(b), tolerance, 0, true, rates);
  return {x, calls};
}

struct Case {
  const char* name;
  std::function<double(double)> f;
  double a, b, expected, within;
  int most_calls;
};

const std::vector<Case>& nasty_cases() {
  static const std::vector<Case> cases = {
      {"line", [](double x) { return 3 * x - 1; }, 0, 1, 1.0 / 3, 1e-15, 10},
      {"cosine", [](double x) { return std::cos(x) - x; }, 0, 1, 0.7390851332151607, 1e-15, 15},
      {"flat cubic", [](double x) { return (x - 0.3) * (x - 0.3) * (x - 0.3); }, 0, 1, 0.3, 1e-5, 150},
      {"ninth power", [](double x) { return std::pow(x - 0.7, 9); }, 0, 1, 0.7, 1e-3, 200},
      {"wall", [](double x) { return std::exp(50 * x) - 1e10; }, 0, 1, 0.4605170185988091, 1e-15, 60},
      {"step", [](double x) { return x < 0.625 ? -1.0 : 1.0; }, 0, 1, 0.625, 1e-15, 120},
      {"pole", [](double x) { return x == 0.2 ? 1e20 : 1 / (x - 0.2); }, 0, 1, 0.2, 1e-14, 200},
      {"tiny values", [](double x) { return 1e-300 * (x - 0.9); }, 0, 1, 0.9, 1e-14, 120},
      {"parabola near its top", [](double x) { return 1e-12 - (x - 0.5) * (x - 0.5); }, 0.5, 1, 0.500001, 1e-15, 60},
      {"root next to an end", [](double x) { return x - 1e-13; }, 0, 1, 1e-13, 1e-27, 60},
      {"wide bracket", [](double x) { return std::atan(x - 1e-3); }, -1e9, 1e9, 1e-3, 1e-15, 120},
  };
  return cases;
}

TEST(FindRoot, finds_the_roots_of_nasty_functions) {
  for (const Case& c : nasty_cases()) {
    const Counted found = root(c.f, c.a, c.b);
    EXPECT_NEAR(found.root, c.expected, c.within) << c.name;
    EXPECT_LE(found.calls, c.most_calls) << c.name;
  }
}

TEST(FindRoot, needs_few_calls_on_smooth_functions) {
  EXPECT_LE(root([](double x) { return x * x * x - 2 * x - 5; }, 2, 3).calls, 12);
}

TEST(FindRoot, needs_fewer_calls_where_rates_are_known) {
  const auto f = [](double x) { return 800 * x - 40 * x * x + 2 * x * x * x - 500; };  // a bullet's way in a step
  const EndRates<double> rates{800, 800 - 80 + 6};
  const Counted found = root(f, 0, 1, 1e-15, &rates);
  EXPECT_NEAR(f(found.root), 0, 1e-12);
  EXPECT_LE(found.calls, 3);
  EXPECT_GE(root(f, 0, 1, 1e-15).calls, found.calls + 2);
  // ... the other way round, and down
  const EndRates<double> back{rates.at_b, rates.at_a};
  EXPECT_NEAR(root(f, 1, 0, 1e-15, &back).root, found.root, 1e-15);
  EXPECT_LE(root(f, 1, 0, 1e-15, &back).calls, 3);
  const EndRates<double> down{-rates.at_a, -rates.at_b};
  EXPECT_LE(root([&](double x) { return -f(x); }, 0, 1, 1e-15, &down).calls, 3);
}

TEST(FindRoot, is_not_led_astray_by_wrong_rates) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  const EndRates<double> wrong[] = {{0, 0},       {1, 1},    {-1, -1},       {1e300, 1e300}, {1e-300, -1e-300},
                                    {kNan, kNan}, {1, kNan}, {kInfinity, 1}, {-3, 1e-9},     {1e-9, 1e9}};
  for (const Case& c : nasty_cases())
    for (const EndRates<double>& rates : wrong) {
      SCOPED_TRACE(std::to_string(rates.at_a) + " " + std::to_string(rates.at_b));
      const Counted found = root(c.f, c.a, c.b, 0, &rates);
      EXPECT_NEAR(found.root, c.expected, c.within) << c.name;
      EXPECT_LE(found.calls, c.most_calls + 2) << c.name;
    }
}

TEST(FindRoot, stops_at_the_tolerance) {
  const Counted loose = root([](double x) { return std::exp(x) - 2; }, 0, 4, 1e-3);
  EXPECT_NEAR(loose.root, std::log(2.0), 1e-3);
  EXPECT_LT(loose.calls, root([](double x) { return std::exp(x) - 2; }, 0, 4).calls);
}

TEST(FindRoot, takes_values_within_the_noise_for_zero) {
  const auto f = [](double x) { return std::exp(x) - 2; };
  const double x = find_root(f, 0, f(0), 4, f(4), 0, 1e-6);
  EXPECT_LE(std::abs(f(x)), 1e-6);
  EXPECT_NE(x, root(f, 0, 4).root) << "it should have stopped earlier";
}

TEST(FindRoot, takes_an_end_that_is_a_root) {
  const auto never = [](double) -> double { return std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_EQ(find_root(never, 2, 0, 3, 1, 0), 2);
  EXPECT_EQ(find_root(never, 2, -1, 3, 0, 0), 3);
}

TEST(FindRoot, takes_the_better_end_where_there_is_no_change_of_sign) {
  const auto never = [](double) -> double { return std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_EQ(find_root(never, 2, 5, 3, 1, 0), 3);
  EXPECT_EQ(find_root(never, 2, -0.5, 3, -1, 0), 2);
}

TEST(FindRoot, ends_where_the_function_is_not_a_number) {
  const auto nan = [](double) { return std::numeric_limits<double>::quiet_NaN(); };
  const double x = find_root(nan, 0, -1, 1, 1, 0);
  EXPECT_GE(x, 0);
  EXPECT_LE(x, 1);
}

TEST(FindRoot, works_from_either_end) {
  const auto f = [](double x) { return std::cos(x) - x; };
  EXPECT_NEAR(find_root(f, 1, f(1), 0, f(0), 0), 0.7390851332151607, 1e-15);
}

/// x^3 - c with another c, bracket and rounding in every lane: some end by the secant method, some by Chandrupatla's,
/// some at an end of the bracket, some have no change of sign.
TEST(FindRoot, finds_in_the_lanes_of_a_pack_what_it_finds_alone) {
  using P = Pack<double, 8>;
  const P c = P::load(std::data({8.0, 1e-9, 3.0, 0.0, 27.0, 100.0, 1e6, -5.0}));
  const P a = P::load(std::data({0.0, -1.0, -50.0, 0.0, 3.0, 5.0, 0.0, -400.0}));
  const P b = P::load(std::data({3.0, 1.0, 2.0, 1.0, 4.0, 6.0, 1e4, 0.5}));
  const P noise = P::load(std::data({0.0, 0.0, 1e-3, 0.0, 0.0, 0.0, 1e-9, 0.0}));
  const auto f = [&](const P& x) { return x * x * x - c; };
  const P found = find_roots(f, a, f(a), b, f(b), 1e-15, noise, a == a);
  for (int lane = 0; lane < 8; ++lane) {
    const auto alone = [&](double x) { return x * x * x - c[lane]; };
    EXPECT_EQ(found[lane], find_root(alone, a[lane], alone(a[lane]), b[lane], alone(b[lane]), 1e-15, noise[lane]))
        << lane;
  }
}

}  // namespace physim::math_root_test
