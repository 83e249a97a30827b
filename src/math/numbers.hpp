// Structures of numbers: structs with all members of one number type R (float, double, or a pack of lanes), read as the
// numbers that they hold, first to last.
//
// A lane that moves from pack to pack, a row that is loaded from its columns, and doubles that become floats are one
// loop each, whatever the members are called; none is counted by hand. Here alone such a structure is read as an array.
#pragma once

#include <cstdint>
#include <type_traits>

#include "base/assert.hpp"
#include "math/pack.hpp"

/// In front of a loop over numbers that lie a pack apart: clang would gather and scatter them, which takes a third
/// longer than moving them one by one on some processors, and no less on others.
#if defined(__clang__)
#define PHYSIM_ONE_BY_ONE _Pragma("clang loop vectorize(disable)")
#else
#define PHYSIM_ONE_BY_ONE
#endif

namespace physim {

/// How many numbers a structure holds, of whatever type R.
template <template <class> class Struct>
inline constexpr unsigned kNumbers = sizeof(Struct<double>) / sizeof(double);

/// Stretches of a structure's numbers, in order.
struct NumberRuns {
  struct Run {
    std::uint8_t first, end;
  };
  static constexpr unsigned kMost = 8;
  Run run[kMost];
  unsigned count = 0;

  /// Extends the last run if it can.
  constexpr void add(unsigned first, unsigned numbers) {
    PHYSIM_ASSERT(first + numbers <= 255);
    const auto begin = static_cast<std::uint8_t>(first), end = static_cast<std::uint8_t>(first + numbers);
    if (count > 0 && run[count - 1].end == begin) return void(run[count - 1].end = end);
    PHYSIM_ASSERT(count < kMost && (count == 0 || run[count - 1].end < begin));
    run[count++] = {begin, end};
  }
  [[nodiscard]] constexpr unsigned numbers() const {
    unsigned sum = 0;
    for (unsigned i = 0; i < count; ++i) sum += static_cast<unsigned>(run[i].end - run[i].first);
    return sum;
  }
  /// The first number behind the last stretch.
  [[nodiscard]] constexpr unsigned end() const { return count == 0 ? 0 : run[count - 1].end; }
  /// Calls f with the index of each number.
  PHYSIM_INLINE void each(const auto& f) const {
    for (unsigned k = 0; k < count; ++k) {
      const unsigned end_of_run = run[k].end;  // read once: for all that compilers know f writes over it
      PHYSIM_ONE_BY_ONE
      for (unsigned i = run[k].first; i < end_of_run; ++i) f(i);
    }
  }
};

/// All numbers of a structure.
template <template <class> class Struct>
struct AllNumbers {
  PHYSIM_INLINE void each(const auto& f) const {
    PHYSIM_ONE_BY_ONE
    for (unsigned i = 0; i < kNumbers<Struct>; ++i) f(i);
  }
};

}  // namespace physim

PHYSIM_ISA_BEGIN

template <template <class> class Struct, class R>
PHYSIM_INLINE const R* numbers(const Struct<R>& s) {
  static_assert(std::is_trivially_copyable_v<Struct<R>> && sizeof s == kNumbers<Struct> * sizeof(R));
  return reinterpret_cast<const R*>(&s);
}
template <template <class> class Struct, class R>
PHYSIM_INLINE R* numbers(Struct<R>& s) {
  static_assert(std::is_trivially_copyable_v<Struct<R>> && sizeof s == kNumbers<Struct> * sizeof(R));
  return reinterpret_cast<R*>(&s);
}

/// As many numbers as R has lanes, from memory and into it.
template <class R, class T>
PHYSIM_INLINE R load_lanes(const T* from) {
  if constexpr (kLanes<R> == 1)
    return *from;
  else
    return R::load(from);
}
template <class R, class T>
PHYSIM_INLINE void store_lanes(const R& x, T* to) {
  if constexpr (kLanes<R> == 1)
    *to = x;
  else
    x.store(to);
}

/// Where the numbers of a lane begin; they lie sizeof(R) bytes apart.
template <class R>
PHYSIM_INLINE const char* lane_bytes(const R* numbers, int lane) {
  PHYSIM_ASSERT(lane >= 0 && lane < kLanes<R>);
  return static_cast<const char*>(static_cast<const void*>(numbers)) + sizeof(ScalarOf<R>) * unsigned(lane);
}
template <class R>
PHYSIM_INLINE char* lane_bytes(R* numbers, int lane) {
  PHYSIM_ASSERT(lane >= 0 && lane < kLanes<R>);
  return static_cast<char*>(static_cast<void*>(numbers)) + sizeof(ScalarOf<R>) * unsigned(lane);
}

/// Copies one lane of a structure to a lane of another; one of them may hold a single lane, as plain numbers.
template <template <class> class Struct, class R, class Into, class Runs = AllNumbers<Struct>>
PHYSIM_INLINE void copy_lane(const Struct<R>& from, int from_lane, Struct<Into>& into, int lane,
                             const Runs& runs = {}) {
  static_assert(std::is_same_v<ScalarOf<R>, ScalarOf<Into>>);
  const char* source = lane_bytes(numbers(from), from_lane);
  char* to = lane_bytes(numbers(into), lane);
  runs.each([source, to](unsigned i) PHYSIM_INLINE_LAMBDA {
    std::memcpy(to + i * sizeof(Into), source + i * sizeof(R), sizeof(ScalarOf<R>));
  });
}
template <class R, class Into>
PHYSIM_INLINE void copy_lane(const R& from, int from_lane, Into& into, int lane) {
  set_lane(into, lane, lane_of(from, from_lane));
}

/// Rounds doubles into one lane of a structure.
template <template <class> class Struct, class R, class Runs = AllNumbers<Struct>>
PHYSIM_INLINE void put_lane(const double* from, Struct<R>& into, int lane, const Runs& runs = {}) {
  using S = ScalarOf<R>;
  PHYSIM_ASSERT(from != nullptr);
  char* to = lane_bytes(numbers(into), lane);
  runs.each([from, to](unsigned i) PHYSIM_INLINE_LAMBDA {
    const S number = static_cast<S>(from[i]);
    std::memcpy(to + i * sizeof(R), &number, sizeof(S));
  });
}
template <template <class> class Struct, class R>
PHYSIM_INLINE void put_lane(const Struct<double>& from, Struct<R>& into, int lane) {
  put_lane(numbers(from), into, lane);
}

/// Doubles that become floats or the other way round, all lanes at a time.
template <template <class> class Struct, class R, class Into, class Runs = AllNumbers<Struct>>
PHYSIM_INLINE void cast_numbers(const Struct<R>& from, Struct<Into>& into, const Runs& runs = {}) {
  const R* source = numbers(from);
  Into* to = numbers(into);
  runs.each([source, to](unsigned i) PHYSIM_INLINE_LAMBDA { to[i] = cast<ScalarOf<Into>>(source[i]); });
}

PHYSIM_ISA_END
