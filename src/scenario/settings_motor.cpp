// Settings of [shot.motor].
#include <filesystem>

#include "physim/motor_file.hpp"
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

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
    motor = picked->motor;
    return {};
  }};
}

ValueRef thrust_slot(const Scope& scope) {
  return points(scope.shot->projectile.motor.thrust, &ThrustPoint::time, &ThrustPoint::force,
                {{"time", "thrust"}, {Quantity::time, Quantity::force}, {}, {}});
}

ValueRef propellant_slot(const Scope& scope) {
  return points(scope.shot->projectile.motor.propellant, &PropellantPoint::time, &PropellantPoint::mass,
                {{"time", "mass"}, {Quantity::time, Quantity::mass}, {}, {}});
}

constexpr Entry kMotorSettings[] = {
    {.path = "shot.motor.name",
     .slot = PHYSIM_FIELD(shot->projectile.motor.name),
     .doc = "of the motor; picks one out of a file of several"},
    {.path = "shot.motor.file",
     .slot = file_slot,
     .doc = "a RASP file (.eng) with thrust and propellant, found from the scenario's folder; other keys change it"},
    {.path = "shot.motor.thrust",
     .slot = thrust_slot,
     .doc = "[time, thrust] since ignition, straight lines between, times rising from 0",
     .range = at_most(1000)},
    {.path = "shot.motor.propellant_mass",
     .slot = PHYSIM_FIELD(shot->projectile.motor.propellant_mass),
     .doc = "burned in all; part of shot.mass",
     .quantity = Quantity::mass,
     .range = at_least(0)},
    {.path = "shot.motor.propellant",
     .slot = propellant_slot,
     .doc = "[time, mass left], from propellant_mass to 0; empty: it falls with the impulse delivered",
     .range = at_most(1000)},
    {.path = "shot.motor.ignition_delay",
     .slot = PHYSIM_FIELD(shot->projectile.motor.ignition_delay),
     .doc = "from launch to ignition",
     .quantity = Quantity::time,
     .range = between(0, 1e6)},
    {.path = "shot.motor.drag_factor",
     .slot = PHYSIM_FIELD(shot->projectile.motor.drag_factor),
     .doc = "times the drag while it burns",
     .range = between(0, 1000)},
    {.path = "shot.motor.drag_curve",
     .slot = [](const Scope& s) { return curve_slot(s.shot->projectile.motor.drag_curve); },
     .doc = "[Mach number, drag coefficient] while it burns; empty: that of shot.drag",
     .range = at_most(100000)},
};

}  // namespace

std::span<const Entry> motor_settings() { return kMotorSettings; }

}  // namespace physim
