// Segments over a height field: what the kernels of each instruction set offer, and the choice among them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "collide/field_block.hpp"
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

struct FieldKernel {
  const char* name;
  /// Those cells of a block that a way may meet: the numbers of its BlockWay, in float.
  std::uint32_t (*cells_in_block)(const FieldGrid& grid, const float* way, const FieldCells& block);
  void (*find_cells)(FieldJob& job);
};
/// That of the instruction set in use.
[[nodiscard]] const FieldKernel& field_kernel();

}  // namespace physim::collide
