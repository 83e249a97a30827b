// One hardware register of numbers, by the vector extensions of g++ and clang, and what processors have one instruction
// for but compilers make several of, or none.
#pragma once

#include <type_traits>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "base/isa.hpp"

PHYSIM_ISA_BEGIN

#if defined(__AVX512F__)
inline constexpr int kNativeBytes = 64;
#elif defined(__AVX__)
inline constexpr int kNativeBytes = 32;
#else
inline constexpr int kNativeBytes = 16;
#endif

// Correctly rounded by IEEE 754 everywhere, so it is taken from the hardware.
PHYSIM_INLINE double sqrt(double x) { return __builtin_sqrt(x); }
PHYSIM_INLINE float sqrt(float x) { return __builtin_sqrtf(x); }
template <class T, class Register>
PHYSIM_INLINE Register register_sqrt(const Register& a) {
#if defined(__AVX512F__)
  if constexpr (sizeof a == 64 && sizeof(T) == 8) return (Register)_mm512_maskz_sqrt_pd(0xff, (__m512d)a);
  if constexpr (sizeof a == 64 && sizeof(T) == 4) return (Register)_mm512_maskz_sqrt_ps(0xffff, (__m512)a);
#endif
#if defined(__AVX__)
  if constexpr (sizeof a == 32 && sizeof(T) == 8) return (Register)_mm256_sqrt_pd((__m256d)a);
  if constexpr (sizeof a == 32 && sizeof(T) == 4) return (Register)_mm256_sqrt_ps((__m256)a);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof a == 16 && sizeof(T) == 8) return (Register)_mm_sqrt_pd((__m128d)a);
  if constexpr (sizeof a == 16 && sizeof(T) == 4) return (Register)_mm_sqrt_ps((__m128)a);
#endif
  Register c;
  for (unsigned lane = 0; lane < sizeof a / sizeof(T); ++lane) c[lane] = sqrt(a[lane]);
  return c;
}
// The smaller and the larger; b where either is not a number. Each processor has one instruction that means that; g++
// 12 makes a comparison and a selection of it in most widths.
template <class T, class Register>
PHYSIM_INLINE Register register_min(const Register& a, const Register& b) {
#if defined(__AVX512F__)
  if constexpr (sizeof a == 64 && std::is_same_v<T, double>)
    return (Register)_mm512_maskz_min_pd(0xff, (__m512d)a, (__m512d)b);
  if constexpr (sizeof a == 64 && std::is_same_v<T, float>)
    return (Register)_mm512_maskz_min_ps(0xffff, (__m512)a, (__m512)b);
#endif
#if defined(__AVX__)
  if constexpr (sizeof a == 32 && std::is_same_v<T, double>) return (Register)_mm256_min_pd((__m256d)a, (__m256d)b);
  if constexpr (sizeof a == 32 && std::is_same_v<T, float>) return (Register)_mm256_min_ps((__m256)a, (__m256)b);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof a == 16 && std::is_same_v<T, double>) return (Register)_mm_min_pd((__m128d)a, (__m128d)b);
  if constexpr (sizeof a == 16 && std::is_same_v<T, float>) return (Register)_mm_min_ps((__m128)a, (__m128)b);
#endif
  return a < b ? a : b;
}
template <class T, class Register>
PHYSIM_INLINE Register register_max(const Register& a, const Register& b) {
#if defined(__AVX512F__)
  if constexpr (sizeof a == 64 && std::is_same_v<T, double>)
    return (Register)_mm512_maskz_max_pd(0xff, (__m512d)a, (__m512d)b);
  if constexpr (sizeof a == 64 && std::is_same_v<T, float>)
    return (Register)_mm512_maskz_max_ps(0xffff, (__m512)a, (__m512)b);
#endif
#if defined(__AVX__)
  if constexpr (sizeof a == 32 && std::is_same_v<T, double>) return (Register)_mm256_max_pd((__m256d)a, (__m256d)b);
  if constexpr (sizeof a == 32 && std::is_same_v<T, float>) return (Register)_mm256_max_ps((__m256)a, (__m256)b);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof a == 16 && std::is_same_v<T, double>) return (Register)_mm_max_pd((__m128d)a, (__m128d)b);
  if constexpr (sizeof a == 16 && std::is_same_v<T, float>) return (Register)_mm_max_ps((__m128)a, (__m128)b);
#endif
  return a > b ? a : b;
}

/// A register of kCount numbers.
template <class T, int kCount>
struct RegisterFor {
  typedef T Type __attribute__((vector_size(kCount * sizeof(T))));
};
/// As many numbers of another type, each rounded or widened. (g++ 12 widens a register half by half.)
template <class T, int kCount, class Register>
PHYSIM_INLINE typename RegisterFor<T, kCount>::Type register_cast(const Register& a) {
  using To = typename RegisterFor<T, kCount>::Type;
#if defined(__AVX512F__)
  if constexpr (sizeof(To) == 64 && sizeof a == 32 && std::is_same_v<T, double>)
    return (To)_mm512_maskz_cvtps_pd(0xff, (__m256)a);
#endif
#if defined(__AVX__)
  if constexpr (sizeof(To) == 32 && sizeof a == 16 && std::is_same_v<T, double>) return (To)_mm256_cvtps_pd((__m128)a);
#endif
  return __builtin_convertvector(a, To);
}
/// As many of the numbers of two registers as there are indices, from kFirst on.
template <int kFirst, class Register, int... kIndex>
PHYSIM_INLINE auto numbers_from(const Register& a, const Register& b, std::integer_sequence<int, kIndex...>) {
  return __builtin_shufflevector(a, b, (kFirst + kIndex)...);
}
/// The first or the second kCount numbers of twice as many.
template <int kCount, int kHalf, class Register>
PHYSIM_INLINE auto half_of(const Register& a) {
  return numbers_from<kHalf * kCount>(a, a, std::make_integer_sequence<int, kCount>{});
}
/// Two registers of kCount numbers as one.
template <int kCount, class Register>
PHYSIM_INLINE auto joined_registers(const Register& a, const Register& b) {
  return numbers_from<0>(a, b, std::make_integer_sequence<int, 2 * kCount>{});
}

PHYSIM_ISA_END
