#include "scenario/volley.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/philox.hpp"
#include "model/sight.hpp"

namespace physim {
namespace {

/// Two numbers of a spread: normal with deviation 1, or even within the unit circle.
struct Pair {
  double first, second;
};

Pair pair_of(SpreadShape shape, std::uint32_t a, std::uint32_t b) {
  const double u = open_unit(a), turn = 2 * kPi * open_unit(b);
  // Box and Muller (1958) for normal numbers; equal areas of the circle for even ones. Our own functions: the same bits
  // everywhere.
  PHYSIM_ASSERT(u > 0);  // its logarithm is taken
  const double radius = shape == SpreadShape::normal ? std::sqrt(-2 * log(u)) : std::sqrt(u);
  return {radius * cos(turn), radius * sin(turn)};
}

double single_of(SpreadShape shape, std::uint32_t a, std::uint32_t b) {
  return shape == SpreadShape::normal ? pair_of(shape, a, b).first : 2 * open_unit(a) - 1;
}

/// A direction turned by two small or large angles: to the right, and upwards.
Vec3d turned(const Vec3d& direction, double right_angle, double up_angle) {
  const double angle = std::sqrt(right_angle * right_angle + up_angle * up_angle);
  if (angle == 0) return direction;
  const Vec3d across = cross(direction, Vec3d{0, 1, 0});
  const Vec3d right = length(across) > 1e-9 ? normalized(across) : Vec3d{0, 0, 1};
  const Vec3d up = cross(right, direction);
  return direction * cos(angle) + (right * right_angle + up * up_angle) * (sin(angle) / angle);
}

}  // namespace

Launch scattered(const Launch& launch, const Volley& volley, std::uint64_t index) {
  PHYSIM_ASSERT(launch.sight.zero_range <= 0);  // its bore is known
  const Spread& spread = volley.spread;
  if (spread == Spread{}) return launch;
  const auto seed = static_cast<std::uint64_t>(volley.seed);
  const PhiloxKey key = {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
  const auto low = static_cast<std::uint32_t>(index), high = static_cast<std::uint32_t>(index >> 32);
  const PhiloxCounter a = philox({low, high, 0, 0}, key), b = philox({low, high, 1, 0}, key);
  const PhiloxCounter c = philox({low, high, 2, 0}, key);
  const Pair angles = pair_of(spread.shape, a[0], a[1]);
  const double faster = spread.speed * single_of(spread.shape, a[2], a[3]);

  const Vec3d bore = launch_direction(launch, sight_frame(launch), launch.elevation);
  const Vec3d direction = turned(bore, spread.horizontal * angles.first, spread.vertical * angles.second);
  Launch out = launch;
  out.speed = 0;
  out.velocity = direction * std::max(0.0, length(velocity_along(launch, bore)) + faster);
  // What starts from rest points along its bore.
  out.elevation = asin(std::clamp(direction.y, -1.0, 1.0));
  out.azimuth = atan2(direction.z, direction.x);
  out.sight.cant = 0;
  out.position +=
      {spread.position.x * single_of(spread.shape, b[0], b[1]), spread.position.y * single_of(spread.shape, b[2], b[3]),
       spread.position.z * single_of(spread.shape, c[0], c[1])};
  return out;
}

}  // namespace physim
