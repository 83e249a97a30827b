// The namespace of the instruction set that a file is compiled for.
//
// Kernel files (*_kernel.cpp) are compiled once per instruction set with -DPHYSIM_ISA=avx2 and so on. Everything that
// they instantiate lives in an inline namespace of that name, so that the copies never meet in the linker.
#pragma once

#include "physim/macros.hpp"

#ifndef PHYSIM_ISA
#define PHYSIM_ISA base
#endif

/// A function template behind a call: long, and seldom flown. Each file that calls it has a copy of its own: of one
/// that other files might share, clang must think that another compiler's does what this one does not, and changes
/// whatever it is told the place of.
#define PHYSIM_NOINLINE [[gnu::noinline]] static

#define PHYSIM_ISA_BEGIN \
  namespace physim {     \
  inline namespace PHYSIM_ISA {
#define PHYSIM_ISA_END \
  }                    \
  }
