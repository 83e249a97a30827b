// Flights through a part of a step, side by side, if nothing happens on them.
//
// Settling takes any row through anything, and most of its cost is preparation. A row that is emitted in a step, or
// dies in it, mostly flies a part of it by one evaluation of forces, and meets nothing: that is the step that the
// kernel would take, shorter. Settling flies all others.
#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "world/step/settle.hpp"

namespace physim {

/// Flights of rows of one cohort, in the numbers of their rows.
template <class S>
struct FlownParts {
  static constexpr std::size_t kLanes = 32;
  using Column = std::array<S, kLanes>;

  std::size_t count = 0;               // lanes in use
  std::array<Column, 3> x, v;          // where they start; of closed forms, where they were launched
  Column length;                       // how long they fly from there, above 0 [s]
  std::array<Column, 3> push;          // that their emitter gives them where they start; read where rows are forced
  Column drag_rate;                    // of the drag in it
  std::array<Column, 3> end_x, end_v;  // where they get to
  std::uint32_t quiet = 0;             // a bit for each lane: nothing happens to it on its way
};

/// Numbers of a body, of which those that its cohort's rows hold are set.
template <class S>
using BodyNumbers = std::array<S, kNumbers<Body>>;

class PartFlights {
 public:
  /// Before rows are asked for: the step, its length or the cohorts may be others than before.
  void forget() { cohorts_.clear(); }
  /// True if rows of a cohort fly so.
  [[nodiscard]] bool knows(const SettleContext& context, std::uint16_t cohort) {
    return known(context, cohort).is_known();
  }
  /// Flies rows of a cohort that is known, all with the numbers of one body.
  template <class S>
  void fly(const SettleContext& context, std::uint16_t cohort, const BodyNumbers<S>& body, FlownParts<S>& parts) {
    PHYSIM_ASSERT(knows(context, cohort));
    const Cohort& by = known(context, cohort);
    std::get<Fly<S>>(by.fly)(by, *context.registry->cohort(cohort).course<S>().conditions, body, parts);
  }
  /// State of a row `until` into the step, from its start on, or from its birth in it; none: it has to be settled.
  [[nodiscard]] std::optional<State<double>> state_after(const SettleContext& context, std::uint16_t cohort,
                                                         std::uint32_t row, std::optional<double> born, double until);

 private:
  struct Cohort;
  template <class S>
  using Fly = void (*)(const Cohort& cohort, const Conditions<S>& c, const BodyNumbers<S>& body, FlownParts<S>& parts);
  struct Cohort {
    bool is_asked = false;
    std::tuple<Fly<float>, Fly<double>> fly{};  // that of its precision; null: not known
    double floor = 0;                           // as in Watchdog [m]
    double slowest = 0;                         // as in Watchdog [m/s]

    [[nodiscard]] bool is_known() const { return std::get<0>(fly) || std::get<1>(fly); }
  };
  Cohort& known(const SettleContext& context, std::uint16_t index) {
    return index < cohorts_.size() && cohorts_[index].is_asked ? cohorts_[index] : find(context, index);
  }
  Cohort& find(const SettleContext& context, std::uint16_t index);
  template <class S>
  static void find(const SettleContext& context, std::uint16_t index, Cohort& cohort);
  template <class Rung, class S>
  static void fly_parts(const Cohort& cohort, const Conditions<S>& c, const BodyNumbers<S>& body, FlownParts<S>& parts);
  template <class Rung, class R, class S>
  static void fly_lanes(const Cohort& cohort, const Conditions<S>& c, const BodyNumbers<S>& body, FlownParts<S>& parts);
  template <class S>
  std::optional<State<double>> fly_row(const SettleContext& context, std::uint16_t cohort, std::uint32_t row,
                                       std::optional<double> born, double until);

  std::vector<Cohort> cohorts_;
};

}  // namespace physim
