// Known flights: a part of a step of one row whose rung kernels know at compile time, where nothing happens to it.
//
// Settling takes any row through anything, and most of what it costs is getting ready. Who is born in a step, or whose
// life ends in it, mostly flies a part of it on one of the rungs that games use most, and meets nothing: that is the
// one step that the kernel would take, shorter. Settling flies all others.
#pragma once

#include <optional>
#include <vector>

#include "world/settle.hpp"

namespace physim {

class KnownFlights {
 public:
  /// Before rows are asked for: the step, its length or the cohorts may be others than before.
  void forget() { cohorts_.clear(); }
  /// Where a row is that flies so long from where it is now on; none: it wants to be settled.
  [[nodiscard]] std::optional<State<double>> state_after(const SettleContext& context, std::uint16_t cohort,
                                                         std::uint32_t row, double length);

 private:
  struct Cohort {
    bool is_asked = false;
    std::optional<State<double>> (*fly)(const Cohort& cohort, const SettleContext& context, std::uint16_t index,
                                        std::uint32_t row, double length) = nullptr;  // null: not a known one
    double floor = 0;                                                                 // as Watchdog tells it [m]
    double slowest = 0;                                                               // likewise [m/s]
  };
  template <class S>
  static void find(const SettleContext& context, std::uint16_t index, Cohort& cohort);
  template <class Rung, class S>
  static std::optional<State<double>> fly(const Cohort& cohort, const SettleContext& context, std::uint16_t index,
                                          std::uint32_t row, double length);

  std::vector<Cohort> cohorts_;
};

}  // namespace physim
