// Heights over a grid: a segment is compared with a block of the cells below it, or with block after block.
#pragma once

#include <bit>
#include <vector>

#include "base/prefetch.hpp"
#include "collide/field_job.hpp"
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
    return {rounded_.data(), columns_, rows_,   per_spacing_x_, per_spacing_z_, bounds_.low.y,
            bounds_.high.y,  middle_,  extent_, planes_.data(), planes_a_row_};
  }
  /// Where a segment may meet it.
  [[nodiscard]] FieldCells cells_along(const Segment& s) const {
    if (s.reach < 0) return {0, 0, 0};
    const FieldGrid over = grid();
    const Vec3d along = s.along * s.reach;
    const auto way = way_over(over, s.from, along, slack_over(over, s.from, along, s.radius + s.seam));
    if (passes(over, way)) return {0, 0, 0};
    const CellRange<double> columns = columns_of(way), rows = rows_of(way);
    const bool is_far = columns.last - columns.first >= kBlockSide || rows.last - rows.first >= kBlockSide ||
                        way.size(columns.first, rows.first) > kManyCells;
    return is_far ? FieldCells{0, 0, FieldCells::kFar} : cells_in(way, columns, rows);
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
  [[nodiscard]] double clear_part(Segment s) const;
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

  [[nodiscard]] CellRange<double> columns_of(const FieldWay<double>& way) const {
    return cells_between(way.from.x, way.from.x + way.along.x, way.wide_x, columns_);
  }
  [[nodiscard]] CellRange<double> rows_of(const FieldWay<double>& way) const {
    return cells_between(way.from.z, way.from.z + way.along.z, way.wide_z, rows_);
  }

  /// Calls visit(triangle, number) for those of a segment that passes many cells.
  template <class Visit>
  [[gnu::noinline]] void triangles_far_along(Segment& s, const Visit& visit) const {
    double in = 0, out = s.reach;
    FieldWalk walk;
    if (!begin_walk(s, in, out, walk)) return;
    const FieldKernel& kernel = field_kernel();
    const FieldGrid over = grid();
    const double per_part = out > in ? 1 / (out - in) : 0;
    for (FieldCells cells = kernel.next_cells(over, walk); cells.some != 0; cells = kernel.next_cells(over, walk)) {
      triangles_in(s, cells, visit);
      walk.reach = std::min(walk.reach, (s.reach - in) * per_part);
    }
  }
  /// Sets a walk for a segment as it is over the field, from one part of it to another; false where it passes it.
  bool begin_walk(const Segment& s, double& in, double& out, FieldWalk& walk) const;

  /// Those of a block that a way may meet.
  [[nodiscard]] FieldCells cells_in(const FieldWay<double>& way, const CellRange<double>& columns,
                                    const CellRange<double>& rows) const {
    const FieldGrid over = grid();
    const BlockWay<double> block = way_in_block(over, way, columns.first, rows.first);
    float numbers[kBlockWayNumbers];
    each_number(block, [&](int i, double number) { numbers[i] = static_cast<float>(number); });
    FieldCells cells{static_cast<std::uint32_t>(columns.first), static_cast<std::uint32_t>(rows.first),
                     block_of(count_of(columns), count_of(rows))};
    cells.some = field_kernel().cells_in_block(over, numbers, cells);
    return cells;
  }
  [[nodiscard]] static std::uint32_t count_of(const CellRange<double>& cells) {
    PHYSIM_ASSERT(cells.first >= 0 && cells.first <= cells.last);
    return static_cast<std::uint32_t>(cells.last - cells.first) + 1;
  }

  [[nodiscard]] std::size_t bytes() const;
  void build_planes();
  [[nodiscard]] FieldPlane plane_over(std::uint32_t column, std::uint32_t row) const;
  void build_levels();
  [[nodiscard]] Bounds box(std::size_t level, std::uint32_t column, std::uint32_t row) const;
  [[nodiscard]] Bounds cell_box(std::uint32_t column, std::uint32_t row) const;
  void clear_of(const Vec3d& p, std::size_t level, std::uint32_t column, std::uint32_t row, double& within) const;
  void clear_of_cell(const Vec3d& p, std::uint32_t column, std::uint32_t row, double& within) const;

  [[nodiscard]] Vec3d point(std::uint32_t column, std::uint32_t row) const {
    return {column * spacing_x_, height(column, row), row * spacing_z_};
  }

  std::uint32_t columns_ = 0, rows_ = 0;
  double spacing_x_ = 1, spacing_z_ = 1, per_spacing_x_ = 1, per_spacing_z_ = 1;
  std::vector<double> heights_;
  std::vector<float> rounded_;  // heights less the middle one, and so many more as the last block is read with
  std::vector<FieldPlane> planes_;
  std::uint32_t planes_a_row_ = 0;
  std::vector<Level> levels_;  // the last one has one block
  Bounds bounds_;
  double extent_ = 0;  // the largest coordinate [m]
  double middle_ = 0;  // between the least and the largest height [m]
};

}  // namespace physim::collide
