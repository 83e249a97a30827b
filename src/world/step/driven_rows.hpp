// Driven rows: the effects of emitters on the flights of many of their particles, computed pack by pack.
//
// What a law reads of a particle lies by slots, scattered in memory, and is constant while the particle lives. So it is
// kept here in order of rows from step to step, and looked up again only if a row has changed.
#pragma once

#include <span>
#include <vector>

#include "world/step/drive.hpp"
#include "world/step/world_job.hpp"

namespace physim {

/// Where and how fast the rows of a block are in a stage; rows of blocks begin at `first`.
struct DrivenBlock {
  static constexpr std::size_t kMost = FlightLaw::kPack;
  using Vectors = FlightPack<kMost>::Vectors;
  std::uint16_t cohort = 0;
  std::uint32_t first = 0, count = 0;
  Vectors x, v;
  Vectors a;                            // to which what emitters do is added [m/s^2]
  FlightPack<kMost>::Column drag_rate;  // of the drag in it, is added to [1/s]

  /// Takes the states of its rows out of columns of places and velocities, which are padded to whole blocks.
  template <class S>
  void put(const S* const (&columns)[6], std::uint32_t row) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < kMost; ++i) {
        x[axis][i] = static_cast<double>(columns[axis][row + i]);
        v[axis][i] = static_cast<double>(columns[axis + 3][row + i]);
      }
  }
};

/// Memory of the pushes of some rows, used again from step to step.
struct PushMemory {
  std::vector<float> floats;
  std::vector<double> doubles;
};

class DrivenRows {
 public:
  /// Before the stages of a step of a length: finds which particles the rows hold now.
  void find(const Registry& registry, WorldState& state, double time, double dt);
  /// The world is as it was at another time: nothing that is known holds.
  void forget() { cohorts_.clear(); }
  /// In a stage at a time of the world.
  void push(const Registry& registry, const WorldState& state, Integrator integrator, double time,
            DrivenBlock& block) const;
  /// Pushes on rows of a cohort at the start of a step, if they feel nothing else in it.
  template <class S>
  [[nodiscard]] RowPush<S> pushes(const Registry& registry, const WorldState& state, std::uint16_t cohort,
                                  std::uint32_t first, std::uint32_t last, PushMemory& memory) const;

 private:
  /// What is known of rows, in columns as long as whole packs.
  struct Columns {
    bool is_known = false;
    std::vector<std::uint32_t> slot;
    std::vector<std::uint32_t> emitter;  // that drives it; 0: none
    std::vector<std::uint64_t> number;   // of the particle, as InFlight has it; 0: none
    std::vector<double> birth, span;
    void resize(std::size_t rows);  // those behind the last one belong to no particle
    void look_up(const WorldState& state, std::uint32_t row, std::uint32_t slot);
    /// Whether what is known of a row is so.
    [[nodiscard]] bool is_of(const WorldState& state, const Rows& rows, std::uint64_t row) const;
  };
  using Lanes = std::array<std::uint8_t, DrivenBlock::kMost>;
  /// Calls f for each emitter among `count` rows from `first` on, with its law, the lanes of its rows, the last ones
  /// filled up, and how many those are.
  template <class F>
  void each_law(const WorldState& state, const Columns& rows, std::uint32_t first, std::uint32_t count,
                const F& f) const;
  void put_felt(const Registry& registry, const WorldState& state, const FlightLaw& law, const DrivenBlock& block,
                std::span<const std::uint8_t> lanes, FlightPack<FlightLaw::kPack>& pack) const;

  void push_alone(const Registry& registry, const WorldState& state, Integrator integrator, double time,
                  DrivenBlock& block) const;
  /// Rates of drag of DrivenBlock::kMost rows of a cohort, where that by age is all that emitters do [1/s].
  void rates(const ParticleKernel& kernel, const WorldState& state, std::uint16_t cohort, std::uint32_t first,
             double* rate) const;

  std::vector<Columns> cohorts_;
  double time_ = 0, dt_ = 0;  // of the step [s]
  bool in_packs_ = true;      // else velocities are added, which need the whole step
  bool drag_by_age_ = false;  // emitters do nothing to flights but drag with a rate that follows age
};

}  // namespace physim
