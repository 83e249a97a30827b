// Rows of a BodyDef. How a ContactDef meets things has the same rows.
#pragma once

#include "physim/body.hpp"
#include "settings/row.hpp"

namespace physim::setting_rows {

inline constexpr auto kBodyRows = std::tuple{
    PHYSIM_SETTING(gravity_scale, "times gravity; 0: none", kLive),
    PHYSIM_SETTING(use_gravity, "false is a gravity_scale of 0", kLive),
    PHYSIM_SETTING(drag_scale, "times every drag; 0: none", at_least(0)),
    PHYSIM_SETTING(angular_drag, "rate at which turning dies away", Quantity::frequency, at_least(0)),
    PHYSIM_SETTING(angular_velocity, "at launch; moves nothing but in contacts of a ball, whose spin it is",
                   Quantity::angular_rate),
    PHYSIM_SETTING(kinematic, "moves only when told to", kLive),
    PHYSIM_SETTING(infinite_mass, "nothing ever moves it"),
    PHYSIM_SETTING(frozen, "axes of the world along which it does not move", kLive),
    PHYSIM_SETTING(frozen_rotation, "axes of the world about which it does not turn", kLive),
    PHYSIM_SETTING(can_sleep, "goes to sleep after resting", kLive),
    PHYSIM_SETTING(sleep_speed, "slower than this is resting", Quantity::speed, at_least(0)),
    PHYSIM_SETTING(sleep_time, "rest before it sleeps", Quantity::time, at_least(0)),
};

inline constexpr auto kContactRows = std::tuple{
    PHYSIM_SETTING(restitution, "speed kept by a bounce", kFraction, kContact),
    PHYSIM_SETTING(friction, "Coulomb's, of bounces and sliding", at_least(0), kContact),
    PHYSIM_SETTING(rolling_resistance, "part of the weight that resists rolling; 0: a point slides, against friction",
                   at_least(0), kContact),
    PHYSIM_SETTING(combine.restitution, "how it is combined with that of what is touched; of two rules the later one",
                   kContact),
    PHYSIM_SETTING(combine.friction, "how it is combined with that of what is touched; of two rules the later one",
                   kContact),
    PHYSIM_SETTING(collision.on_hit, "what it does where it meets a thing of the scene", kContact),
    PHYSIM_SETTING(collision.radius, "it meets them as a ball of so much, 1e-12 m at least; 0: as a point",
                   Quantity::length, between(0, 1e6), kContact),
    PHYSIM_SETTING(collision.inertia, "of the ball, over mass and radius squared", kAboveZeroToOne, kContact),
    PHYSIM_SETTING(collision.layers, "bits: it meets things of these layers; 0: none", kBits, kContact),
    PHYSIM_SETTING(collision.others, "bits: it meets projectiles of these layers that want its own; 0: none", kBits),
};

inline constexpr auto kDespawnRows = std::tuple{
    PHYSIM_SETTING(despawn.below, "leaves below this height above the origin", Quantity::length, or_infinite({})),
    PHYSIM_SETTING(despawn.farther, "leaves farther than this from its launch", Quantity::length,
                   or_infinite(above(0))),
    PHYSIM_SETTING(despawn.older, "leaves this long after launch", Quantity::time, or_infinite(above(0))),
    PHYSIM_SETTING(despawn.slower, "leaves when slower than this", Quantity::speed, at_least(0)),
    PHYSIM_SETTING(despawn.outside_box, "leaves outside of the box"),
};

inline constexpr auto kBoxRows = std::tuple{
    PHYSIM_SETTING(despawn.box_low, "corner of the box", Quantity::length),
    PHYSIM_SETTING(despawn.box_high, "opposite corner of the box", Quantity::length),
};

inline constexpr auto kShownRows = std::tuple{
    PHYSIM_SETTING(smoothing, "how a position between two steps is shown", kLive),
};

inline constexpr auto kCarriedRows = std::tuple{
    PHYSIM_SETTING(within_time, "how long after its launch shot.fidelity.cheapest_within is kept", Quantity::time,
                   above(0)),
    PHYSIM_SETTING(layers, "bits for forces and for the user's own use", kBits, kLive),
    PHYSIM_SETTING(colour, "carried along, 0xRRGGBBAA", kBits, kLive),
    PHYSIM_SETTING(label, "carried along", kLive),
};

}  // namespace physim::setting_rows
