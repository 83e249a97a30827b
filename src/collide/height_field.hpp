// Heights over a grid: a segment walks over the cells below it, in blocks of four times four.
#pragma once

#include <bit>
#include <vector>

#include "base/prefetch.hpp"
#include "collide/box.hpp"
#include "collide/field_block.hpp"
#include "collide/triangle.hpp"
#include "physim/scene.hpp"

namespace physim::collide {

class HeightField {
 public:
  [[nodiscard]] static Result<HeightField> make(const HeightFieldShape& shape);

  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] ShapeInfo info() const {
    return {.triangles = 2 * std::size_t{columns_ - 1} * (rows_ - 1), .bytes = bytes()};
  }

  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  [[nodiscard]] double spacing_x() const { return spacing_x_; }  // [m]
  [[nodiscard]] double spacing_z() const { return spacing_z_; }  // [m]
  [[nodiscard]] double height(std::uint32_t column, std::uint32_t row) const {
    PHYSIM_ASSERT(column < columns_ && row < rows_);
    return heights_[std::size_t{row} * columns_ + column];
  }
  /// The two halves of a cell, seen from above.
  [[nodiscard]] Triangle triangle(std::uint32_t column, std::uint32_t row, std::uint32_t half) const {
    const Vec3d right = point(column + 1, row), far = point(column, row + 1);
    return half == 0 ? Triangle{point(column, row), far, right} : Triangle{right, far, point(column + 1, row + 1)};
  }
  /// The primitive that a hit on a half of a cell tells.
  [[nodiscard]] std::uint32_t number(std::uint32_t column, std::uint32_t row, std::uint32_t half) const {
    PHYSIM_ASSERT(column + 1 < columns_ && row + 1 < rows_ && half < 2);
    return 2 * (row * (columns_ - 1) + column) + half;
  }
  [[nodiscard]] HeightFieldShape definition() const { return {columns_, rows_, spacing_x_, spacing_z_, heights_}; }

  /// Calls take(crossing, segment) for each triangle met.
  template <class Take>
  void crossings(Segment& s, const Take& take) const {
    if (const FieldCells cells = cells_along(s); cells.some != 0) crossings_in(s, cells, take);
  }
  /// Calls it for those met in the cells along a segment.
  template <class Take>
  void crossings_in(Segment& s, const FieldCells& cells, const Take& take) const {
    const Shear shear(s);
    triangles_in(s, cells, [&](const Triangle& triangle, std::uint32_t number) {
      auto crossing = meets(s, shear, triangle);
      if (!crossing) return;
      crossing->primitive = number;
      take(*crossing, s);
    });
  }
  /// Calls visit(triangle, number) for those that a segment may meet, which shortens its reach.
  template <class Visit>
  void triangles_along(Segment& s, const Visit& visit) const {
    triangles_in(s, cells_along(s), visit);
  }
  /// What it is compared with segments by.
  [[nodiscard]] FieldGrid grid() const {
    PHYSIM_ASSERT(rounded_.size() == heights_.size() + kBlockSide * (std::size_t{columns_} + 1));
    return {rounded_.data(), columns_,       rows_,   per_spacing_x_, per_spacing_z_,
            bounds_.low.y,   bounds_.high.y, middle_, extent_};
  }
  /// Where a segment may meet it.
  [[nodiscard]] FieldCells cells_along(const Segment& s) const {
    if (s.reach < 0) return {0, 0, 0};
    const FieldGrid over = grid();
    const Vec3d along = s.along * s.reach;
    const auto way = way_over(over, s.from, along, slack_over(over, s.from, along, s.radius));
    if (passes(over, way)) return {0, 0, 0};
    const CellRange<double> columns = columns_of(way), rows = rows_of(way);
    const bool is_far = columns.last - columns.first >= kBlockSide || rows.last - rows.first >= kBlockSide ||
                        way.size(columns.first, rows.first) > kManyCells;
    return is_far ? FieldCells{0, 0, FieldCells::kFar} : cells_in(way, Range(columns), Range(rows));
  }
  /// Has the first of some cells brought from memory.
  void prefetch(const FieldCells& cells) const {
    if (cells.some == FieldCells::kFar) return;
    PHYSIM_ASSERT(cells.some != 0);
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(cells.some));
    const double* corner = &heights_[std::size_t{cells.row + lane / kBlockSide} * columns_ + cells.column];
    prefetch_at(corner, lane % kBlockSide * sizeof(double));
    prefetch_at(corner + columns_, lane % kBlockSide * sizeof(double));
  }
  /// Calls visit(triangle, number) for those in the cells along a segment.
  template <class Visit>
  PHYSIM_INLINE void triangles_in(Segment& s, const FieldCells& cells, const Visit& visit) const {
    if (cells.some == FieldCells::kFar) return triangles_far_along(s, visit);
    for (std::uint32_t some = cells.some; some != 0;) {
      const int lane = s.along.z >= 0 ? std::countr_zero(some) : 31 - std::countl_zero(some);
      some &= ~(1u << lane);
      const std::uint32_t column = cells.column + static_cast<std::uint32_t>(lane) % kBlockSide;
      const std::uint32_t row = cells.row + static_cast<std::uint32_t>(lane) / kBlockSide;
      for (std::uint32_t half = 0; half < 2; ++half) visit(triangle(column, row, half), number(column, row, half));
    }
  }
  /// A part of a segment up to which spheres about its points touch nothing: its reach, or less.
  [[nodiscard]] double clear_part(Segment s) const {
    triangles_along(s, [&](const Triangle& triangle, std::uint32_t) {
      if (const auto part = collide::clear_part(s, triangle)) s.reach = std::min(s.reach, *part);
    });
    return s.reach;
  }
  [[nodiscard]] std::optional<NearPlace> nearest(const Vec3d& p, double& within) const;
  /// Between the distance of p and half of it.
  [[nodiscard]] double clearance(const Vec3d& p) const;

 private:
  static constexpr std::uint32_t kBlock = 8;  // cells along a side of the smallest blocks
  /// The least and the largest height in a block of cells.
  struct Heights {
    float low, high;
  };
  /// Blocks of one size; those of the next level are twice as wide.
  struct Level {
    std::uint32_t columns, rows;
    std::vector<Heights> blocks;
  };

  /// Parts of a segment, from one to another.
  struct Part {
    double in, out;
  };
  /// Cells from the first one on.
  struct Range {
    std::uint32_t first, count;

    Range(std::uint32_t from, std::uint32_t many) : first(from), count(many) {}
    explicit Range(const CellRange<double>& cells)
        : first(static_cast<std::uint32_t>(cells.first)), count(static_cast<std::uint32_t>(cells.last) - first + 1) {
      PHYSIM_ASSERT(cells.first >= 0 && cells.first <= cells.last);
    }
  };

  /// What of a part of a segment is between two places along an axis; out < in where nothing is. `per_along`: 0 where
  /// it does not go along the axis.
  [[nodiscard]] static Part part_between(double from, double per_along, double low, double high, double wide,
                                         const Part& part) {
    const double below = low - wide - from, above = high + wide - from;
    if (per_along == 0) return below <= 0 && above >= 0 ? part : Part{1, 0};
    const double one = below * per_along, other = above * per_along;
    return {std::max(part.in, std::min(one, other)), std::min(part.out, std::max(one, other))};
  }
  [[nodiscard]] CellRange<double> columns_of(const FieldWay<double>& way) const {
    return cells_between(way.from.x, way.from.x + way.along.x, way.wide_x, columns_);
  }
  [[nodiscard]] CellRange<double> rows_of(const FieldWay<double>& way) const {
    return cells_between(way.from.z, way.from.z + way.along.z, way.wide_z, rows_);
  }

  /// Those of a segment that passes many cells, in strips of three across its way: it leaves a strip four cells later
  /// at most.
  template <class Visit>
  [[gnu::noinline]] void triangles_far_along(Segment& s, const Visit& visit) const {
    const FieldGrid over_grid = grid();
    const double wide = slack_over(over_grid, s.from, s.along, s.radius);
    const double per_x = s.along.x == 0 ? 0 : finite_inverse(s.along.x);
    const double per_z = s.along.z == 0 ? 0 : finite_inverse(s.along.z);
    const Part over = part_between(s.from.z, per_z, 0, (rows_ - 1) * spacing_z_, wide,
                                   part_between(s.from.x, per_x, 0, (columns_ - 1) * spacing_x_, wide, {0, s.reach}));
    if (!(over.in <= over.out)) return;
    const FieldWay<double> way = way_over(over_grid, s.at(over.in), s.along * (over.out - over.in), wide);
    const bool by_columns = std::abs(way.along.x) >= std::abs(way.along.z);
    const Range all(by_columns ? columns_of(way) : rows_of(way));
    const double spacing = by_columns ? spacing_x_ : spacing_z_;
    const bool forwards = (by_columns ? s.along.x : s.along.z) >= 0;
    constexpr std::uint32_t kWide = kBlockSide - 1;
    const std::uint32_t strips = (all.count + kWide - 1) / kWide;
    for (std::uint32_t i = 0; i < strips; ++i) {
      const std::uint32_t at = kWide * (forwards ? i : strips - 1 - i);
      const Range strip{all.first + at, std::min(kWide, all.count - at)};
      PHYSIM_ASSERT(strip.count >= 1 && strip.first + strip.count <= all.first + all.count);
      const double low = strip.first * spacing, high = (strip.first + strip.count) * spacing;
      const Part part{over.in, std::min(over.out, s.reach)};
      const Part here = by_columns ? part_between(s.from.x, per_x, low, high, wide, part)
                                   : part_between(s.from.z, per_z, low, high, wide, part);
      if (here.in <= here.out) triangles_in_strip(s, strip, by_columns, here, wide, visit);
    }
  }
  template <class Visit>
  void triangles_in_strip(Segment& s, const Range& strip, bool by_columns, const Part& here, double wide,
                          const Visit& visit) const {
    const FieldWay<double> way = way_over(grid(), s.at(here.in), s.along * (here.out - here.in), wide);
    const Range across(by_columns ? rows_of(way) : columns_of(way));
    const bool forwards = (by_columns ? s.along.z : s.along.x) >= 0;
    const std::uint32_t blocks = (across.count + kBlockSide - 1) / kBlockSide;
    for (std::uint32_t i = 0; i < blocks; ++i) {
      const std::uint32_t at = kBlockSide * (forwards ? i : blocks - 1 - i);
      const Range block{across.first + at, std::min(kBlockSide, across.count - at)};
      const Range &columns = by_columns ? strip : block, &rows = by_columns ? block : strip;
      triangles_in(s, cells_in(way, columns, rows), visit);
      if (s.reach < here.in) return;
    }
  }
  /// Those of a block that a way may meet.
  [[nodiscard]] FieldCells cells_in(const FieldWay<double>& way, const Range& columns, const Range& rows) const {
    const FieldGrid over = grid();
    const double column = columns.first, row = rows.first;
    std::uint32_t some = block_of(columns.count, rows.count);
    if (way.size(column, row) <= kManyCells) {
      const BlockWay<double> block = way_in_block(over, way, column, row);
      float numbers[kBlockWayNumbers];
      for (int i = 0; i < kBlockWayNumbers; ++i) numbers[i] = static_cast<float>((&block.x)[i]);
      some = cells_met(over, numbers, 1, columns.first, rows.first, columns.count, rows.count);
    }
    return {columns.first, rows.first, some};
  }

  [[nodiscard]] std::size_t bytes() const;
  void build_levels();
  [[nodiscard]] Bounds box(std::size_t level, std::uint32_t column, std::uint32_t row) const;
  void clear_of(const Vec3d& p, std::size_t level, std::uint32_t column, std::uint32_t row, double& within) const;
  void clear_of_cell(const Vec3d& p, std::uint32_t column, std::uint32_t row, double& within) const;

  [[nodiscard]] Vec3d point(std::uint32_t column, std::uint32_t row) const {
    return {column * spacing_x_, height(column, row), row * spacing_z_};
  }

  std::uint32_t columns_ = 0, rows_ = 0;
  double spacing_x_ = 1, spacing_z_ = 1, per_spacing_x_ = 1, per_spacing_z_ = 1;
  std::vector<double> heights_;
  std::vector<float> rounded_;  // heights less the middle one, and so many more as the last block is read with
  std::vector<Level> levels_;   // the last one has one block
  Bounds bounds_;
  double extent_ = 0;  // the largest coordinate [m]
  double middle_ = 0;  // between the least and the largest height [m]
};

}  // namespace physim::collide
