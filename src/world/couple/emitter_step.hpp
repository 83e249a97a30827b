// The part of emitters in a step: particles emitted inside of it, lives that end in it, and sub-emitters that fire.
//
// Before the others move, those that die within the step are flown to that moment and leave, and what reaches an
// age is looked at. Then all fly. Events of that flight, or of the way to the end of a life, set off sub-emitters;
// these and the emitters' own moments are handled in order of time. Each particle is placed at its own moment and flown
// to the end of the step by the code that settles rows, and events on that way set off more. So nothing depends
// on frames but for the rows' own steps; neither on threads, nor on the order of rows.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "emit/odometer.hpp"
#include "world/core/emitters.hpp"
#include "world/core/step_way.hpp"
#include "world/couple/birth_columns.hpp"
#include "world/couple/emitter_pose.hpp"
#include "world/step/part_flights.hpp"
#include "world/step/settle.hpp"

namespace physim {

/// An event of a particle of an emitter with sub-emitters.
struct EmitterTrigger {
  SubEvent on = SubEvent::birth;
  double time = 0;   // [s]
  double birth = 0;  // of the particle [s]
  Particle particle;
  BodyState at;
  Vec3d normal;            // of what it hit; zero: nothing
  std::size_t only = ~0u;  // of its subs; otherwise all that wait for it
};

/// The closed form of a followed projectile, counted from its launch.
struct LedByLaunch {
  std::uint16_t cohort = 0;
  Body<double> body;
  double launched = 0;       // [s]
  double until = kInfinity;  // it meets something, and sets out again [s]
};

/// The way of an emitter that a projectile or a call leads through the step.
struct Led {
  explicit Led(const MotionKey& begin) : way(begin) {}

  StepWay way;
  std::optional<BodyState> at_end;  // of the step, if it is there then
  bool is_left = false;             // the projectile has gone
  std::optional<LedByLaunch> by_launch;
  std::optional<collide::Path> path;  // all of the way, once it is known
  std::optional<Odometer> odometer;   // along it, where it fires by distance; from where that counts
};

/// Memory that steps use again and again.
struct EmitterScratch {
  struct Departure {
    std::uint32_t emitter;
    double time;  // [s]
  };
  std::vector<EmitterTrigger> triggers;
  std::vector<EmitterTrigger> causes;     // those that set off a sub-emitter
  std::vector<Departure> departures;      // of particles, in the step at hand
  std::vector<ProjectileId> dying;        // particles that die in it, in that order
  std::vector<double> ends;               // and when they do [s]
  std::vector<std::optional<Led>> led;    // by emitter
  std::uint32_t births = 0;               // by sub-emitters, in the step at hand
  std::vector<std::uint32_t> own_births;  // of each emitter without a trigger, in the step at hand
  Chunk chunk;
  PartFlights known;                                 // of the step at hand
  std::vector<std::unique_ptr<BirthColumns>> ahead;  // own moments of each emitter, in the step at hand
  BirthColumns together;                             // of one moment
};

struct WorldImpl;

/// Before a step: ends of lives, ages, and where followed projectiles are.
void begin_emitters(WorldImpl& world, double dt);
/// Flies one that was launched inside the step just taken, to its end.
void fly_launched(WorldImpl& world, const SettleContext& context, std::uint32_t slot, double time);
/// All have moved, and none has left yet: what that sets off.
void watch_for_emitters(WorldImpl& world, const SettleContext& context);
/// All that had to leave have left: births.
void fire_emitters(WorldImpl& world, const SettleContext& context);

/// Between steps: one that has just begun to play and began before the world's time: its past.
void fire_past(WorldImpl& world, std::uint32_t emitter);
/// Between steps: emits `count` particles of one emitter; returns how many were emitted.
std::size_t fire_now(WorldImpl& world, std::uint32_t emitter, std::uint32_t count);
/// Between steps: SubEvent::trigger of all of its particles.
void trigger_now(WorldImpl& world, std::uint32_t emitter);
/// A particle leaves now by a rule that is looked at after a step.
void leave_after_step(WorldImpl& world, std::uint32_t slot);

}  // namespace physim
