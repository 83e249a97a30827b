#include "world/kernels.hpp"

#include <string_view>

#include "flight/kernels.hpp"

#ifndef PHYSIM_HAVE_AVX2
#define PHYSIM_HAVE_AVX2 0
#endif
#ifndef PHYSIM_HAVE_AVX512
#define PHYSIM_HAVE_AVX512 0
#endif

namespace physim {

inline namespace base {
bool step_rows(const WorldJob<float>& job);
bool step_rows(const WorldJob<double>& job);
bool advance_forced(const ForcedJob<float>& job);
bool advance_forced(const ForcedJob<double>& job);
}  // namespace base
#if PHYSIM_HAVE_AVX2
namespace avx2 {
bool step_rows(const WorldJob<float>& job);
bool step_rows(const WorldJob<double>& job);
bool advance_forced(const ForcedJob<float>& job);
bool advance_forced(const ForcedJob<double>& job);
}  // namespace avx2
#endif
#if PHYSIM_HAVE_AVX512
namespace avx512 {
bool step_rows(const WorldJob<float>& job);
bool step_rows(const WorldJob<double>& job);
bool advance_forced(const ForcedJob<float>& job);
bool advance_forced(const ForcedJob<double>& job);
}  // namespace avx512
#endif

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
