// Asking backwards: aim() finds the directions that hit a target, max_range() the one that carries farthest.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physim/flight.hpp"

namespace physim {

/// What is to be hit: a point, standing or moving, by where it is when the shot is fired.
struct Target {
  Vec3d position{};      ///< at launch, in W [m]
  Vec3d velocity{};      ///< at launch [m/s]
  Vec3d acceleration{};  ///< constant [m/s^2]

  /// Where the target is at a time after launch [s].
  [[nodiscard]] Vec3d at(double time) const;
  /// How fast it moves then [m/s].
  [[nodiscard]] Vec3d velocity_at(double time) const;

  bool operator==(const Target&) const = default;
};

/// Which of the ways to a target.
enum class Arc {
  low,   ///< the one of the shortest time of flight
  high,  ///< the one of the longest
  both,
};

/// How to aim.
struct AimOptions {
  Arc arc = Arc::both;             ///< which solutions are looked for [-]
  double tolerance = 0.01;         ///< a path that passes so near to the target hits it [m]
  std::optional<double> ground{};  ///< height of ground that stops the shot; none: no ground [m]
  double time = 600;               ///< longest time of flight [s]
  Tolerance flight{};              ///< of the flights [-]
  const Scene* scene = nullptr;  ///< things that may stand in the way; null: none. It must stay while the call runs [-]
  ContactDef contact{};          ///< of it collision.radius, collision.layers and scene_time are read [-]
  InstanceId target_thing{};     ///< the thing of the scene that is to be hit, which is in nobody's way; or none [-]
};

/// A direction that was flown, and how it passed the target.
struct AimSolution {
  Launch launch{};           ///< with the elevation and azimuth found, and a plain sight: fly() it to see it hit [-]
  double miss = 0;           ///< distance between projectile and target where they are closest, as flown [m]
  double time = 0;           ///< of flight, to there [s]
  Vec3d position{};          ///< of the projectile there [m]
  Vec3d velocity{};          ///< of the projectile there [m/s]
  double speed = 0;          ///< |velocity| [m/s]
  double descent = 0;        ///< angle of the path there, downwards positive [rad]
  std::int64_t flights = 0;  ///< trajectories flown to find it [-]
};

/// A way to the target that something stands in.
struct BlockedWay {
  AimSolution solution{};  ///< as it hits where nothing stands [-]
  Event hit{};             ///< what it meets, and where [-]
};

/// The answer of aim().
struct Aim {
  std::optional<AimSolution> low{};   ///< of the shortest time of flight, where it was asked for [-]
  std::optional<AimSolution> high{};  ///< of the longest; equal to `low` where only one exists [-]
  AimSolution nearest{};              ///< the closest that any flight came; a solution, where there is one [-]
  bool behind_ground = false;         ///< paths hit the target, but only through AimOptions::ground [-]
  std::vector<BlockedWay>
      blocked{};  ///< ways to the target that something of AimOptions::scene stands in, low first [-]
  std::optional<Event> sight_ends{};  ///< what hides the target from the muzzle, EventKind::hit; none: nothing does [-]
  std::int64_t flights = 0;           ///< trajectories flown in all; those that find a fixed step are not counted [-]
  FidelityInUse fidelity_in_use{};    ///< of the flights [-]

  [[nodiscard]] bool in_reach() const { return low || high; }
  /// "hit in 2.18 s, ..." or "out of reach: the nearest path passes 12 m from the target".
  [[nodiscard]] std::string explanation() const;
};

/// Finds the bore elevation and azimuth with which a projectile of launch.speed hits a target, flown with the models of
/// `fidelity`. Elevation, azimuth and sight of `launch` are not read. Every solution was flown, and its path passes
/// within options.tolerance. If no path does, the answer has the nearest one that was found. Returns an error for bad
/// input, and if all flights together take more than five million steps or 20 million evaluations of forces.
///
/// A rocket may start from rest on a rail: the ways to the target of the shortest and of the longest time are found,
/// of those that a fan of flights over all elevations shows.
///
///   const auto answer = aim(shell, {.speed = 300}, {}, Fidelity::simulation(), {.position = {5000, 120, 300}});
///   if (answer && answer->low) fire(answer->low->launch);
[[nodiscard]] Result<Aim> aim(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                              const Fidelity& fidelity, const Target& target, const AimOptions& options = {});

/// The answer of max_range().
struct MaxRange {
  double elevation = 0;      ///< of the bore above the horizon [rad]
  double range = 0;          ///< along the ground, from below the muzzle to the point of impact [m]
  double time = 0;           ///< of flight [s]
  Vec3d position{};          ///< of impact [m]
  Vec3d velocity{};          ///< at impact [m/s]
  std::int64_t flights = 0;  ///< trajectories flown [-]
};

/// The bore elevation that carries farthest over even ground that rises with `slope` [rad] in the direction of fire,
/// launch.azimuth, and lies at the height `ground` [m] below or at the muzzle. An error where there is no farthest: the
/// shot does not come down within `time` [s]; and where all flights together take more than five million steps
/// or 20 million evaluations of forces.
[[nodiscard]] Result<MaxRange> max_range(const ProjectileDef& projectile, const Launch& launch,
                                         const Environment& environment, const Fidelity& fidelity, double ground = 0,
                                         double slope = 0, double time = 3600);

/// Ranges along the line of sight between which a flight stays near a height over it.
struct DangerSpace {
  double from = 0;  ///< [m]
  double to = 0;    ///< [m]
};

/// The ranges around `range` [m] within which a target of a height [m], aimed at in its middle, is hit by a flight that
/// passes its middle at `range`: the path lies within half the height of where it is there. Ends with the flight.
[[nodiscard]] Result<DangerSpace> danger_space(const Flight& flight, double range, double height);
/// ... of a target that stands on the ground of a scene, which is as it is at time 0: the ranges around `range` within
/// which the path lies no more than `height` [m] above the nearest surface below it, of things of these layers but for
/// sensors. It is looked at each quarter of the height along the path; where a step of the ground is narrower, it may
/// be missed. Ends with the flight. An error where the path lies higher at `range`, or over no ground.
[[nodiscard]] Result<DangerSpace> danger_space(const Flight& flight, double range, double height, const Scene& ground,
                                               std::uint32_t layers = 0xffffffff);

/// Time of flight [s] to a range [m] along the line of sight of `launch`, with its elevation or its zero range.
[[nodiscard]] Result<double> time_to_range(const ProjectileDef& projectile, const Launch& launch,
                                           const Environment& environment, const Fidelity& fidelity, double range);

}  // namespace physim
