// Trajectories as samples: which times, which numbers, and the files of them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "physim/result.hpp"
#include "report/flown.hpp"
#include "report/picture.hpp"
#include "report/records.hpp"

namespace physim::report {

inline constexpr std::size_t kMaxSamples = 1'000'000;  // of all shots of a file together

/// The numbers of one row, in the order of the columns.
inline constexpr std::array<std::string_view, 14> kSampleColumns = {
    "t [s]",      "x [m]",      "y [m]",      "z [m]",       "vx [m/s]", "vy [m/s]",  "vz [m/s]",
    "ax [m/s^2]", "ay [m/s^2]", "az [m/s^2]", "speed [m/s]", "mach [-]", "mass [kg]", "thrust [N]"};
using SampleRow = std::array<double, kSampleColumns.size()>;
[[nodiscard]] SampleRow row_of(const Sample& sample);
/// Behind them, where jerk is asked for.
inline constexpr std::array<std::string_view, 3> kJerkColumns = {"jx [m/s^3]", "jy [m/s^3]", "jz [m/s^3]"};

/// Times of samples in their order. A time that stands twice is one at which the state jumps, as at a bounce: the first
/// of the two samples is the state before it, the second the state behind it.
using Times = std::vector<double>;
using SampleTimes = std::vector<Times>;

/// True if the path or a derivative of it may be discontinuous at an event of a kind; a crossing of a value is smooth.
[[nodiscard]] bool may_break_path(EventKind kind);
/// The times at which the path of a flight may break, in order [s].
[[nodiscard]] Times breaks_of(const Flight& flight);
/// The times with those of all events in which the path may break, so that no corner is cut. Times that lie close to
/// such an event give way to it.
[[nodiscard]] Times with_breaks(const Flight& flight, const Times& times);
/// The sample at times[i].
[[nodiscard]] Sample sample_at(const Flight& flight, std::span<const double> times, std::size_t i);

/// Times of the samples of each shot: every multiple of the interval [s], every break of the path, and the end. Without
/// an interval each shot has a round one that gives 200 to 500 samples. An error with the place "interval" if there
/// would be too many.
[[nodiscard]] Result<SampleTimes> sample_times(const std::vector<FlownShot>& shots, std::optional<double> interval);

/// Flights, and when each is sampled.
struct Flights {
  const FlownScenario& flown;
  const SampleTimes& times;
  bool with_jerk = false;
};

/// A row for each sample of each shot.
[[nodiscard]] Records records_of(const Flights& flights);
[[nodiscard]] Content flights_json(const Flights& flights);

}  // namespace physim::report
