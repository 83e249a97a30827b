#include "base/kernel_choice.hpp"
#include "base/kernel_copies.hpp"
#include "study/draw_job.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(void draw_units(const UnitsJob& job);
                     void draw_normals(double* numbers, std::size_t count, const NormalScale& scale);)

namespace {

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

// Numbers know nothing of how many are drawn.
const DrawKernel& draw_kernel() { return copy_in_use(kDrawKernels); }

}  // namespace physim
