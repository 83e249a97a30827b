// Segments over a height field: what the kernels of each instruction set offer, and the choice among them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "collide/field_block.hpp"
#include "collide/segment.hpp"
#include "physim/scene.hpp"

namespace physim::collide {

inline constexpr std::size_t kFieldSegments = 128;  // at a time

/// A segment that may meet a field.
struct FieldNear {
  std::uint32_t number;
  FieldCells cells;
};

/// Which of some segments may meet a field, and where. All of them make sense.
struct FieldJob {
  FieldGrid grid;
  Vec3d x, y, z, position;  // axes of the field, and where it stands
  double per_scale;
  const SceneSegment* segments;
  const std::uint32_t* numbers;  // of the segments that are asked about
  std::size_t count;             // of those
  FieldNear* near;               // room for one more than are asked about
  std::size_t found;             // so many of them, in order
};

inline constexpr std::size_t kStripsAtOnce = 8;

/// A way over many cells, which is looked at by blocks of them: strips of blocks across the axis that it goes along
/// most, one after the other. Blocks begin at multiples of their side.
struct FieldWalk {
  double numbers[kBlockWayNumbers];  // of its BlockWay, as seen from the first cell of the first block
  float rounded[kBlockWayNumbers];
  std::uint32_t first[2], count[2];  // cells from there to the last one that it may meet, along x and z
  int axis;                          // along which it goes most: 0 or 1
  std::uint32_t strips, begun;       // so many of them were looked at,
  std::uint32_t across;              // and so many blocks across those after them
  std::uint32_t some[2];  // bits of strips at hand that may meet something in a block, or in the one beside it
  double at[kStripsAtOnce], blocks[kStripsAtOnce], in[kStripsAtOnce];  // which ones; these blocks; where it comes there
  double within;  // the reach when strips at hand were first looked at: blocks across them are counted by that
  double reach;   // farther along it nothing is wanted any more
};

/// Where the points of a field are.
struct FieldPoints {
  const double* heights;        // row by row [m]
  std::uint32_t columns;        // of points
  double spacing_x, spacing_z;  // [m]
};

struct FieldKernel {
  const char* name;
  /// Those cells of a block that a way may meet: the numbers of its BlockWay, in float.
  std::uint32_t (*cells_in_block)(const FieldGrid& grid, const float* way, const FieldCells& block);
  /// Cells of the next block with some that a walk may meet; none: it is over.
  FieldCells (*next_cells)(const FieldGrid& grid, FieldWalk& walk);
  /// Shortens the reach of a segment to where spheres about it touch nothing in some cells.
  void (*clear_cells)(const FieldPoints& points, const FieldCells& cells, Segment& segment);
  void (*find_cells)(FieldJob& job);
};
/// That of the instruction set in use.
[[nodiscard]] const FieldKernel& field_kernel();

}  // namespace physim::collide
