#include "base/kernel_choice.hpp"
#include "base/kernel_copies.hpp"
#include "collide/field_job.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(std::uint32_t cells_in_block(const collide::FieldGrid& grid, const float* way,
                                                  const collide::FieldCells& block);
                     collide::FieldCells next_cells(const collide::FieldGrid& grid, collide::FieldWalk& walk);
                     void clear_cells(const collide::FieldPoints& points, const collide::FieldCells& cells,
                                      collide::Segment& segment);
                     void find_cells(collide::FieldJob& job);)

namespace collide {
namespace {

constexpr FieldKernel kFieldKernels[] = {
#if PHYSIM_HAVE_AVX512
    {"avx512", avx512::cells_in_block, avx512::next_cells, avx512::clear_cells, avx512::find_cells},
#endif
#if PHYSIM_HAVE_AVX2
    {"avx2", avx2::cells_in_block, avx2::next_cells, avx2::clear_cells, avx2::find_cells},
#endif
    {"base", base::cells_in_block, base::next_cells, base::clear_cells, base::find_cells},
};

}  // namespace

const FieldKernel& field_kernel() { return copy_in_use(kFieldKernels); }

}  // namespace collide
}  // namespace physim
