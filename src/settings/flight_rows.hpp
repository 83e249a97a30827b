// Rows of a Fidelity, a Tolerance and an Until.
#pragma once

#include "settings/row.hpp"

namespace physim::setting_rows {

inline constexpr auto kFidelityRows = std::tuple{
    PHYSIM_SETTING(motion, "how the equations of motion are treated"),
    PHYSIM_SETTING(integrator, "how they are stepped through time"),
    PHYSIM_SETTING(gravity, "model of gravity"),
    PHYSIM_SETTING(drag, "model of drag"),
    PHYSIM_SETTING(air, "model of air density and sound speed"),
    PHYSIM_SETTING(wind, "model of wind"),
    PHYSIM_SETTING(earth, "shape and rotation of the Earth"),
    PHYSIM_SETTING(rotation, "effects of the projectile's spin"),
    PHYSIM_SETTING(body_form, "how the attitude of a rigid body is computed"),
    PHYSIM_SETTING(precision, "number type of the computation"),
    PHYSIM_SETTING(interpolation, "how a drag curve is read between its points"),
    PHYSIM_SETTING(tolerance,
                   "relative error of a step of adaptive integrators if tolerance.relative is not given; 1e-15 at "
                   "least, in float32 2e-6; 0: 1e-9, in float32 2e-6",
                   at_least(0)),
    PHYSIM_SETTING(planar, "confine the flight to the vertical plane of fire"),
    PHYSIM_SETTING(aerodynamic_jump,
                   "with rotation spin_drift: crosswind at the muzzle turns the path up or down (Litz)"),
    PHYSIM_SETTING(original_one_shot_forces,
                   "classic only: forces act for one frame and never stop, as in the original"),
};

inline constexpr auto kToleranceRows = std::tuple{
    PHYSIM_SETTING(relative,
                   "adaptive integrators: error per step relative to position and velocity; none: the tolerance of "
                   "the fidelity",
                   at_least(0)),
    PHYSIM_SETTING(absolute,
                   "adaptive integrators: error per step where these are near zero, in m and m/s; both add as squares; "
                   "none: 1e-9, or the tolerance of the fidelity if that is less and tolerance.relative is none",
                   at_least(0)),
    PHYSIM_SETTING(step,
                   "of fixed-step integrators; 0: heun and rk4 find it by pilot flights, the others take 1/60 s or "
                   "less",
                   Quantity::time, at_least(0)),
    PHYSIM_SETTING(position_error, "what pilot flights keep along the whole flight", Quantity::length, above(0)),
    PHYSIM_SETTING(max_step, "adaptive integrators never step further", Quantity::time, or_infinite(above(0))),
    PHYSIM_SETTING(max_steps, "then the flight ends", between(1, 1e9)),
};

inline constexpr auto kUntilRows = std::tuple{
    PHYSIM_SETTING(ground, "height of the ground above the origin; off: no ground", Quantity::length, absent("off")),
    PHYSIM_SETTING(time, "the flight ends after this time", Quantity::time, above(0)),
    PHYSIM_SETTING(range, "the flight ends at this range along the line of sight", Quantity::length, above(0)),
};

}  // namespace physim::setting_rows
