// Four or eight floats at a time: what packs of them lack for comparing boxes.
#pragma once

#include "collide/box.hpp"
#include "math/pack.hpp"

namespace physim::collide {

inline constexpr double kFloatSlack = 0x1p-22;  // what coordinates lose in float, four times

/// So many floats at a time: the same operations on every machine.
using Quad = Pack<float, 4>;
using Octet = Pack<float, 8>;

/// g++ 12 does not see that a selection is one instruction.
template <int N>
[[nodiscard]] PHYSIM_INLINE Pack<float, N> larger(const Pack<float, N>& a, const Pack<float, N>& b) {
#if defined(__SSE2__)
  using Register = typename Pack<float, N>::Register;
  Pack<float, N> c;
#if defined(__AVX__)
  if constexpr (sizeof(Register) == 32) {
    PHYSIM_EACH_REGISTER((Pack<float, N>::kRegisters),
                         c.r[i] = (Register)_mm256_max_ps((__m256)a.r[i], (__m256)b.r[i]));
    return c;
  }
#endif
  if constexpr (sizeof(Register) == 16) {
    PHYSIM_EACH_REGISTER((Pack<float, N>::kRegisters), c.r[i] = (Register)_mm_max_ps((__m128)a.r[i], (__m128)b.r[i]));
    return c;
  }
#endif
  return max(a, b);
}
/// A bit for each lane in which a <= b.
template <int N>
[[nodiscard]] PHYSIM_INLINE unsigned lanes_up_to(const Pack<float, N>& a, const Pack<float, N>& b) {
  return lane_bits(a <= b);
}

/// Four doubles, to the nearest floats.
[[nodiscard]] PHYSIM_INLINE Quad rounded(const double* from) {
  Quad c;
#if defined(__SSE2__)
  c.r[0] = (Quad::Register)_mm_movelh_ps(_mm_cvtpd_ps(_mm_loadu_pd(from)), _mm_cvtpd_ps(_mm_loadu_pd(from + 2)));
#else
  for (int i = 0; i < 4; ++i) c.set(i, static_cast<float>(from[i]));
#endif
  return c;
}

/// Three doubles, to the nearest floats; the fourth number is 0.
[[nodiscard]] PHYSIM_INLINE Quad rounded(const Vec3d& v) {
  Quad c;
#if defined(__SSE2__)
  c.r[0] = (Quad::Register)_mm_movelh_ps(_mm_cvtpd_ps(_mm_set_pd(v.y, v.x)), _mm_cvtpd_ps(_mm_set_sd(v.z)));
#else
  for (std::size_t i = 0; i < 3; ++i) c.set(static_cast<int>(i), static_cast<float>(v[i]));
  c.set(3, 0);
#endif
  return c;
}
/// The largest of the first three of them.
[[nodiscard]] PHYSIM_INLINE float most_of_three(const Quad& a) {
  const float two = a[0] > a[1] ? a[0] : a[1];
  return two > a[2] ? two : a[2];
}

}  // namespace physim::collide
