// Heights over a grid: a segment is compared with a block of the cells below it, or walks over four columns at a time.
#pragma once

#include <bit>
#include <vector>

#include "base/prefetch.hpp"
#include "collide/field_job.hpp"
#include "collide/quad_boxes.hpp"
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

  /// Where a segment is between two places along an axis, and not farther than its reach.
  struct Slab {
    double in, out;
    bool some;
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

  [[nodiscard]] CellRange<double> columns_of(const FieldWay<double>& way) const {
    return cells_between(way.from.x, way.from.x + way.along.x, way.wide_x, columns_);
  }
  [[nodiscard]] CellRange<double> rows_of(const FieldWay<double>& way) const {
    return cells_between(way.from.z, way.from.z + way.along.z, way.wide_z, rows_);
  }

  /// Calls visit(triangle, number) for those of a segment that passes many cells, four columns after four: by the least
  /// and the largest height of each cell, which are soon compared.
  template <class Visit>
  [[gnu::noinline]] void triangles_far_along(Segment& s, const Visit& visit) const {
    const double wide = slack(s), per_x = s.along.x == 0 ? 0 : finite_inverse(s.along.x);
    const Slab columns = slab(s.from.x, per_x, 0, (columns_ - 1) * spacing_x_, wide, s.reach);
    if (!columns.some) return;
    const Range over =
        cells(s.from.x + s.along.x * columns.in, s.from.x + s.along.x * columns.out, per_spacing_x_, columns_, wide);
    if (over.count <= 4) return triangles_in_strip(s, over, columns, wide, per_x, visit);
    const std::uint32_t strips = (over.count + 3) / 4;
    for (std::uint32_t i = 0; i < strips; ++i) {
      const std::uint32_t at = 4 * (s.along.x >= 0 ? i : strips - 1 - i);
      const Range strip{over.first + at, std::min(4u, over.count - at)};
      const Slab here =
          slab(s.from.x, per_x, strip.first * spacing_x_, (strip.first + strip.count) * spacing_x_, wide, s.reach);
      if (here.some) triangles_in_strip(s, strip, here, wide, per_x, visit);
    }
  }
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

  /// Calls visit(triangle, number) for those of four columns of cells, or fewer, which the segment passes `here`.
  template <class Visit>
  void triangles_in_strip(const Segment& s, const Range& columns, const Slab& here, double wide, double per_x,
                          const Visit& visit) const {
    const Range over =
        cells(s.from.z + s.along.z * here.in, s.from.z + s.along.z * here.out, per_spacing_z_, rows_, wide);
    const StripTest test(*this, s, columns.first, here, wide, per_x);
    PHYSIM_ASSERT(columns.count >= 1 && columns.count <= 4 && columns.first + columns.count < columns_);
    PHYSIM_ASSERT(over.first + over.count < rows_);
    const unsigned there = (1u << columns.count) - 1;
    const bool forwards = s.along.z >= 0;
    for (std::uint32_t i = 0; i < over.count; ++i) {
      const std::uint32_t row = forwards ? over.first + i : over.first + over.count - 1 - i;
      const float* heights = &rounded_[std::size_t{row} * columns_ + columns.first];
      for (unsigned lanes = there & test.meets(row * spacing_z_, heights, heights + columns_, s.reach); lanes != 0;) {
        const int lane = s.along.x >= 0 ? std::countr_zero(lanes) : 31 - std::countl_zero(lanes);
        lanes &= ~(1u << lane);
        const std::uint32_t column = columns.first + static_cast<std::uint32_t>(lane);
        for (std::uint32_t half = 0; half < 2; ++half) visit(triangle(column, row, half), number(column, row, half));
      }
    }
  }
  /// A segment on its way through four columns of cells, ready to be compared with four cells of a row at once: in
  /// float, from where it enters the columns on, and wider by what it is rounded to.
  class StripTest {
   public:
    StripTest(const HeightField& field, const Segment& s, std::uint32_t column, const Slab& here, double wide,
              double per_x)
        : base_(here.in), out_(here.out) {
      const Vec3d from = s.at(here.in);
      const auto slack = [wide](double size) { return wide + kFloatSlack * (wide + size); };
      const auto quad = [](double x) { return Quad(static_cast<float>(x)); };
      enters_ = Quad(0.0f), leaves_ = Quad(2.0f);
      if (per_x != 0) {
        const double aside = slack(16 * field.spacing_x_), left = column * field.spacing_x_ - from.x;
        const Quad steps = quad(field.spacing_x_) * lanes(), per = quad(std::clamp(per_x, -1e30, 1e30));
        const Quad one = (quad(left - aside) + steps) * per;
        const Quad other = (quad(left + field.spacing_x_ + aside) + steps) * per;
        enters_ = max(min(one, other), enters_);
        leaves_ = max(one, other);
      }
      const double aside = slack(0);
      const bool forwards = s.along.z >= 0;
      near_z_ = (forwards ? -aside : field.spacing_z_ + aside) - from.z;
      far_z_ = (forwards ? field.spacing_z_ + aside : -aside) - from.z;
      if (s.along.z != 0) per_z_ = finite_inverse(s.along.z);
      y_ = quad(from.y - field.middle_);
      along_y_ = quad(s.along.y);
      const double highest = std::max(std::abs(field.bounds_.low.y), std::abs(field.bounds_.high.y));
      above_ = quad(slack(2 * std::abs(from.y) + highest + 4 * std::abs(s.along.y) * (out_ - base_)));
    }
    /// A bit for each of four cells that the segment may meet up to its reach; z: where their row begins, with the
    /// heights there and behind it.
    [[nodiscard]] PHYSIM_INLINE unsigned meets(double z, const float* near, const float* far, double reach) const {
      double in_z = 0, out_z = std::min(reach, out_) - base_;
      if (per_z_ != 0) {
        in_z = std::clamp((z + near_z_) * per_z_, 0.0, 2.0);
        out_z = std::min(out_z, (z + far_z_) * per_z_);
      }
      const Quad in = max(enters_, Quad(static_cast<float>(in_z)));
      const Quad out = min(leaves_, Quad(static_cast<float>(std::max(out_z, -2.0)))) * (1 + 0x1p-20f);
      const Quad one = y_ + along_y_ * in, other = y_ + along_y_ * out;
      const Quad a = Quad::load(near), b = Quad::load(near + 1), c = Quad::load(far), d = Quad::load(far + 1);
      return lanes_at_most(in, out) & lanes_at_most(min(one, other) - above_, max(max(a, b), max(c, d))) &
             lanes_at_most(min(min(a, b), min(c, d)), max(one, other) + above_);
    }

   private:
    [[nodiscard]] static Quad lanes() {
      constexpr float kLanes[] = {0, 1, 2, 3};
      return Quad::load(kLanes);
    }

    double base_, out_, near_z_, far_z_, per_z_ = 0;  // per_z_: 0 where it does not go along the axis
    Quad enters_, leaves_, y_, along_y_, above_;      // enters_, leaves_: columns, from base_ on
  };

  /// Those of a block that a way may meet.
  [[nodiscard]] FieldCells cells_in(const FieldWay<double>& way, const Range& columns, const Range& rows) const {
    const FieldGrid over = grid();
    const double column = columns.first, row = rows.first;
    std::uint32_t some = block_of(columns.count, rows.count);
    if (way.size(column, row) <= kManyCells) {
      const BlockWay<double> block = way_in_block(over, way, column, row);
      float numbers[kBlockWayNumbers];
      for (int i = 0; i < kBlockWayNumbers; ++i) numbers[i] = static_cast<float>((&block.x)[i]);
      some = field_kernel().cells_in_block(over, numbers, {columns.first, rows.first, some});
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
