// Rules about settings of emitters.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/emit_shape_table.hpp"
#include "physim/names.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/unread.hpp"

namespace physim {

bool has_own_fire(const EmitterDef& e) {
  const bool has_rate = e.per_second.value != 0 || e.per_second.to || e.per_metre != 0;
  return has_rate || !e.bursts.empty() || e.gun.rounds_per_minute > 0 || e.rain.density > 0;
}

namespace rules_of_emitters {
namespace {

using R = const Reading&;

const ScenarioEmitter& emitter(R r) {
  PHYSIM_ASSERT(r.scope.emitter != nullptr);
  return *r.scope.emitter;
}
const EmitterDef& def(R r) { return emitter(r).def; }

/// Whether the place of an emitter moves. An emitter that only turns has no velocity.
bool moves(R r) {
  const ScenarioMotion& motion = emitter(r).motion;
  return !motion.keys.empty() || motion.velocity != Vec3d{} || !emitter(r).follows.empty();
}
bool varies(const DrawnNumber& number) { return !number.curve.empty() || !number.to_curve.empty(); }
/// Whether it fires by itself, not only as the sub of others.
bool fires(R r) { return def(r).cycle.plays && has_own_fire(def(r)); }
/// An emitter that fires only as a sub of others fires at the places of their particles.
std::string why_not_its_own_place(R r) {
  const auto names_it = [&](const ScenarioEmitter& other) {
    return std::ranges::any_of(other.subs, [&](const ScenarioSub& sub) { return sub.emitter == def(r).name; });
  };
  const bool is_sub = std::ranges::any_of(r.scenario.emitters, names_it);
  return read_or(!is_sub || fires(r) || !def(r).cycle.plays, ": the emitter fires only as the sub of others");
}
/// Whether something of it goes over the cycle.
bool reads_cycle(R r) {
  const EmitterDef& e = def(r);
  const ParticleStart& s = e.start;
  return !e.cycle.looping || e.cycle.prewarm || !e.bursts.empty() || varies(e.per_second) || varies(s.lifetime) ||
         varies(s.speed) || varies(s.size) || varies(s.size_y) || varies(s.size_z) || varies(s.rotation) ||
         varies(s.rotation_y) || varies(s.rotation_z) || varies(s.gravity) || !s.colour.gradient.empty();
}
std::string why_it_is_still(R r) { return read_or(moves(r), ": the emitter does not move"); }
std::string why_no_gun(R r) { return read_with(def(r).gun.rounds_per_minute > 0, "emitter.gun.rounds_per_minute"); }
std::string why_no_rain(R r) { return read_with(def(r).rain.density > 0, "emitter.rain.density"); }

constexpr UnreadRule kPlaceRules[] = {
    {"emitter.position",
     [](R r) {
       if (std::string why = why_not_its_own_place(r); !why.empty()) return why;
       return read_unless(!emitter(r).follows.empty(), "emitter.follows");
     }},
    {"emitter.follows", why_not_its_own_place},
    {"emitter.motion.velocity", why_not_its_own_place},
    {"emitter.motion.keys.position", why_not_its_own_place},
    {"emitter.rotation.axis", [](R r) { return read_with(emitter(r).rotation.angle != 0, "emitter.rotation.angle"); }},
    {"emitter.motion.start",
     [](R r) {
       const ScenarioMotion& motion = emitter(r).motion;
       return read_with(motion.velocity != Vec3d{} || motion.angular_velocity != Vec3d{},
                        "emitter.motion.velocity or angular_velocity");
     }},
    {"emitter.motion.curve", [](R r) { return read_with(!emitter(r).motion.keys.empty(), "emitter.motion.keys"); }},
    {"emitter.motion.keys.velocity",
     [](R r) {
       if (std::string why = why_not_its_own_place(r); !why.empty()) return why;
       return read_with(emitter(r).motion.curve == MotionCurve::smooth, "emitter.motion.curve = \"smooth\"");
     }},
    {"emitter.inherit_velocity", why_it_is_still},
    {"emitter.per_metre", why_it_is_still},
    {"emitter.bursts.interval",
     [](R r) {
       PHYSIM_ASSERT(r.scope.burst != nullptr);
       return read_with(r.scope.burst->cycles != 1, "emitter.bursts.cycles: the burst comes once");
     }},
    {"emitter.bursts.time",
     [](R r) {
       const EmitterDef& e = def(r);
       PHYSIM_ASSERT(r.scope.burst != nullptr && !e.bursts.empty());
       const Burst& burst = *r.scope.burst;
       return read_or(burst.time < e.cycle.duration, ": burst " + std::to_string(&burst - e.bursts.data() + 1) +
                                                         " is due at " + quantity_text(burst.time, Quantity::time) +
                                                         ", and the cycle ends before, see emitter.cycle.duration = " +
                                                         quantity_text(e.cycle.duration, Quantity::time));
     }},
    {"emitter.cycle.plays",
     [](R r) {
       return read_or(has_own_fire(def(r)), ": the emitter has no rate, burst, gun or rain to fire by itself");
     }},
    {"emitter.cycle.duration",
     [](R r) {
       return read_or(reads_cycle(r), ": cycles that loop without bursts and curves are one like the other");
     }},
};

/// Rules of all settings of a cycle but `plays`, which says that an emitter fires only as a sub.
std::vector<UnreadRule> rules_of_cycle() {
  std::vector<UnreadRule> rules;
  for (const SchemaNode& node : find_node("emitter.cycle")->children)
    if (node.name != "plays")
      rules.push_back({node.path, [](R r) {
                         return read_or(fires(r), ": the emitter fires only as the sub of others, or not at all");
                       }});
  PHYSIM_ASSERT(!rules.empty());
  return rules;
}

constexpr UnreadRule kGunRules[] = {
    {"emitter.gun", why_no_gun},
    {"emitter.gun.burst_rounds",
     [](R r) {
       const GunDef& gun = def(r).gun;
       return read_with(gun.burst_pause > 0 || gun.recoil != 0, "emitter.gun.burst_pause or recoil");
     }},
    {"emitter.gun.burst_pause", [](R r) { return read_with(def(r).gun.burst_rounds > 0, "emitter.gun.burst_rounds"); }},
    {"emitter.gun.reload", [](R r) { return read_with(def(r).gun.magazine > 0, "emitter.gun.magazine"); }},
    {"emitter.gun.magazines", [](R r) { return read_with(def(r).gun.magazine > 0, "emitter.gun.magazine"); }},
    {"emitter.gun.convergence", [](R r) { return read_with(!def(r).gun.barrels.empty(), "emitter.gun.barrels"); }},
    {"emitter.gun.recoil",
     [](R r) {
       return read_with(!def(r).gun.recoil_up.empty() || !def(r).gun.recoil_right.empty(),
                        "emitter.gun.recoil_up or recoil_right");
     }},
    {"emitter.gun.recoil_up", [](R r) { return read_with(def(r).gun.recoil != 0, "emitter.gun.recoil"); }},
    {"emitter.gun.recoil_right", [](R r) { return read_with(def(r).gun.recoil != 0, "emitter.gun.recoil"); }},
    {"emitter.rain.size", why_no_rain},
    {"emitter.rain.drift", why_no_rain},
    {"emitter.rain.shelter",
     [](R r) {
       if (std::string why = why_no_rain(r); !why.empty()) return why;
       return read_with(!r.scenario.things.empty(), "a [[thing]]");
     }},
};

// -------------------------------------------------------------------------------------------------------------- shapes
template <FromMember member>
std::string why_unread(R r) {
  const EmitShape shape = def(r).from.shape;
  return read_unless(!reads(shape, member), "emitter.from.shape = " + in_quotes(name(shape)));
}

constexpr UnreadRule kShapeRules[] = {
    {"emitter.from.radius", why_unread<kFromRadius>},
    {"emitter.from.angle", why_unread<kFromAngle>},
    {"emitter.from.tube", why_unread<kFromTube>},
    {"emitter.from.size", why_unread<kFromSize>},
    {"emitter.from.length", why_unread<kFromLength>},
    {"emitter.from.thickness", why_unread<kFromThickness>},
    {"emitter.from.arc", why_unread<kFromArc>},
    {"emitter.from.arc_mode", why_unread<kFromArcMode>},
    {"emitter.from.arc_speed",
     [](R r) {
       if (std::string why = why_unread<kFromArcMode>(r); !why.empty()) return why;
       const ArcMode mode = def(r).from.arc_mode;
       return read_with(mode == ArcMode::loop || mode == ArcMode::ping_pong,
                        "emitter.from.arc_mode = \"loop\" or \"ping_pong\"");
     }},
    {"emitter.from.surface", why_unread<kFromSurface>},
    {"emitter.from.surface.low_x", why_unread<kFromPatch>},
    {"emitter.from.surface.high_x", why_unread<kFromPatch>},
    {"emitter.from.surface.low_z", why_unread<kFromPatch>},
    {"emitter.from.surface.high_z", why_unread<kFromPatch>},
};

// ----------------------------------------------------------------------------------------------------------- particles
bool is_something(const DrawnNumber& number) { return number.value != 0 || number.to.value_or(0) != 0; }
std::string why_no_speed_of_life(R r) { return read_with(def(r).life.fast > 0, "emitter.life.fast"); }
std::string why_no_noise(R r) { return read_with(is_something(def(r).flight.noise), "emitter.flight.noise"); }
std::string why_no_forces(R r) {
  const bool is_pushed =
      r.any_of(emitter(r).shot, [](const FlownRung& f) { return f.granted.motion == Motion::force; });
  return read_by(is_pushed, "shots with motion \"force\" feel");
}
std::string why_no_drag(R r) { return read_with(is_something(def(r).flight.drag), "emitter.flight.drag"); }
std::string why_no_gravity(R r) {
  return read_or(r.any_of(emitter(r).shot, feels_gravity), ": gravity does not move its particles");
}
std::string why_no_trail(R r) { return read_with(def(r).trail.points > 0, "emitter.trail.points"); }

constexpr UnreadRule kParticleRules[] = {
    {"emitter.life.fast",
     [](R r) {
       return read_with(!def(r).life.size_by_speed.empty() || !def(r).life.colour_by_speed.empty(),
                        "emitter.life.size_by_speed or colour_by_speed");
     }},
    {"emitter.life.size_by_speed", why_no_speed_of_life},
    {"emitter.life.colour_by_speed", why_no_speed_of_life},
    {"emitter.start.gravity", why_no_gravity},
    {"emitter.flight", why_no_forces},
    {"emitter.flight.gravity", why_no_gravity},
    {"emitter.flight.fast",
     [](R r) {
       if (std::string why = why_no_drag(r); !why.empty()) return why;
       return read_with(!def(r).flight.drag_by_speed.empty(), "emitter.flight.drag_by_speed");
     }},
    {"emitter.flight.drag_by_speed",
     [](R r) {
       if (std::string why = why_no_drag(r); !why.empty()) return why;
       return read_with(def(r).flight.fast > 0, "emitter.flight.fast");
     }},
    {"emitter.flight.limit_rate",
     [](R r) {
       const DrawnNumber& limit = def(r).flight.limit;
       return read_with(std::isfinite(limit.value) || std::isfinite(limit.to.value_or(kInfinity)),
                        "emitter.flight.limit");
     }},
    {"emitter.flight.noise_size", why_no_noise},
    {"emitter.flight.noise_rate", why_no_noise},
    {"emitter.flight.noise_octaves", why_no_noise},
    {"emitter.flight.noise_gain",
     [](R r) {
       if (std::string why = why_no_noise(r); !why.empty()) return why;
       return read_with(def(r).flight.noise_octaves > 1, "emitter.flight.noise_octaves");
     }},
    {"emitter.trail.time", why_no_trail},
    {"emitter.trail.distance", why_no_trail},
    {"emitter.sub.on",
     [](R r) {
       return read_or(r.scope.sub->def.on != SubEvent::trigger, " but in programs: nothing triggers subs in a run");
     }},
    {"emitter.sub.age",
     [](R r) { return read_with(r.scope.sub->def.on == SubEvent::age, "emitter.sub.on = \"age\""); }},
};

}  // namespace
}  // namespace rules_of_emitters

std::span<const UnreadRule> unread_in_emitters() {
  using namespace rules_of_emitters;
  static const std::vector<UnreadRule> all = [] {
    std::vector<UnreadRule> list = rules_of_cycle();
    for (const std::span<const UnreadRule> part :
         std::initializer_list<std::span<const UnreadRule>>{kPlaceRules, kGunRules, kShapeRules, kParticleRules})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace physim
