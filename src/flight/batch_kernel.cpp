// Compiled once per instruction set, in a namespace of its name; the widest pack that pays is two registers.
#include "flight/batch_driver.hpp"

PHYSIM_ISA_BEGIN

void fly_bodies(const BatchJob<float>& job) { fly_lanes<Pack<float, 2 * kNativeBytes / 4>>(job); }
void fly_bodies(const BatchJob<double>& job) { fly_lanes<Pack<double, 2 * kNativeBytes / 8>>(job); }

// One flight after the other, for comparison and for equivalence tests.
void fly_bodies_singly(const BatchJob<float>& job) { fly_lanes<float>(job); }
void fly_bodies_singly(const BatchJob<double>& job) { fly_lanes<double>(job); }

PHYSIM_ISA_END
