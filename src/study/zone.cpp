#include "study/zone.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"

namespace physim {
namespace {

PlanePoint direction_of_edge(std::size_t k) {
  PHYSIM_ASSERT(k <= kZoneDirections);
  const double angle = 2 * kPi * static_cast<double>(k) / kZoneDirections;
  return {cos(angle), sin(angle)};
}

/// How far numbers reach along a direction. In lanes: none waits for the largest of the others.
double farthest(const PlanePoint& n, std::span<const double> right, std::span<const double> up) {
  PHYSIM_ASSERT(!right.empty() && right.size() == up.size());
  constexpr std::size_t kLanes = 8;
  const auto along = [&](std::size_t i) { return n.right * right[i] + n.up * up[i]; };
  const auto larger = [](double a, double b) { return a > b ? a : b; };
  double most[kLanes];
  std::fill(most, most + kLanes, along(0));
  std::size_t i = 1;
  for (; i + kLanes <= right.size(); i += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) most[lane] = larger(along(i + lane), most[lane]);
  for (; i < right.size(); ++i) most[0] = larger(along(i), most[0]);
  return *std::max_element(most, most + kLanes);
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
  std::vector<double> reach;
  for (std::size_t k = 0; k < kZoneDirections && !right.empty(); ++k)
    reach.push_back(farthest(direction_of_edge(k), right, up));
  return reach;
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
