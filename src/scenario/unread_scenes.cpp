// Rules about settings of materials, shapes, things and of how shots meet them.
#include <algorithm>

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
bool is_turned(const ScenarioRotation& rotation) { return rotation.angle != 0; }

bool has_things(R r) { return !r.scenario.things.empty(); }
const RicochetDef& ricochet(R r) { return r.scope.material->ricochet; }

// ------------------------------------------------------------------------------------------- how a shot meets things
const CollisionDef& collision(R r) {
  PHYSIM_ASSERT(r.scope.shot != nullptr);
  return r.scope.shot->body.collision;
}
bool bounces_itself(R r) {
  return has_things(r) && (collision(r).on_hit == OnHit::bounce || collision(r).on_hit == OnHit::impact);
}
/// It bounces off something: ground, things or other projectiles.
bool may_bounce(R r) {
  const bool has_bouncy_ground = r.scenario.world.given && r.scenario.world.def.ground.mode == GroundMode::bounce;
  return has_bouncy_ground || bounces_itself(r) || collision(r).others != 0;
}

constexpr UnreadRule kSceneRules[] = {
    // ------------------------------------------------------------------------------------------------------ materials
    {"material", [](R r) { return is_used_material(r.scenario, r.scope.material->name); }, ": no thing is made of it"},
    {"material.restitution material.friction material.combine material.grip_restitution thing.conveyor", bounces,
     ": only shots with on_hit \"bounce\" and \"impact\" read it"},
    {"material.grip_restitution",
     [](R r) {
       const auto is_ball = [](const ScenarioShot& shot) { return shot.body.collision.radius > 0; };
       return std::ranges::any_of(r.scenario.shots, is_ball);
     },
     " without shot.body.collision.radius"},
    {"material.density",
     [](R r) { return ricochet(r).liquid || !std::holds_alternative<ImpenetrableDef>(r.scope.material->penetration); },
     " without a law of penetration, and without ricochet.liquid"},
    {"material.ricochet material.penetration material.poncelet material.young material.de_marre material.lambert "
     "material.ballistic_limit material.spread",
     [](R r) { return may(r, {OnHit::impact}); }, ": only shots with on_hit \"impact\" read it"},
    {"material.ricochet.restitution material.ricochet.friction",
     [](R r) { return ricochet(r).critical_angle > 0 && !ricochet(r).liquid; },
     " without material.ricochet.critical_angle"},
    {"material.ricochet.critical_angle", [](R r) { return !ricochet(r).liquid; }, " beside material.ricochet.liquid"},

    // ---------------------------------------------------------------------------------------------- shapes and things
    {"shape", [](R r) { return is_used_shape(r.scenario, r.scope.shape->name); }, ": no thing has it"},
    {"shape.compound.rotation.axis", [](R r) { return is_turned(r.scope.part->rotation); },
     " without shape.compound.rotation.angle"},
    {"thing.rotation.axis", [](R r) { return is_turned(r.scope.thing->rotation); }, " without thing.rotation.angle"},
    {"thing.keys.rotation.axis", [](R r) { return is_turned(r.scope.key->rotation); },
     " without thing.keys.rotation.angle"},
    {"thing.start",
     [](R r) { return r.scope.thing->velocity != Vec3d{} || r.scope.thing->angular_velocity != Vec3d{}; },
     " without thing.velocity or angular_velocity"},
    {"thing.layers",
     [](R r) {
       const auto takes_all = [](const ScenarioShot& shot) { return shot.body.collision.layers == 0xffffffff; };
       return r.scope.thing->layers == 0 || !std::ranges::all_of(r.scenario.shots, takes_all);
     },
     ": shots meet things of all layers"},
    {"thing.layers", [](R r) { return r.scope.thing->layers != 0; }, " but that no shot meets it"},
    {"thing.conveyor", [](R r) { return !r.scope.thing->sensor; }, " beside thing.sensor = true"},
    {"thing.curve", [](R r) { return !r.scope.thing->keys.empty(); }, " without thing.keys"},
    {"thing.keys.velocity", [](R r) { return r.scope.thing->curve == MotionCurve::smooth; },
     " without thing.curve = \"smooth\""},

    // ------------------------------------------------------------------------------------------------------- contacts
    {"shot.body.restitution shot.body.friction shot.body.rolling_resistance shot.body.combine", may_bounce,
     ": it bounces off nothing"},
    {"shot.body.angular_drag shot.body.frozen_rotation",
     [](R r) { return r.scope.shot->body.angular_velocity != Vec3d{} || may_be_turned(r); },
     " without shot.body.angular_velocity"},
    {"shot.body.collision.on_hit shot.body.collision.radius",
     [](R r) { return has_things(r) || collision(r).others != 0; },
     " without a [[thing]] or shot.body.collision.others"},
    {"shot.body.collision.layers", has_things, " without a [[thing]]"},
    {"shot.body.collision.layers",
     [](R r) {
       const std::uint32_t layers = collision(r).layers;
       const auto has_one = [&](const ScenarioThing& thing) { return (thing.layers & layers) != 0; };
       return layers == 0 || std::ranges::any_of(r.scenario.things, has_one);
     },
     " but that it meets no thing: no thing.layers has one of them"},
    {"shot.body.collision.inertia", may_be_turned,
     " without shot.body.collision.radius and something that turns a ball"},
};

}  // namespace
}  // namespace rules_of_scenes

bool may_be_turned(const Reading& r) {
  const CollisionDef& collision = rules_of_scenes::collision(r);
  return collision.radius > 0 && (rules_of_scenes::bounces_itself(r) || collision.others != 0);
}

std::span<const UnreadRule> unread_in_scenes() { return rules_of_scenes::kSceneRules; }

}  // namespace physim
