#include "study/cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "study/cell_number.hpp"

namespace physim {
namespace {

constexpr int kDropped = 52 - kCellDigits;  // digits of t that do not matter
constexpr std::uint64_t kOne = std::bit_cast<std::uint64_t>(1.0) >> kDropped;

/// The lower edge of a cell, in scales.
double edge_of(std::int64_t cell) {
  const auto k = static_cast<std::uint64_t>(cell < 0 ? -cell : cell);
  const double distance = std::bit_cast<double>((k + kOne) << kDropped) - 1;
  return cell < 0 ? -distance : distance;
}

/// Makes room for cells from `low` to `high`.
void widen(CountedCells& cells, std::int64_t low, std::int64_t high) {
  PHYSIM_ASSERT(low <= high);
  if (cells.counts.empty()) cells.first = low;
  const std::int64_t last = std::max(high, cells.first + static_cast<std::int64_t>(cells.counts.size()) - 1);
  if (low < cells.first) {
    cells.counts.insert(cells.counts.begin(), static_cast<std::size_t>(cells.first - low), 0);
    cells.first = low;
  }
  cells.counts.resize(static_cast<std::size_t>(last - cells.first + 1));
}

/// Between which the numbers of a cell lie.
std::pair<double, double> ends_of(const CountedCells& cells, std::size_t i) {
  const double low = cells.edge(i), high = cells.edge(i + 1);
  return {std::clamp(cells.least, low, high), std::clamp(cells.most, low, high)};
}

/// Before what they are the ends of is counted.
void take_ends(CountedCells& cells, double least, double most) {
  const bool some = !cells.counts.empty();
  cells.least = some ? std::min(cells.least, least) : least;
  cells.most = some ? std::max(cells.most, most) : most;
}

}  // namespace

void count_into(CountedCells& cells, std::span<const double> numbers) {
  if (!numbers.empty()) count_into(cells, numbers, shard_kernel().least_and_most(numbers.data(), numbers.size()));
}

void count_into(CountedCells& cells, std::span<const double> numbers, const LeastAndMost& ends) {
  PHYSIM_ASSERT(cells.scale > 0 && !numbers.empty());
  const ShardKernel& kernel = shard_kernel();
  take_ends(cells, ends.least, ends.most);
  const double per_scale = 1 / cells.scale;
  const auto cell_of = [&](double x) { return static_cast<std::int64_t>(cell_number((x - cells.centre) * per_scale)); };
  widen(cells, cell_of(ends.least), cell_of(ends.most));
  constexpr std::size_t kAtOnce = 512;
  std::uint64_t cell[kAtOnce];
  std::uint64_t* const counts = cells.counts.data();
  const std::int64_t lowest = cells.first;
  for (std::size_t first = 0; first < numbers.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, numbers.size() - first);
    kernel.cells({numbers.data() + first, cells.centre, per_scale, cell, count});
    for (std::size_t i = 0; i < count; ++i) {
      const auto place = static_cast<std::size_t>(static_cast<std::int64_t>(cell[i]) - lowest);
      PHYSIM_ASSERT(place < cells.counts.size());
      ++counts[place];
    }
  }
}

void join(CountedCells& cells, const CountedCells& others) {
  PHYSIM_ASSERT(cells.centre == others.centre && cells.scale == others.scale);
  if (others.counts.empty()) return;
  take_ends(cells, others.least, others.most);
  widen(cells, others.first, others.first + static_cast<std::int64_t>(others.counts.size()) - 1);
  const auto offset = static_cast<std::size_t>(others.first - cells.first);
  for (std::size_t i = 0; i < others.counts.size(); ++i) cells.counts[offset + i] += others.counts[i];
}

std::uint64_t CountedCells::count() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t n : counts) sum += n;
  return sum;
}

double CountedCells::edge(std::size_t i) const {
  const IeeeMode mode;
  return centre + scale * edge_of(first + static_cast<std::int64_t>(i));
}

double CountedCells::quantile(double p) const {
  const IeeeMode mode;
  const std::uint64_t all = count();
  if (all == 0 || !(p >= 0 && p <= 1)) return std::numeric_limits<double>::quiet_NaN();
  const double wanted = p * static_cast<double>(all);
  double below = 0;
  std::size_t last = 0;  // a cell that has some
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    last = i;
    const auto inside = static_cast<double>(counts[i]);
    if (below + inside >= wanted) {
      const auto [low, high] = ends_of(*this, i);
      return low + (high - low) * std::max(0.0, (wanted - below) / inside);
    }
    below += inside;
  }
  return std::min(edge(last + 1), most);
}

double CountedCells::part_below(double x) const {
  const IeeeMode mode;
  double below = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto [low, high] = ends_of(*this, i);
    if (x <= low) break;
    below += static_cast<double>(counts[i]) * (x >= high ? 1 : (x - low) / (high - low));
  }
  const std::uint64_t all = count();
  return all == 0 || x != x ? std::numeric_limits<double>::quiet_NaN() : below / static_cast<double>(all);
}

std::vector<HistogramBar> CountedCells::histogram(std::size_t bars) const {
  const IeeeMode mode;
  const auto is_counted = [](std::uint64_t n) { return n > 0; };
  const auto some = std::ranges::find_if(counts, is_counted);
  if (some == counts.end()) return {};
  const auto begin = static_cast<std::size_t>(some - counts.begin());
  std::size_t end = counts.size();
  while (!is_counted(counts[end - 1])) --end;
  const auto nearest_edge = [&](double x) {
    std::size_t low = begin, high = end;  // the edge is one of these or lies between
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (edge(middle) <= x ? low : high) = middle;
    }
    return x - edge(low) < edge(high) - x ? low : high;
  };
  const double from = quantile(0.001), to = quantile(0.999);
  const std::size_t inner = std::clamp<std::size_t>(bars, 3, kMostBars) - 2;
  std::vector<std::size_t> ends = {begin};
  const auto end_at = [&](std::size_t edge) {
    if (edge > ends.back()) ends.push_back(edge);
  };
  for (std::size_t i = 0; i <= inner; ++i)
    end_at(nearest_edge(from + (to - from) * (static_cast<double>(i) / static_cast<double>(inner))));
  end_at(end);
  std::vector<HistogramBar> histogram;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    HistogramBar bar{.low = edge(ends[i - 1]), .high = edge(ends[i])};
    for (std::size_t cell = ends[i - 1]; cell < ends[i]; ++cell) bar.count += counts[cell];
    histogram.push_back(bar);
  }
  return histogram;
}

double CountedCells::error_at(double x) const {
  const IeeeMode mode;
  return (scale + std::abs(x - centre)) / 256;
}

}  // namespace physim
