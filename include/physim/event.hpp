// Events: what happens to projectiles, how they meet things, and the ids of what takes part.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "physim/math.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Ids: what projectiles, kinds and force generators of a world are named by, and what stands in a scene.

/// Identifies one of many in a world or a scene: the number of its slot, and how often that slot was used. Index 0 is
/// null. Ids of what is gone differ from those of what took its place; every call ignores them or reports them. An id
/// is the same number on every machine that makes the same calls, so it does not say of which world it is: keep ids of
/// different worlds apart. Ids can be compared, sorted (by index) and used as keys.
template <class Named>
struct Id {
  std::uint32_t index = 0;       ///< of the slot; 0: none [-]
  std::uint32_t generation = 0;  ///< of the slot's use [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const Id&) const = default;
};
/// Identifies an object that stays as long as its world or scene. Numbers are never used twice.
template <class Named>
struct LastingId {
  std::uint32_t index = 0;  ///< 0: none; of materials: the one that every scene begins with [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const LastingId&) const = default;
};

using ProjectileId = Id<class Projectile>;
using KindId = LastingId<struct Kind>;
using ForceId = Id<struct ForceGenerator>;
using JointId = Id<struct Joint>;
using EmitterId = Id<struct EmitterDef>;
using ShapeId = Id<class Shape>;
using InstanceId = Id<struct Instance>;
using MaterialId = LastingId<struct Material>;

}  // namespace physim

template <class Named>
struct std::hash<physim::Id<Named>> {
  std::size_t operator()(const physim::Id<Named>& id) const noexcept {
    return std::hash<std::uint64_t>()(id.index | std::uint64_t{id.generation} << 32);
  }
};
template <class Named>
struct std::hash<physim::LastingId<Named>> {
  std::size_t operator()(const physim::LastingId<Named>& id) const noexcept {
    return std::hash<std::uint32_t>()(id.index);
  }
};

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// CollisionDef: how a projectile meets the things of a scene, in a world and in a flight.

/// The response of a projectile to a hit on a thing of the scene. Each hit is also reported.
enum class OnHit : std::uint8_t {
  pass,    ///< flies on
  stop,    ///< its flight ends; in a world: LifeStatus::landed, and it leaves the world
  stick,   ///< it stays where it struck, at rest; in a world LifeStatus::landed, until it is despawned or moved
  bounce,  ///< it bounces by its restitution and friction with those of the material, slides, rolls to rest and sleeps
  impact,  ///< as its material says (physim/scene.hpp): it ricochets, goes through, stays in it, or bounces as above
  ask,     ///< as World::set_hit_function() answers for this hit; in worlds alone
};

/// Collision behaviour of a projectile with the things of a scene.
struct CollisionDef {
  OnHit on_hit = OnHit::stop;         ///< response to a hit [-]
  double radius = 0;                  ///< of the ball that meets them, 1e-12 to 1e6; 0: a point, which
                                      ///< nothing spins [m]
  double inertia = 0.4;               ///< of the ball, over mass and radius squared: 2/5 solid, 2/3 hollow [-]
  std::uint32_t layers = 0xffffffff;  ///< bits: things of these layers; 0: none [-]
  std::uint32_t others = 0;           ///< bits: in worlds, projectiles of these BodyDef::layers, which want its own; 0:
                                      ///< none [-]

  bool operator==(const CollisionDef&) const = default;
};

/// The rule by which a number of each of two that touch becomes the number of their contact.
enum class Combine : std::uint8_t {
  product,  ///< of both
  mean,     ///< of both
  minimum,  ///< the smaller one
  maximum,  ///< the larger one
};

/// The rules by which restitution and friction of two that touch are combined. If the two have different rules, the one
/// that stands later in Combine holds: each rule but product can be set on one side alone.
struct CombineDef {
  Combine restitution = Combine::product;  ///< [-]
  Combine friction = Combine::product;     ///< [-]

  bool operator==(const CombineDef&) const = default;
};

/// A surface that runs while what it belongs to stands or moves: a conveyor belt, a treadmill. Friction acts relative
/// to it, on what bounces, slides, rolls or lies on the surface. What lies on it does not sleep.
struct ConveyorDef {
  Vec3d velocity{};  ///< of the surface, each component within 1e6 m/s: of a thing in its own frame, of the ground in
                     ///< W. Only the part along the surface acts [m/s]

  bool operator==(const ConveyorDef&) const = default;
};

/// Contact of a flight with the things of a scene, see Until::scene. Its numbers are those of a BodyDef.
struct ContactDef {
  CollisionDef collision{};          ///< [-]
  double restitution = 0.5;          ///< speed kept by a bounce, combined with that of the material, 0..1 [-]
  double friction = 0.5;             ///< Coulomb's, of bounces and sliding, combined with that of the material [-]
  double rolling_resistance = 0.05;  ///< weight that resists rolling; 0: a point slides against friction [-]
  double scene_time = 0;             ///< of the scene at launch: what moves is then where it is at that time [s]
  CombineDef combine{};              ///< of restitution and friction with those of the material [-]
  std::uint64_t seed = 0;            ///< of what materials leave to chance (Material::spread) [-]

  bool operator==(const ContactDef&) const = default;
};

// ---------------------------------------------------------------------------------------------------------------------
// Event: something that happened to a projectile, in a flight or in a world. EventSpec: what to look for.

/// The kind of an event. Those of a quantity that crosses a value may be asked for by an EventSpec.
enum class EventKind : std::uint8_t {
  ground,            ///< a quantity crosses a value: height above the ground [m]
  apex,              ///< a quantity crosses a value: the vertical velocity, zero
  range,             ///< a quantity crosses a value: distance along the line of sight (horizontal when it is level) [m]
  height,            ///< a quantity crosses a value: height above the origin of the world frame [m]
  mach,              ///< a quantity crosses a value: Mach number [-]
  speed,             ///< a quantity crosses a value: |velocity| in W [m/s]
  time,              ///< a quantity crosses a value: time since launch [s]
  ignition,          ///< of the motor; waits for no value
  burnout,           ///< of the motor; waits for no value
  rail_exit,         ///< the end of the launch rail; waits for no value
  spawned,           ///< in a world: at its launch
  landed,            ///< in a world: on the ground
  bounced,           ///< off the ground of a world, or off a thing of a scene; the velocity is that after the bounce
  slept,             ///< in a world: came to rest and sleeps
  woke,              ///< in a world: was woken by a force or a change
  expired,           ///< in a world: left by its despawn rules
  retired,           ///< in a world: taken out
  fidelity_changed,  ///< in a world: moved to another rung
  hit,               ///< with a scene: met a thing of its scene; the velocity is that before
  entered,           ///< with a scene: went into a thing that it passes, OnHit::pass
  left,              ///< with a scene: came out of a thing that it passes, or of a sensor
  sensed,            ///< with a scene: went into a sensor
  ricocheted,        ///< with a scene: was thrown off by what it met, as it came in flat; the velocity is that after
  penetrated,        ///< with a scene: came out behind what it met; place and velocity are those there, value the depth
  stopped,           ///< with a scene: stuck in what it met; value is the depth [m]
  stayed,  ///< with a scene, in a world: was in a sensor at the start and at the end of a step that it moved in,
           ///< if PassageDef::tells_stay
};

PHYSIM_UNORDERED(EventKind)

/// The direction of the crossings that count.
enum class Crossing : std::uint8_t { any, rising, falling };

/// An event to look for.
struct EventSpec {
  EventKind kind = EventKind::height;  ///< up to rail_exit [-]
  double value = 0;                    ///< that is crossed [unit of the kind]
  Crossing direction = Crossing::any;  ///< [-]
  bool terminal = false;               ///< ends the flight [-]
};

/// The reason for which a projectile left.
enum class Reason : std::uint8_t {
  none,
  below,        ///< DespawnRules::below
  farther,      ///< DespawnRules::farther
  older,        ///< DespawnRules::older
  slower,       ///< DespawnRules::slower
  outside_box,  ///< DespawnRules::box_low, box_high
  despawned,    ///< World::despawn()
  replaced,     ///< by a newer one in a full pool
  non_finite,   ///< its numbers were no longer numbers
  left_domain,  ///< fell below the lower end of the standard atmosphere
  stalled,      ///< an adaptive integrator could not get through a step, or an emitter's past took too many
  inside,       ///< of a hit: it was inside of the thing when the step began, and stays there
};

/// An event that happened.
struct Event {
  EventKind kind = EventKind::ground;      ///< [-]
  Crossing direction = Crossing::falling;  ///< of a quantity that crossed a value [-]
  Reason reason = Reason::none;            ///< of expired and retired [-]
  ProjectileId id{};                       ///< in a world [-]
  double value = 0;                        ///< crossed, a depth, or of spawned its emitter's index [unit of the kind]
  double time = 0;                         ///< in a flight since launch, in a world of the world [s]
  Vec3d position{};                        ///< [m]
  Vec3d velocity{};                        ///< [m/s]
  Vec3d normal{};                          ///< of the surface that was hit, towards the projectile [-]
  InstanceId instance{};                   ///< that was hit, or that it bounced off; none: the ground [-]
  std::uint32_t primitive = 0;             ///< of it, as SceneHit::primitive [-]
  MaterialId material{};                   ///< of it [-]
  double energy = 0;                       ///< lost to the thing, in the thing's frame [J]
  ProjectileId other{};                    ///< that it met in a world; none: no projectile [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// Queried hits: what a world reports of each hit of a projectile with OnHit::ask, and the answer.

/// A hit about which a world asks.
struct HitQuestion {
  ProjectileId projectile{};    ///< that struck [-]
  KindId kind{};                ///< of it [-]
  double time = 0;              ///< of the world, inside of the step at hand [s]
  Vec3d position{};             ///< of the point, or of the middle of the ball, then [m]
  Vec3d velocity{};             ///< with which it came [m/s]
  Vec3d normal{};               ///< of the surface, towards the projectile [-]
  Vec3d surface_velocity{};     ///< of what was struck, there and then [m/s]
  InstanceId instance{};        ///< that was struck [-]
  std::uint32_t primitive = 0;  ///< of it, as SceneHit::primitive [-]
  MaterialId material{};        ///< of it [-]
  double energy = 0;            ///< of its motion, as seen from the surface; 0 without a mass [J]
  double obliquity = 0;         ///< between its way, as seen from the surface, and the normal; 0 straight on [rad]
  double thickness = 0;         ///< of the thing along its way; 0: not known, a sheet, or more than 1000 m [m]
  bool inside = false;  ///< it was inside of the thing when the step began: it stays there, unless it is to stop [-]

  bool operator==(const HitQuestion&) const = default;
};

/// The response of a projectile to a queried hit: as if its kind had it, but for `pass`.
struct HitAnswer {
  OnHit then = OnHit::stop;  ///< any but `ask`; `pass`: it comes out behind the thing at once, by the straight way, and
                             ///< flies on from there: an event `penetrated` [-]
  std::optional<Vec3d> velocity{};  ///< after it, instead of what follows: of `bounce`, not into the surface, or of
                                    ///< `pass`, on into it; as seen from the surface no faster than before [m/s]

  bool operator==(const HitAnswer&) const = default;
};

/// All hits about which nothing is known yet, in order of time, then of id; no projectile has two.
struct HitBatch {
  std::span<const HitQuestion> questions{};  ///< [-]
  std::span<HitAnswer> answers{};            ///< one for each question, HitAnswer{} as it comes [-]
};
using HitFunction = std::function<void(const HitBatch&)>;

/// Counts of the queried hits of a world since it was made or loaded.
struct HitCounts {
  std::uint64_t calls = 0;      ///< of its function [-]
  std::uint64_t questions = 0;  ///< in these [-]
  std::uint64_t refused = 0;    ///< answers that made no sense, or threw: they count as OnHit::stop [-]
};

}  // namespace physim
