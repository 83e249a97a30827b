// Work on whole columns of a study's shots: what the kernels of each instruction set offer, and the choice among them.
//
// Each gives the bits that shot by shot gives. What is gathered over shots is gathered in eight lanes, sums in four,
// whatever the instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "physim/math.hpp"

namespace physim {

/// Moves shots along their last bit of path, or back, to the plane of impact.
struct PlaneJob {
  Vec3d forward, muzzle;  // the plane's normal, and where the range is counted from [m]
  double range;           // [m]
  Vec3d acceleration;     // [m/s^2]
  double most_time;       // of the time of flight; a shot that needs more gets a NaN as its x
  double* time;           // [s]
  double *x, *y, *z;      // [m]
  double *vx, *vy, *vz;   // [m/s]
  std::size_t count;
};

/// How far places lie along an axis from where it starts.
struct AxisJob {
  Vec3d axis, start;
  const double *x, *y, *z;
  double* along;
  std::size_t count;
};

/// Extreme spreads of groups of consecutive shots; NaN if a shot of a group is NaN.
struct SpreadJob {
  const double *right, *up;
  std::size_t size;  // of a group
  std::size_t groups;
  double* spreads;  // of each group
};

struct LeastAndMost {
  double least, most;
};

/// Cells of study/cells.hpp, by their numbers.
struct CellJob {
  const double* numbers;
  double centre, per_scale;
  std::uint64_t* cells;  // the bits of signed numbers
  std::size_t count;
};

/// The farthest of impacts along directions.
struct ReachJob {
  static constexpr std::size_t kDirections = 16;
  const double *right, *up;
  std::size_t count;                                 // > 0
  double to_right[kDirections], to_up[kDirections];  // unit vectors
  double reach[kDirections];
};

/// Means of columns, and sums of products of what is left of two of them: (0, 0), (0, 1) ... (1, 1) ...
struct MomentsJob {
  const double* const* columns;
  std::size_t columns_count, count;  // count > 0
  double *means, *products;
};

struct ShardKernel {
  const char* name;
  /// offset + factor x for each x; `into` may be `from`.
  void (*stretch)(double offset, double factor, const double* from, double* into, std::size_t count);
  void (*to_plane)(const PlaneJob& job);
  void (*along)(const AxisJob& job);
  /// Lengths of vectors.
  void (*lengths)(const double* x, const double* y, const double* z, double* into, std::size_t count);
  /// Distances from a point of the plane.
  void (*distances)(const double* right, const double* up, double from_right, double from_up, double* into,
                    std::size_t count);
  bool (*all_finite)(const double* numbers, std::size_t count);
  /// There are some numbers, and none of them is NaN.
  LeastAndMost (*least_and_most)(const double* numbers, std::size_t count);
  void (*moments)(const MomentsJob& job);
  void (*cells)(const CellJob& job);
  void (*spreads)(const SpreadJob& job);
  void (*reach)(ReachJob& job);
};

/// That of the instruction set of the batch kernel in use.
[[nodiscard]] const ShardKernel& shard_kernel();

}  // namespace physim
