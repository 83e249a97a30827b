// Settings of [[shot]]: projectile, launch and fidelity.
#include <filesystem>

#include "physim/motor_file.hpp"
#include "physim/presets.hpp"
#include "scenario/settings_parts.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

ValueRef preset_slot(const Scope& scope) {
  Fidelity& fidelity = scope.shot->projectile.fidelity;
  return Choice{fidelity_presets(), [] { return std::optional<std::size_t>(); },  // its fields say all that it says
                [&fidelity](std::size_t i) { fidelity = *fidelity_preset(fidelity_presets()[i]); }};
}

ValueRef projectile_preset_slot(const Scope& scope) {
  ScenarioShot& shot = *scope.shot;
  return Choice{projectile_presets(), [] { return std::optional<std::size_t>(); },  // its fields say all that it says
                [&shot](std::size_t i) {
                  const ProjectilePreset preset = *projectile_preset(projectile_presets()[i]);
                  const std::string name = shot.projectile.name;
                  shot.projectile = preset.projectile;
                  shot.projectile.name = name;
                  shot.body = preset.body;
                  shot.launch.speed = preset.speed;
                }};
}

/// Comes before the other keys of the table, which then say what errors are measured against.
ValueRef cheapest_within_slot(const Scope& scope) {
  ScenarioShot& shot = *scope.shot;
  return OptionalNumber{[&shot] { return shot.cheapest_within; },
                        [&shot](std::optional<double> error) {
                          shot.cheapest_within = error;
                          if (error) shot.projectile.fidelity = Fidelity::reference();
                        }};
}

/// A motor file, found from where the scenario is. It comes after the name, which picks one of its motors, and before
/// the other keys, which change it.
ValueRef file_slot(const Scope& scope) {
  return Reference{[scope](const std::string& given) -> Status {
    const std::string file = (std::filesystem::path(scope.scenario->file).parent_path() / given).string();
    const auto motors = read_motor_file(file);
    if (!motors) return motors.error();
    MotorDef& motor = scope.shot->projectile.motor;
    const auto picked = pick_motor(*motors, motor.name, file);
    if (!picked) return picked.error();
    if (const double mass = scope.shot->projectile.mass; mass < picked->mass)
      return Error{"the motor alone weighs " + quantity_text(picked->mass, Quantity::mass) +
                       ", and with it shot.mass is " + quantity_text(mass, Quantity::mass),
                   "", "shot.mass is that of the loaded rocket"};
    motor = picked->motor;
    return {};
  }};
}

Quantity quantity_of_spin(const Scope& scope) {
  const bool by_rate = scope.shot->projectile.magnus.measure == SpinMeasure::rate;
  return by_rate ? Quantity::angular_rate : Quantity::number;
}

#define PHYSIM_PROJECTILE(field, ...) setting("shot." #field, PHYSIM_FIELD(shot->projectile.field), __VA_ARGS__)
#define PHYSIM_LAUNCH(field, ...) setting("shot." #field, PHYSIM_FIELD(shot->launch.field), __VA_ARGS__)

constexpr Entry kShotSettings[] = {
    setting("shot", PHYSIM_FIELD(scenario->shots), "the projectiles and their launches", between(1, 100000)),
    PHYSIM_PROJECTILE(name, "in tables and overrides, different for each shot; default: shot-1, shot-2, ..."),
    setting("shot.preset", projectile_preset_slot,
            "a projectile to start from (physim list presets); the other keys change it", kPreset),
    PHYSIM_PROJECTILE(mass, "of the projectile", Quantity::mass, above(0), kLive),
    PHYSIM_PROJECTILE(diameter, "reference diameter: the reference area is pi d^2 / 4", Quantity::length, above(0),
                      kLive),
    PHYSIM_PROJECTILE(length, "of the projectile, for its stability; 0: not known", Quantity::length, at_least(0)),
    PHYSIM_PROJECTILE(twist, "rifling, length of one turn, right-handed positive; 0: no spin", Quantity::length),
    PHYSIM_PROJECTILE(drag.table, "source of the drag coefficient", kLive),
    PHYSIM_PROJECTILE(drag.coefficient, "drag coefficient of table = \"constant\"", at_least(0), kLive),
    PHYSIM_PROJECTILE(drag.curve, "[Mach number, drag coefficient] of table = \"custom\", Mach numbers rising",
                      at_most(100000), kLive),
    PHYSIM_PROJECTILE(drag.ballistic_coefficient, "m / (i d^2); 0: from mass, diameter and form factor",
                      Quantity::ballistic_coefficient, at_least(0), kLive),
    PHYSIM_PROJECTILE(drag.bands, "ballistic coefficients by speed, instead of one", at_most(8), kLive),
    PHYSIM_ROW("shot.drag.bands", band, above, "air speed from which the band holds", Quantity::speed, at_least(0)),
    PHYSIM_ROW("shot.drag.bands", band, ballistic_coefficient, "m / (i d^2) of the band",
               Quantity::ballistic_coefficient, above(0), kRequired),
    PHYSIM_PROJECTILE(drag.form_factor, "drag coefficient of the projectile over that of the table", above(0), kLive),
    PHYSIM_PROJECTILE(drag.damping, "part of the velocity kept after one second",
                      Range{.low = 0, .high = 1, .low_open = true}, kLive),
    PHYSIM_PROJECTILE(drag.k1, "linear drag: force -(k1 + k2 |v|) v", Quantity::linear_drag, at_least(0), kLive),
    PHYSIM_PROJECTILE(drag.k2, "quadratic drag; 0 with k1 = 0: from the drag equation at launch",
                      Quantity::quadratic_drag, at_least(0), kLive),
    PHYSIM_PROJECTILE(gravity_scale, "times gravity, in flights and in worlds; 0: none"),
    PHYSIM_PROJECTILE(force, "a constant force on the projectile, such as thrust", Quantity::force),
    PHYSIM_PROJECTILE(force_duration, "how long the force acts, from launch", Quantity::time, or_infinite(at_least(0))),
    PHYSIM_LAUNCH(position, "of the muzzle: x downrange, y up, z right", Quantity::length),
    PHYSIM_LAUNCH(speed, "at the muzzle", Quantity::speed, at_least(0)),
    PHYSIM_LAUNCH(elevation, "of the bore above the horizon; with a zero range it must stay 0", Quantity::angle,
                  kHalfTurn),
    PHYSIM_LAUNCH(azimuth, "of the plane of fire, from x to the right", Quantity::angle, kTurn),
    PHYSIM_LAUNCH(velocity, "instead of speed, elevation and azimuth", Quantity::speed),
    PHYSIM_LAUNCH(rail_length, "it moves only forwards along the bore until it has come so far; 0: no rail",
                  Quantity::length, at_least(0)),
    PHYSIM_LAUNCH(sight.height, "of the sight above the bore, at the muzzle", Quantity::length),
    PHYSIM_LAUNCH(sight.look_angle, "of the line of sight above the horizon", Quantity::angle, kHalfTurn),
    PHYSIM_LAUNCH(sight.cant, "roll of launcher and sight, clockwise seen from behind", Quantity::angle, kTurn),
    PHYSIM_LAUNCH(sight.zero_range, "the bore is elevated to hit the line of sight there; 0: it is not",
                  Quantity::length, at_least(0)),
    PHYSIM_LAUNCH(sight.zero_in_calm_air, "the zero was shot without wind"),
    PHYSIM_LAUNCH(spin.backspin, "of a ball at launch: lifts it; negative: topspin", Quantity::angular_rate),
    PHYSIM_LAUNCH(spin.sidespin, "of a ball at launch: turns its path to the right", Quantity::angular_rate),
    PHYSIM_LAUNCH(spin.gyrospin, "of a ball at launch, about its path, clockwise seen from behind; lifts nothing",
                  Quantity::angular_rate),
    PHYSIM_PROJECTILE(magnus.lift, "lift coefficient: lift S / (lift_base + lift_saturation S), S the spin parameter"),
    PHYSIM_PROJECTILE(magnus.lift_base, "see lift", above(0)),
    PHYSIM_PROJECTILE(magnus.lift_saturation, "see lift", at_least(0)),
    PHYSIM_PROJECTILE(magnus.drag_per_spin, "added to the drag coefficient for each rad/s of spin", Quantity::time,
                      at_least(0)),
    PHYSIM_PROJECTILE(magnus.measure, "what the spins of the table are"),
    PHYSIM_PROJECTILE(magnus.table,
                      "drag and lift by speed and spin, every speed with every spin, instead of the formula",
                      at_most(10000)),
    PHYSIM_ROW("shot.magnus.table", magnus_point, speed, "through the air", Quantity::speed, at_least(0)),
    PHYSIM_ROW("shot.magnus.table", magnus_point, spin, "a rate, or a spin parameter", at_least(0),
               QuantityBy{quantity_of_spin, "of the measure"}),
    PHYSIM_ROW("shot.magnus.table", magnus_point, drag, "drag coefficient there", at_least(0)),
    PHYSIM_ROW("shot.magnus.table", magnus_point, lift, "lift coefficient there"),
    PHYSIM_PROJECTILE(magnus.decay_time, "in which the spin falls to 1/e", Quantity::time, or_infinite(above(0))),
    PHYSIM_PROJECTILE(motor.name, "of the motor; picks one out of a file of several"),
    setting("shot.motor.file", file_slot,
            "a RASP file (.eng) with thrust and propellant, found from the scenario's folder; other keys change it"),
    PHYSIM_PROJECTILE(motor.thrust,
                      "[time, thrust] since ignition, straight lines between, times rising from 0; two points at "
                      "one time are a step",
                      at_most(1000)),
    PHYSIM_PROJECTILE(motor.propellant_mass, "burned in all; part of shot.mass", Quantity::mass, at_least(0)),
    PHYSIM_PROJECTILE(motor.propellant,
                      "[time, mass left], from propellant_mass to 0; empty: it falls with the impulse delivered",
                      at_most(1000)),
    PHYSIM_PROJECTILE(motor.ignition_delay, "from launch to ignition", Quantity::time, between(0, 1e6)),
    PHYSIM_PROJECTILE(motor.drag_factor, "times the drag while it burns", between(0, 1000)),
    PHYSIM_PROJECTILE(motor.drag_curve, "[Mach number, drag coefficient] while it burns; empty: that of shot.drag",
                      at_most(100000)),
    PHYSIM_PROJECTILE(inertia.moments, "Ixx, Iyy, Izz along body axes (x forward, y up, z right); all 0: no rigid body",
                      Quantity::moment_of_inertia),
    PHYSIM_PROJECTILE(inertia.products, "Ixy, Ixz, Iyz of the tensor, with its sign: Ixy = -integral of x y dm",
                      Quantity::moment_of_inertia),
    PHYSIM_PROJECTILE(aero.area, "reference area S; 0: pi/4 diameter^2", Quantity::area, at_least(0)),
    PHYSIM_PROJECTILE(aero.length, "reference length d of pitching, yawing and Magnus; 0: the diameter",
                      Quantity::length, at_least(0)),
    PHYSIM_PROJECTILE(aero.span, "reference length of rolling and of a yaw damping of its own; 0: the length",
                      Quantity::length, at_least(0)),
    PHYSIM_PROJECTILE(aero.rate_norm, "what rates are made dimensionless by: p d / V or p d / 2V"),
    PHYSIM_PROJECTILE(aero.damping_frame, "what damping is against: the turning air, or the fixed stars"),
    PHYSIM_PROJECTILE(aero.drag_yaw,
                      "CDd2: drag of yaw by the square of the sine of the angle of attack; by Mach number"),
    PHYSIM_PROJECTILE(aero.lift, "CLa0: lift by the sine of the angle of attack; by Mach number"),
    PHYSIM_PROJECTILE(aero.lift_cubic, "CLa2: lift by the third power of the sine; by Mach number"),
    PHYSIM_PROJECTILE(aero.pitching,
                      "CMa0: overturning moment by the sine, positive away from the path; by Mach number"),
    PHYSIM_PROJECTILE(aero.pitching_cubic, "CMa2: overturning moment by the third power of the sine; by Mach number"),
    PHYSIM_PROJECTILE(aero.pitch_damping, "CMq + CMadot, negative where it damps; by Mach number"),
    PHYSIM_PROJECTILE(aero.yaw_damping, "Cnr; none: as pitch_damping; by Mach number"),
    PHYSIM_PROJECTILE(aero.roll_damping, "Clp, negative where it damps; by Mach number"),
    PHYSIM_PROJECTILE(aero.magnus_force, "CNpa: Magnus force; by Mach number and the square of the angle of attack"),
    PHYSIM_PROJECTILE(aero.magnus_moment, "CMpa: Magnus moment; by Mach number and the square of the angle of attack"),
    PHYSIM_LAUNCH(attitude.frame, "what the launch angles are measured from"),
    PHYSIM_LAUNCH(attitude.yaw, "of the nose at launch, to the right, first", Quantity::angle, kTurn),
    PHYSIM_LAUNCH(attitude.pitch, "of the nose at launch, up, second", Quantity::angle, kTurn),
    PHYSIM_LAUNCH(attitude.roll, "at launch, right side down, third", Quantity::angle, kTurn),
    PHYSIM_LAUNCH(attitude.rate_frame, "which frame the launch rates are seen from"),
    PHYSIM_LAUNCH(attitude.rates,
                  "at launch, about body axes (x forward, y up, z right), on top of the spin by rifling",
                  Quantity::angular_rate),
    setting(
        "shot.fidelity.cheapest_within", cheapest_within_slot,
        "flies the cheapest fidelity that stays this near to what the other keys say; without them, to the reference",
        Quantity::length, above(0)),
    setting("shot.fidelity.preset", preset_slot, "a preset to start from; further keys change it", kShorthand, kPreset),
    PHYSIM_PROJECTILE(fidelity.motion, "how the equations of motion are treated"),
    PHYSIM_PROJECTILE(fidelity.integrator, "how they are stepped through time"),
    PHYSIM_PROJECTILE(fidelity.gravity, "model of gravity"),
    PHYSIM_PROJECTILE(fidelity.drag, "model of drag"),
    PHYSIM_PROJECTILE(fidelity.air, "model of air density and sound speed"),
    PHYSIM_PROJECTILE(fidelity.wind, "model of wind"),
    PHYSIM_PROJECTILE(fidelity.earth, "shape and rotation of the Earth"),
    PHYSIM_PROJECTILE(fidelity.rotation, "effects of the projectile's spin"),
    PHYSIM_PROJECTILE(fidelity.body_form, "how the attitude of a rigid body is computed"),
    PHYSIM_PROJECTILE(fidelity.precision, "number type of the computation"),
    PHYSIM_PROJECTILE(fidelity.interpolation, "how a drag curve is read between its points"),
    PHYSIM_PROJECTILE(fidelity.tolerance,
                      "relative error of a step of adaptive integrators if tolerance.relative is not given; 1e-15 at "
                      "least, in float32 2e-6; 0: 1e-9, in float32 2e-6",
                      at_least(0)),
    PHYSIM_PROJECTILE(fidelity.planar, "confine the flight to the vertical plane of fire"),
    PHYSIM_PROJECTILE(fidelity.aerodynamic_jump,
                      "with rotation spin_drift: crosswind at the muzzle turns the path up or down (Litz)"),
    PHYSIM_PROJECTILE(fidelity.original_one_shot_forces,
                      "classic only: forces act for one frame and never stop, as in the original"),
};

}  // namespace

std::span<const Entry> shot_settings() { return kShotSettings; }

}  // namespace physim
