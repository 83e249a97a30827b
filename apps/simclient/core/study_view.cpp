#include "simclient/core/study_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/angles.hpp"
#include "physim/names.hpp"
#include "report/number.hpp"
#include "report/study_answer.hpp"
#include "report/study_pictures.hpp"
#include "report/table.hpp"

namespace physim::client {
namespace {

constexpr int kCells = 48;
constexpr double kMostStretch = 4;  // beyond it axes have scales of their own

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
  [[nodiscard]] double size() const { return high - low; }
  /// So many times as large about its middle.
  [[nodiscard]] Span times(double factor) const {
    const double middle = 0.5 * (low + high), half = 0.5 * factor * size();
    return {middle - half, middle + half};
  }
};

/// What is drawn: the middle of the impacts, and targets that are not much larger.
struct Seen {
  Span across, up;

  void add(const std::vector<PlanePoint>& points) {
    for (const PlanePoint& p : points) across.add(p.right), up.add(p.up);
  }
  void add_if_near(const std::vector<PlanePoint>& points) {
    constexpr double kMuchLarger = 4;
    Seen with = *this;
    with.add(points);
    if (with.across.size() <= kMuchLarger * across.size() && with.up.size() <= kMuchLarger * up.size()) *this = with;
  }
};

PlotAxis axis_of(const Span& span, int wanted, std::string label) {
  PlotAxis axis = make_axis(span.low, span.high, wanted);
  axis.low = span.low, axis.high = span.high;
  axis.label = std::move(label);
  return axis;
}

/// A span that something has room in, also where all shots end at one place.
Span widened(const Span& span) {
  const double least = 1e-9 * std::max({std::abs(span.low), std::abs(span.high), 1e-3});
  if (span.size() > least) return span.times(1.12);
  return {span.low - 1e3 * least, span.high + 1e3 * least};
}

std::vector<double> shares_of(const CountedCells& cells, const Span& span) {
  std::vector<double> shares;
  for (int i = 0; i < kCells; ++i) {
    const double low = span.low + span.size() * i / kCells, high = span.low + span.size() * (i + 1) / kCells;
    shares.push_back(100 * (cells.part_below(high) - cells.part_below(low)));
  }
  return shares;
}

Span middle_of(const CountedCells& cells) { return {cells.quantile(0.001), cells.quantile(0.999)}; }

/// Where few of all shots come to a place, none may be among the first.
bool none_arrived(const StudyResult& result) { return result.quantities[0].cells.count() == 0; }

StudyFace histogram_of(const StudyResult& result) {
  const QuantityResult& quantity = result.quantities[0];
  StudyFace face;
  if (none_arrived(result)) {
    face.across.label = report::with_unit(quantity.quantity);
    return face;
  }
  const Span span = widened(middle_of(quantity.cells));
  face.cells_across = shares_of(quantity.cells, span);
  face.across = axis_of(span, 6, report::with_unit(quantity.quantity));
  const double most = std::max(*std::ranges::max_element(face.cells_across), 1e-9);
  face.up = axis_of({0, 1.1 * most}, 5, "shots in each cell [%]");
  return face;
}

}  // namespace

StudyFace face_of(const Study& study, const StudyResult& result, double aspect) {
  if (!result.ellipse) return histogram_of(result);
  StudyFace face;
  Seen seen{middle_of(result.quantities[0].cells), middle_of(result.quantities[1].cells)};
  for (const double deviations : {1.0, 2.0, 3.0}) {
    face.ellipses.push_back(report::rim_of(*result.ellipse, deviations));
    seen.add(face.ellipses.back());
  }
  for (const StudyTarget& target : study.targets) {
    face.targets.push_back(report::rim_of(target));
    if (!face.targets.back().empty()) seen.add_if_near(face.targets.back());
  }
  face.aim = study.aim;
  seen.add_if_near({study.aim});
  Span across = widened(seen.across), up = widened(seen.up);
  const double wide = across.size() / aspect, high = up.size();  // of a frame of equal sides
  face.stretch = wide / high;
  if (face.stretch <= kMostStretch && face.stretch >= 1 / kMostStretch) {
    if (wide > high)
      up = up.times(wide / high);
    else
      across = across.times(high / wide);
    face.stretch = 1;
  }
  face.across = axis_of(across, 5, report::with_unit(result.quantities[0].quantity));
  face.up = axis_of(up, 5, report::with_unit(result.quantities[1].quantity));
  face.cells_across = shares_of(result.quantities[0].cells, across);
  face.cells_up = shares_of(result.quantities[1].cells, up);
  return face;
}

std::string lacking_at(const StudyTold& place, const Study& study) {
  const auto is_thing = [](const StudyTarget& target) { return std::holds_alternative<ThingTarget>(target.shape); };
  std::string text;
  const auto say = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (none_arrived(place.result)) say("No shot has come there yet.");
  if (!place.result.from_aim)
    say("It does not begin with two lengths, so it has no plane: shots are shown over " +
        std::string(name(place.study.quantities[0])) + ".");
  if (place.study.targets.empty() && !std::ranges::all_of(study.targets, is_thing))
    say("Targets stand on the plane of the end: none is here.");
  if (std::ranges::any_of(study.targets, is_thing)) say("Things are hit wherever they stand: the end tells of them.");
  return text;
}

// ------------------------------------------------------------------------------------------------ how figures settle
namespace {

constexpr double kNormal95 = 1.959963984540054;  // half of a 95 % interval, in standard errors

/// An interval that is not known is none.
Settling::Point point_of(std::uint64_t shots, double value, double low, double high) {
  const bool known = std::isfinite(low) && std::isfinite(high);
  return {static_cast<double>(shots), value, known ? low : value, known ? high : value};
}

Settling::Point point_of(std::uint64_t shots, const HitResult& hit) {
  return point_of(shots, 100 * hit.probability.value, 100 * hit.low, 100 * hit.high);
}

Settling::Point point_of(std::uint64_t shots, const Estimate& figure) {
  return point_of(shots, figure.value, figure.value - kNormal95 * figure.error,
                  figure.value + kNormal95 * figure.error);
}

void set_axes(Settling& settling, int wanted_ticks) {
  Span values;
  for (const Settling::Point& p : settling.points)
    if (std::isfinite(p.value)) values.add(p.low), values.add(p.high);
  if (!(values.size() >= 0)) values = {0, 1};
  settling.value = axis_of(widened(values), wanted_ticks, settling.label);
  constexpr double kRoom = 1.06;  // for the interval at the end
  const bool is_alone = settling.points.size() == 1;
  settling.shots.low = settling.points.front().shots / (is_alone ? 2 : 1);
  settling.shots.high = settling.points.back().shots * (is_alone ? 2 : kRoom);
}

}  // namespace

double Settling::part(double count) const { return std::log(count / shots.low) / std::log(shots.high / shots.low); }

std::vector<Settling> settling_of(const StudyResult& result, int wanted_ticks) {
  std::vector<Settling> list;
  if (result.stages.empty()) return list;
  const bool has_plane = result.from_aim.has_value();
  if (!result.hits.empty()) {
    Settling hits;
    hits.label = "hits on " + report::one_line(result.hits[0].name) + " [%]";
    for (const StudyStage& stage : result.stages)
      hits.points.push_back(point_of(stage.shots, &stage == &result.stages.back() ? result.hits[0] : stage.hits[0]));
    list.push_back(std::move(hits));
  }
  Settling mean;
  mean.label =
      has_plane ? "mean distance from the aim [m]" : "mean " + report::with_unit(result.quantities[0].quantity);
  for (const StudyStage& stage : result.stages)
    if (std::isfinite(stage.distance.value)) mean.points.push_back(point_of(stage.shots, stage.distance));
  if (!mean.points.empty()) list.push_back(std::move(mean));
  for (Settling& each : list) set_axes(each, wanted_ticks);
  return list;
}

// ------------------------------------------------------------------------------------------------------------ figures
namespace {

/// Six significant digits, or as many decimals as two digits of the error have, whichever is shorter.
std::string within_error(const Estimate& mean) {
  std::string six = report::significant(mean.value, 6);
  if (!(mean.error > 0 && std::isfinite(mean.error))) return six;
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(mean.error))), 0, 9);
  std::string rounded = report::fixed(mean.value, decimals);
  return rounded.size() < six.size() ? rounded : six;
}

}  // namespace

std::vector<StudyFigure> figures_of(const StudyResult& result) {
  using report::significant;
  std::vector<StudyFigure> list = {
      {"shots", std::to_string(result.shots), "in " + std::to_string(result.shards) + " shards"}};
  if (result.not_arrived > 0) list.push_back({"did not arrive", std::to_string(result.not_arrived), ""});
  if (result.refused > 0) list.push_back({"refused", std::to_string(result.refused), result.first_refusal->message});
  for (const HitResult& hit : result.hits)
    list.push_back({"hits on " + report::one_line(hit.name), significant(100 * hit.probability.value, 3) + " %",
                    std::isfinite(hit.low) && std::isfinite(hit.high)
                        ? significant(100 * hit.low, 3) + " .. " + significant(100 * hit.high, 3)
                        : ""});
  if (none_arrived(result)) return list;
  if (result.from_aim) {
    const RadiusResult& r = *result.from_aim;
    list.push_back({"from the aim", significant(r.mean.value, 4) + " m", "\u00b1 " + significant(r.mean.error, 2)});
  }
  if (result.from_centre) {
    const RadiusResult& r = *result.from_centre;
    list.push_back({"CEP", significant(r.r50, 4) + " m", "R90 " + significant(r.r90, 4)});
    list.push_back({"R95", significant(r.r95, 4) + " m", ""});
  }
  for (const QuantityResult& q : result.quantities)
    list.push_back({"mean " + std::string(name(q.quantity)),
                    within_error(q.mean) + " " + std::string(unit_of(q.quantity)),
                    "\u00b1 " + significant(q.mean.error, 2) + ", \u03c3 " + significant(q.deviation, 4)});
  return list;
}

std::vector<StudyInputRow> input_rows(const Study& study, const StudyResult& result, const LinearResult& linear) {
  std::vector<StudyInputRow> list;
  for (const LinearRow& row : linear.rows) {
    const StudyInput& input = study.inputs[row.input];
    const std::string unit = report::unit_of(input);
    StudyInputRow told;
    told.path = input.path;
    const bool is_small_angle = unit == "rad" && row.deviation < 0.5 * kDegree;
    told.deviation = report::significant(is_small_angle  ? 1000 * row.deviation
                                         : unit == "rad" ? row.deviation / kDegree
                                                         : row.deviation,
                                         3) +
                     (unit.empty() || unit == "-" ? ""
                      : is_small_angle            ? " mrad"
                      : unit == "rad"             ? " deg"
                                                  : " " + unit);
    for (std::size_t q = 0; q < std::min<std::size_t>(2, result.quantities.size()); ++q) {
      const std::string of(unit_of(result.quantities[q].quantity));
      const double effect = std::abs(row.effect[q]);
      const bool is_short = of == "m" && effect < 0.01;
      told.effect[q] = report::significant(is_short ? 1000 * effect : effect, 3) + (is_short ? " mm" : " " + of);
      told.share[q] = std::isfinite(row.share[q]) ? row.share[q] : 0;
    }
    list.push_back(std::move(told));
  }
  return list;
}

}  // namespace physim::client
