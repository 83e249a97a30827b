// The few macros of the library.
#pragma once

/// Forces inlining, so that a small function compiled for several instruction sets never leaves a shared copy behind. A
/// lambda says PHYSIM_INLINE_LAMBDA behind its parameters. Builds with small kernels, which hold no copy but one, call.
#if (defined(__GNUC__) || defined(__clang__)) && !defined(PHYSIM_SMALL_KERNELS)
#define PHYSIM_INLINE [[gnu::always_inline]] inline
#define PHYSIM_INLINE_LAMBDA __attribute__((always_inline))
#else
#define PHYSIM_INLINE inline
#define PHYSIM_INLINE_LAMBDA
#endif

/// Enumerators are names: none is less than another. Rungs are compared by their level (RungInfo).
#define PHYSIM_UNORDERED(Enum)          \
  bool operator<(Enum, Enum) = delete;  \
  bool operator<=(Enum, Enum) = delete; \
  bool operator>(Enum, Enum) = delete;  \
  bool operator>=(Enum, Enum) = delete;
