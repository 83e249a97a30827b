// What the closed form of a cohort is evaluated with beside what stands in a row.
#pragma once

#include "world/core/registry.hpp"

namespace physim {

/// A row that changes its law, or stood still meanwhile, has to be launched again where it is: its launch
/// and its clock define where it would be had it flown by the new law from the start.
struct ClosedFormLaw {
  bool closed = false;  // else none of it is asked for
  bool still = false;   // clocks go on while a row stands still
  GravityModel gravity_model{};
  DragModel drag{};
  WindModel wind_model{};
  double gravity = 0;  // [m/s^2]
  Vec3d wind{};        // [m/s]

  explicit ClosedFormLaw(const WorldCohort& cohort) {
    const Fidelity& f = cohort.key.fidelity;
    if (f.motion != Motion::closed_form) return;
    closed = true;
    still = cohort.key.still;
    gravity_model = f.gravity;
    drag = f.drag;
    wind_model = f.wind;
    if (f.gravity != GravityModel::off) gravity = cohort.conditions.gravity;
    if (f.wind != WindModel::off) wind = cohort.conditions.wind.velocity;
  }

  bool operator==(const ClosedFormLaw&) const = default;
};

}  // namespace physim
