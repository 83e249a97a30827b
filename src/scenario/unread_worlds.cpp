// Rules about settings of worlds, of what they do with shots, and of what is not for worlds.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/joint_table.hpp"
#include "model/rotor.hpp"
#include "physim/names.hpp"
#include "scenario/suggest.hpp"
#include "scenario/unread.hpp"

namespace physim {
namespace rules_of_worlds {
namespace {

using R = const Reading&;

const ScenarioJoint& joint(R r) {
  PHYSIM_ASSERT(r.scope.joint != nullptr);
  return *r.scope.joint;
}
const WorldDef& world(R r) { return r.scenario.world.def; }
GroundMode ground(R r) { return world(r).ground.mode; }
JointKind kind(R r) { return joint(r).def.kind; }
std::string name_of_ground(R r) { return in_quotes(name(ground(r))); }
std::string name_of_kind(R r) { return in_quotes(name(kind(r))); }
bool scatters(const Spread& s) { return s.horizontal != 0 || s.vertical != 0 || s.speed != 0 || s.position != Vec3d{}; }
/// The emitter that fires a shot, which nothing else does; null: none.
const ScenarioEmitter* emitter_of(R r) { return emitter_alone_of(r.scenario, r.shot().projectile.name); }

/// A launcher turns about the line of sight: a bore along it stays where it is ...
bool is_elevated(R r) {
  const Launch& launch = r.shot().launch;
  const bool is_drawn = r.is_drawn("shot.elevation") || r.is_drawn("shot.sight");
  const bool is_raised = launch.elevation != launch.sight.look_angle || launch.sight.zero_range > 0 || is_drawn;
  const bool is_turned = r.any([](const FlownRung& f) { return turns(f.granted); });  // by its attitude
  return is_raised || is_turned || launch.velocity;
}
bool is_free_of_bore(R r) {
  const Axes frozen = r.shot().body.frozen;
  const double azimuth = r.shot().launch.azimuth;
  const bool is_free = !has(frozen, Axes::x) || !has(frozen, Axes::y) || (azimuth != 0 && !has(frozen, Axes::z));
  return is_free || !r.scenario.world.given;
}
bool is_moved(R r, const std::string& end) {
  return std::ranges::any_of(r.scenario.shots, [&](const ScenarioShot& each) {
    return each.projectile.name == end && !is_unmoved(each.body);
  });
}
/// Whether a force acts on a shot that it can move.
bool is_felt(R r, const ScenarioForce& force) {
  return r.any([&](const FlownRung& f) {
    const ScenarioShot& fired = *f.shot;
    const bool is_all = force.shots.empty() && force.layers == 0;
    const bool is_of_it =
        is_all || std::ranges::count(force.shots, fired.projectile.name) > 0 || (force.layers & fired.body.layers) != 0;
    return is_of_it && f.granted.motion == Motion::force && !is_unmoved(fired.body);
  });
}

constexpr UnreadRule kWorldRules[] = {
    // --------------------------------------------------------------------------------------------- worlds and volleys
    described({"world.time_scale world.max_steps", [](R) { return false; },
               " in a run: only programs that step the world in real time read it"}),
    {"world.ground.height", [](R r) { return ground(r) != GroundMode::none; },
     " beside world.ground.mode = ", name_of_ground},
    {"world.ground.restitution world.ground.friction world.ground.combine world.ground.conveyor",
     [](R r) { return ground(r) == GroundMode::bounce; }, " beside world.ground.mode = ", name_of_ground},
    {"world.detail.hysteresis world.detail.layers world.observer", [](R r) { return !world(r).detail.rungs.empty(); },
     " without world.detail.rungs"},
    {"world.detail.layers",
     [](R r) {
       const auto has_others = [&](const ScenarioShot& shot) {
         return (shot.body.layers & world(r).detail.layers) == 0;
       };
       return std::ranges::any_of(r.scenario.shots, has_others);
     },
     " but that of all layers: every shot.body.layers has one of them"},
    {"world.observer",
     [](R r) {
       const auto is_by_place = [](const DetailRung& rung) { return std::isfinite(rung.within); };
       return std::ranges::any_of(world(r).detail.rungs, is_by_place);
     },
     " without world.detail.rungs.within"},
    {"volley.interval volley.rate", [](R r) { return r.scope.volley->count != 1; }, " beside volley.count = 1"},
    {"volley.seed volley.spread.shape", [](R r) { return scatters(r.scope.volley->spread); },
     " without a spread of the volley"},

    // ---------------------------------------------------------------------------------------------------------- bodies
    {"shot.body.gravity_scale", [](R r) { return r.shot().body.use_gravity; }, " beside shot.body.use_gravity = false"},
    {"shot.body.gravity_scale",
     [](R r) { return r.any([](const FlownRung& f) { return f.granted.gravity != GravityModel::off; }); },
     ": it feels no gravity"},
    {"shot.body.sleep_speed shot.body.sleep_time", [](R r) { return r.shot().body.can_sleep; },
     " beside shot.body.can_sleep = false"},
    {"shot.body.despawn.box_low shot.body.despawn.box_high", [](R r) { return r.shot().body.despawn.outside_box; },
     " without shot.body.despawn.outside_box"},
    {"shot.body.within_time", [](R r) { return r.shot().cheapest_within.has_value(); },
     " without shot.fidelity.cheapest_within"},

    // -------------------------------------------------------------------------------------------------------- launches
    {"shot.speed", is_free_of_bore, " beside shot.body.frozen"},
    {"shot.speed shot.elevation shot.azimuth shot.velocity shot.position shot.sight",
     [](R r) { return emitter_of(r) == nullptr; }, " beside the emitter ",
     [](R r) { return in_quotes(emitter_of(r)->def.name) + ", which fires it"; }},
    {"shot.sight.height", [](R r) { return !r.scenario.world.given || r.shot().launch.sight.zero_range > 0; },
     " without shot.sight.zero_range in a [world]"},
    {"shot.sight.look_angle",
     [](R r) {
       const Sight& sight = r.shot().launch.sight;
       return !r.scenario.world.given || sight.cant != 0 || sight.zero_range > 0;
     },
     " without shot.sight.cant or zero_range in a [world]"},
    {"shot.sight.cant", [](R r) { return !r.scenario.world.given || is_elevated(r); },
     ": the bore points along the line of sight"},
    // ... and so does a sight without height.
    {"shot.sight.cant", [](R r) { return is_elevated(r) || r.shot().launch.sight.height != 0; },
     ": the bore points along the line of sight, and the sight has no height"},

    // ------------------------------------------------------------------------------------------------------ forces
    {"force", [](R r) { return is_felt(r, *r.scope.force); }, ": no shot with motion \"force\" that moves feels it"},
    {"force.layers",
     [](R r) {
       const auto has_one = [&](const ScenarioShot& shot) { return (shot.body.layers & r.scope.force->layers) != 0; };
       return std::ranges::any_of(r.scenario.shots, has_one) || r.scope.force->shots.empty();
     },
     ": no shot.body.layers has one of them"},
    {"force.spring force.bungee",
     [](R r) {
       const ScenarioForce& force = *r.scope.force;
       const auto is_another = [&](const std::string& shot) { return shot != force.other; };
       return force.layers != 0 || force.shots.empty() || std::ranges::any_of(force.shots, is_another);
     },
     ": the only shot that it acts on is the one at its other end"},

    // ---------------------------------------------------------------------------------------------------------- joints
    {"joint", [](R r) { return is_moved(r, joint(r).a) || is_moved(r, joint(r).b); }, ": nothing moves its ends"},
    {"joint.stiffness joint.damping", [](R r) { return kind(r) == JointKind::spring; },
     " beside joint.kind = ", name_of_kind},
    {"joint.axis", [](R r) { return row_of(kind(r)).turns || row_of(kind(r)).slides; },
     " beside joint.kind = ", name_of_kind},
    {"joint.reference joint.low_angle joint.high_angle", [](R r) { return row_of(kind(r)).turns; },
     " beside joint.kind = ", name_of_kind},
    {"joint.low joint.high", [](R r) { return row_of(kind(r)).slides; }, " beside joint.kind = ", name_of_kind},
    {"joint.velocity", [](R r) { return joint(r).b.empty() && joint(r).thing.empty(); }, " beside its other end"},
    {"joint.restitution", [](R r) { return kind(r) == JointKind::cable; }, " beside joint.kind = ", name_of_kind},
};

}  // namespace
}  // namespace rules_of_worlds

std::span<const UnreadRule> unread_in_worlds() { return rules_of_worlds::kWorldRules; }

}  // namespace physim
