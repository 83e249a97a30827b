// Rows of a ProjectileDef and a Launch.
#pragma once

#include "model/body.hpp"
#include "settings/row.hpp"

namespace physim::setting_rows {

// ----------------------------------------------------------------------------------------------------------- items
inline constexpr auto kDragPointRows = std::tuple{
    PHYSIM_SETTING(mach, "Mach number", at_least(0), kPlace),
    PHYSIM_SETTING_AS("", coefficient, kNoItems, "drag coefficient", at_least(0)),
};
inline constexpr auto kBandRows = std::tuple{
    PHYSIM_SETTING(above, "air speed from which the band holds", Quantity::speed, at_least(0), kPlace),
    PHYSIM_SETTING(ballistic_coefficient, "m / (i d^2) of the band", Quantity::ballistic_coefficient, above(0),
                   kRequired),
};
inline constexpr auto kMagnusPointRows = std::tuple{
    PHYSIM_SETTING(speed, "through the air", Quantity::speed, at_least(0), kKey),
    PHYSIM_SETTING(spin, "a rate, or a spin parameter", Quantity::angular_rate, at_least(0), kKey),
    PHYSIM_SETTING(drag, "drag coefficient there", at_least(0)),
    PHYSIM_SETTING(lift, "lift coefficient there"),
};
inline constexpr auto kThrustPointRows = std::tuple{
    PHYSIM_SETTING(time, "time", Quantity::time, at_least(0), kPlace),
    PHYSIM_SETTING_AS("", force, kNoItems, "thrust", Quantity::force, at_least(0)),
};
inline constexpr auto kPropellantPointRows = std::tuple{
    PHYSIM_SETTING(time, "time", Quantity::time, at_least(0), kPlace),
    PHYSIM_SETTING_AS("", mass, kNoItems, "mass", Quantity::mass, at_least(0)),
};
inline constexpr auto kAeroPointRows = std::tuple{
    PHYSIM_SETTING(mach, "Mach number", between(0, 100), kPlace),
    PHYSIM_SETTING_AS("", value, kNoItems, "coefficient"),
};
inline constexpr auto kAeroAnglePointRows = std::tuple{
    PHYSIM_SETTING(mach, "Mach number", between(0, 100), kPlace),
    PHYSIM_SETTING(angle_squared, "square of the angle of attack", own_unit("rad^2"), between(0, 100), kKey),
    PHYSIM_SETTING_AS("", value, kNoItems, "coefficient"),
};

// ------------------------------------------------------------------------------------------------------- projectile
inline constexpr auto kProjectileRows = std::tuple{
    PHYSIM_SETTING(mass, "of the projectile", Quantity::mass, above(0), kLive, kUncertain),
    PHYSIM_SETTING(diameter, "reference diameter: the reference area is pi d^2 / 4", Quantity::length, above(0), kLive,
                   kUncertain),
    PHYSIM_SETTING(length, "of the projectile, for its stability; 0: not known", Quantity::length, at_least(0),
                   kUncertain),
    PHYSIM_SETTING(twist, "rifling, length of one turn, right-handed positive; 0: no spin", Quantity::length,
                   kUncertain),
    PHYSIM_SETTING(drag.table, "source of the drag coefficient", kLive),
    PHYSIM_SETTING(drag.coefficient, "drag coefficient of table = \"constant\"", at_least(0), kLive, kUncertain),
    PHYSIM_SETTING_LIST(drag.curve, kDragPointRows,
                        "[Mach number, drag coefficient] of table = \"custom\", Mach numbers rising", at_most(100000),
                        kLive, kUncertain),
    PHYSIM_SETTING(drag.ballistic_coefficient, "m / (i d^2); 0: from mass, diameter and form factor",
                   Quantity::ballistic_coefficient, at_least(0), kLive,
                   drawn_into(&LaunchColumns::ballistic_coefficient), kDrawnAboveZero),
    PHYSIM_SETTING_LIST(drag.bands, kBandRows, "ballistic coefficients by speed, instead of one", at_most(kMaxBands),
                        kLive, kUncertain),
    PHYSIM_SETTING(drag.form_factor, "drag coefficient of the projectile over that of the table", above(0), kLive,
                   drawn_into(&LaunchColumns::form_factor)),
    PHYSIM_SETTING(drag.damping, "part of the velocity kept after one second", kAboveZeroToOne, kLive, kUncertain),
    PHYSIM_SETTING(drag.k1, "linear drag: force -(k1 + k2 |v|) v", Quantity::linear_drag, at_least(0), kLive,
                   kUncertain),
    PHYSIM_SETTING(drag.k2, "quadratic drag; 0 with k1 = 0: from the drag equation at launch", Quantity::quadratic_drag,
                   at_least(0), kLive, kUncertain),
    PHYSIM_SETTING(gravity_scale, "times gravity, in flights and in worlds; 0: none", kUncertain),
    PHYSIM_SETTING(force, "a constant force on the projectile, such as thrust", Quantity::force, kUncertain),
    PHYSIM_SETTING(force_duration, "how long the force acts, from launch", Quantity::time, or_infinite(at_least(0)),
                   kUncertain),
};

inline constexpr auto kMagnusRows = std::tuple{
    PHYSIM_SETTING(magnus.lift, "lift coefficient: lift S / (lift_base + lift_saturation S), S the spin parameter",
                   kUncertain),
    PHYSIM_SETTING(magnus.lift_base, "see lift", above(0)),
    PHYSIM_SETTING(magnus.lift_saturation, "see lift", at_least(0)),
    PHYSIM_SETTING(magnus.drag_per_spin, "added to the drag coefficient for each rad/s of spin", Quantity::time,
                   at_least(0), kUncertain),
    PHYSIM_SETTING(magnus.measure, "what the spins of the table are"),
    PHYSIM_SETTING_LIST(magnus.table, kMagnusPointRows,
                        "drag and lift by speed and spin, every speed with every spin, instead of the formula",
                        at_most(10000), kUncertain),
    PHYSIM_SETTING(magnus.decay_time, "in which the spin falls to 1/e", Quantity::time, or_infinite(above(0)),
                   kUncertain),
};

inline constexpr auto kMotorRows = std::tuple{
    PHYSIM_SETTING_LIST(motor.thrust, kThrustPointRows,
                        "[time, thrust] since ignition, straight lines between, times rising from 0; two points at "
                        "one time are a step",
                        at_most(1000), kUncertain, kByFactor),
    PHYSIM_SETTING(motor.propellant_mass, "burned in all; part of shot.mass", Quantity::mass, at_least(0), kUncertain),
    PHYSIM_SETTING_LIST(motor.propellant, kPropellantPointRows,
                        "[time, mass left], from propellant_mass to 0; empty: it falls with the impulse delivered",
                        at_most(1000), kUncertain),
    PHYSIM_SETTING(motor.ignition_delay, "from launch to ignition", Quantity::time, between(0, 1e6), kUncertain),
    PHYSIM_SETTING(motor.drag_factor, "times the drag while it burns", between(0, 1000), kUncertain),
    PHYSIM_SETTING_LIST(motor.drag_curve, kDragPointRows,
                        "[Mach number, drag coefficient] while it burns; empty: that of shot.drag", at_most(100000),
                        kUncertain),
};

inline constexpr auto kInertiaRows = std::tuple{
    PHYSIM_SETTING(inertia.moments, "Ixx, Iyy, Izz along body axes (x forward, y up, z right); all 0: no rigid body",
                   Quantity::moment_of_inertia, kUncertain),
    PHYSIM_SETTING(inertia.products, "Ixy, Ixz, Iyz of the tensor, with its sign: Ixy = -integral of x y dm",
                   Quantity::moment_of_inertia),
};

#define PHYSIM_BY_MACH(member, doc) PHYSIM_SETTING_LIST(member, kAeroPointRows, doc "; by Mach number", kUncertain)
#define PHYSIM_BY_ANGLE(member, doc)                                                                             \
  PHYSIM_SETTING_LIST(member, kAeroAnglePointRows, doc "; by Mach number and the square of the angle of attack", \
                      kUncertain)
inline constexpr auto kAeroRows = std::tuple{
    PHYSIM_SETTING(aero.area, "reference area S; 0: pi/4 diameter^2", Quantity::area, at_least(0)),
    PHYSIM_SETTING(aero.length, "reference length d of pitching, yawing and Magnus; 0: the diameter", Quantity::length,
                   at_least(0)),
    PHYSIM_SETTING(aero.span, "reference length of rolling and of a yaw damping of its own; 0: the length",
                   Quantity::length, at_least(0)),
    PHYSIM_SETTING(aero.rate_norm, "what rates are made dimensionless by: p d / V or p d / 2V"),
    PHYSIM_SETTING(aero.damping_frame, "what damping is against: the turning air, or the fixed stars"),
    PHYSIM_BY_MACH(aero.drag_yaw, "CDd2: drag of yaw by the square of the sine of the angle of attack"),
    PHYSIM_BY_MACH(aero.lift, "CLa0: lift by the sine of the angle of attack"),
    PHYSIM_BY_MACH(aero.lift_cubic, "CLa2: lift by the third power of the sine"),
    PHYSIM_BY_MACH(aero.pitching, "CMa0: overturning moment by the sine, positive away from the path"),
    PHYSIM_BY_MACH(aero.pitching_cubic, "CMa2: overturning moment by the third power of the sine"),
    PHYSIM_BY_MACH(aero.pitch_damping, "CMq + CMadot, negative where it damps"),
    PHYSIM_BY_MACH(aero.yaw_damping, "Cnr; none: as pitch_damping"),
    PHYSIM_BY_MACH(aero.roll_damping, "Clp, negative where it damps"),
    PHYSIM_BY_ANGLE(aero.magnus_force, "CNpa: Magnus force"),
    PHYSIM_BY_ANGLE(aero.magnus_moment, "CMpa: Magnus moment"),
};
#undef PHYSIM_BY_MACH
#undef PHYSIM_BY_ANGLE

// ----------------------------------------------------------------------------------------------------------- launch
inline constexpr auto kMuzzleRows = std::tuple{
    PHYSIM_SETTING(position, "of the muzzle: x downrange, y up, z right", Quantity::length,
                   drawn_into(&LaunchColumns::x, &LaunchColumns::y, &LaunchColumns::z)),
};

inline constexpr auto kLaunchRows = std::tuple{
    PHYSIM_SETTING(speed, "at the muzzle", Quantity::speed, at_least(0), drawn_into(&LaunchColumns::speed)),
    PHYSIM_SETTING(elevation, "of the bore above the horizon; with a zero range it must stay 0", Quantity::angle,
                   between(-2 * kRightAngleUp, 2 * kRightAngleUp), in_files(kHalfTurn),
                   drawn_into(&LaunchColumns::elevation)),
    PHYSIM_SETTING(azimuth, "of the plane of fire, from x to the right", Quantity::angle, in_files(kTurn),
                   drawn_into(&LaunchColumns::azimuth)),
    PHYSIM_SETTING(velocity, "instead of speed, elevation and azimuth", Quantity::speed),
};

inline constexpr auto kSightRows = std::tuple{
    PHYSIM_SETTING(rail_length, "it moves only forwards along the bore until it has come so far; 0: no rail",
                   Quantity::length, at_least(0), kUncertain),
    PHYSIM_SETTING(sight.height, "of the sight above the bore, at the muzzle", Quantity::length),
    PHYSIM_SETTING(sight.look_angle, "of the line of sight above the horizon", Quantity::angle, kHalfTurn),
    PHYSIM_SETTING(sight.cant, "roll of launcher and sight, clockwise seen from behind", Quantity::angle,
                   in_files(kTurn), kUncertain),
    PHYSIM_SETTING(sight.zero_range, "on the level, the bore hits the line of sight there; 0: no zero",
                   Quantity::length, at_least(0)),
    PHYSIM_SETTING(sight.zero_in_calm_air, "the zero was shot without wind"),
    PHYSIM_SETTING(sight.dial, "of the elevation turret: raises the bore above the zero", Quantity::angle, kHalfTurn),
    PHYSIM_SETTING(spin.backspin, "of a ball at launch: lifts it; negative: topspin", Quantity::angular_rate,
                   kUncertain),
    PHYSIM_SETTING(spin.sidespin, "of a ball at launch: turns its path to the right", Quantity::angular_rate,
                   kUncertain),
    PHYSIM_SETTING(spin.gyrospin,
                   "of a ball at launch, about its path, clockwise seen from behind; its axis stays, and lifts as the "
                   "path bends away from it",
                   Quantity::angular_rate, kUncertain),
};

inline constexpr auto kAttitudeRows = std::tuple{
    PHYSIM_SETTING(attitude.frame, "what the launch angles are measured from"),
    PHYSIM_SETTING(attitude.yaw, "of the nose at launch, to the right, first", Quantity::angle, in_files(kTurn),
                   kUncertain),
    PHYSIM_SETTING(attitude.pitch, "of the nose at launch, up, second", Quantity::angle, in_files(kTurn), kUncertain),
    PHYSIM_SETTING(attitude.roll, "at launch, right side down, third", Quantity::angle, in_files(kTurn), kUncertain),
    PHYSIM_SETTING(attitude.rate_frame, "which frame the launch rates are seen from"),
    PHYSIM_SETTING(attitude.rates,
                   "at launch, about body axes (x forward, y up, z right), on top of the spin by rifling",
                   Quantity::angular_rate, kUncertain),
};

}  // namespace physim::setting_rows
