#include "report/study_histograms.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr double kMostMarks = 50;  // of the highest bar

/// As many in a unit of the quantity: bars at the ends are wider than others.
double density(const HistogramBar& bar) {
  PHYSIM_ASSERT(bar.high >= bar.low);
  return bar.high > bar.low ? static_cast<double>(bar.count) / (bar.high - bar.low) : 0;
}

/// The number of digits at which ends of bars differ, however narrow bars are beside their numbers.
int digits_of_ends(std::span<const HistogramBar> bars) {
  constexpr int kLeast = 5, kMost = 17;
  double digits = kLeast;
  for (const HistogramBar& bar : bars) {
    const double number = std::max(std::abs(bar.low), std::abs(bar.high)), width = bar.high - bar.low;
    if (width > 0) digits = std::max(digits, std::ceil(std::log10(number / width)) + 2);
  }
  return static_cast<int>(std::min<double>(digits, kMost));
}

}  // namespace

std::vector<NamedHistogram> histograms_of(const FlownStudy& flown) {
  std::vector<NamedHistogram> list;
  if (flown.histogram_bars == 0) return list;
  const StudyResult& r = flown.result;
  const auto add = [&](const std::string& name, std::string_view unit, const CountedCells& cells) {
    list.push_back({name, std::string(unit), cells.histogram(flown.histogram_bars)});
  };
  for (const QuantityResult& q : r.quantities) add(std::string(name(q.quantity)), unit_of(q.quantity), q.cells);
  if (r.from_aim) add("radius.aim", "m", r.from_aim->cells);
  if (r.from_centre) add("radius.centre", "m", r.from_centre->cells);
  if (r.in_space) add("radius.space", "m", r.in_space->cells);
  for (const SpreadResult& spread : r.spreads) add("extreme_spread." + std::to_string(spread.size), "m", spread.cells);
  return list;
}

std::string histograms_text(const FlownStudy& flown) {
  std::string text;
  const std::vector<NamedHistogram> list = histograms_of(flown);
  for (std::size_t i = 0; i < std::min(list.size(), flown.result.quantities.size()); ++i) {
    Table table({list[i].name + " from [" + list[i].unit + "]", "to", "shots [%]", ""}, "rrrl");
    const int digits = digits_of_ends(list[i].bars);
    double all = 0, most = 0;
    for (const HistogramBar& bar : list[i].bars)
      all += static_cast<double>(bar.count), most = std::max(most, density(bar));
    for (const HistogramBar& bar : list[i].bars) {
      const double marks = most > 0 ? kMostMarks * density(bar) / most : kMostMarks;
      table.add_row({significant(bar.low, digits), significant(bar.high, digits),
                     significant(100 * static_cast<double>(bar.count) / all, 3),
                     std::string(static_cast<std::size_t>(std::lround(marks)), '#')});
    }
    text += table.text(2) + "\n";
  }
  return text;
}

nlohmann::ordered_json histograms_json(const FlownStudy& flown) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const NamedHistogram& histogram : histograms_of(flown)) {
    nlohmann::ordered_json low = nlohmann::ordered_json::array(), high = low, count = low;
    for (const HistogramBar& bar : histogram.bars)
      low.push_back(bar.low), high.push_back(bar.high), count.push_back(bar.count);
    list.push_back({{"name", histogram.name},
                    {"unit", histogram.unit},
                    {"low", std::move(low)},
                    {"high", std::move(high)},
                    {"count", std::move(count)}});
  }
  return list;
}

}  // namespace physim::report
