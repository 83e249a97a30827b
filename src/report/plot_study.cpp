#include <algorithm>
#include <cmath>
#include <vector>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "report/number.hpp"
#include "report/plot_labels.hpp"
#include "report/study_pictures.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr int kStudyWidth = 1600, kStudyHeight = 1150;                                   // [px]
constexpr PixelBox kImpactBox{.left = 100, .right = 900, .bottom = 80, .top = 985};      // [px]
constexpr PixelBox kTornadoBox{.left = 1000, .right = 1380, .bottom = 545, .top = 985};  // [px]
constexpr PixelBox kSettlingBox{.left = 1000, .right = 1560, .bottom = 80, .top = 430};  // [px]
constexpr std::size_t kDrawnShots = 4096, kDrawnInputs = 8;
constexpr std::string_view kHitInk = "#0072B2", kMissInk = "#D55E00", kFaceInk = "#F1ECE2", kRimInk = "#8A7F6C";
constexpr std::string_view kTornadoInks[] = {"#0072B2", "#E69F00"};  // of the first quantity and the second

std::string study_panel(const PixelBox& box) {
  return panel_at(box.left / kStudyWidth, box.right / kStudyWidth, box.bottom / kStudyHeight, box.top / kStudyHeight);
}

std::string row_of_numbers(std::initializer_list<double> numbers) {
  std::string row;
  for (const double number : numbers) row += (std::isfinite(number) ? significant(number, 9) : "NaN") + " ";
  return row + "\n";
}

/// Lengths of a plane in the unit that reads best.
struct PlaneUnit {
  double per_unit = 1;
  std::string name;
};
PlaneUnit plane_unit(StudyQuantity a, StudyQuantity b, double span) {
  if (unit_of(a) != "m" || unit_of(b) != "m") return {1, ""};
  if (span < 0.5) return {100, "cm"};
  return span >= 20'000 ? PlaneUnit{1e-3, "km"} : PlaneUnit{1, "m"};
}

/// What impacts are drawn on: the middle of them, and targets and zones that are not much larger.
struct View {
  Extent across, up;

  void add(const std::vector<PlanePoint>& points) {
    for (const PlanePoint& p : points) across.add(p.right), up.add(p.up);
  }
  void add_if_seen(const std::vector<PlanePoint>& points, double most) {
    View with = *this;
    with.add(points);
    if (with.across.span() <= most * across.span() && with.up.span() <= most * up.span()) *this = with;
  }
};

class StudyPicture {
 public:
  StudyPicture(const std::string& title, const FlownStudy& flown)
      : title_(title),
        flown_(flown),
        study_(flown.plan.study()),
        result_(flown.result),
        has_plane_(result_.ellipse.has_value()) {}

  [[nodiscard]] std::string script() const {
    const std::string clear = "unset label\nunset object\nunset logscale\n";
    return axes_style() + "set style textbox opaque noborder fillcolor rgb 'white'\nset multiplot\n" +
           (has_plane_ ? impacts_panel() : histogram_panel()) + clear + tornado_panel() + clear + settling_panel() +
           "unset multiplot\n";
  }

 private:
  [[nodiscard]] const QuantityResult& quantity(std::size_t i) const { return result_.quantities[i]; }

  [[nodiscard]] std::string header() const {
    std::string told = std::to_string(result_.shots) + " shots, " + std::string(name(study_.sampling)) + ", seed " +
                       std::to_string(study_.seed);
    if (result_.not_arrived > 0) told += ", " + std::to_string(result_.not_arrived) + " did not arrive";
    if (result_.from_aim)
      told += "  ·  from the aim: CEP " + readable(result_.from_aim->r50, 3) + " m, R95 " +
              readable(result_.from_aim->r95, 3) + " m";
    for (const HitResult& hit : result_.hits)
      told += "  ·  " + hit.name + " " + significant(100 * hit.probability.value, 3) + " % (" +
              significant(100 * hit.low, 3) + " to " + significant(100 * hit.high, 3) + ")";
    return title_at(0.022, 0.967, title_, kStudyWidth) +
           text_at(0.022, 0.929, shortened(one_line(told), 168), 13, kQuiet);
  }

  // ------------------------------------------------------------------------------------------------------- impacts
  [[nodiscard]] View view() const {
    View seen;
    for (const double p : {0.001, 0.999}) {
      seen.across.add(quantity(0).cells.quantile(p));
      seen.up.add(quantity(1).cells.quantile(p));
    }
    seen.add(rim_of(*result_.ellipse, 3));
    for (const StudyTarget& target : study_.targets) seen.add_if_seen(rim_of(target), 4);
    seen.add_if_seen({study_.aim}, 2);
    if (result_.zone && !study_.until.range) seen.add_if_seen(result_.zone->corners, 3);
    return {padded(seen.across), padded(seen.up)};
  }

  [[nodiscard]] std::string block(const std::string& id, const std::vector<PlanePoint>& points,
                                  const PlaneUnit& unit) const {
    std::string rows;
    for (const PlanePoint& p : points) rows += row_of_numbers({unit.per_unit * p.right, unit.per_unit * p.up});
    return datablock(id, rows.empty() ? "NaN NaN\n" : rows);
  }

  struct Impacts {
    std::vector<PlanePoint> hits, misses;
  };
  [[nodiscard]] Impacts impacts() const {
    const StudyShots shots = fly_shots_of(flown_.plan, 0);
    Impacts found;
    for (std::size_t i = 0; i < std::min(shots.quantities[0].size(), kDrawnShots); ++i) {
      const PlanePoint at{shots.quantities[0][i], shots.quantities[1][i]};
      if (!std::isfinite(at.right) || !std::isfinite(at.up)) continue;
      const bool hit = std::ranges::any_of(shots.hits, [i](const std::vector<bool>& target) { return target[i]; });
      (hit || study_.targets.empty() ? found.hits : found.misses).push_back(at);
    }
    return found;
  }

  /// What colours and lines mean, above the panel's title.
  [[nodiscard]] std::string impacts_legend() const {
    std::vector<std::pair<std::string, std::string_view>> words;
    if (study_.targets.empty()) {
      words = {{"● shots", kHitInk}};
    } else {
      words = {{"● on a target", kHitInk}, {"● beside", kMissInk}};
    }
    words.insert(words.end(), {{"○ 1, 2, 3 deviations", kInk}, {"✚ aim", kInk}});
    if (result_.zone && !study_.until.range)
      words.emplace_back("- - holds " + significant(100 * result_.zone->holds, 6) + " %, 95 % sure", kInk);
    std::string out;
    double x = kImpactBox.left + 10;
    for (const auto& [text, ink] : words) {
      out += text_at(x / kStudyWidth, (kImpactBox.top - 16) / kStudyHeight, text, 12, ink);
      x += 30 + 9 * static_cast<double>(display_width(text));
    }
    return out;
  }

  [[nodiscard]] std::string deviation_labels(const PlaneUnit& unit) const {
    std::string out;
    const EllipseResult& e = *result_.ellipse;
    for (int deviations = 1; deviations <= 3; ++deviations) {
      const double away = deviations * e.long_axis;
      out += "set label '" + std::to_string(deviations) + "σ' at " +
             significant(unit.per_unit * (e.right + away * std::cos(e.angle)), 9) + "," +
             significant(unit.per_unit * (e.up + away * std::sin(e.angle)), 9) +
             " center front boxed font ',11' textcolor rgb " + literal(kInk) + "\n";
    }
    return out;
  }

  [[nodiscard]] std::string impact_curves(const PlaneUnit& unit, std::string& blocks) const {
    const Impacts shots = impacts();
    blocks += block("$hits", shots.hits, unit) + block("$misses", shots.misses, unit);
    std::string plot = "plot ";
    for (std::size_t i = 0; i < study_.targets.size(); ++i) {
      const std::string id = "$target" + std::to_string(i);
      blocks += block(id, rim_of(study_.targets[i]), unit);
      plot += id + " using 1:2 with filledcurves closed fc rgb " + literal(kFaceInk) + " notitle, " + id +
              " using 1:2 with lines lw 2 dt 1 lc rgb " + literal(kRimInk) + " notitle, ";
    }
    const auto dots = [](const char* id, std::string_view ink) {
      return std::string(id) + " using 1:2 with points pt 7 ps 0.4 lc rgb " +
             literal("#70" + std::string(ink.substr(1))) + " notitle";
    };
    plot += dots("$misses", kMissInk) + ", " + dots("$hits", kHitInk);
    for (int deviations = 1; deviations <= 3; ++deviations) {
      const std::string id = "$ellipse" + std::to_string(deviations);
      blocks += block(id, rim_of(*result_.ellipse, deviations), unit);
      plot += ", " + id + " using 1:2 with lines lw 2 dt 1 lc rgb " + literal(kInk) + " notitle";
    }
    if (result_.zone && !study_.until.range) {
      std::vector<PlanePoint> rim = result_.zone->corners;
      rim.push_back(rim.front());
      blocks += block("$zone", rim, unit);
      plot += ", $zone using 1:2 with lines lw 2 dt (10,6) lc rgb " + literal(kInk) + " notitle";
    }
    blocks += block("$aim", {study_.aim}, unit);
    return plot +
           ", $aim using 1:2 with points pt 1 ps 3.4 lw 5 lc rgb 'white' notitle, $aim using 1:2 with points pt 1 "
           "ps 3 lw 2.5 lc rgb " +
           literal(kInk) + " notitle\n";
  }

  [[nodiscard]] std::string impacts_panel() const {
    View seen = view();
    const bool lengths = unit_of(quantity(0).quantity) == "m" && unit_of(quantity(1).quantity) == "m";
    const PlaneUnit unit =
        plane_unit(quantity(0).quantity, quantity(1).quantity, std::max(seen.across.span(), seen.up.span()));
    for (Extent* extent : {&seen.across, &seen.up}) extent->low *= unit.per_unit, extent->high *= unit.per_unit;
    seen.up.high += 0.05 * seen.up.span();  // where the legend stands
    const std::string note =
        lengths ? to_scale(seen.across, seen.up, kImpactBox.right - kImpactBox.left, kImpactBox.top - kImpactBox.bottom,
                           0.5, {"horizontal axis", "vertical axis"})
                : "";
    const auto label = [&](std::size_t i) {
      const std::string unit_name = lengths ? unit.name : std::string(unit_of(quantity(i).quantity));
      return std::string(name(quantity(i).quantity)) + " [" + unit_name + "]";
    };
    std::string blocks;
    const std::string curves = impact_curves(unit, blocks);
    const std::uint64_t drawn = std::min<std::uint64_t>(kDrawnShots, study_.shard_shots);
    return blocks + study_panel(kImpactBox) + range_of("x", seen.across) + range_of("y", seen.up) + "set xlabel " +
           literal(label(0)) + " offset 0,0.4\nset grid xtics ytics\n" +
           panel_title(label(1) + ", the first " + std::to_string(drawn) + " shots" + note) + header() +
           impacts_legend() + deviation_labels(unit) + curves;
  }

  // ----------------------------------------------------------------------------------------------------- histogram
  [[nodiscard]] std::string histogram_panel() const {
    constexpr int kBars = 60;
    const QuantityResult& q = quantity(0);
    const Extent shown = padded({q.cells.quantile(0.0005), q.cells.quantile(0.9995)});
    const double width = shown.span() / kBars;
    std::string rows;
    double most = 0;
    for (int i = 0; i < kBars; ++i) {
      const double low = shown.low + i * width;
      const double part = 100 * (q.cells.part_below(low + width) - q.cells.part_below(low));
      most = std::max(most, part);
      rows += row_of_numbers({low + 0.5 * width, part});
    }
    std::string marks;
    for (const double p : {0.05, 0.5, 0.95}) {
      const std::string x = significant(q.cells.quantile(p), 9);
      marks += "set arrow from first " + x + ", graph 0 to first " + x + ", graph 0.93 nohead lw 2 lc rgb " +
               literal(kInk) + "\nset label " + literal(readable(q.cells.quantile(p), 4)) + " at first " + x +
               ", graph 0.96 center font ',12' textcolor rgb " + literal(kInk) + "\nset label " +
               literal(significant(100 * p, 3) + " %") + " at first " + x +
               ", graph 0.985 center font ',12' textcolor rgb " + literal(kQuiet) + "\n";
    }
    return datablock("$bars", rows) + study_panel(kImpactBox) + range_of("x", shown) +
           range_of("y", {0, 1.15 * std::max(most, 1e-9)}) + "set xlabel " + literal(with_unit(q.quantity)) +
           " offset 0,0.4\nset boxwidth " + significant(0.92 * width, 9) +
           "\nset style fill solid 0.75 noborder\nset grid ytics\n" + panel_title("shots [%] in each of 60 cells") +
           header() + marks + "plot $bars using 1:2 with boxes lc rgb " + literal(kHitInk) + " notitle\nunset arrow\n";
  }

  // ------------------------------------------------------------------------------------------------- what moves them
  [[nodiscard]] std::string input_label(std::size_t input, double deviation) const {
    const StudyInput& in = study_.inputs[input];
    std::string unit;
    if (const auto path = study_path(in.path); path && path->unit != "-") unit = path->unit;
    double shown = deviation;
    if (unit == "rad" && deviation < 0.5 * kDegree) {
      unit = "mrad", shown = 1000 * deviation;
    } else if (unit == "rad") {
      unit = "deg", shown = deviation / kDegree;
    }
    return in.path + "  ± " + significant(shown, 3) + (unit.empty() ? "" : " " + unit) +
           (in.drawn_for == DrawnFor::occasion ? " per occasion" : "");
  }

  [[nodiscard]] std::vector<const LinearRow*> rows_by_share() const {
    std::vector<const LinearRow*> rows;
    for (const LinearRow& row : flown_.linear->rows) rows.push_back(&row);
    const auto weight = [](const LinearRow* row) {
      double most = row->share[0];
      if (row->share.size() > 1) most = std::max(most, row->share[1]);
      return most;
    };
    std::ranges::stable_sort(rows, [&](const auto* a, const auto* b) { return weight(a) > weight(b); });
    return rows;
  }

  [[nodiscard]] std::string tornado_row(const LinearRow& row, double top, std::size_t shown, double full) const {
    std::string out = "set label " + literal(shortened(input_label(row.input, row.deviation), 62)) +
                      " at graph 0, first " + significant(top - 0.2, 6) + " left font ',12' textcolor rgb " +
                      literal(kInk) + "\nset arrow from first 0, first " + significant(top - 0.34, 6) +
                      " to first 0, first " + significant(top - 0.88, 6) + " nohead lw 1 lc rgb " + literal(kQuiet) +
                      "\n";
    for (std::size_t q = 0; q < shown; ++q) {
      if (!(row.share[q] >= 0.0005)) continue;  // nothing to be seen
      const double height = shown == 1 ? 0.5 : 0.25, low = top - 0.36 - height * static_cast<double>(q + 1);
      const double effect = std::min(std::abs(row.effect[q]), full);
      const std::string ink = literal(kTornadoInks[q]);
      out += "set object rectangle from first " + significant(-effect, 9) + ", first " + significant(low + 0.03, 6) +
             " to first " + significant(effect, 9) + ", first " + significant(low + height - 0.03, 6) + " fc rgb " +
             ink + " fillstyle solid noborder\nset label " +
             literal("± " + readable(std::abs(row.effect[q]), 3) + " " + std::string(unit_of(quantity(q).quantity)) +
                     "  " + readable(100 * row.share[q], 2) + " %") +
             " at graph 1.03, first " + significant(low + 0.5 * height, 6) + " left font ',11' textcolor rgb " + ink +
             "\n";
    }
    return out;
  }

  [[nodiscard]] std::string tornado_panel() const {
    const std::string empty = "set border 0\nunset tics\nunset grid\nunset xlabel\n";
    if (!flown_.linear)
      return empty + study_panel(kTornadoBox) + range_of("x", {-1, 1}) + range_of("y", {0, 1}) +
             panel_title("no slopes: a shot near the mean of all inputs does not arrive") + "plot NaN notitle\n";
    const auto rows = rows_by_share();
    const std::size_t shown = std::min<std::size_t>(2, result_.quantities.size());
    const std::size_t count = std::min(rows.size(), kDrawnInputs), slots = std::max<std::size_t>(count, 4);
    double full[2] = {0, 0};
    for (const LinearRow* row : rows)
      for (std::size_t q = 0; q < shown; ++q) full[q] = std::max(full[q], std::abs(row->effect[q]));
    const bool one_unit = shown < 2 || unit_of(quantity(0).quantity) == unit_of(quantity(1).quantity);
    const double most = std::max({one_unit ? std::max(full[0], full[1]) : full[0], 1e-12});
    std::string out = empty + study_panel(kTornadoBox) + range_of("x", {-most, most}) +
                      range_of("y", {0, static_cast<double>(slots)}) +
                      panel_title("a deviation of each input: effect, share");
    for (std::size_t q = 0; q < shown; ++q)
      out += text_at((kTornadoBox.right + 11) / kStudyWidth,
                     (kTornadoBox.top + 20 - 18.0 * static_cast<double>(q)) / kStudyHeight,
                     "■ " + std::string(name(quantity(q).quantity)), 12, kTornadoInks[q]);
    for (std::size_t i = 0; i < count; ++i) out += tornado_row(*rows[i], static_cast<double>(slots - i), shown, most);
    if (rows.size() > count)
      out += "set label " + literal(std::to_string(rows.size() - count) + " more do less") +
             " at graph 0, graph -0.03 left font ',11' textcolor rgb " + literal(kQuiet) + "\n";
    return out + "plot NaN notitle\nunset arrow\n";
  }

  // --------------------------------------------------------------------------------------------- how figures settle
  /// Counts of shots on a logarithmic axis: 1, 2 and 5 times powers of ten, "20 k".
  [[nodiscard]] static std::string shot_tics(const Extent& shown) {
    std::string tics;
    for (double power = 1; power <= shown.high; power *= 10)
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double at = digit * power;
        if (at < shown.low || at > shown.high) continue;
        const auto [size, name] = at >= 1e9   ? std::pair{1e9, " G"}
                                  : at >= 1e6 ? std::pair{1e6, " M"}
                                  : at >= 1e3 ? std::pair{1e3, " k"}
                                              : std::pair{1.0, ""};
        const bool named = digit == 1 || shown.high < 300 * shown.low;
        tics += (tics.empty() ? "" : ", ") + literal(named ? significant(at / size, 3) + name : "") + " " +
                significant(at, 6);
      }
    return "unset mxtics\nset xtics nomirror (" + tics + ")\nset ytics nomirror\n";
  }

  [[nodiscard]] std::string settling_panel() const {
    PHYSIM_ASSERT(!result_.stages.empty());
    const bool hits = !result_.hits.empty();
    std::string rows;
    Extent shown;
    for (const StudyStage& stage : result_.stages) {
      const bool last = &stage == &result_.stages.back();
      double value = stage.distance.value, low = value - 1.96 * stage.distance.error,
             high = value + 1.96 * stage.distance.error;
      if (hits) {
        const HitResult& hit = last ? result_.hits[0] : stage.hits[0];
        value = 100 * hit.probability.value, low = 100 * hit.low, high = 100 * hit.high;
      }
      for (const double y : {value, low, high}) shown.add(y);
      rows += row_of_numbers({static_cast<double>(stage.shots), value, low, high});
    }
    const auto first = static_cast<double>(result_.stages.front().shots);
    const auto last = static_cast<double>(result_.stages.back().shots);
    const std::string what = hits         ? "hits on " + shortened(one_line(result_.hits[0].name), 20) + " [%]"
                             : has_plane_ ? "mean distance from the aim [m]"
                                          : "mean " + with_unit(quantity(0).quantity);
    const std::string settled = datablock("$settling", rows) + axes_style() + study_panel(kSettlingBox);
    const Extent counts = first < last ? Extent{0.93 * first, 1.07 * last} : Extent{0.5 * last, 2 * last};
    return settled + "set logscale x\n" + range_of("x", counts) + shot_tics(counts) +
           range_of("y", padded(shown.or_zero())) + "set xlabel 'shots' offset 0,0.4\n" +
           panel_title(what + ", with the 95 % interval") +
           "plot $settling using 1:3:4 with filledcurves lc rgb '#C8DDEC' notitle, $settling using 1:2 with lines lw "
           "2.5 lc rgb " +
           literal(kHitInk) + " notitle, $settling using 1:2:3:4 every ::" + std::to_string(result_.stages.size() - 1) +
           " with yerrorbars pt 7 ps 1 lw 2 lc rgb " + literal(kInk) + " notitle\n";
  }

  std::string title_;
  const FlownStudy& flown_;
  const Study& study_;
  const StudyResult& result_;
  bool has_plane_;
};

}  // namespace

std::vector<PlanePoint> rim_of(const StudyTarget& target) {
  std::vector<PlanePoint> rim;
  if (const auto* circle = std::get_if<CircleTarget>(&target.shape)) {
    constexpr int kCorners = 96;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * kPi * i / kCorners;
      rim.push_back({circle->centre.right + circle->radius * std::cos(angle),
                     circle->centre.up + circle->radius * std::sin(angle)});
    }
  } else if (const auto* r = std::get_if<RectangleTarget>(&target.shape)) {
    for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      rim.push_back({r->centre.right + x * r->width, r->centre.up + y * r->height});
  } else if (const auto* polygon = std::get_if<PolygonTarget>(&target.shape)) {
    rim = polygon->corners;
  } else {
    return {};  // a thing stands in space
  }
  rim.push_back(rim.front());
  return rim;
}

std::vector<PlanePoint> rim_of(const EllipseResult& ellipse, double deviations) {
  constexpr int kCorners = 180;
  std::vector<PlanePoint> rim;
  const double cosine = std::cos(ellipse.angle), sine = std::sin(ellipse.angle);
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * kPi * i / kCorners;
    const double a = deviations * ellipse.long_axis * std::cos(angle);
    const double b = deviations * ellipse.short_axis * std::sin(angle);
    rim.push_back({ellipse.right + a * cosine - b * sine, ellipse.up + a * sine + b * cosine});
  }
  return rim;
}

Picture study_picture(const std::string& title, const FlownStudy& flown) {
  return {kStudyWidth, kStudyHeight, StudyPicture(title, flown).script()};
}

}  // namespace physim::report
