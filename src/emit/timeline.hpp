// Timeline: when an emitter fires on its own. The moments follow from its definition and seed alone, one after the
// other, so that no frame can shift one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "emit/emission.hpp"

namespace physim {

/// Many, or one, at one time.
struct EmitMoment {
  double time = 0;   // since the emitter began to play, by its own clock [s]
  double phase = 0;  // of the cycle, 0..1
  std::uint32_t count = 1;
  bool is_round = false;    // of the gun
  std::uint64_t round = 0;  // its number then, from 0
};

/// The progress of an emitter, for each source: its rate, each of its bursts, its gun. Plain numbers, which a save
/// holds; they follow from how many moments were taken, and spare finding each again.
struct TimelineState {
  std::uint64_t play = 0;              // how often it has begun to play before; what is drawn differs
  std::vector<std::uint64_t> taken{};  // moments taken, and those of bursts that came to nothing
  std::vector<double> at{};            // when the next one is, since the first cycle began; infinite: none [s]
  std::uint64_t rate_cycle = 0;        // of a rate that each cycle draws: which cycle the next birth lies in
  double rate_before = 0;              // and the births of the cycles before, parts of one too

  bool operator==(const TimelineState&) const = default;
};

class Timeline {
 public:
  explicit Timeline(const Emission& emission) : emission_(emission) {}

  /// Nothing was taken.
  [[nodiscard]] TimelineState begin(std::uint64_t play) const;
  /// Whether a state, as a save may hold it, can be one of this emitter's.
  [[nodiscard]] bool is_of(const TimelineState& state) const;
  /// The first moment that was not taken; none: it will not fire any more. Of one time, those with a lower source
  /// first.
  [[nodiscard]] std::optional<EmitMoment> next(const TimelineState& state) const;
  /// Takes that moment.
  void take(TimelineState& state) const;
  /// The next moments where a rate that is one number has them, each of one particle, up to that of another source; how
  /// many of the places are filled. `phase` has as many as `time`.
  std::size_t steady(const TimelineState& state, std::span<double> time, std::span<double> phase) const;
  /// Takes `count` of these.
  void take_steady(TimelineState& state, std::size_t count) const;
  /// When its first cycle begins and its last one ends, by the emitter's clock; infinite where it loops [s].
  [[nodiscard]] std::pair<double, double> span(std::uint64_t play) const;
  /// How far through its cycle an emitter is at a time of its clock, 0..1.
  [[nodiscard]] double phase_at(std::uint64_t play, double time) const;

 private:
  /// Finds the next moment of a source.
  void find(TimelineState& state, std::size_t source) const;

  const Emission& emission_;
};

}  // namespace physim
