// Settings of [shot.inertia] and [shot.attitude]: what rigid bodies are and how they start.
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

constexpr Entry kRotationSettings[] = {
    {.path = "shot.inertia.moments",
     .slot = PHYSIM_FIELD(shot->projectile.inertia.moments),
     .doc = "Ixx, Iyy, Izz along body axes (x forward, y up, z right); all 0: no rigid body",
     .quantity = Quantity::moment_of_inertia},
    {.path = "shot.inertia.products",
     .slot = PHYSIM_FIELD(shot->projectile.inertia.products),
     .doc = "Ixy, Ixz, Iyz of the tensor, with its sign: Ixy = -integral of x y dm",
     .quantity = Quantity::moment_of_inertia},
    {.path = "shot.attitude.frame",
     .slot = PHYSIM_FIELD(shot->launch.attitude.frame),
     .doc = "what the launch angles are measured from"},
    {.path = "shot.attitude.yaw",
     .slot = PHYSIM_FIELD(shot->launch.attitude.yaw),
     .doc = "of the nose at launch, to the right, first",
     .quantity = Quantity::angle,
     .range = kTurn},
    {.path = "shot.attitude.pitch",
     .slot = PHYSIM_FIELD(shot->launch.attitude.pitch),
     .doc = "of the nose at launch, up, second",
     .quantity = Quantity::angle,
     .range = kTurn},
    {.path = "shot.attitude.roll",
     .slot = PHYSIM_FIELD(shot->launch.attitude.roll),
     .doc = "at launch, right side down, third",
     .quantity = Quantity::angle,
     .range = kTurn},
    {.path = "shot.attitude.rate_frame",
     .slot = PHYSIM_FIELD(shot->launch.attitude.rate_frame),
     .doc = "which frame the launch rates are seen from"},
    {.path = "shot.attitude.rates",
     .slot = PHYSIM_FIELD(shot->launch.attitude.rates),
     .doc = "at launch, about body axes (x forward, y up, z right), on top of the spin by rifling",
     .quantity = Quantity::angular_rate},
};

}  // namespace

std::span<const Entry> rotation_settings() { return kRotationSettings; }

}  // namespace physim
