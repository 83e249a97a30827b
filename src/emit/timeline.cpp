#include "emit/timeline.hpp"

#include <algorithm>
#include <cmath>

#include "emit/parts.hpp"

namespace physim {
namespace {

// Sources of an emitter: its rate, each burst, its gun.
constexpr std::size_t kRate = 0;

// A burst with this many empty moments in a row is over: waiting would not end. Below one chance in 1e6.
constexpr std::uint64_t kMostMissed = 20'000'000;

double delay_of(const EmitWhen& when, std::uint64_t seed, std::uint64_t play) {
  return when.delay.plain([=] { return open_unit(emit_words(seed, EmitStream::delay, 0, play, 0)[0]); });
}

/// The first moment of a burst, from `moment` on, that lets something out; `moment` becomes its number.
double next_burst(const BurstMoments& burst, std::uint64_t& moment, std::uint64_t play) {
  for (std::uint64_t missed = 0; missed < kMostMissed && moment < burst.moments(); ++missed, ++moment)
    if (burst.count_of(moment, play) > 0) return burst.time_of(moment);
  return kInfinity;
}

double next_round(const Gun& gun, const EmitterCycle& cycle, std::uint64_t round) {
  if (round >= gun.rounds()) return kInfinity;
  const double time = gun.time_of(round);
  return cycle.looping || time < cycle.duration ? time : kInfinity;
}

/// What stands before the point of a number that is not below 0: for any number the oldest processors call a function.
double whole_part(double x) { return x < 0x1p62 ? static_cast<double>(static_cast<std::int64_t>(x)) : x; }

/// How far through its cycle an emitter is, `since` seconds after the first one began.
double phase_of(const EmitterCycle& cycle, double since) {
  // A time that should be a cycle's start may lie before it by rounding.
  constexpr double kPhaseRounding = 4.5e-16;
  PHYSIM_ASSERT(since >= 0);
  const double cycles = cycle.looping ? whole_part(since / cycle.duration * (1 + kPhaseRounding)) : 0;
  return std::clamp((since - cycles * cycle.duration) / cycle.duration, 0.0, 1.0);
}

std::size_t first_of(const TimelineState& state) {
  PHYSIM_ASSERT(!state.at.empty() && state.at.size() == state.taken.size());
  return static_cast<std::size_t>(std::min_element(state.at.begin(), state.at.end()) - state.at.begin());
}

}  // namespace

TimelineState Timeline::begin(std::uint64_t play) const {
  const std::size_t sources = emission_.parts_->when.bursts.size() + 2;
  TimelineState state{.play = play, .taken = std::vector<std::uint64_t>(sources, 0)};
  state.at.resize(sources);
  for (std::size_t source = 0; source < sources; ++source) find(state, source);
  return state;
}

bool Timeline::is_of(const TimelineState& state) const {
  const auto& bursts = emission_.parts_->when.bursts;
  const std::size_t sources = bursts.size() + 2;
  if (state.taken.size() != sources || state.at.size() != sources || !std::isfinite(state.rate_before)) return false;
  for (std::size_t source = 0; source < sources; ++source) {
    if (!(state.at[source] >= 0)) return false;
    if (source == kRate || !std::isfinite(state.at[source])) continue;
    const std::uint64_t most = source <= bursts.size() ? bursts[source - 1].moments() : emission_.parts_->gun.rounds();
    if (state.taken[source] >= most) return false;
  }
  return true;
}

void Timeline::find(TimelineState& state, std::size_t source) const {
  const Emission::Parts& p = *emission_.parts_;
  const std::size_t gun = p.when.bursts.size() + 1;
  std::uint64_t& taken = state.taken[source];
  PHYSIM_ASSERT(source <= gun);
  double time = 0;
  if (source == kRate) {
    RateReached reached{state.rate_cycle, state.rate_before};
    time = p.when.rate.time_of(taken, state.play, reached);
    state.rate_cycle = reached.cycle, state.rate_before = reached.before;
  } else if (source == gun) {
    time = next_round(p.gun, p.def.cycle, taken);
  } else {
    time = next_burst(p.when.bursts[source - 1], taken, state.play);
  }
  state.at[source] = time;
}

std::optional<EmitMoment> Timeline::next(const TimelineState& state) const {
  const Emission::Parts& p = *emission_.parts_;
  const std::size_t source = first_of(state);
  const double since = state.at[source];
  if (!(since < kInfinity)) return std::nullopt;
  EmitMoment moment{.time = delay_of(p.when, p.seed, state.play) + since, .phase = phase_of(p.def.cycle, since)};
  if (source == p.when.bursts.size() + 1) {
    moment.is_round = true;
    moment.round = state.taken[source];
  } else if (source != kRate) {
    moment.count = p.when.bursts[source - 1].count_of(state.taken[source], state.play);
  }
  PHYSIM_ASSERT(moment.count > 0);
  return moment;
}

void Timeline::take(TimelineState& state) const {
  const std::size_t source = first_of(state);
  PHYSIM_ASSERT(state.at[source] < kInfinity);
  ++state.taken[source];
  find(state, source);
}

std::size_t Timeline::steady(const TimelineState& state, std::span<double> time, std::span<double> phase) const {
  PHYSIM_ASSERT(time.size() == phase.size());
  const Emission::Parts& p = *emission_.parts_;
  if (!p.when.rate.is_steady()) return 0;
  const double delay = delay_of(p.when, p.seed, state.play);
  const double other = *std::min_element(state.at.begin() + kRate + 1, state.at.end());
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double since = p.when.rate.steady(static_cast<double>(state.taken[kRate] + i) + 1);
    if (!(since < kInfinity) || since > other) return i;
    time[i] = delay + since, phase[i] = phase_of(p.def.cycle, since);
  }
  return time.size();
}

void Timeline::take_steady(TimelineState& state, std::size_t count) const {
  state.taken[kRate] += count;
  find(state, kRate);
}

std::pair<double, double> Timeline::span(std::uint64_t play) const {
  const Emission::Parts& p = *emission_.parts_;
  const double delay = delay_of(p.when, p.seed, play);
  return {delay, p.def.cycle.looping ? kInfinity : delay + p.def.cycle.duration};
}

double Timeline::phase_at(std::uint64_t play, double time) const {
  const Emission::Parts& p = *emission_.parts_;
  return phase_of(p.def.cycle, std::max(time - delay_of(p.when, p.seed, play), 0.0));
}

}  // namespace physim
