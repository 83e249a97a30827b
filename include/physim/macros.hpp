// The few macros of the library.
#pragma once

/// Forces inlining, so that a small function compiled for several instruction sets never leaves a shared copy behind.
#if defined(__GNUC__) || defined(__clang__)
#define PHYSIM_INLINE [[gnu::always_inline]] inline
#else
#define PHYSIM_INLINE inline
#endif
