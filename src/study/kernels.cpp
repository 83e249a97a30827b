#include "base/kernel_choice.hpp"
#include "base/kernel_copies.hpp"
#include "study/draw_job.hpp"
#include "study/shard_job.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(
    void stretch_column(double offset, double factor, const double* from, double* into, std::size_t count);
    void move_to_plane(const PlaneJob& job); void put_along(const AxisJob& job);
    void put_lengths(const double* x, const double* y, const double* z, double* into, std::size_t count);
    void put_distances(const double* right, const double* up, double from_right, double from_up, double* into,
                       std::size_t count);
    bool all_are_finite(const double* numbers, std::size_t count);
    LeastAndMost least_and_most_of(const double* numbers, std::size_t count); void put_moments(const MomentsJob& job);
    void put_cells(const CellJob& job); void put_spreads(const SpreadJob& job); void put_reach(ReachJob& job);)

PHYSIM_KERNEL_COPIES(void draw_units(const UnitsJob& job);
                     void draw_normals(double* numbers, std::size_t count, const NormalScale& scale);)

namespace {

#define PHYSIM_SHARD_KERNEL(isa)                                                                         \
  {                                                                                                      \
#isa, isa::stretch_column, isa::move_to_plane, isa::put_along, isa::put_lengths, isa::put_distances, \
        isa::all_are_finite, isa::least_and_most_of, isa::put_moments, isa::put_cells, isa::put_spreads, \
        isa::put_reach                                                                                   \
  }

constexpr ShardKernel kShardKernels[] = {
#if PHYSIM_HAVE_AVX512
    PHYSIM_SHARD_KERNEL(avx512),
#endif
#if PHYSIM_HAVE_AVX2
    PHYSIM_SHARD_KERNEL(avx2),
#endif
    PHYSIM_SHARD_KERNEL(base),
};

#undef PHYSIM_SHARD_KERNEL

constexpr DrawKernel kDrawKernels[] = {
#if PHYSIM_HAVE_AVX512
    {"avx512", avx512::draw_units, avx512::draw_normals},
#endif
#if PHYSIM_HAVE_AVX2
    {"avx2", avx2::draw_units, avx2::draw_normals},
#endif
    {"base", base::draw_units, base::draw_normals},
};

}  // namespace

const ShardKernel& shard_kernel() { return copy_in_use(kShardKernels); }

// Numbers know nothing of how many are drawn.
const DrawKernel& draw_kernel() { return copy_in_use(kDrawKernels); }

}  // namespace physim
