// How several particles of an emitter start, side by side: each with the bits that Emission::newborn() has for it
// alone.
#pragma once

#include <array>
#include <cstdint>

#include "emit/emission.hpp"
#include "emit/particle_job.hpp"

namespace physim {

/// Births, which come in, and newborns, in the frame of their emitter, which come out; none of them rounds of a gun.
/// Unused lanes hold a birth, too, but their starts are unspecified.
struct NewbornPack {
  static constexpr std::size_t kLanes = kColumn;
  using Column = std::array<double, kLanes>;

  std::size_t count = kLanes;                // lanes in use, the first ones
  std::array<std::uint64_t, kLanes> number;  // as Birth has it
  Column time, phase;                        // as Birth has it
  std::array<std::uint32_t, kLanes> of_moment, moment;

  std::array<Column, 3> place;      // [m]
  std::array<Column, 3> direction;  // of length one
  Column speed;                     // [m/s]
  Column lifetime;                  // [s]

  [[nodiscard]] Birth birth(std::size_t lane) const {
    return {number[lane], time[lane], phase[lane], of_moment[lane], moment[lane]};
  }
};

}  // namespace physim
