// Source: model/drag_curves.hpp.
#include "model/drag_curves.hpp"

#include <algorithm>
#include <mutex>

#include "model/sphere_drag.hpp"
#include "physim/drag_curve.hpp"

namespace physim {
namespace {

constexpr int kMaxCells = 16384;  // half a megabyte of rows at most for one curve

PiecewiseCubic through(std::span<const DragPoint> points, Interpolation interpolation) {
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

PiecewiseCubic curve_of(const DragDef& drag, Interpolation interpolation) {
  const auto points = points_of(drag);
  if (!points.empty()) return through(points, interpolation);
  const DragPoint unit{0, 1};  // a constant Cd is part of the area; see half_area_per_mass()
  return through({&unit, 1}, interpolation);
}

/// The curve of a table that is not custom, on equal cells. Each is fitted once: it takes as long as a short flight.
const UniformCubic& standard_cells(DragTable table, Interpolation interpolation) {
  struct Fitted {
    std::once_flag once;
    UniformCubic cells;
  };
  static Fitted fitted[std::size_t(DragTable::custom)][std::size_t(Interpolation::cubic) + 1];
  Fitted& f = fitted[std::size_t(table)][std::size_t(interpolation)];
  std::call_once(f.once, [&] {
    DragDef drag;
    drag.table = table;
    f.cells = on_uniform_cells(curve_of(drag, interpolation), kMaxCells).value();
  });
  return f.cells;
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

std::size_t MagnusPool::add(const MagnusDef& magnus) {
  const MagnusGrid grid = magnus_grid(magnus);
  const auto known = std::find(grids_.begin(), grids_.end(), grid);
  const auto index = static_cast<std::size_t>(known - grids_.begin());
  if (known == grids_.end()) grids_.push_back(grid);
  return index;
}

CurvePlace CurvePool::add(const DragDef& drag, Interpolation interpolation) {
  for (const Entry& e : entries_) {
    if (e.table != drag.table) continue;
    if (drag.table == DragTable::custom && e.curve != drag.curve) continue;
    return e.place;
  }
  const auto own_points = drag.table == DragTable::custom ? drag.curve : std::vector<DragPoint>{};
  entries_.push_back({drag.table, own_points, place_of(drag, interpolation)});
  return entries_.back().place;
}

CurvePlace CurvePool::place_of(const DragDef& drag, Interpolation interpolation) {
  if (drag.table != DragTable::custom) return place_of(standard_cells(drag.table, interpolation));
  const PiecewiseCubic curve = curve_of(drag, interpolation);
  if (const auto cells = on_uniform_cells(curve, kMaxCells)) return place_of(*cells);
  searched_.push_back(curve);
  if (rows_.empty()) rows_.assign(4, 0);  // lanes with searched curves still read some row
  return {-static_cast<double>(searched_.size()), 0, 1, 0};
}

CurvePlace CurvePool::place_of(const UniformCubic& curve) {
  return {add_rows(curve.rows), curve.start, 1 / curve.cell, static_cast<double>(curve.rows.size() - 1)};
}

double CurvePool::add_rows(const std::vector<std::array<double, 4>>& rows) {
  const auto first = static_cast<double>(rows_.size() / 4);
  const auto* numbers = reinterpret_cast<const double*>(rows.data());
  rows_.insert(rows_.end(), numbers, numbers + 4 * rows.size());
  return first;
}

const AeroPlace* CurvePool::find(const AeroDef& aero) const {
  for (const auto& [known, place] : aero_)
    if (known == aero) return &place;
  return nullptr;
}

double drag_coefficient(const DragDef& drag, Interpolation interpolation, double mach) {
  return drag.table == DragTable::constant ? drag.coefficient : curve_of(drag, interpolation)(mach);
}

bool spline_overshoots(const DragDef& drag) {
  return drag.table == DragTable::custom && overshoots(through(drag.curve, Interpolation::cubic), drag.curve);
}

double sphere_drag_coefficient(double reynolds) {
  double cd;
  sphere_cd(reynolds, cd);
  return cd;
}

}  // namespace physim
