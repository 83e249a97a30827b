// Comparisons of packs, returned as bits of lanes.
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
    using Register = typename Pack<T, N>::Register;
    const auto ask = [](const Register& x, const Register& y) PHYSIM_INLINE_LAMBDA {
      if constexpr (sizeof(T) == 8) return unsigned(_mm512_cmp_pd_mask((__m512d)x, (__m512d)y, _CMP_GE_OQ));
      if constexpr (sizeof(T) == 4) return unsigned(_mm512_cmp_ps_mask((__m512)x, (__m512)y, _CMP_GE_OQ));
    };
    PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), bits |= ask(a.r[i], b.r[i]) << (i * kPer));
    return bits;
  }
#endif
  return lane_bits(a >= b);
}

/// Bits of the first `count` lanes.
PHYSIM_INLINE constexpr unsigned first_lanes(int count) {
  return static_cast<unsigned>((std::uint64_t(1) << count) - 1);
}
/// Bits of all lanes.
template <class R>
inline constexpr unsigned kAllLanes = first_lanes(kLanes<R>);

/// The mask that has these bits.
template <class R>
PHYSIM_INLINE MaskOf<R> mask_of_lanes(unsigned bits) {
  if constexpr (kLanes<R> == 1) {
    return (bits & 1u) != 0;
  } else {
    using Mask = MaskOf<R>;
    using Register = typename Mask::Register;
    constexpr int kPer = R::kPerRegister;
    static_assert(kPer <= 8 * int(sizeof(typename Mask::I)) - 1);
    Register own{};  // the bit of each lane of a register
    for (int lane = 0; lane < kPer; ++lane) own[lane] = typename Mask::I(1) << lane;
    Mask mask;
    PHYSIM_EACH_REGISTER(Mask::kRegisters,
                         mask.r[i] = ((typename Mask::I(bits >> (i * kPer)) - Register{}) & own) != Register{});
    return mask;
  }
}

PHYSIM_ISA_END
