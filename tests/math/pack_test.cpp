// Every operation of Pack, lane by lane against plain numbers.
#include "math/lane_bits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace physim::math_pack_test {

template <class P>
class PackTest : public testing::Test {
 protected:
  using Lane = ScalarOf<P>;
  static constexpr int kWidth = kLanes<P>;

  /// Packs of everyday and special numbers, the same in every run.
  static std::vector<P> packs() {
    const Lane inf = std::numeric_limits<Lane>::infinity(), nan = std::numeric_limits<Lane>::quiet_NaN();
    const Lane specials[] = {0,
                             Lane(-0.0),
                             1,
                             -1,
                             Lane(0.5),
                             Lane(-2.5),
                             inf,
                             -inf,
                             nan,
                             std::numeric_limits<Lane>::denorm_min(),
                             std::numeric_limits<Lane>::max()};
    std::mt19937_64 random(7);
    std::vector<P> result(20);
    for (P& p : result) {
      for (int lane = 0; lane < kWidth; ++lane) {
        const Lane everyday = Lane(static_cast<std::int64_t>(random() % 4001) - 2000) / 16;
        set_lane(p, lane, random() % 3 == 0 ? specials[random() % std::size(specials)] : everyday);
      }
    }
    return result;
  }
  static bool same(Lane a, Lane b) { return std::isnan(a) ? std::isnan(b) : to_bits(a) == to_bits(b); }

  /// pack_operation(a, b) has in every lane what lane_operation has of the lanes of a and b.
  template <class OnPacks, class OnLanes>
  static void expect_lanes(const char* what, OnPacks on_packs, OnLanes on_lanes) {
    for (const P& a : packs()) {
      for (const P& b : packs()) {
        const auto result = on_packs(a, b);
        for (int lane = 0; lane < kWidth; ++lane) {
          const auto expected = on_lanes(a[lane], b[lane]);
          if constexpr (std::is_same_v<decltype(expected), const bool>) {
            ASSERT_EQ(lane_of(result, lane), expected) << what << ' ' << a[lane] << ' ' << b[lane];
          } else {
            ASSERT_TRUE(same(result[lane], expected))
                << what << ' ' << a[lane] << ' ' << b[lane] << ": " << result[lane] << ", not " << expected;
          }
        }
      }
    }
  }
  /// The same expression on packs and on lanes.
  template <class Operation>
  static void expect_lanes(const char* what, Operation operation) {
    expect_lanes(what, operation, operation);
  }
};
using Packs = testing::Types<Pack<float, 4>, Pack<float, 16>, Pack<float, 32>, Pack<double, 2>, Pack<double, 8>,
                             Pack<double, 16>>;
TYPED_TEST_SUITE(PackTest, Packs);

TYPED_TEST(PackTest, HoldsItsLanes) {
  using T = ScalarOf<TypeParam>;
  constexpr int kN = kLanes<TypeParam>;
  static_assert(sizeof(TypeParam) == kN * sizeof(T));
  T numbers[kN], copy[kN];
  for (int lane = 0; lane < kN; ++lane) numbers[lane] = T(lane) - T(0.5);
  TypeParam p = TypeParam::load(numbers);
  for (int lane = 0; lane < kN; ++lane) EXPECT_EQ(p[lane], numbers[lane]);
  set_lane(p, kN - 1, T(42));
  EXPECT_EQ(lane_of(p, kN - 1), T(42));
  p.store(copy);
  EXPECT_EQ(copy[0], T(-0.5));
  EXPECT_EQ(copy[kN - 1], T(42));
  const TypeParam minus_zero(T(-0.0)), third = constant<TypeParam>(1.0 / 3);
  for (int lane = 0; lane < kN; ++lane) {
    EXPECT_TRUE(std::signbit(minus_zero[lane]));
    EXPECT_EQ(third[lane], T(1.0 / 3));
  }
}
TYPED_TEST(PackTest, DoesArithmetic) {
  using T = ScalarOf<TypeParam>;
  this->expect_lanes("a + b", [](const auto& a, const auto& b) { return a + b; });
  this->expect_lanes("a - b", [](const auto& a, const auto& b) { return a - b; });
  this->expect_lanes("a * b", [](const auto& a, const auto& b) { return a * b; });
  this->expect_lanes("a / b", [](const auto& a, const auto& b) { return a / b; });
  this->expect_lanes("-a", [](const auto& a, const auto&) { return -a; });
  this->expect_lanes("a + 2", [](const auto& a, const auto&) { return a + T(2); });
  this->expect_lanes("2 - a", [](const auto& a, const auto&) { return T(2) - a; });
  this->expect_lanes("a * 3", [](const auto& a, const auto&) { return a * T(3); });
  this->expect_lanes("1 / a", [](const auto& a, const auto&) { return T(1) / a; });
  this->expect_lanes("sqrt", [](const auto& a, const auto&) { return sqrt(a); });
  this->expect_lanes("+= -= *= /=", [](auto a, const auto& b) {
    a += b;
    a *= b;
    a -= b;
    a /= b;
    return a;
  });
}
TYPED_TEST(PackTest, Compares) {
  using T = ScalarOf<TypeParam>;
  this->expect_lanes("a < b", [](const auto& a, const auto& b) { return a < b; });
  this->expect_lanes("a <= b", [](const auto& a, const auto& b) { return a <= b; });
  this->expect_lanes("a > b", [](const auto& a, const auto& b) { return a > b; });
  this->expect_lanes("a >= b", [](const auto& a, const auto& b) { return a >= b; });
  this->expect_lanes("a == b", [](const auto& a, const auto& b) { return a == b; });
  this->expect_lanes("a != b", [](const auto& a, const auto& b) { return a != b; });
  this->expect_lanes("a < 1", [](const auto& a, const auto&) { return a < T(1); });
  this->expect_lanes("a >= 1", [](const auto& a, const auto&) { return a >= T(1); });
  this->expect_lanes("is_finite", [](const auto& a, const auto&) { return is_finite(a); });
}
TYPED_TEST(PackTest, TellsLanesByBits) {
  for (const TypeParam& a : this->packs()) {
    for (const TypeParam& b : this->packs()) {
      const unsigned below = lane_bits(a < b), at_least = lanes_at_least(a, b), at_most = lanes_at_most(a, b);
      EXPECT_EQ(std::uint64_t(below | at_least | at_most) >> this->kWidth, 0u);
      for (int lane = 0; lane < this->kWidth; ++lane) {
        const auto x = lane_of(a, lane), y = lane_of(b, lane);
        EXPECT_EQ(below >> lane & 1u, x < y ? 1u : 0u) << x << ' ' << y;
        EXPECT_EQ(at_least >> lane & 1u, x >= y ? 1u : 0u) << x << ' ' << y;
        EXPECT_EQ(at_most >> lane & 1u, x <= y ? 1u : 0u) << x << ' ' << y;
      }
    }
  }
}

TYPED_TEST(PackTest, BecomesLanesOfAnotherType) {
  using T = ScalarOf<TypeParam>;
  using Other = std::conditional_t<sizeof(T) == 8, float, double>;
  for (const TypeParam& a : this->packs()) {
    const TypeParam third = a / T(3);  // not every number of it is a float
    const Cast<Other, TypeParam> there = cast<Other>(third);
    const TypeParam back = cast<T>(there);
    const auto mask = cast_mask<Other, TypeParam>(third < T(0));
    for (int lane = 0; lane < kLanes<TypeParam>; ++lane) {
      const Other expected = static_cast<Other>(third[lane]);
      ASSERT_TRUE(std::isnan(expected) ? std::isnan(there[lane]) : to_bits(there[lane]) == to_bits(expected)) << lane;
      ASSERT_TRUE(this->same(back[lane], static_cast<T>(expected))) << lane;
      ASSERT_EQ(mask[lane], third[lane] < T(0)) << lane;
    }
  }
}

TYPED_TEST(PackTest, MakesMasksOfBits) {
  EXPECT_EQ(kAllLanes<TypeParam>, lane_bits(TypeParam(0) == TypeParam(0)));
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const unsigned bits = static_cast<unsigned>(random()) & kAllLanes<TypeParam>;
    EXPECT_EQ(lane_bits(mask_of_lanes<TypeParam>(bits)), bits);
    EXPECT_EQ(lane_bits(mask_of_lanes<TypeParam>(bits | ~kAllLanes<TypeParam>)), bits) << "others do not count";
  }
}

TYPED_TEST(PackTest, CombinesMasks) {
  using T = ScalarOf<TypeParam>;
  this->expect_lanes(
      "and", [](const auto& a, const auto& b) { return (a < b) & (a > T(0)); },
      [](T a, T b) { return a < b && a > 0; });
  this->expect_lanes(
      "or", [](const auto& a, const auto& b) { return (a < b) | (a > T(0)); }, [](T a, T b) { return a < b || a > 0; });
  this->expect_lanes("not", [](const auto& a, const auto& b) { return !(a < b); });
}
TYPED_TEST(PackTest, Selects) {
  this->expect_lanes("select", [](const auto& a, const auto& b) { return select(a < b, a, b); });
  this->expect_lanes("min", [](const auto& a, const auto& b) { return min(a, b); });
  this->expect_lanes("max", [](const auto& a, const auto& b) { return max(a, b); });
  this->expect_lanes("clamp", [](const auto& a, const auto&) {
    using R = std::decay_t<decltype(a)>;
    return clamp(a, constant<R>(-3), constant<R>(5));
  });
}
TYPED_TEST(PackTest, WorksOnSigns) {
  using T = ScalarOf<TypeParam>;
  this->expect_lanes(
      "abs", [](const auto& a, const auto&) { return abs(a); }, [](T a, T) { return std::fabs(a); });
  this->expect_lanes(
      "copysign", [](const auto& a, const auto& b) { return copysign(a, b); },
      [](T a, T b) { return std::isnan(b) ? copysign(a, b) : std::copysign(a, b); });
}
TYPED_TEST(PackTest, RoundsSmallNumbers) {
  using T = ScalarOf<TypeParam>;
  const auto small = [](const auto& a) {
    using R = std::decay_t<decltype(a)>;
    return clamp(a, constant<R>(-1000), constant<R>(1000));
  };
  this->expect_lanes(
      "round_to_int", [&](const auto& a, const auto&) { return round_to_int(small(a)); },
      [&](T a, T) { return std::nearbyint(small(a)) + T(0); });
  this->expect_lanes(
      "floor_small", [&](const auto& a, const auto&) { return floor_small(small(a)); },
      [&](T a, T) { return std::floor(small(a)) + T(0); });
}
TYPED_TEST(PackTest, KnowsAnyAndAll) {
  using T = ScalarOf<TypeParam>;
  constexpr int kN = kLanes<TypeParam>;
  const TypeParam zero(T(0)), one(T(1));
  EXPECT_FALSE(any(one < zero));
  EXPECT_FALSE(all(one < zero));
  EXPECT_TRUE(any(zero < one));
  EXPECT_TRUE(all(zero < one));
  for (int lane = 0; lane < kN; ++lane) {  // a single lane counts, wherever it is
    TypeParam p = zero;
    set_lane(p, lane, T(1));
    EXPECT_TRUE(any(p == one)) << lane;
    EXPECT_EQ(all(p == one), kN == 1) << lane;
    EXPECT_FALSE(all(p == zero)) << lane;
    EXPECT_TRUE(lane_of(p == one, lane));
  }
}
TYPED_TEST(PackTest, WorksOnBits) {
  using U = BitsOf<ScalarOf<TypeParam>>;
  for (const TypeParam& a : this->packs()) {
    const BitsOf<TypeParam> bits = to_bits(a), mask(U(0x00ff00ff));
    const TypeParam back = from_bits<TypeParam>(bits);
    for (int lane = 0; lane < kLanes<TypeParam>; ++lane) {
      const U u = to_bits(a[lane]);
      ASSERT_EQ(bits[lane], u);
      ASSERT_EQ(to_bits(back[lane]), u);
      ASSERT_EQ((bits & mask)[lane], u & U(0x00ff00ff));
      ASSERT_EQ((bits | mask)[lane], u | U(0x00ff00ff));
      ASSERT_EQ((bits ^ mask)[lane], u ^ U(0x00ff00ff));
      ASSERT_EQ((bits << 5)[lane], u << 5);
      ASSERT_EQ((bits >> 5)[lane], u >> 5);
      ASSERT_EQ((bits + mask)[lane], u + U(0x00ff00ff));
      ASSERT_EQ((bits - mask)[lane], u - U(0x00ff00ff));
    }
  }
}

}  // namespace physim::math_pack_test
