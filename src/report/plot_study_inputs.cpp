#include <algorithm>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/plot_labels.hpp"
#include "report/study_pictures.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr int kInputsWidth = 1600, kInputsHeight = 1100;                          // [px]
constexpr PixelBox kPanels{.left = 90, .right = 1560, .bottom = 90, .top = 950};  // [px]
constexpr double kAcross = 70, kBetween = 110;                                    // between panels [px]
constexpr std::size_t kMostPanels = 9, kMostCurves = 6;

/// How much the hit probability of any target changes over an input.
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

  /// A row of each part: its middle, then each target's probability with its interval.
  [[nodiscard]] std::string block(std::size_t i) const {
    std::string rows;
    for (const InputPart& part : shown_[i]->parts) {
      rows += significant(part.middle, 9);
      for (const HitResult& hit : part.hits)
        for (const double x : {hit.probability.value, hit.low, hit.high}) rows += " " + significant(100 * x, 9);
      rows += "\n";
    }
    return datablock(name_of_block(i), rows);
  }

  [[nodiscard]] std::string header() const {
    const std::vector<HitResult>& hits = flown_.result.hits;
    std::string out = title_at(0.022, 0.965, title_, kInputsWidth) +
                      text_at(0.022, 0.928,
                              "hits [%] with their 95 % interval over each input, by " +
                                  std::to_string(*flown_.plan.study().over_inputs) +
                                  " equally likely parts of it; the others are as uncertain as ever" +
                                  (left_out_ > 0 ? "; " + std::to_string(left_out_) + " inputs change less" : ""),
                              13, kQuiet);
    double x = kPanels.left;
    for (std::size_t target = 0; target < std::min(hits.size(), kMostCurves); ++target) {
      const std::string text = "■ " + shortened(one_line(hits[target].name), 24);
      out += text_at(x / kInputsWidth, 0.892, text, 13, kPalette[target % kPalette.size()]);
      x += 30 + 10 * static_cast<double>(display_width(text));
    }
    return out;
  }

  [[nodiscard]] std::string panel(std::size_t i) const {
    const PanelGrid grid{shown_.size(), kPanels, kAcross, kBetween, kInputsWidth, kInputsHeight};
    const StudyInput& input = flown_.plan.study().inputs[shown_[i]->input];
    Extent x;
    for (const InputPart& part : shown_[i]->parts) x.add(part.middle);
    if (x.span() == 0) x = {x.low - 1, x.high + 1};
    return grid.panel(i) + range_of("x", padded(x)) + range_of("y", {0, 104}) + "set ytics 20\nset xlabel " +
           literal(with_unit(input)) + " offset 0,0.4\n" + (i == 0 ? header() : "") + curves(i) + "\n";
  }

  [[nodiscard]] std::string curves(std::size_t i) const {
    std::string bands, lines;
    for (std::size_t target = 0; target < std::min(flown_.result.hits.size(), kMostCurves); ++target) {
      const std::size_t column = 2 + 3 * target;
      const std::string ink(kPalette[target % kPalette.size()]), from = name_of_block(i) + " using 1:";
      bands += (bands.empty() ? "plot " : ", ") + from + std::to_string(column + 1) + ":" + std::to_string(column + 2) +
               " with filledcurves lc rgb " + literal("#C0" + ink.substr(1)) + " notitle";
      lines += ", " + from + std::to_string(column) + " with linespoints pt 7 ps 0.8" +
               curve_style("2.5", target, ink) + " notitle";
    }
    return bands + lines;
  }

  std::string title_;
  const FlownStudy& flown_;
  std::vector<const HitsOverInput*> shown_;  // those that change hits most first
  std::size_t left_out_ = 0;
};

}  // namespace

Picture over_inputs_picture(const std::string& title, const FlownStudy& flown) {
  return {kInputsWidth, kInputsHeight, OverInputsPicture(title, flown).script()};
}

}  // namespace physim::report
