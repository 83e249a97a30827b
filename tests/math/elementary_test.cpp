// The elementary functions: error bounds against libm, special values, and equal bits for scalars, packs and platforms.
#include "math/elementary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

namespace physim::math_elementary_test {

// To measure the table of elementary.hpp anew: -DPHYSIM_ULP_POINTS=8000000, which also prints the worst errors.
#ifdef PHYSIM_ULP_POINTS
constexpr int kPoints = PHYSIM_ULP_POINTS;
constexpr bool kPrint = true;
#else
constexpr int kPoints = 50000;
constexpr bool kPrint = false;
#endif
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr bool kHaveWideReference = std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;

/// libm with more digits than T.
template <class T>
using Wider = std::conditional_t<sizeof(T) == 8, long double, double>;

/// Distance from the exact result in units in the last place of T.
template <class T>
double ulps(T result, Wider<T> exact) {
  if (result == static_cast<T>(exact)) {
    if (std::isinf(result)) return 0;
  } else if (!std::isfinite(result)) {
    return kInf;
  }
  using Limits = std::numeric_limits<T>;
  const int exponent = exact == 0 ? Limits::min_exponent : std::max(std::ilogb(exact) + 1, Limits::min_exponent);
  return static_cast<double>(std::fabs(result - exact) / std::ldexp(Wider<T>(1), exponent - Limits::digits));
}

/// Random numbers that are the same with every standard library.
class Random {
 public:
  /// Uniform in [low, high).
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  /// Either sign, with a uniform exponent of 2 in [low, high).
  double of_any_size(double low, double high) {
    const double s = sign();  // one draw after the other: C++ leaves the order within an expression open
    const double mantissa = between(1, 2);
    return s * std::ldexp(mantissa, static_cast<int>(std::floor(between(low, high))));
  }
  double sign() { return bits() % 2 == 0 ? 1 : -1; }
  std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_{20240611};
};

/// One or two arguments of a function.
template <class T, std::size_t N>
using Points = std::vector<std::array<T, N>>;

/// Points for T: dense between low and high, and of all sizes towards zero.
template <class T>
Points<T, 1> points_between(double low, double high) {
  Random random;
  Points<T, 1> points{{T(low)}, {T(high)}};
  for (int i = 0; i < kPoints; ++i) points.push_back({T(random.between(low, high))});
  for (int i = 0; i < kPoints; ++i) {
    const T x = T(random.of_any_size(sizeof(T) == 8 ? -1000 : -120, std::ilogb(std::max(-low, high)) + 1));
    if (x >= T(low) && x <= T(high)) points.push_back({x});
  }
  return points;
}
/// Positive numbers of every size, and many near one.
template <class T>
Points<T, 1> positive_points() {
  Random random;
  using Limits = std::numeric_limits<T>;
  Points<T, 1> points{{Limits::denorm_min()}, {Limits::min()}, {T(1)}, {Limits::max()}};
  const double low = sizeof(T) == 8 ? -1074 : -149, high = sizeof(T) == 8 ? 1024 : 128;
  for (int i = 0; i < kPoints; ++i) points.push_back({T(std::fabs(random.of_any_size(low, high)))});
  for (int i = 0; i < kPoints; ++i) points.push_back({T(random.between(0.5, 2))});
  for (int i = 0; i < kPoints; ++i) points.push_back({T(1 + random.of_any_size(-40, -2))});
  return points;
}
/// The numbers next to multiples of pi/2 join the others: there sines and cosines are hardest.
template <class T>
Points<T, 1> angles_to(double limit) {
  Points<T, 1> points = points_between<T>(-limit, limit);
  for (const auto& x : points_between<T>(-4, 4)) points.push_back(x);
  const long double half_pi = 1.570796326794896619231321691639751442L;
  for (int n = 0; static_cast<double>(n) * 1.5707963267948966 < limit; ++n) {
    const T x = static_cast<T>(n * half_pi);
    for (T y : {x, std::nextafter(x, T(0)), std::nextafter(x, T(1e9))}) points.push_back({y}), points.push_back({-y});
  }
  return points;
}

/// The worst error at `points`, which are arrays of a function's arguments.
template <class T, std::size_t N, class Ours, class Exact>
double worst_ulps(const std::vector<std::array<T, N>>& points, Ours ours, Exact exact) {
  double worst = 0;
  std::array<T, N> where{};
  for (const auto& x : points) {
    const auto error_at = [&](auto... xs) { return ulps<T>(ours(xs...), exact(static_cast<Wider<T>>(xs)...)); };
    const double error = std::apply(error_at, x);
    if (!(error <= worst)) worst = error, where = x;
  }
  if (kPrint)
    std::printf("%-7s %.3f ulp at %.17g %.17g\n", sizeof(T) == 8 ? "double" : "float", worst, double(where[0]),
                double(where[N - 1]));
  return worst;
}

// Checks the function `name` against libm in double and in float. The bounds stand in elementary.hpp's table.
#define EXPECT_ULPS(name, points_double, bound_double, points_float, bound_float) \
  do {                                                                            \
    const auto ours = [](auto... x) { return name(x...); };                       \
    const auto exact = [](auto... x) { return std::name(x...); };                 \
    if (kHaveWideReference) {                                                     \
      EXPECT_LE(worst_ulps(points_double, ours, exact), bound_double);            \
    }                                                                             \
    EXPECT_LE(worst_ulps(points_float, ours, exact), bound_float);                \
  } while (false)

TEST(Elementary, ExpIsWithinOneUlp) {
  EXPECT_ULPS(exp, points_between<double>(-708, 709.78), 0.85, points_between<float>(-87, 88.72), 0.85);
}
TEST(Elementary, ExpUnderflowsGradually) {
  EXPECT_ULPS(exp, points_between<double>(-745, -708), 0.85, points_between<float>(-103.9, -87), 0.85);
}
TEST(Elementary, Expm1IsWithinItsBound) {
  EXPECT_ULPS(expm1, points_between<double>(-60, 709.78), 1.5, points_between<float>(-30, 88.72), 1.5);
  EXPECT_ULPS(expm1, points_between<double>(-2, 2), 1.5, points_between<float>(-2, 2), 1.5);
}
TEST(Elementary, LogIsWithinOneUlp) {
  EXPECT_ULPS(log, positive_points<double>(), 0.95, positive_points<float>(), 0.95);
}
TEST(Elementary, Log1pIsWithinOneUlp) {
  EXPECT_ULPS(log1p, points_between<double>(-1 + 1e-15, 3), 0.95, points_between<float>(-1 + 1e-6, 3), 0.95);
  EXPECT_ULPS(log1p, positive_points<double>(), 0.95, positive_points<float>(), 0.95);
}

/// Bases of every size with exponents that lead to results of every size.
template <class T>
Points<T, 2> powers() {
  Random random;
  Points<T, 2> points;
  const double low = sizeof(T) == 8 ? -708 : -87, high = sizeof(T) == 8 ? 709.7 : 88.7;
  for (const auto& [x] : positive_points<T>()) {
    const double log_x = std::log(static_cast<double>(x));
    const T y = T(x == T(1) ? 3 : random.between(low, high) / log_x);
    const double log_result = double(y) * log_x;
    if (log_result > low && log_result < high) points.push_back({x, y});
    points.push_back({T(random.between(0.1, 10)), T(random.between(-10, 10))});
  }
  return points;
}
TEST(Elementary, PowIsWithinItsBound) { EXPECT_ULPS(pow, powers<double>(), 1.05, powers<float>(), 0.85); }

// The limits of the reduction: 2^19 quarter turns in double, 2^13 in float.
TEST(Elementary, SinIsWithinOneUlp) {
  EXPECT_ULPS(sin, angles_to<double>(8.2e5), 0.95, angles_to<float>(1.28e4), 0.95);
}
TEST(Elementary, CosIsWithinOneUlp) {
  EXPECT_ULPS(cos, angles_to<double>(8.2e5), 0.95, angles_to<float>(1.28e4), 0.95);
}
TEST(Elementary, TanIsWithinItsBound) { EXPECT_ULPS(tan, angles_to<double>(1e5), 2.4, angles_to<float>(1e4), 2.5); }

TEST(Elementary, AsinIsWithinItsBound) {
  EXPECT_ULPS(asin, points_between<double>(-1, 1), 1.2, points_between<float>(-1, 1), 1.2);
}
TEST(Elementary, AcosIsWithinItsBound) {
  EXPECT_ULPS(acos, points_between<double>(-1, 1), 1.2, points_between<float>(-1, 1), 1.2);
}
TEST(Elementary, AtanIsWithinItsBound) {
  EXPECT_ULPS(atan, points_between<double>(-5, 5), 1.4, points_between<float>(-5, 5), 1.4);
  EXPECT_ULPS(atan, points_between<double>(-1e9, 1e9), 1.4, points_between<float>(-1e9, 1e9), 1.4);
}

template <class T>
Points<T, 2> planar_points() {
  Random random;
  Points<T, 2> points;
  const double size = sizeof(T) == 8 ? 1000 : 120;
  for (int i = 0; i < kPoints; ++i) {
    points.push_back({T(random.between(-1, 1)), T(random.between(-1, 1))});
    points.push_back({T(random.of_any_size(-8, 8)), T(random.of_any_size(-8, 8))});
    points.push_back({T(random.of_any_size(-size, size)), T(random.of_any_size(-size, size))});
    points.push_back({T(random.of_any_size(-1074, 1024)), T(random.of_any_size(-1074, 1024))});
  }
  std::erase_if(points, [](const auto& p) { return !std::isfinite(p[0]) || !std::isfinite(p[1]); });
  return points;
}
TEST(Elementary, Atan2IsWithinItsBound) {
  EXPECT_ULPS(atan2, planar_points<double>(), 1.6, planar_points<float>(), 1.6);
}

// -------------------------------------------------------------------------------------------------- special values
template <class T>
bool same(T a, T b) {
  return std::isnan(a) ? std::isnan(b) : to_bits(a) == to_bits(b);
}

template <class T>
class ElementarySpecials : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ElementarySpecials, Scalars);

/// Where C's libm has an exact answer, ours is the same to the sign of zero.
TYPED_TEST(ElementarySpecials, AreThoseOfC) {
  using T = TypeParam;
  const T inf = T(kInf), nan = T(kNan), zero = T(0), one = T(1);
#define EXPECT_AS_C(name, ...) \
  for (const T& x : {__VA_ARGS__}) EXPECT_TRUE(same<T>(name(x), std::name(x))) << #name "(" << x << ") = " << name(x)
  EXPECT_AS_C(exp, zero, -zero, inf, -inf, nan, T(1e4), T(-1e4));
  EXPECT_AS_C(expm1, zero, -zero, inf, -inf, nan, T(1e4), T(-1e4), T(1e-40), T(-1e-40));
  EXPECT_AS_C(log, zero, -zero, inf, -inf, nan, one, -one);
  EXPECT_AS_C(log1p, zero, -zero, inf, -inf, nan, -one, T(-2), T(1e-40), T(-1e-40));
  EXPECT_AS_C(sin, zero, -zero, inf, -inf, nan, T(1e-30), T(-1e-30));
  EXPECT_AS_C(cos, zero, -zero, inf, -inf, nan, T(1e-30), T(-1e-30));
  EXPECT_AS_C(tan, zero, -zero, inf, -inf, nan, T(1e-30), T(-1e-30));
  EXPECT_AS_C(asin, zero, -zero, inf, -inf, nan, one, -one, T(1.01), T(-1.01));
  EXPECT_AS_C(acos, zero, -zero, inf, -inf, nan, one, -one, T(1.01), T(-1.01));
  EXPECT_AS_C(atan, zero, -zero, inf, -inf, nan);
#undef EXPECT_AS_C
}

TYPED_TEST(ElementarySpecials, OfPowAndAtan2AreThoseOfC) {
  using T = TypeParam;
  const T inf = T(kInf), largest = std::numeric_limits<T>::max(), smallest = std::numeric_limits<T>::denorm_min();
  const T values[] = {0, T(-0.0), 1, -1, inf, -inf, T(kNan), largest, -largest, smallest, -smallest};
  for (const T& a : values) {
    for (const T& b : values) {
      const T exact = T(std::atan2(double(a), double(b)));  // the C float version itself is not always nearest
      EXPECT_TRUE(same<T>(atan2(a, b), exact)) << "atan2(" << a << ", " << b << ") = " << atan2(a, b);
    }
  }
  const T bases[] = {0, T(-0.0), 1, -1, inf, -inf, T(kNan), T(0.5), T(-0.5), 2, -2, largest, -largest};
  const T exponents[] = {0,
                         T(-0.0),
                         1,
                         -1,
                         2,
                         -2,
                         3,
                         -3,
                         T(0.5),
                         T(-0.5),
                         T(2.5),
                         inf,
                         -inf,
                         T(kNan),
                         largest,
                         -largest,
                         16777215,
                         16777216,
                         T(9007199254740991),
                         T(9007199254740992),
                         smallest};
  for (const T& a : bases) {
    for (const T& b : exponents) {
      const T exact = std::pow(a, b), ours = pow(a, b);
      const bool fine = std::isfinite(exact) && exact != 0 ? ulps<T>(ours, exact) <= 1 : same(ours, exact);
      EXPECT_TRUE(fine) << "pow(" << a << ", " << b << ") = " << ours << ", not " << exact;
    }
  }
}

TYPED_TEST(ElementarySpecials, SinAndCosStayInRangeForHugeAngles) {
  using T = TypeParam;
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const T x = T(random.of_any_size(10, sizeof(T) == 8 ? 1023 : 127));
    EXPECT_LE(std::fabs(sin(x)), T(1)) << x;
    EXPECT_LE(std::fabs(cos(x)), T(1)) << x;
  }
}

TYPED_TEST(ElementarySpecials, TanIsHugeAtItsPole) {
  using T = TypeParam;
  EXPECT_EQ(tan(T(0)), T(0));
  EXPECT_GT(std::fabs(tan(T(1.5707963267948966))), T(1e7));
}

// ------------------------------------------------------------------------------------------------------- same bits
/// Any number: every bit pattern, everyday sizes, and the special values.
template <class T>
T any_number(Random& random) {
  const T specials[] = {0,
                        T(-0.0),
                        1,
                        -1,
                        T(kInf),
                        T(-kInf),
                        T(kNan),
                        T(0.5),
                        2,
                        std::numeric_limits<T>::denorm_min(),
                        std::numeric_limits<T>::min(),
                        std::numeric_limits<T>::max(),
                        T(-1e-40),
                        T(1e-310)};
  switch (random.bits() % 8) {
    case 0: return from_bits<T>(static_cast<BitsOf<T>>(random.bits()));
    case 1: return specials[random.bits() % std::size(specials)];
    case 2: return T(random.between(-1, 1));
    case 3: return T(random.between(-800, 800));
    case 4: return T(std::fabs(random.of_any_size(-30, 30)));
    default: return T(random.between(-10, 10));
  }
}

/// Calls check(name, function) for every function, each taking two numbers.
template <class Check>
void for_every_function(Check check) {
  check("exp", [](const auto& x, const auto&) { return exp(x); });
  check("expm1", [](const auto& x, const auto&) { return expm1(x); });
  check("log", [](const auto& x, const auto&) { return log(x); });
  check("log1p", [](const auto& x, const auto&) { return log1p(x); });
  check("pow", [](const auto& x, const auto& y) { return pow(x, y); });
  check("sin", [](const auto& x, const auto&) { return sin(x); });
  check("cos", [](const auto& x, const auto&) { return cos(x); });
  check("sincos", [](const auto& x, const auto&) { return sincos(x).sin - sincos(x).cos; });
  check("tan", [](const auto& x, const auto&) { return tan(x); });
  check("asin", [](const auto& x, const auto&) { return asin(x); });
  check("acos", [](const auto& x, const auto&) { return acos(x); });
  check("atan", [](const auto& x, const auto&) { return atan(x); });
  check("atan2", [](const auto& x, const auto& y) { return atan2(x, y); });
}

template <class P>
void expect_lanes_equal_scalars() {
  using T = ScalarOf<P>;
  for_every_function([](const char* name, auto function) {
    Random random;
    int different = 0;
    for (int i = 0; i < 20000 / kLanes<P>; ++i) {
      P x, y;
      for (int lane = 0; lane < kLanes<P>; ++lane) {
        set_lane(x, lane, any_number<T>(random));
        set_lane(y, lane, any_number<T>(random));
      }
      const P result = function(x, y);
      for (int lane = 0; lane < kLanes<P>; ++lane) {
        const T alone = function(lane_of(x, lane), lane_of(y, lane));
        if (same<T>(lane_of(result, lane), alone)) continue;
        if (++different <= 3) {
          ADD_FAILURE() << name << "(" << lane_of(x, lane) << ", " << lane_of(y, lane)
                        << ") = " << lane_of(result, lane) << " in a pack, " << alone << " alone";
        }
      }
    }
    EXPECT_EQ(different, 0) << name;
  });
}
TEST(Elementary, Pack16DoublesHasTheBitsOfScalars) { expect_lanes_equal_scalars<Pack<double, 16>>(); }
TEST(Elementary, Pack2DoublesHasTheBitsOfScalars) { expect_lanes_equal_scalars<Pack<double, 2>>(); }
TEST(Elementary, Pack32FloatsHasTheBitsOfScalars) { expect_lanes_equal_scalars<Pack<float, 32>>(); }
TEST(Elementary, Pack4FloatsHasTheBitsOfScalars) { expect_lanes_equal_scalars<Pack<float, 4>>(); }

/// FNV-1a over the results for fixed inputs; all NaNs count as one.
template <class T>
std::uint64_t hash_of_results() {
  std::uint64_t hash = 14695981039346656037u;
  for_every_function([&hash](const char*, auto function) {
    Random random;
    for (int i = 0; i < 5000; ++i) {
      const T x = any_number<T>(random), y = any_number<T>(random);
      const T result = function(x, y);
      hash = (hash ^ (std::isnan(result) ? 1u : to_bits(result))) * 1099511628211u;
    }
  });
  return hash;
}
// These numbers change only when a function's results are meant to change, never with compiler, option or machine.
TEST(Elementary, HasTheSameBitsOnEveryPlatform) {
  EXPECT_EQ(hash_of_results<double>(), 18125039072386548304u);
  EXPECT_EQ(hash_of_results<float>(), 3556013968998374446u);
}

}  // namespace physim::math_elementary_test
