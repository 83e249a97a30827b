// The simulation's clock.
#pragma once

#include <cstdint>

#include "base/assert.hpp"

namespace physim {

/// Time is counted in steps, so that it gathers no rounding errors while dt stays the same.
struct Clock {
  double dt = 0;                // of the last step [s]
  double run_start = 0;         // time at which steps of this dt began [s]
  std::uint64_t run_steps = 0;  // since then
  std::uint64_t steps = 0;      // ever
  std::uint64_t epoch = 0;      // step that rows count from
  double left_over = 0;         // of advance() [s]
  double time_scale = 1;
  bool paused = false;

  [[nodiscard]] double time() const { return run_start + static_cast<double>(run_steps) * dt; }
  /// What time() is after the coming step.
  [[nodiscard]] double next() const { return run_start + static_cast<double>(run_steps + 1) * dt; }
  /// The number of the coming step, as rows count.
  [[nodiscard]] double now() const {
    PHYSIM_ASSERT(steps >= epoch);
    return static_cast<double>(steps - epoch);
  }
  void tick() {
    ++steps;
    ++run_steps;
  }
  /// Rows count from now on.
  void start_epoch() { epoch = steps; }
  /// Steps have another length from now on.
  void start_run(double new_dt) {
    PHYSIM_ASSERT(new_dt > 0);
    run_start = time();
    run_steps = 0;
    dt = new_dt;
  }
};

}  // namespace physim
