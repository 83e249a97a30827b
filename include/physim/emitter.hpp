// Emitters fire projectiles into a world at their own moments inside its steps: guns, sprays, fireworks. EmitterDef:
// what, when, from where and how.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physim/body.hpp"
#include "physim/event.hpp"
#include "physim/math.hpp"
#include "physim/projectile.hpp"
#include "physim/scene.hpp"

namespace physim {

// ------------------------------------------------------------------------------------------------- numbers
/// A point of a curve.
struct CurveKey {
  double at = 0;     ///< part of the span, 0..1, above that of the key before [-]
  double value = 0;  ///< [unit of the curve]

  bool operator==(const CurveKey&) const = default;
};
/// A curve over a span, such as a cycle or a life: monotone cubics (PCHIP) through its keys, held before the first and
/// after the last one; no keys: 1 everywhere.
using Curve = std::vector<CurveKey>;

/// A number that emitters draw: {5} is a constant, {4, 6} lies evenly between two, {10, {}, {{0, 1}, {1, 0}}} falls
/// from 10 to 0 over the span, {4, 6, low, high} lies evenly between two curves.
struct DrawnNumber {
  double value = 0;            ///< times `curve` [unit of the number]
  std::optional<double> to{};  ///< times `to_curve`: it lies evenly between both; none: it is `value` [same unit]
  Curve curve{};               ///< [-]
  Curve to_curve{};            ///< none: `curve` [-]

  bool operator==(const DrawnNumber&) const = default;
};

/// A point of a gradient.
struct ColourKey {
  double at = 0;                      ///< part of the span, 0..1, above that of the key before [-]
  std::uint32_t colour = 0xffffffff;  ///< RGBA, a byte each [-]

  bool operator==(const ColourKey&) const = default;
};
/// Colours over a span, in straight lines for each of red, green, blue and alpha; no keys: white.
using Gradient = std::vector<ColourKey>;

/// A colour that emitters draw, as DrawnNumber: both factors are multiplied, as parts of 255.
struct DrawnColour {
  std::uint32_t colour = 0xffffffff;  ///< times `gradient` [-]
  std::optional<std::uint32_t> to{};  ///< times `to_gradient`: it lies evenly between both; none: `colour` [-]
  Gradient gradient{};                ///< [-]
  Gradient to_gradient{};             ///< none: `gradient` [-]

  bool operator==(const DrawnColour&) const = default;
};

// ------------------------------------------------------------------------------------------------- when
/// Many at one moment, once or again and again.
struct Burst {
  double time = 0;           ///< into the cycle [s]
  DrawnNumber count{1};      ///< rounded to the nearest whole number; curves go over the cycle [-]
  std::uint32_t cycles = 1;  ///< times; 0: to the end of the cycle [-]
  double interval = 0.1;     ///< between them [s]
  double probability = 1;    ///< of each [-]

  bool operator==(const Burst&) const = default;
};

/// The place of one of several barrels in the emitter's frame: x forward, y up, z right.
struct Barrel {
  Vec3d position{};  ///< of its muzzle [m]

  bool operator==(const Barrel&) const = default;
};

/// Fires rounds one by one while the emitter plays.
struct GunDef {
  double rounds_per_minute = 0;    ///< 0: no gun [1/min]
  std::uint32_t burst_rounds = 0;  ///< rounds, then a pause; 0: fire without pauses [-]
  double burst_pause = 0;          ///< after the last round of a burst, on top of the time between rounds [s]
  std::uint32_t magazine = 0;      ///< rounds, then it reloads; 0: it never runs out [-]
  double reload = 0;               ///< from a magazine's last round to the next, never sooner than by the rate [s]
  std::uint32_t magazines = 0;     ///< then it is silent; 0: without end [-]
  double dispersion = 0;           ///< standard deviation of the direction, to each side and up and down [rad]
  std::uint32_t tracer_every = 0;  ///< every so manyth round is of the kind `tracer`; 0: none [-]
  KindId tracer{};                 ///< [-]
  std::vector<Barrel> barrels{};   ///< fired in rotation; none: one, at the origin [-]
  double convergence = 0;          ///< distance at which the barrels' lines meet; 0: they are parallel [m]
  Curve recoil_up{};               ///< over the rounds of a burst, else of a magazine, times recoil; no keys: 0 [-]
  Curve recoil_right{};            ///< as recoil_up, to the right [-]
  double recoil = 0;               ///< by which the direction climbs where a curve is 1 [rad]

  bool operator==(const GunDef&) const = default;
};

// ------------------------------------------------------------------------------------------------- shapes
/// The shape from which particles are emitted. Its axis is the emitter's x axis.
enum class EmitShape : std::uint8_t {
  point,          ///< forwards
  cone,           ///< from a disc of `radius`, away from the tip of a cone of half angle `angle`
  sphere,         ///< away from the middle of a ball of `radius`
  hemisphere,     ///< away from the middle of the half of a ball that lies forwards
  box,            ///< forwards, from a box of `size` about the origin
  circle,         ///< away from the middle of a disc of `radius` across the axis
  ring,           ///< away from the middle line of a torus of `radius` and of a tube of `tube`
  line,           ///< forwards, from a line of `length` along z about the origin
  mesh,           ///< from the surface of a mesh, evenly by area; see EmitSurface, as of the next three
  mesh_edges,     ///< from the edges of its triangles, evenly by length, each once
  mesh_vertices,  ///< from the corners of its triangles, one as often as the other
  terrain,        ///< from a height field, or a rectangle of it, evenly by area
};

/// The sequence of emission points along the arc.
enum class ArcMode : std::uint8_t {
  random,     ///< anywhere
  loop,       ///< further by arc_speed all the time
  ping_pong,  ///< to and fro by arc_speed
  spread,     ///< those of one moment evenly over the arc
};

/// The direction in which particles leave a mesh or terrain.
enum class EmitAlong : std::uint8_t {
  normal,  ///< of the triangle; at an edge or a vertex the mean of those about it
  smooth,  ///< between the normals of the triangle's corners, as a smooth surface has it
  axis,    ///< forwards
};

/// The surface that emits particles if the shape is made of triangles. It lies unchanged in the emitter's frame: an
/// emitter with the place and rotation of a thing of the same shape emits from that thing.
struct EmitSurface {
  SharedShape shape{};                  ///< a mesh, or a height field where the shape is terrain [-]
  double scale = 1;                     ///< along all axes, 1e-9 to 1e9 [-]
  EmitAlong along = EmitAlong::normal;  ///< [-]
  double low_x = -kInfinity;            ///< of terrain: a rectangle of it, in its own frame, before it is scaled [m]
  double high_x = kInfinity;            ///< above low_x [m]
  double low_z = -kInfinity;            ///< [m]
  double high_z = kInfinity;            ///< above low_z [m]

  bool operator==(const EmitSurface&) const = default;
};

struct EmitFrom {
  EmitShape shape = EmitShape::point;  ///< [-]
  double radius = 1;                   ///< of cone, sphere, hemisphere, circle, ring [m]
  double angle = 0.4363323129985824;   ///< of a cone, 0 to below pi/2: half of its opening (25 degrees) [rad]
  double tube = 0.1;                   ///< radius of the ring's tube, up to that of the ring [m]
  Vec3d size{1, 1, 1};                 ///< of the box [m]
  double length = 1;                   ///< of the line [m]
  double thickness = 1;                ///< 1: from the whole volume or disc; 0: from its surface or edge [-]
  double arc =
      6.283185307179586;  ///< about the axis, of cone, hemisphere, sphere, circle, ring; a line: all of it [rad]
  ArcMode arc_mode = ArcMode::random;  ///< of those with an arc, and of the line [-]
  double arc_speed = 1;                ///< of loop and ping_pong: arcs a second [1/s]
  double randomise = 0;                ///< part of the way from its direction to a random one, 0..1 [-]
  EmitSurface surface{};               ///< of mesh, mesh_edges, mesh_vertices and terrain [-]

  bool operator==(const EmitFrom&) const = default;
};

/// Rain, snow or dust about a viewer: a box about the emitter's origin that particles fill evenly, at rest and while it
/// moves. They come in through its faces, at exact moments, and those that are outside after a step are gone. They
/// start with the direction of the shape and `start.speed`; where in the shape does not count.
struct RainDef {
  double density = 0;      ///< particles in a cubic metre; 0: no rain [1/m^3]
  Vec3d size{20, 20, 20};  ///< of the box, along the axes of W, at most 1e6 particles in it [m]
  Vec3d drift{};           ///< velocity that is added to that of all: what the wind does [m/s]
  double shelter = 0;      ///< no particle begins where a thing of the scene is so near, against its velocity; 0: not
                           ///< looked at; below the ground none begins [m]

  bool operator==(const RainDef&) const = default;
};

// ------------------------------------------------------------------------------------------------- particles
/// Initial values of a particle; curves go over the emitter's cycle.
struct ParticleStart {
  DrawnNumber lifetime{5};    ///< above 0, infinity too; then it expires, Reason::older, at that moment [s]
  DrawnNumber speed{5};       ///< in the direction of the shape; below 0: backwards [m/s]
  DrawnNumber size{1};        ///< shown only [m]
  DrawnNumber size_y{1};      ///< times `size`, across [-]
  DrawnNumber size_z{1};      ///< times `size`, the third axis [-]
  DrawnNumber rotation{0};    ///< about the axis towards the viewer; shown only [rad]
  DrawnNumber rotation_y{0};  ///< about its own y axis [rad]
  DrawnNumber rotation_z{0};  ///< about its own z axis [rad]
  double flipped = 0;         ///< part of the particles that turn the other way, 0..1 [-]
  DrawnColour colour{};       ///< shown only [-]
  DrawnNumber gravity{1};     ///< times BodyDef::gravity_scale [-]

  bool operator==(const ParticleStart&) const = default;
};

/// Changes over the age of a particle; shown only. Curves go over its lifetime, or over 1 s where that is infinite.
struct ParticleLife {
  DrawnNumber size{1};         ///< times the size at the start [-]
  DrawnNumber turn{0};         ///< rate of its rotation [rad/s]
  DrawnColour colour{};        ///< times the colour at the start [-]
  double fast = 0;             ///< speed at which size_by_speed and colour_by_speed end; 0: neither counts [m/s]
  Curve size_by_speed{};       ///< over 0 .. fast, times the size [-]
  Gradient colour_by_speed{};  ///< over 0 .. fast, times the colour [-]

  bool operator==(const ParticleLife&) const = default;
};

/// Effects on the flight of a particle over its age, beside those of its kind, rung and world. Curves go over its
/// lifetime, or over 1 s where that is infinite; what lies between two is drawn once for each particle. Rungs of
/// Motion::force alone feel them. Axes are those of W.
struct ParticleFlight {
  DrawnNumber drag{0};           ///< its velocity falls at that rate, 0 or more [1/s]
  double fast = 0;               ///< speed at which drag_by_speed ends; 0: it does not count [m/s]
  Curve drag_by_speed{};         ///< over 0 .. fast, times the drag [-]
  DrawnNumber gravity{1};        ///< times the gravity that it feels anyway [-]
  DrawnNumber velocity_x{0};     ///< added to its velocity: at birth its value then, later its changes [m/s]
  DrawnNumber velocity_y{0};     ///< upwards [m/s]
  DrawnNumber velocity_z{0};     ///< to the right [m/s]
  DrawnNumber force_x{0};        ///< [N]
  DrawnNumber force_y{0};        ///< upwards [N]
  DrawnNumber force_z{0};        ///< to the right [N]
  DrawnNumber limit{kInfinity};  ///< speed above which it is slowed down, 0 or more; infinity: none [m/s]
  double limit_rate = 10;        ///< decay rate of its speed above the limit [1/s]
  DrawnNumber noise{0};          ///< acceleration by swirls without sources, root of its mean square, 0 or more [m/s^2]
  double noise_size = 1;         ///< of the largest swirls: the cells of a lattice in W, above 0 [m]
  double noise_rate = 0;         ///< swirls change, and come again after 1 / rate; 0: they stay as they are [1/s]
  std::uint32_t noise_octaves = 1;  ///< 1 to 8: each has swirls half as large as the one before [-]
  double noise_gain = 0.5;          ///< acceleration of an octave over that of the one before, 0..1 [-]

  bool operator==(const ParticleFlight&) const = default;
};

/// Past places of each particle, kept for drawing its trail: World::trails(). One is recorded at birth and after each
/// step.
struct TrailDef {
  std::uint32_t points = 0;  ///< of each particle at most, the oldest go first, up to 1e6; 0: none are kept [-]
  double time = kInfinity;   ///< older ones are not returned, above 0 [s]
  double distance = 0;       ///< least distance between recorded places [m]

  bool operator==(const TrailDef&) const = default;
};

/// The event at which a sub-emitter fires.
enum class SubEvent : std::uint8_t {
  birth,   ///< of a particle
  hit,     ///< it met a thing of the scene, whatever followed
  bounce,  ///< off the ground or a thing
  ricochet,
  exit,     ///< it came out of a thing: EventKind::penetrated and left
  landing,  ///< on the ground, where that ends its flight
  apex,     ///< WorldDef::apex_events must be set
  death,    ///< however it ends, but by a call or to make room
  age,      ///< it has reached an age
  trigger,  ///< World::trigger_emitter()
};

/// The direction of the axis of a sub-emitter's shape.
enum class SubAxis : std::uint8_t {
  emitter,   ///< as the emitter that it is
  velocity,  ///< along the velocity in the event
  normal,    ///< along the normal of what was hit; where nothing was, as the emitter
};

/// An emitter of the same world fires where something happens to a particle of this one: exactly once each, at the
/// moment and place of the event.
struct SubEmitter {
  SubEvent on = SubEvent::death;    ///< [-]
  EmitterId emitter{};              ///< source of kind, shape and start; it need not play; none: its own [-]
  DrawnNumber count{1};             ///< rounded to the nearest whole number; curves do not count [-]
  double probability = 1;           ///< of each event [-]
  double age = 0;                   ///< of SubEvent::age, above 0 [s]
  SubAxis axis = SubAxis::emitter;  ///< [-]
  double inherit_velocity = 0;      ///< part of the particle's velocity that is added [-]
  bool inherit_colour = false;      ///< times the particle's colour then [-]
  bool inherit_size = false;        ///< times the particle's size then [-]

  bool operator==(const SubEmitter&) const = default;
};

/// The action of an emitter that does not loop, when it is over and its last particle is gone.
enum class StopAction : std::uint8_t {
  none,    ///< it stays, and may play again
  remove,  ///< World::remove_emitter()
};

/// The timing of an emitter.
struct EmitterCycle {
  double duration = 5;                 ///< of a cycle, above 0 [s]
  bool looping = true;                 ///< cycle after cycle [-]
  DrawnNumber delay{0};                ///< from the start to the first cycle; curves do not count [s]
  bool prewarm = false;                ///< starts as if it had played one cycle (looping ones, without a delay) [-]
  double rate = 1;                     ///< speed of its clock over that of the world's, above 0 [-]
  bool plays = true;                   ///< from the moment it is added; false: World::play_emitter() starts it [-]
  StopAction stop = StopAction::none;  ///< [-]

  bool operator==(const EmitterCycle&) const = default;
};

struct EmitterDef {
  std::string name{};    ///< in messages and tables [-]
  KindId kind{};         ///< of its projectiles: World::add_kind() [-]
  Launch launch{};       ///< its other members: rail, attitude, spin; the rest is the emitter's [-]
  EmitterCycle cycle{};  ///< [-]
  std::optional<std::uint64_t>
      seed{};                    ///< of all that is drawn; none: one that follows from the emitters added before [-]
  Vec3d position{};              ///< of its origin, where it does not move [m]
  Quatd rotation{};              ///< from its frame (x forward, y up, z right) to W; of any length but zero [-]
  SceneMotion motion{};          ///< its path over the world's time; at rest: as position and rotation say [-]
  ProjectileId follows{};        ///< its origin is that projectile; when it is gone the emitter stops [-]
  double inherit_velocity = 0;   ///< part of the emitter's own velocity that is added to particles [-]
  DrawnNumber per_second{10};    ///< particles a second; curves go over the cycle [1/s]
  double per_metre = 0;          ///< particles for each metre that the emitter moves [1/m]
  std::vector<Burst> bursts{};   ///< [-]
  GunDef gun{};                  ///< [-]
  RainDef rain{};                ///< [-]
  EmitFrom from{};               ///< [-]
  ParticleStart start{};         ///< [-]
  ParticleLife life{};           ///< [-]
  ParticleFlight flight{};       ///< [-]
  TrailDef trail{};              ///< [-]
  std::uint32_t maximum = 1000;  ///< particles alive at once [-]
  WhenFull when_full = WhenFull::refuse;  ///< a new one then: refused, or the oldest makes room; both are counted [-]
  std::vector<SubEmitter> subs{};         ///< [-]
};

// ------------------------------------------------------------------------------------------------- results
/// Counts of an emitter since it was added.
struct EmitterCounts {
  std::uint64_t born = 0;      ///< [-]
  std::uint64_t refused = 0;   ///< full, or the world did not take them [-]
  std::uint64_t aged = 0;      ///< gone at the end of their lifetime [-]
  std::uint64_t landed = 0;    ///< gone on the ground or on a thing that stopped them [-]
  std::uint64_t expired = 0;   ///< gone by other rules of DespawnRules [-]
  std::uint64_t replaced = 0;  ///< gone for a newer one [-]
  std::uint64_t taken = 0;     ///< despawned by a call, or retired: at a NaN, or in a past that is cut [-]
  std::uint64_t cut = 0;       ///< not emitted: endless sub-emitters; over 1e6 in a step or a long past stop it [-]
  std::uint32_t alive = 0;     ///< now [-]

  bool operator==(const EmitterCounts&) const = default;
};

/// Columns for a renderer, in the caller's memory and with the caller's stride, each as long as there are particles to
/// be shown; those left empty are not wanted.
struct ParticleColumns {
  Column<ProjectileId> id{};       ///< [-]
  Column<Vec3d> position{};        ///< [m]
  Column<Vec3d> previous{};        ///< before the last step, or at its birth in it [m]
  Column<Vec3d> velocity{};        ///< [m/s]
  Column<Vec3d> size{};            ///< by its own axes [m]
  Column<Vec3d> rotation{};        ///< about x (towards the viewer), y and z [rad]
  Column<std::uint32_t> colour{};  ///< RGBA [-]
  Column<double> age{};            ///< [s]
  Column<std::uint64_t> number{};  ///< of the particle among those of its emitter, from 0 [-]
  /// They come from the farthest to the nearest of this place, those equally far by the index of their ids, as all do
  /// without one [m].
  std::optional<Vec3d> eye{};
};

/// Columns for drawing trails, in the caller's memory. Columns left empty are skipped, and shorter ones receive the
/// first entries.
struct TrailColumns {
  Column<ProjectileId> id{};      ///< of each particle [-]
  Column<std::uint32_t> first{};  ///< of each particle: which of all places is its first one [-]
  Column<std::uint32_t> count{};  ///< of each particle: how many places it has [-]
  Column<Vec3d> position{};       ///< of one particle after the other, from the oldest place to where it is now [m]
  Column<double> time{};          ///< at which it was there [s]
};
/// Counts of the trails of an emitter.
struct TrailCounts {
  std::size_t particles = 0;  ///< [-]
  std::size_t places = 0;     ///< of all together [-]
};

}  // namespace physim
