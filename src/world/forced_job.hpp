// Forced rows: projectiles that generators push. They step together, stage by stage; here is what a kernel is given.
#pragma once

#include "world/world_job.hpp"

namespace physim {

/// Columns of scratch memory of a cohort's rows, each as long as its rows rounded up to whole packs.
enum ForcedColumn : unsigned {
  kStagePosition = 0,  // of the stage; at last of the end
  kStageVelocity = 3,
  kPush = 6,       // acceleration by generators in the stage
  kFirstPush = 9,  // the same in the first stage
  kSlopes = 12,    // of stage i from 6 i on: velocity, acceleration
};

/// Rungs that turn have further columns behind the slopes: the Turn of the stage, at last that of the end, then its
/// slopes in all stages.
[[nodiscard]] constexpr unsigned turn_column(int stages) { return kSlopes + 6 * static_cast<unsigned>(stages); }
[[nodiscard]] constexpr unsigned turn_slope_column(int stages, int stage) {
  return turn_column(stages) + kNumbers<Turn> * (1 + static_cast<unsigned>(stage));
}
[[nodiscard]] constexpr unsigned forced_columns(int stages, bool turning) {
  return turning ? turn_slope_column(stages, stages) : turn_column(stages);
}

/// Rows of one cohort in one stage.
template <class S>
struct ForcedJob {
  WorldJob<S> rows;
  S* memory;
  std::size_t stride;  // from column to column
  int stage;
  bool own_force;  // some have a ProjectileDef::force

  [[nodiscard]] S* column(unsigned k) const { return memory + k * stride; }
};

}  // namespace physim
