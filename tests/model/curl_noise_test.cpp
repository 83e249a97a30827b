// Curl noise: no sources, its strength, seeds, sizes and times.
#include "model/curl_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "math/vec3.hpp"
#include "random_shots.hpp"

namespace physim::model_curl_noise_test {

using Seeds = std::array<std::uint32_t, CurlNoise::kMostOctaves>;
constexpr Seeds kSeeds{11, 22, 33, 44, 55, 66, 77, 88};

CurlNoise noise(double size = 1, double rate = 0, std::uint32_t octaves = 1, double gain = 0.5) {
  return {kSeeds, size, rate, octaves, gain};
}

double divergence(const CurlNoise& field, const Vec3d& x, double time, double h) {
  const auto along = [&](const Vec3d& d) {
    return (field.at(x + d * h, time) - field.at(x - d * h, time)) * (0.5 / h);
  };
  return along({1, 0, 0}).x + along({0, 1, 0}).y + along({0, 0, 1}).z;
}

TEST(CurlNoise, has_no_sources) {
  test::Random r(1);
  const CurlNoise field = noise(0.7, 0.3, 3, 0.6);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d x = r.vector(30);
    const double time = r.in(0, 10);
    ASSERT_NEAR(divergence(field, x, time, 1e-5), 0, 3e-7) << i;  // of parts of the order of 10
  }
}

TEST(CurlNoise, has_a_mean_square_of_one_that_is_equal_along_all_axes) {
  for (const std::uint32_t octaves : {1u, 4u}) {
    test::Random r(2);
    const CurlNoise field = noise(2, 0.25, octaves, 0.7);
    const int n = 400'000;
    Vec3d square{};
    for (int i = 0; i < n; ++i) {
      const Vec3d w = field.at(r.vector(4000), r.in(0, 50));
      square += Vec3d{w.x * w.x, w.y * w.y, w.z * w.z} * (1.0 / n);
    }
    EXPECT_NEAR(square.x + square.y + square.z, 1, 0.005) << octaves;
    EXPECT_NEAR(square.x, 1.0 / 3, 0.004) << octaves;
    EXPECT_NEAR(square.y, 1.0 / 3, 0.004) << octaves;
  }
}

TEST(CurlNoise, is_continuous_across_its_cells) {
  const CurlNoise field = noise(1, 0.5, 2);
  test::Random r(3);
  for (int i = 0; i < 500; ++i) {
    Vec3d x = r.vector(20);
    (i % 3 == 0 ? x.x : i % 3 == 1 ? x.y : x.z) = r.below(20) - 10;
    const Vec3d d{1e-9, 1e-9, 1e-9};
    ASSERT_LT(length(field.at(x + d, 1) - field.at(x - d, 1)), 1e-6) << i;
  }
}

TEST(CurlNoise, follows_its_seed) {
  Seeds other = kSeeds;
  other[0] = 12;
  const Vec3d x{0.3, 0.4, 0.6};
  EXPECT_EQ(noise().at(x, 0), noise().at(x, 0));
  EXPECT_NE(noise().at(x, 0), CurlNoise(other, 1, 0, 1, 0.5).at(x, 0));
  EXPECT_EQ(noise().at(x, 0), CurlNoise({11}, 1, 0, 1, 0.5).at(x, 0)) << "of an octave that is not there none counts";
  EXPECT_NE(noise(1, 0, 2).at(x, 0), CurlNoise({11}, 1, 0, 2, 0.5).at(x, 0));
}

TEST(CurlNoise, is_as_large_as_its_cells) {
  const Vec3d x{0.31, -7.4, 3.6};
  EXPECT_EQ(noise(4).at(x * 4, 0), noise(1).at(x, 0));
  EXPECT_EQ(noise(1, 0, 2, 0).at(x, 0), noise(1).at(x, 0));
  // Two cells apart nothing is shared: neither gathers a mean.
  test::Random r(4);
  double same = 0, far = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Vec3d at = r.vector(1000), w = noise().at(at, 0);
    same += dot(w, noise().at(at + Vec3d{0.05, 0, 0}, 0)) / 100'000,
        far += dot(w, noise().at(at + Vec3d{2.5, 0, 0}, 0)) / 100'000;
  }
  EXPECT_GT(same, 0.95);
  EXPECT_NEAR(far, 0, 0.01);
}

TEST(CurlNoise, comes_again_after_its_period) {
  const CurlNoise field = noise(1, 0.4, 3);
  const Vec3d x{1.3, 2.4, -0.6};
  EXPECT_LT(length(field.at(x, 0.7) - field.at(x, 0.7 + 2.5)), 1e-13);
  EXPECT_LT(length(field.at(x, 0.7) - field.at(x, 0.7 - 5)), 1e-13);
  EXPECT_GT(length(field.at(x, 0.7) - field.at(x, 0.7 + 1.1)), 0.1);
  EXPECT_EQ(noise(1, 0).at(x, 3), noise(1, 0).at(x, 17)) << "without a rate it stays as it is";
}

TEST(CurlNoise, of_places_that_are_none_is_nothing_that_spreads) {
  const double nan = std::nan("");
  EXPECT_EQ(noise().at({nan, 0, 0}, 0), (Vec3d{}));
  EXPECT_EQ(noise().at({0, 1e300, 0}, 0), (Vec3d{}));
  EXPECT_LT(length(noise().at({-9e14, 9e14, 0.5}, 1e9)), 10);
}

}  // namespace physim::model_curl_noise_test
