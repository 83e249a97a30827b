#include "base/kernel_choice.hpp"
#include "base/kernel_copies.hpp"
#include "study/draw_job.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(void draw_units(const UnitsJob& job);
                     void normal_quantiles_of(double* numbers, std::size_t count);)

namespace {

constexpr DrawKernel kDrawKernels[] = {
#if PHYSIM_HAVE_AVX512
    {"avx512", avx512::draw_units, avx512::normal_quantiles_of},
#endif
#if PHYSIM_HAVE_AVX2
    {"avx2", avx2::draw_units, avx2::normal_quantiles_of},
#endif
    {"base", base::draw_units, base::normal_quantiles_of},
};

}  // namespace

// Numbers know nothing of how many are drawn.
const DrawKernel& draw_kernel() { return copy_in_use(kDrawKernels); }

}  // namespace physim
