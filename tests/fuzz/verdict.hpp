// What a fuzz finds wrong, and how much it tried.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>

#include "physim/math.hpp"

namespace physim::test {

inline long case_number = 0, faults = 0;

inline void fault(const char* what) {
  std::printf("world %ld: %s\n", case_number, what);
  ++faults;
}
inline void expect(bool holds, const char* what) {
  if (!holds) fault(what);
}

/// Shows that not all was refused.
struct Tally {
  std::uint64_t calls = 0, spawned = 0, steps = 0, saves = 0, damaged_loads = 0, replays = 0, inside = 0, flights = 0,
                flown = 0;
};
inline Tally tally;

inline bool is_finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace physim::test
