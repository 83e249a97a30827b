// The parts that a flight is made of, one at a time, in packs of the widest kernel of each instruction set.
#pragma once

#include <cstddef>

#include "solve/lanes.hpp"

namespace physim::bench {

enum class Part {
  exp,         // e^x
  log,         // ln x
  cd_lookup,   // Cd by Mach number from the curve
  air,         // standard atmosphere
  rhs,         // the whole acceleration
  rk4_step,    // four of them and the sums
  tsit5_step,  // six, the sums, error and step control
  dop853_step,
  watch,   // looking for events
  accept,  // moving on
  enter,   // preparing a shot and putting it into a lane
};
inline constexpr int kParts = 11;
[[nodiscard]] const char* name(Part part);

template <class S>
struct MicroJob {
  const Course<S>* course;
  const Body<S>* bodies;  // as many as the widest pack has lanes
  int repeats;
  S* sink;  // a pack's worth of results, so that nothing is optimised away
};

/// Runs a part `repeats` times and returns how many lanes that made.
using MicroDouble = std::size_t (*)(Part part, const MicroJob<double>& job);
using MicroFloat = std::size_t (*)(Part part, const MicroJob<float>& job);

inline constexpr int kMostLanes = 32;

}  // namespace physim::bench
