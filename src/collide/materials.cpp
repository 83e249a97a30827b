// Materials: checks, and those whose numbers were published.
#include "physim/scene.hpp"

#include <string_view>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "model/poncelet.hpp"

namespace physim {
namespace {

/// A part of something: 0 to 1.
void check_part(Checker& c, double part, std::string_view place, std::string_view hint = "") {
  c.require(part >= 0 && part <= 1, place, "must lie between 0 and 1", hint);
}
/// An angle below a right one.
void check_angle(Checker& c, double angle, std::string_view place) {
  c.require(angle >= 0 && angle < kRightAngle, place, "must lie between 0 and below pi/2", "in rad");
}

/// Numbers that something can be computed with.
void check_between(Checker& c, double x, double low, double high, std::string_view place, std::string_view hint) {
  PHYSIM_ASSERT(low < high);
  if (!(x >= low && x <= high))
    c.require(false, place, "must lie between " + short_text(low) + " and " + short_text(high), hint);
}

void check_penetration(Checker&, const ImpenetrableDef&, double) {}
void check_penetration(Checker& c, const PonceletDef& p, double density) {
  if (p.strength != 0) check_between(c, p.strength, 1, 1e15, "material.penetration.strength", "in Pa; 0: a liquid");
  check_between(c, p.inertia, 0, 1000, "material.penetration.inertia", "solids 1, liquids 1/2");
  check_between(c, p.crater, 0, 100, "material.penetration.crater", "in diameters; concrete 2");
  c.require(p.strength > 0 || p.inertia * density > 0, "material.penetration.strength", "resists nothing",
            "give a strength, or an inertia and material.density");
}
void check_penetration(Checker& c, const YoungDef& y, double) {
  check_between(c, y.s_number, 1e-3, 1e3, "material.penetration.s_number", "concrete about 1, soils more");
}
void check_penetration(Checker& c, const DeMarreDef& d, double) {
  check_between(c, d.quality, 1e-3, 1e3, "material.penetration.quality", "nickel steel 1");
  check_part(c, d.plug, "material.penetration.plug");
}
void check_penetration(Checker& c, const LambertDef& l, double density) {
  check_between(c, l.coefficient, 1, 1e6, "material.penetration.coefficient", "rolled homogeneous armour 4000");
  c.positive(density, "material.density", "LambertDef needs it, in kg/m^3");
}
void check_penetration(Checker& c, const BallisticLimitDef& b, double) {
  check_between(c, b.speed, 1e-3, 1e9, "material.penetration.speed", "the ballistic limit, in m/s");
  check_part(c, b.a, "material.penetration.a", "more would give energy");
  check_between(c, b.p, 1, 100, "material.penetration.p", "2: a constant energy is lost");
}

void check_ricochet(Checker& c, const RicochetDef& r, double density) {
  check_angle(c, r.critical_angle, "material.ricochet.critical_angle");
  check_part(c, r.restitution, "material.ricochet.restitution", "more would give energy");
  c.not_negative(r.friction, "material.ricochet.friction");
  if (c.status_so_far() && r.critical_angle > 0)
    c.require(r.friction * (1 + r.restitution) * tan(r.critical_angle) <= 1, "material.ricochet.friction",
              "leaves no speed along the surface at the critical angle",
              "at most 1 / ((1 + restitution) tan(critical_angle))");
  if (r.liquid) c.positive(density, "material.density", "what ricochets off a liquid needs it, in kg/m^3");
}

}  // namespace

PHYSIM_COLD Status check_material(const Material& m) {
  const IeeeMode mode;
  Checker c;
  check_part(c, m.restitution, "material.restitution", "more would give energy");
  c.not_negative(m.friction, "material.friction");
  c.named(m.combine.restitution, "material.combine.restitution");
  c.named(m.combine.friction, "material.combine.friction");
  check_part(c, m.grip_restitution, "material.grip_restitution", "more would give energy");
  check_between(c, m.density, 0, 1e6, "material.density", "in kg/m^3; 0: not known");
  check_ricochet(c, m.ricochet, m.density);
  std::visit([&](const auto& law) { check_penetration(c, law, m.density); }, m.penetration);
  check_angle(c, m.spread.deflection, "material.spread.deflection");
  check_angle(c, m.spread.yaw, "material.spread.yaw");
  return c.status();
}

namespace materials {
namespace {

constexpr double kKilogramForce = 9.80665;  // [N]

/// Strength of wood by the ratio of the energy of motion, m v^2, to the volume of the impression [kgf/m^2], which is
/// twice the strength.
PonceletDef wood(double ratio) { return {.strength = 0.5 * ratio * kKilogramForce}; }

}  // namespace

Material water() {
  return {.name = "water", .density = 998.2, .ricochet = {.liquid = true}, .penetration = PonceletDef{.inertia = 0.5}};
}

Material concrete(double compressive_strength) {
  const IeeeMode mode;
  const double strength = compressive_strength > 0 ? concrete_strength(compressive_strength) : compressive_strength;
  return {
      .name = "concrete", .density = 2370, .penetration = PonceletDef{.strength = strength, .inertia = 1, .crater = 2}};
}

Material fir() { return {.name = "fir", .penetration = wood(3.94e6)}; }
Material oak() { return {.name = "oak", .penetration = wood(6.02e6)}; }

Material nickel_steel() { return {.name = "nickel_steel", .penetration = DeMarreDef{}}; }
Material rolled_armour() {
  return {.name = "rolled_armour", .density = 7850, .penetration = LambertDef{.coefficient = 4000}};
}
Material aluminium() { return {.name = "aluminium", .density = 2700, .penetration = LambertDef{.coefficient = 1750}}; }

}  // namespace materials
}  // namespace physim
