// Timing: contenders take turns, so that whatever else the machine does falls on all of them alike.
#pragma once

#include <functional>
#include <vector>

namespace physim::bench {

enum class Clock {
  wall,  ///< steady_clock
  cpu,   ///< time this thread ran: for machines that do other work meanwhile
};

/// Seconds on a clock.
[[nodiscard]] double now(Clock clock);

/// Seconds of one call.
[[nodiscard]] double seconds(Clock clock, const std::function<void()>& call);

/// Seconds on the wall until two processes have both done a piece of work.
[[nodiscard]] double seconds_of_two(const std::function<void()>& work);

/// Calls every contender once a round; returns seconds[contender][round].
[[nodiscard]] std::vector<std::vector<double>> take_turns(Clock clock, int rounds,
                                                          const std::vector<std::function<void()>>& contenders);

[[nodiscard]] double smallest(const std::vector<double>& values);
[[nodiscard]] double median(std::vector<double> values);
/// Part of the values that lie below the result: 0.25 for the lower quartile.
[[nodiscard]] double quantile(std::vector<double> values, double part);
/// a[i] / b[i]
[[nodiscard]] std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace physim::bench
