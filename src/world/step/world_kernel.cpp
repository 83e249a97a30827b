// Compiled once per instruction set, in a namespace of its name; the widest pack that pays is two registers.
#include "world/step/forced_rows.hpp"
#include "world/step/step_rows.hpp"

PHYSIM_ISA_BEGIN

bool step_rows(const WorldJob<float>& job) { return step_packs_of<Pack<float, PHYSIM_PACK_BYTES / 4>>(job); }
bool step_rows(const WorldJob<double>& job) { return step_packs_of<Pack<double, PHYSIM_PACK_BYTES / 8>>(job); }

bool advance_forced(const ForcedJob<float>& job) { return advance_packs<Pack<float, PHYSIM_PACK_BYTES / 4>>(job); }
bool advance_forced(const ForcedJob<double>& job) { return advance_packs<Pack<double, PHYSIM_PACK_BYTES / 8>>(job); }

PHYSIM_ISA_END
