// Body: how a world treats a kind of projectile; what a world is made with; presets of projectiles.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physim/environment.hpp"
#include "physim/event.hpp"
#include "physim/flight.hpp"
#include "physim/math.hpp"
#include "physim/projectile.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// WorldDef: what a world is made with. BodyDef: how a world treats a kind of projectile, beside what it is.

/// Axes of the world frame, to be joined with |.
enum class Axes : std::uint8_t { none = 0, x = 1, y = 2, z = 4, all = 7 };
constexpr Axes operator|(Axes a, Axes b) {
  return static_cast<Axes>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has(Axes set, Axes axis) { return (static_cast<unsigned>(set) & static_cast<unsigned>(axis)) != 0; }

/// The response of a projectile to the ground.
enum class GroundMode {
  none,    ///< there is no ground
  land,    ///< its flight ends: LifeStatus::landed, and it leaves the world
  stick,   ///< it stays where it struck, at rest, LifeStatus::landed, until it is despawned or moved
  bounce,  ///< it bounces and slides, rolls to rest and sleeps
};

/// The ground: a plane of constant height (over a round Earth, a surface of constant height).
struct Ground {
  GroundMode mode = GroundMode::land;  ///< [-]
  double height = 0;                   ///< above the origin of the world frame [m]
  double restitution = 1;              ///< combined with BodyDef::restitution, 0..1 [-]
  double friction = 1;                 ///< combined with BodyDef::friction [-]
  CombineDef combine{};                ///< of both with those of the body [-]
  ConveyorDef conveyor{};              ///< that the ground is where it bounces [-]
};

/// Conditions that remove a projectile without a call; LifeStatus::expired. Rules are data, evaluated after every step.
struct DespawnRules {
  double below = -kInfinity;   ///< height above the origin [m]
  double farther = kInfinity;  ///< distance from where it was launched [m]
  double older = kInfinity;    ///< time since launch [s]
  double slower = 0;           ///< speed [m/s]
  bool outside_box = false;    ///< whether the box counts [-]
  Vec3d box_low{};             ///< corner of the box [m]
  Vec3d box_high{};            ///< opposite corner of the box [m]

  bool operator==(const DespawnRules&) const = default;
};

/// The displayed position between two steps.
enum class Smoothing : std::uint8_t {
  none,         ///< as of the last step
  interpolate,  ///< between the last two steps: smooth, one step late
  extrapolate,  ///< ahead of the last step by its velocity: on time, and corrected at every step
};

/// Properties of a kind of projectile in a world. Those marked (live) may be changed for each projectile at any time.
struct BodyDef {
  double gravity_scale = 1;           ///< (live) times gravity; 0: none [-]
  bool use_gravity = true;            ///< (live) false is a gravity_scale of 0 [-]
  double drag_scale = 1;              ///< times every drag; 0: none [-]
  double angular_drag = 0;            ///< rate at which turning dies away: d omega / dt = -angular_drag omega [1/s]
  Vec3d angular_velocity{};           ///< at launch, in W; moves nothing but in contacts of a ball [rad/s]
  bool kinematic = false;             ///< (live) moves only as calls set it [-]
  bool infinite_mass = false;         ///< inverse mass 0: nothing ever moves it [-]
  Axes frozen = Axes::none;           ///< (live) axes of the world along which it does not move [-]
  Axes frozen_rotation = Axes::none;  ///< (live) axes of the world about which it does not turn [-]
  bool can_sleep = true;              ///< (live) goes to sleep after resting [-]
  double sleep_speed = 0.05;          ///< slower than this is resting [m/s]
  double sleep_time = 0.5;            ///< rest before it sleeps [s]
  double restitution = 0.5;           ///< speed kept by a bounce, 0..1 [-]
  double friction = 0.5;              ///< Coulomb's, of bounces and sliding [-]
  double rolling_resistance = 0.05;   ///< weight that resists rolling; 0: a point slides against friction [-]
  CombineDef combine{};               ///< of restitution and friction with those of what it touches [-]
  CollisionDef collision{};           ///< with things of the scene, and with others [-]
  DespawnRules despawn{};             ///< [-]
  Smoothing smoothing = Smoothing::interpolate;  ///< of World::render_position() (live) [-]
  std::uint32_t pool = 0;                        ///< index in WorldDef::pools [-]
  std::uint32_t environment = 0;                 ///< index of an environment of the world [-]
  double cheapest_within = 0;         ///< > 0: instead of its own rung, the cheapest with an error below this [m]
  double within_time = 2;             ///< ... during this time after its launch [s]
  std::uint32_t layers = 1;           ///< (live) bits, for group forces and for the user's own use [-]
  std::uint32_t colour = 0xffffffff;  ///< (live) carried along, RGBA [-]
  std::string label{};                ///< (live) carried along [-]

  bool operator==(const BodyDef&) const = default;
};

/// The overflow policy of a pool.
enum class WhenFull {
  refuse,          ///< the new projectile is not spawned
  replace_oldest,  ///< the one spawned first leaves: LifeStatus::retired
};

/// A limit on projectiles of some kinds.
struct PoolDef {
  std::string name{};                                                     ///< [-]
  std::uint32_t maximum = std::numeric_limits<std::uint32_t>::max() / 2;  ///< projectiles [-]
  WhenFull when_full = WhenFull::refuse;                                  ///< [-]
};

/// A rung of a level-of-detail rule.
struct DetailRung {
  Fidelity fidelity{};         ///< asked for on this rung [-]
  double within = kInfinity;   ///< distance to the observer up to which it holds [m]
  double younger = kInfinity;  ///< age up to which it holds [s]
};

/// Moves projectiles between rungs by distance to an observer and age; the first rung that holds is taken, the last one
/// where none does. A projectile keeps its rung until the rule was against it by more than the hysteresis.
struct DetailRule {
  std::vector<DetailRung> rungs{};    ///< two or three, finest first; empty: no rule [-]
  double hysteresis = 0.1;            ///< part of a rung's distance by which it must be left before it changes [-]
  std::uint32_t layers = 0xffffffff;  ///< projectiles of these layers [-]
};

/// The number of threads of a world.
struct Threading {
  unsigned threads = 0;                   ///< 0: all that the machine has [-]
  std::uint32_t rows_per_thread = 16384;  ///< smaller worlds use fewer threads: one per this many rows [-]
};

/// The definition of a world.
struct WorldDef {
  Environment environment{};     ///< environment 0; more by World::add_environment() [-]
  Ground ground{};               ///< [-]
  double step = 1.0 / 60;        ///< of World::advance() [s]
  std::uint32_t max_steps = 8;   ///< of one World::advance(); time beyond is dropped, and reported [-]
  double time_scale = 1;         ///< factor on the time given to World::advance(); 0..1000 [-]
  Tolerance tolerance{};         ///< of adaptive integrators inside a step; only relative and absolute are read [-]
  bool apex_events = false;      ///< emits an event when a projectile passes its highest point [-]
  std::vector<PoolDef> pools{};  ///< none: one pool without limit [-]
  DetailRule detail{};           ///< level of detail [-]
  Threading threading{};         ///< [-]
  std::uint32_t max_projectiles = 1u << 26;  ///< alive at once; then spawning is refused [-]
};

/// The life stage of a projectile.
enum class LifeStatus : std::uint8_t {
  unknown,    ///< no such projectile, or it is forgotten
  pending,    ///< spawned, to be launched later
  in_flight,  ///< moves, rests or sleeps in the world
  landed,     ///< its flight ended on the ground
  expired,    ///< left by its despawn rules
  retired,    ///< taken out: despawned, replaced in a full pool, or turned into something that is not a number
};

// ---------------------------------------------------------------------------------------------------------------------
// Presets of projectiles: what flies, how a world treats it, and how fast it usually starts. The fidelity is your
// choice.

/// A projectile to start from.
struct ProjectilePreset {
  ProjectileDef projectile{};  ///< [-]
  BodyDef body{};              ///< [-]
  double speed = 0;            ///< usual at launch [m/s]
  std::string doc{};           ///< description [-]
  std::string source{};        ///< source of its numbers [-]
};

namespace presets {

// The projectiles of the original PhySim (2017): damping and a gravity of their own, in its own frame loop
// (Fidelity::classic()).
[[nodiscard]] ProjectilePreset artillery();
[[nodiscard]] ProjectilePreset bullet();
[[nodiscard]] ProjectilePreset laser();
[[nodiscard]] ProjectilePreset sphere();

[[nodiscard]] ProjectilePreset rifle_bullet();
[[nodiscard]] ProjectilePreset arrow();
[[nodiscard]] ProjectilePreset grenade();
[[nodiscard]] ProjectilePreset paintball();
[[nodiscard]] ProjectilePreset tennis_ball();
[[nodiscard]] ProjectilePreset golf_ball();
[[nodiscard]] ProjectilePreset baseball();
[[nodiscard]] ProjectilePreset football();
[[nodiscard]] ProjectilePreset table_tennis_ball();

}  // namespace presets

/// Names of all presets of projectiles.
[[nodiscard]] std::span<const std::string_view> projectile_presets();
/// The preset of a name ("rifle_bullet"), if it is one.
[[nodiscard]] std::optional<ProjectilePreset> projectile_preset(std::string_view name);

}  // namespace physim
