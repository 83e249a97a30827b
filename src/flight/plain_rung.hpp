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

/// True if a projectile is a point mass with a drag curve in the standard's air, calm or with one wind, on these rungs
/// and with these features alone. A wind of zero, that of calm air, changes no bit of the velocity through the air.
template <class S>
PHYSIM_INLINE bool is_plain(const Conditions<S>& c, const PlainRungs& rungs) {
  const Fidelity& f = c.fidelity;
  return f.motion == Motion::force && f.gravity == rungs.gravity && f.earth == rungs.earth &&
         f.drag == DragModel::equation && f.air == AirModel::isa && f.wind != WindModel::profile && !f.planar &&
         !turns(f) && !spins(f) && static_cast<const Features&>(c) == rungs.features;
}

/// True if the wind of calm air is stored as zero. Steps that read the wind on any rung assert it.
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
