// Track: what is remembered of one projectile, for its trail, plots and marks.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physim/flight.hpp"
#include "physim/world.hpp"
#include "scenario/scenario.hpp"
#include "simclient/core/bodies.hpp"
#include "simclient/core/palette.hpp"

namespace physim::client {

/// The colour of a body that was given none.
inline constexpr Colour kNoColour = 0xFFFFFFFF;

/// A projectile after one step of the world, or at an event within it.
struct TrackSample {
  double time = 0;  // since its launch [s]
  Vec3d position, velocity, acceleration;
  double mach = 0;
  double mass = 0;  // what is left of it [kg]
  Vec3d jerk{};     // [m/s^3]

  bool operator==(const TrackSample&) const = default;
};

/// On the straight line in time between two samples, at a part of it.
[[nodiscard]] inline TrackSample between(const TrackSample& a, const TrackSample& b, double part) {
  const auto mix = [part](const auto& x, const auto& y) { return x + (y - x) * part; };
  return {mix(a.time, b.time),         mix(a.position, b.position),
          mix(a.velocity, b.velocity), mix(a.acceleration, b.acceleration),
          mix(a.mach, b.mach),         mix(a.mass, b.mass),
          mix(a.jerk, b.jerk)};
}

/// A projectile as it is now, so long after its launch.
[[nodiscard]] inline TrackSample sample_of(const ProjectileView& projectile, double time) {
  const BodyState at = projectile.state();
  return {time,
          at.position,
          at.velocity,
          projectile.accelerations().total,
          projectile.mach(),
          projectile.mass(),
          projectile.jerk()};
}

/// A flight so long after its launch.
[[nodiscard]] inline TrackSample sample_of(const Flight& flight, double time) {
  const Sample at = flight.at(time);
  return {at.time, at.position, at.velocity, at.acceleration, at.mach, at.mass, flight.jerk(at.time)};
}

struct Track {
  ProjectileId id;
  std::uint64_t number = 0;  // of its launch in this session, from 1
  std::string name;
  Colour colour = 0xFFFFFFFF;
  double radius = 0;                 // [m]
  BodyLook look;                     // what it is drawn as
  Vec3d spin;                        // of a ball, at launch [rad/s]
  double born = 0;                   // [s] of the world
  FidelityInUse granted;             // as it was at launch
  std::vector<TrackSample> samples;  // see thinning.hpp
  std::size_t thinned = 0;           // the number of the last one that has been thinned out
  double coarseness = 1;             // of that, from 1
  std::optional<TrackSample> apex, impact;
  std::optional<double> burnout;  // of its motor, since launch [s]
  LifeStatus status = LifeStatus::in_flight;
  bool by_hand = false;                      // fired by one, not by the scenario
  std::shared_ptr<const ScenarioShot> shot;  // that was fired by hand; null: by the scenario
  bool is_at_wall = false;                   // that of its world stopped it
  bool edited = false;                       // something about it was changed while it flew
  std::shared_ptr<const Flight> whole;       // computed before it is shown, and played; null: it flies in the world
  std::shared_ptr<const std::vector<TrackSample>> path;  // of that, to its end
  std::size_t passed = 1;                                // samples of the path that it has passed

  [[nodiscard]] bool is_flying() const { return status == LifeStatus::in_flight; }
  /// When it ended, or its last sample where it flies, of the world [s].
  [[nodiscard]] double end() const { return born + samples.back().time; }
  /// "artillery #3".
  [[nodiscard]] std::string title() const { return name + " #" + std::to_string(number); }
};

}  // namespace physim::client
