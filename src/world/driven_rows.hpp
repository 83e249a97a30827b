// Driven rows: what emitters do to the flights of many of their particles, asked for pack by pack.
//
// What a law reads of a particle lies by slots, all over the memory, and stays as it is while the particle lives. So it
// is kept here in order of rows from step to step, and looked up anew only where a row or a slot has changed hands.
#pragma once

#include <span>
#include <vector>

#include "world/drive.hpp"

namespace physim {

/// Where and how fast the rows of a block are in a stage; rows of blocks begin at `first`.
struct DrivenBlock {
  static constexpr std::size_t kMost = FlightLaw::kPack;
  using Vectors = FlightPack<kMost>::Vectors;
  std::uint16_t cohort = 0;
  std::uint32_t first = 0, count = 0;
  Vectors x, v;
  Vectors a;  // to which what emitters do is added [m/s^2]
};

class DrivenRows {
 public:
  /// Before the stages of a step: who is in the rows now.
  void find(const Registry& registry, WorldState& state);
  /// The world is as it was at another time: nothing that is known holds.
  void forget() { cohorts_.clear(); }
  /// In a stage at a time of the world.
  void push(const Registry& registry, const WorldState& state, double time, DrivenBlock& block) const;
  /// Whether all of it is done by packs: velocities that are added need to know of the whole step.
  [[nodiscard]] static bool in_packs(const WorldState& state);

 private:
  struct Row {
    std::uint32_t slot = 0;
    std::uint32_t emitter = 0;  // that drives it; 0: none
    InFlight particle;
  };
  void look_up(const WorldState& state, Row& row, std::uint32_t slot) const;
  void put_felt(const Registry& registry, const WorldState& state, const FlightLaw& law, const DrivenBlock& block,
                std::span<const std::uint8_t> lanes, FlightPack<FlightLaw::kPack>& pack) const;

  std::vector<std::vector<Row>> cohorts_;
};

}  // namespace physim
