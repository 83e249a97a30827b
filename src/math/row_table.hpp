// Evaluates a cubic with its four coefficients in a row of a table, with another row for each lane.
//
// A hardware gather of the four columns costs more than the arithmetic of a whole drag law; loading each lane's row at
// once and transposing blocks of four rows by shuffles costs a fraction of it.
#pragma once

#include <cstdint>
#include <utility>

#include "base/assert.hpp"
#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// Row `index` of a table of rows of four; index is a whole number, 0 <= index < 2^22.
template <class S>
requires std::is_floating_point_v<S> PHYSIM_INLINE const S* row_at(const S* rows, S index) {
  PHYSIM_ASSERT(rows != nullptr && index >= S(0) && index < S(1 << 22));
  return rows + 4 * static_cast<std::int64_t>(index);
}
/// r0 + r1 t + r2 t^2 + r3 t^3, as (r0 + t r1) + t^2 (r2 + t r3).
template <class S>
requires std::is_floating_point_v<S> PHYSIM_INLINE S row_cubic(const S* r, S t) {
  return (r[0] + t * r[1]) + (t * t) * (r[2] + t * r[3]);
}
/// ... with r = rows[4 * index ..].
template <class S>
requires std::is_floating_point_v<S> PHYSIM_INLINE S row_cubic(const S* rows, S index, S t) {
  return row_cubic(row_at(rows, index), t);
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define PHYSIM_HAS_SHUFFLE 1
#endif
#endif

#ifdef PHYSIM_HAS_SHUFFLE
/// Lane i of the result is lane kFrom(i) of a, or of b where the count exceeds a.
template <auto kFrom, int kCount, class V>
PHYSIM_INLINE auto shuffled(const V& a, const V& b) {
  return [&]<int... I>(std::integer_sequence<int, I...>) { return __builtin_shufflevector(a, b, kFrom(I)...); }
  (std::make_integer_sequence<int, kCount>{});
}

/// Four columns of a table, each with its own row in every lane of a register. Neighbouring columns are loaded together
/// and parted by shuffles; which lanes are loaded side by side is chosen so that full registers are shuffled.
template <class S, int kPer>
struct TableRows {
  typedef S Two __attribute__((vector_size(2 * sizeof(S))));
  typedef S Four __attribute__((vector_size(4 * sizeof(S))));
  typedef S Register __attribute__((vector_size(kPer * sizeof(S))));
  static constexpr bool kDouble = sizeof(S) == 8;
  static constexpr bool kPossible = kPer == 4 || kPer == 8 || kPer == (kDouble ? 2 : 16);

  const S* rows;
  const UnsignedOf<S>* offset;

  PHYSIM_INLINE void load(Register* column) const {
    if constexpr (kDouble && kPer > 2) {
      Register even[2], odd[2];  // columns 0 and 2, and 1 and 3, of half of the lanes: two lanes of each in turns
      for (int i = 0; i < 2; ++i) {
        const Register a = every_other(i * kPer / 2);
        const Register b = every_other(i * kPer / 2 + 1);
        even[i] = pick<[](int j) { return j % 2 == 0 ? j : kPer + j - 1; }>(a, b);
        odd[i] = pick<[](int j) { return j % 2 == 0 ? j + 1 : kPer + j; }>(a, b);
      }
      constexpr auto kFirstPairs = [](int j) { return j / 2 * 4 + j % 2; };
      constexpr auto kSecondPairs = [](int j) { return j / 2 * 4 + 2 + j % 2; };
      column[0] = pick<kFirstPairs>(even[0], even[1]), column[2] = pick<kSecondPairs>(even[0], even[1]);
      column[1] = pick<kFirstPairs>(odd[0], odd[1]), column[3] = pick<kSecondPairs>(odd[0], odd[1]);
    } else if constexpr (kDouble) {
      for (int k = 0; k < 4; k += 2) {
        const Register a = part<Two>(0, k), b = part<Two>(1, k);
        column[k] = pick<[](int j) { return 2 * j; }>(a, b);
        column[k + 1] = pick<[](int j) { return 2 * j + 1; }>(a, b);
      }
    } else {
      // In every block of four lanes, transpose: columns 0 and 1 in turns, 2 and 3 in turns, then one by one.
      constexpr auto kLow = [](int j) { return j / 4 * 4 + j % 4 / 2 + j % 2 * kPer; };
      constexpr auto kHigh = [](int j) { return j / 4 * 4 + 2 + j % 4 / 2 + j % 2 * kPer; };
      constexpr auto kFirst = [](int j) { return j / 4 * 4 + j % 2 + j % 4 / 2 * kPer; };
      constexpr auto kSecond = [](int j) { return j / 4 * 4 + 2 + j % 2 + j % 4 / 2 * kPer; };
      const Register r0 = every_fourth(0), r1 = every_fourth(1), r2 = every_fourth(2), r3 = every_fourth(3);
      const Register low_01 = pick<kLow>(r0, r1), high_01 = pick<kHigh>(r0, r1);
      const Register low_23 = pick<kLow>(r2, r3), high_23 = pick<kHigh>(r2, r3);
      column[0] = pick<kFirst>(low_01, low_23), column[1] = pick<kSecond>(low_01, low_23);
      column[2] = pick<kFirst>(high_01, high_23), column[3] = pick<kSecond>(high_01, high_23);
    }
  }

 private:
  /// The first numbers of a lane's row, from column k on.
  template <class Part>
  PHYSIM_INLINE Part part(int lane, int k = 0) const {
    Part p;
    std::memcpy(&p, rows + offset[lane] + k, sizeof p);
    return p;
  }
  template <class V>
  PHYSIM_INLINE static auto join(const V& a, const V& b) {
    return shuffled<[](int j) { return j; }, 2 * sizeof(V) / sizeof(S)>(a, b);
  }
  template <auto kFrom>
  PHYSIM_INLINE static Register pick(const Register& a, const Register& b) {
    return shuffled<kFrom, kPer>(a, b);
  }
  /// Rows of lanes first and first + 2; just one where a register holds no more.
  PHYSIM_INLINE Register every_other(int first) const {
    if constexpr (kPer == 4) return part<Four>(first);
    if constexpr (kPer == 8) return join(part<Four>(first), part<Four>(first + 2));
  }
  /// Rows of lanes first, first + 4, ...
  PHYSIM_INLINE Register every_fourth(int first) const {
    if constexpr (kPer == 4) return part<Four>(first);
    if constexpr (kPer == 8) return join(part<Four>(first), part<Four>(first + 4));
    if constexpr (kPer == 16)
      return join(join(part<Four>(first), part<Four>(first + 4)), join(part<Four>(first + 8), part<Four>(first + 12)));
  }
};
#endif

/// Where the rows of whole numbers begin, in memory of the caller's. (As a class with a member that points into itself,
/// g++ 12 would forget all else that it knows about memory, such as known conditions.)
template <class S, int N>
PHYSIM_INLINE const UnsignedOf<S>* row_offsets(const Pack<S, N>& index, UnsignedOf<S> (&stored)[N]) {
  PHYSIM_ASSERT(all((index >= S(0)) & (index < S(1 << 22))));
  // Adding the rounding number leaves the integer in the low bits of the mantissa.
  using U = UnsignedOf<S>;
  const auto bits = to_bits(index + rounding_magic<Pack<S, N>>());
  ((bits & Pack<U, N>(U(0x3fffff))) << 2).store(stored);
  const U* at = stored;
  // Reading the offsets back from memory costs one load a lane; taking them out of a register three instructions.
#if defined(__clang__)
  asm("" : "+m"(stored));  // clang would not store what it thinks is never read
#elif defined(__GNUC__)
  // Hiding where they lie does it. (Hiding what they are would hide all else in memory, too.)
  asm("" : "+r"(at));
#endif
  return at;
}

/// The four numbers of rows[4 * index ..], each in its own column.
template <class S>
requires std::is_floating_point_v<S> PHYSIM_INLINE void row_columns(const S* rows, S index, S* column) {
  PHYSIM_ASSERT(rows != nullptr && index >= S(0) && index < S(1 << 22));
  const S* r = rows + 4 * static_cast<std::int64_t>(index);
  for (int k = 0; k < 4; ++k) column[k] = r[k];
}
template <class S, int N>
PHYSIM_INLINE void row_columns(const S* rows, const Pack<S, N>& index, Pack<S, N>* column) {
  UnsignedOf<S> stored[N];
  const UnsignedOf<S>* offset = row_offsets(index, stored);
#ifdef PHYSIM_HAS_SHUFFLE
  constexpr int kPer = Pack<S, N>::kPerRegister;
  if constexpr (TableRows<S, kPer>::kPossible) {
    PHYSIM_EACH_REGISTER((Pack<S, N>::kRegisters), typename Pack<S, N>::Register r[4];
                         TableRows<S, kPer>{rows, offset + i * kPer}.load(r);
                         for (int k = 0; k < 4; ++k) column[k].r[i] = r[k]);
    return;
  }
#endif
  for (int lane = 0; lane < N; ++lane)
    for (int k = 0; k < 4; ++k) set_lane(column[k], lane, rows[offset[lane] + static_cast<unsigned>(k)]);
}

/// row_cubic() of rows that begin at offsets of row_offsets().
template <class S, int N>
PHYSIM_INLINE Pack<S, N> row_cubic_at(const S* rows, const UnsignedOf<S>* offset, const Pack<S, N>& t) {
#ifdef PHYSIM_HAS_SHUFFLE
  constexpr int kPer = Pack<S, N>::kPerRegister;
  if constexpr (TableRows<S, kPer>::kPossible) {
    Pack<S, N> result;
    PHYSIM_EACH_REGISTER((Pack<S, N>::kRegisters), typename Pack<S, N>::Register r[4];
                         TableRows<S, kPer>{rows, offset + i * kPer}.load(r);
                         result.r[i] = (r[0] + t.r[i] * r[1]) + (t.r[i] * t.r[i]) * (r[2] + t.r[i] * r[3]));
    return result;
  }
#endif
  S column[4][N];
  for (int lane = 0; lane < N; ++lane)
    for (int k = 0; k < 4; ++k) column[k][lane] = rows[offset[lane] + static_cast<unsigned>(k)];
  using P = Pack<S, N>;
  return (P::load(column[0]) + t * P::load(column[1])) + (t * t) * (P::load(column[2]) + t * P::load(column[3]));
}
template <class S, int N>
PHYSIM_INLINE Pack<S, N> row_cubic(const S* rows, const Pack<S, N>& index, const Pack<S, N>& t) {
  UnsignedOf<S> stored[N];
  return row_cubic_at(rows, row_offsets(index, stored), t);
}

PHYSIM_ISA_END
