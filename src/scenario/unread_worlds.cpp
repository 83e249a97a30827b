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

const Volley& volley(R r) {
  PHYSIM_ASSERT(r.scope.volley != nullptr && r.scope.volley->count >= 1);
  return *r.scope.volley;
}
const ScenarioJoint& joint(R r) {
  PHYSIM_ASSERT(r.scope.joint != nullptr);
  return *r.scope.joint;
}
const WorldDef& world(R r) { return r.scenario.world.def; }
bool is_measured_by_place(const DetailRung& rung) { return std::isfinite(rung.within); }

std::string why_no_ground(R r) {
  const GroundMode mode = world(r).ground.mode;
  return read_unless(mode == GroundMode::none, "world.ground.mode = " + in_quotes(name(mode)));
}
std::string why_no_bounce(R r) {
  const GroundMode mode = world(r).ground.mode;
  return read_unless(mode != GroundMode::bounce, "world.ground.mode = " + in_quotes(name(mode)));
}
std::string why_no_detail(R r) { return read_with(!world(r).detail.rungs.empty(), "world.detail.rungs"); }
bool scatters(const Spread& s) { return s.horizontal != 0 || s.vertical != 0 || s.speed != 0 || s.position != Vec3d{}; }
std::string why_no_spread(R r) { return read_with(scatters(volley(r).spread), "a spread of the volley"); }
std::string why_no_interval(R r) { return read_unless(volley(r).count == 1, "volley.count = 1"); }

/// Settings of real time are for programs that show a world as it goes on.
std::string why_no_real_time(R) { return " in a run: only programs that step the world in real time read it"; }

constexpr UnreadRule kWorldRules[] = {
    {"world.time_scale", why_no_real_time, true},
    {"world.max_steps", why_no_real_time, true},
    {"world.ground.height", why_no_ground},
    {"world.ground.restitution", why_no_bounce},
    {"world.ground.friction", why_no_bounce},
    {"world.ground.combine", why_no_bounce},
    {"world.ground.conveyor", why_no_bounce},
    {"world.detail.hysteresis", why_no_detail},
    {"world.detail.layers",
     [](R r) {
       if (std::string why = why_no_detail(r); !why.empty()) return why;
       const std::uint32_t layers = world(r).detail.layers;
       const bool has_others = std::ranges::any_of(
           r.scenario.shots, [&](const ScenarioShot& shot) { return (shot.body.layers & layers) == 0; });
       return read_or(has_others, " but that of all layers: every shot.body.layers has one of them");
     }},
    {"world.observer",
     [](R r) {
       if (std::string why = why_no_detail(r); !why.empty()) return why;
       return read_with(std::ranges::any_of(world(r).detail.rungs, is_measured_by_place), "world.detail.rungs.within");
     }},
    {"volley.interval", why_no_interval},
    {"volley.rate", why_no_interval},
    {"volley.seed", why_no_spread},
    {"volley.spread.shape", why_no_spread},
};

constexpr UnreadRule kBodyRules[] = {
    {"shot.body.gravity_scale",
     [](R r) {
       if (!r.shot().body.use_gravity) return std::string(" beside shot.body.use_gravity = false");
       return read_or(r.any([](const FlownRung& f) { return f.granted.gravity != GravityModel::off; }),
                      ": it feels no gravity");
     }},
    {"shot.body.sleep_speed", [](R r) { return read_unless(!r.shot().body.can_sleep, "shot.body.can_sleep = false"); }},
    {"shot.body.sleep_time", [](R r) { return read_unless(!r.shot().body.can_sleep, "shot.body.can_sleep = false"); }},
    {"shot.body.despawn.box_low",
     [](R r) { return read_with(r.shot().body.despawn.outside_box, "shot.body.despawn.outside_box"); }},
    {"shot.body.despawn.box_high",
     [](R r) { return read_with(r.shot().body.despawn.outside_box, "shot.body.despawn.outside_box"); }},
    {"shot.body.within_time",
     [](R r) { return read_with(r.shot().cheapest_within.has_value(), "shot.fidelity.cheapest_within"); }},
};

// --------------------------------------------------------------------------------------- shots that emitters fire
// alone
const ScenarioEmitter* emitter_of(R r) { return emitter_alone_of(r.scenario, r.shot().projectile.name); }
std::string why_fired(R r) {
  const ScenarioEmitter* emitter = emitter_of(r);
  return emitter == nullptr ? std::string()
                            : " beside the emitter " + in_quotes(emitter->def.name) + ", which fires it";
}
std::string why_no_sight(R r) {
  const Sight& sight = r.shot().launch.sight;
  return read_with(!r.scenario.world.given || sight.zero_range > 0, "shot.sight.zero_range in a [world]");
}

/// A launcher turns about the line of sight: a bore along it stays where it is, and so does a sight without height.
std::string why_no_elevation(R r) {
  const Launch& launch = r.shot().launch;
  const bool is_drawn = r.is_drawn("shot.elevation") || r.is_drawn("shot.sight");
  const bool is_raised = launch.elevation != launch.sight.look_angle || launch.sight.zero_range > 0 || is_drawn;
  const bool is_turned = r.any([](const FlownRung& f) { return turns(f.granted); });  // by its attitude
  if (is_raised || is_turned || launch.velocity) return {};
  if (r.scenario.world.given) return ": the bore points along the line of sight";
  return read_or(launch.sight.height != 0, ": the bore points along the line of sight, and the sight has no height");
}

std::string why_no_look(R r) {
  const Sight& sight = r.shot().launch.sight;
  return read_with(!r.scenario.world.given || sight.cant != 0 || sight.zero_range > 0,
                   "shot.sight.cant or zero_range in a [world]");
}
std::string why_frozen(R r) {
  const Axes frozen = r.shot().body.frozen;
  const double azimuth = r.shot().launch.azimuth;
  const bool is_free = !has(frozen, Axes::x) || !has(frozen, Axes::y) || (azimuth != 0 && !has(frozen, Axes::z));
  return read_unless(r.scenario.world.given && !is_free, "shot.body.frozen");
}

constexpr UnreadRule kLaunchRules[] = {
    {"shot.speed", why_frozen},
    {"shot.speed", why_fired},
    {"shot.elevation", why_fired},
    {"shot.azimuth", why_fired},
    {"shot.velocity", why_fired},
    {"shot.position", why_fired},
    {"shot.sight", why_fired},
    {"shot.sight.height", why_no_sight},
    {"shot.sight.look_angle", why_no_look},
    {"shot.sight.cant", why_no_elevation},
};

// -------------------------------------------------------------------------------------------------------------- joints
std::string why_no_spring(R r) {
  const JointKind kind = joint(r).def.kind;
  return read_unless(kind != JointKind::spring, "joint.kind = " + in_quotes(name(kind)));
}
std::string why_no_axis(R r) {
  const JointKind kind = joint(r).def.kind;
  return read_unless(!row_of(kind).turns && !row_of(kind).slides, "joint.kind = " + in_quotes(name(kind)));
}
std::string why_no_hinge(R r) {
  const JointKind kind = joint(r).def.kind;
  return read_unless(!row_of(kind).turns, "joint.kind = " + in_quotes(name(kind)));
}
std::string why_no_slider(R r) {
  const JointKind kind = joint(r).def.kind;
  return read_unless(!row_of(kind).slides, "joint.kind = " + in_quotes(name(kind)));
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

/// A spring whose only shot is the one at its other end.
std::string why_on_itself(R r) {
  const ScenarioForce& force = *r.scope.force;
  const bool has_another =
      force.layers != 0 || force.shots.empty() ||
      std::ranges::any_of(force.shots, [&](const std::string& shot) { return shot != force.other; });
  return read_or(has_another, ": the only shot that it acts on is the one at its other end");
}

constexpr UnreadRule kForceRules[] = {
    {"force",
     [](R r) { return read_or(is_felt(r, *r.scope.force), ": no shot with motion \"force\" that moves feels it"); }},
    {"force.layers",
     [](R r) {
       const std::uint32_t layers = r.scope.force->layers;
       const bool has_some = std::ranges::any_of(
           r.scenario.shots, [&](const ScenarioShot& shot) { return (shot.body.layers & layers) != 0; });
       return read_or(has_some || r.scope.force->shots.empty(), ": no shot.body.layers has one of them");
     }},
    {"force.spring", why_on_itself},
    {"force.bungee", why_on_itself},
};

constexpr UnreadRule kJointRules[] = {
    {"joint",
     [](R r) { return read_or(is_moved(r, joint(r).a) || is_moved(r, joint(r).b), ": nothing moves its ends"); }},
    {"joint.stiffness", why_no_spring},
    {"joint.damping", why_no_spring},
    {"joint.axis", why_no_axis},
    {"joint.reference", why_no_hinge},
    {"joint.low_angle", why_no_hinge},
    {"joint.high_angle", why_no_hinge},
    {"joint.low", why_no_slider},
    {"joint.high", why_no_slider},
    {"joint.velocity",
     [](R r) { return read_unless(!joint(r).b.empty() || !joint(r).thing.empty(), "its other end"); }},
    {"joint.restitution",
     [](R r) {
       const JointKind kind = joint(r).def.kind;
       return read_unless(kind != JointKind::cable, "joint.kind = " + in_quotes(name(kind)));
     }},
};

}  // namespace
}  // namespace rules_of_worlds

std::span<const UnreadRule> unread_in_worlds() {
  using namespace rules_of_worlds;
  static const std::vector<UnreadRule> all = [] {
    std::vector<UnreadRule> list;
    for (const std::span<const UnreadRule> part : std::initializer_list<std::span<const UnreadRule>>{
             kWorldRules, kBodyRules, kLaunchRules, kForceRules, kJointRules})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace physim
