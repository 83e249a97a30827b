// Rules about settings of worlds, of what they do with shots, and of what is not for worlds.
#include <algorithm>
#include <cmath>

#include "physim/names.hpp"
#include "scenario/suggest.hpp"
#include "scenario/unread.hpp"

namespace physim {
namespace rules_of_worlds {
namespace {

using R = const Reading&;

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
bool scatters(const Spread& s) {
  return s.horizontal != 0 || s.vertical != 0 || s.speed != 0 || s.position != Vec3d{};
}
std::string why_no_spread(R r) { return read_with(scatters(r.scope.volley->spread), "a spread of the volley"); }
std::string why_no_interval(R r) { return read_unless(r.scope.volley->count == 1, "volley.count = 1"); }

constexpr UnreadRule kWorldRules[] = {
    {"world.ground.height", why_no_ground},
    {"world.ground.restitution", why_no_bounce},
    {"world.ground.friction", why_no_bounce},
    {"world.detail.hysteresis", why_no_detail},
    {"world.detail.layers", why_no_detail},
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
       if (!r.scope.shot->body.use_gravity) return std::string(" beside shot.body.use_gravity = false");
       return read_or(r.any([](const FlownRung& f) { return f.granted.gravity != GravityModel::off; }),
                      ": it feels no gravity");
     }},
    {"shot.body.sleep_speed",
     [](R r) { return read_unless(!r.scope.shot->body.can_sleep, "shot.body.can_sleep = false"); }},
    {"shot.body.sleep_time",
     [](R r) { return read_unless(!r.scope.shot->body.can_sleep, "shot.body.can_sleep = false"); }},
    {"shot.body.despawn.box_low",
     [](R r) { return read_with(r.scope.shot->body.despawn.outside_box, "shot.body.despawn.outside_box"); }},
    {"shot.body.despawn.box_high",
     [](R r) { return read_with(r.scope.shot->body.despawn.outside_box, "shot.body.despawn.outside_box"); }},
    {"shot.body.within_time",
     [](R r) { return read_with(r.scope.shot->cheapest_within.has_value(), "shot.fidelity.cheapest_within"); }},
};

// --------------------------------------------------------------------------------------- shots that emitters fire alone
/// The emitter that fires a shot, which no volley fires; null: none.
const ScenarioEmitter* emitter_of(R r) {
  const std::string& name = r.scope.shot->projectile.name;
  const auto is_of_volley = [&](const Volley& volley) { return volley.shot == name; };
  const auto fires = [&](const ScenarioEmitter& emitter) { return emitter.shot == name || emitter.tracer == name; };
  if (std::ranges::any_of(r.scenario.volleys, is_of_volley)) return nullptr;
  const auto emitter = std::ranges::find_if(r.scenario.emitters, fires);
  return emitter == r.scenario.emitters.end() ? nullptr : &*emitter;
}
std::string why_fired(R r) {
  const ScenarioEmitter* emitter = emitter_of(r);
  return emitter == nullptr ? std::string()
                            : " beside the emitter " + in_quotes(emitter->def.name) + ", which fires it";
}
std::string why_no_sight(R r) {
  const Sight& sight = r.scope.shot->launch.sight;
  return read_with(!r.scenario.world.given || sight.zero_range > 0, "shot.sight.zero_range in a [world]");
}

constexpr UnreadRule kLaunchRules[] = {
    {"shot.speed", why_fired},    {"shot.elevation", why_fired}, {"shot.azimuth", why_fired},
    {"shot.velocity", why_fired}, {"shot.position", why_fired},  {"shot.sight", why_fired},
    {"shot.sight.height", why_no_sight},
};

// -------------------------------------------------------------------------------------------------------------- joints
std::string why_no_spring(R r) {
  const JointKind kind = r.scope.joint->def.kind;
  return read_unless(kind != JointKind::spring, "joint.kind = " + in_quotes(name(kind)));
}
constexpr UnreadRule kJointRules[] = {
    {"joint.stiffness", why_no_spring},
    {"joint.damping", why_no_spring},
    {"joint.restitution",
     [](R r) {
       const JointKind kind = r.scope.joint->def.kind;
       return read_unless(kind != JointKind::cable, "joint.kind = " + in_quotes(name(kind)));
     }},
};

}  // namespace
}  // namespace rules_of_worlds

std::span<const UnreadRule> unread_in_worlds() {
  using namespace rules_of_worlds;
  static const std::vector<UnreadRule> all = [] {
    std::vector<UnreadRule> list;
    for (const std::span<const UnreadRule> part :
         std::initializer_list<std::span<const UnreadRule>>{kWorldRules, kBodyRules, kLaunchRules, kJointRules})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace physim
