// Source: model/table_pool.hpp.
#include "model/table_pool.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "model/drag_curves.hpp"

namespace physim {

PHYSIM_COLD std::size_t MagnusPool::add(const MagnusDef& magnus) {
  const MagnusGrid grid = magnus_grid(magnus);
  PHYSIM_ASSERT(is_full(grid, magnus.table.size()));
  const auto known = std::find(grids_.begin(), grids_.end(), grid);
  const auto index = static_cast<std::size_t>(known - grids_.begin());
  if (known == grids_.end()) grids_.push_back(grid);
  return index;
}

namespace {

constexpr std::size_t kMaxRows = 1 << 22;            // what floats count, and row_cubic() reads
constexpr std::size_t kMaxCurveRows = kMaxRows / 2;  // the rest is for tables that cannot be searched

CurvePart<double> place_at(double first_row, const UniformCubic& curve) {
  PHYSIM_ASSERT(!curve.rows.empty() && curve.cell > 0);
  return {first_row, curve.start / curve.cell, 1 / curve.cell, static_cast<double>(curve.rows.size() - 1)};
}

}  // namespace

void TablePool::settle() {
  if (alone_ == nullptr) return;
  const UniformCubic& curve = *std::exchange(alone_, nullptr);
  PHYSIM_ASSERT(rows_.empty() && entries_.empty());
  entries_.push_back({alone_table_, {}, place_of(curve)});
}

CurvePart<double> TablePool::add(const DragDef& drag, Interpolation interpolation) {
  if (alone_ != nullptr && drag.table == alone_table_) return place_at(0, *alone_);
  if (drag.table != DragTable::custom && rows_.empty() && entries_.empty() && alone_ == nullptr) {
    alone_ = &standard_drag_cells(drag.table, interpolation);
    alone_table_ = drag.table;
    return place_at(0, *alone_);
  }
  settle();
  for (const Entry& e : entries_)
    if (e.table == drag.table && (drag.table != DragTable::custom || same_points(e.curve, drag.curve))) return e.place;
  const auto own_points = drag.table == DragTable::custom ? drag.curve : std::vector<DragPoint>{};
  entries_.push_back({drag.table, own_points, place_of(drag, interpolation)});
  return entries_.back().place;
}

CurvePart<double> TablePool::place_of(const DragDef& drag, Interpolation interpolation) {
  if (drag.table != DragTable::custom) return place_of(standard_drag_cells(drag.table, interpolation));
  const PiecewiseCubic curve = drag_curve(drag, interpolation);
  const auto cells = on_uniform_cells(curve, kMaxCurveCells);
  if (cells && rows_.size() / 4 + cells->rows.size() <= kMaxCurveRows) return place_of(*cells);
  searched_.push_back(curve);
  if (rows_.empty()) rows_.assign(4, 0);  // lanes with searched curves still read some row
  return {-static_cast<double>(searched_.size()), 0, 1, 0};
}

CurvePart<double> TablePool::place_of(const UniformCubic& curve) { return place_at(add_rows(curve.rows), curve); }

double TablePool::add_rows(const std::vector<std::array<double, 4>>& rows) {
  settle();
  PHYSIM_ASSERT(!rows.empty() && rows_.size() % 4 == 0);
  const std::size_t first = rows_.size();
  static_assert(sizeof(rows[0]) == 4 * sizeof(double));  // they lie side by side
  const double* const numbers = rows.front().data();
  rows_.insert(rows_.end(), numbers, numbers + 4 * rows.size());
  PHYSIM_ASSERT(rows_.size() / 4 <= kMaxRows);
  return static_cast<double>(first / 4);
}

PHYSIM_COLD const AeroPlace* TablePool::find(const AeroDef& aero) const {
  for (const auto& [known, place] : aero_)
    if (known == aero) return &place;
  return nullptr;
}

std::size_t TablePool::size() const {
  return rows().size() + searched_.size() + motors.pieces().size() + magnus.grids().size();
}

template <class S>
TablePointers<S> TablePool::pointers(const S* rows) const {
  return {rows, searched_.data(), motors.pieces().data(), magnus.grids().data()};
}

void TablePool::point(Conditions<double>& c) const { static_cast<TablePointers<double>&>(c) = pointers(rows().data()); }

void TablePool::point(Conditions<float>& c) {
  const std::span<const double> wide = rows();
  PHYSIM_ASSERT(rows_float_.size() <= wide.size());
  const std::size_t known = rows_float_.size();
  rows_float_.resize(wide.size());
  for (std::size_t i = known; i < wide.size(); ++i) rows_float_[i] = static_cast<float>(wide[i]);
  static_cast<TablePointers<float>&>(c) = pointers(rows_float_.data());
}

}  // namespace physim
