// Known flights: a part of a step of rows on rungs that kernels know at compile time, if nothing happens to them.
//
// Settling takes any row through anything, and most of its cost is preparation. A row that is emitted in a step, or
// dies in it, mostly flies a part of it on one of the rungs that games use most, and meets nothing: that is the
// one step that the kernel would take, shorter. Settling flies all others.
#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "world/step/settle.hpp"

namespace physim {

/// Newborns of one kind and rung side by side, in the numbers of their rows.
template <class S>
struct NewbornFlights {
  static constexpr std::size_t kLanes = 32;
  using Column = std::array<S, kLanes>;

  std::size_t count = 0;               // lanes in use
  std::array<Column, 3> x, v;          // where they start
  Column length;                       // how long they fly, above 0 [s]
  std::array<Column, 3> push;          // that their emitter gives them where they start; read where rows are forced
  Column drag_rate;                    // of the drag in it
  std::array<Column, 3> end_x, end_v;  // where they get to
  std::uint32_t known = 0;             // a bit for each lane: nothing happens to it on its way
};

class KnownFlights {
 public:
  /// Before rows are asked for: the step, its length or the cohorts may be others than before.
  void forget() { cohorts_.clear(); }
  /// Where a row is `until` into the step, from its start on, or from its birth in it; none: it has to
  /// be settled.
  [[nodiscard]] std::optional<State<double>> state_after(const SettleContext& context, std::uint16_t cohort,
                                                         std::uint32_t row, std::optional<double> born, double until);
  /// Whether newborns of a cohort fly side by side.
  [[nodiscard]] bool knows(const SettleContext& context, std::uint16_t cohort) {
    return find(context, cohort).fly != nullptr;
  }
  /// Flies newborns of a cohort that is known; `body` is that of their kind and rung.
  template <class S>
  void fly(const SettleContext& context, std::uint16_t cohort, const Body<double>& body, NewbornFlights<S>& newborns) {
    const Cohort& known = find(context, cohort);
    PHYSIM_ASSERT(known.fly);
    std::get<FlyEach<S>>(known.fly_each)(known, context, cohort, body, newborns);
  }

 private:
  struct Cohort;
  /// A part of a step of a row.
  struct Part {
    std::uint16_t cohort;
    std::uint32_t row;
    std::optional<double> born;
    double until;
  };
  using Fly = std::optional<State<double>> (*)(const Cohort& cohort, const SettleContext& context, const Part& part);
  template <class S>
  using FlyEach = void (*)(const Cohort& cohort, const SettleContext& context, std::uint16_t index,
                           const Body<double>& body, NewbornFlights<S>& newborns);
  struct Cohort {
    bool is_asked = false;
    Fly fly = nullptr;  // null: not a known one
    std::tuple<FlyEach<float>, FlyEach<double>> fly_each{};
    double floor = 0;    // as in Watchdog [m]
    double slowest = 0;  // as in Watchdog [m/s]
  };
  Cohort& find(const SettleContext& context, std::uint16_t index);
  template <class S>
  static void find(const SettleContext& context, std::uint16_t index, Cohort& cohort);
  template <class Rung, class S>
  static std::optional<State<double>> fly_alone(const Cohort& cohort, const SettleContext& context, const Part& part);
  template <class Rung, class S>
  static void fly_together(const Cohort& cohort, const SettleContext& context, std::uint16_t index,
                           const Body<double>& body, NewbornFlights<S>& newborns);

  std::vector<Cohort> cohorts_;
};

}  // namespace physim
