// The processor says which kernels run: asked by cpuid as the compiler's own builtin asks it.
#include "base/kernel_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/kernel_copies.hpp"

namespace physim::base_kernel_choice_test {

[[maybe_unused]] bool has(std::string_view name) { return std::ranges::count(kernel_names(), name) == 1; }

TEST(KernelChoice, base_and_scalar_run_everywhere) {
  EXPECT_TRUE(has("base"));
  EXPECT_EQ(kernel_names().back(), "scalar");
}

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
TEST(KernelChoice, the_processor_is_asked_as_the_compiler_asks_it) {
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512cd");
  EXPECT_EQ(has("avx2"), avx2 && PHYSIM_HAVE_AVX2);
  EXPECT_EQ(has("avx512"), avx512 && PHYSIM_HAVE_AVX512);
}
#endif

}  // namespace physim::base_kernel_choice_test
