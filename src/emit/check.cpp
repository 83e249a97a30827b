// Refuses emitters that make no sense.
#include <cmath>
#include <string>
#include <variant>

#include "base/checker.hpp"
#include "base/emit_shape_table.hpp"
#include "collide/path.hpp"
#include "emit/drawn.hpp"
#include "emit/emission.hpp"
#include "emit/emit_surface.hpp"
#include "emit/moments.hpp"
#include "math/angles.hpp"
#include "math/quat.hpp"
#include "math/vec3.hpp"
#include "model/curl_noise.hpp"
#include "prepare/check.hpp"

namespace physim {
namespace {

constexpr std::size_t kMostKeys = 10'000;  // of a curve
constexpr std::size_t kMostParts = 1'000;  // bursts, barrels or sub-emitters
constexpr double kLeastGap = 1e-9;         // between keys: slopes beyond are no numbers
constexpr double kMostValue = 1e15;        // of a number or a curve: products stay finite
constexpr double kMostBirths = 1e9;        // in a second or at one moment
constexpr double kLeastBirths = 1e-6;      // in a cycle if each draws its rate: rarer births take long to find
constexpr double kLeastChance = 1e-5;      // of a moment of a burst, for the same reason
constexpr double kLongest = 1e9;           // [s]
constexpr double kFarthest = 1e15;         // [m]
constexpr double kNearest = 1e-6;          // in front of a barrel that its line meets others [m]
constexpr double kWholeTurn = 6.2832;      // 2 pi, and what rounding it may add [rad]
constexpr double kMostDispersion = 0.3;    // its tails still point forwards [rad]

constexpr double kLeastPatch = 1e-9;  // of terrain: part of the whole field along a side

constexpr double kMostInRain = 1e6;               // particles in the box of rain
constexpr std::uint32_t kMostPlaces = 1'000'000;  // of a trail

enum class Least : std::uint8_t { any, zero, above_zero };

using Place = std::string;

/// What a list may hold at most.
void check_length(Checker& c, std::size_t size, std::size_t most, const Place& place) {
  c.require(size <= most, place, "has too many parts", "at most " + std::to_string(most));
}
void check_part(Checker& c, double x, const Place& place) {
  c.require(x >= 0 && x <= 1, place, "must lie between 0 and 1, not at " + short_text(x));
}
void check_within(Checker& c, double x, double least, double most, const Place& place, const Place& hint = "") {
  c.require(x >= least && x <= most, place,
            "must lie between " + short_text(least) + " and " + short_text(most) + ", not at " + short_text(x), hint);
}

// ------------------------------------------------------------------------------------------------- values
/// Keys of a curve or a gradient: 0..1, rising.
template <class Key>
bool check_keys(Checker& c, const std::vector<Key>& keys, const Place& place) {
  check_length(c, keys.size(), kMostKeys, place);
  for (std::size_t i = 0; i < keys.size() && c.status_so_far(); ++i) {
    const double at = keys[i].at;
    if (at >= 0 && at <= 1 && (i == 0 || at - keys[i - 1].at >= kLeastGap)) continue;
    const Place key = place + "[" + std::to_string(i) + "].at";
    check_part(c, at, key);
    c.require(false, key, "must rise from key to key, by 1e-9 at least", "sort the keys");
  }
  return bool(c.status_so_far());
}

void check_curve(Checker& c, const Curve& curve, const Place& place, Least least = Least::any) {
  if (!check_keys(c, curve, place)) return;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double value = curve[i].value;
    if (std::abs(value) <= kMostValue && (value >= 0 || least == Least::any)) continue;
    const Place key = place + "[" + std::to_string(i) + "].value";
    check_within(c, value, least == Least::any ? -kMostValue : 0, kMostValue, key);
  }
}

void check_gradient(Checker& c, const Gradient& gradient, const Place& place) { check_keys(c, gradient, place); }

/// `endless`: infinity is a number, too, if it is the only one.
void check_number(Checker& c, const DrawnNumber& n, const Place& place, Least least = Least::any,
                  bool endless = false) {
  if (!c.status_so_far()) return;
  const auto end = [&](double x, const Place& at) {
    if (endless && x == kInfinity && !n.to) return;
    c.require(std::abs(x) <= kMostValue, at, "must be a number within 1e15, not " + short_text(x));
    if (least == Least::zero) c.require(x >= 0, at, "must be zero or positive, not " + short_text(x));
    if (least == Least::above_zero) c.require(x > 0, at, "must be positive, not " + short_text(x));
  };
  end(n.value, place);
  if (n.to) end(*n.to, place + ".to");
  check_curve(c, n.curve, place + ".curve", least);
  check_curve(c, n.to_curve, place + ".to_curve", least);
  c.require(n.to || n.to_curve.empty(), place + ".to_curve", "does nothing without `to`",
            "give the number that it is for, too");
  if (least != Least::above_zero || !c.status_so_far()) return;
  c.require(range_of(n).least > 0, place, "becomes 0 on its curve", "keep its keys above 0");
}

void check_colour(Checker& c, const DrawnColour& colour, const Place& place) {
  check_gradient(c, colour.gradient, place + ".gradient");
  check_gradient(c, colour.to_gradient, place + ".to_gradient");
  c.require(colour.to || colour.to_gradient.empty(), place + ".to_gradient", "does nothing without `to`",
            "give the colour that it is for, too");
}

/// How many come at one moment.
void check_count(Checker& c, const DrawnNumber& count, const Place& place) {
  check_number(c, count, place, Least::zero);
  if (c.status_so_far())
    c.require(range_of(count).most <= kMostBirths, place, "is more than 1e9 at one moment", "give fewer");
}

// ------------------------------------------------------------------------------------------------- when
void check_cycle(Checker& c, const EmitterCycle& cycle) {
  c.require(cycle.duration > 0 && cycle.duration <= kLongest, "emitter.cycle.duration",
            "must be positive, and at most 1e9 s, not " + short_text(cycle.duration),
            "let it loop to go on without end");
  check_number(c, cycle.delay, "emitter.cycle.delay", Least::zero);
  if (!c.status_so_far()) return;
  const double delay = cycle.delay.to ? std::max(*cycle.delay.to, cycle.delay.value) : cycle.delay.value;
  c.require(delay <= kLongest, "emitter.cycle.delay", "is longer than 1e9 s", "times are in seconds");
  c.require(!cycle.prewarm || cycle.looping, "emitter.cycle.prewarm", "goes together with looping alone",
            "it starts as if a cycle was over");
  c.require(!cycle.prewarm || delay == 0, "emitter.cycle.prewarm", "goes with no delay", "leave one of them out");
  c.require(cycle.rate > 0 && cycle.rate <= 1e6, "emitter.cycle.rate",
            "must be positive, and at most 1e6, not " + short_text(cycle.rate), "1 is the world's clock");
  c.named(cycle.stop, "emitter.cycle.stop");
}

void check_burst(Checker& c, const Burst& burst, const Place& place) {
  check_within(c, burst.time, 0, kLongest, place + ".time", "it counts from the start of the cycle, in s");
  check_count(c, burst.count, place + ".count");
  check_within(c, burst.interval, 0, kLongest, place + ".interval", "in s");
  c.require(burst.cycles != 0 || burst.interval > 0, place + ".interval", "must be positive, not 0",
            "it goes on to the end of the cycle: the moments would not end");
  check_part(c, burst.probability, place + ".probability");
  c.require(burst.probability == 0 || burst.probability >= kLeastChance, place + ".probability",
            "is less than 1e-5, but not 0", "let it come at fewer moments");
}

/// The births of an emitter in a second, at most, by its own clock.
double most_births(const EmitterDef& def) {
  double most = range_of(def.per_second).most + def.gun.rounds_per_minute / 60;
  for (const Burst& burst : def.bursts)
    most +=
        std::max(range_of(burst.count).most, 1.0) * moments_in_cycle(burst, def.cycle.duration) / def.cycle.duration;
  return most;
}

void check_rates(Checker& c, const EmitterDef& def) {
  check_number(c, def.per_second, "emitter.per_second", Least::zero);
  check_within(c, def.per_metre, 0, kMostBirths, "emitter.per_metre");
  check_length(c, def.bursts.size(), kMostParts, "emitter.bursts");
  for (std::size_t i = 0; i < def.bursts.size() && c.status_so_far(); ++i)
    check_burst(c, def.bursts[i], "emitter.bursts[" + std::to_string(i) + "]");
}

/// The total of the rates, each of which is valid alone.
void check_births(Checker& c, const EmitterDef& def) {
  if (!c.status_so_far()) return;
  const double births = most_births(def) * def.cycle.rate;
  const NumberRange rate = range_of(def.per_second);
  const Place where = rate.most * def.cycle.rate > kMostBirths                        ? "emitter.per_second"
                      : def.gun.rounds_per_minute / 60 * def.cycle.rate > kMostBirths ? "emitter.gun.rounds_per_minute"
                                                                                      : "emitter.bursts";
  c.require(births <= kMostBirths, where, "would let out " + short_text(births) + " particles a second",
            "at most 1e9, by rate, bursts and gun together");
  if (!c.status_so_far()) return;
  const EmitNumber drawn(def.per_second);
  const auto integral = [&drawn](double u) { return drawn.integral(1, [u] { return u; }); };
  const double of_cycle = std::max(integral(0), integral(1)) * def.cycle.duration;
  c.require(!def.per_second.to || rate.most == 0 || of_cycle >= kLeastBirths, "emitter.per_second",
            "comes to less than 1e-6 particles in a cycle", "make the cycle longer, or give one rate alone");
}

void check_gun(Checker& c, const GunDef& gun) {
  const Place at = "emitter.gun.";
  c.not_negative(gun.rounds_per_minute, at + "rounds_per_minute", "0: no gun");
  check_within(c, gun.burst_pause, 0, kLongest, at + "burst_pause", "in s");
  check_within(c, gun.reload, 0, kLongest, at + "reload", "in s");
  c.require(gun.magazines == 0 || gun.magazine > 0, at + "magazine", "must be positive where magazines are counted",
            "give how many rounds each has");
  check_within(c, gun.dispersion, 0, kMostDispersion, at + "dispersion", "a standard deviation, in radians");
  check_within(c, gun.recoil, -kRightAngle, kRightAngle, at + "recoil", "in radians");
  check_curve(c, gun.recoil_up, at + "recoil_up");
  check_curve(c, gun.recoil_right, at + "recoil_right");
  const bool climbs = gun.recoil != 0 && !(gun.recoil_up.empty() && gun.recoil_right.empty());
  c.require(!climbs || gun.burst_rounds > 0 || gun.magazine > 0, at + "recoil",
            "needs bursts or a magazine, over whose rounds it climbs", "give burst_rounds or magazine");
  check_within(c, gun.convergence, 0, kFarthest, at + "convergence", "0: the barrels are parallel");
  c.require(gun.convergence == 0 || gun.convergence >= kNearest, at + "convergence", "must be 0, or 1e-6 m at least");
  check_length(c, gun.barrels.size(), kMostParts, at + "barrels");
  for (std::size_t i = 0; i < gun.barrels.size() && c.status_so_far(); ++i) {
    const Place place = at + "barrels[" + std::to_string(i) + "].position";
    const Vec3d& p = gun.barrels[i].position;
    c.require(finite(p) && length(p) <= kFarthest, place, "must lie within 1e15 m");
    c.require(gun.convergence == 0 || p.x <= gun.convergence - kNearest, place, "lies beyond the convergence",
              "the barrels' lines meet in front of them");
  }
}

void check_rain(Checker& c, const EmitterDef& def) {
  const RainDef& rain = def.rain;
  const Place at = "emitter.rain.";
  check_within(c, rain.density, 0, kMostBirths, at + "density", "particles in a cubic metre; 0: no rain");
  const Vec3d& size = rain.size;
  c.require(size.x > 0 && size.y > 0 && size.z > 0 && length(size) <= kFarthest, at + "size",
            "must have three components, all positive, within 1e15 m");
  c.require(finite(rain.drift) && length(rain.drift) <= kMostValue, at + "drift", "must be a velocity within 1e15 m/s");
  check_within(c, rain.shelter, 0, kFarthest, at + "shelter", "in m; 0: not looked at");
  if (!c.status_so_far() || rain.density == 0) return;
  const double within = rain.density * size.x * size.y * size.z;
  c.require(within <= kMostInRain, at + "density", "puts " + short_text(within) + " particles into the box",
            "at most 1e6");
  c.require(def.inherit_velocity == 0, "emitter.inherit_velocity", "does not go together with rain",
            "rain does not move with its viewer");
}

void check_trail(Checker& c, const TrailDef& trail) {
  c.require(trail.points <= kMostPlaces, "emitter.trail.points", "must not be above 1e6", "places of one particle");
  c.require(trail.time > 0, "emitter.trail.time", "must be positive, not " + short_text(trail.time), "in s");
  check_within(c, trail.distance, 0, kFarthest, "emitter.trail.distance", "in m");
}

// ------------------------------------------------------------------------------------------------- where
/// The mesh or the terrain that particles come out of.
void check_surface(Checker& c, const EmitFrom& from) {
  const EmitSurface& surface = from.surface;
  const Place at = "emitter.from.surface.", shape = at + "shape";
  c.named(surface.along, at + "along");
  check_within(c, surface.scale, 1e-9, 1e9, at + "scale", "1 changes nothing");
  c.require(reads(from.shape, kFromSurface) || !surface.shape, shape, "does nothing for this shape",
            "say mesh, mesh_edges, mesh_vertices or terrain");
  if (!c.status_so_far() || !reads(from.shape, kFromSurface)) return;
  const bool is_terrain = from.shape == EmitShape::terrain;
  c.require(bool(surface.shape), shape, is_terrain ? "has no height field" : "has no mesh",
            "SharedShape::make() prepares one");
  if (!c.status_so_far()) return;
  const collide::HeightField* field = surface.shape.content()->field();
  c.require(is_terrain == (field != nullptr), shape,
            is_terrain ? "is a mesh, and no height field" : "is a height field, and no mesh",
            is_terrain ? "say mesh" : "say terrain");
  if (!c.status_so_far() || !is_terrain) return;
  c.require(surface.low_x < surface.high_x, at + "low_x", "must lie below high_x, not at " + short_text(surface.low_x));
  c.require(surface.low_z < surface.high_z, at + "low_z", "must lie below high_z, not at " + short_text(surface.low_z));
  const EmitPatch patch = patch_of(surface, *field);
  const double wide = (field->columns() - 1) * field->spacing_x(), deep = (field->rows() - 1) * field->spacing_z();
  const Place hint = "in the field's own frame, in m";
  c.require(patch.high_x - patch.low_x > kLeastPatch * wide, at + "low_x",
            "leaves nothing of the field, which goes from x = 0 to " + short_text(wide), hint);
  c.require(patch.high_z - patch.low_z > kLeastPatch * deep, at + "low_z",
            "leaves nothing of the field, which goes from z = 0 to " + short_text(deep), hint);
}

void check_from(Checker& c, const EmitFrom& from) {
  const Place at = "emitter.from.";
  c.named(from.shape, at + "shape").named(from.arc_mode, at + "arc_mode");
  check_within(c, from.radius, 0, kFarthest, at + "radius", "in m");
  check_within(c, from.tube, 0, kFarthest, at + "tube", "in m");
  check_within(c, from.length, 0, kFarthest, at + "length", "in m");
  const Vec3d& size = from.size;
  c.require(size.x >= 0 && size.y >= 0 && size.z >= 0 && length(size) <= kFarthest, at + "size",
            "must have three components, zero or positive, within 1e15 m");
  c.require(from.angle >= 0 && from.angle < kRightAngle, at + "angle",
            "must lie between 0 and a right angle, not at " + short_text(from.angle),
            "in radians, from the axis; a hemisphere goes all the way");
  check_part(c, from.thickness, at + "thickness");
  check_within(c, from.arc, 0, kWholeTurn, at + "arc", "in radians: 2 pi is a whole turn");
  check_within(c, from.arc_speed, -1e9, 1e9, at + "arc_speed", "in arcs a second");
  check_part(c, from.randomise, at + "randomise");
  c.require(from.shape != EmitShape::ring || from.tube <= from.radius, at + "tube",
            "must not be larger than the radius of the ring", "a ring without a hole is a sphere");
  if (c.status_so_far()) check_surface(c, from);
}

/// Its path, what it follows and its launch; their own checks name places without the emitter.
void check_origin(Checker& c, const EmitterDef& def) {
  c.require(finite(def.position) && length(def.position) <= kFarthest, "emitter.position", "must lie within 1e15 m");
  const double norm = norm_squared(def.rotation);
  c.require(norm > 1e-12 && norm < 1e12, "emitter.rotation", "is no rotation: its length is none");
  check_within(c, def.inherit_velocity, -1e6, 1e6, "emitter.inherit_velocity");
  const auto inner = [&c](const Error& error) { c.also(Error{error.message, "emitter." + error.place, error.hint}); };
  if (const auto launch = check(def.launch); !launch) inner(launch.error());
  c.require(!def.motion.valueless_by_exception(), "emitter.motion", "is none", "an exception took it");
  if (!c.status_so_far() || std::holds_alternative<AtRest>(def.motion)) return;
  c.require(!def.follows, "emitter.motion", "does not go together with `follows`", "the projectile moves it");
  const auto path = collide::Path::make(def.motion, {.position = def.position, .rotation = def.rotation});
  if (!path) inner(path.error());
}

// ------------------------------------------------------------------------------------------------- what
void check_start(Checker& c, const ParticleStart& start) {
  const Place at = "emitter.start.";
  check_number(c, start.lifetime, at + "lifetime", Least::above_zero, true);
  check_number(c, start.speed, at + "speed");
  check_number(c, start.size, at + "size", Least::zero);
  check_number(c, start.size_y, at + "size_y", Least::zero);
  check_number(c, start.size_z, at + "size_z", Least::zero);
  check_number(c, start.rotation, at + "rotation");
  check_number(c, start.rotation_y, at + "rotation_y");
  check_number(c, start.rotation_z, at + "rotation_z");
  check_part(c, start.flipped, at + "flipped");
  check_colour(c, start.colour, at + "colour");
  check_number(c, start.gravity, at + "gravity");
}

void check_life(Checker& c, const ParticleLife& life) {
  const Place at = "emitter.life.";
  check_number(c, life.size, at + "size", Least::zero);
  check_number(c, life.turn, at + "turn");
  check_colour(c, life.colour, at + "colour");
  check_within(c, life.fast, 0, kMostValue, at + "fast", "a speed, in m/s");
  check_curve(c, life.size_by_speed, at + "size_by_speed", Least::zero);
  check_gradient(c, life.colour_by_speed, at + "colour_by_speed");
  c.require(life.fast > 0 || life.size_by_speed.empty(), at + "size_by_speed", "does nothing without `fast`",
            "give the speed at which it ends");
  c.require(life.fast > 0 || life.colour_by_speed.empty(), at + "colour_by_speed", "does nothing without `fast`",
            "give the speed at which it ends");
}

void check_flight(Checker& c, const ParticleFlight& flight) {
  const Place at = "emitter.flight.";
  check_number(c, flight.drag, at + "drag", Least::zero);
  check_within(c, flight.fast, 0, kMostValue, at + "fast", "a speed, in m/s");
  check_curve(c, flight.drag_by_speed, at + "drag_by_speed", Least::zero);
  c.require(flight.fast > 0 || flight.drag_by_speed.empty(), at + "drag_by_speed", "does nothing without `fast`",
            "give the speed at which it ends");
  check_number(c, flight.gravity, at + "gravity");
  check_number(c, flight.velocity_x, at + "velocity_x");
  check_number(c, flight.velocity_y, at + "velocity_y");
  check_number(c, flight.velocity_z, at + "velocity_z");
  check_number(c, flight.force_x, at + "force_x");
  check_number(c, flight.force_y, at + "force_y");
  check_number(c, flight.force_z, at + "force_z");
  check_number(c, flight.limit, at + "limit", Least::zero, true);
  c.require(flight.limit.value < kInfinity || flight.limit.curve.empty(), at + "limit.curve",
            "does nothing where there is no limit", "give the speed that it is a factor of");
  check_within(c, flight.limit_rate, 0, kMostValue, at + "limit_rate", "in 1/s");
  check_number(c, flight.noise, at + "noise", Least::zero);
  check_within(c, flight.noise_size, kNearest, kFarthest, at + "noise_size", "in m");
  check_within(c, flight.noise_rate, 0, kMostValue, at + "noise_rate", "in 1/s");
  check_within(c, flight.noise_octaves, 1, CurlNoise::kMostOctaves, at + "noise_octaves");
  check_part(c, flight.noise_gain, at + "noise_gain");
}

void check_sub(Checker& c, const SubEmitter& sub, const Place& place) {
  c.named(sub.on, place + ".on").named(sub.axis, place + ".axis");
  check_count(c, sub.count, place + ".count");
  check_part(c, sub.probability, place + ".probability");
  check_within(c, sub.age, 0, kMostValue, place + ".age", "in s");
  c.require(sub.on != SubEvent::age || sub.age > 0, place + ".age", "must be positive, not 0",
            "at what age it fires, in s");
  check_within(c, sub.inherit_velocity, -1e6, 1e6, place + ".inherit_velocity");
}

}  // namespace

Status check(const EmitterDef& def) {
  Checker c;
  check_cycle(c, def.cycle);
  check_origin(c, def);
  check_rates(c, def);
  check_gun(c, def.gun);
  check_births(c, def);
  check_rain(c, def);
  check_trail(c, def.trail);
  check_from(c, def.from);
  check_start(c, def.start);
  check_life(c, def.life);
  check_flight(c, def.flight);
  c.require(def.maximum > 0, "emitter.maximum", "must be positive", "it is how many are alive at once");
  c.named(def.when_full, "emitter.when_full");
  check_length(c, def.subs.size(), kMostParts, "emitter.subs");
  for (std::size_t i = 0; i < def.subs.size() && c.status_so_far(); ++i)
    check_sub(c, def.subs[i], "emitter.subs[" + std::to_string(i) + "]");
  return c.status();
}

}  // namespace physim
