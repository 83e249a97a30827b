// Turning: orientations that are shown and move nothing. Where rotation moves a projectile, its rotation model says so.
#include "math/elementary.hpp"
#include "world/world_impl.hpp"

namespace physim {

/// The angular velocity dies away exponentially; over a step the axis stays, so the turn is exact:
/// angle = |omega| (1 - e^(-k dt)) / k.
void World::Impl::turn(double dt) {
  for (auto& [index, turning] : state.turning) {
    const Slot& slot = state.slots[index];
    if (slot.is(kStill)) continue;
    const double k = kind_of(slot).body.angular_drag;
    const Axes frozen = slot.is(kAlive) && state.own.contains(index) ? own_of(index).frozen_rotation
                                                                     : kind_of(slot).body.frozen_rotation;
    Vec3d& w = turning.angular_velocity;
    if (has(frozen, Axes::x)) w.x = 0;
    if (has(frozen, Axes::y)) w.y = 0;
    if (has(frozen, Axes::z)) w.z = 0;
    const double speed = length(w);
    if (speed == 0) continue;
    const double kept = exp(-k * dt);
    const double angle = speed * (k > 0 ? (1 - kept) / k : dt);
    const auto half = sincos(0.5 * angle);
    const Vec3d axis = w * (half.sin / speed);
    turning.orientation = normalized(Quatd{half.cos, axis.x, axis.y, axis.z} * turning.orientation);
    w *= kept;
  }
}

}  // namespace physim
