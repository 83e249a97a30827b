// A progress bar on stderr: only on a terminal, and only when the work takes longer than a second.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace physim::cli {

class Progress {
 public:
  /// `total` steps of work, described in a word or two.
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more step is done.
  void advance();

 private:
  using Clock = std::chrono::steady_clock;
  void draw();

  std::string label_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool enabled_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_draw_;
};

}  // namespace physim::cli
