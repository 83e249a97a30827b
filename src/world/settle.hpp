// Settling: the closer look at rows to which something may have happened inside a step. The kernels leave such rows
// where they were; here each is stepped by itself, with the same numbers, its events are located and acted on.
#pragma once

#include <vector>

#include "world/state.hpp"

namespace physim {

/// What settling decided that concerns more than the row itself; done after the step, in order of slots.
struct Change {
  enum class Kind : std::uint8_t { remove, stick, sleep };
  std::uint32_t slot;
  Kind kind;
  LifeStatus status;
  Reason reason;
};

/// Rows of one cohort that one thread steps.
struct Chunk {
  std::uint16_t cohort = 0;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  bool attention = false;
  std::vector<WorldEvent> events;
  std::vector<Change> changes;
};

/// Memory that steps use again and again.
struct StepScratch {
  std::vector<std::uint32_t> attention;   // a bit for each row
  std::vector<std::size_t> words_before;  // of each cohort's rows in it
  std::vector<Chunk> chunks;
  std::size_t chunk_count = 0;
  std::vector<Change> changes;
};

/// What settling reads beside the row.
struct SettleContext {
  const WorldDef* def;
  const Registry* registry;
  WorldState* state;  // only the chunk's own rows and slots are written
  double dt;
  double now;   // number of the step, as rows count
  double time;  // at the start of the step [s]
  // Forced rows: acceleration by generators at the start of the step, held over it; else zero.
  Vec3d held{};
};

/// Steps one row that was left where it was, and writes where it is after the step.
void settle_row(const SettleContext& context, Chunk& chunk, std::uint32_t row);

}  // namespace physim
