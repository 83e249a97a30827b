// The few macros of the library.
#pragma once

/// PHYSIM_INLINE forces inlining in kernel files, which are compiled once per instruction set (the compiler defines
/// PHYSIM_ISA for them alone): no copy of a small function may be left that the linker could share with code for an
/// older processor. Everywhere else it is `inline`, for smaller programs that compile sooner; there
/// PHYSIM_INLINE_ALWAYS forces it for the sums of a step, and PHYSIM_FLAT for all that the acceleration calls: without
/// them a flight by fixed steps takes half as long again. A lambda has PHYSIM_INLINE_LAMBDA behind its parameters.
/// Small kernels, of which there is one copy, are called.
#if (defined(__GNUC__) || defined(__clang__)) && !defined(PHYSIM_SMALL_KERNELS)
#define PHYSIM_INLINE_ALWAYS [[gnu::always_inline]] inline
#define PHYSIM_INLINE_LAMBDA __attribute__((always_inline))
#define PHYSIM_FLAT [[gnu::flatten]]
#else
#define PHYSIM_INLINE_ALWAYS inline
#define PHYSIM_INLINE_LAMBDA
#define PHYSIM_FLAT
#endif
#ifdef PHYSIM_ISA
#define PHYSIM_INLINE PHYSIM_INLINE_ALWAYS
#else
#define PHYSIM_INLINE inline
#endif

/// Enumerators are names: none is less than another. Rungs are compared by their level (RungInfo).
#define PHYSIM_UNORDERED(Enum)          \
  bool operator<(Enum, Enum) = delete;  \
  bool operator<=(Enum, Enum) = delete; \
  bool operator>(Enum, Enum) = delete;  \
  bool operator>=(Enum, Enum) = delete;
