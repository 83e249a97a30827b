// EmitShape: where in its shape a particle comes out, and in which direction.
//
// Symbols: x axis of the shape, forwards; f angle about it, from y (up) towards z (right), u and v numbers between 0
//   and 1; t thickness; s place between middle and edge, 0..1; A half angle of a cone; R, r radii of a ring and its
//   tube, p angle about the tube.
// Equations: discs: s^2 even in (1-t)^2 .. 1; balls: s^3 even in (1-t)^3 .. 1, x/s even in -1..1 or 0..1; cones: away
//   from the tip, tan(lean) = s tan A; boxes: even in the shell between the box and the one that lies t times its
//   smallest half size inside; rings: (s, p) even in the disc, with p mirrored, p -> pi - p, with the probability
//   (1 - s r/R cos p)/2, which makes the density 1 + s r/R cos p, even in the volume of the torus. Randomised: turned
//   by part times acos(1 - 2 u), about its direction by 2 pi v, so that a part of 1 gives every direction evenly.
// Source: L. Devroye, Non-Uniform Random Variate Generation (1986), ch. II.2 and V.2 (inversion; balls and discs by the
//   distribution of their radius) and IV.8.1 (skewed densities by mirroring).
#pragma once

#include <memory>

#include "emit/chance.hpp"
#include "emit/emission.hpp"
#include "emit/newborn_pack.hpp"
#include "emit/pack_chance.hpp"
#include "emit/shape_lanes.hpp"

namespace physim {

/// Where a particle comes out of a shape, and its direction, of length one.
struct Outlet {
  Vec3d place{};
  Vec3d direction{1, 0, 0};
};

class SurfaceOutlets;

class ShapeOutlets {
 public:
  explicit ShapeOutlets(const EmitFrom& from);

  [[nodiscard]] Outlet at(const Birth& birth, ParticleChance& chance) const;
  /// Fills in places and directions.
  void at_each(NewbornPack& pack, PackChance<Draw, EmitStream::particle, NewbornPack::kLanes>& chance) const;

 private:
  void by_kernel(NewbornPack& pack, PackChance<Draw, EmitStream::particle, NewbornPack::kLanes>& chance) const;

  ShapeNumbers shape_;
  std::shared_ptr<const SurfaceOutlets> surface_;  // null: no shape of triangles
};

}  // namespace physim
