#include "study/moments.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/assert.hpp"
#include "study/shard_job.hpp"

namespace physim {

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
  const std::size_t size = columns.size(), n = columns.empty() ? 0 : columns[0].size();
  m.count = n;
  m.mean.resize(size), m.products.resize(size * (size + 1) / 2);
  if (n == 0) return m;
  std::vector<const double*> from;
  for (const auto& column : columns) {
    PHYSIM_ASSERT(column.size() == n);
    from.push_back(column.data());
  }
  shard_kernel().moments({from.data(), size, n, m.mean.data(), m.products.data()});
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
