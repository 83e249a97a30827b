// Equations and symbols: emit/moments.hpp.
#include "emit/moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/elementary.hpp"
#include "math/interpolation.hpp"
#include "math/root.hpp"

namespace physim {
namespace {

constexpr std::uint64_t kEndless = std::numeric_limits<std::uint64_t>::max();
// A sum of rates that should be a whole number misses it by rounding: what lacks so little of a birth has it.
constexpr double kBirthRounding = 1e-12;
constexpr std::uint64_t kMostCycles = 100'000'000;  // searched for a birth, where check() lets nothing come near it

}  // namespace

// ------------------------------------------------------------------------------------------------- rates
BirthRate::BirthRate(const EmitterDef& def, std::uint64_t seed)
    : rate_(def.per_second), duration_(def.cycle.duration), looping_(def.cycle.looping), seed_(seed) {
  silent_ = !(range_of(def.per_second).most > 0);
  if (rate_.is_constant()) constant_ = def.per_second.value;
  if (!rate_.is_drawn()) of_cycle_ = in_cycle(1, 0);
  knots_ = {0, 1};
  for (const EmitCurve* curve : {&rate_.curve(), &rate_.to_curve()})
    for (const double x : curve->knots())
      if (x < 1) knots_.push_back(x);
  knots_ = rising(std::move(knots_));
  PHYSIM_ASSERT(duration_ > 0 && knots_.front() == 0 && knots_.back() == 1);
}

double BirthRate::time_of(std::uint64_t k, std::uint64_t play, RateReached& reached) const {
  if (silent_) return kInfinity;
  const double births = static_cast<double>(k) + 1;
  if (constant_ > 0) return steady(births);
  return rate_.is_drawn() ? drawn(births, play, reached) : by_curve(births);
}

double BirthRate::by_curve(double births) const {
  if (!(of_cycle_ > 0)) return kInfinity;
  const double cycle = std::max(0.0, std::ceil(births / of_cycle_ * (1 - kBirthRounding)) - 1);
  if (!looping_ && cycle > 0) return kInfinity;
  const HiLo<double> before = two_product(cycle, of_cycle_);
  return cycle * duration_ + place_of((births - before.hi) - before.lo, 0) * duration_;
}

double BirthRate::drawn(double births, std::uint64_t play, RateReached& reached) const {
  for (std::uint64_t i = 0; i < kMostCycles; ++i) {
    const double u = open_unit(emit_words(seed_, EmitStream::rate, 0, reached.cycle, play)[0]);
    const double of_cycle = in_cycle(1, u), wanted = births - reached.before;
    PHYSIM_ASSERT(of_cycle >= 0);
    if (wanted <= of_cycle + kBirthRounding * births)
      return static_cast<double>(reached.cycle) * duration_ + place_of(wanted, u) * duration_;
    if (!looping_) return kInfinity;
    ++reached.cycle;
    reached.before += of_cycle;
  }
  return kInfinity;
}

double BirthRate::in_cycle(double x, double u) const {
  return duration_ * rate_.integral(x, [u] { return u; });
}

/// The first place in a cycle by which `births` births are done: between two knots, where the integral is one cubic or
/// the sum of two and rises.
double BirthRate::place_of(double births, double u) const {
  const double enough = births * (1 - kBirthRounding);
  const auto end = std::lower_bound(knots_.begin() + 1, knots_.end() - 1, enough,
                                    [&](double x, double sum) { return in_cycle(x, u) < sum; });
  const double a = *(end - 1), b = *end;
  const auto lacking = [&](double x) { return in_cycle(x, u) - births; };
  const double x = find_root(lacking, a, lacking(a), b, lacking(b), 0);
  PHYSIM_ASSERT(x >= 0 && x <= 1);
  return x;
}

// ------------------------------------------------------------------------------------------------- bursts
double moments_in_cycle(const Burst& burst, double duration) {
  if (!(burst.time < duration)) return 0;
  const double most = burst.cycles == 0 ? kInfinity : burst.cycles;
  if (burst.interval == 0) return most;
  // The quotient may be off by one either way.
  double n = std::floor((duration - burst.time) / burst.interval);
  if (!(n < 9e15)) return std::min(most, 9e15);  // beyond it whole numbers are not counted any more
  while (n > 0 && !(burst.time + (n - 1) * burst.interval < duration)) --n;
  while (n < most && burst.time + n * burst.interval < duration && n < 9e15) ++n;
  return std::min(n, most);
}

BurstMoments::BurstMoments(const EmitterDef& def, std::size_t burst, std::uint64_t seed)
    : count_(def.bursts[burst].count),
      time_(def.bursts[burst].time),
      interval_(def.bursts[burst].interval),
      probability_(def.bursts[burst].probability),
      duration_(def.cycle.duration),
      index_(static_cast<std::uint32_t>(burst)),
      seed_(seed) {
  const double in_cycle = moments_in_cycle(def.bursts[burst], duration_);
  PHYSIM_ASSERT(in_cycle >= 0 && in_cycle < 1e18);
  per_cycle_ = static_cast<std::uint64_t>(in_cycle);
  const bool never = probability_ == 0 || range_of(def.bursts[burst].count).most < 0.5;
  if (never || !may_fire()) per_cycle_ = 0;
  moments_ = def.cycle.looping && per_cycle_ > 0 ? kEndless : per_cycle_;
}

double BurstMoments::time_of(std::uint64_t moment) const {
  PHYSIM_ASSERT(moment < moments_ && per_cycle_ > 0);
  const double into = time_ + static_cast<double>(moment % per_cycle_) * interval_;
  return static_cast<double>(moment / per_cycle_) * duration_ + into;
}

double BurstMoments::phase_of(std::uint64_t moment) const {
  return (time_ + static_cast<double>(moment % per_cycle_) * interval_) / duration_;
}

bool BurstMoments::may_fire() const {
  constexpr std::uint64_t kFew = 4096;  // more are not looked at beforehand
  if (per_cycle_ > kFew) return true;
  for (std::uint64_t moment = 0; moment < per_cycle_; ++moment) {
    const double x = phase_of(moment);
    const double most = std::max(count_.at(x, [] { return 0.0; }), count_.at(x, [] { return 1.0; }));
    if (whole_count(most) > 0) return true;
  }
  return false;
}

std::uint32_t BurstMoments::count_of(std::uint64_t moment, std::uint64_t play) const {
  PHYSIM_ASSERT(moment < moments_ && per_cycle_ > 0);
  const bool sure = probability_ == 1;
  PhiloxCounter words{};
  if (!sure || count_.is_drawn()) words = emit_words(seed_, EmitStream::burst, index_, moment, play);
  if (!sure && open_unit(words[0]) >= probability_) return 0;
  return whole_count(count_.at(phase_of(moment), [&words] { return open_unit(words[1]); }));
}

}  // namespace physim
