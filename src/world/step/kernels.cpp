#include "world/step/kernels.hpp"

#include <string_view>

#include "base/kernel_choice.hpp"
#include "base/kernel_copies.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(bool step_rows(const WorldJob<float>& job); bool step_rows(const WorldJob<double>& job);
                     bool advance_forced(const ForcedJob<float>& job);
                     bool advance_forced(const ForcedJob<double>& job); void strike_rows(StrikeJob<float>& job);
                     void strike_rows(StrikeJob<double>& job);)

#define PHYSIM_WORLD_KERNEL(isa)                                                                                 \
  WorldKernel {                                                                                                  \
    isa::step_rows, isa::step_rows, isa::advance_forced, isa::advance_forced, isa::strike_rows, isa::strike_rows \
  }

WorldKernel world_kernel() {
  // "scalar" is for single flights: rows are always stepped in packs, of the narrowest kind then.
  const std::string_view name = kernel_in_use();
#if PHYSIM_HAVE_AVX512
  if (name == "avx512") return PHYSIM_WORLD_KERNEL(avx512);
#endif
#if PHYSIM_HAVE_AVX2
  if (name == "avx2") return PHYSIM_WORLD_KERNEL(avx2);
#endif
  (void)name;
  return PHYSIM_WORLD_KERNEL(base);
}

#undef PHYSIM_WORLD_KERNEL

}  // namespace physim
