// Impacts and materials that nothing can be computed with are refused, and the error names the number.
#include <functional>

#include "support.hpp"

namespace physim::collide_impact_input_test {

using test::kNan;

Impact good_impact() { return {.mass = 0.01, .diameter = 0.008, .velocity = {300, -400, 0}}; }

void expect_refused(const Impact& hit, const Material& material, std::string_view place) {
  const auto result = impact(hit, material);
  ASSERT_FALSE(result) << place;
  EXPECT_EQ(result.error().place, place) << result.error().text();
  EXPECT_FALSE(result.error().message.empty());
}

TEST(ImpactInput, numbers_that_are_none_are_named) {
  const std::pair<const char*, std::function<void(Impact&, double)>> numbers[] = {
      {"impact.velocity", [](Impact& i, double x) { i.velocity.y = x; }},
      {"impact.spin", [](Impact& i, double x) { i.spin.z = x; }},
      {"impact.normal", [](Impact& i, double x) { i.normal.x = x; }},
      {"impact.surface_velocity", [](Impact& i, double x) { i.surface_velocity.x = x; }},
      {"impact.mass", [](Impact& i, double x) { i.mass = x; }},
      {"impact.diameter", [](Impact& i, double x) { i.diameter = x; }},
      {"impact.length", [](Impact& i, double x) { i.length = x; }},
      {"impact.nose_length", [](Impact& i, double x) { i.nose_length = x; }},
      {"impact.inertia", [](Impact& i, double x) { i.inertia = x; }}};
  for (const auto& [place, set] : numbers)
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
      Impact hit = good_impact();
      set(hit, bad);
      expect_refused(hit, materials::fir(), place);
      expect_refused(hit, {}, place);
    }
  for (const double bad : {kNan, -kInfinity, -1.0, 1e-12}) {
    Impact hit = good_impact();
    hit.thickness = bad;
    expect_refused(hit, {}, "impact.thickness");
  }
  Impact endless = good_impact();
  endless.thickness = kInfinity;
  EXPECT_TRUE(impact(endless, materials::fir()));
}

TEST(ImpactInput, a_normal_has_length_one_and_speeds_have_a_limit) {
  Impact hit = good_impact();
  hit.normal = {0, 2, 0};
  expect_refused(hit, {}, "impact.normal");
  hit.normal = {};
  expect_refused(hit, {}, "impact.normal");
  hit = good_impact();
  hit.velocity.x = 1e10;
  expect_refused(hit, {}, "impact.velocity");
}

TEST(ImpactInput, numbers_whose_products_are_none_are_refused) {
  const auto refused = [](const char* place, auto change) {
    Impact hit = good_impact();
    change(hit);
    expect_refused(hit, {}, place);
  };
  for (const double x : {1e200, kInfinity, kNan}) {
    refused("impact.mass", [x](Impact& hit) { hit.mass = x; });
    refused("impact.diameter", [x](Impact& hit) { hit.diameter = x; });
    refused("impact.length", [x](Impact& hit) { hit.length = x; });
    refused("impact.spin", [x](Impact& hit) { hit.spin.y = x; });
  }
  refused("impact.diameter", [](Impact& hit) { hit.diameter = 1e-308; });  // it would spin at any rate
  Impact hit = good_impact();
  hit.mass = 1e100, hit.diameter = 1e15, hit.spin = {1e15, 0, 0};
  const auto result = must(impact(hit, {}));
  EXPECT_TRUE(std::isfinite(result.energy) && std::isfinite(length(result.spin)));
}

TEST(ImpactInput, mass_and_diameter_are_asked_for_by_the_laws_that_need_them) {
  Impact hit = good_impact();
  hit.mass = 0;
  EXPECT_TRUE(impact(hit, {}));
  expect_refused(hit, materials::fir(), "impact.mass");
  expect_refused(hit, materials::water(), "impact.mass");
  hit = good_impact();
  hit.diameter = 0;
  EXPECT_TRUE(impact(hit, {}));
  expect_refused(hit, materials::nickel_steel(), "impact.diameter");
  EXPECT_FALSE(impact({.mass = -1, .velocity = {0, -1, 0}}, {}));
  EXPECT_FALSE(impact({.inertia = 0, .velocity = {0, -1, 0}}, {}));
}

TEST(ImpactInput, materials_that_gain_energy_or_hold_no_numbers_are_refused_with_their_place) {
  const std::pair<const char*, Material> bad[] = {
      {"material.restitution", {.restitution = 1.01}},
      {"material.restitution", {.restitution = -0.1}},
      {"material.restitution", {.restitution = kNan}},
      {"material.friction", {.friction = -1}},
      {"material.friction", {.friction = kInfinity}},
      {"material.grip_restitution", {.grip_restitution = 1.5}},
      {"material.grip_restitution", {.grip_restitution = kNan}},
      {"material.density", {.density = -1}},
      {"material.density", {.density = kNan}},
      {"material.ricochet.critical_angle", {.ricochet = {.critical_angle = 1.6}}},
      {"material.ricochet.critical_angle", {.ricochet = {.critical_angle = -0.1}}},
      {"material.ricochet.critical_angle", {.ricochet = {.critical_angle = kNan}}},
      {"material.ricochet.restitution", {.ricochet = {.critical_angle = 0.3, .restitution = 2}}},
      {"material.ricochet.friction", {.ricochet = {.critical_angle = 0.3, .friction = kNan}}},
      {"material.ricochet.friction", {.ricochet = {.critical_angle = 0.8, .friction = 1}}},
      {"material.density", {.ricochet = {.liquid = true}}},
      {"material.penetration.strength", {.penetration = PonceletDef{}}},
      {"material.penetration.strength", {.penetration = PonceletDef{.inertia = 1}}},
      {"material.penetration.strength", {.penetration = PonceletDef{.strength = -1e6}}},
      {"material.penetration.strength", {.penetration = PonceletDef{.strength = kNan}}},
      {"material.penetration.inertia", {.penetration = PonceletDef{.strength = 1e6, .inertia = -1}}},
      {"material.penetration.crater", {.penetration = PonceletDef{.strength = 1e6, .crater = kInfinity}}},
      {"material.penetration.s_number", {.penetration = YoungDef{}}},
      {"material.penetration.quality", {.penetration = DeMarreDef{.quality = 0}}},
      {"material.penetration.plug", {.penetration = DeMarreDef{.plug = 1.1}}},
      {"material.penetration.coefficient", {.density = 7850, .penetration = LambertDef{.coefficient = kNan}}},
      {"material.density", {.penetration = LambertDef{}}},
      {"material.penetration.speed", {.penetration = BallisticLimitDef{}}},
      {"material.penetration.a", {.penetration = BallisticLimitDef{.speed = 100, .a = 1.2}}},
      {"material.penetration.p", {.penetration = BallisticLimitDef{.speed = 100, .p = 0.5}}},
      {"material.penetration.strength", materials::concrete(-1)},
      {"material.penetration.strength", materials::concrete(kNan)},
      {"material.spread.deflection", {.spread = {.deflection = -0.1}}},
      {"material.spread.yaw", {.spread = {.yaw = kNan}}}};
  for (const auto& [place, material] : bad) {
    const Status status = check_material(material);
    ASSERT_FALSE(status) << place;
    EXPECT_EQ(status.error().place, place) << status.error().text();
    expect_refused(good_impact(), material, place);
    Scene scene;
    EXPECT_FALSE(scene.add_material(material)) << place;
  }
}

TEST(ImpactInput, published_materials_are_sound) {
  for (const Material& material : {materials::water(), materials::concrete(30e6), materials::fir(), materials::oak(),
                                   materials::nickel_steel(), materials::rolled_armour(), materials::aluminium()}) {
    EXPECT_TRUE(check_material(material)) << material.name;
    EXPECT_FALSE(material.name.empty());
  }
}

// Numbers at the ends of what is taken: an answer of numbers, or an error.
TEST(ImpactInput, extreme_numbers_give_numbers) {
  for (const Material& material :
       {Material{}, materials::water(), materials::concrete(30e6), materials::oak(), materials::nickel_steel(),
        materials::rolled_armour(), Material{.penetration = YoungDef{.s_number = 1e-3}},
        Material{.penetration = BallisticLimitDef{.speed = 1e-3, .p = 100}},
        Material{.ricochet = {.critical_angle = 1.5}, .spread = {.deflection = 1.5, .yaw = 1.5}}})
    for (const double mass : {1e-15, 1.0, 1e15})
      for (const double diameter : {1e-9, 0.01, 1e6})
        for (const double speed : {1e-300, 1e-9, 1.0, 1e9})
          for (const double slope : {1e-300, 1e-9, 0.3, 1e9})
            for (const double thickness : {0.0, 1e-9, 1.0, 1e300}) {
              const double cosine = 1 / std::sqrt(1 + slope * slope);
              const Impact hit{.mass = mass,
                               .diameter = diameter,
                               .nose_length = 100,
                               .velocity = {0.99 * speed * cosine, -0.99 * speed * slope * cosine, 0},
                               .thickness = thickness};
              const auto result = must(impact(hit, material));
              EXPECT_TRUE(std::isfinite(length(result.velocity)) && !std::isnan(result.depth) &&
                          !std::isnan(result.energy) && std::isfinite(result.obliquity))
                  << material.name << ' ' << mass << ' ' << diameter << ' ' << speed << ' ' << slope << ' '
                  << thickness;
            }
}

}  // namespace physim::collide_impact_input_test
