// Chooses the batch kernel: the best that the machine runs, unless told otherwise.
#include "flight/kernels.hpp"

#include <atomic>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "base/kernel_copies.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(void fly_bodies(const BatchJob<float>& job); void fly_bodies(const BatchJob<double>& job);
                     void fly_bodies_singly(const BatchJob<float>& job);
                     void fly_bodies_singly(const BatchJob<double>& job);)

namespace {

const std::vector<BatchKernel>& available() {
  static const std::vector<BatchKernel> list = [] {
    std::vector<BatchKernel> found;
    BatchKernel singly{"scalar", base::fly_bodies_singly, base::fly_bodies_singly};
#if PHYSIM_HAVE_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd"))
      found.push_back({"avx512", avx512::fly_bodies, avx512::fly_bodies});
#endif
#if PHYSIM_HAVE_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) {
      found.push_back({"avx2", avx2::fly_bodies, avx2::fly_bodies});
      singly = {"scalar", avx2::fly_bodies_singly, avx2::fly_bodies_singly};
    }
#endif
    found.push_back({"base", base::fly_bodies, base::fly_bodies});
    found.push_back(singly);
    return found;
  }();
  return list;
}

const BatchKernel* find(std::string_view name) {
  for (const BatchKernel& kernel : available())
    if (kernel.name == name) return &kernel;
  return nullptr;
}

const BatchKernel* at_start() {
  const char* wanted = std::getenv("PHYSIM_KERNEL");
  const BatchKernel* kernel = wanted ? find(wanted) : nullptr;
  return kernel ? kernel : &available().front();
}

std::atomic<const BatchKernel*>& chosen() {
  static std::atomic<const BatchKernel*> kernel{at_start()};
  return kernel;
}

}  // namespace

const BatchKernel& batch_kernel() {
  const BatchKernel* kernel = chosen().load();
  PHYSIM_ASSERT(kernel != nullptr && kernel->fly_float != nullptr && kernel->fly_double != nullptr);
  return *kernel;
}

std::vector<std::string> kernels() {
  std::vector<std::string> names;
  for (const BatchKernel& kernel : available()) names.emplace_back(kernel.name);
  return names;
}

bool use_kernel(const std::string& name) {
  const BatchKernel* kernel = name.empty() ? &available().front() : find(name);
  if (kernel) chosen().store(kernel);
  return kernel != nullptr;
}

}  // namespace physim
