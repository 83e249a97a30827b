// Sorting what is spread evenly along a line: each goes to the bucket of its place, and is put in order among its
// neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace physim {

/// Sorts a list in the order in which is_before() has them. It has those of lower places before those of higher ones;
/// few that are crowded at some places are sorted as any list is. `spare` is memory that may be used.
template <class T, class PlaceOf, class IsBefore>
void spread_sort(std::vector<T>& list, std::vector<T>& spare, const PlaceOf& place_of, const IsBefore& is_before) {
  constexpr std::size_t kFew = 64, kMostBuckets = 4096, kCrowded = 64;
  const std::size_t buckets = std::min(list.size(), kMostBuckets);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const T& x : list) low = std::min(low, double(place_of(x))), high = std::max(high, double(place_of(x)));
  const double scale = static_cast<double>(buckets - 1) / (high - low);
  if (list.size() < kFew || !(scale > 0 && scale < std::numeric_limits<double>::infinity()))
    return std::ranges::sort(list, is_before), void();
  const auto bucket = [&](const T& x) { return static_cast<std::size_t>((double(place_of(x)) - low) * scale); };
  std::array<std::uint32_t, kMostBuckets> ends{};
  for (const T& x : list) ++ends[bucket(x)];
  std::size_t pairs = 0;
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < buckets; ++i) {
    pairs += std::size_t{ends[i]} * ends[i];
    ends[i] = end += ends[i];
  }
  if (pairs > kCrowded * list.size()) return std::ranges::sort(list, is_before), void();
  spare.resize(list.size());
  for (std::size_t i = list.size(); i > 0; --i) spare[--ends[bucket(list[i - 1])]] = list[i - 1];
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::size_t to = i;
    for (; to > 0 && is_before(spare[i], list[to - 1]); --to) list[to] = list[to - 1];
    list[to] = spare[i];
  }
}

}  // namespace physim
