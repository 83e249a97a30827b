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
bool has_own_place(R r) {
  const auto names_it = [&](const ScenarioEmitter& other) {
    return std::ranges::any_of(other.subs, [&](const ScenarioSub& sub) { return sub.emitter == def(r).name; });
  };
  const bool is_sub = std::ranges::any_of(r.scenario.emitters, names_it);
  return !is_sub || fires(r) || !def(r).cycle.plays;
}
/// Whether something of it goes over the cycle.
bool reads_cycle(R r) {
  const EmitterDef& e = def(r);
  const ParticleStart& s = e.start;
  return !e.cycle.looping || e.cycle.prewarm || !e.bursts.empty() || varies(e.per_second) || varies(s.lifetime) ||
         varies(s.speed) || varies(s.size) || varies(s.size_y) || varies(s.size_z) || varies(s.rotation) ||
         varies(s.rotation_y) || varies(s.rotation_z) || varies(s.gravity) || !s.colour.gradient.empty();
}
bool is_something(const DrawnNumber& number) { return number.value != 0 || number.to.value_or(0) != 0; }

template <FromMember member>
constexpr UnreadRule of_shape(std::string_view settings) {
  return {settings, [](R r) { return reads(def(r).from.shape, member); },
          " beside emitter.from.shape = ", [](R r) { return in_quotes(name(def(r).from.shape)); }};
}

constexpr UnreadRule kEmitterRules[] = {
    // ------------------------------------------------------------------------------------------------ place and cycle
    {"emitter.cycle.duration emitter.cycle.looping emitter.cycle.delay emitter.cycle.prewarm emitter.cycle.rate", fires,
     ": the emitter fires only as the sub of others, or not at all"},
    {"emitter.cycle.duration", reads_cycle, ": cycles that loop without bursts and curves are one like the other"},
    {"emitter.cycle.plays", [](R r) { return has_own_fire(def(r)); },
     ": the emitter has no rate, burst, gun or rain to fire by itself"},
    {"emitter.position emitter.follows emitter.motion.velocity emitter.motion.keys.position "
     "emitter.motion.keys.velocity",
     has_own_place, ": the emitter fires only as the sub of others"},
    {"emitter.position", [](R r) { return emitter(r).follows.empty(); }, " beside emitter.follows"},
    {"emitter.rotation.axis", [](R r) { return emitter(r).rotation.angle != 0; }, " without emitter.rotation.angle"},
    {"emitter.motion.start",
     [](R r) { return emitter(r).motion.velocity != Vec3d{} || emitter(r).motion.angular_velocity != Vec3d{}; },
     " without emitter.motion.velocity or angular_velocity"},
    {"emitter.motion.curve", [](R r) { return !emitter(r).motion.keys.empty(); }, " without emitter.motion.keys"},
    {"emitter.motion.keys.velocity", [](R r) { return emitter(r).motion.curve == MotionCurve::smooth; },
     " without emitter.motion.curve = \"smooth\""},
    {"emitter.inherit_velocity emitter.per_metre", moves, ": the emitter does not move"},
    {"emitter.bursts.interval", [](R r) { return r.scope.burst->cycles != 1; },
     " without emitter.bursts.cycles: the burst comes once"},
    {"emitter.bursts.time", [](R r) { return r.scope.burst->time < def(r).cycle.duration; }, ": burst ",
     [](R r) {
       return std::to_string(r.scope.burst - def(r).bursts.data() + 1) + " is due at " +
              quantity_in_words(r.scope.burst->time, Quantity::time) +
              ", and the cycle ends before, see emitter.cycle.duration = " +
              quantity_in_words(def(r).cycle.duration, Quantity::time);
     }},

    // --------------------------------------------------------------------------------------------------- gun and rain
    {"emitter.gun", [](R r) { return def(r).gun.rounds_per_minute > 0; }, " without emitter.gun.rounds_per_minute"},
    {"emitter.gun.burst_rounds", [](R r) { return def(r).gun.burst_pause > 0 || def(r).gun.recoil != 0; },
     " without emitter.gun.burst_pause or recoil"},
    {"emitter.gun.burst_pause", [](R r) { return def(r).gun.burst_rounds > 0; }, " without emitter.gun.burst_rounds"},
    {"emitter.gun.reload emitter.gun.magazines", [](R r) { return def(r).gun.magazine > 0; },
     " without emitter.gun.magazine"},
    {"emitter.gun.convergence", [](R r) { return !def(r).gun.barrels.empty(); }, " without emitter.gun.barrels"},
    {"emitter.gun.recoil", [](R r) { return !def(r).gun.recoil_up.empty() || !def(r).gun.recoil_right.empty(); },
     " without emitter.gun.recoil_up or recoil_right"},
    {"emitter.gun.recoil_up emitter.gun.recoil_right", [](R r) { return def(r).gun.recoil != 0; },
     " without emitter.gun.recoil"},
    {"emitter.rain.size emitter.rain.drift emitter.rain.shelter", [](R r) { return def(r).rain.density > 0; },
     " without emitter.rain.density"},
    {"emitter.rain.shelter", [](R r) { return !r.scenario.things.empty(); }, " without a [[thing]]"},

    // --------------------------------------------------------------------------------------------------------- shapes
    of_shape<kFromRadius>("emitter.from.radius"),
    of_shape<kFromAngle>("emitter.from.angle"),
    of_shape<kFromTube>("emitter.from.tube"),
    of_shape<kFromSize>("emitter.from.size"),
    of_shape<kFromLength>("emitter.from.length"),
    of_shape<kFromThickness>("emitter.from.thickness"),
    of_shape<kFromArc>("emitter.from.arc"),
    of_shape<kFromArcMode>("emitter.from.arc_mode emitter.from.arc_speed"),
    {"emitter.from.arc_speed",
     [](R r) { return def(r).from.arc_mode == ArcMode::loop || def(r).from.arc_mode == ArcMode::ping_pong; },
     " without emitter.from.arc_mode = \"loop\" or \"ping_pong\""},
    of_shape<kFromSurface>("emitter.from.surface"),
    of_shape<kFromPatch>("emitter.from.surface.low_x emitter.from.surface.high_x emitter.from.surface.low_z "
                         "emitter.from.surface.high_z"),

    // ------------------------------------------------------------------------------------------------------ particles
    {"emitter.life.fast",
     [](R r) { return !def(r).life.size_by_speed.empty() || !def(r).life.colour_by_speed.empty(); },
     " without emitter.life.size_by_speed or colour_by_speed"},
    {"emitter.life.size_by_speed emitter.life.colour_by_speed", [](R r) { return def(r).life.fast > 0; },
     " without emitter.life.fast"},
    {"emitter.start.gravity emitter.flight.gravity", [](R r) { return r.any_of(emitter(r).shot, feels_gravity); },
     ": gravity does not move its particles"},
    {"emitter.flight", [](R r) { return r.any_of(emitter(r).shot, is_pushed); },
     ": only shots with motion \"force\" feel it"},
    {"emitter.flight.fast emitter.flight.drag_by_speed", [](R r) { return is_something(def(r).flight.drag); },
     " without emitter.flight.drag"},
    {"emitter.flight.fast", [](R r) { return !def(r).flight.drag_by_speed.empty(); },
     " without emitter.flight.drag_by_speed"},
    {"emitter.flight.drag_by_speed", [](R r) { return def(r).flight.fast > 0; }, " without emitter.flight.fast"},
    {"emitter.flight.limit_rate",
     [](R r) {
       const DrawnNumber& limit = def(r).flight.limit;
       return std::isfinite(limit.value) || std::isfinite(limit.to.value_or(kInfinity));
     },
     " without emitter.flight.limit"},
    {"emitter.flight.noise_size emitter.flight.noise_rate emitter.flight.noise_octaves emitter.flight.noise_gain",
     [](R r) { return is_something(def(r).flight.noise); }, " without emitter.flight.noise"},
    {"emitter.flight.noise_gain", [](R r) { return def(r).flight.noise_octaves > 1; },
     " without emitter.flight.noise_octaves"},
    {"emitter.trail.time emitter.trail.distance", [](R r) { return def(r).trail.points > 0; },
     " without emitter.trail.points"},
    {"emitter.sub.on", [](R r) { return r.scope.sub->def.on != SubEvent::trigger; },
     " but in programs: nothing triggers subs in a run"},
    {"emitter.sub.age", [](R r) { return r.scope.sub->def.on == SubEvent::age; }, " without emitter.sub.on = \"age\""},
};

}  // namespace
}  // namespace rules_of_emitters

std::span<const UnreadRule> unread_in_emitters() { return rules_of_emitters::kEmitterRules; }

}  // namespace physim
