#include "base/kernel_choice.hpp"

#include <atomic>
#include <cstdlib>

#include "base/kernel_copies.hpp"

namespace physim {
namespace {

const std::string_view* find_kernel_name(std::string_view name) {
  for (const std::string_view& each : kernel_names())
    if (each == name) return &each;
  return nullptr;
}

const std::string_view* kernel_at_start() {
  const char* wanted = std::getenv("PHYSIM_KERNEL");
  const std::string_view* name = wanted ? find_kernel_name(wanted) : nullptr;
  return name ? name : &kernel_names().front();
}

std::atomic<const std::string_view*>& chosen_kernel() {
  static std::atomic<const std::string_view*> name{kernel_at_start()};
  return name;
}

}  // namespace

const std::vector<std::string_view>& kernel_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> found;
#if PHYSIM_HAVE_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd"))
      found.emplace_back("avx512");
#endif
#if PHYSIM_HAVE_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
      found.emplace_back("avx2");
#endif
    found.emplace_back("base");
    found.emplace_back("scalar");
    return found;
  }();
  return names;
}

std::string_view kernel_in_use() { return *chosen_kernel().load(); }

bool choose_kernel(std::string_view name) {
  const std::string_view* known = name.empty() ? &kernel_names().front() : find_kernel_name(name);
  if (known) chosen_kernel().store(known);
  return known != nullptr;
}

}  // namespace physim
