// Settings of [[emitter]]: their paths are those of EmitterDef, but for what a file says by name. EmitterCycle::stop is
// none: emitters of a run stay to its end, which tells their counts.
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

constexpr Range kFullTurn = {.low = 0, .high = 4 * kRightAngle, .words = "0 .. 360 deg"};

#define PHYSIM_EMITTER(field, ...) PHYSIM_ROW("emitter", emitter, field, __VA_ARGS__)
/// A row of what an emitter is in the library, under its name there.
#define PHYSIM_EMITTER_DEF(field, ...) setting("emitter." #field, PHYSIM_FIELD(emitter->def.field), __VA_ARGS__)
#define PHYSIM_BURST(field, ...) PHYSIM_ROW("emitter.bursts", burst, field, __VA_ARGS__)
#define PHYSIM_SUB(field, ...) setting("emitter.sub." #field, PHYSIM_FIELD(sub->def.field), __VA_ARGS__)

constexpr Entry kEmitterSettings[] = {
    setting("emitter", PHYSIM_FIELD(scenario->emitters),
            "what fires shots by itself: guns, sprays, fireworks; a shot that only emitters name is not fired once",
            at_most(10000)),
    PHYSIM_EMITTER_DEF(name, "in tables and for sub.emitter; default: emitter-1, emitter-2, ..."),
    PHYSIM_EMITTER(shot,
                   "name of the shot that it fires: projectile, body, rail, attitude, spin; not its place and speed",
                   kRequired),
    PHYSIM_EMITTER_DEF(position, "of its origin, where it does not move", Quantity::length),
    PHYSIM_ROTATION("emitter", emitter),
    PHYSIM_EMITTER(motion.start, "time at which a steady motion has it at its position", Quantity::time),
    PHYSIM_EMITTER(motion.velocity, "steady", Quantity::speed),
    PHYSIM_EMITTER(motion.angular_velocity, "steady, about its origin", Quantity::angular_rate),
    PHYSIM_EMITTER(motion.keys, "where it is at rising times, instead of a position and steady motion", at_most(10000)),
    PHYSIM_KEYS("emitter.motion.keys"),
    PHYSIM_EMITTER(motion.curve, "which way it takes from key to key"),
    PHYSIM_EMITTER(follows, "name of a shot, fired once, that it sits on; it stops when that is gone"),
    PHYSIM_EMITTER_DEF(inherit_velocity, "part of its own velocity that is added to particles"),
    PHYSIM_EMITTER_DEF(seed, "of all that it draws; none: one of its own", between(0, 9007199254740992.0)),
    PHYSIM_EMITTER_DEF(cycle.duration, "of a cycle, which curves go over", Quantity::time, above(0)),
    PHYSIM_EMITTER_DEF(cycle.looping, "cycle after cycle"),
    PHYSIM_EMITTER_DEF(cycle.delay, "before the first cycle", Quantity::time, at_least(0)),
    PHYSIM_EMITTER_DEF(cycle.prewarm, "starts as if it had played one cycle"),
    PHYSIM_EMITTER_DEF(cycle.rate, "its own clock runs so many times as fast as the world's", above(0)),
    PHYSIM_EMITTER_DEF(cycle.plays, "from the start; false: it fires only as the sub of others"),
    PHYSIM_EMITTER_DEF(per_second, "particles a second; curves go over the cycle", Quantity::frequency, at_least(0)),
    PHYSIM_EMITTER_DEF(per_metre, "particles for each metre that it moves", at_least(0)),
    PHYSIM_EMITTER_DEF(bursts, "many at one moment", at_most(1000)),
    PHYSIM_BURST(time, "into the cycle", Quantity::time, at_least(0)),
    PHYSIM_BURST(count, "particles", at_least(0)),
    PHYSIM_BURST(cycles, "how many times; 0: to the end of the cycle", kBits),
    PHYSIM_BURST(interval, "between them", Quantity::time, at_least(0)),
    PHYSIM_BURST(probability, "of each", kFraction),
    PHYSIM_EMITTER_DEF(gun.rounds_per_minute, "fires rounds one by one; 0: no gun", at_least(0)),
    PHYSIM_EMITTER_DEF(gun.burst_rounds, "rounds, then a pause; 0: one after the other", kBits),
    PHYSIM_EMITTER_DEF(gun.burst_pause, "after the last round of a burst, on top of the time between rounds",
                       Quantity::time, at_least(0)),
    PHYSIM_EMITTER_DEF(gun.magazine, "rounds, then it reloads; 0: it never runs out", kBits),
    PHYSIM_EMITTER_DEF(gun.reload, "from the last round of a magazine to the first of the next", Quantity::time,
                       at_least(0)),
    PHYSIM_EMITTER_DEF(gun.magazines, "then it is silent; 0: without end", kBits),
    PHYSIM_EMITTER_DEF(gun.dispersion, "standard deviation of the direction, to each side and up and down",
                       Quantity::angle, kBelowRightAngle),
    PHYSIM_EMITTER_DEF(gun.tracer_every, "every so manyth round is a tracer; 0: none", kBits),
    setting("emitter.gun.tracer", PHYSIM_FIELD(emitter->tracer), "name of the shot that a tracer is"),
    PHYSIM_EMITTER_DEF(gun.barrels, "in turn; none: one, at the origin", at_most(1000)),
    PHYSIM_ROW("emitter.gun.barrels", barrel, position, "of its muzzle, in the emitter's frame", Quantity::length),
    PHYSIM_EMITTER_DEF(gun.convergence, "distance at which the barrels' lines meet; 0: they are parallel",
                       Quantity::length, at_least(0)),
    PHYSIM_EMITTER_DEF(gun.recoil_up, "[part of a burst, part of recoil] by which the direction climbs", kCurveKeys),
    PHYSIM_EMITTER_DEF(gun.recoil_right, "[part of a burst, part of recoil] by which it turns to the right",
                       kCurveKeys),
    PHYSIM_EMITTER_DEF(gun.recoil, "by which the direction climbs where a curve is 1", Quantity::angle, kHalfTurn),
    PHYSIM_EMITTER_DEF(from.shape, "that particles come out of; its axis is the emitter's x axis", kShorthand),
    PHYSIM_EMITTER_DEF(from.radius, "of cone, sphere, hemisphere, circle, ring", Quantity::length, at_least(0)),
    PHYSIM_EMITTER_DEF(from.angle, "of a cone: half of its opening", Quantity::angle, kBelowRightAngle),
    PHYSIM_EMITTER_DEF(from.tube, "radius of the ring's tube", Quantity::length, at_least(0)),
    PHYSIM_EMITTER_DEF(from.size, "of the box", Quantity::length),
    PHYSIM_EMITTER_DEF(from.length, "of the line", Quantity::length, at_least(0)),
    PHYSIM_EMITTER_DEF(from.thickness, "1: from the whole volume or disc; 0: from its surface or edge", kFraction),
    PHYSIM_EMITTER_DEF(from.arc, "about the axis, of cone, hemisphere, sphere, circle, ring", Quantity::angle,
                       kFullTurn),
    PHYSIM_EMITTER_DEF(from.arc_mode, "where on the arc particles come out, one after the other"),
    PHYSIM_EMITTER_DEF(from.arc_speed, "of loop and ping_pong: arcs a second", Quantity::frequency),
    PHYSIM_EMITTER_DEF(from.randomise, "part of the way from its direction to a random one", kFraction),
    PHYSIM_EMITTER_DEF(start.lifetime, "then it expires", Quantity::time, or_infinite(above(0))),
    PHYSIM_EMITTER_DEF(start.speed, "in the direction of the shape; below 0: backwards", Quantity::speed),
    PHYSIM_EMITTER_DEF(start.size, "shown only", Quantity::length, at_least(0)),
    PHYSIM_EMITTER_DEF(start.size_y, "times size, across", at_least(0)),
    PHYSIM_EMITTER_DEF(start.size_z, "times size, the third axis", at_least(0)),
    PHYSIM_EMITTER_DEF(start.rotation, "about the axis towards the viewer; shown only", Quantity::angle),
    PHYSIM_EMITTER_DEF(start.rotation_y, "about its own y axis", Quantity::angle),
    PHYSIM_EMITTER_DEF(start.rotation_z, "about its own z axis", Quantity::angle),
    PHYSIM_EMITTER_DEF(start.flipped, "part of the particles that turn the other way", kFraction),
    PHYSIM_EMITTER_DEF(start.colour, "shown only"),
    PHYSIM_EMITTER_DEF(start.gravity, "times shot.body.gravity_scale"),
    PHYSIM_EMITTER_DEF(life.size, "times the size at the start; curves of life go over the lifetime", at_least(0)),
    PHYSIM_EMITTER_DEF(life.turn, "rate of its rotation", Quantity::angular_rate),
    PHYSIM_EMITTER_DEF(life.colour, "times the colour at the start"),
    PHYSIM_EMITTER_DEF(life.fast, "speed at which what goes by speed ends; 0: nothing does", Quantity::speed,
                       at_least(0)),
    PHYSIM_EMITTER_DEF(life.size_by_speed, "[part of fast, times the size]", kCurveKeys),
    PHYSIM_EMITTER_DEF(life.colour_by_speed, "[part of fast, times the colour]", kCurveKeys),
    PHYSIM_EMITTER_DEF(maximum, "particles alive at once", between(1, 4294967295.0)),
    PHYSIM_EMITTER_DEF(when_full, "what happens to the next one"),
    setting("emitter.sub", PHYSIM_FIELD(emitter->subs), "emitters that fire where something happens to its particles",
            at_most(1000)),
    setting("emitter.sub.emitter", PHYSIM_FIELD(sub->emitter), "name of the emitter that fires", kRequired),
    PHYSIM_SUB(on, "what it fires at"),
    PHYSIM_SUB(count, "particles", at_least(0)),
    PHYSIM_SUB(probability, "of each event", kFraction),
    PHYSIM_SUB(age, "of on = \"age\"", Quantity::time, at_least(0)),
    PHYSIM_SUB(axis, "which way the axis of the emitter's shape points"),
    PHYSIM_SUB(inherit_velocity, "part of the particle's velocity that is added"),
    PHYSIM_SUB(inherit_colour, "times the particle's colour then"),
    PHYSIM_SUB(inherit_size, "times the particle's size then"),
};

}  // namespace

std::span<const Entry> emitter_settings() { return kEmitterSettings; }

}  // namespace physim
