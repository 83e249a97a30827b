// Source: model/drag_curves.hpp.
#include "model/drag_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <type_traits>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "model/ladder.hpp"
#include "model/sphere_drag.hpp"
#include "physim/projectile.hpp"

namespace physim {
namespace {

PiecewiseCubic through(std::span<const DragPoint> points, Interpolation interpolation) {
  PHYSIM_ASSERT(!points.empty());
  std::vector<double> mach, cd;
  for (const DragPoint& p : points) {
    mach.push_back(p.mach);
    cd.push_back(p.coefficient);
  }
  return interpolate(mach, cd, interpolation);
}

std::span<const DragPoint> points_of(const DragDef& drag) {
  return drag.table == DragTable::custom ? std::span<const DragPoint>(drag.curve) : drag_points(drag.table);
}

/// Whether a curve leaves the span of its neighbouring points by a quarter of them, or goes below zero.
bool overshoots(const PiecewiseCubic& curve, std::span<const DragPoint> points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto [low, high] = std::minmax(points[i].coefficient, points[i + 1].coefficient);
    for (int part = 1; part < 16; ++part) {
      const double cd = curve(points[i].mach + (points[i + 1].mach - points[i].mach) * part / 16);
      if (cd < 0 || cd < 0.75 * low || cd > 1.25 * high) return true;
    }
  }
  return false;
}

}  // namespace

PiecewiseCubic drag_curve(const DragDef& drag, Interpolation interpolation) {
  const auto points = points_of(drag);
  if (!points.empty()) return through(points, interpolation);
  const DragPoint unit{0, 1};  // a constant Cd is part of the area; see half_area_per_mass() in prepare/projectile.cpp
  return through({&unit, 1}, interpolation);
}

const UniformCubic& standard_drag_cells(DragTable table, Interpolation interpolation) {
  struct Fitted {
    std::once_flag once;
    UniformCubic cells;
  };
  static Fitted fitted[std::size_t(DragTable::custom)][kRungCount<Interpolation>];
  PHYSIM_ASSERT(std::size_t(table) < std::size(fitted) && std::size_t(interpolation) < kRungCount<Interpolation>);
  Fitted& f = fitted[std::size_t(table)][std::size_t(interpolation)];
  std::call_once(f.once, [&] {
    DragDef drag;
    drag.table = table;
    f.cells = on_uniform_cells(drag_curve(drag, interpolation), kMaxCurveCells).value();
  });
  return f.cells;
}

namespace {

/// Whether a curve can be made of unchecked input.
bool has_curve(const DragDef& drag, Interpolation interpolation) {
  if (static_cast<std::size_t>(interpolation) >= kRungCount<Interpolation>) return false;
  if (static_cast<std::size_t>(drag.table) > static_cast<std::size_t>(DragTable::custom)) return false;
  if (drag.table != DragTable::custom) return true;
  for (std::size_t i = 0; i < drag.curve.size(); ++i) {
    if (!std::isfinite(drag.curve[i].mach) || !std::isfinite(drag.curve[i].coefficient)) return false;
    if (i > 0 && !(drag.curve[i].mach > drag.curve[i - 1].mach)) return false;
  }
  return !drag.curve.empty();
}

}  // namespace

double drag_coefficient(const DragDef& drag, Interpolation interpolation, double mach) {
  const IeeeMode mode;
  if (!has_curve(drag, interpolation)) return std::numeric_limits<double>::quiet_NaN();
  return drag.table == DragTable::constant ? drag.coefficient : drag_curve(drag, interpolation)(mach);
}

bool same_points(const std::vector<DragPoint>& a, const std::vector<DragPoint>& b) {
  static_assert(std::is_trivially_copyable_v<DragPoint> && sizeof(DragPoint) == 2 * sizeof(double));
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(DragPoint)) == 0);
}

bool spline_overshoots(const DragDef& drag) {
  return drag.table == DragTable::custom && overshoots(through(drag.curve, Interpolation::cubic), drag.curve);
}

double sphere_drag_coefficient(double reynolds) {
  const IeeeMode mode;
  double cd;
  sphere_cd(reynolds, cd);
  return cd;
}

}  // namespace physim
