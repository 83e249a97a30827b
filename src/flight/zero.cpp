// The elevation of a zero, found by several flights.
#include "flight/zero.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "math/elementary.hpp"
#include "math/root.hpp"
#include "model/sight.hpp"

namespace physim {
namespace {

/// Height over the line of sight at a range for a bore elevation; a shot that never gets there counts as far below.
class ZeroFlights {
 public:
  ZeroFlights(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
              const Fidelity& fidelity, double range)
      : projectile_(projectile), launch_(launch), environment_(environment), fidelity_(fidelity), range_(range) {
    launch_.sight.zero_range = 0;
    launch_.sight.cant = 0;  // a zero is shot upright; cant is what happens afterwards
    if (launch_.sight.zero_in_calm_air) environment_.wind = Wind{};
    fidelity_.precision = Precision::float64;
    fidelity_.rotation = RotationModel::none;
    if (fidelity_.motion != Motion::closed_form) fidelity_.integrator = Integrator::tsit5;
    until_.ground.reset();
    until_.range = range;
    until_.time = 600;
  }

  double above_sight(double elevation) {
    launch_.elevation = elevation;
    const Flight flight = fly(projectile_, launch_, environment_, fidelity_, {}, until_);
    if (flight.error()) error_ = flight.error();
    return flight.outcome() == Outcome::reached_range ? flight.end().drop : -range_;
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  ProjectileDef projectile_;
  Launch launch_;
  Environment environment_;
  Fidelity fidelity_;
  double range_;
  Until until_;
  std::optional<Error> error_;
};

Error out_of_reach(double range) {
  return Error{"no elevation up to 45 degrees hits the line of sight at " + short_text(range) + " m",
               "launch.sight.zero_range", "shorten the zero range or raise the speed"};
}

}  // namespace

Result<double> zero_elevation(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                              const Fidelity& fidelity, double range) {
  if (!(std::isfinite(range) && range > 0))
    return Error{"a zero range must be a positive number", "launch.sight.zero_range", "in m"};
  ZeroFlights flights(projectile, launch, environment, fidelity, range);
  const double look = launch.sight.look_angle;
  const auto drop = [&](double elevation) { return flights.above_sight(elevation); };
  double low = look;
  double at_low = drop(low);
  // Away from the line of sight, up where the shot lies low and down where it lies high, in growing steps.
  const double side = at_low <= 0 ? 1 : -1;
  constexpr double kSteepest = 0.7853981633974483;  // 45 degrees
  for (double angle = 0.002; angle < 2 * kSteepest; angle *= 2) {
    if (flights.error()) return *flights.error();
    const double high = look + side * min(angle, kSteepest);
    const double at_high = drop(high);
    if ((at_high > 0) != (at_low > 0)) {
      const double elevation = find_root(drop, low, at_low, high, at_high, 1e-13);
      // Where the range is just out of reach the height jumps, and the end of a jump is no zero.
      return abs(drop(elevation)) < 1e-6 * range + 1e-6 ? Result<double>(elevation) : out_of_reach(range);
    }
    low = high;
    at_low = at_high;
  }
  return flights.error() ? *flights.error() : out_of_reach(range);
}

Result<double> elevation_of(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                            const Fidelity& fidelity) {
  if (launch.sight.zero_range <= 0) return launch.elevation;
  return zero_elevation(projectile, launch, environment, fidelity, launch.sight.zero_range);
}

}  // namespace physim
