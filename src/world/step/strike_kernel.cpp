// Compiled once per instruction set, in a namespace of its name. Packs are as wide as those that the world steps in
// double, whatever the rows' precision: the search for the ground is in double.
#include "world/step/strike_packs.hpp"

PHYSIM_ISA_BEGIN

void strike_rows(StrikeJob<float>& job) { strike_packs<Pack<float, PHYSIM_PACK_BYTES / 8>>(job); }
void strike_rows(StrikeJob<double>& job) { strike_packs<Pack<double, PHYSIM_PACK_BYTES / 8>>(job); }

PHYSIM_ISA_END
