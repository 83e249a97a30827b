// Thinning: which samples of a path are kept, for trails, plots and files alike. Straight lines in time between those
// that are kept stay within a small part of what each quantity spans.
#pragma once

#include <vector>

#include "simclient/core/track.hpp"

namespace physim::client {

/// How far a line between kept samples may be from the path, in parts of the diagonal of the box about the path; and
/// from another quantity, in parts of what that spans.
inline constexpr double kPlaceError = 5e-5, kQuantityError = 5e-4;

/// Samples that a track keeps as they come, before those behind are thinned out.
inline constexpr std::size_t kFreshSamples = 2048;

/// Removes samples behind number `from` that lines between the others show. The first and the last stay. `coarseness`:
/// errors may be so many times as large.
void thin_out(std::vector<TrackSample>& samples, std::size_t from, double coarseness = 1);

/// Adds a sample to a track. Each part of a path is thinned once, so that errors do not add up; a path that has too
/// many corners for that is thinned again, twice as coarsely.
void add_sample(Track& track, const TrackSample& sample);
/// Adds a sample to a track if it is later than the last one.
void add_later(Track& track, const TrackSample& sample);

/// A flight from its start to its end: at least 800 intervals, finer where lines would leave the path, and with all of
/// its corners. `rounds`: how often an interval is halved at most.
[[nodiscard]] std::vector<TrackSample> samples_of(const Flight& flight, int rounds = 10);

}  // namespace physim::client
