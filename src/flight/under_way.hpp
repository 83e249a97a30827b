// Flights that go on from where a projectile is, frame by frame, as a world would step it.
#pragma once

#include <cstdint>

#include "flight/flight_record.hpp"

namespace physim {

/// Parts that an adaptive integrator may divide a frame into before it is given up.
inline constexpr int kMostPartsOfFrame = 1000;

/// What pushes a projectile beside its own models: the generators of a world.
class Pushes {
 public:
  virtual ~Pushes() = default;
  /// Whether one acts in a frame from now; asked for each frame in order. `mass`: at its start [kg].
  virtual bool begin_frame(std::int64_t frame, double mass) = 0;
  /// At a place 0..1 of that frame.
  [[nodiscard]] virtual Pushed<double> at(double place, const State<double>& state) = 0;
};

/// Things that a flight meets, and how.
struct Obstacles {
  const Scene* scene = nullptr;  // null: none
  ContactDef contact{};
  Vec3d shown_spin{};        // of rungs that fly none [rad/s]
  Vec3d turns{1, 1, 1};      // about which axes it may, see Ball [-]
  std::uint32_t number = 0;  // of the projectile, for what is left to chance
};

/// Where a projectile is on its way, and by what frames it continues.
struct FrameStart {
  State<double> now{};
  Vec3d carried{};             // by the original loop [m/s^2]
  Turn<double> turn{};         // of rungs that turn
  bool is_clocked = false;     // its models read the time since launch: clock + steps dt, in its precision
  double clock = 0;            // [s]
  double steps = 0;            // frames since the clock read that
  double dt = 0;               // of a frame [s]
  bool in_parts = false;       // frames are flown in short parts from their start (flight/step_parts.hpp)
  bool has_own_force = false;  // ProjectileDef::force, or others of its cohort have one
  Pushes* pushes = nullptr;    // null: none
  Obstacles obstacles{};
  double run_start = 0;         // the scene's time when frames of this length began, and ...
  std::uint64_t run_steps = 0;  // ... how many there were since then
  bool from_launch = false;     // no world steps it: it ends at rest on a thing that rests
};

/// Flies on. The record has all but its path: what is in use, conditions, body and rotor as they are now. The bits at
/// the ends of frames are those of a world (world/step/settle.cpp, world/step/forced_step.cpp).
void fly_on(FlightRecord& record, const FrameStart& from, const Tolerance& tolerance, const Until& until);

}  // namespace physim
