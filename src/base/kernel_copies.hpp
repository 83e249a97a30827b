// Declares what a kernel file offers, once for each instruction set that it was compiled for (cmake/kernels.cmake).
#pragma once

#include "base/isa.hpp"
#include "base/kernel_sets.hpp"  // generated: PHYSIM_HAVE_AVX2, PHYSIM_HAVE_AVX512

#if PHYSIM_HAVE_AVX2
#define PHYSIM_AVX2_COPY(...) \
  namespace avx2 {            \
  __VA_ARGS__                 \
  }
#else
#define PHYSIM_AVX2_COPY(...)
#endif
#if PHYSIM_HAVE_AVX512
#define PHYSIM_AVX512_COPY(...) \
  namespace avx512 {            \
  __VA_ARGS__                   \
  }
#else
#define PHYSIM_AVX512_COPY(...)
#endif

/// The declarations, in namespaces base, avx2 and avx512 of the one it stands in.
#define PHYSIM_KERNEL_COPIES(...) \
  inline namespace base {         \
  __VA_ARGS__                     \
  }                               \
  PHYSIM_AVX2_COPY(__VA_ARGS__)   \
  PHYSIM_AVX512_COPY(__VA_ARGS__)
