// The namespace of the instruction set that a file is compiled for.
//
// Kernel files (*_kernel.cpp) are compiled once per instruction set with -DPHYSIM_ISA=avx2 and so on. Everything that
// they instantiate lives in an inline namespace of that name, so that the copies never meet in the linker.
#pragma once

#include "physim/macros.hpp"

#ifndef PHYSIM_ISA
#define PHYSIM_ISA base
#endif

#define PHYSIM_ISA_BEGIN \
  namespace physim {     \
  inline namespace PHYSIM_ISA {
#define PHYSIM_ISA_END \
  }                    \
  }
