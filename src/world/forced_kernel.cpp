// Compiled once per instruction set, in a namespace of its name.
#include "world/forced_rows.hpp"

PHYSIM_ISA_BEGIN

bool advance_forced(const ForcedJob<float>& job) { return advance_packs<Pack<float, 2 * kNativeBytes / 4>>(job); }
bool advance_forced(const ForcedJob<double>& job) { return advance_packs<Pack<double, 2 * kNativeBytes / 8>>(job); }

PHYSIM_ISA_END
