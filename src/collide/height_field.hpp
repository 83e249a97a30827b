// Heights over a grid: a segment walks over the cells below it, column by column.
#pragma once

#include "collide/bvh.hpp"
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
  [[nodiscard]] HeightFieldShape definition() const { return {columns_, rows_, spacing_x_, spacing_z_, heights_}; }

  /// Calls take(crossing, segment) for each triangle met. Triangle 2 (row (columns - 1) + column) + i is of that cell.
  template <class Take>
  void crossings(Segment& s, const Take& take) const {
    const Shear shear(s);
    triangles_along(s, [&](const Triangle& triangle, std::uint32_t number) {
      auto crossing = meets(s, shear, triangle);
      if (!crossing) return;
      crossing->primitive = number;
      take(*crossing, s);
    });
  }
  /// A part of a segment up to which spheres about its points touch nothing: its reach, or less.
  [[nodiscard]] double clear_part(Segment s) const {
    triangles_along(s, [&](const Triangle& triangle, std::uint32_t) {
      if (const auto part = collide::clear_part(s, triangle)) s.reach = std::min(s.reach, *part);
    });
    return s.reach;
  }
  [[nodiscard]] std::optional<Vec3d> nearest(const Vec3d& p, double& within) const;
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

  /// Where a segment is between two places along an axis, and not farther than its reach.
  struct Slab {
    double in, out;
    bool some;
  };
  /// Cells from the first one on.
  struct Range {
    std::uint32_t first, count;
  };

  /// What coordinates are rounded to, with the radius.
  [[nodiscard]] double slack(const Segment& s) const {
    return s.radius + 8 * std::numeric_limits<double>::epsilon() * (s.extent() + extent_);
  }
  /// `per_along`: 0 where it does not go along the axis.
  [[nodiscard]] static Slab slab(double from, double per_along, double low, double high, double wide, double reach) {
    const double below = low - wide - from, above = high + wide - from;
    if (per_along == 0) return {0, reach, below <= 0 && above >= 0 && reach >= 0};
    const double one = below * per_along, other = above * per_along;
    const double in = std::max(0.0, std::min(one, other)), out = std::min(reach, std::max(one, other));
    return {in, out, in <= out};
  }
  /// The cells between two places, with those that rounding or the radius may reach.
  [[nodiscard]] static Range cells(double one, double other, double per_spacing, std::uint32_t points, double wide) {
    const double last = points - 2.0;
    const double low = std::clamp((std::min(one, other) - wide) * per_spacing, 0.0, last);
    const double high = std::clamp((std::max(one, other) + wide) * per_spacing, 0.0, last);
    PHYSIM_ASSERT(low <= high && high <= points - 2);
    const auto first = static_cast<std::uint32_t>(low);
    return {first, static_cast<std::uint32_t>(high) - first + 1};
  }

  /// Whether all of a cell lies above a height, or below another one.
  [[nodiscard]] bool is_beside(std::uint32_t column, std::uint32_t row, double low, double high) const {
    const double a = height(column, row), b = height(column + 1, row);
    const double c = height(column, row + 1), d = height(column + 1, row + 1);
    const bool above = (a > high) & (b > high) & (c > high) & (d > high);
    return above | ((a < low) & (b < low) & (c < low) & (d < low));
  }

  /// Calls visit(triangle, number) for those that a segment may meet, which shortens its reach.
  template <class Visit>
  void triangles_along(Segment& s, const Visit& visit) const {
    const double wide = slack(s), per_x = s.along.x == 0 ? 0 : finite_inverse(s.along.x);
    const Slab columns = slab(s.from.x, per_x, 0, (columns_ - 1) * spacing_x_, wide, s.reach);
    if (!columns.some) return;
    const Range over =
        cells(s.from.x + s.along.x * columns.in, s.from.x + s.along.x * columns.out, per_spacing_x_, columns_, wide);
    const bool forwards = s.along.x >= 0;
    for (std::uint32_t i = 0; i < over.count; ++i) {
      const std::uint32_t column = forwards ? over.first + i : over.first + over.count - 1 - i;
      const Slab here = slab(s.from.x, per_x, column * spacing_x_, (column + 1) * spacing_x_, wide, s.reach);
      if (here.some) triangles_in(s, column, here, wide, visit);
    }
  }
  /// Calls visit(triangle, number) for those of one column of cells.
  template <class Visit>
  void triangles_in(const Segment& s, std::uint32_t column, const Slab& here, double wide, const Visit& visit) const {
    const Range over =
        cells(s.from.z + s.along.z * here.in, s.from.z + s.along.z * here.out, per_spacing_z_, rows_, wide);
    const double one = s.from.y + s.along.y * here.in, other = s.from.y + s.along.y * here.out;
    const double low = std::min(one, other) - wide, high = std::max(one, other) + wide;
    const bool forwards = s.along.z >= 0;
    for (std::uint32_t i = 0; i < over.count; ++i) {
      const std::uint32_t row = forwards ? over.first + i : over.first + over.count - 1 - i;
      if (is_beside(column, row, low, high)) continue;
      for (std::uint32_t half = 0; half < 2; ++half)
        visit(triangle(column, row, half), 2 * (row * (columns_ - 1) + column) + half);
    }
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
  std::vector<Level> levels_;  // the last one has one block
  Bounds bounds_;
  double extent_ = 0;  // the largest coordinate [m]
};

}  // namespace physim::collide
