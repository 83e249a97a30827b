#include <algorithm>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/plot_labels.hpp"
#include "report/study_histograms.hpp"
#include "report/study_pictures.hpp"

namespace physim::report {
namespace {

constexpr int kHistogramsWidth = 1600, kHistogramsHeight = 1100;                         // [px]
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
    return title_at(0.022, 0.965, title_, kHistogramsWidth) +
           text_at(
               0.022, 0.928,
               std::to_string(flown_.result.shots) +
                   " shots: parts of those that arrived [%] in bars of one width, without up to 0.2 % beyond each end",
               13, kQuiet);
  }

  [[nodiscard]] std::string panel(std::size_t i) const {
    const PanelGrid grid{shown_.size(), kHistogramArea, kGapAcross, kGapDown, kHistogramsWidth, kHistogramsHeight};
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

Picture histograms_picture(const std::string& title, const FlownStudy& flown) {
  return {kHistogramsWidth, kHistogramsHeight, HistogramsPicture(title, flown).script()};
}

}  // namespace physim::report
