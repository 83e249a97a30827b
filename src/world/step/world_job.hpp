// What the world's kernels are given: plain data, the same for every instruction set.
#pragma once

#include "solve/lanes.hpp"
#include "world/core/rows.hpp"
#include "world/core/static_rungs.hpp"

namespace physim {

/// Events of the watch list that the numbers of a Watchdog find: the ground, the end of the air and apexes, and
/// what happens to motors and on rails.
PHYSIM_INLINE bool is_seen_by_watchdog(const Watched& watched) {
  return watched.outcome != Outcome::event || watched.spec.kind == EventKind::apex ||
         row_of(watched.spec.kind).needs != Needs::nothing;
}

/// What makes a row worth a second look after a step. Everything is the same for a whole cohort.
template <class S>
struct Watchdog {
  S floor;      // height at or below which the ground, a rule or the end of the air may be [m]; -infinity: none
  S slowest;    // speed [m/s]: of a rule, or of rest
  S farthest;   // distance from the launch [m]
  Vec3<S> low;  // corners of the box [m]
  Vec3<S> high;
  bool apex;     // the highest point is an event
  bool watched;  // further events of the course's watch list are needed, see is_seen_by_watchdog()
  bool box;
  bool simple;  // nothing but floor and slowest is watched
};

/// Where something may be in a step that rows have not noticed (world/step/restless.hpp).
template <class S>
struct RestlessBoxes {
  static constexpr unsigned kMost = 33;
  unsigned count = 0;               // 0: all rests
  Vec3<S> low[kMost], high[kMost];  // corners; the first box holds all others [m]
};

/// Worlds with more bytes than this do not fit into usual caches. There a line that is about to be overwritten is not
/// worth fetching from memory first: positions are stored past the caches, which saves a sixth of the traffic.
inline constexpr std::size_t kCacheBytes = 24u << 20;

/// Pushes of emitters on rows at the start of a step, felt for all of it. Columns begin with the first row of a job.
template <class S>
struct RowPush {
  const S* a[3];       // acceleration [m/s^2]
  const S* drag_rate;  // of the drag in it [1/s]
  const double* drag;  // linear drag is all of it: its rate [1/s]; null: the columns above

  [[nodiscard]] PHYSIM_INLINE bool is_there() const { return drag != nullptr || drag_rate != nullptr; }
};

/// Rows to step once.
template <class S>
struct WorldJob {
  const Course<S>* course;
  std::int8_t static_rung;  // of the course
  RowPush<S> push;
  RowColumns<S> columns;
  const std::uint8_t* fields;
  const std::uint32_t* field_masks;  // of a Body's numbers, see RowMasks
  unsigned field_count;
  bool stream;  // positions are stored past the caches
  bool clocked;
  bool launched;
  S now;                             // number of this step
  S h;                               // [s]
  S radius;                          // of none of the rows is it larger [m]
  const RestlessBoxes<S>* restless;  // null: all rests, or no row meets it
  Watchdog<S> watchdog;
  std::uint32_t first;  // row, a multiple of 32
  std::uint32_t last;
  std::uint32_t* attention;  // bit i of word w: row 32 w + i was left where it was, and needs a closer look
  std::uint32_t* near;       // bits as in attention: rows that moved on and may have come near a thing; null: unwanted
};

}  // namespace physim
