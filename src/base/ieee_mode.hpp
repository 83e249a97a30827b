// IeeeMode: while it lives, the processor computes as IEEE 754 has it by default, whatever the caller's thread is set
// to: rounding to nearest, subnormal numbers kept, no traps. A program linked with -ffast-math, and threads of many
// engines, flush subnormal numbers to zero; others round upwards or downwards.
//
// The compiler does not know that the mode changes the result of an operation. It may move an operation behind the end
// of the mode if the result is used only there, in a caller that inlines the function. Public calls are not inlined, so
// they return finished results. The functions of this class are always inline, which is the form that the tests check.
//
// It stands in the first line of every public call that computes and of every task on a lent thread. Inside another
// one, and where the caller's mode is the default already, it costs a look at a register, less than 1 ns; elsewhere
// some 30 ns.
#pragma once

#include <cstdint>

#include "base/strict_math.hpp"
#include "physim/math.hpp"

#if defined(__x86_64__) || defined(_M_X64) || defined(__SSE2_MATH__)
#include <emmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace physim {

#if defined(__x86_64__) || defined(_M_X64) || defined(__SSE2_MATH__)

/// The control and status register of SSE and AVX.
struct ModeRegister {
  using Value = std::uint32_t;
  static constexpr Value kDefault = 0x1f80;  // all exceptions masked, rounding to nearest, no flushing
  static constexpr Value kFlags = 0x003f;    // exceptions that were seen: no part of the mode
  PHYSIM_INLINE_ALWAYS static Value read() { return _mm_getcsr(); }
  PHYSIM_INLINE_ALWAYS static bool is_default(Value value) { return (value & 0xffffu & ~kFlags) == kDefault; }
  PHYSIM_INLINE_ALWAYS static void set_default() { _mm_setcsr(kDefault); }
  PHYSIM_INLINE_ALWAYS static void put_back(Value value) { _mm_setcsr(value); }
};

#elif defined(__aarch64__)

/// The floating-point control register.
struct ModeRegister {
  using Value = std::uint64_t;
  PHYSIM_INLINE_ALWAYS static Value read() {
    Value value;
    asm volatile("mrs %0, fpcr" : "=r"(value));
    return value;
  }
  PHYSIM_INLINE_ALWAYS static bool is_default(Value value) { return value == 0; }
  PHYSIM_INLINE_ALWAYS static void set_default() { put_back(0); }
  PHYSIM_INLINE_ALWAYS static void put_back(Value value) { asm volatile("msr fpcr, %0" : : "r"(value) : "memory"); }
};

#else

/// What the C++ standard library controls: rounding, not subnormal numbers.
struct ModeRegister {
  using Value = int;
  static Value read() { return std::fegetround(); }
  static bool is_default(Value value) { return value == FE_TONEAREST; }
  static void set_default() { put_back(FE_TONEAREST); }
  static void put_back(Value value) { std::fesetround(value); }
};

#endif

class IeeeMode {
 public:
  PHYSIM_INLINE_ALWAYS IeeeMode() : before_(ModeRegister::read()) {
    if (!ModeRegister::is_default(before_)) ModeRegister::set_default();
  }
  /// Puts the caller's setting back, with the exceptions that the caller had seen.
  PHYSIM_INLINE_ALWAYS ~IeeeMode() {
    if (!ModeRegister::is_default(before_)) ModeRegister::put_back(before_);
  }
  IeeeMode(const IeeeMode&) = delete;
  IeeeMode& operator=(const IeeeMode&) = delete;

 private:
  ModeRegister::Value before_;
};

}  // namespace physim
