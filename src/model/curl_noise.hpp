// Curl noise: a field of swirls that has no sources.
//
// What it models: eddies, by their looks: a smooth field with neither sources nor sinks of its vectors, so that
//   what drifts along neither gathers nor thins out. As an acceleration beside a drag k it drives particles towards the
//   velocity w / k, which is as free of sources.
// When it is wrong: it is no turbulence: its spectrum is that of its octaves, nothing carries its swirls along, and
// what
//   swirls does not feel particles. In planes through the corners of its cells its second derivatives jump.
// Symbols: x place in W [m]; t time [s]; s size of a cell [m]; q = x 2^k / s in octave k; f fade from corner to corner
//   [-]; r from a corner to q; p, p' gradients at a corner, each of their parts 1 or -1 by a hash of corner, octave and
//   seed [-]; a = 2 pi 2^k rate t phase [rad]; psi potential; g gain [-].
// Equations: psi_i = sum over the corners of a cell of f(|r_x|) f(|r_y|) f(|r_z|) (p_i cos a + p'_i sin a).r, with
//   1 - f = 6 u^5 - 15 u^4 + 10 u^3; w = sum over octaves of g^k curl psi, curl = (d psi_z/dy - d psi_y/dz, ...), over
//   the root of its mean square. That of one octave is 238536280 / 53414361: the integral over a cell of
//   2 sum (3 F^2 + 2 F r.grad F + r^2 (grad F)^2), F the product of the three f.
// Source: R. Bridson, J. Houriham, M. Nordenstam, "Curl-noise for procedural fluid flow", ACM Trans. Graphics 26 (2007)
//   46; K. Perlin, "Improving noise", ACM Trans. Graphics 21 (2002) 681 (fade); K. Perlin, F. Neyret, "Flow noise",
//   SIGGRAPH Technical Sketches (2001) (gradients that turn); M. Jarzynski, M. Olano, "Hash functions for GPU
//   rendering", J. Computer Graphics Techniques 9 (2020) 20 (pcg).
#pragma once

#include <array>
#include <cstdint>

#include "physim/math.hpp"

namespace physim {

class CurlNoise {
 public:
  static constexpr std::uint32_t kMostOctaves = 8;

  /// Swirls of `size` [m] that come again after 1 / rate [s], in `octaves` octaves, each `gain` times as strong as the
  /// one before and half its size; `seeds` of each.
  CurlNoise(const std::array<std::uint32_t, kMostOctaves>& seeds, double size, double rate, std::uint32_t octaves,
            double gain);

  /// At a place [m] and a time [s]; its mean square, over places, is 1. Zero where a place has no part of a cell in its
  /// digits any more.
  [[nodiscard]] Vec3d at(const Vec3d& x, double time) const;

 private:
  std::array<std::uint32_t, kMostOctaves> seeds_;
  double per_size_;  // of the first octave [1/m]
  double rate_;      // [1/s]
  std::uint32_t octaves_;
  double gain_;
  double first_;  // strength of the first octave
};

}  // namespace physim
