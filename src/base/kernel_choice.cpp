#include "base/kernel_choice.hpp"

#include <atomic>
#include <cstdint>
#include <cstdlib>

#include "base/kernel_copies.hpp"

#if PHYSIM_HAVE_AVX2 || PHYSIM_HAVE_AVX512
#include <cpuid.h>
#endif

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
#ifndef PHYSIM_WITHOUT_SCALAR
    "scalar",
#endif
};

#if PHYSIM_HAVE_AVX2 || PHYSIM_HAVE_AVX512
/// The registers of the processor that its operating system keeps: bits of XCR0. Source: Intel 64 and IA-32
/// Architectures Software Developer's Manual, vol. 1, sec. 13.3 and 15.2.
std::uint32_t kept_registers() {
  std::uint32_t low = 0, high = 0;
  asm("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

/// What the processor says of itself. __builtin_cpu_supports() of some tool chains says that it can nothing.
bool has_wide(bool avx512) {
  constexpr std::uint32_t kYmm = 0x06, kZmm = 0xe6;     // of XCR0
  constexpr std::uint32_t kAvx2 = bit_AVX2 | bit_BMI2;  // of leaf 7
  constexpr std::uint32_t kAvx512 = bit_AVX512F | bit_AVX512DQ | bit_AVX512CD | bit_AVX512BW | bit_AVX512VL;
  std::uint32_t a = 0, b = 0, c = 0, d = 0;
  if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & bit_OSXSAVE) == 0 || (c & bit_AVX) == 0 || (c & bit_FMA) == 0)
    return false;
  const std::uint32_t registers = avx512 ? kZmm : kYmm, wanted = avx512 ? kAvx512 | kAvx2 : kAvx2;
  if ((kept_registers() & registers) != registers || __get_cpuid_count(7, 0, &a, &b, &c, &d) == 0) return false;
  return (b & wanted) == wanted;
}
#endif

bool runs_here(std::string_view name) {
#if PHYSIM_HAVE_AVX512
  if (name == "avx512") return has_wide(true);
#endif
#if PHYSIM_HAVE_AVX2
  if (name == "avx2") return has_wide(false);
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
