// Philox4x32-10 of math/philox.hpp for a counter in each lane, its words in 64 bits: lanes multiply 32 bits by 32.
//
// Source: as math/philox.hpp.
#pragma once

#include "math/pack.hpp"

namespace physim {
inline constexpr std::uint64_t kPhiloxWord = 0xFFFFFFFFu;
}  // namespace physim

PHYSIM_ISA_BEGIN

/// The product of the lower 32 bits of each lane with those of a number.
template <int N>
PHYSIM_INLINE Pack<std::uint64_t, N> product_of_words(const Pack<std::uint64_t, N>& a, std::uint32_t b) {
  using U = Pack<std::uint64_t, N>;
  const U wide(b);
#if defined(__SSE2__)
  using Register = typename U::Register;
  U c;
  for (int i = 0; i < U::kRegisters; ++i) {
#if defined(__AVX512F__)
    if constexpr (U::kBytes == 64)
      c.r[i] = (Register)_mm512_maskz_mul_epu32((__mmask8)-1, (__m512i)a.r[i], (__m512i)wide.r[i]);
#endif
#if defined(__AVX2__)
    if constexpr (U::kBytes == 32) c.r[i] = (Register)_mm256_mul_epu32((__m256i)a.r[i], (__m256i)wide.r[i]);
#endif
    if constexpr (U::kBytes == 16) c.r[i] = (Register)_mm_mul_epu32((__m128i)a.r[i], (__m128i)wide.r[i]);
  }
  return c;
#else
  return (a & U(kPhiloxWord)) * wide;
#endif
}

/// Ten rounds, in place. Products read the lower 32 bits alone, so that what stands above them is cleared once.
template <int N>
PHYSIM_INLINE void philox_lanes(Pack<std::uint64_t, N> (&word)[4], const std::uint32_t (&key)[2]) {
  using U = Pack<std::uint64_t, N>;
  std::uint32_t first = key[0], second = key[1];
  for (int round = 0; round < 10; ++round) {
    const U a = product_of_words(word[0], 0xD2511F53u), b = product_of_words(word[2], 0xCD9E8D57u);
    word[0] = (b >> 32) ^ word[1] ^ U(first);
    word[2] = (a >> 32) ^ word[3] ^ U(second);
    word[1] = b;
    word[3] = a;
    first += 0x9E3779B9u;
    second += 0xBB67AE85u;
  }
  for (U& w : word) w = w & U(kPhiloxWord);
}

PHYSIM_ISA_END
