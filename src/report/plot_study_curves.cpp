// Pictures of studies: hits over inputs and over ranges, and histograms.
#include <algorithm>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/plot_labels.hpp"
#include "report/study_answer.hpp"
#include "report/study_pictures.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr int kCurvesWidth = 1600, kCurvesHeight = 1100;  // [px]

std::string header_of(const std::string& title, const std::string& told) {
  return title_at(0.022, 0.965, title, kCurvesWidth) + text_at(0.022, 0.928, told, 13, kQuiet);
}

/// A row of a block: x, then each target's hit probability with its interval [%].
std::string row_of_hits(double x, const std::vector<HitResult>& hits) {
  std::string row = significant(x, 9);
  for (const HitResult& hit : hits)
    for (const double y : {hit.probability.value, hit.low, hit.high}) row += " " + significant(100 * y, 9);
  return row + "\n";
}

/// Plots such a block: a curve for each target over a band for its interval.
std::string plot_of_hits(const std::string& block, std::size_t targets, const char* mark_size) {
  std::string bands, lines;
  for (std::size_t i = 0; i < targets; ++i) {
    const std::size_t column = 2 + 3 * i;
    const std::string ink(kPalette[i % kPalette.size()]), from = block + " using 1:";
    bands += (bands.empty() ? "plot " : ", ") + from + std::to_string(column + 1) + ":" + std::to_string(column + 2) +
             " with filledcurves lc rgb " + literal("#C0" + ink.substr(1)) + " notitle";
    lines += ", " + from + std::to_string(column) + " with linespoints pt 7 ps " + mark_size +
             curve_style("2.5", i, ink) + " notitle";
  }
  return bands + lines + "\n";
}

// ---------------------------------------------------------------------------------------------------------- over
// inputs
constexpr PixelBox kPanels{.left = 90, .right = 1560, .bottom = 90, .top = 950};  // [px]
constexpr double kAcross = 70, kBetween = 110;                                    // between panels [px]
constexpr std::size_t kMostPanels = 9, kMostCurves = 6;

/// Change of the hit probability of any target over an input.
double change_over(const HitsOverInput& over) {
  PHYSIM_ASSERT(!over.parts.empty());
  double most = 0;
  for (std::size_t target = 0; target < over.parts[0].hits.size(); ++target) {
    Extent seen;
    for (const InputPart& part : over.parts) seen.add(part.hits[target].probability.value);
    most = std::max(most, seen.span());
  }
  return most;
}

class OverInputsPicture {
 public:
  OverInputsPicture(const std::string& title, const FlownStudy& flown) : title_(title), flown_(flown) {
    for (const HitsOverInput& over : flown.result.over_inputs) shown_.push_back(&over);
    std::ranges::stable_sort(
        shown_, [](const HitsOverInput* a, const HitsOverInput* b) { return change_over(*a) > change_over(*b); });
    left_out_ = shown_.size() - std::min(shown_.size(), kMostPanels);
    shown_.resize(shown_.size() - left_out_);
    PHYSIM_ASSERT(!shown_.empty());
  }

  [[nodiscard]] std::string script() const {
    std::string blocks, panels;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      blocks += block(i);
      panels += panel(i) + (i == 0 ? "unset label\n" : "");
    }
    return axes_style() + blocks + "set multiplot\n" + panels + "unset multiplot\n";
  }

 private:
  [[nodiscard]] std::string name_of_block(std::size_t i) const { return "$over" + std::to_string(i); }

  [[nodiscard]] std::string block(std::size_t i) const {
    std::string rows;
    for (const InputPart& part : shown_[i]->parts) rows += row_of_hits(part.middle, part.hits);
    return datablock(name_of_block(i), rows);
  }

  [[nodiscard]] std::string header() const {
    const std::vector<HitResult>& hits = flown_.result.hits;
    std::string out =
        header_of(title_, "hits [%] with their 95 % interval over each input, by " +
                              std::to_string(*flown_.plan.study().over_inputs) +
                              " equally likely parts of it; the others are as uncertain as ever" +
                              (left_out_ > 0 ? "; " + std::to_string(left_out_) + " inputs change less" : ""));
    double x = kPanels.left;
    for (std::size_t target = 0; target < std::min(hits.size(), kMostCurves); ++target) {
      const std::string text = "■ " + shortened(one_line(hits[target].name), 24);
      out += text_at(x / kCurvesWidth, 0.892, text, 13, kPalette[target % kPalette.size()]);
      x += 30 + 10 * static_cast<double>(display_width(text));
    }
    return out;
  }

  [[nodiscard]] std::string panel(std::size_t i) const {
    const PanelGrid grid{shown_.size(), kPanels, kAcross, kBetween, kCurvesWidth, kCurvesHeight};
    const StudyInput& input = flown_.plan.study().inputs[shown_[i]->input];
    Extent x;
    for (const InputPart& part : shown_[i]->parts) x.add(part.middle);
    if (x.span() == 0) x = {x.low - 1, x.high + 1};
    return grid.panel(i) + range_of("x", padded(x)) + range_of("y", {0, 104}) + "set ytics 20\nset xlabel " +
           literal(with_unit(input)) + " offset 0,0.4\n" + (i == 0 ? header() : "") +
           plot_of_hits(name_of_block(i), std::min(flown_.result.hits.size(), kMostCurves), "0.8");
  }

  std::string title_;
  const FlownStudy& flown_;
  std::vector<const HitsOverInput*> shown_;  // those that change hits most first
  std::size_t left_out_ = 0;
};

// ---------------------------------------------------------------------------------------------------------- over
// ranges
constexpr PixelBox kHitsBox{.left = 100, .right = 1370, .bottom = 500, .top = 955};    // [px]
constexpr PixelBox kScatterBox{.left = 100, .right = 1370, .bottom = 85, .top = 430};  // [px]
constexpr const char* kScatterNames[] = {"R95", "CEP", "right ±", "up ±"};             // columns of a row, from 2 on

std::string ranges_panel(const PixelBox& box) {
  return panel_at(box.left / kCurvesWidth, box.right / kCurvesWidth, box.bottom / kCurvesHeight,
                  box.top / kCurvesHeight);
}

class RangesPicture {
 public:
  RangesPicture(const std::string& title, std::span<const StudyAtRange> list) : title_(title), list_(list) {
    PHYSIM_ASSERT(!list.empty());
    for (const StudyAtRange& at : list) ranges_.add(at.range);
    ranges_ = padded(ranges_);
  }

  [[nodiscard]] std::string script() const {
    const std::string begin = axes_style() + blocks() + "set multiplot\n" + range_of("x", ranges_);
    const bool hits = !list_.front().result.hits.empty();
    return begin + (hits ? hits_panel() + "unset label\n" : "") + scatter_panel(!hits) + "unset multiplot\n";
  }

 private:
  [[nodiscard]] std::string blocks() const {
    std::string scatter, hits;
    for (const auto& [range, r, held] : list_) {
      PHYSIM_ASSERT(r.from_centre.has_value());
      scatter += significant(range, 9);
      for (const double x :
           {r.from_centre->r95, r.from_centre->r50, r.quantities[0].deviation, r.quantities[1].deviation})
        scatter += " " + significant(x, 9);
      scatter += "\n";
      hits += row_of_hits(range, r.hits);
    }
    return datablock("$scatter", scatter) + datablock("$hits", hits);
  }

  [[nodiscard]] std::string header() const {
    return header_of(title_, std::to_string(list_.front().result.shots) + " shots at each range");
  }

  /// Names of curves stand at their right ends, moved apart where they would cover each other.
  [[nodiscard]] std::string end_labels(const PixelBox& box, const Extent& y,
                                       const std::vector<std::pair<std::string, double>>& ends) const {
    constexpr double kLine = 22;  // [px]
    std::vector<std::size_t> order(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return ends[a].second > ends[b].second; });
    std::string out;
    double above = box.top + kLine;
    for (const std::size_t i : order) {
      const double at = box.bottom + (ends[i].second - y.low) / y.span() * (box.top - box.bottom);
      above = std::min(at, above - kLine);
      out += text_at((box.right + 12) / kCurvesWidth, above / kCurvesHeight, ends[i].first, 13,
                     kPalette[i % kPalette.size()]);
    }
    return out;
  }

  [[nodiscard]] std::string hits_panel() const {
    const std::vector<HitResult>& last = list_.back().result.hits;
    std::vector<std::pair<std::string, double>> ends;
    for (const HitResult& hit : last)
      ends.emplace_back(hit.name + " " + significant(100 * hit.probability.value, 3) + " %",
                        100 * hit.probability.value);
    const Extent y{0, 104};
    return ranges_panel(kHitsBox) + range_of("y", y) + "unset xlabel\nset ytics 20\n" +
           panel_title("hits [%] with their 95 % interval") + header() + end_labels(kHitsBox, y, ends) +
           plot_of_hits("$hits", last.size(), "1") + "set ytics autofreq\n";
  }

  [[nodiscard]] std::string scatter_panel(bool alone) const {
    PixelBox box = kScatterBox;
    if (alone) box.top = kHitsBox.top;
    Extent y{0, 0};
    std::vector<std::pair<std::string, double>> ends;
    std::string lines;
    for (std::size_t i = 0; i < std::size(kScatterNames); ++i) {
      lines += (i == 0 ? "plot " : ", ") + ("$scatter using 1:" + std::to_string(i + 2)) +
               " with linespoints pt 7 ps 1" + curve_style("2.5", i, kPalette[i]) + " notitle";
      const StudyResult& r = list_.back().result;
      const double values[] = {r.from_centre->r95, r.from_centre->r50, r.quantities[0].deviation,
                               r.quantities[1].deviation};
      ends.emplace_back(std::string(kScatterNames[i]) + " " + readable(values[i], 3) + " m", values[i]);
    }
    for (const auto& [range, r, held] : list_) y.add(r.from_centre->r95), y.add(r.quantities[0].deviation);
    y.high = std::max(1.07 * y.high, 1e-9);
    return ranges_panel(box) + range_of("y", y) + "set xlabel 'range [m]' offset 0,0.4\n" +
           panel_title("how far shots scatter [m]: radii about the mean impact, deviations aside and upwards") +
           (alone ? header() : "") + end_labels(box, y, ends) + lines + "\n";
  }

  std::string title_;
  std::span<const StudyAtRange> list_;
  Extent ranges_;
};

// -----------------------------------------------------------------------------------------------------------
// histograms
constexpr PixelBox kHistogramArea{.left = 90, .right = 1560, .bottom = 90, .top = 950};  // [px]
constexpr double kGapAcross = 80, kGapDown = 130;                                        // between panels [px]
constexpr std::size_t kMostHistograms = 9;

class HistogramsPicture {
 public:
  HistogramsPicture(const std::string& title, const FlownStudy& flown)
      : title_(title), flown_(flown), shown_(histograms_of(flown)) {
    std::erase_if(shown_, [](const NamedHistogram& histogram) { return histogram.bars.empty(); });
    if (shown_.size() > kMostHistograms) shown_.resize(kMostHistograms);
  }

  [[nodiscard]] std::string script() const {
    std::string blocks, panels;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      blocks += datablock("$bars" + std::to_string(i), rows_of(shown_[i]));
      panels += panel(i) + (i == 0 ? "unset label\n" : "");
    }
    return axes_style() + blocks + "set style fill solid 0.75 noborder\nset multiplot\n" + panels + "unset multiplot\n";
  }

 private:
  /// What is drawn: all but bars at the ends of what lies beyond, 0.2 % at most; where few values are drawn there are
  /// none.
  [[nodiscard]] static std::span<const HistogramBar> inner_bars(const NamedHistogram& histogram) {
    std::span<const HistogramBar> bars(histogram.bars);
    const std::uint64_t all = count_of(histogram);
    const auto is_beyond = [&](const HistogramBar& bar) { return bar.count <= all / 500; };
    if (bars.size() > 1 && is_beyond(bars.front())) bars = bars.subspan(1);
    if (bars.size() > 1 && is_beyond(bars.back())) bars = bars.first(bars.size() - 1);
    return bars;
  }
  [[nodiscard]] static std::uint64_t count_of(const NamedHistogram& histogram) {
    std::uint64_t all = 0;
    for (const HistogramBar& bar : histogram.bars) all += bar.count;
    return all;
  }

  /// Shots in a bar as it would be if all were equally wide [%], with its ends.
  [[nodiscard]] static std::string rows_of(const NamedHistogram& histogram) {
    const std::span<const HistogramBar> bars = inner_bars(histogram);
    const double width = (bars.back().high - bars.front().low) / static_cast<double>(bars.size());
    const auto all = static_cast<double>(count_of(histogram));
    std::string rows;
    for (const HistogramBar& bar : bars) {
      const double own = bar.high - bar.low;
      const double part = 100 * static_cast<double>(bar.count) / all * (own > 0 ? width / own : 1);
      rows += shortest(0.5 * (bar.low + bar.high)) + " " + significant(part, 9) + " " + shortest(bar.low) + " " +
              shortest(bar.high) + "\n";
    }
    return rows;
  }

  [[nodiscard]] std::string header() const {
    return header_of(
        title_,
        std::to_string(flown_.result.shots) +
            " shots: parts of those that arrived [%] in bars of one width, without up to 0.2 % beyond each end");
  }

  [[nodiscard]] std::string panel(std::size_t i) const {
    const PanelGrid grid{shown_.size(), kHistogramArea, kGapAcross, kGapDown, kCurvesWidth, kCurvesHeight};
    const std::span<const HistogramBar> bars = inner_bars(shown_[i]);
    const std::string block = "$bars" + std::to_string(i);
    return grid.panel(i) + range_of("x", padded({bars.front().low, bars.back().high})) +
           "set yrange [0:*]\nset xlabel " + literal(shown_[i].name + " [" + shown_[i].unit + "]") + " offset 0,0.4\n" +
           (i == 0 ? header() : "") + "plot " + block + " using 1:($2/2):3:4:(0):2 with boxxyerror lc rgb " +
           literal(kPalette[0]) + " notitle\n";
  }

  std::string title_;
  const FlownStudy& flown_;
  std::vector<NamedHistogram> shown_;
};

}  // namespace

Picture over_inputs_picture(const std::string& title, const FlownStudy& flown) {
  return {kCurvesWidth, kCurvesHeight, OverInputsPicture(title, flown).script()};
}

Picture ranges_picture(const std::string& title, std::span<const StudyAtRange> list) {
  return {kCurvesWidth, kCurvesHeight, RangesPicture(title, list).script()};
}

Picture histograms_picture(const std::string& title, const FlownStudy& flown) {
  return {kCurvesWidth, kCurvesHeight, HistogramsPicture(title, flown).script()};
}

}  // namespace physim::report
