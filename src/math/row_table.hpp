// Evaluates a cubic whose four coefficients lie in a row of a table, with another row for each lane.
//
// A hardware gather of the four columns costs more than the arithmetic of a whole drag law; loading each lane's row at
// once and transposing blocks of four rows by shuffles costs a fraction of it.
#pragma once

#include <cstdint>

#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// r0 + r1 t + r2 t^2 + r3 t^3, as (r0 + t r1) + t^2 (r2 + t r3), with r = rows[4 * index ..]; index is a whole number,
/// 0 <= index < 2^22.
template <class S>
requires std::is_floating_point_v<S> PHYSIM_INLINE S row_cubic(const S* rows, S index, S t) {
  const S* r = rows + 4 * static_cast<std::int64_t>(index);
  return (r[0] + t * r[1]) + (t * t) * (r[2] + t * r[3]);
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define PHYSIM_HAS_SHUFFLE 1
#endif
#endif

#ifdef PHYSIM_HAS_SHUFFLE
template <class S>
struct FourRows {
  typedef S Row __attribute__((vector_size(4 * sizeof(S))));
  typedef S Eight __attribute__((vector_size(8 * sizeof(S))));
  typedef S Sixteen __attribute__((vector_size(16 * sizeof(S))));

  /// Column c of the four rows at r[0..3], for c = 0..3.
  PHYSIM_INLINE static void transpose(const S* rows, const UnsignedOf<S>* offset, Row* column) {
    Row a, b, c, d;
    std::memcpy(&a, rows + offset[0], sizeof a);
    std::memcpy(&b, rows + offset[1], sizeof b);
    std::memcpy(&c, rows + offset[2], sizeof c);
    std::memcpy(&d, rows + offset[3], sizeof d);
    const Row ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Row ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Row cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Row cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    column[0] = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
    column[1] = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
    column[2] = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
    column[3] = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
  }
  PHYSIM_INLINE static Eight join4(Row a, Row b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); }
  PHYSIM_INLINE static Sixteen join8(Eight a, Eight b) {
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  }
};
#endif

template <class S, int N>
PHYSIM_INLINE Pack<S, N> row_cubic(const S* rows, const Pack<S, N>& index, const Pack<S, N>& t) {
  // Adding the rounding number leaves the integer in the low bits of the mantissa.
  using U = UnsignedOf<S>;
  const auto bits = to_bits(index + rounding_magic<Pack<S, N>>());
  U offset[N];
  ((bits & Pack<U, N>(U(0x3fffff))) << 2).store(offset);
#if defined(__GNUC__)
  // Reading the offsets back from memory costs one load a lane; taking them out of a register costs three instructions.
  asm("" : "+m"(offset));
#endif

#ifdef PHYSIM_HAS_SHUFFLE
  constexpr int kPer = Pack<S, N>::kPerRegister;
  if constexpr (kPer == 4 || kPer == 8 || kPer == 16) {
    using Four = FourRows<S>;
    typename Four::Row c[kPer / 4][4];
    Pack<S, N> r0, r1, r2, r3;
    for (int i = 0; i < Pack<S, N>::kRegisters; ++i) {
      for (int block = 0; block < kPer / 4; ++block) Four::transpose(rows, offset + i * kPer + 4 * block, c[block]);
      if constexpr (kPer == 4) {
        r0.r[i] = c[0][0], r1.r[i] = c[0][1], r2.r[i] = c[0][2], r3.r[i] = c[0][3];
      } else if constexpr (kPer == 8) {
        r0.r[i] = Four::join4(c[0][0], c[1][0]), r1.r[i] = Four::join4(c[0][1], c[1][1]);
        r2.r[i] = Four::join4(c[0][2], c[1][2]), r3.r[i] = Four::join4(c[0][3], c[1][3]);
      } else {
        r0.r[i] = Four::join8(Four::join4(c[0][0], c[1][0]), Four::join4(c[2][0], c[3][0]));
        r1.r[i] = Four::join8(Four::join4(c[0][1], c[1][1]), Four::join4(c[2][1], c[3][1]));
        r2.r[i] = Four::join8(Four::join4(c[0][2], c[1][2]), Four::join4(c[2][2], c[3][2]));
        r3.r[i] = Four::join8(Four::join4(c[0][3], c[1][3]), Four::join4(c[2][3], c[3][3]));
      }
    }
    return (r0 + t * r1) + (t * t) * (r2 + t * r3);
  }
#endif
  S column[4][N];
  for (int lane = 0; lane < N; ++lane)
    for (int k = 0; k < 4; ++k) column[k][lane] = rows[offset[lane] + static_cast<unsigned>(k)];
  using P = Pack<S, N>;
  return (P::load(column[0]) + t * P::load(column[1])) + (t * t) * (P::load(column[2]) + t * P::load(column[3]));
}

PHYSIM_ISA_END
