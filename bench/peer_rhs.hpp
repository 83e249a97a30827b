// The right-hand side that the peers integrate: the equations of src/model written as one scalar function.
#pragma once

#include <algorithm>
#include <cmath>

#include "peers.hpp"

namespace physim::bench {
namespace {

/// c[0] + c[1] x + ...: halves that do not wait for each other.
template <int N>
[[gnu::always_inline]] inline double peer_polynomial(const double* c, double x, double x2, double x4, double x8) {
  if constexpr (N == 1) return c[0];
  if constexpr (N == 2) return c[0] + c[1] * x;
  if constexpr (N > 2 && N <= 4)
    return peer_polynomial<2>(c, x, x2, x4, x8) + x2 * peer_polynomial<N - 2>(c + 2, x, x2, x4, x8);
  if constexpr (N > 4 && N <= 8)
    return peer_polynomial<4>(c, x, x2, x4, x8) + x4 * peer_polynomial<N - 4>(c + 4, x, x2, x4, x8);
  if constexpr (N > 8) return peer_polynomial<8>(c, x, x2, x4, x8) + x8 * peer_polynomial<N - 8>(c + 8, x, x2, x4, x8);
}

struct PeerAir {
  double density;
  double per_sound_speed;
};

inline PeerAir peer_layered_air(const PeerModel& m, double z) {
  const double h = m.geopotential_radius * z / (m.geopotential_radius + z);
  int layer = 0;
  while (layer + 1 < m.layers && h >= m.base[layer + 1]) ++layer;
  const double rise = h - m.base[layer];
  const double ratio = 1 + m.lapse[layer] * rise;
  return {m.base_density[layer] * std::exp(m.power[layer] * std::log(ratio) + m.decay[layer] * rise),
          m.base_per_sound_speed[layer] / std::sqrt(ratio)};
}

/// By the laws of the standard atmosphere, as its reader would write them, or by PhySim's polynomials for them.
enum class AirBy { polynomials, laws };

template <AirBy kAir>
[[gnu::always_inline]] inline PeerAir peer_air(const PeerModel& m, double z) {
  if (kAir == AirBy::polynomials && z <= m.top) {
    const double u = (z - m.middle) * m.scale;
    const double u2 = u * u;
    const double u4 = u2 * u2;
    const double u8 = u4 * u4;
    return {peer_polynomial<kPeerDensityTerms>(m.density, u, u2, u4, u8),
            peer_polynomial<kPeerSoundTerms>(m.per_sound_speed, u, u2, u4, u8)};
  }
  return peer_layered_air(m, z);
}

/// y = (x, y, z, vx, vy, vz)
template <AirBy kAir = AirBy::polynomials>
[[gnu::always_inline]] inline void peer_rhs(const PeerModel& m, const double* y, double* slope) {
  const PeerAir air = peer_air<kAir>(m, m.altitude + y[1]);
  const double speed = std::sqrt(y[3] * y[3] + y[4] * y[4] + y[5] * y[5]);
  const double place = speed * (air.per_sound_speed * m.cells_per_mach);
  const int cell = std::min(static_cast<int>(place), m.last_cell);
  const double t = std::min(place - cell, 1.0);
  const double* r = m.rows + 4 * cell;
  const double cd = (r[0] + t * r[1]) + (t * t) * (r[2] + t * r[3]);
  const double k = speed * -(air.density * m.half_area_per_mass) * cd;

  slope[0] = y[3];
  slope[1] = y[4];
  slope[2] = y[5];
  slope[3] = k * y[3];
  slope[4] = k * y[4] - m.gravity;
  slope[5] = k * y[5];
}

/// The state at the muzzle.
inline void peer_launch(const PeerShot& shot, double* y) {
  y[0] = y[1] = y[2] = y[5] = 0;
  y[3] = shot.speed * std::cos(shot.elevation);
  y[4] = shot.speed * std::sin(shot.elevation);
}

/// First step for the solvers that want one: the same for all shots, near what they settle at.
inline double peer_first_step(double tolerance) { return std::pow(tolerance, 0.2); }

}  // namespace
}  // namespace physim::bench
