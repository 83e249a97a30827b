// Evenly spread numbers: chi-squared and Kolmogorov-Smirnov of every distribution under every sampling, equal parts of
// Latin hypercubes, nets of Sobol's sequence, and what each number depends on.
#include "study/sampling.hpp"

#include <set>

#include "study/correlation.hpp"
#include "study/distributions.hpp"
#include "study/sobol.hpp"
#include "support.hpp"

namespace physim::study_sampling_test {

constexpr Sampling kSamplings[] = {Sampling::random, Sampling::latin_hypercube, Sampling::sobol};

std::vector<double> numbers_of(Sampling sampling, unsigned dimension, std::size_t count, std::uint64_t seed = 7) {
  std::vector<double> all(count);
  constexpr std::size_t kShard = 1024;
  for (std::size_t shard = 0; shard * kShard < count; ++shard)
    Sampler{sampling, seed}.fill(dimension, shard, std::span(all).subspan(shard * kShard, kShard));
  return all;
}

const std::pair<const char*, Distribution> kContinuous[] = {
    {"normal", NormalDistribution{800, 3}},
    {"uniform", UniformDistribution{-2, 5}},
    {"triangular", TriangularDistribution{1, 2, 7}},
    {"lognormal", LognormalDistribution{2, 0.7}},
    {"truncated", TruncatedNormalDistribution{1, 2, 0, 2.5}},
    {"far truncated", TruncatedNormalDistribution{0, 1, 5, kInfinity}}};

/// Kolmogorov: the largest distance of random numbers from their distribution is above 1.95 / sqrt(n) once in 1000.
TEST(Sampling, numbers_follow_their_distributions) {
  for (const auto& [what, distribution] : kContinuous)
    for (const Sampling sampling : kSamplings) {
      std::vector<double> x = numbers_of(sampling, 3, 16384);
      Quantiles(distribution).from_units(x);
      std::ranges::sort(x);
      double most = 0;
      const auto n = static_cast<double>(x.size());
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double p = probability_up_to(distribution, x[i]);
        most = std::max({most, p - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - p});
      }
      const bool by_chance = sampling == Sampling::random;
      EXPECT_GT(most, by_chance ? 0.3 / std::sqrt(n) : 0) << what << ": more even than chance";
      EXPECT_LT(most, (by_chance ? 1.95 : 0.1) / std::sqrt(n)) << what << ' ' << name(sampling);
    }
}

/// Chi-squared of 63 degrees of freedom lies between 34 and 104 but once in 1000.
TEST(Sampling, pairs_of_dimensions_fill_the_square) {
  for (const Sampling sampling : kSamplings)
    for (const unsigned other : {1u, 2u, 40u}) {
      const std::vector<double> a = numbers_of(sampling, 0, 16384), b = numbers_of(sampling, other, 16384);
      double counts[64] = {}, chi = 0;
      for (std::size_t i = 0; i < a.size(); ++i) ++counts[static_cast<int>(a[i] * 8) * 8 + static_cast<int>(b[i] * 8)];
      for (const double n : counts) chi += (n - 256) * (n - 256) / 256;
      EXPECT_LT(chi, 104) << name(sampling) << other;
      EXPECT_GE(chi, sampling == Sampling::random ? 34 : 0) << other;
    }
}

TEST(Sampling, discrete_values_come_as_often_as_they_weigh) {
  std::vector<double> x = numbers_of(Sampling::random, 0, 65536);
  Quantiles(DiscreteDistribution{{3, 1, 2, 9}, {4, 1, 2, 0}}).from_units(x);
  const auto part = [&](double value) {
    return static_cast<double>(std::ranges::count(x, value)) / static_cast<double>(x.size());
  };
  const double error = 4 * std::sqrt(0.25 / 65536);
  EXPECT_NEAR(part(3), 4.0 / 7, error);
  EXPECT_NEAR(part(1), 1.0 / 7, error);
  EXPECT_NEAR(part(2), 2.0 / 7, error);
  EXPECT_EQ(part(9), 0);
}

TEST(Sampling, a_number_depends_on_seed_dimension_and_shot_alone) {
  for (const Sampling sampling : kSamplings) {
    const std::vector<double> all = numbers_of(sampling, 5, 4096);
    std::vector<double> third(1024);
    Sampler{sampling, 7}.fill(5, 2, third);
    EXPECT_TRUE(std::equal(third.begin(), third.end(), all.begin() + 2048)) << name(sampling);
    EXPECT_NE(numbers_of(sampling, 5, 1024, 8)[0], all[0]) << name(sampling);
    EXPECT_NE(numbers_of(sampling, 6, 1024)[0], all[0]) << name(sampling);
    for (const double u : all) EXPECT_TRUE(u > 0 && u < 1);
  }
}

TEST(Sampling, latin_hypercubes_have_one_shot_in_each_part) {
  const std::vector<double> x = numbers_of(Sampling::latin_hypercube, 1, 2048);
  for (std::size_t shard = 0; shard < 2; ++shard) {
    std::set<int> parts;
    for (std::size_t i = 0; i < 1024; ++i) parts.insert(static_cast<int>(x[shard * 1024 + i] * 1024));
    EXPECT_EQ(parts.size(), 1024U);
  }
  EXPECT_NE(static_cast<int>(x[0] * 1024), static_cast<int>(x[1024] * 1024)) << "a permutation of its own";
}

/// Of 2^k points from a multiple of it on, each of 2^k equal parts has one, in every dimension and after scrambling.
TEST(Sobol, every_dimension_is_a_net) {
  for (unsigned dimension = 0; dimension < kSobolDimensions; ++dimension)
    for (const bool scrambled : {false, true}) {
      const SobolDimension d = scrambled ? scrambled_dimension(3, dimension, 5) : sobol_dimension(dimension);
      std::vector<double> x(256);
      fill_sobol(d, 512, x);
      std::set<int> parts;
      for (const double u : x) parts.insert(static_cast<int>(u * 256));
      EXPECT_EQ(parts.size(), 256U) << dimension;
    }
}

/// Joe and Kuo's first ten points in three dimensions, as their program prints them.
TEST(Sobol, the_published_points) {
  const double points[10][3] = {{0, 0, 0},
                                {0.5, 0.5, 0.5},
                                {0.75, 0.25, 0.25},
                                {0.25, 0.75, 0.75},
                                {0.375, 0.375, 0.625},
                                {0.875, 0.875, 0.125},
                                {0.625, 0.125, 0.875},
                                {0.125, 0.625, 0.375},
                                {0.1875, 0.3125, 0.9375},
                                {0.6875, 0.8125, 0.4375}};
  for (unsigned dimension = 0; dimension < 3; ++dimension) {
    std::vector<double> x(10);
    fill_sobol(sobol_dimension(dimension), 0, x);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(x[i], points[i][dimension], 1e-15) << i << ' ' << dimension;
  }
}

/// Two dimensions of 2^k points: a box of 2^-a by 2^-b has 2^(k - a - b) of them, where k - a - b is the net's t or
/// more. Joe and Kuo chose theirs so that t is small in pairs; the first two dimensions have t = 0.
TEST(Sobol, scrambling_keeps_the_net_of_two_dimensions) {
  std::vector<double> x(64), y(64);
  for (const std::uint32_t replicate : {0u, 1u}) {
    fill_sobol(scrambled_dimension(1, 0, replicate), 64, x);
    fill_sobol(scrambled_dimension(1, 1, replicate), 64, y);
    for (int a = 0; a <= 6; ++a) {
      std::set<int> boxes;
      for (std::size_t i = 0; i < 64; ++i)
        boxes.insert(static_cast<int>(x[i] * (1 << a)) * 64 + static_cast<int>(y[i] * (1 << (6 - a))));
      EXPECT_EQ(boxes.size(), 64U) << a;
    }
  }
}

TEST(Correlation, drawn_numbers_have_the_correlations_asked_for) {
  const std::vector<double> matrix{1, 0.8, -0.3, 0.8, 1, 0.1, -0.3, 0.1, 1};
  const std::vector<std::string> names{"a", "b", "c"};
  const auto root = must(correlation_root(matrix, names, "here"));
  std::vector<std::vector<double>> x;
  for (unsigned i = 0; i < 3; ++i) {
    x.push_back(numbers_of(Sampling::random, i, 65536));
    Quantiles(NormalDistribution{}).from_units(x.back());
  }
  const std::vector<std::span<double>> columns(x.begin(), x.end());
  correlate(root, columns);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t s = 0; s < x[i].size(); ++s) sum += x[i][s] * x[j][s];
      const double c = matrix[i * 3 + j];
      EXPECT_NEAR(sum / 65536, c, 4 * std::sqrt((1 + c * c) / 65536)) << i << j;
    }
}

TEST(Correlation, what_is_none_is_refused_by_its_entries) {
  const std::vector<std::string> names{"speed", "mass", "wind"};
  const auto refusal = [&](const std::vector<double>& matrix) {
    const auto root = correlation_root(matrix, names, "matrix");
    return root ? "" : root.error().text();
  };
  EXPECT_NE(refusal({1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1}).find("wind with speed = 0.9"), std::string::npos);
  EXPECT_NE(refusal({1, 1, 0, 1, 1, 0, 0, 0, 1}).find("mass with speed = 1"), std::string::npos);
  EXPECT_NE(refusal({1, 0.5, 0, 0.4, 1, 0, 0, 0, 1}).find("the other way round 0.4"), std::string::npos);
  EXPECT_NE(refusal({1, 2, 0, 2, 1, 0, 0, 0, 1}).find("not between -1 and 1"), std::string::npos);
  EXPECT_NE(refusal({2, 0, 0, 0, 1, 0, 0, 0, 1}).find("speed with speed is 2"), std::string::npos);
  EXPECT_NE(refusal({1, 0, 0, 1}).find("4 numbers for 3 inputs"), std::string::npos);
  EXPECT_NE(refusal({1, test::kNan, 0, test::kNan, 1, 0, 0, 0, 1}).find("not between"), std::string::npos);
}

}  // namespace physim::study_sampling_test
