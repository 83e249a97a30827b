// Distributions against their closed forms: moments by integrals over quantiles, chi-squared and Kolmogorov-Smirnov.
#include "study/distributions.hpp"

#include "math/philox.hpp"
#include "support.hpp"

namespace physim::study_distributions_test {

using test::near;

const std::pair<const char*, Distribution> kAll[] = {
    {"normal", NormalDistribution{800, 3}},
    {"uniform", UniformDistribution{-2, 5}},
    {"triangular", TriangularDistribution{1, 2, 7}},
    {"triangular, peak at the end", TriangularDistribution{1, 7, 7}},
    {"lognormal", LognormalDistribution{2, 0.7}},
    {"truncated", TruncatedNormalDistribution{1, 2, 0, 2.5}},
    {"truncated below", TruncatedNormalDistribution{0, 1, 3, kInfinity}},
    {"truncated above", TruncatedNormalDistribution{0, 1, -kInfinity, -2}},
};

/// By the midpoints of equal parts.
TEST(Distributions, mean_and_variance_are_the_integrals_of_the_quantiles) {
  for (const auto& [name, d] : kAll) {
    const int n = 100'000;
    std::vector<double> x;
    for (int i = 0; i < n; ++i) x.push_back((i + 0.5) / n);
    Quantiles(d).from_units(x);
    double mean = 0, squares = 0;
    for (const double number : x) mean += number / n;
    for (const double number : x) squares += (number - mean) * (number - mean) / n;
    EXPECT_TRUE(near(mean_of(d), mean, 1e-5, 1e-5)) << name;
    EXPECT_TRUE(near(variance_of(d), squares, 5e-4)) << name;
  }
  // so narrow a piece of a bell is level
  EXPECT_NEAR(variance_of(TruncatedNormalDistribution{800, 1e5, 799.5, 800.5}), 1.0 / 12, 1e-9);
  EXPECT_NEAR(mean_of(TruncatedNormalDistribution{800, 1e5, 799.5, 800.5}), 800, 1e-9);
  EXPECT_NEAR(variance_of(TruncatedNormalDistribution{0, 1, -1e-6, 2e-6}), 9e-12 / 12, 1e-18);
  const DiscreteDistribution dice{{6, 1, 2, 3, 4, 5}, {}};
  EXPECT_DOUBLE_EQ(mean_of(dice), 3.5);
  EXPECT_DOUBLE_EQ(variance_of(dice), 35.0 / 12);
  EXPECT_DOUBLE_EQ(mean_of(DiscreteDistribution{{0, 1}, {1, 3}}), 0.75);
}

TEST(Distributions, quantiles_and_probabilities_are_inverse) {
  for (const auto& [name, d] : kAll)
    for (const double p : {1e-9, 1e-3, 0.1, 0.31, 0.5, 0.77, 0.99, 1 - 1e-9})
      EXPECT_TRUE(near(probability_up_to(d, quantile_of(d, p)), p, 1e-6, 1e-12)) << name << ' ' << p;
  EXPECT_EQ(probability_up_to(TruncatedNormalDistribution{0, 1, 1, 2}, 0.5), 0);
  EXPECT_EQ(probability_up_to(TruncatedNormalDistribution{0, 1, 1, 2}, 3), 1);
  EXPECT_EQ(probability_up_to(LognormalDistribution{}, -1), 0);
}

/// Standard figures: 97.5 % of a normal number, e^0 of a lognormal one whose logarithm is standard.
TEST(Distributions, known_quantiles) {
  EXPECT_NEAR(quantile_of(NormalDistribution{}, 0.975), 1.959963984540054, 1e-14);
  const double e = std::exp(1.0);
  const LognormalDistribution standard{std::sqrt(e), std::sqrt((e - 1) * e)};
  EXPECT_NEAR(quantile_of(standard, 0.5), 1, 1e-14);
}

TEST(Distributions, bad_ones_are_refused) {
  const auto place = [](const Distribution& d) {
    const Status status = check(d);
    EXPECT_TRUE(std::isnan(mean_of(d)) == !status);
    return status ? std::string() : status.error().place;
  };
  EXPECT_EQ(place(NormalDistribution{0, 0}), "deviation");
  EXPECT_EQ(place(NormalDistribution{test::kNan, 1}), "mean");
  EXPECT_EQ(place(UniformDistribution{1, 1}), "high");
  EXPECT_EQ(place(UniformDistribution{-1e308, 1e308}), "high");
  EXPECT_EQ(place(TriangularDistribution{0, 2, 1}), "peak");
  EXPECT_EQ(place(LognormalDistribution{-1, 1}), "mean");
  EXPECT_EQ(place(TruncatedNormalDistribution{0, 1, 2, 1}), "high");
  EXPECT_EQ(place(TruncatedNormalDistribution{0, 1, 100, 101}), "low");
  EXPECT_EQ(place(TruncatedNormalDistribution{0, 1, test::kNan, 1}), "high");
  EXPECT_EQ(place(DiscreteDistribution{{}, {}}), "values");
  EXPECT_EQ(place(DiscreteDistribution{{1}, {1, 2}}), "weights");
  EXPECT_EQ(place(DiscreteDistribution{{1, 2}, {0, 0}}), "weights");
  EXPECT_EQ(place(DiscreteDistribution{{1, 2}, {1, -1}}), "weights");
  EXPECT_EQ(place(NormalDistribution{}), "");
  EXPECT_TRUE(std::isnan(quantile_of(NormalDistribution{}, 1)));
}

}  // namespace physim::study_distributions_test
