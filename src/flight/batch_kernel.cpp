// Compiled once per instruction set, in a namespace of its name. Four packs of one register side by side hide the
// latency of one; where there are 32 registers, two packs of two do it better in double (see cmake/kernels.cmake).
#include "flight/batch_driver.hpp"

PHYSIM_ISA_BEGIN

namespace {
#ifdef __AVX512F__
constexpr int kDoubleRegisters = 2;
#else
constexpr int kDoubleRegisters = 1;
#endif
}  // namespace

void fly_bodies(const BatchJob<float>& job) { fly_lanes<Pack<float, kNativeBytes / 4>, PHYSIM_BATCH_PACKS>(job); }
void fly_bodies(const BatchJob<double>& job) {
  fly_lanes<Pack<double, kDoubleRegisters * kNativeBytes / 8>, PHYSIM_BATCH_PACKS / kDoubleRegisters>(job);
}

#if !PHYSIM_PACKS_ALONE
// One number at a time, for comparison and for equivalence tests.
void fly_bodies_singly(const BatchJob<float>& job) { fly_lanes<float, 4>(job); }
void fly_bodies_singly(const BatchJob<double>& job) { fly_lanes<double, 4>(job); }
#endif

PHYSIM_ISA_END
