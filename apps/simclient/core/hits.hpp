// Hits: what projectiles did with the things of a scene, for marks and lists.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "physim/world.hpp"
#include "scenario/scenario.hpp"
#include "simclient/core/palette.hpp"

namespace physim::client {

/// A projectile met a thing. Places are those in the thing's own frame, so that they move as it does.
struct Hit {
  ProjectileId id;
  std::string shot;             // what the projectile is called, "bullet #3"
  Colour colour = 0;            // of the projectile
  double radius = 0;            // of the projectile [m]
  InstanceId instance;          // the thing
  std::uint32_t primitive = 0;  // of it, as SceneHit::primitive
  std::string thing;            // its name
  std::string material;         // name of its material; empty: none is known
  double time = 0;              // of the world [s]
  Vec3d position;               // where it was met, in W then [m]
  Vec3d at, normal;             // of its surface, in its frame [m]; outwards [-]
  Vec3d end;                    // where it came out or stayed, in the frame of the thing [m]
  Vec3d velocity, after;        // before and after, in W [m/s]
  Vec3d surface_velocity;       // of the surface there [m/s]
  double obliquity = 0;         // between its way, as seen from the surface, and the normal [rad]
  double depth = 0;             // how far it went in [m]
  double energy = 0;            // that it lost by what the material did to it [J]
  /// bounced, ricocheted, penetrated, stopped; entered, left or sensed for what is passed.
  EventKind outcome = EventKind::hit;

  // Speeds as seen from the surface, which is what materials go by; 0 after what it stayed in or at [m/s].
  [[nodiscard]] double speed() const;
  [[nodiscard]] double speed_after() const;
};

/// A place in the frame of a thing, in W.
[[nodiscard]] Vec3d place_in_world(const MotionState& thing, const Vec3d& at);

/// The thing was no obstacle.
[[nodiscard]] bool is_passed(const Hit& hit);

/// The last hits of a world.
class HitLog {
 public:
  static constexpr std::size_t kMost = 256;

  /// What happened in a step. Contacts that go on, of what slides, rolls or rests on a thing, are none.
  void look_at(const World& world, std::span<const Event> events);
  /// The first to the last.
  [[nodiscard]] const std::deque<Hit>& hits() const { return hits_; }
  /// How many there were, those that were forgotten too.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  void clear() { hits_.clear(), gone_.clear(), count_ = 0; }
  void forget_after(double time);
  /// Other things stand in the scene: hits on those that are gone leave the list, and come again with them.
  void change_things(const std::vector<ScenarioThing>& before, const std::vector<ScenarioThing>& after);
  /// The last hit of a projectile, on a thing that is gone too; null: it has none.
  [[nodiscard]] const Hit* last_of(ProjectileId id) const;

 private:
  struct Gone {
    Hit hit;
    ScenarioThing thing;
  };

  void add(Hit hit);

  std::deque<Hit> hits_;
  std::vector<Gone> gone_;
  std::uint64_t count_ = 0;
};

}  // namespace physim::client
