// Presets of projectiles, each with the source of its numbers.
#include "physim/presets.hpp"

#include <array>
#include <cmath>

#include "physim/units.hpp"

namespace physim {
namespace presets {
namespace {

using namespace units;

constexpr double kStandardGravity = 9.80665;  // [m/s^2]

/// A shot of the original at its elevation setting 2, removed where the original removed it.
ProjectilePreset original(const char* name, double mass, double damping, double gravity, double speed) {
  ProjectilePreset p;
  p.projectile.name = name;
  p.projectile.mass = mass;
  p.projectile.drag.damping = damping;
  p.projectile.fidelity = Fidelity::classic();
  p.body.gravity_scale = gravity / kStandardGravity;
  p.body.despawn.below = -5;
  p.body.despawn.farther = 100;
  p.speed = speed;
  return p;
}

}  // namespace

ProjectilePreset artillery() {
  ProjectilePreset p = original("artillery", 200, 0.9, 20, std::hypot(4.0, 40.0));
  p.doc = "the original's artillery shell: 200 kg, gravity 20 m/s^2, damping 0.9";
  p.source = "client of the original PhySim (2017): (0, 2 e, 40) m/s at elevation setting e = 2";
  return p;
}

ProjectilePreset bullet() {
  ProjectilePreset p = original("bullet", 2, 0.9, 2, std::hypot(2.0, 35.0));
  p.doc = "the original's bullet: 2 kg, gravity 2 m/s^2, damping 0.9";
  p.source = "client of the original PhySim (2017): (0, e, 35) m/s at elevation setting e = 2";
  return p;
}

ProjectilePreset laser() {
  ProjectilePreset p = original("laser", 1, 1, 0, std::hypot(2.0, 35.0));
  p.doc = "the original's laser: neither gravity nor drag";
  p.source = "client of the original PhySim (2017): (0, e, 35) m/s at elevation setting e = 2";
  return p;
}

ProjectilePreset sphere() {
  ProjectilePreset p;
  p.projectile.name = "sphere";
  p.projectile.drag.table = DragTable::sphere;
  p.speed = 40;
  p.doc = "a plain smooth ball of 1 kg and 10 cm";
  p.source = "mass, size and speed: the library's own; Cd by Reynolds number: Morrison (2013)";
  return p;
}

ProjectilePreset rifle_bullet() {
  ProjectilePreset p;
  p.projectile = {.name = "rifle_bullet",
                  .mass = 168_gr,
                  .diameter = 0.308_in,
                  .length = 1.226_in,
                  .twist = 12_in,
                  .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  p.body.restitution = 0.2;
  p.speed = 2700_fps;
  p.doc = ".308 Winchester, 168 gr match bullet";
  p.source = "G7: B. Litz, Applied Ballistics for Long-Range Shooting (2009); size and twist: McCoy (1999), ch. 9";
  return p;
}

ProjectilePreset arrow() {
  ProjectilePreset p;
  p.projectile = {.name = "arrow", .mass = 18.5_g, .diameter = 5.2_mm, .drag = {.coefficient = 2.05}};
  p.body.restitution = 0;
  p.speed = 56.4;
  p.doc = "Olympic recurve arrow with large vanes";
  p.source = "Cd and speed: Ortiz et al., Proceedings 49 (2020) 56; mass and diameter: typical, our choice";
  return p;
}

ProjectilePreset grenade() {
  ProjectilePreset p;
  p.projectile = {.name = "grenade", .mass = 14_oz, .diameter = 2.5_in, .drag = {.table = DragTable::sphere}};
  p.body.restitution = 0.3;
  p.body.friction = 0.3;
  p.body.rolling_resistance = 0.1;
  p.body.despawn.older = 4.5;
  p.speed = 18.5;
  p.doc = "hand grenade, 14 oz, gone after 4.5 s";
  p.source = "mass, diameter, fuze of 4 to 5 s and a throw of about 35 m: M67, US Army FM 3-23.30; bounces: our choice";
  return p;
}

ProjectilePreset paintball() {
  ProjectilePreset p;
  p.projectile = {.name = "paintball", .mass = 3_g, .diameter = 0.68_in, .drag = {.table = DragTable::sphere}};
  p.body.restitution = 0;
  p.speed = 280_fps;
  p.doc = "paintball of calibre .68";
  p.source = "mass and speed: typical, our choice; Cd by Reynolds number: Morrison (2013)";
  return p;
}

ProjectilePreset tennis_ball() {
  ProjectilePreset p;
  p.projectile = {.name = "tennis_ball", .mass = 57.7_g, .diameter = 66.1_mm, .drag = {.coefficient = 0.507}};
  p.body.restitution = 0.745;
  p.body.friction = 0.2;  // less than of a ball that slides: it soon rolls, which a point mass does not know
  p.speed = 120_mph;
  p.doc = "tennis ball, served";
  p.source = "Cd: Cross and Lindsey (2014); mass, size and bounce (141 cm from 254 cm): middle of the rules of tennis";
  return p;
}

}  // namespace presets

namespace {

struct Named {
  std::string_view name;
  ProjectilePreset (*make)();
};

constexpr Named kPresets[] = {
    {"artillery", presets::artillery},
    {"bullet", presets::bullet},
    {"laser", presets::laser},
    {"sphere", presets::sphere},
    {"rifle_bullet", presets::rifle_bullet},
    {"arrow", presets::arrow},
    {"grenade", presets::grenade},
    {"paintball", presets::paintball},
    {"tennis_ball", presets::tennis_ball},
};

}  // namespace

std::span<const std::string_view> projectile_presets() {
  static constexpr auto names = [] {
    std::array<std::string_view, std::size(kPresets)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = kPresets[i].name;
    return all;
  }();
  return names;
}

std::optional<ProjectilePreset> projectile_preset(std::string_view name) {
  for (const Named& preset : kPresets)
    if (preset.name == name) return preset.make();
  return std::nullopt;
}

}  // namespace physim
