#include "world/kernels.hpp"

#include <string_view>

#include "base/kernel_copies.hpp"
#include "flight/kernels.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(bool step_rows(const WorldJob<float>& job); bool step_rows(const WorldJob<double>& job);
                     Advanced advance_forced(const ForcedJob<float>& job);
                     Advanced advance_forced(const ForcedJob<double>& job);)

WorldKernel world_kernel() {
  // "scalar" is for single flights: rows are always stepped in packs, of the narrowest kind then.
  const std::string_view name = batch_kernel().name;
#if PHYSIM_HAVE_AVX512
  if (name == "avx512") return {avx512::step_rows, avx512::step_rows, avx512::advance_forced, avx512::advance_forced};
#endif
#if PHYSIM_HAVE_AVX2
  if (name == "avx2") return {avx2::step_rows, avx2::step_rows, avx2::advance_forced, avx2::advance_forced};
#endif
  (void)name;
  return {base::step_rows, base::step_rows, base::advance_forced, base::advance_forced};
}

}  // namespace physim
