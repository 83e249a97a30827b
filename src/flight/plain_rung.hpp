// Which conditions are those of a plain point mass: what single flights and batches know at compile time.
#pragma once

#include "math/pack.hpp"
#include "model/acceleration.hpp"

namespace physim {

/// The rungs and features that distinguish plain point masses.
struct PlainRungs {
  GravityModel gravity = GravityModel::constant;
  EarthModel earth = EarthModel::flat;
  Features features{};
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Whether a projectile flies as a point mass with a drag curve in the standard's air, calm or with one wind, and has
/// nothing special about it but these features. Calm air is a wind of zero, which leaves the bits of a velocity as they
/// are.
template <class S>
PHYSIM_INLINE bool is_plain(const Conditions<S>& c, const PlainRungs& rungs) {
  const Fidelity& f = c.fidelity;
  return f.motion == Motion::force && f.gravity == rungs.gravity && f.earth == rungs.earth &&
         f.drag == DragModel::equation && f.air == AirModel::isa && f.wind != WindModel::profile && !f.planar &&
         !turns(f) && !spins(f) && static_cast<const Features&>(c) == rungs.features;
}

/// Whether calm air has a wind of zero: who reads it without looking at its rung says so before.
template <class S>
PHYSIM_INLINE bool is_calm_without_wind(const Conditions<S>& c) {
  const Components<S>& w = c.wind.velocity;
  return c.fidelity.wind != WindModel::off || (w.x == 0 && w.y == 0 && w.z == 0);
}

/// Whether a place over a flat Earth is one where the standard's air is known by its lowest layer alone.
PHYSIM_INLINE bool is_in_low_air(const Conditions<double>& c, const Vec3<double>& place) {
  return !(place.y + c.altitude > c.air.low_top);
}

PHYSIM_ISA_END
