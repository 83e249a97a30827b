// Heights over a grid: a segment walks over the cells below it, four columns at a time.
#pragma once

#include <bit>
#include <vector>

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
  [[nodiscard]] HeightFieldShape definition() const {
    return {columns_, rows_, spacing_x_, spacing_z_, {heights_.begin(), heights_.end() - kMore}};
  }

  /// Calls take(crossing, segment) for each triangle met.
  template <class Take>
  void crossings(Segment& s, const Take& take) const {
    std::optional<Shear> shear;  // many segments come to no triangle
    triangles_along(s, [&](const Triangle& triangle, std::uint32_t number) {
      if (!shear) shear.emplace(s);
      auto crossing = meets(s, *shear, triangle);
      if (!crossing) return;
      crossing->primitive = number;
      take(*crossing, s);
    });
  }
  /// Calls visit(triangle, number) for those that a segment may meet, which shortens its reach: four columns after
  /// four.
  template <class Visit>
  void triangles_along(Segment& s, const Visit& visit) const {
    const double wide = slack(s), per_x = s.along.x == 0 ? 0 : finite_inverse(s.along.x);
    const Slab columns = slab(s.from.x, per_x, 0, (columns_ - 1) * spacing_x_, wide, s.reach);
    if (!columns.some) return;
    const Range over =
        cells(s.from.x + s.along.x * columns.in, s.from.x + s.along.x * columns.out, per_spacing_x_, columns_, wide);
    if (over.count <= 4) return triangles_in(s, over, columns, wide, per_x, visit);
    const std::uint32_t strips = (over.count + 3) / 4;
    for (std::uint32_t i = 0; i < strips; ++i) {
      const std::uint32_t at = 4 * (s.along.x >= 0 ? i : strips - 1 - i);
      const Range strip{over.first + at, std::min(4u, over.count - at)};
      const Slab here =
          slab(s.from.x, per_x, strip.first * spacing_x_, (strip.first + strip.count) * spacing_x_, wide, s.reach);
      if (here.some) triangles_in(s, strip, here, wide, per_x, visit);
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
  static constexpr int kMore = 3;             // numbers behind the heights, as four are read at once
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

  /// Calls visit(triangle, number) for those of four columns of cells, or fewer, which the segment passes `here`.
  template <class Visit>
  void triangles_in(const Segment& s, const Range& columns, const Slab& here, double wide, double per_x,
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
      const double* heights = &heights_[std::size_t{row} * columns_ + columns.first];
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
        enters_ = larger(min(one, other), enters_);
        leaves_ = larger(one, other);
      }
      const double aside = slack(0);
      const bool forwards = s.along.z >= 0;
      near_z_ = (forwards ? -aside : field.spacing_z_ + aside) - from.z;
      far_z_ = (forwards ? field.spacing_z_ + aside : -aside) - from.z;
      if (s.along.z != 0) per_z_ = finite_inverse(s.along.z);
      y_ = quad(from.y);
      along_y_ = quad(s.along.y);
      const double highest = std::max(std::abs(field.bounds_.low.y), std::abs(field.bounds_.high.y));
      above_ = quad(slack(2 * std::abs(from.y) + highest + 4 * std::abs(s.along.y) * (out_ - base_)));
    }
    /// A bit for each of four cells that the segment may meet up to its reach; z: where their row begins, with the
    /// heights there and behind it.
    [[nodiscard]] PHYSIM_INLINE unsigned meets(double z, const double* near, const double* far, double reach) const {
      double in_z = 0, out_z = std::min(reach, out_) - base_;
      if (per_z_ != 0) {
        in_z = std::clamp((z + near_z_) * per_z_, 0.0, 2.0);
        out_z = std::min(out_z, (z + far_z_) * per_z_);
      }
      const Quad in = larger(enters_, Quad(static_cast<float>(in_z)));
      const Quad out = min(leaves_, Quad(static_cast<float>(std::max(out_z, -2.0)))) * (1 + 0x1p-20f);
      const Quad one = y_ + along_y_ * in, other = y_ + along_y_ * out;
      const Quad a = rounded(near), b = rounded(near + 1), c = rounded(far), d = rounded(far + 1);
      return lanes_up_to(in, out) & lanes_up_to(min(one, other) - above_, larger(larger(a, b), larger(c, d))) &
             lanes_up_to(min(min(a, b), min(c, d)), larger(one, other) + above_);
    }

   private:
    [[nodiscard]] static Quad lanes() {
      constexpr float kLanes[] = {0, 1, 2, 3};
      return Quad::load(kLanes);
    }

    double base_, out_, near_z_, far_z_, per_z_ = 0;  // per_z_: 0 where it does not go along the axis
    Quad enters_, leaves_, y_, along_y_, above_;      // enters_, leaves_: columns, from base_ on
  };

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
  std::vector<double> heights_;  // and kMore numbers
  std::vector<Level> levels_;    // the last one has one block
  Bounds bounds_;
  double extent_ = 0;  // the largest coordinate [m]
};

}  // namespace physim::collide
