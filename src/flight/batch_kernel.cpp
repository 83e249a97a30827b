// Compiled once per instruction set, in a namespace of its name. Four packs of one register side by side hide the
// latency of one best; the 16 registers of older processors leave no room for that, there one pack of two does.
#include "flight/batch_driver.hpp"

PHYSIM_ISA_BEGIN

namespace {
#if defined(__AVX__)
constexpr int kSets = 4;
constexpr int kBytes = kNativeBytes;
#else
constexpr int kSets = 1;
constexpr int kBytes = 2 * kNativeBytes;
#endif
}  // namespace

void fly_bodies(const BatchJob<float>& job) { fly_lanes<Pack<float, kBytes / 4>, kSets>(job); }
void fly_bodies(const BatchJob<double>& job) { fly_lanes<Pack<double, kBytes / 8>, kSets>(job); }

// One number at a time, for comparison and for equivalence tests.
void fly_bodies_singly(const BatchJob<float>& job) { fly_lanes<float, 4>(job); }
void fly_bodies_singly(const BatchJob<double>& job) { fly_lanes<double, 4>(job); }

PHYSIM_ISA_END
