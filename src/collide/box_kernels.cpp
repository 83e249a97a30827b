#include "base/kernel_choice.hpp"
#include "base/kernel_copies.hpp"
#include "collide/box_job.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(void enter_boxes(collide::BoxJob& job); void pass_triangles(collide::TriangleJob& job);
                     void clear_triangles(const collide::ClearJob& job);)

namespace collide {
namespace {

constexpr BoxKernel kBoxKernels[] = {
#if PHYSIM_HAVE_AVX512
    {"avx512", avx512::enter_boxes, avx512::pass_triangles, avx512::clear_triangles},
#endif
#if PHYSIM_HAVE_AVX2
    {"avx2", avx2::enter_boxes, avx2::pass_triangles, avx2::clear_triangles},
#endif
    {"base", base::enter_boxes, base::pass_triangles, base::clear_triangles},
};

}  // namespace

const BoxKernel& box_kernel() { return copy_in_use(kBoxKernels); }

}  // namespace collide
}  // namespace physim
