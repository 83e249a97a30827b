// Forced rows: projectiles that generators push. They step together, stage by stage; here is what a kernel is given.
#pragma once

#include "world/step/world_job.hpp"

namespace physim {

/// Columns of scratch memory of a cohort's rows, each as long as its rows rounded up to whole packs.
enum ForcedColumn : unsigned {
  kStagePosition = 0,  // of the stage; at last of the end
  kStageVelocity = 3,
  kPush = 6,       // acceleration by generators in the stage
  kFirstPush = 9,  // acceleration by generators in the first stage
  kPushRate = 12,  // of the drag in them [1/s]
  kFirstPushRate = 13,
  kSlopes = 14,  // of stage i from 6 i on: velocity, acceleration
};

/// Rungs that turn have further columns behind the slopes: the Turn of the stage, at last that of the end, then its
/// slopes in all stages.
[[nodiscard]] constexpr unsigned turn_column(int stages) { return kSlopes + 6 * static_cast<unsigned>(stages); }
[[nodiscard]] constexpr unsigned forced_columns(int stages, bool turning) {
  return turn_column(stages) + (turning ? kNumbers<Turn> * (1 + static_cast<unsigned>(stages)) : 0);
}

/// The columns of a part of what is flown: the state or the Turn.
struct PartColumns {
  unsigned stage;   // of the stage; at last of the end
  unsigned slopes;  // of stage i from slopes + width i on
  unsigned width;

  [[nodiscard]] PHYSIM_INLINE unsigned slope(int i) const { return slopes + width * static_cast<unsigned>(i); }
};
/// Where the two parts of what is flown have their scratch columns.
template <class R>
PHYSIM_INLINE PartColumns columns_of(const Step<R>&, int) {
  return {kStagePosition, kSlopes, 6};
}
template <class R>
PHYSIM_INLINE PartColumns columns_of(const TurnStep<R>&, int stages) {
  return {turn_column(stages), turn_column(stages) + kNumbers<Turn>, kNumbers<Turn>};
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
