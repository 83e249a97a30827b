#include <algorithm>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/plot_labels.hpp"
#include "report/study_pictures.hpp"

namespace physim::report {
namespace {

constexpr int kRangesWidth = 1600, kRangesHeight = 1100;                               // [px]
constexpr PixelBox kHitsBox{.left = 100, .right = 1370, .bottom = 500, .top = 955};    // [px]
constexpr PixelBox kScatterBox{.left = 100, .right = 1370, .bottom = 85, .top = 430};  // [px]
constexpr const char* kScatterNames[] = {"R95", "CEP", "right ±", "up ±"};             // columns of a row, from 2 on

std::string ranges_panel(const PixelBox& box) {
  return panel_at(box.left / kRangesWidth, box.right / kRangesWidth, box.bottom / kRangesHeight,
                  box.top / kRangesHeight);
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
      hits += significant(range, 9);
      for (const HitResult& hit : r.hits)
        for (const double x : {hit.probability.value, hit.low, hit.high}) hits += " " + significant(100 * x, 9);
      hits += "\n";
    }
    return datablock("$scatter", scatter) + datablock("$hits", hits);
  }

  [[nodiscard]] std::string header() const {
    return title_at(0.022, 0.965, title_, kRangesWidth) +
           text_at(0.022, 0.928, std::to_string(list_.front().result.shots) + " shots at each range", 13, kQuiet);
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
      out += text_at((box.right + 12) / kRangesWidth, above / kRangesHeight, ends[i].first, 13,
                     kPalette[i % kPalette.size()]);
    }
    return out;
  }

  [[nodiscard]] std::string hits_panel() const {
    const std::vector<HitResult>& last = list_.back().result.hits;
    std::vector<std::pair<std::string, double>> ends;
    std::string bands, lines;
    for (std::size_t i = 0; i < last.size(); ++i) {
      const std::size_t column = 2 + 3 * i;
      const std::string ink(kPalette[i % kPalette.size()]), x = "$hits using 1:" + std::to_string(column);
      const std::string band = "$hits using 1:" + std::to_string(column + 1) + ":" + std::to_string(column + 2);
      bands += (bands.empty() ? "plot " : ", ") + band + " with filledcurves lc rgb " + literal("#C0" + ink.substr(1)) +
               " notitle";
      lines += ", " + x + " with linespoints pt 7 ps 1" + curve_style("2.5", i, ink) + " notitle";
      ends.emplace_back(last[i].name + " " + significant(100 * last[i].probability.value, 3) + " %",
                        100 * last[i].probability.value);
    }
    const Extent y{0, 104};
    return ranges_panel(kHitsBox) + range_of("y", y) + "unset xlabel\nset ytics 20\n" +
           panel_title("hits [%] with their 95 % interval") + header() + end_labels(kHitsBox, y, ends) + bands + lines +
           "\nset ytics autofreq\n";
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

}  // namespace

Picture ranges_picture(const std::string& title, std::span<const StudyAtRange> list) {
  return {kRangesWidth, kRangesHeight, RangesPicture(title, list).script()};
}

}  // namespace physim::report
