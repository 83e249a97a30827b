// The ladder of fidelity for one shot: which rungs there are, how far each ends from the reference, and what it costs.
#pragma once

#include <string>
#include <vector>

#include "physim/flight.hpp"
#include "physim/result.hpp"
#include "physim/scenario.hpp"

namespace physim::cli {

enum class Family { preset, integrator, effect };
inline constexpr int kFamilies = 3;
[[nodiscard]] std::string_view family_name(Family family);

/// What the reference is flown with: the tightest tolerance that double precision can keep.
inline constexpr Tolerance kReferenceTolerance{.relative = 1e-15, .absolute = 1e-15};

/// One way to fly the shot.
struct Rung {
  Family family = Family::preset;
  std::string series;  // rungs that differ in step or tolerance only: "rk4"; the name itself where there is one
  std::string detail;  // "1/60 s", "1e-6"; may be empty
  Fidelity fidelity;
  Tolerance tolerance;
  [[nodiscard]] std::string name() const { return detail.empty() ? series : series + " " + detail; }
};

/// A rung flown. The last of them is the reference itself.
struct RungResult {
  Rung rung;
  Flight flight;
  std::string leaves_out;  // physics of the reference that this rung was not granted
  double error = 0;        // distance between the ends of this flight and the reference [m]
  double time_error = 0;   // difference of the times of flight [s]
  double cost = 0;         // of one fly(), median of several [s]
};

/// A rung that is not in the table, and why.
struct RungLeftOut {
  std::string name;
  std::string reason;
};

struct Ladder {
  std::string shot;
  std::vector<RungResult> rungs;  // presets from cheap to true, integrators by order, effects; then the reference
  std::vector<RungLeftOut> left_out;
};

/// Flies a shot of a scenario on every rung. All start with the reference's velocity, so that a zero range is found
/// once.
[[nodiscard]] Result<Ladder> climb(const Scenario& scenario, const ScenarioShot& shot);

}  // namespace physim::cli
