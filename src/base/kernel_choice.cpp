#include "base/kernel_choice.hpp"

#include <atomic>
#include <cstdlib>

#include "base/kernel_copies.hpp"

namespace physim {
namespace {

// The copies of this build, the best first.
constexpr std::string_view kCopies[] = {
#if PHYSIM_HAVE_AVX512
    "avx512",
#endif
#if PHYSIM_HAVE_AVX2
    "avx2",
#endif
    "base",
    "scalar",
};

bool runs_here(std::string_view name) {
#if PHYSIM_HAVE_AVX512
  if (name == "avx512")
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512cd");
#endif
#if PHYSIM_HAVE_AVX2
  if (name == "avx2")
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
#endif
  return name == "base" || name == "scalar";
}

/// One that runs here; null: none of that name does.
const std::string_view* find_copy(std::string_view name) {
  for (const std::string_view& copy : kCopies)
    if (runs_here(copy) && (name.empty() || copy == name)) return &copy;
  return nullptr;
}

const std::string_view* copy_at_start() {
  const char* wanted = std::getenv("PHYSIM_KERNEL");
  const std::string_view* copy = wanted ? find_copy(wanted) : nullptr;
  return copy ? copy : find_copy("");
}

std::atomic<const std::string_view*>& chosen_copy() {
  static std::atomic<const std::string_view*> copy{copy_at_start()};
  return copy;
}

}  // namespace

const std::vector<std::string_view>& kernel_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> found;
    for (const std::string_view& copy : kCopies)
      if (runs_here(copy)) found.push_back(copy);
    return found;
  }();
  return names;
}

std::string_view kernel_in_use() { return *chosen_copy().load(); }
std::size_t number_in_use() { return static_cast<std::size_t>(chosen_copy().load() - kCopies); }

bool choose_kernel(std::string_view name) {
  const std::string_view* copy = find_copy(name);
  if (copy) chosen_copy().store(copy);
  return copy != nullptr;
}

}  // namespace physim
