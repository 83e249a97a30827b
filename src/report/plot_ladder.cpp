#include <algorithm>
#include <map>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/pictures.hpp"
#include "report/plot_labels.hpp"

namespace physim::report {
namespace {

constexpr int kLadderWidth = 1600, kLadderHeight = 1100;                           // [px]
constexpr PixelBox kPanel{.left = 110, .right = 1570, .bottom = 100, .top = 935};  // [px]

// How a family looks: gnuplot's point type and size, and the same shape as a character for the legend.
struct Look {
  Family family;
  std::string_view colour;
  int mark;
  double size;
  std::string_view glyph;
  int font_size;
  std::string_view legend;
};
constexpr std::array<Look, kFamilies> kLooks = {
    Look{Family::preset, "#0072B2", 7, 2.4, "●", 17, "presets"},
    Look{Family::integrator, "#009E73", 5, 1.1, "■", 14, "integrators of the full simulation, by step or tolerance"},
    Look{Family::effect, "#D55E00", 9, 1.9, "▲", 14, "the full simulation without one effect"}};
constexpr std::string_view kSeriesLine = "#9FD8C7";

const Look& look_of(Family family) {
  const Look& look = kLooks[static_cast<std::size_t>(family)];
  PHYSIM_ASSERT(look.family == family);
  return look;
}

// One logarithmic axis: its ends as powers of ten, and as pixels.
struct LogAxis {
  double low = 0, high = 1;
  double low_pixel = 0, high_pixel = 1;
  [[nodiscard]] double pixel(double value) const {
    PHYSIM_ASSERT(value > 0);
    PHYSIM_ASSERT(high > low);
    return low_pixel + (std::log10(value) - low) / (high - low) * (high_pixel - low_pixel);
  }
};

LogAxis axis_over(const std::vector<double>& values, double room_low, double room_high) {
  if (values.empty()) return {};
  const auto [low, high] = std::ranges::minmax(values);
  return {.low = std::log10(low) - room_low, .high = std::log10(high) + room_high};
}

// "set ytics ('1 mm' 1e-3, ...)": powers of ten in the unit that reads best; on a long axis every third has a text.
std::string tics(const std::string& axis_name, const LogAxis& axis, const std::string& unit) {
  static const std::map<int, std::string> prefixes = {{-15, "f"}, {-12, "p"}, {-9, "n"}, {-6, "µ"},
                                                      {-3, "m"},  {0, ""},    {3, "k"},  {6, "M"}};
  const int every = axis.high - axis.low > 8 ? 3 : 1;
  std::string out;
  for (int power = static_cast<int>(std::ceil(axis.low)); power <= axis.high; ++power) {
    const int group = std::clamp(static_cast<int>(std::floor(power / 3.0)) * 3, -15, 6);
    const std::string text = significant(std::pow(10.0, power - group), 9) + " " + prefixes.at(group) + unit;
    out += (out.empty() ? "" : ", ") + literal(power % every == 0 ? text : "") + " 1e" + std::to_string(power);
  }
  return "set " + axis_name + "tics (" + out + ")\n";
}

std::string range(const std::string& name, const LogAxis& axis) {
  return "set " + name + "range [" + significant(std::pow(10, axis.low), 9) + ":" +
         significant(std::pow(10, axis.high), 9) + "]\n";
}

class LadderPicture {
 public:
  LadderPicture(const std::string& title, const Ladder& ladder) : title_(title), shot_(ladder.shot) {
    std::vector<double> costs, errors;
    for (const RungResult& result : ladder.rungs) {
      if (!(result.error > 0) || !std::isfinite(result.error)) continue;  // the reference, or no error at all
      rungs_.push_back(&result);
      costs.push_back(result.cost);
      errors.push_back(result.error);
    }
    x_ = axis_over(costs, 0.15, 0.5);
    x_.low_pixel = kPanel.left, x_.high_pixel = kPanel.right;
    y_ = axis_over(errors, 0.5, 0.5);
    y_.low_pixel = kPanel.bottom, y_.high_pixel = kPanel.top;
    for (const RungResult* result : rungs_) places_.push_back({x_.pixel(result->cost), y_.pixel(result->error)});
  }

  [[nodiscard]] std::string script() const {
    std::string out = axes_style() +
                      panel_at(kPanel.left / kLadderWidth, kPanel.right / kLadderWidth, kPanel.bottom / kLadderHeight,
                               kPanel.top / kLadderHeight) +
                      "set logscale xy\n" + range("x", x_) + range("y", y_) + tics("x", x_, "s") + tics("y", y_, "m") +
                      "set xlabel 'cost of one flight' font ',16' offset 0,-0.2\n" + header() + labels();
    for (const Look& look : kLooks) out += family_data(look.family);
    return out + series_data() + plot();
  }

 private:
  static std::string block_name(Family family) { return "$" + std::string(family_name(family)); }
  static std::string point(const RungResult& r) { return shortest(r.cost) + " " + shortest(r.error) + "\n"; }

  // Rungs that differ in step or tolerance only are neighbours in the ladder.
  [[nodiscard]] bool continues_series(std::size_t i) const {
    return i > 0 && rungs_[i]->rung.family == Family::integrator &&
           rungs_[i - 1]->rung.series == rungs_[i]->rung.series;
  }

  [[nodiscard]] std::string family_data(Family family) const {
    std::string rows;
    for (const RungResult* r : rungs_)
      if (r->rung.family == family) rows += point(*r);
    return datablock(block_name(family), rows);
  }

  // An empty line parts one series from the next.
  [[nodiscard]] std::string series_data() const {
    std::string rows;
    for (std::size_t i = 0; i < rungs_.size(); ++i)
      if (rungs_[i]->rung.family == Family::integrator) rows += (continues_series(i) ? "" : "\n") + point(*rungs_[i]);
    return datablock("$series", rows);
  }

  [[nodiscard]] bool has(Family family) const {
    return std::ranges::any_of(rungs_, [&](const RungResult* r) { return r->rung.family == family; });
  }

  [[nodiscard]] std::string plot() const {
    std::string out = "plot NaN notitle";  // something to draw where nothing has an error
    if (has(Family::integrator))
      out += ", $series using 1:2 with lines lw 2 lc rgb " + literal(kSeriesLine) + " notitle";
    for (const Look& look : kLooks)
      if (has(look.family))
        out += ", " + block_name(look.family) + " using 1:2 with points pt " + std::to_string(look.mark) + " ps " +
               shortest(look.size) + " lc rgb " + literal(look.colour) + " notitle";
    return out + "\n";
  }

  [[nodiscard]] std::string header() const {
    std::string out = title_at(0.02, 0.967, title_, kLadderWidth);
    out += text_at(0.02, 0.932,
                   shot_ + ": distance from the reference flight (dop853, tolerance " +
                       significant(kReferenceTolerance.relative.value_or(0), 1) +
                       ") over the time that one fly() takes here",
                   14, kQuiet);
    out += text_at(0.02, 0.868, "error at the end of the flight", 14, kInk);
    double x = 0.02;
    for (const Look& look : kLooks) {
      out += text_at(x, 0.903, look.glyph, 15, look.colour) + text_at(x + 0.014, 0.903, look.legend, 14, kInk);
      x += 0.04 + 0.0057 * static_cast<double>(look.legend.size());
    }
    return out;
  }

  // What to write, the most important first: names, then steps and tolerances where there is room.
  [[nodiscard]] std::vector<LabelRequest> wanted_labels() const {
    std::vector<LabelRequest> names, details;
    for (std::size_t i = 0; i < rungs_.size(); ++i) {
      const Rung& rung = rungs_[i]->rung;
      const Look& look = look_of(rung.family);
      const bool ends_series = i + 1 == rungs_.size() || !continues_series(i + 1);
      const bool is_named = rung.family != Family::integrator || ends_series;
      const double size = look.font_size;
      if (is_named) names.push_back({rung.series, look.colour, places_[i], size, rung.family == Family::preset});
      if (!rung.detail.empty()) details.push_back({rung.detail, kQuiet, places_[i], 11, false, true});
    }
    names.insert(names.end(), details.begin(), details.end());
    return names;
  }

  [[nodiscard]] std::string labels() const {
    const std::vector<LabelRequest> requests = wanted_labels();
    std::vector<PixelLine> lines;
    for (std::size_t i = 0; i < rungs_.size(); ++i)
      if (continues_series(i)) lines.emplace_back(places_[i - 1], places_[i]);
    const std::vector<PlacedLabel> placed = place_labels(requests, places_, std::move(lines), kPanel);
    PHYSIM_ASSERT(placed.size() == requests.size());
    std::string out;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const auto& [shown, at, has_leader, end] = placed[i];
      if (!shown) continue;
      const LabelRequest& request = requests[i];
      out += text_at(at.x / kLadderWidth, at.y / kLadderHeight, request.text, static_cast<int>(request.font_size),
                     request.colour, request.bold);
      if (has_leader)
        out += line_at(request.at.x / kLadderWidth, request.at.y / kLadderHeight, end.x / kLadderWidth,
                       end.y / kLadderHeight, " lw 1 lc rgb '#A0A0A0' back");
    }
    return out;
  }

  std::string title_;
  std::string shot_;
  std::vector<const RungResult*> rungs_;
  std::vector<PixelPoint> places_;
  LogAxis x_, y_;
};

}  // namespace

Content ladder_picture(const LadderOfShot& subject) {
  return Picture{kLadderWidth, kLadderHeight, LadderPicture(title_of(subject.scenario), subject.ladder).script()};
}

}  // namespace physim::report
