// Settings of [[shot]]: projectile, launch and fidelity.
#include <algorithm>
#include <filesystem>

#include "physim/body.hpp"
#include "physim/scenario.hpp"
#include "scenario/settings_parts.hpp"
#include "scenario/units.hpp"
#include "settings/flight_rows.hpp"
#include "settings/shot_rows.hpp"

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
      return Error{"the motor alone weighs " + quantity_in_words(picked->mass, Quantity::mass) +
                       ", and with it shot.mass is " + quantity_in_words(mass, Quantity::mass),
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

constexpr Entry kShotSettings[] = {
    setting("shot", PHYSIM_FIELD(scenario->shots), "the projectiles and their launches", between(1, 100000)),
    PHYSIM_PROJECTILE(name, "in tables and overrides, different for each shot; default: shot-1, shot-2, ..."),
    setting("shot.preset", projectile_preset_slot,
            "a projectile to start from (physim list presets); the other keys change it", kPreset),
};

constexpr Entry kMotorSettings[] = {
    PHYSIM_PROJECTILE(motor.name, "of the motor; picks one out of a file of several, as \"C6\" or \"Estes C6\""),
    setting("shot.motor.file", file_slot,
            "a RASP file (.eng) with thrust and propellant, found from the scenario's folder; other keys change it"),
};

constexpr Entry kFidelitySettings[] = {
    setting(
        "shot.fidelity.cheapest_within", cheapest_within_slot,
        "flies the cheapest fidelity that stays this near to what the other keys say; without them, to the reference",
        Quantity::length, above(0)),
    setting("shot.fidelity.preset", preset_slot, "a preset to start from; further keys change it", kShorthand, kPreset),
};

std::vector<Entry> all_shot_settings() {
  std::vector<Entry> list;
  add(list, kShotSettings);
  add_rows<projectile_in, kProjectileRows>(list, "shot.");
  add_rows<launch_in, kMuzzleRows>(list, "shot.");
  add_rows<launch_in, kLaunchRows>(list, "shot.");
  add_rows<launch_in, kSightRows>(list, "shot.");
  add_rows<projectile_in, kMagnusRows>(list, "shot.");
  say(*std::ranges::find(list, "shot.magnus.table.spin", &Entry::path), QuantityBy{quantity_of_spin, "of the measure"});
  add(list, kMotorSettings);
  add_rows<projectile_in, kMotorRows>(list, "shot.");
  add_rows<projectile_in, kInertiaRows>(list, "shot.");
  add_rows<projectile_in, kAeroRows>(list, "shot.");
  add_rows<launch_in, kAttitudeRows>(list, "shot.");
  add(list, kFidelitySettings);
  add_rows<fidelity_in, kFidelityRows>(list, "shot.fidelity.");
  return list;
}

}  // namespace

std::span<const Entry> shot_settings() {
  static const std::vector<Entry> all = all_shot_settings();
  return all;
}

}  // namespace physim
