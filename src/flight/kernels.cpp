#include "flight/kernels.hpp"

#include <algorithm>
#include <string>

#include "base/kernel_copies.hpp"
#include "physim/flight.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(void fly_bodies(const BatchJob<float>& job); void fly_bodies(const BatchJob<double>& job);
                     void fly_bodies_singly(const BatchJob<float>& job);
                     void fly_bodies_singly(const BatchJob<double>& job);)

namespace {

constexpr BatchKernel kBatchKernels[] = {
#if PHYSIM_HAVE_AVX512
    {"avx512", avx512::fly_bodies, avx512::fly_bodies},
#endif
#if PHYSIM_HAVE_AVX2
    {"avx2", avx2::fly_bodies, avx2::fly_bodies},
#endif
    {"base", base::fly_bodies, base::fly_bodies},
#ifndef PHYSIM_WITHOUT_SCALAR
    {"scalar", base::fly_bodies_singly, base::fly_bodies_singly},
#endif
};

#if PHYSIM_HAVE_AVX2 && !defined(PHYSIM_WITHOUT_SCALAR)
constexpr BatchKernel kSinglyByAvx2{"scalar", avx2::fly_bodies_singly, avx2::fly_bodies_singly};
#endif

}  // namespace

const BatchKernel& batch_kernel() {
  const BatchKernel& kernel = copy_in_use(kBatchKernels);
#if PHYSIM_HAVE_AVX2 && !defined(PHYSIM_WITHOUT_SCALAR)
  static const bool has_avx2 = std::ranges::count(kernel_names(), "avx2") > 0;
  if (has_avx2 && kernel.name == std::string_view("scalar")) return kSinglyByAvx2;
#endif
  return kernel;
}

std::vector<std::string> kernels() { return {kernel_names().begin(), kernel_names().end()}; }

bool use_kernel(const std::string& name) { return choose_kernel(name); }

}  // namespace physim
