// Blocks of four times four cells of a height field, each compared with a segment at once.
//
// What it models: in which cells a segment may meet the surface, or come as near to it as its radius. Nothing is
//   missed; what is told beyond that is little, so most of it is met.
// Symbols: u, w a place in a cell, in parts of its sides; h00, h10, h01, h11 heights of its corners, along x, then z;
//   a = h10 - h00, b = h01 - h00, c = h11 - h01 - a.
// Equations: the half of the cell with u + w <= 1 is part of the plane h00 + a u + b w, which a point is f0 above; the
//   other one of a plane which it is f1 = f0 + c (1 - u - w) above. The surface is the higher of both where c >= 0, the
//   lower where not: a point is min(f0, f1) or max(f0, f1) above it. Along a line f0 and f1 change steadily, so their
//   values where it enters and leaves a cell bound those between.
#pragma once

#include <cstdint>
#include <limits>

#include "math/lane_bits.hpp"
#include "math/vec3.hpp"

namespace physim::collide {

inline constexpr std::uint32_t kBlockSide = 4;  // in cells
inline constexpr double kManyCells = 1e6;       // floats do not tell cells apart where a way is so long or wide

/// A plane that no point of the surface in a block is above: there is one for each block whose first column and row are
/// multiples of its side.
struct FieldPlane {
  float over;                 // how high it is at the first corner, above the middle height [m]
  float per_column, per_row;  // how much it rises from one to the next [m]
};

/// Heights over a grid, in float.
struct FieldGrid {
  const float* heights;                 // less the middle one, row by row; 4 rows and 4 numbers more can be read
  std::uint32_t columns, rows;          // of its points
  double per_spacing_x, per_spacing_z;  // [1/m]
  double low, high, middle;             // of the heights [m]
  double extent;                        // the largest coordinate [m]
  const FieldPlane* planes;             // of its blocks, row by row
  std::uint32_t planes_a_row;
};

/// Where a segment may meet a field: some cells of a block, bit 4 row + column from its first one on.
struct FieldCells {
  static constexpr std::uint32_t kFar = 1 << 16;  // it is not within one block

  std::uint32_t column, row, some;
};

}  // namespace physim::collide

PHYSIM_ISA_BEGIN

/// A way over a grid: in cells along x and z, in m above the middle height along y.
template <class R>
struct FieldWay {
  Vec3<R> from, along;
  R wide_x, wide_z, wide;  // how far beside it something may be met

  /// Counts cells; it is as large as the largest of its numbers that do.
  [[nodiscard]] PHYSIM_INLINE R size(const R& column, const R& row) const {
    return abs(from.x - column) + abs(from.z - row) + abs(along.x) + abs(along.z) + wide_x + wide_z;
  }
};
/// From the number of a cell to that of another one.
template <class R>
struct CellRange {
  R first, last;
};

/// What coordinates are rounded to, with the radius [m].
template <class R>
PHYSIM_INLINE R slack_over(const collide::FieldGrid& grid, const Vec3<R>& from, const Vec3<R>& along, const R& radius) {
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  const R most_from = max(abs(from.x), max(abs(from.y), abs(from.z)));
  const R most_along = max(abs(along.x), max(abs(along.y), abs(along.z)));
  return radius + (most_from + most_along + radius + R(grid.extent)) * R(kRounding);
}
template <class R>
PHYSIM_INLINE FieldWay<R> way_over(const collide::FieldGrid& grid, const Vec3<R>& from, const Vec3<R>& along,
                                   const R& wide) {
  const R per_x(grid.per_spacing_x), per_z(grid.per_spacing_z);
  return {{from.x * per_x, from.y - R(grid.middle), from.z * per_z},
          {along.x * per_x, along.y, along.z * per_z},
          wide * per_x,
          wide * per_z,
          wide};
}
/// The cells of a row of points between two places, with those that lie so far beside them.
template <class R>
PHYSIM_INLINE CellRange<R> cells_between(const R& from, const R& to, const R& wide, std::uint32_t points) {
  const R last(points - 2.0);
  return {floor_small(clamp(min(from, to) - wide, R(0.0), last)),
          floor_small(clamp(max(from, to) + wide, R(0.0), last))};
}
/// Whether it is higher than all of the field, or lower.
template <class R>
PHYSIM_INLINE MaskOf<R> passes(const collide::FieldGrid& grid, const FieldWay<R>& way) {
  const R end = way.from.y + way.along.y;
  return (min(way.from.y, end) - way.wide > R(grid.high - grid.middle)) |
         (max(way.from.y, end) + way.wide < R(grid.low - grid.middle));
}

/// A way as seen from the first cell of a block.
template <class R>
struct BlockWay {
  R x, y, z, along_x, along_y, along_z;
  R per_x, per_z;        // one over the way along x and z, of a size whose products with what is in a block are numbers
  R beyond_x, beyond_z;  // how far beside it something may be met
  R flat, steep;         // how far above it: at least, and for each m that corners of a cell differ by
};
inline constexpr int kBlockWayNumbers = 12;
/// Calls put(i, number) for each of them, as they lie. One by one: what is put so can be read at once, where a loop
/// that is made of wider moves waits until its numbers are in the cache.
template <class Put>
PHYSIM_INLINE void each_number(const BlockWay<double>& way, const Put& put) {
  put(0, way.x), put(1, way.y), put(2, way.z);
  put(3, way.along_x), put(4, way.along_y), put(5, way.along_z);
  put(6, way.per_x), put(7, way.per_z), put(8, way.beyond_x), put(9, way.beyond_z);
  put(10, way.flat), put(11, way.steep);
}

template <class R>
PHYSIM_INLINE BlockWay<R> way_in_block(const collide::FieldGrid& grid, const FieldWay<R>& way, const R& column,
                                       const R& row) {
  const R rounding(0x1p-20);  // what all of this loses in float, several times
  const R aside = rounding * (R(4.0) + way.size(column, row));
  const R one(1.0), least(1e-12);
  const R heights = R(grid.high - grid.low) * (one + way.wide_x + way.wide_z) + abs(way.from.y) + abs(way.along.y);
  return {way.from.x - column,
          way.from.y,
          way.from.z - row,
          way.along.x,
          way.along.y,
          way.along.z,
          one / copysign(max(abs(way.along.x), least), way.along.x),
          one / copysign(max(abs(way.along.z), least), way.along.z),
          way.wide_x + aside,
          way.wide_z + aside,
          way.wide + rounding * (heights + way.wide),
          max(way.wide_x, way.wide_z) + aside + aside};
}

/// A way, ready to be compared with the cells of a block: as many rows at once as fit into a register.
class BlockTest {
 public:
  /// `numbers`: those of a BlockWay, `stride` apart; the block is so many cells beyond the one that it was made for.
  PHYSIM_INLINE BlockTest(const float* numbers, std::size_t stride, float columns = 0, float rows = 0) {
    const auto number = [&](std::size_t i) PHYSIM_INLINE_LAMBDA { return numbers[i * stride]; };
    const float along_x = number(3), along_z = number(5), beyond_x = number(8), beyond_z = number(9);
    constexpr float kColumnOf[] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    constexpr float kRowOf[] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    u_ = Look(number(0) - columns) - Look::load(kColumnOf);
    w_ = Look(number(2) - rows) - Look::load(kRowOf);
    y_ = Look(number(1));
    along_x_ = Look(along_x);
    along_y_ = Look(number(4));
    along_z_ = Look(along_z);
    along_xz_ = Look(along_x + along_z);
    const Look per_x(number(6));
    const Look one = (Look(-beyond_x) - u_) * per_x, other = (Look(1 + beyond_x) - u_) * per_x;
    enters_ = max(min(one, other), Look(0.0f));
    leaves_ = min(max(one, other), Look(1.0f));
    const float per_z = number(7);  // less than 0 where the way is -0, too
    per_z_ = Look(per_z);
    near_z_ = Look(per_z < 0 ? 1 + beyond_z : -beyond_z);
    far_z_ = Look(per_z < 0 ? -beyond_z : 1 + beyond_z);
    flat_ = Look(number(10));
    steep_ = Look(number(11));
  }
  /// Which of some cells may be met, by bits 4 row + column. `heights` points to that of the block's first corner;
  /// rows are `columns` heights apart.
  [[nodiscard]] PHYSIM_INLINE std::uint32_t meets(const float* heights, std::size_t columns, std::uint32_t some) const {
    std::uint32_t cells = 0;
    Look w = w_;
    for (int row = 0; some >> (4 * row) != 0; row += kRows, heights += kRows * columns, w = w - Look(float(kRows)))
      cells |= meets_rows(w, heights, columns) << (4 * row);
    return some & cells;
  }

 private:
  static constexpr int kRows = kNativeBytes / 16;
  using Look = Pack<float, 4 * kRows>;

  [[nodiscard]] PHYSIM_INLINE std::uint32_t meets_rows(const Look& w, const float* heights, std::size_t columns) const {
    const Look in = max(enters_, (near_z_ - w) * per_z_);
    const Look out = min(leaves_, (far_z_ - w) * per_z_) * Look(1 + 0x1p-20f);
    const Look h00 = rows_of(heights, columns), h10 = rows_of(heights + 1, columns);
    const Look h01 = rows_of(heights + columns, columns), h11 = rows_of(heights + columns + 1, columns);
    const Look a = h10 - h00, b = h01 - h00, c = (h11 - h01) - a;
    const Look f0 = (y_ - h00) - a * u_ - b * w, f1 = f0 + c * ((Look(1.0f) - w) - u_);
    const Look rate0 = along_y_ - a * along_x_ - b * along_z_, rate1 = rate0 - c * along_xz_;
    const Look in0 = f0 + rate0 * in, out0 = f0 + rate0 * out, in1 = f1 + rate1 * in, out1 = f1 + rate1 * out;
    const Look least0 = min(in0, out0), least1 = min(in1, out1);
    const Look most0 = max(in0, out0), most1 = max(in1, out1);
    const auto rises = c >= Look(0.0f);
    const Look least = select(rises, min(least0, least1), max(least0, least1));
    const Look most = select(rises, min(most0, most1), max(most0, most1));
    const Look slack = flat_ + (abs(a) + abs(b) + Look(2.0f) * abs(c)) * steep_;
    return lanes_at_most(in, out) & lanes_at_most(least, slack) & lanes_at_most(Look(0.0f) - slack, most);
  }
  /// Four heights of each of some rows.
  [[nodiscard]] PHYSIM_INLINE static Look rows_of(const float* heights, [[maybe_unused]] std::size_t columns) {
#if defined(__AVX__)
    const auto two = [&](const float* from) PHYSIM_INLINE_LAMBDA {
      return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(from)), _mm_loadu_ps(from + columns), 1);
    };
    Look rows;
#if defined(__AVX512F__)
    rows.r[0] = (Look::Register)_mm512_castpd_ps(_mm512_maskz_insertf64x4(
        0xff, _mm512_castps_pd(_mm512_castps256_ps512(two(heights))), _mm256_castps_pd(two(heights + 2 * columns)), 1));
#else
    rows.r[0] = (Look::Register)two(heights);
#endif
    return rows;
#else
    return Look::load(heights);
#endif
  }

  Look u_, w_, enters_, leaves_, y_, along_x_, along_y_, along_z_, along_xz_, near_z_, far_z_, per_z_, flat_, steep_;
};

/// The cells of so many columns and rows of a block.
PHYSIM_INLINE std::uint32_t block_of(std::uint32_t columns, std::uint32_t rows) {
  PHYSIM_ASSERT(columns >= 1 && columns <= collide::kBlockSide && rows >= 1 && rows <= collide::kBlockSide);
  return (0x1111u * ((1u << columns) - 1)) & ((1u << (4 * rows)) - 1);
}
/// Those cells of a block that a way may meet; its numbers may be those of a block so many columns and rows before.
PHYSIM_INLINE std::uint32_t cells_met(const collide::FieldGrid& grid, const float* numbers, std::size_t stride,
                                      const collide::FieldCells& block, float columns = 0, float rows = 0) {
  PHYSIM_ASSERT(block.column + 1 < grid.columns && block.row + 1 < grid.rows);
  return BlockTest(numbers, stride, columns, rows)
      .meets(grid.heights + std::size_t{block.row} * grid.columns + block.column, grid.columns, block.some);
}

PHYSIM_ISA_END
