// The figures of a study, each under its own name, and its histograms.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/study_answer.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr double kNoError = std::numeric_limits<double>::quiet_NaN();

void add_radius(const char* from, const std::optional<RadiusResult>& radius, std::vector<Figure>& list) {
  if (!radius) return;
  const std::string head = std::string("radius.") + from;
  list.push_back({head + ".mean [m]", radius->mean.value, radius->mean.error});
  list.push_back({head + ".r50 [m]", radius->r50, kNoError});
  list.push_back({head + ".r90 [m]", radius->r90, kNoError});
  list.push_back({head + ".r95 [m]", radius->r95, kNoError});
}

/// Hits over each input: its number and path, then the number of the part. An end that is none is left out.
void add_over_inputs(const FlownStudy& flown, std::vector<Figure>& list) {
  for (const HitsOverInput& over : flown.result.over_inputs) {
    const StudyInput& input = flown.plan.study().inputs[over.input];
    const std::string unit = unit_of(input).empty() ? "" : " [" + unit_of(input) + "]";
    for (std::size_t i = 0; i < over.parts.size(); ++i) {
      const InputPart& part = over.parts[i];
      const std::string head = "over." + std::to_string(over.input + 1) + "." + input.path + (input.added ? "+=" : "") +
                               "." + std::to_string(i + 1);
      if (std::isfinite(part.low)) list.push_back({head + ".from" + unit, part.low, kNoError});
      list.push_back({head + ".middle" + unit, part.middle, kNoError});
      if (std::isfinite(part.high)) list.push_back({head + ".to" + unit, part.high, kNoError});
      list.push_back({head + ".shots", static_cast<double>(part.shots), kNoError});
      for (const HitResult& hit : part.hits) {
        list.push_back({head + ".hit." + hit.name, hit.probability.value, hit.probability.error});
        list.push_back({head + ".hit." + hit.name + ".low", hit.low, kNoError});
        list.push_back({head + ".hit." + hit.name + ".high", hit.high, kNoError});
      }
    }
  }
}

/// The number of a histogram's bar, and its ends.
void add_histograms(const FlownStudy& flown, std::vector<Figure>& list) {
  for (const NamedHistogram& histogram : histograms_of(flown)) {
    const std::string unit = " [" + histogram.unit + "]";
    for (std::size_t i = 0; i < histogram.bars.size(); ++i) {
      const HistogramBar& bar = histogram.bars[i];
      const std::string head = "histogram." + histogram.name + "." + std::to_string(i + 1);
      list.push_back({head + ".from" + unit, bar.low, kNoError});
      list.push_back({head + ".to" + unit, bar.high, kNoError});
      list.push_back({head + ".count", static_cast<double>(bar.count), kNoError});
    }
  }
}

/// All that records have, with that of places behind it, under their names.
std::vector<Figure> all_figures_of(const FlownStudy& flown) {
  std::vector<Figure> list = figures_of(flown);
  add_over_inputs(flown, list);
  add_histograms(flown, list);
  for (std::size_t i = 0; i < flown.at.size(); ++i)
    for (Figure& figure : all_figures_of(flown.at[i])) {
      figure.name = "at." + name_of_place(flown, i) + "." + figure.name;
      list.push_back(std::move(figure));
    }
  return list;
}

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

std::string names_of_inputs(const Study& study, const std::vector<std::size_t>& inputs) {
  std::string text;
  for (const std::size_t input : inputs) {
    PHYSIM_ASSERT(input < study.inputs.size());
    text += (text.empty() ? "" : ", ") + study.inputs[input].path;
  }
  return text;
}

std::vector<Figure> figures_of(const FlownStudy& flown) {
  const StudyResult& r = flown.result;
  const Study& study = flown.plan.study();
  std::vector<Figure> list = {{"shots", static_cast<double>(r.shots), kNoError},
                              {"refused", static_cast<double>(r.refused), kNoError},
                              {"not_arrived", static_cast<double>(r.not_arrived), kNoError}};
  for (const QuantityResult& q : r.quantities) {
    const std::string head(name(q.quantity)), unit = " [" + std::string(unit_of(q.quantity)) + "]";
    list.push_back({head + ".mean" + unit, q.mean.value, q.mean.error});
    list.push_back({head + ".deviation" + unit, q.deviation, kNoError});
    list.push_back({head + ".least" + unit, q.least, kNoError});
    for (const double p : {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99})
      list.push_back({head + ".quantile_" + as_typed(p) + unit, q.cells.quantile(p), kNoError});
    list.push_back({head + ".most" + unit, q.most, kNoError});
  }
  add_radius("aim", r.from_aim, list);
  add_radius("centre", r.from_centre, list);
  add_radius("space", r.in_space, list);
  if (r.ellipse) {
    list.push_back({"ellipse.long_axis [m]", r.ellipse->long_axis, kNoError});
    list.push_back({"ellipse.short_axis [m]", r.ellipse->short_axis, kNoError});
    list.push_back({"ellipse.angle [rad]", r.ellipse->angle, kNoError});
  }
  for (const SpreadResult& s : r.spreads) {
    const std::string head = "extreme_spread." + std::to_string(s.size);
    list.push_back({head + " [m]", s.mean.value, s.mean.error});
    for (const double p : {0.05, 0.5, 0.95})
      list.push_back({head + ".quantile_" + as_typed(p) + " [m]", s.cells.quantile(p), kNoError});
  }
  for (const HitResult& hit : r.hits) {
    list.push_back({"hit." + hit.name, hit.probability.value, hit.probability.error});
    list.push_back({"hit." + hit.name + ".low", hit.low, kNoError});
    list.push_back({"hit." + hit.name + ".high", hit.high, kNoError});
  }
  for (const IndexResult& index : r.indices)
    for (std::size_t q = 0; q < index.first.size(); ++q) {
      const std::string of = std::string(name(r.quantities[q].quantity)) + "." + names_of_inputs(study, index.inputs);
      list.push_back({"index.first." + of, index.first[q].value, index.first[q].error});
      list.push_back({"index.total." + of, index.total[q].value, index.total[q].error});
    }
  return list;
}

Records records_of(const FlownStudy& flown) {
  const auto figures = std::make_shared<const std::vector<Figure>>(all_figures_of(flown));
  return {{"figure", "value", "error"}, [figures](const std::function<void(Row)>& take) {
            for (const Figure& figure : *figures) {
              const Cell cells[] = {std::string_view(figure.name), figure.value, figure.error};
              take(cells);
            }
          }};
}

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

}  // namespace physim::report
