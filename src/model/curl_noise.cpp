// Equations, symbols and Source: model/curl_noise.hpp.
#include "model/curl_noise.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

constexpr double kMeanSquare = 238536280.0 / 53414361.0;  // of one octave
constexpr double kTwoPi = 6.283185307179586;
constexpr double kFarthestCell = 1e15;  // beyond, places have no part of a cell any more

/// One round of pcg on a word.
constexpr std::uint32_t pcg(std::uint32_t word) {
  const std::uint32_t state = word * 747796405u + 2891336453u;
  const std::uint32_t mixed = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
  return mixed >> 22 ^ mixed;
}

/// A coordinate in its cell, and the weights of both ends of it with their derivatives.
struct Within {
  std::uint32_t cell;
  double offset[2];  // from the ends
  double weight[2], slope[2];

  explicit Within(double q) {
    const double floor = std::floor(q), u = q - floor;
    PHYSIM_ASSERT(u >= 0 && u <= 1);
    cell = static_cast<std::uint32_t>(static_cast<std::int64_t>(floor));
    const double fade = u * u * u * (u * (u * 6 - 15) + 10), rise = 30 * u * u * (u * (u - 2) + 1);
    offset[0] = u, offset[1] = u - 1;
    weight[0] = 1 - fade, weight[1] = fade;
    slope[0] = -rise, slope[1] = rise;
  }
};

/// What the parts of a gradient may be at a phase: by one bit for p and one for p'.
using Parts = std::array<double, 4>;

/// The curl of the potential at a place in cells.
Vec3d curl_at(std::uint32_t seed, const Vec3d& q, const Parts& parts) {
  const Within x(q.x), y(q.y), z(q.z);
  double yx = 0, zx = 0, xy = 0, zy = 0, xz = 0, yz = 0;  // dy of psi_x, dz of psi_x, ...
  for (unsigned k = 0; k < 2; ++k) {
    const std::uint32_t layer = pcg(z.cell + k + seed);
    for (unsigned j = 0; j < 2; ++j) {
      const std::uint32_t line = pcg(y.cell + j + layer);
      for (unsigned i = 0; i < 2; ++i) {
        std::uint32_t bits = pcg(x.cell + i + line) >> 8;  // of which 18 are taken
        const double side = y.weight[j] * z.weight[k], weight = x.weight[i] * side;
        const Vec3d rise{x.slope[i] * side, x.weight[i] * (y.slope[j] * z.weight[k]),
                         x.weight[i] * (y.weight[j] * z.slope[k])};
        const auto next = [&](Vec3d& g) {  // the next gradient, and how far its plane has risen here
          g = {parts[bits & 3], parts[bits >> 2 & 3], parts[bits >> 4 & 3]};
          bits >>= 6;
          return g.x * x.offset[i] + g.y * y.offset[j] + g.z * z.offset[k];
        };
        Vec3d g;
        const double of_x = next(g);
        yx += g.y * weight + rise.y * of_x, zx += g.z * weight + rise.z * of_x;
        const double of_y = next(g);
        xy += g.x * weight + rise.x * of_y, zy += g.z * weight + rise.z * of_y;
        const double of_z = next(g);
        xz += g.x * weight + rise.x * of_z, yz += g.y * weight + rise.y * of_z;
      }
    }
  }
  return {yz - zy, zx - xz, xy - yx};
}

}  // namespace

CurlNoise::CurlNoise(const std::array<std::uint32_t, kMostOctaves>& seeds, double size, double rate,
                     std::uint32_t octaves, double gain)
    : seeds_(seeds), per_size_(1 / size), rate_(rate), octaves_(octaves), gain_(gain), first_(1) {
  PHYSIM_ASSERT(size > 0 && octaves >= 1 && octaves <= kMostOctaves && gain >= 0);
  double sum = 0, strength = 1;
  for (std::uint32_t k = 0; k < octaves; ++k, strength *= gain) sum += strength * strength;
  first_ = 1 / std::sqrt(kMeanSquare * sum);
}

Vec3d CurlNoise::at(const Vec3d& x, double time) const {
  Vec3d sum{};
  double scale = per_size_, strength = first_, turns = rate_ * time;
  for (std::uint32_t k = 0; k < octaves_; ++k, scale *= 2, strength *= gain_, turns *= 2) {
    const Vec3d q = x * scale;
    if (!(std::abs(q.x) < kFarthestCell && std::abs(q.y) < kFarthestCell && std::abs(q.z) < kFarthestCell)) break;
    const double phase = kTwoPi * (turns - std::floor(turns)), c = cos(phase), s = sin(phase);
    sum += curl_at(seeds_[k], q, {c + s, c - s, s - c, -c - s}) * strength;
  }
  return sum;
}

}  // namespace physim
