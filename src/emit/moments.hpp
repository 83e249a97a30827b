// Moments: when an emitter's rate and bursts let particles out, counted from its first cycle.
//
// Symbols: D duration of a cycle; r rate; k number of a birth, from 0; c number of a cycle; x part of a cycle;
//   R(x) = D integral of the rate's curve from 0 to x, C = R(1); u a number between 0 and 1, drawn once a cycle where
//   the rate lies between two.
// Equations: constant rates: t = (k + 1) / r, one division. Curves: c = ceil((k + 1) / C) - 1 and R(x) = k + 1 - c C,
// so
//   that t = c D + x D is the first time at which k + 1 are through. Drawn ones: c is the first cycle with sum C >=
//   k + 1. Bursts: t = c D + time + j interval.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "emit/chance.hpp"
#include "emit/drawn.hpp"

namespace physim {

/// The cycle that a search for births has reached, if each cycle draws its own rate.
struct RateReached {
  std::uint64_t cycle = 0;
  double before = 0;  // births in the cycles before it

  bool operator==(const RateReached&) const = default;
};

class BirthRate {
 public:
  BirthRate(const EmitterDef& def, std::uint64_t seed);

  /// The time of birth k; infinite if it never comes. If the rate is drawn, births have to be taken in order: `reached`
  /// is what the one before left, and as new for the first one.
  [[nodiscard]] double time_of(std::uint64_t k, std::uint64_t play, RateReached& reached) const;
  /// Whether it is one number: then steady() gives the time by which `births` births are complete.
  [[nodiscard]] bool is_steady() const { return !silent_ && constant_ > 0; }
  [[nodiscard]] double steady(double births) const {
    PHYSIM_ASSERT(constant_ > 0);
    const double time = births / constant_;
    return looping_ || time <= duration_ ? time : std::numeric_limits<double>::infinity();
  }

 private:
  [[nodiscard]] double by_curve(double births) const;
  [[nodiscard]] double drawn(double births, std::uint64_t play, RateReached& reached) const;
  [[nodiscard]] double in_cycle(double x, double u) const;  // births from its start
  [[nodiscard]] double place_of(double births, double u) const;

  EmitNumber rate_;
  double duration_;
  bool looping_, silent_;
  std::uint64_t seed_;
  std::vector<double> knots_;  // 0, 1 and where a curve has a piece's end between them
  double constant_ = 0;        // the rate, where it is one
  double of_cycle_ = 0;        // births in a cycle, where it is not drawn
};

/// A burst: its moments, numbered from cycle to cycle.
class BurstMoments {
 public:
  BurstMoments(const EmitterDef& def, std::size_t burst, std::uint64_t seed);

  /// How many moments it has in all; those without end are more than can be counted.
  [[nodiscard]] std::uint64_t moments() const { return moments_; }
  [[nodiscard]] double time_of(std::uint64_t moment) const;
  [[nodiscard]] std::uint32_t count_of(std::uint64_t moment, std::uint64_t play) const;

 private:
  [[nodiscard]] double phase_of(std::uint64_t moment) const;
  /// Whether any moment of a cycle can let something out: a count that follows a curve may be nothing at all of them.
  [[nodiscard]] bool may_fire() const;

  EmitNumber count_;
  double time_, interval_, probability_, duration_;
  std::uint32_t index_;
  std::uint64_t seed_, per_cycle_, moments_;
};

/// How many moments of a burst lie in a cycle.
[[nodiscard]] double moments_in_cycle(const Burst& burst, double duration);

}  // namespace physim
