#include "study/zone.hpp"

#include <iterator>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "study/shard_job.hpp"

namespace physim {
namespace {

PlanePoint direction_of_edge(std::size_t k) {
  PHYSIM_ASSERT(k <= kZoneDirections);
  const double angle = 2 * kPi * static_cast<double>(k) / kZoneDirections;
  return {cos(angle), sin(angle)};
}

/// The chance of fewer than K of what comes lambda times on average.
double fewer_than_directions(double lambda) {
  double term = exp(-lambda), sum = 0;
  for (std::size_t i = 0; i < kZoneDirections; ++i) {
    sum += term;
    term *= lambda / static_cast<double>(i + 1);
  }
  return sum;
}

}  // namespace

std::vector<double> reach_of(std::span<const double> right, std::span<const double> up) {
  PHYSIM_ASSERT(right.size() == up.size());
  static_assert(ReachJob::kDirections == kZoneDirections);
  if (right.empty()) return {};
  ReachJob job{.right = right.data(), .up = up.data(), .count = right.size()};
  for (std::size_t k = 0; k < kZoneDirections; ++k) {
    const PlanePoint along = direction_of_edge(k);
    job.to_right[k] = along.right, job.to_up[k] = along.up;
  }
  shard_kernel().reach(job);
  return {std::begin(job.reach), std::end(job.reach)};
}

std::optional<ZoneResult> zone_of(std::span<const double> reach, std::uint64_t shots) {
  ZoneResult zone;
  double low = kZoneDirections, high = 100;
  for (int i = 0; i < 60; ++i)
    (fewer_than_directions(0.5 * (low + high)) > 1 - zone.confidence ? low : high) = 0.5 * (low + high);
  if (reach.empty() || static_cast<double>(shots) <= high) return std::nullopt;
  PHYSIM_ASSERT(reach.size() == kZoneDirections);
  zone.holds = 1 - high / static_cast<double>(shots);
  const double across = sin(2 * kPi / kZoneDirections);
  for (std::size_t k = 0; k < kZoneDirections; ++k) {  // where the edges k and k + 1 meet
    const PlanePoint a = direction_of_edge(k), b = direction_of_edge(k + 1);
    const double h = reach[k], g = reach[(k + 1) % kZoneDirections];
    zone.corners.push_back({(h * b.up - g * a.up) / across, (g * a.right - h * b.right) / across});
  }
  return zone;
}

}  // namespace physim
