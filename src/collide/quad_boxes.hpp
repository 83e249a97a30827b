// Four or eight floats at a time: what packs of them lack for comparing boxes.
#pragma once

#include "collide/box.hpp"
#include "math/lane_bits.hpp"

namespace physim::collide {

inline constexpr double kFloatSlack = 0x1p-22;  // what coordinates lose in float, four times

/// So many floats at a time: the same operations on every machine.
using Quad = Pack<float, 4>;
using Octet = Pack<float, 8>;

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
