#include "study/moments.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/assert.hpp"

namespace physim {
namespace {

/// Sums up in four lanes, which are added in the end: one addition does not wait for the one before.
template <class Term>
double sum_of(std::size_t count, const Term& term) {
  constexpr std::size_t kLanes = 4;
  double lanes[kLanes] = {};
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] += term(i + lane);
  for (; i < count; ++i) lanes[0] += term(i);
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

}  // namespace

double SampleMoments::product(std::size_t i, std::size_t j) const {
  if (i > j) std::swap(i, j);
  PHYSIM_ASSERT(j < size());
  return products[i * size() - i * (i + 1) / 2 + j];
}

double SampleMoments::covariance(std::size_t i, std::size_t j) const {
  return count < 2 ? 0 : product(i, j) / static_cast<double>(count - 1);
}

double SampleMoments::standard_error(std::size_t i) const {
  if (count < 2) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(covariance(i, i) / static_cast<double>(count));
}

SampleMoments moments_of(std::span<const std::span<const double>> columns) {
  SampleMoments m;
  const std::size_t n = columns.empty() ? 0 : columns[0].size();
  m.count = n;
  const auto divisor = static_cast<double>(n == 0 ? 1 : n);
  for (const auto& column : columns) {
    PHYSIM_ASSERT(column.size() == n);
    m.mean.push_back(sum_of(n, [&](std::size_t i) { return column[i]; }) / divisor);
  }
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = i; j < columns.size(); ++j) {
      const auto &x = columns[i], &y = columns[j];
      const double mean_x = m.mean[i], mean_y = m.mean[j];
      m.products.push_back(sum_of(n, [&](std::size_t shot) { return (x[shot] - mean_x) * (y[shot] - mean_y); }));
    }
  return m;
}

void join(SampleMoments& all, const SampleMoments& more) {
  if (more.count == 0) return;
  if (all.count == 0) {
    all = more;
    return;
  }
  PHYSIM_ASSERT(all.size() == more.size());
  const auto n_a = static_cast<double>(all.count), n_b = static_cast<double>(more.count);
  const double part = n_b / (n_a + n_b);
  std::size_t at = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j, ++at)
      all.products[at] +=
          more.products[at] + (more.mean[i] - all.mean[i]) * (more.mean[j] - all.mean[j]) * (n_a * part);
  for (std::size_t i = 0; i < all.size(); ++i) all.mean[i] += (more.mean[i] - all.mean[i]) * part;
  all.count += more.count;
}

}  // namespace physim
