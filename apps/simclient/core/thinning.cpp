#include "simclient/core/thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/assert.hpp"
#include "report/trajectory.hpp"

namespace physim::client {
namespace {

constexpr std::size_t kMostSamples = 16384;  // of a track
constexpr std::size_t kPlaces = 3;           // the first quantities are the place

/// The quantities of a sample.
using Quantities = std::array<double, 14>;
Quantities quantities_of(const TrackSample& s) {
  return {s.position.x,     s.position.y,     s.position.z, s.velocity.x, s.velocity.y, s.velocity.z, s.acceleration.x,
          s.acceleration.y, s.acceleration.z, s.mach,       s.mass,       s.jerk.x,     s.jerk.y,     s.jerk.z};
}

/// How far each quantity may be off.
Quantities tolerances_of(const std::vector<TrackSample>& samples) {
  Quantities low, high, tolerances;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const TrackSample& sample : samples) {
    const Quantities q = quantities_of(sample);
    for (std::size_t i = 0; i < q.size(); ++i) low[i] = std::min(low[i], q[i]), high[i] = std::max(high[i], q[i]);
  }
  const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  const double of_axis = kPlaceError * diagonal / std::sqrt(3.0);
  for (std::size_t i = 0; i < low.size(); ++i) {
    const double rounding = 1e-12 * std::max(std::abs(low[i]), std::abs(high[i]));
    tolerances[i] = std::max(i < kPlaces ? of_axis : kQuantityError * (high[i] - low[i]), rounding);
  }
  return tolerances;
}

/// The lines from one sample that pass near all samples looked at since.
class Fan {
 public:
  Fan(const TrackSample& from, const Quantities& tolerances)
      : time_(from.time), from_(quantities_of(from)), tolerances_(tolerances) {
    low_.fill(-std::numeric_limits<double>::infinity());
    high_.fill(std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] bool holds(const TrackSample& to) const {
    const Quantities slopes = slopes_to(to, 0);
    for (std::size_t i = 0; i < slopes.size(); ++i)
      if (!(slopes[i] >= low_[i] && slopes[i] <= high_[i])) return false;
    return true;
  }
  void narrow(const TrackSample& by) {
    const Quantities below = slopes_to(by, -1), above = slopes_to(by, 1);
    for (std::size_t i = 0; i < below.size(); ++i)
      low_[i] = std::max(low_[i], below[i]), high_[i] = std::min(high_[i], above[i]);
  }

 private:
  [[nodiscard]] Quantities slopes_to(const TrackSample& to, double side) const {
    const double per_second = 1 / std::max(to.time - time_, 1e-300);
    Quantities slopes = quantities_of(to);
    for (std::size_t i = 0; i < slopes.size(); ++i)
      slopes[i] = (slopes[i] + side * tolerances_[i] - from_[i]) * per_second;
    return slopes;
  }

  double time_;
  Quantities from_, tolerances_, low_, high_;
};

bool are_near(const TrackSample& a, const TrackSample& b, const Quantities& tolerances) {
  const Quantities x = quantities_of(a), y = quantities_of(b);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!(std::abs(x[i] - y[i]) <= tolerances[i])) return false;
  return true;
}

/// Adds the middle of each interval that a line does not show; false if there is none.
bool refine(const Flight& flight, std::vector<TrackSample>& samples) {
  const Quantities tolerances = tolerances_of(samples);
  const double shortest = flight.duration() * 1e-6;
  std::vector<TrackSample> finer = {samples.front()};
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const TrackSample line = between(samples[i - 1], samples[i], 0.5);
    if (samples[i].time - samples[i - 1].time > shortest) {
      const TrackSample flown = sample_of(flight, line.time);
      if (!are_near(line, flown, tolerances)) finer.push_back(flown);
    }
    finer.push_back(samples[i]);
  }
  const bool has_changed = finer.size() > samples.size();
  samples = std::move(finer);
  return has_changed;
}

}  // namespace

void thin_out(std::vector<TrackSample>& samples, std::size_t from, double coarseness) {
  PHYSIM_ASSERT(from < samples.size() && coarseness >= 1);
  if (samples.size() - from < 3) return;
  Quantities tolerances = tolerances_of(samples);
  for (double& each : tolerances) each *= coarseness;
  std::size_t kept = from;
  Fan fan(samples[kept], tolerances);
  fan.narrow(samples[from + 1]);
  for (std::size_t i = from + 2; i < samples.size(); ++i) {
    if (!fan.holds(samples[i])) {
      samples[++kept] = samples[i - 1];
      fan = Fan(samples[kept], tolerances);
    }
    fan.narrow(samples[i]);
  }
  samples[++kept] = samples.back();
  samples.resize(kept + 1);
}

void add_sample(Track& track, const TrackSample& sample) {
  std::vector<TrackSample>& samples = track.samples;
  samples.push_back(sample);
  if (samples.size() - track.thinned <= kFreshSamples) return;
  thin_out(samples, track.thinned, track.coarseness);
  if (samples.size() > kMostSamples) thin_out(samples, 0, track.coarseness *= 2);
  track.thinned = samples.size() - 1;
}

void add_later(Track& track, const TrackSample& sample) {
  constexpr double kInstant = 1e-9;  // times nearer than this are the same [s]
  if (sample.time > track.samples.back().time + kInstant) add_sample(track, sample);
}

std::vector<TrackSample> samples_of(const Flight& flight, int rounds) {
  constexpr int kIntervals = 800;
  report::Times times;
  for (int i = 0; i <= kIntervals; ++i) times.push_back(flight.duration() * i / kIntervals);
  std::vector<TrackSample> samples;
  double last = -1;
  for (const double time : report::with_breaks(flight, times)) {
    if (time <= last) continue;  // the state behind a jump follows in the next sample
    samples.push_back(sample_of(flight, time));
    last = time;
  }
  for (int i = 0; i < rounds && samples.size() < kMostSamples; ++i)
    if (!refine(flight, samples)) break;
  return samples;
}

}  // namespace physim::client
