// The elevation of a zero, found by several flights.
#include "flight/zero.hpp"

#include <cmath>

#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/step_budget.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/minimum.hpp"
#include "math/root.hpp"
#include "model/sight.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"

namespace physim {
namespace {

/// The range at which a path comes down to the line of sight for the last time; 0 where it is never above it.
double reach_of(const Flight& flight) {
  constexpr int kParts = 4;  // of a step, which is long where little happens
  const auto drop = [&](double time) { return flight.at(time).drop; };
  const std::vector<double> times = flight.step_times();
  double reach = 0, before = 0, at_before = drop(0);
  for (std::size_t i = 1; i < times.size(); ++i)
    for (int part = 1; part <= kParts; ++part) {
      const double time = times[i - 1] + (times[i] - times[i - 1]) * part / kParts;
      const double at_time = drop(time);
      if (at_before > 0 && at_time <= 0)
        reach = flight.at(find_root(drop, before, at_before, time, at_time, 1e-13 * time)).range;
      before = time;
      at_before = at_time;
    }
  return at_before > 0 ? flight.end().range : reach;
}

/// What a shot that does not reach its zero range may lack: a speed, or the unit of its ballistic coefficient.
Error out_of_reach(const ProjectileDef& projectile, const Launch& launch, double range, double reach) {
  if (launch_speed(launch) == 0 && !has_motor(projectile))
    return Error{"is 0, and a zero range is given", "launch.speed", "give the muzzle speed"};
  const std::string message = "no elevation hits the line of sight at " + short_text(range) + " m" +
                              (reach > 0 ? "; it is hit up to " + short_text(std::round(reach)) + " m" : "");
  constexpr double kLightest = 10;  // of ballistic coefficients in use: 0.014 lb/in^2 [kg/m^2]
  const double bc = projectile.drag.ballistic_coefficient;
  if (bc > 0 && bc < kLightest)
    return Error{message, "projectile.drag.ballistic_coefficient",
                 "it is " + short_text(bc) + " kg/m^2, very little: is it in lb/in^2?"};
  return Error{message, "launch.sight.zero_range", "shorten the zero range or raise the speed"};
}

/// Shots at a zero range, judged by their height over the line of sight there.
class ZeroShots {
 public:
  ZeroShots(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
            const Fidelity& fidelity, double range)
      : projectile_(projectile), launch_(launch), air_(environment), exact_(fidelity), range_(range) {
    // A zero is shot upright; cant is what happens afterwards.
    launch_.sight.zero_range = launch_.sight.cant = 0;
    if (launch.sight.zero_in_calm_air) air_.wind = Wind{};
    exact_.precision = Precision::float64;
    exact_.rotation = RotationModel::none;
    if (exact_.motion != Motion::closed_form) exact_.integrator = Integrator::tsit5;
  }

  Result<double> zero() {
    const double look = launch_.sight.look_angle, at_look = drop(look);
    std::optional<double> found = zero_near(look, at_look);
    double reach = 0;
    if (!found && !error_ && at_look <= 0) {
      // Near the end of its reach a shot gets there between two of these steps only: around the elevation that carries
      // farthest along the line of sight.
      const auto shortfall = [&](double elevation) { return error_ ? 0.0 : -reach_of(flight_at(elevation)); };
      const double farthest = least_between(shortfall, look, kRightAngle);
      reach = -shortfall(farthest);
      const double at_farthest = drop(farthest);
      if (at_farthest > 0) found = root_between(look, at_look, farthest, at_farthest);
    }
    if (error_) return *error_;
    return found ? Result<double>(*found) : out_of_reach(projectile_, launch_, range_, reach);
  }

 private:
  Flight flight_at(double elevation) {
    launch_.elevation = elevation;
    Flight flight = fly(projectile_, launch_, air_, exact_, {}, {.ground = std::nullopt, .time = 600, .range = range_});
    if (flight.error()) error_ = flight.error();
    budget_.spend(flight);
    if (budget_.is_spent() && !error_) error_ = StepBudget::error("the zero");
    return flight;
  }
  /// A shot that never gets there counts as far below.
  double drop(double elevation) {
    if (error_) return -range_;
    const Flight flight = flight_at(elevation);
    return flight.outcome() == Outcome::reached_range ? flight.end().drop : -range_;
  }
  PHYSIM_COLD std::optional<double> root_between(double low, double at_low, double high, double at_high) {
    const auto at = [&](double elevation) { return drop(elevation); };
    const double elevation = find_root(at, low, at_low, high, at_high, 1e-13);
    // A jump of the height has no zero.
    return abs(drop(elevation)) < 1e-6 * range_ + 1e-6 ? std::optional(elevation) : std::nullopt;
  }
  /// Away from the line of sight, up where the shot lies low and down where it lies high, in growing steps.
  std::optional<double> zero_near(double look, double at_look) {
    constexpr double kSteepest = 0.7853981633974483;  // 45 degrees
    const double side = at_look <= 0 ? 1 : -1;
    double low = look, at_low = at_look;
    for (double angle = 0.002; angle < 2 * kSteepest && !error_; angle *= 2) {
      const double high = look + side * min(angle, kSteepest), at_high = drop(high);
      if ((at_high > 0) != (at_low > 0)) return root_between(low, at_low, high, at_high);
      low = high;
      at_low = at_high;
    }
    return std::nullopt;
  }

  const ProjectileDef& projectile_;
  Launch launch_;
  Environment air_;
  Fidelity exact_;
  double range_;
  std::optional<Error> error_;
  StepBudget budget_;
};

}  // namespace

PHYSIM_COLD Result<double> zero_elevation(const ProjectileDef& projectile, const Launch& launch,
                                          const Environment& environment, const Fidelity& fidelity, double range) {
  const IeeeMode mode;
  if (!(std::isfinite(range) && range > 0))
    return Error{"a zero range must be a positive number", "launch.sight.zero_range", "in m"};
  if (Status status = check(Tolerance{}, fidelity); !status) return status.error();
  return ZeroShots(projectile, launch, environment, fidelity, range).zero();
}

Result<double> elevation_of(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                            const Fidelity& fidelity) {
  if (launch.sight.zero_range <= 0) return launch.elevation;
  // Sights are zeroed on the level; rifle and sight are raised together afterwards.
  Launch level = launch;
  level.sight.look_angle = 0;
  const auto zeroed = zero_elevation(projectile, level, environment, fidelity, launch.sight.zero_range);
  if (!zeroed) return zeroed.error();
  return launch.sight.look_angle + *zeroed + launch.sight.dial;
}

double elevation_of(const Vec3d& velocity) {
  return atan2(velocity.y, sqrt(velocity.x * velocity.x + velocity.z * velocity.z));
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
