// Compiled once per instruction set, in a namespace of its name; the widest pack that pays is two registers.
#include "world/forced_rows.hpp"
#include "world/place_rows.hpp"
#include "world/step_rows.hpp"

PHYSIM_ISA_BEGIN

bool step_rows(const WorldJob<float>& job) { return step_packs_of<Pack<float, PHYSIM_PACK_BYTES / 4>>(job); }
bool step_rows(const WorldJob<double>& job) { return step_packs_of<Pack<double, PHYSIM_PACK_BYTES / 8>>(job); }

Advanced advance_forced(const ForcedJob<float>& job) { return advance_packs<Pack<float, PHYSIM_PACK_BYTES / 4>>(job); }
Advanced advance_forced(const ForcedJob<double>& job) {
  return advance_packs<Pack<double, PHYSIM_PACK_BYTES / 8>>(job);
}

void place_rows(const WorldJob<float>& job) { place_packs_of<Pack<float, PHYSIM_PACK_BYTES / 4>>(job); }
void place_rows(const WorldJob<double>& job) { place_packs_of<Pack<double, PHYSIM_PACK_BYTES / 8>>(job); }

bool are_quiet(const WorldJob<float>& job, std::uint32_t steps) {
  return quiet_packs_of<Pack<float, PHYSIM_PACK_BYTES / 4>>(job, steps);
}
bool are_quiet(const WorldJob<double>& job, std::uint32_t steps) {
  return quiet_packs_of<Pack<double, PHYSIM_PACK_BYTES / 8>>(job, steps);
}

PHYSIM_ISA_END
