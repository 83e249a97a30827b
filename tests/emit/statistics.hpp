// Whether many numbers are distributed as they should be: Kolmogorov's and Pearson's tests, with limits that a right
// sample passes in all but 1 of 10000 cases; seeds are fixed, so one that passes goes on to pass.
// Source: D. E. Knuth, The Art of Computer Programming 2 (1997), sec. 3.3.1; E. B. Wilson, M. M. Hilferty, "The
// distribution of chi-square", PNAS 17 (1931) 684-688.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "emit/emission.hpp"

namespace physim::test {

inline constexpr std::size_t kSamples = 1'000'000;

/// `parts` should lie evenly between 0 and 1: the distribution function of each sample.
inline testing::AssertionResult evenly(std::vector<double> parts) {
  constexpr double kLimit = 2.2252;  // 2 exp(-2 x^2) = 1e-4
  std::sort(parts.begin(), parts.end());
  const double n = static_cast<double>(parts.size());
  double most = parts.front() < 0 || parts.back() > 1 ? 1 : 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double below = static_cast<double>(i) / n;
    most = std::max({most, parts[i] - below, below + 1 / n - parts[i]});
  }
  const double statistic = most * std::sqrt(n);
  if (statistic <= kLimit) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "Kolmogorov's statistic is " << statistic << ", allowed " << kLimit;
}

/// Counts should be as expected; all of these are large.
inline testing::AssertionResult as_expected(const std::vector<double>& counts, const std::vector<double>& expected) {
  double sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] < 20) return testing::AssertionFailure() << "too few are expected in cell " << i;
    sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
  }
  const double freedom = static_cast<double>(counts.size()) - 1, part = 2 / (9 * freedom);
  const double limit = freedom * std::pow(1 - part + 3.719 * std::sqrt(part), 3);
  if (sum <= limit) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "chi squared is " << sum << " with " << freedom << " degrees, allowed "
                                     << limit;
}

/// Points should lie evenly in the unit cube, each coordinate by itself and all of them together.
template <std::size_t N>
testing::AssertionResult evenly_together(const std::vector<std::array<double, N>>& points) {
  constexpr std::size_t kCells = N == 2 ? 30 : 10;
  std::vector<double> counts(N == 2 ? kCells * kCells : kCells * kCells * kCells);
  for (const auto& point : points) {
    std::size_t cell = 0;
    for (const double x : point) {
      if (!(x >= 0 && x <= 1)) return testing::AssertionFailure() << x << " is no part";
      cell = cell * kCells + std::min(static_cast<std::size_t>(x * double(kCells)), kCells - 1);
    }
    ++counts[cell];
  }
  for (std::size_t i = 0; i < N; ++i) {
    std::vector<double> one;
    for (const auto& point : points) one.push_back(point[i]);
    if (auto result = evenly(one); !result) return result << ", of coordinate " << i;
  }
  const double each = static_cast<double>(points.size()) / static_cast<double>(counts.size());
  return as_expected(counts, std::vector<double>(counts.size(), each));
}

/// What one emitter lets out.
inline std::vector<Newborn> newborns(const EmitterDef& def, std::size_t count = kSamples, std::uint64_t seed = 20) {
  const Emission emission(def, seed);
  std::vector<Newborn> all;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) all.push_back(emission.newborn({.number = i}));
  return all;
}

/// The angle of v about the x axis, from y to z, as a part of a whole turn.
inline double turn_of(const Vec3d& v) {
  const double part = std::atan2(v.z, v.y) / (2 * 3.14159265358979323846);
  return part < 0 ? part + 1 : part;
}

/// 4 x (1 - x): PCHIP through three keys is this parabola.
inline Curve parabola() { return {{0, 0}, {0.5, 1}, {1, 0}}; }
/// Its integral from 0.
inline double under_parabola(double x) { return 2 * x * x - 4 * x * x * x / 3; }

}  // namespace physim::test
