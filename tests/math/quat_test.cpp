// Every operation of Quat, in float and double.
#include "physim/math.hpp"

#include <gtest/gtest.h>

namespace physim::math_quat_test {

constexpr double kPi = 3.141592653589793;

template <class T>
class QuatTest : public testing::Test {
 protected:
  static constexpr double kTolerance = sizeof(T) == 8 ? 1e-15 : 3e-7;

  static void expect_near(const Vec3<T>& a, const Vec3<T>& b) { EXPECT_LE(length(a - b), kTolerance * 4); }
  static void expect_near(const Quat<T>& a, const Quat<T>& b) {
    EXPECT_NEAR(a.w, b.w, kTolerance);
    EXPECT_NEAR(a.x, b.x, kTolerance);
    EXPECT_NEAR(a.y, b.y, kTolerance);
    EXPECT_NEAR(a.z, b.z, kTolerance);
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(QuatTest, Scalars);

TYPED_TEST(QuatTest, StartsAsIdentity) {
  using T = TypeParam;
  const Quat<T> q;
  EXPECT_EQ(q, (Quat<T>{1, 0, 0, 0}));
  EXPECT_EQ(rotate(q, Vec3<T>{1, -2, 3}), (Vec3<T>{1, -2, 3}));
}
TYPED_TEST(QuatTest, MultipliesAsHamiltonDid) {
  using Q = Quat<TypeParam>;
  const Q i{0, 1, 0, 0}, j{0, 0, 1, 0}, k{0, 0, 0, 1}, minus_one{-1, 0, 0, 0};
  EXPECT_EQ(i * i, minus_one);
  EXPECT_EQ(j * j, minus_one);
  EXPECT_EQ(k * k, minus_one);
  EXPECT_EQ(i * j * k, minus_one);
  EXPECT_EQ(i * j, k);
  EXPECT_EQ(j * k, i);
  EXPECT_EQ(k * i, j);
  EXPECT_EQ((Q{1, 2, 3, 4} * Q{5, 6, 7, 8}), (Q{-60, 12, 30, 24}));
}
TYPED_TEST(QuatTest, ConjugateUndoesARotation) {
  using T = TypeParam;
  const Quat<T> q = quat_from_axis_angle<T>({1, 2, -3}, T(0.7));
  EXPECT_EQ(conjugate(Quat<T>{1, 2, 3, 4}), (Quat<T>{1, -2, -3, -4}));
  this->expect_near(q * conjugate(q), Quat<T>{});
  const Vec3<T> v{T(0.3), T(-0.4), T(0.5)};
  this->expect_near(rotate(conjugate(q), rotate(q, v)), v);
}
TYPED_TEST(QuatTest, NormalizesToNormOneAndZeroToIdentity) {
  using T = TypeParam;
  const Quat<T> q{2, 0, 0, 0}, r{1, 5, -5, 7};
  EXPECT_EQ(norm_squared(r), T(100));
  EXPECT_EQ(norm(r), T(10));
  EXPECT_EQ(normalized(q), Quat<T>{});
  this->expect_near(normalized(r), Quat<T>{T(0.1), T(0.5), T(-0.5), T(0.7)});
  EXPECT_EQ(normalized(Quat<T>{0, 0, 0, 0}), Quat<T>{});
}
TYPED_TEST(QuatTest, AQuarterTurnFollowsTheRightHand) {
  using T = TypeParam;
  const Vec3<T> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const T quarter = T(kPi / 2);
  this->expect_near(rotate(quat_from_axis_angle(z, quarter), x), y);
  this->expect_near(rotate(quat_from_axis_angle(x, quarter), y), z);
  this->expect_near(rotate(quat_from_axis_angle(y, quarter), z), x);
  this->expect_near(rotate(quat_from_axis_angle(z * T(5), quarter), x), y);
  this->expect_near(rotate(quat_from_axis_angle(z, -quarter), y), x);
  EXPECT_EQ(quat_from_axis_angle(Vec3<T>{}, quarter), Quat<T>{});
}
TYPED_TEST(QuatTest, ProductsChainRotations) {
  using T = TypeParam;
  const Quat<T> a = quat_from_axis_angle<T>({1, 2, -3}, T(0.7)), b = quat_from_axis_angle<T>({0, -1, 2}, T(-2.1));
  const Vec3<T> v{T(0.3), T(-0.4), T(0.5)};
  this->expect_near(rotate(a * b, v), rotate(a, rotate(b, v)));
}
TYPED_TEST(QuatTest, RotationKeepsLengthsAndAngles) {
  using T = TypeParam;
  const Quat<T> q = quat_from_axis_angle<T>({1, 2, -3}, T(0.7));
  const Vec3<T> u{T(0.3), T(-0.4), T(0.5)}, v{T(0.1), T(0.9), T(-0.2)};
  EXPECT_NEAR(norm(q), 1, this->kTolerance);
  EXPECT_NEAR(length(rotate(q, u)), length(u), this->kTolerance);
  EXPECT_NEAR(dot(rotate(q, u), rotate(q, v)), dot(u, v), this->kTolerance);
}
TYPED_TEST(QuatTest, YawPitchRollTurnTheNoseRightUpAndTheRightSideDown) {
  using T = TypeParam;
  const Vec3<T> forward{1, 0, 0}, up{0, 1, 0}, right{0, 0, 1};
  const T quarter = T(kPi / 2);
  this->expect_near(rotate(quat_from_yaw_pitch_roll<T>(quarter, 0, 0), forward), right);
  this->expect_near(rotate(quat_from_yaw_pitch_roll<T>(0, quarter, 0), forward), up);
  this->expect_near(rotate(quat_from_yaw_pitch_roll<T>(0, 0, quarter), right), -up);
  // Yaw is applied last in the world: a shot at 30 deg elevation, 90 deg to the right.
  const T elevation = T(kPi / 6);
  this->expect_near(rotate(quat_from_yaw_pitch_roll<T>(quarter, elevation, T(1.2)), forward),
                    Vec3<T>{0, T(0.5), T(0.8660254037844386)});
}

}  // namespace physim::math_quat_test
