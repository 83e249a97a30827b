#include "timing.hpp"

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace physim::bench {

double now(Clock clock) {
#ifdef CLOCK_THREAD_CPUTIME_ID
  if (clock == Clock::cpu) {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
#else
  (void)clock;
#endif
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double seconds(Clock clock, const std::function<void()>& call) {
  const double start = now(clock);
  call();
  return now(clock) - start;
}

double seconds_of_two(const std::function<void()>& work) {
  return seconds(Clock::wall, [&] {
    for (int i = 0; i < 2; ++i)
      if (fork() == 0) {
        work();
        std::_Exit(0);
      }
    while (wait(nullptr) > 0) {
    }
  });
}

std::vector<std::vector<double>> take_turns(Clock clock, int rounds,
                                            const std::vector<std::function<void()>>& contenders) {
  std::vector<std::vector<double>> times(contenders.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contenders.size(); ++i) times[i].push_back(seconds(clock, contenders[i]));
  return times;
}

double smallest(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> r;
  for (std::size_t i = 0; i < a.size(); ++i) r.push_back(a[i] / b[i]);
  return r;
}

}  // namespace physim::bench
