// Equations, symbols and Source: model/exit_spread.hpp.
#include "model/exit_spread.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/pack.hpp"
#include "math/philox.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

constexpr std::uint32_t kHitStream = 1;  // volleys draw from stream 0

}  // namespace

HitNumbers hit_numbers(std::uint64_t seed, std::uint32_t projectile, std::uint32_t hit) {
  const PhiloxKey key{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
  const PhiloxCounter bits = philox({projectile, hit, 0, kHitStream}, key);
  const auto angle = [](std::uint32_t u) { return std::sqrt(-2 * log(open_unit(u))); };
  return {{angle(bits[0]), angle(bits[2])}, {2 * kPi * open_unit(bits[1]), 2 * kPi * open_unit(bits[3])}};
}

Vec3d turned_off(const Vec3d& d, double angle, double about) {
  PHYSIM_ASSERT(!(abs(length_squared(d) - 1) > 1e-9));
  // The axis farthest from d makes the first vector across it.
  const double x = abs(d.x), y = abs(d.y), z = abs(d.z);
  const Vec3d axis = x <= y && x <= z ? Vec3d{1, 0, 0} : y <= z ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
  const Vec3d e1 = normalized(cross(axis, d)), e2 = cross(d, e1);
  const SinCos<double> off = sincos(angle), turn = sincos(about);
  return d * off.cos + (e1 * turn.cos + e2 * turn.sin) * off.sin;
}

}  // namespace physim
