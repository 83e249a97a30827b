// The step of forced rows: all that share an integrator go through it together, stage by stage, because springs join
// them and one user function sees them all.
#pragma once

#include <functional>

#include "world/step/driven_rows.hpp"
#include "world/step/force_field.hpp"
#include "world/step/settle.hpp"

namespace physim {

/// The rows of a cohort in such a step.
struct ForcedRun {
  std::uint16_t cohort;
  std::uint32_t first;  // row of its group
  std::uint32_t count;  // rows
  std::size_t memory;   // where its columns begin
  std::size_t words;    // where its marks begin
  bool attention;       // some rows need a closer look
};

/// Rows of one integrator.
struct ForcedGroup {
  Integrator integrator;
  std::size_t first_run;
  std::size_t last_run;
};

/// Memory that steps use again and again.
struct ForcedScratch {
  std::vector<ForcedRun> runs;
  std::vector<ForcedGroup> groups;
  ForceRows rows;  // of the group at hand
  std::vector<float> floats;
  std::vector<double> doubles;
  std::vector<std::uint32_t> attention;
  ZoneDrag zones;
  DrivenRows driven;
  Chunk chunk;  // events and changes
  std::vector<std::uint32_t> over;

  template <class S>
  [[nodiscard]] std::vector<S>& memory() {
    if constexpr (sizeof(S) == 4) return floats;
    if constexpr (sizeof(S) == 8) return doubles;
  }
};

/// True if nothing pushes the rows of a cohort in the stages of a step, or emitters alone in its only stage: each steps
/// by itself then, as free rows do.
[[nodiscard]] bool steps_with_free(const SettleContext& context, std::uint16_t cohort);

/// Steps all other forced rows that move; returns how many. Where they are then stands as their next position: nothing
/// that other rows see is changed.
std::size_t step_forced_rows(const SettleContext& context, ForcedScratch& scratch);

/// Calls f with what settles a row of a cohort in the step just taken, which is as it was before it.
void with_taken_step(const SettleContext& context, ForcedScratch& scratch, std::uint16_t cohort, std::uint32_t row,
                     const std::function<void(const SettleContext&)>& f);

}  // namespace physim
