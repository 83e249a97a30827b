// Rules about settings of materials, shapes, things and of how shots meet them.
#include <algorithm>
#include <type_traits>

#include "base/assert.hpp"
#include "scenario/suggest.hpp"
#include "scenario/unread.hpp"

namespace physim {
namespace rules_of_scenes {
namespace {

using R = const Reading&;

bool is_used_shape(const Scenario& scenario, const std::string& name) {
  PHYSIM_ASSERT(!name.empty());  // given or made up by now
  const auto is_of_part = [&](const ScenarioPart& part) { return part.shape == name; };
  return std::ranges::any_of(scenario.things, [&](const ScenarioThing& thing) { return thing.shape == name; }) ||
         std::ranges::any_of(scenario.emitters, [&](const ScenarioEmitter& e) { return e.surface_of == name; }) ||
         std::ranges::any_of(scenario.shapes,
                             [&](const ScenarioShape& shape) { return std::ranges::any_of(shape.parts, is_of_part); });
}
bool is_used_material(const Scenario& scenario, const std::string& name) {
  PHYSIM_ASSERT(!name.empty());
  const auto is_of_part = [&](const ScenarioPart& part) { return part.material == name; };
  const auto is_of_shape = [&](const ScenarioShape& shape) {
    return std::ranges::any_of(shape.parts, is_of_part) || std::ranges::count(shape.materials, name) > 0;
  };
  return std::ranges::any_of(scenario.things, [&](const ScenarioThing& thing) { return thing.material == name; }) ||
         std::ranges::any_of(scenario.shapes, is_of_shape);
}

/// Whether some shot may do this where it meets a thing.
bool may(R r, std::initializer_list<OnHit> what) {
  return std::ranges::any_of(r.scenario.shots, [&](const ScenarioShot& shot) {
    return std::ranges::find(what, shot.body.collision.on_hit) != what.end();
  });
}
bool bounces(R r) { return may(r, {OnHit::bounce, OnHit::impact}); }
std::string why_no_bounce(R r) { return read_by(bounces(r), "shots with on_hit \"bounce\" and \"impact\" read"); }
std::string why_no_impact(R r) { return read_by(may(r, {OnHit::impact}), "shots with on_hit \"impact\" read"); }

bool is_turned(const ScenarioRotation& rotation) { return rotation.angle != 0; }

constexpr UnreadRule kMaterialRules[] = {
    {"material",
     [](R r) { return read_or(is_used_material(r.scenario, r.scope.material->name), ": no thing is made of it"); }},
    {"material.restitution", why_no_bounce},
    {"material.friction", why_no_bounce},
    {"material.combine", why_no_bounce},
    {"material.grip_restitution",
     [](R r) {
       if (std::string why = why_no_bounce(r); !why.empty()) return why;
       const auto is_ball = [](const ScenarioShot& shot) { return shot.body.collision.radius > 0; };
       return read_with(std::ranges::any_of(r.scenario.shots, is_ball), "shot.body.collision.radius");
     }},
    {"material.density",
     [](R r) {
       const Material& material = *r.scope.material;
       const bool goes_in = !std::holds_alternative<ImpenetrableDef>(material.penetration);
       return read_with(goes_in || material.ricochet.liquid, "a law of penetration, and without ricochet.liquid");
     }},
    {"material.ricochet", why_no_impact},
    {"material.ricochet.restitution",
     [](R r) {
       const auto& ricochet = r.scope.material->ricochet;
       return read_with(ricochet.critical_angle > 0 && !ricochet.liquid, "material.ricochet.critical_angle");
     }},
    {"material.ricochet.friction",
     [](R r) {
       const auto& ricochet = r.scope.material->ricochet;
       return read_with(ricochet.critical_angle > 0 && !ricochet.liquid, "material.ricochet.critical_angle");
     }},
    {"material.ricochet.critical_angle",
     [](R r) { return read_unless(r.scope.material->ricochet.liquid, "material.ricochet.liquid"); }},
    {"material.penetration", why_no_impact},
    {"material.poncelet", why_no_impact},
    {"material.young", why_no_impact},
    {"material.de_marre", why_no_impact},
    {"material.lambert", why_no_impact},
    {"material.ballistic_limit", why_no_impact},
    {"material.spread", why_no_impact},
};

constexpr UnreadRule kThingRules[] = {
    {"shape", [](R r) { return read_or(is_used_shape(r.scenario, r.scope.shape->name), ": no thing has it"); }},
    {"shape.compound.rotation.axis",
     [](R r) { return read_with(is_turned(r.scope.part->rotation), "shape.compound.rotation.angle"); }},
    {"thing.rotation.axis", [](R r) { return read_with(is_turned(r.scope.thing->rotation), "thing.rotation.angle"); }},
    {"thing.keys.rotation.axis",
     [](R r) { return read_with(is_turned(r.scope.key->rotation), "thing.keys.rotation.angle"); }},
    {"thing.start",
     [](R r) {
       const ScenarioThing& thing = *r.scope.thing;
       return read_with(thing.velocity != Vec3d{} || thing.angular_velocity != Vec3d{},
                        "thing.velocity or angular_velocity");
     }},
    {"thing.layers",
     [](R r) {
       const auto takes_all = [](const ScenarioShot& shot) { return shot.body.collision.layers == 0xffffffff; };
       const bool is_read = r.scope.thing->layers == 0 || !std::ranges::all_of(r.scenario.shots, takes_all);
       return read_or(is_read, ": shots meet things of all layers");
     }},
    {"thing.conveyor", why_no_bounce},
    {"thing.curve", [](R r) { return read_with(!r.scope.thing->keys.empty(), "thing.keys"); }},
    {"thing.keys.velocity",
     [](R r) { return read_with(r.scope.thing->curve == MotionCurve::smooth, "thing.curve = \"smooth\""); }},
};

// ------------------------------------------------------------------------------------------------ how a shot meets
// them
bool has_things(R r) { return !r.scenario.things.empty(); }
bool has_bouncy_ground(R r) { return r.scenario.world.given && r.scenario.world.def.ground.mode == GroundMode::bounce; }
const CollisionDef& collision(R r) {
  PHYSIM_ASSERT(r.scope.shot != nullptr);
  return r.scope.shot->body.collision;
}
bool bounces_itself(R r) {
  return has_things(r) && (collision(r).on_hit == OnHit::bounce || collision(r).on_hit == OnHit::impact);
}
/// It bounces off something: ground, things or other projectiles.
bool may_bounce(R r) { return has_bouncy_ground(r) || bounces_itself(r) || collision(r).others != 0; }
std::string why_no_turning(R r) {
  return read_with(r.scope.shot->body.angular_velocity != Vec3d{} || may_be_turned(r), "shot.body.angular_velocity");
}
std::string why_no_things(R r) { return read_with(has_things(r), "a [[thing]]"); }
std::string why_no_contact(R r) { return read_or(may_bounce(r), ": it bounces off nothing"); }

constexpr UnreadRule kContactRules[] = {
    {"shot.body.restitution", why_no_contact},
    {"shot.body.friction", why_no_contact},
    {"shot.body.rolling_resistance", why_no_contact},
    {"shot.body.combine", why_no_contact},
    {"shot.body.angular_drag", why_no_turning},
    {"shot.body.frozen_rotation", why_no_turning},
    {"shot.body.collision.on_hit",
     [](R r) {
       return read_with(has_things(r) || collision(r).others != 0, "a [[thing]] or shot.body.collision.others");
     }},
    {"shot.body.collision.layers", why_no_things},
    {"shot.body.collision.radius",
     [](R r) {
       return read_with(has_things(r) || collision(r).others != 0, "a [[thing]] or shot.body.collision.others");
     }},
    {"shot.body.collision.inertia",
     [](R r) { return read_with(may_be_turned(r), "shot.body.collision.radius and something that turns a ball"); }},
};

}  // namespace
}  // namespace rules_of_scenes

bool may_be_turned(const Reading& r) {
  const CollisionDef& collision = rules_of_scenes::collision(r);
  return collision.radius > 0 && (rules_of_scenes::bounces_itself(r) || collision.others != 0);
}

std::span<const UnreadRule> unread_in_scenes() {
  using namespace rules_of_scenes;
  static const std::vector<UnreadRule> all = [] {
    std::vector<UnreadRule> list(std::begin(kMaterialRules), std::end(kMaterialRules));
    list.insert(list.end(), std::begin(kThingRules), std::end(kThingRules));
    list.insert(list.end(), std::begin(kContactRules), std::end(kContactRules));
    return list;
  }();
  return all;
}

}  // namespace physim
