// The namespace of the instruction set that a file is compiled for.
//
// Kernel files (*_kernel.cpp) are compiled once per instruction set with -DPHYSIM_ISA=avx2 and so on. Everything that
// they instantiate lives in an inline namespace of that name, so that the copies never meet in the linker.
#pragma once

#include "physim/math.hpp"

/// A function template behind a call. Of clang each kernel file has its own copy: if files may share one, clang assumes
/// that another compiler's may replace it, and that it changes whatever it gets the address of.
#if defined(PHYSIM_ISA) && defined(__clang__)
#define PHYSIM_NOINLINE [[gnu::noinline]] static
#else
#define PHYSIM_NOINLINE [[gnu::noinline]]
#endif
#ifndef PHYSIM_ISA
#define PHYSIM_ISA base
#endif

/// 1 in kernels with copies of their loops for the rungs that are flown most; 0 in those that a better copy replaces on
/// most machines. The bits are the same.
#ifndef PHYSIM_KNOWS_RUNGS
#define PHYSIM_KNOWS_RUNGS 1
#endif

/// A function of preparation or of questions, or one that steps seldom call. The compiler keeps it small: programs link
/// it whatever they fly.
#define PHYSIM_COLD [[gnu::cold]]

#define PHYSIM_ISA_BEGIN \
  namespace physim {     \
  inline namespace PHYSIM_ISA {
#define PHYSIM_ISA_END \
  }                    \
  }
