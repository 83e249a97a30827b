// Walks over many cells of a height field: which blocks a way may meet, eight strips of them side by side.
//
// What it models: a way that flies clear of the ground is above a plane over each block that it passes, mostly, which
//   takes little to find out for all of them at once; only the cells of other blocks are looked at.
// Symbols: per_column, per_row: how steep the plane of a block is [m a cell]; above: how far the way is above it at its
//   start [m]; rate: how much that changes over all of the way [m]; in, out: the part of the way over the block, or
//   beside it by as much as something may be met [-].
// Equations: within the block above + rate t is least at in or out. What a sphere at that distance touches is as far
//   beside its middle as it is wide at most, where the plane is higher by as much as it is steep.
#pragma once

#include <bit>

#include "collide/field_job.hpp"
#include "math/lane_bits.hpp"

PHYSIM_ISA_BEGIN

/// Where a number of a BlockWay is that counts along an axis, and the one along the other axis that belongs to it.
enum Along : int { kFrom = 0, kWay = 3, kPer = 6, kBeyond = 8 };
PHYSIM_INLINE double number_of(const collide::FieldWalk& walk, Along which, int axis) {
  return walk.numbers[which + axis * (which < kPer ? 2 : 1)];
}

using Strips = Pack<double, int(collide::kStripsAtOnce)>;

/// Parts of a way, one for each strip.
struct StripParts {
  Strips in, out;

  /// That over some cells of it along an axis.
  PHYSIM_INLINE static StripParts over(const collide::FieldWalk& walk, int axis, const Strips& first,
                                       const Strips& end) {
    const Strips from(number_of(walk, kFrom, axis)), per(number_of(walk, kPer, axis));
    const Strips beyond(number_of(walk, kBeyond, axis));
    const Strips one = (first - beyond - from) * per, other = (end + beyond - from) * per;
    return {min(one, other), max(one, other)};
  }
  PHYSIM_INLINE StripParts within(const Strips& from, const Strips& to) const { return {max(in, from), min(out, to)}; }
};

/// Planes of blocks, one for each strip.
struct StripPlanes {
  Strips over, along[2];  // along x and z

  /// Those whose numbers, as they lie, are told.
  PHYSIM_INLINE static StripPlanes load(const collide::FieldGrid& grid, const Strips& numbers) {
    double number[collide::kStripsAtOnce];
    float over[collide::kStripsAtOnce], along_x[collide::kStripsAtOnce], along_z[collide::kStripsAtOnce];
    numbers.store(number);
    for (std::size_t i = 0; i < collide::kStripsAtOnce; ++i) {
      PHYSIM_ASSERT(number[i] >= 0 &&
                    number[i] < double(grid.planes_a_row) * ((grid.rows - 2) / collide::kBlockSide + 1));
      const collide::FieldPlane& plane = grid.planes[static_cast<std::int64_t>(number[i])];
      over[i] = plane.over, along_x[i] = plane.per_column, along_z[i] = plane.per_row;
    }
    using Floats = Pack<float, int(collide::kStripsAtOnce)>;
    return {cast<double>(Floats::load(over)),
            {cast<double>(Floats::load(along_x)), cast<double>(Floats::load(along_z))}};
  }
};

/// The strips at hand: which of the walk each lane is, and the part of the way over it.
struct StripsAtHand {
  Strips strip;
  StripParts part;
  unsigned some;  // lanes that have one, with a part of the way
};

PHYSIM_INLINE StripsAtHand strips_at_hand(const collide::FieldWalk& walk) {
  constexpr double kLane[] = {0, 1, 2, 3, 4, 5, 6, 7};
  static_assert(std::size(kLane) == collide::kStripsAtOnce && collide::kBlockSide == 4);
  const int axis = walk.axis;
  const Strips last(walk.strips - 1.0), side{double(collide::kBlockSide)};
  const Strips nth = Strips(double(walk.begun)) + Strips::load(kLane), here = min(nth, last);
  const Strips strip = number_of(walk, kPer, axis) < 0 ? last - here : here;
  const Strips first = strip * side, end = min(first + side, Strips(double(walk.count[axis])));
  const StripParts part = StripParts::over(walk, axis, first, end).within(Strips(0.0), Strips(walk.within));
  return {strip, part, lanes_at_most(nth, last) & lanes_at_most(part.in, part.out)};
}

/// Which of these strips the way is not above the planes of, at a block across each of them.
PHYSIM_INLINE unsigned not_above(const collide::FieldGrid& grid, const collide::FieldWalk& walk, const StripsAtHand& at,
                                 const Strips& block) {
  const int axis = walk.axis, across = 1 - axis;
  const double row = grid.planes_a_row, per[] = {1, row};
  const Strips first(row * (walk.first[1] / collide::kBlockSide) + walk.first[0] / collide::kBlockSide);
  const StripPlanes planes =
      StripPlanes::load(grid, first + at.strip * Strips(per[axis]) + block * Strips(per[across]));
  const Strips side{double(collide::kBlockSide)}, begin = block * side;
  const StripParts part = StripParts::over(walk, across, begin, begin + side).within(at.part.in, at.part.out);
  const auto number = [&](Along which, int of) PHYSIM_INLINE_LAMBDA { return Strips(number_of(walk, which, of)); };
  const Strips& a = planes.along[axis];
  const Strips& b = planes.along[across];
  const Strips above = Strips(walk.numbers[1]) - planes.over - a * (number(kFrom, axis) - at.strip * side) -
                       b * (number(kFrom, across) - begin);
  const Strips rate = Strips(walk.numbers[4]) - a * number(kWay, axis) - b * number(kWay, across);
  const Strips least = min(above + rate * part.in, above + rate * part.out);
  const Strips slack = Strips(walk.numbers[10]) + (abs(a) + abs(b)) * Strips(walk.numbers[11]);
  return lanes_at_most(part.in, part.out) & lanes_at_most(least, slack);
}

/// Looks at the strips at hand, at two blocks across each of them.
PHYSIM_INLINE void look_at_strips(const collide::FieldGrid& grid, collide::FieldWalk& walk) {
  if (walk.across == 0) walk.within = walk.reach;
  const StripsAtHand at = strips_at_hand(walk);
  const int across = 1 - walk.axis;
  const Strips start(number_of(walk, kFrom, across)), along(number_of(walk, kWay, across));
  const Strips beyond(number_of(walk, kBeyond, across)), zero(0.0), last(walk.count[across] - 1.0);
  const Strips one = start + along * at.part.in, other = start + along * at.part.out;
  constexpr double kPerSide = 1.0 / collide::kBlockSide;
  const auto block_of_cell = [&](const Strips& cell) PHYSIM_INLINE_LAMBDA {
    return floor_small(clamp(cell, zero, last) * Strips(kPerSide));
  };
  const Strips end = block_of_cell(max(one, other) + beyond);
  const Strips first = block_of_cell(min(one, other) - beyond) + Strips(double(walk.across));
  const Strips second = first + Strips(1.0);
  const unsigned has_first = at.some & lanes_at_most(first, end), has_second = at.some & lanes_at_most(second, end);
  walk.some[0] = has_first & not_above(grid, walk, at, min(first, end));
  walk.some[1] = has_second & not_above(grid, walk, at, min(second, end));
  first.store(walk.blocks);
  at.strip.store(walk.at);
  at.part.in.store(walk.in);
  if (walk.in[0] > walk.reach) return void(walk.begun = walk.strips);  // the others are farther
  walk.across += 2;
  if ((at.some & lanes_at_most(first + Strips(2.0), end)) != 0) return;
  walk.across = 0;
  walk.begun += collide::kStripsAtOnce;
}

/// The next one of the blocks at hand, whose cells are told from the first one of the walk on.
PHYSIM_INLINE collide::FieldCells next_block(collide::FieldWalk& walk) {
  const int lane = std::countr_zero(walk.some[0] | walk.some[1]);
  const std::uint32_t one = 1u << lane, other = (walk.some[0] & one) != 0 ? 0 : 1;
  walk.some[other] &= ~one;
  if (walk.in[lane] > walk.reach) return {0, 0, 0};
  std::uint32_t first[2], count[2];
  first[walk.axis] = static_cast<std::uint32_t>(walk.at[lane]) * collide::kBlockSide;
  first[1 - walk.axis] = (static_cast<std::uint32_t>(walk.blocks[lane]) + other) * collide::kBlockSide;
  for (int i = 0; i < 2; ++i) count[i] = min(walk.count[i] - first[i], collide::kBlockSide);
  return {first[0], first[1], block_of(count[0], count[1])};
}

PHYSIM_ISA_END
