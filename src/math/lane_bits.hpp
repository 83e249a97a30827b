// Comparisons of packs that are told by bits of lanes.
#pragma once

#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// lane_bits() of a >= b and of a <= b: with AVX-512 a comparison makes these bits, and a mask only from them.
template <class R>
PHYSIM_INLINE unsigned lanes_at_least(const R& a, const std::type_identity_t<R>& b) {
  return lane_bits(a >= b);
}
template <class R>
PHYSIM_INLINE unsigned lanes_at_most(const R& a, const std::type_identity_t<R>& b) {
  return lanes_at_least(b, a);
}
template <class T, int N>
PHYSIM_INLINE unsigned lanes_at_least(const Pack<T, N>& a, const std::type_identity_t<Pack<T, N>>& b) {
#if defined(__AVX512F__)
  constexpr int kPer = Pack<T, N>::kPerRegister;
  if constexpr (std::is_floating_point_v<T> && Pack<T, N>::kBytes == 64) {
    unsigned bits = 0;
    for (int i = 0; i < Pack<T, N>::kRegisters; ++i) {
      if constexpr (sizeof(T) == 8)
        bits |= unsigned(_mm512_cmp_pd_mask((__m512d)a.r[i], (__m512d)b.r[i], _CMP_GE_OQ)) << (i * kPer);
      else
        bits |= unsigned(_mm512_cmp_ps_mask((__m512)a.r[i], (__m512)b.r[i], _CMP_GE_OQ)) << (i * kPer);
    }
    return bits;
  }
#endif
  return lane_bits(a >= b);
}

PHYSIM_ISA_END
