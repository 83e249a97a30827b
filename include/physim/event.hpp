// Event: something that happened to a projectile, in a flight or in a world. EventSpec: what to look for.
#pragma once

#include <cstdint>

#include "physim/ids.hpp"
#include "physim/macros.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// What happened. Those of a quantity that crosses a value may be asked for by an EventSpec.
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
};

PHYSIM_UNORDERED(EventKind)

/// Which crossings count.
enum class Crossing : std::uint8_t { any, rising, falling };

/// An event to look for.
struct EventSpec {
  EventKind kind = EventKind::height;  ///< up to rail_exit [-]
  double value = 0;                    ///< that is crossed [unit of the kind]
  Crossing direction = Crossing::any;  ///< [-]
  bool terminal = false;               ///< ends the flight [-]
};

/// Why a projectile left.
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
  stalled,      ///< an adaptive integrator could not get through a step
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
  double energy = 0;                       ///< that it lost to the thing, as seen from that [J]
  ProjectileId other{};                    ///< that it met in a world; none: no projectile [-]
};

}  // namespace physim
