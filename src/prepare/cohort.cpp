// Step plans, and conditions pointed to their tables.
#include "prepare/cohort.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "prepare/conditions.hpp"

namespace physim {

template <class S>
StepPlan<S> prepare_plan(const Tolerance& tolerance, const Fidelity& granted, double step) {
  const bool adaptive = steps_itself(granted);
  const double most = sizeof(S) == 4 ? 16e6 : 9e15;    // whole numbers that S counts exactly
  const double least = sizeof(S) == 4 ? 2e-6 : 1e-15;  // some roundings
  const double own = granted.tolerance > 0 ? std::max(granted.tolerance, least) : sizeof(S) == 4 ? 2e-6 : 1e-9;
  const double relative = tolerance.relative.value_or(own);
  const double absolute = tolerance.absolute.value_or(tolerance.relative ? 1e-9 : std::min(1e-9, own));
  return {static_cast<S>(relative), static_cast<S>(absolute), static_cast<S>(adaptive ? 0 : step),
          static_cast<S>(std::min(tolerance.max_step, 1e30)),
          static_cast<S>(std::min(static_cast<double>(tolerance.max_steps), most))};
}
template StepPlan<float> prepare_plan<float>(const Tolerance&, const Fidelity&, double);
template StepPlan<double> prepare_plan<double>(const Tolerance&, const Fidelity&, double);

void Cohort::finish() {
  conditions.fidelity = in_use.fidelity;
  PHYSIM_ASSERT(!conditions.has_motor || !pool.motors.pieces().empty());
  PHYSIM_ASSERT(!conditions.has_magnus_tables || !pool.magnus.grids().empty());
  PHYSIM_ASSERT(!conditions.has_searched_curves || !pool.searched().empty());
  PHYSIM_ASSERT(!conditions.has_aero_tables || !pool.rows().empty());
  pool.point(conditions);
  if (in_use.fidelity.precision == Precision::float64) return;
  conditions_float = to_float(conditions);
  pool.point(conditions_float);
}

bool corners_matter(const Conditions<double>& c) {
  return c.fidelity.motion != Motion::closed_form && (c.has_rail || (steps_itself(c.fidelity) && has_corners(c)));
}

}  // namespace physim
