// Plots as numbers: what can be drawn over what, axes that read well, and the nearest point to the mouse.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physim/result.hpp"
#include "report/records.hpp"
#include "scenario/scenario.hpp"
#include "simclient/core/track.hpp"

namespace physim::client {

/// Something that a projectile has at every moment.
struct PlotQuantity {
  std::string_view name, unit;
  double (*of)(const Track& track, const TrackSample& sample);
};

[[nodiscard]] std::span<const PlotQuantity> plot_quantities();

/// One plot: a quantity over another.
struct PlotSpec {
  std::size_t y = 2, x = 0;  // indices in plot_quantities()

  bool operator==(const PlotSpec&) const = default;
};

/// "y/x speed/time": any number of plots; time is what stands under a quantity that has nothing under it.
[[nodiscard]] Result<std::vector<PlotSpec>> parse_plots(std::string_view text);

struct PlotPoint {
  double x = 0, y = 0;
  double time = 0;  // since the launch of its projectile [s]
};

/// The curve of one projectile.
struct PlotCurve {
  const Track* track = nullptr;
  std::vector<PlotPoint> points;
};

/// A point that the scenario says should come out.
struct PlotMark {
  PlotPoint point;
  bool published = false;  ///< drawn as a ring; else as a cross
};

struct PlotAxis {
  double low = 0, high = 1, step = 0.2;
  std::string label;  // "speed [m/s]"

  [[nodiscard]] double part(double value) const { return (value - low) / (high - low); }
  [[nodiscard]] std::vector<double> ticks() const;
  [[nodiscard]] std::string text(double tick) const;
};

/// An axis with round numbers around all values, with about `wanted` of them.
[[nodiscard]] PlotAxis make_axis(double low, double high, int wanted);

struct Plot {
  std::vector<PlotCurve> curves;
  std::vector<PlotMark> expected;
  PlotAxis x, y;
};

/// A number in so many characters: with three decimals, with fewer where they do not fit, or with an exponent.
[[nodiscard]] std::string fitting_text(double value, std::size_t room);

/// The curves of all projectiles, or of one alone.
[[nodiscard]] Plot make_plot(const PlotSpec& spec, std::span<const Track> tracks, const Track* alone,
                             const Scenario& scenario, int wanted_x, int wanted_y);

/// The point of a plot nearest to a place in it; both axes count from 0 to 1, `aspect` is width over height.
struct PlotHit {
  const Track* track = nullptr;
  PlotPoint point;
};
[[nodiscard]] std::optional<PlotHit> nearest_point(const Plot& plot, const PlotPoint& place, double aspect,
                                                   double reach);

/// A row for each sample of each projectile, with all quantities as columns.
[[nodiscard]] report::Records records_of(std::span<const Track> tracks);

}  // namespace physim::client
