// The way of an emitter that calls lead: straight legs from place to place, each to be done by a time of the world.
//
// Its place at a moment follows from the two ends of the leg that the moment lies on, and its distance from the lengths
// of the legs before, added up in their order. So what is emitted on a way does not depend on the steps that
// cut it.
//
// Symbols: a, b ends of a leg [m], s, t their times [s], d what was counted before the leg [m], u from when on metres
//   count [s].
// Equation: |b - a| (t - max(s, u)) / (t - s) metres count of a leg; a distance D >= d is reached at
//   max(s, u) + (D - d) (t - s) / |b - a|.
// Source: none; it is a steady velocity on a straight line.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "collide/path.hpp"

namespace physim {

class EmitterLead {
 public:
  /// No leg takes less time: its velocity would be a matter of rounding [s].
  static constexpr double kShortestLeg = 1e-6;

  [[nodiscard]] bool empty() const { return legs_.empty(); }
  /// Where, and when, the last leg ends; there is one.
  [[nodiscard]] const MotionKey& end() const { return legs_.back().to; }
  /// Adds a leg from the end of the last one; from `here` if it is the first.
  void go(const MotionKey& here, const MotionKey& to);
  /// Stands where the last leg ends from then on; a moment at which two legs meet belongs to the first of them.
  [[nodiscard]] MotionState at(double time) const;
  /// The time at which the distance is reached, if not after `latest`; `travelled` was counted before the first leg,
  /// metres count from a time on.
  [[nodiscard]] std::optional<double> when(double distance, double travelled, double counted_from, double latest) const;
  /// What counts of the legs up to now.
  [[nodiscard]] double counted(double counted_from, double now) const;
  /// Legs that are over by now go; what counts of them is added to `travelled`.
  void pass(double now, double counted_from, double& travelled);
  /// It goes no farther, and has no legs any more.
  void stop(double now, double counted_from, double& travelled);

  /// The beginning, and the ends of all legs; none where there is no leg. restore() is false where these are none.
  [[nodiscard]] std::vector<MotionKey> keys() const;
  [[nodiscard]] bool restore(std::span<const MotionKey> keys);
  [[nodiscard]] std::size_t bytes() const { return legs_.capacity() * sizeof(Leg); }

 private:
  struct Leg {
    MotionKey from, to;
    std::shared_ptr<const collide::Path> path;

    [[nodiscard]] double length() const;
    /// What counts of it up to a time.
    [[nodiscard]] double counted(double counted_from, double until) const;
  };
  std::vector<Leg> legs_;
};

}  // namespace physim
