// The elevation of a zero, found by several flights.
#include "flight/zero.hpp"

#include <cmath>

#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/step_budget.hpp"
#include "math/elementary.hpp"
#include "math/root.hpp"
#include "model/sight.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"

namespace physim {
namespace {

/// What a shot that does not reach its zero range may lack: a speed, or the unit of its ballistic coefficient.
Error out_of_reach(const ProjectileDef& projectile, const Launch& launch, double range, double reached) {
  if (launch_speed(launch) == 0 && !has_motor(projectile))
    return Error{"is 0, and a zero range is given", "launch.speed", "give the muzzle speed"};
  const std::string message = "no elevation up to 45 degrees hits the line of sight at " + short_text(range) + " m; " +
                              short_text(std::round(reached)) + " m were reached";
  constexpr double kLightest = 10;  // of ballistic coefficients in use: 0.014 lb/in^2 [kg/m^2]
  const double bc = projectile.drag.ballistic_coefficient;
  if (bc > 0 && bc < kLightest)
    return Error{message, "projectile.drag.ballistic_coefficient",
                 "it is " + short_text(bc) + " kg/m^2, very little: is it in lb/in^2?"};
  return Error{message, "launch.sight.zero_range", "shorten the zero range or raise the speed"};
}

}  // namespace

Result<double> zero_elevation(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                              const Fidelity& fidelity, double range) {
  const IeeeMode mode;
  if (!(std::isfinite(range) && range > 0))
    return Error{"a zero range must be a positive number", "launch.sight.zero_range", "in m"};
  if (Status status = check(Tolerance{}, fidelity); !status) return status.error();
  Launch upright = launch;  // a zero is shot upright; cant is what happens afterwards
  upright.sight.zero_range = upright.sight.cant = 0;
  Environment air = environment;
  if (launch.sight.zero_in_calm_air) air.wind = Wind{};
  Fidelity exact = fidelity;
  exact.precision = Precision::float64;
  exact.rotation = RotationModel::none;
  if (exact.motion != Motion::closed_form) exact.integrator = Integrator::tsit5;
  const Until until{.ground = std::nullopt, .time = 600, .range = range};
  std::optional<Error> error;
  StepBudget budget;
  double reached = 0;
  // Height over the line of sight at the range; a shot that never gets there counts as far below.
  const auto drop = [&](double elevation) {
    if (budget.is_spent()) error = StepBudget::error("the zero");
    if (error) return -range;
    upright.elevation = elevation;
    const Flight flight = fly(projectile, upright, air, exact, {}, until);
    if (flight.error()) error = flight.error();
    budget.spend(flight);
    reached = max(reached, flight.end().range);
    return flight.outcome() == Outcome::reached_range ? flight.end().drop : -range;
  };
  const double look = launch.sight.look_angle;
  double low = look;
  double at_low = drop(low);
  // Away from the line of sight, up where the shot lies low and down where it lies high, in growing steps.
  const double side = at_low <= 0 ? 1 : -1;
  constexpr double kSteepest = 0.7853981633974483;  // 45 degrees
  for (double angle = 0.002; angle < 2 * kSteepest; angle *= 2) {
    if (error) return *error;
    const double high = look + side * min(angle, kSteepest);
    const double at_high = drop(high);
    if ((at_high > 0) != (at_low > 0)) {
      const double elevation = find_root(drop, low, at_low, high, at_high, 1e-13);
      const double off = drop(elevation);
      if (error) return *error;
      // Where the range is just out of reach the height jumps, and the end of a jump is no zero.
      return abs(off) < 1e-6 * range + 1e-6 ? Result<double>(elevation)
                                            : out_of_reach(projectile, launch, range, reached);
    }
    low = high;
    at_low = at_high;
  }
  return error ? *error : out_of_reach(projectile, launch, range, reached);
}

Result<double> elevation_of(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                            const Fidelity& fidelity) {
  if (launch.sight.zero_range <= 0) return launch.elevation;
  return zero_elevation(projectile, launch, environment, fidelity, launch.sight.zero_range);
}

Result<Launch> aimed_launch(const ProjectileDef& projectile, Launch launch, const Environment& environment,
                            const Fidelity& fidelity) {
  const auto elevation = elevation_of(projectile, launch, environment, fidelity);
  if (!elevation) return elevation.error();
  launch.elevation = *elevation;
  launch.sight.zero_range = 0;
  return launch;
}

}  // namespace physim
