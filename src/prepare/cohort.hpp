// Cohort: everything that flights of equal fidelity and environment share, ready to compute.
#pragma once

#include "model/table_pool.hpp"
#include "physim/flight.hpp"
#include "prepare/profile_tables.hpp"
#include "prepare/watch_list.hpp"
#include "solve/lanes.hpp"

namespace physim {

template <class S>
[[nodiscard]] StepPlan<S> prepare_plan(const Tolerance& tolerance, const Fidelity& granted, double step);

/// Whether steps must end at corners of what is piecewise.
[[nodiscard]] bool corners_matter(const Conditions<double>& conditions);

/// Bodies with the data they point to, in the cohort's precision.
struct Cohort {
  FidelityInUse in_use;
  TablePool pool;
  ProfileTables profiles;
  Conditions<double> conditions;
  Conditions<float> conditions_float;

  /// Points the conditions to the finished pool; call after all projectiles are prepared and after every move.
  void finish();

  template <class S>
  [[nodiscard]] const Conditions<S>& conditions_in() const {
    if constexpr (sizeof(S) == 4) return conditions_float;
    if constexpr (sizeof(S) == 8) return conditions;
  }
  template <class S>
  [[nodiscard]] Course<S> course(const Tolerance& tolerance, double step, const WatchList& watch) const {
    return course_with<S>(tolerance, step, [&]() -> const WatchList& { return watch; });
  }
  template <class S>
  [[nodiscard]] Course<S> course(const Tolerance& tolerance, double step, const Until& until, Watcher watcher) const {
    return course_with<S>(tolerance, step, [&] { return prepare_watch(until, conditions, watcher); });
  }

 private:
  /// The list of what is watched is large: it is made where it stays.
  template <class S>
  [[nodiscard]] Course<S> course_with(const Tolerance& tolerance, double step, const auto& watch) const {
    PHYSIM_ASSERT(conditions.curve_rows == pool.rows().data());  // finish() came after the last addition and move
    return {&conditions_in<S>(),
            &conditions,
            parts_flown(in_use.fidelity, conditions).runs(),
            prepare_plan<S>(tolerance, in_use.fidelity, step),
            watch(),
            corners_matter(conditions)};
  }
};

}  // namespace physim
