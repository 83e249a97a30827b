// Every operation of Vec3, in float and double.
#include "physim/math.hpp"

#include <gtest/gtest.h>

namespace physim::math_vec3_test {

template <class T>
class Vec3Test : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Vec3Test, Scalars);

// The components are small integers, so that every result is exact.
TYPED_TEST(Vec3Test, StartsAtZero) {
  const Vec3<TypeParam> v;
  EXPECT_EQ(v, (Vec3<TypeParam>{0, 0, 0}));
}
TYPED_TEST(Vec3Test, ComparesEveryComponent) {
  using V = Vec3<TypeParam>;
  EXPECT_EQ((V{1, 2, 3}), (V{1, 2, 3}));
  EXPECT_NE((V{1, 2, 3}), (V{9, 2, 3}));
  EXPECT_NE((V{1, 2, 3}), (V{1, 9, 3}));
  EXPECT_NE((V{1, 2, 3}), (V{1, 2, 9}));
}
TYPED_TEST(Vec3Test, InvertTurnsItAround) {
  Vec3<TypeParam> v{1, -2, 3};
  v.invert();
  EXPECT_EQ(v, (Vec3<TypeParam>{-1, 2, -3}));
  EXPECT_EQ(-v, (Vec3<TypeParam>{1, -2, 3}));
}
TYPED_TEST(Vec3Test, ClearSetsZero) {
  Vec3<TypeParam> v{1, -2, 3};
  v.clear();
  EXPECT_EQ(v, (Vec3<TypeParam>{0, 0, 0}));
}
TYPED_TEST(Vec3Test, IsScaledByAnyNumber) {
  using V = Vec3<TypeParam>;
  const V v{1, -2, 3};
  const V twice{2, -4, 6};
  EXPECT_EQ(v * 2, twice);
  EXPECT_EQ(2 * v, twice);
  EXPECT_EQ(v * 2u, twice);
  EXPECT_EQ(2.0 * v, twice);
  EXPECT_EQ(v * 2.0f, twice);
}
TYPED_TEST(Vec3Test, HasComponentsByIndex) {
  Vec3<TypeParam> v{1, -2, 3};
  v[1] = 7;
  const Vec3<TypeParam>& seen = v;
  EXPECT_EQ(seen, (Vec3<TypeParam>{1, 7, 3}));
  EXPECT_EQ(seen[0], TypeParam(1));
  EXPECT_EQ(seen[1], TypeParam(7));
  EXPECT_EQ(seen[2], TypeParam(3));
}
TYPED_TEST(Vec3Test, HasLengthAndSquaredLength) {
  const Vec3<TypeParam> v{2, -3, 6};
  EXPECT_EQ(length_squared(v), TypeParam(49));
  EXPECT_EQ(length(v), TypeParam(7));
  EXPECT_EQ(length(Vec3<TypeParam>{}), TypeParam(0));
}
TYPED_TEST(Vec3Test, NormalizesToLengthOne) {
  const Vec3<TypeParam> v = normalized(Vec3<TypeParam>{0, -8, 0});
  EXPECT_EQ(v, (Vec3<TypeParam>{0, -1, 0}));
  Vec3<TypeParam> w{2, -3, 6};
  normalize(w);
  EXPECT_NEAR(length(w), 1, 1e-6);
  EXPECT_NEAR(w.x, 2.0 / 7, 1e-6);
  EXPECT_NEAR(w.y, -3.0 / 7, 1e-6);
  EXPECT_NEAR(w.z, 6.0 / 7, 1e-6);
}
TYPED_TEST(Vec3Test, NormalizingLeavesZeroAlone) {
  Vec3<TypeParam> zero;
  normalize(zero);
  EXPECT_EQ(zero, (Vec3<TypeParam>{0, 0, 0}));
  EXPECT_EQ(normalized(zero), (Vec3<TypeParam>{0, 0, 0}));
}
TYPED_TEST(Vec3Test, ScalesFromBothSides) {
  const Vec3<TypeParam> v{1, -2, 3}, expected{2, -4, 6};
  EXPECT_EQ(v * TypeParam(2), expected);
  EXPECT_EQ(TypeParam(2) * v, expected);
  Vec3<TypeParam> w = v;
  w *= TypeParam(2);
  EXPECT_EQ(w, expected);
}
TYPED_TEST(Vec3Test, AddsAndSubtracts) {
  const Vec3<TypeParam> a{1, -2, 3}, b{10, 20, 30};
  EXPECT_EQ(a + b, (Vec3<TypeParam>{11, 18, 33}));
  EXPECT_EQ(a - b, (Vec3<TypeParam>{-9, -22, -27}));
  Vec3<TypeParam> c = a;
  c += b;
  EXPECT_EQ(c, a + b);
  c -= b;
  EXPECT_EQ(c, a);
}
TYPED_TEST(Vec3Test, AddsScaled) {
  Vec3<TypeParam> v{1, -2, 3};
  v.add_scaled({10, 20, 30}, TypeParam(0.5));
  EXPECT_EQ(v, (Vec3<TypeParam>{6, 8, 18}));
}
TYPED_TEST(Vec3Test, MultipliesByComponentAndDot) {
  const Vec3<TypeParam> a{1, -2, 3}, b{4, 5, 6};
  EXPECT_EQ(component_product(a, b), (Vec3<TypeParam>{4, -10, 18}));
  EXPECT_EQ(dot(a, b), TypeParam(12));
  EXPECT_EQ(dot(a, a), length_squared(a));
}
TYPED_TEST(Vec3Test, CrossProductIsRightHanded) {
  using V = Vec3<TypeParam>;
  const V x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(cross(x, y), z);
  EXPECT_EQ(cross(y, z), x);
  EXPECT_EQ(cross(z, x), y);
  const V a{1, -2, 3}, b{4, 5, 6};
  EXPECT_EQ(cross(a, b), (V{-27, 6, 13}));
  EXPECT_EQ(cross(b, a), -cross(a, b));
  EXPECT_EQ(dot(cross(a, b), a), TypeParam(0));
  EXPECT_EQ(dot(cross(a, b), b), TypeParam(0));
}
TYPED_TEST(Vec3Test, ConvertsBetweenNumberTypes) {
  const Vec3<TypeParam> v{1, -2, 3};
  EXPECT_EQ(vec_cast<float>(v), (Vec3f{1, -2, 3}));
  EXPECT_EQ(vec_cast<double>(v), (Vec3d{1, -2, 3}));
}

}  // namespace physim::math_vec3_test
