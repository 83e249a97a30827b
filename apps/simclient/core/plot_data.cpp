#include "simclient/core/plot_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/stroke.hpp"

namespace physim::client {
namespace {

using S = const TrackSample&;
using T = const Track&;

constexpr PlotQuantity kQuantities[] = {
    {"time", "s", [](T, S s) { return s.time; }},
    {"x", "m", [](T, S s) { return s.position.x; }},
    {"y", "m", [](T, S s) { return s.position.y; }},
    {"z", "m", [](T, S s) { return s.position.z; }},
    {"vx", "m/s", [](T, S s) { return s.velocity.x; }},
    {"vy", "m/s", [](T, S s) { return s.velocity.y; }},
    {"vz", "m/s", [](T, S s) { return s.velocity.z; }},
    {"ax", "m/s\u00b2", [](T, S s) { return s.acceleration.x; }},
    {"ay", "m/s\u00b2", [](T, S s) { return s.acceleration.y; }},
    {"az", "m/s\u00b2", [](T, S s) { return s.acceleration.z; }},
    {"speed", "m/s", [](T, S s) { return length(s.velocity); }},
    {"acceleration", "m/s\u00b2", [](T, S s) { return length(s.acceleration); }},
    {"jx", "m/s\u00b3", [](T, S s) { return s.jerk.x; }},
    {"jy", "m/s\u00b3", [](T, S s) { return s.jerk.y; }},
    {"jz", "m/s\u00b3", [](T, S s) { return s.jerk.z; }},
    {"jerk", "m/s\u00b3", [](T, S s) { return length(s.jerk); }},
    {"mach", "-", [](T, S s) { return s.mach; }},
    {"mass", "kg", [](T, S s) { return s.mass; }},
    {"energy", "J", [](T, S s) { return s.mass * length_squared(s.velocity) / 2; }},
    {"range", "m",
     [](T t, S s) {
       const Vec3d way = s.position - t.samples.front().position;
       return std::hypot(way.x, way.z);
     }},
};

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
};

Result<std::size_t> find_quantity(std::string_view name) {
  std::vector<std::string_view> names;
  for (const PlotQuantity& each : kQuantities) names.push_back(each.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  return Error{"there is no quantity " + in_quotes(name), "plot", suggestion(name, names, "quantities")};
}

std::string label_of(const PlotQuantity& quantity) {
  return std::string(quantity.name) + " [" + std::string(quantity.unit) + "]";
}

/// Removes samples of a curve that a plot on a large screen cannot show.
void leave_out_unseen(PlotCurve& curve, const Extent& across, const Extent& upward) {
  constexpr std::size_t kFew = 800;
  constexpr double kWide = 1600, kHigh = 800;  // [pixels]
  std::vector<PlotPoint>& points = curve.points;
  if (points.size() <= kFew) return;
  const double x = kWide / std::max(across.high - across.low, 1e-300);
  const double y = kHigh / std::max(upward.high - upward.low, 1e-300);
  const auto kept = points_of_stroke(points.size(), [&](std::size_t i) -> std::optional<Pixel> {
    return Pixel{(points[i].x - across.low) * x, (points[i].y - upward.low) * y};
  });
  for (std::size_t i = 0; i < kept.size(); ++i) points[i] = points[kept[i]];
  points.resize(kept.size());
}

/// What the scenario says should come out, where time is below.
std::vector<PlotMark> expected_points(const PlotSpec& spec, std::span<const Track> tracks, const Track* alone,
                                      const Scenario& scenario) {
  std::vector<PlotMark> marks;
  if (kQuantities[spec.x].name != "time") return marks;
  for (const Expectation& e : scenario.expect) {
    if (e.at != ExpectAt::time || e.quantity != kQuantities[spec.y].name) continue;
    const bool is_drawn = std::any_of(tracks.begin(), tracks.end(), [&](const Track& track) {
      return (e.shot.empty() || e.shot == track.name) && (alone == nullptr || alone == &track);
    });
    if (is_drawn) marks.push_back({{e.at_value, e.equals}, e.published});
  }
  return marks;
}

}  // namespace

std::span<const PlotQuantity> plot_quantities() { return kQuantities; }

Result<std::vector<PlotSpec>> parse_plots(std::string_view text) {
  std::vector<PlotSpec> plots;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t slash = word.find('/');
    const Result<std::size_t> y = find_quantity(word.substr(0, slash));
    const Result<std::size_t> x = find_quantity(slash == word.npos ? "time" : word.substr(slash + 1));
    if (!y) return y.error();
    if (!x) return x.error();
    plots.push_back({*y, *x});
  }
  if (plots.empty() || plots.size() > 6) return Error{"one to six plots fit", "plot", "plot y/x speed/time"};
  return plots;
}

PlotAxis make_axis(double low, double high, int wanted) {
  if (!(low <= high)) low = 0, high = 1;
  double room = high - low;
  if (room < 1e-9 * std::max(std::abs(low), std::abs(high)) || room == 0) {  // nothing changes
    const double size = std::max(std::abs(low), 1.0) * 0.5;
    low -= size, high += size, room = high - low;
  }
  PlotAxis axis;
  axis.step = scale_step(room, std::max(wanted, 1));
  axis.low = std::floor(low / axis.step + 1e-9) * axis.step;
  axis.high = std::ceil(high / axis.step - 1e-9) * axis.step;
  return axis;
}

std::vector<double> PlotAxis::ticks() const {
  std::vector<double> all;
  double first = std::ceil(low / step) * step;
  if (first - low > (1 - 1e-6) * step) first = low;  // a round number but for rounding errors
  const auto count = static_cast<int>(std::floor((high - first) / step + 1e-6));
  for (int i = 0; i <= count; ++i) all.push_back(first + i * step);
  return all;
}

std::string PlotAxis::text(double tick) const {
  if (std::abs(tick) < step * 1e-6) tick = 0;
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest >= 1e6 || step < 1e-4) return formatted("%.3g", tick);
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return formatted("%.*f", digits, tick);
}

std::string fitting_text(double value, std::size_t room) {
  for (const int decimals : {3, 2, 1, 0})
    if (std::string text = formatted("%.*f", decimals, value); text.size() <= room) return text;
  for (const int decimals : {3, 2, 1})
    if (std::string text = formatted("%.*e", decimals, value); text.size() <= room) return text;
  return formatted("%.0e", value);
}

Plot make_plot(const PlotSpec& spec, std::span<const Track> tracks, const Track* alone, const Scenario& scenario,
               int wanted_x, int wanted_y) {
  const PlotQuantity &x = kQuantities[spec.x], &y = kQuantities[spec.y];
  Plot plot;
  Extent across, upward;
  for (const Track& track : tracks) {
    if (alone != nullptr && &track != alone) continue;
    PlotCurve curve{&track, {}};
    const auto add = [&](const TrackSample& sample) {
      curve.points.push_back({x.of(track, sample), y.of(track, sample), sample.time});
      across.add(curve.points.back().x), upward.add(curve.points.back().y);
    };
    for (const TrackSample& sample : track.samples) add(sample);
    plot.curves.push_back(std::move(curve));
  }
  for (PlotCurve& curve : plot.curves) leave_out_unseen(curve, across, upward);
  plot.expected = expected_points(spec, tracks, alone, scenario);
  for (const PlotMark& mark : plot.expected) across.add(mark.point.x), upward.add(mark.point.y);
  plot.x = make_axis(across.low, across.high, wanted_x);
  plot.y = make_axis(upward.low, upward.high, wanted_y);
  plot.x.label = label_of(x);
  plot.y.label = label_of(y);
  return plot;
}

std::optional<PlotHit> nearest_point(const Plot& plot, const PlotPoint& place, double aspect, double reach) {
  std::optional<PlotHit> best;
  double nearest = reach;
  for (const PlotCurve& curve : plot.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const PlotPoint &from = curve.points[i > 0 ? i - 1 : 0], &to = curve.points[i];
      const double x = (plot.x.part(from.x) - place.x) * aspect, y = plot.y.part(from.y) - place.y;
      const double to_x = (plot.x.part(to.x) - place.x) * aspect - x, to_y = plot.y.part(to.y) - place.y - y;
      const double size = to_x * to_x + to_y * to_y;
      const double part = size > 0 ? std::clamp(-(x * to_x + y * to_y) / size, 0.0, 1.0) : 1;
      const double away = std::hypot(x + part * to_x, y + part * to_y);
      if (away >= nearest) continue;
      nearest = away;
      best =
          PlotHit{curve.track,
                  {std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part), std::lerp(from.time, to.time, part)}};
    }
  return best;
}

report::Records records_of(std::span<const Track> tracks) {
  report::Records records{{"number", "name"}, [tracks](const auto& take) {
                            std::vector<report::Cell> row;
                            for (const Track& track : tracks)
                              for (const TrackSample& sample : track.samples) {
                                row = {track.number, std::string_view(track.name)};
                                for (const PlotQuantity& q : kQuantities) row.emplace_back(q.of(track, sample));
                                take(row);
                              }
                          }};
  for (const PlotQuantity& q : kQuantities) records.columns.push_back(label_of(q));
  return records;
}

}  // namespace physim::client
