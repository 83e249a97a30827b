// Pack<T, N>: N numbers that are computed with as if they were one. Each lane is another projectile.
//
// A pack is a short array of hardware registers, written with the compilers' vector extensions (g++, clang, and through
// them x86-64, arm64 and WebAssembly). A function template over the number type R works on float, double and packs
// alike; the vocabulary that the three share is below: sqrt, abs, min, max, select, any, all, and the traits
// scalar_of, mask_of, kLanes. Every operation is one IEEE operation per lane, so a lane's bits never depend on N.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "base/assert.hpp"
#include "base/isa.hpp"
#include "math/registers.hpp"

PHYSIM_ISA_BEGIN

/// The signed and unsigned integers as wide as T.
template <class T>
using SignedOf = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
template <class T>
using UnsignedOf = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

/// A statement for each register i of a pack. A loop hides from clang which register is meant until it is unrolled, and
/// meanwhile packs lie in memory, where little of what is known is found again. More than four at a time are rare.
#define PHYSIM_EACH_REGISTER(kCount, ...)   \
  do {                                      \
    {                                       \
      [[maybe_unused]] constexpr int i = 0; \
      __VA_ARGS__;                          \
    }                                       \
    if constexpr ((kCount) > 1) {           \
      constexpr int i = 1;                  \
      __VA_ARGS__;                          \
    }                                       \
    if constexpr ((kCount) > 2) {           \
      constexpr int i = 2;                  \
      __VA_ARGS__;                          \
    }                                       \
    if constexpr ((kCount) > 3) {           \
      constexpr int i = 3;                  \
      __VA_ARGS__;                          \
    }                                       \
    if constexpr ((kCount) > 4)             \
      for (int i = 4; i < (kCount); ++i) {  \
        __VA_ARGS__;                        \
      }                                     \
  } while (false)

template <class T, int N>
struct Pack {
  static constexpr int kBytes = N * int(sizeof(T)) < kNativeBytes ? N * int(sizeof(T)) : kNativeBytes;
  static constexpr int kPerRegister = kBytes / int(sizeof(T));
  static constexpr int kRegisters = N / kPerRegister;
  static_assert(kRegisters * kPerRegister == N, "a pack fills whole registers");
  typedef T Register __attribute__((vector_size(kBytes)));
  /// A register's worth of numbers anywhere in memory. (A memcpy would keep whole packs from living in registers.)
  typedef T Stored __attribute__((vector_size(kBytes), aligned(alignof(T)), may_alias));

  Register r[kRegisters];

  Pack() = default;
  /// Every lane gets the same value.
  PHYSIM_INLINE Pack(T value) {  // NOLINT: a number is a pack of equal numbers
    PHYSIM_EACH_REGISTER(kRegisters, r[i] = value - Register{});
  }
  PHYSIM_INLINE T operator[](int lane) const {
    PHYSIM_ASSERT(lane >= 0 && lane < N);
    return r[lane / kPerRegister][lane % kPerRegister];
  }
  PHYSIM_INLINE void set(int lane, T value) {
    PHYSIM_ASSERT(lane >= 0 && lane < N);
    r[lane / kPerRegister][lane % kPerRegister] = value;
  }

  PHYSIM_INLINE static Pack load(const T* from) {
    Pack p;
    PHYSIM_EACH_REGISTER(kRegisters, p.r[i] = *reinterpret_cast<const Stored*>(from + i * kPerRegister));
    return p;
  }
  PHYSIM_INLINE void store(T* to) const { PHYSIM_EACH_REGISTER(kRegisters, *place(to, i) = r[i]); }
  /// Stores past the caches, to an address that is a multiple of the register's size: for more numbers than fit there.
  /// finish_streams() before others read them.
  PHYSIM_INLINE void stream(T* to) const {
    PHYSIM_ASSERT(std::bit_cast<std::uintptr_t>(to) % kBytes == 0);
    PHYSIM_EACH_REGISTER(kRegisters, stream_register(place(to, i), r[i]));
  }

 private:
  PHYSIM_INLINE static void stream_register(Stored* to, const Register& from) {
#if defined(__AVX512F__)
    if constexpr (kBytes == 64) return _mm512_stream_si512((__m512i*)to, (__m512i)from);
#endif
#if defined(__AVX__)
    if constexpr (kBytes == 32) return _mm256_stream_si256((__m256i*)to, (__m256i)from);
#endif
#if defined(__SSE2__)
    if constexpr (kBytes == 16) return _mm_stream_si128((__m128i*)to, (__m128i)from);
#endif
    *to = from;
  }
  /// Where register i is stored.
  PHYSIM_INLINE static Stored* place(T* to, int i) { return reinterpret_cast<Stored*>(to + i * kPerRegister); }
};

/// What was streamed is in memory.
PHYSIM_INLINE void finish_streams() {
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

/// The result of a comparison: all bits of a lane set, or none.
template <class T, int N>
struct PackMask {
  using I = SignedOf<T>;
  typedef I Register __attribute__((vector_size(Pack<T, N>::kBytes)));
  static constexpr int kRegisters = Pack<T, N>::kRegisters;
  Register r[kRegisters];

  PHYSIM_INLINE bool operator[](int lane) const {
    return r[lane / Pack<T, N>::kPerRegister][lane % Pack<T, N>::kPerRegister] != 0;
  }
};

// ---------------------------------------------------------------------------------------------------- arithmetic
#define PHYSIM_PACK_BINARY(op)                                                           \
  template <class T, int N>                                                              \
  PHYSIM_INLINE Pack<T, N> operator op(const Pack<T, N>& a, const Pack<T, N>& b) {       \
    Pack<T, N> c;                                                                        \
    PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = a.r[i] op b.r[i]);           \
    return c;                                                                            \
  }                                                                                      \
  template <class T, int N>                                                              \
  PHYSIM_INLINE Pack<T, N> operator op(const Pack<T, N>& a, std::type_identity_t<T> b) { \
    return a op Pack<T, N>(b);                                                           \
  }                                                                                      \
  template <class T, int N>                                                              \
  PHYSIM_INLINE Pack<T, N> operator op(std::type_identity_t<T> a, const Pack<T, N>& b) { \
    return Pack<T, N>(a) op b;                                                           \
  }                                                                                      \
  template <class T, int N>                                                              \
  PHYSIM_INLINE Pack<T, N>& operator op##=(Pack<T, N>& a, const Pack<T, N>& b) {         \
    return a = a op b;                                                                   \
  }
PHYSIM_PACK_BINARY(+)
PHYSIM_PACK_BINARY(-)
PHYSIM_PACK_BINARY(*)
PHYSIM_PACK_BINARY(/)
#undef PHYSIM_PACK_BINARY

// Integers only: bits of the lanes.
#define PHYSIM_PACK_BITS(op)                                                   \
  template <class T, int N>                                                    \
  requires std::is_integral_v<T> PHYSIM_INLINE Pack<T, N>                      \
  operator op(const Pack<T, N>& a, const Pack<T, N>& b) {                      \
    Pack<T, N> c;                                                              \
    PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = a.r[i] op b.r[i]); \
    return c;                                                                  \
  }
PHYSIM_PACK_BITS(&)
PHYSIM_PACK_BITS(|)
PHYSIM_PACK_BITS(^)
#undef PHYSIM_PACK_BITS

#define PHYSIM_PACK_SHIFT(op)                                                \
  template <class T, int N>                                                  \
  requires std::is_integral_v<T> PHYSIM_INLINE Pack<T, N>                    \
  operator op(const Pack<T, N>& a, int bits) {                               \
    Pack<T, N> c;                                                            \
    PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = a.r[i] op bits); \
    return c;                                                                \
  }
PHYSIM_PACK_SHIFT(<<)
PHYSIM_PACK_SHIFT(>>)
#undef PHYSIM_PACK_SHIFT

template <class T, int N>
PHYSIM_INLINE Pack<T, N> operator-(const Pack<T, N>& a) {
  Pack<T, N> c;
  PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = -a.r[i]);
  return c;
}

// --------------------------------------------------------------------------------------------------- comparisons
#define PHYSIM_PACK_COMPARE(op)                                                                                     \
  template <class T, int N>                                                                                         \
  PHYSIM_INLINE PackMask<T, N> operator op(const Pack<T, N>& a, const Pack<T, N>& b) {                              \
    PackMask<T, N> m;                                                                                               \
    PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), m.r[i] = (typename PackMask<T, N>::Register)(a.r[i] op b.r[i])); \
    return m;                                                                                                       \
  }                                                                                                                 \
  template <class T, int N>                                                                                         \
  PHYSIM_INLINE PackMask<T, N> operator op(const Pack<T, N>& a, std::type_identity_t<T> b) {                        \
    return a op Pack<T, N>(b);                                                                                      \
  }
PHYSIM_PACK_COMPARE(<)
PHYSIM_PACK_COMPARE(<=)
PHYSIM_PACK_COMPARE(>)
PHYSIM_PACK_COMPARE(>=)
PHYSIM_PACK_COMPARE(==)
PHYSIM_PACK_COMPARE(!=)
#undef PHYSIM_PACK_COMPARE

#define PHYSIM_MASK_BINARY(op)                                                                 \
  template <class T, int N>                                                                    \
  PHYSIM_INLINE PackMask<T, N> operator op(const PackMask<T, N>& a, const PackMask<T, N>& b) { \
    PackMask<T, N> m;                                                                          \
    PHYSIM_EACH_REGISTER((PackMask<T, N>::kRegisters), m.r[i] = a.r[i] op b.r[i]);             \
    return m;                                                                                  \
  }
PHYSIM_MASK_BINARY(&)
PHYSIM_MASK_BINARY(|)
#undef PHYSIM_MASK_BINARY
template <class T, int N>
PHYSIM_INLINE PackMask<T, N> operator!(const PackMask<T, N>& a) {
  PackMask<T, N> m;
  PHYSIM_EACH_REGISTER((PackMask<T, N>::kRegisters), m.r[i] = ~a.r[i]);
  return m;
}

// ------------------------------------------------------------------------------- what numbers and packs have in common
template <class R>
struct NumberTraits {
  using Scalar = R;
  using Mask = bool;
  using Unsigned = UnsignedOf<R>;
  static constexpr int kLanes = 1;
};
template <class T, int N>
struct NumberTraits<Pack<T, N>> {
  using Scalar = T;
  using Mask = PackMask<T, N>;
  using Unsigned = Pack<UnsignedOf<T>, N>;
  static constexpr int kLanes = N;
};
/// The number of one lane: float or double.
template <class R>
using ScalarOf = typename NumberTraits<R>::Scalar;
/// What a comparison gives: bool, or a mask of lanes.
template <class R>
using MaskOf = typename NumberTraits<R>::Mask;
/// Unsigned integers as wide as the lanes.
template <class R>
using BitsOf = typename NumberTraits<R>::Unsigned;
template <class R>
inline constexpr int kLanes = NumberTraits<R>::kLanes;

/// A constant written in double, rounded to the lane's type.
template <class R>
PHYSIM_INLINE R constant(double value) {
  return R(static_cast<ScalarOf<R>>(value));
}

/// Lane by lane: mask ? a : b. Both sides are computed.
template <class T>
requires std::is_arithmetic_v<T> PHYSIM_INLINE T select(bool mask, T a, T b) { return mask ? a : b; }
template <class T, int N>
PHYSIM_INLINE Pack<T, N> select(const PackMask<T, N>& mask, const Pack<T, N>& a, const Pack<T, N>& b) {
  Pack<T, N> c;
  PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = mask.r[i] ? a.r[i] : b.r[i]);
  return c;
}

PHYSIM_INLINE bool any(bool mask) { return mask; }
PHYSIM_INLINE bool all(bool mask) { return mask; }
template <class T, int N>
PHYSIM_INLINE bool any(const PackMask<T, N>& mask) {
  auto bits = mask.r[0];
  PHYSIM_EACH_REGISTER((PackMask<T, N>::kRegisters), bits |= mask.r[i]);
#if defined(__AVX512F__)
  if constexpr (sizeof bits == 64) return _mm512_test_epi64_mask((__m512i)bits, (__m512i)bits) != 0;
#endif
#if defined(__AVX__)
  if constexpr (sizeof bits == 32) return !_mm256_testz_si256((__m256i)bits, (__m256i)bits);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof bits == 16) return _mm_movemask_epi8((__m128i)bits) != 0;
#endif
  SignedOf<T> sum = 0;
  for (int lane = 0; lane < Pack<T, N>::kPerRegister; ++lane) sum |= bits[lane];
  return sum != 0;
}
template <class T, int N>
PHYSIM_INLINE bool all(const PackMask<T, N>& mask) {
  return !any(!mask);
}
/// Bit i of the result is lane i of the mask.
PHYSIM_INLINE unsigned lane_bits(bool mask) { return mask ? 1u : 0u; }
template <class T, int N>
PHYSIM_INLINE unsigned register_bits(const typename PackMask<T, N>::Register& mask) {
#if defined(__AVX512DQ__)
  if constexpr (sizeof mask == 64)
    return sizeof(T) == 8 ? unsigned(_mm512_movepi64_mask((__m512i)mask))
                          : unsigned(_mm512_movepi32_mask((__m512i)mask));
#endif
#if defined(__AVX__)
  if constexpr (sizeof mask == 32)
    return unsigned(sizeof(T) == 8 ? _mm256_movemask_pd((__m256d)mask) : _mm256_movemask_ps((__m256)mask));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof mask == 16)
    return unsigned(sizeof(T) == 8 ? _mm_movemask_pd((__m128d)mask) : _mm_movemask_ps((__m128)mask));
#endif
  unsigned bits = 0;
  for (int lane = 0; lane < Pack<T, N>::kPerRegister; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
  return bits;
}
template <class T, int N>
PHYSIM_INLINE unsigned lane_bits(const PackMask<T, N>& mask) {
  static_assert(N <= 32);
  constexpr int kPer = Pack<T, N>::kPerRegister;
  unsigned bits = 0;
  PHYSIM_EACH_REGISTER((PackMask<T, N>::kRegisters), bits |= register_bits<T, N>(mask.r[i]) << (i * kPer));
  return bits;
}
/// One lane of a pack, of a mask, or of what is but one.
template <class T>
requires std::is_arithmetic_v<T> PHYSIM_INLINE T lane_of(T x, int) { return x; }
template <class T, int N>
PHYSIM_INLINE bool lane_of(const PackMask<T, N>& mask, int lane) {
  return mask[lane];
}
template <class T, int N>
PHYSIM_INLINE T lane_of(const Pack<T, N>& x, int lane) {
  return x[lane];
}
PHYSIM_INLINE void set_lane(double& x, int, double value) { x = value; }
PHYSIM_INLINE void set_lane(float& x, int, float value) { x = value; }
template <class T, int N>
PHYSIM_INLINE void set_lane(Pack<T, N>& x, int lane, T value) {
  x.set(lane, value);
}

/// As many lanes of another number type, each rounded or widened.
template <class T, class R>
struct CastTo {
  using Type = T;
};
template <class T, class From, int N>
struct CastTo<T, Pack<From, N>> {
  using Type = Pack<T, N>;
};
template <class T, class R>
using Cast = typename CastTo<T, R>::Type;
template <class T, class From>
requires std::is_arithmetic_v<From> PHYSIM_INLINE T cast(From x) { return static_cast<T>(x); }
template <class T, class From, int N>
PHYSIM_INLINE Pack<T, N> cast(const Pack<From, N>& x) {
  if constexpr (std::is_same_v<T, From>) {
    return x;
  } else {
    constexpr int kFrom = Pack<From, N>::kPerRegister, kTo = Pack<T, N>::kPerRegister;
    static_assert(kTo == kFrom || kTo == 2 * kFrom || kFrom == 2 * kTo, "halves of a register at most");
    Pack<T, N> c;
    if constexpr (kTo == kFrom) {
      PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = register_cast<T, kTo>(x.r[i]));
    } else if constexpr (kTo > kFrom) {
      PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters),
                           c.r[i] = joined_registers<kFrom>(register_cast<T, kFrom>(x.r[2 * i]),
                                                            register_cast<T, kFrom>(x.r[2 * i + 1])));
    } else {
      PHYSIM_EACH_REGISTER((Pack<From, N>::kRegisters), c.r[2 * i] = register_cast<T, kTo>(half_of<kTo, 0>(x.r[i]));
                           c.r[2 * i + 1] = register_cast<T, kTo>(half_of<kTo, 1>(x.r[i])));
    }
    return c;
  }
}

/// The mask of a pack of R's for as many lanes of type T.
template <class T, class R>
PHYSIM_INLINE MaskOf<Cast<T, R>> cast_mask(const MaskOf<R>& mask) {
  if constexpr (std::is_same_v<T, ScalarOf<R>> || kLanes<R> == 1) {
    return mask;
  } else {
    return cast<T>(select(mask, R(ScalarOf<R>(1)), R(ScalarOf<R>(0)))) != Cast<T, R>(T(0));
  }
}

/// The bits of the lanes as unsigned integers, and back.
template <class R>
PHYSIM_INLINE BitsOf<R> to_bits(const R& x) {
  BitsOf<R> bits;
  static_assert(sizeof bits == sizeof x);
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}
template <class R>
PHYSIM_INLINE R from_bits(const BitsOf<R>& bits) {
  R x;
  static_assert(sizeof bits == sizeof x);
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// --------------------------------------------------------------------------------------------------- square root
template <class T, int N>
PHYSIM_INLINE Pack<T, N> sqrt(const Pack<T, N>& a) {
  Pack<T, N> c;
  PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = register_sqrt<T>(a.r[i]));
  return c;
}

// ------------------------------------------------------------------------------------------- abs, min, max, round
template <class R>
PHYSIM_INLINE R abs(const R& x) {
  constexpr auto kSign = BitsOf<ScalarOf<R>>(1) << (8 * sizeof(ScalarOf<R>) - 1);
  return from_bits<R>(to_bits(x) & BitsOf<R>(BitsOf<ScalarOf<R>>(kSign - 1)));
}
/// The smaller; b where either is not a number.
template <class R>
PHYSIM_INLINE R min(const R& a, const std::type_identity_t<R>& b) {
  return select(a < b, a, b);
}
/// The larger; b where either is not a number.
template <class R>
PHYSIM_INLINE R max(const R& a, const std::type_identity_t<R>& b) {
  return select(a > b, a, b);
}
template <class T, int N>
PHYSIM_INLINE Pack<T, N> min(const Pack<T, N>& a, const std::type_identity_t<Pack<T, N>>& b) {
  Pack<T, N> c;
  PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = register_min<T>(a.r[i], b.r[i]));
  return c;
}
template <class T, int N>
PHYSIM_INLINE Pack<T, N> max(const Pack<T, N>& a, const std::type_identity_t<Pack<T, N>>& b) {
  Pack<T, N> c;
  PHYSIM_EACH_REGISTER((Pack<T, N>::kRegisters), c.r[i] = register_max<T>(a.r[i], b.r[i]));
  return c;
}
template <class R>
PHYSIM_INLINE R clamp(const R& x, const std::type_identity_t<R>& low, const std::type_identity_t<R>& high) {
  return min(max(x, low), high);
}
/// The magnitude of a with the sign of b.
template <class R>
PHYSIM_INLINE R copysign(const R& a, const std::type_identity_t<R>& b) {
  using U = BitsOf<ScalarOf<R>>;
  constexpr U kSign = U(1) << (8 * sizeof(U) - 1);
  return from_bits<R>((to_bits(a) & BitsOf<R>(U(kSign - 1))) | (to_bits(b) & BitsOf<R>(kSign)));
}
/// Lanes that are neither infinite nor NaN.
template <class R>
PHYSIM_INLINE MaskOf<R> is_finite(const R& x) {
  return x - x == R(ScalarOf<R>(0));
}
/// When added, it pushes the fraction of |x| < 2^(digits-2) out of the mantissa: 1.5 * 2^52 or 1.5 * 2^23.
template <class R>
PHYSIM_INLINE R rounding_magic() {
  return constant<R>(sizeof(ScalarOf<R>) == 8 ? 6755399441055744.0 : 12582912.0);
}
/// Nearest integer, ties to even, for |x| < 2^51 (double) or 2^22 (float).
template <class R>
PHYSIM_INLINE R round_to_int(const R& x) {
  const R magic = rounding_magic<R>();
  return (x + magic) - magic;
}
/// Largest integer not above x, in the same range.
template <class R>
PHYSIM_INLINE R floor_small(const R& x) {
  const R n = round_to_int(x);
  return select(n > x, n - R(ScalarOf<R>(1)), n);
}

PHYSIM_ISA_END
