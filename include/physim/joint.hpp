// Joint: a rod, a cable or a spring that holds a projectile of a world to another one, or to a fixed point.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>

#include "physim/ids.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// Names a joint of one world. Ids of joints that are gone are told from those of what took their place.
struct JointId {
  std::uint32_t index = 0;       ///< 0: none [-]
  std::uint32_t generation = 0;  ///< [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const JointId&) const = default;
};

enum class JointKind : std::uint8_t {
  rod,     ///< keeps the distance of its ends: it pulls and pushes
  cable,   ///< lets them come nearer, and not farther apart: it only pulls
  spring,  ///< Hooke's law with damping; it is stable however stiff it is
};

/// What holds two projectiles, or one to a point. It has no mass, is straight, meets nothing, and ends in the middles
/// of projectiles, which it does not turn.
struct Joint {
  JointKind kind = JointKind::rod;  ///< [-]
  ProjectileId a{};                 ///< one end [-]
  ProjectileId b{};                 ///< the other end; null: `point` [-]
  Vec3d point{};                    ///< of the world, where there is no b [m]
  std::optional<double> length{};   ///< of a rod, of a cable that is taut, of a spring at rest; above 0; none: as far
                                    ///< as its ends are apart when it is added [m]
  double restitution = 0;           ///< of a cable: speed kept when it comes taut, 0..1; 0: its ends go on together [-]
  double stiffness = 1;             ///< of a spring [N/m]
  double damping = 0;               ///< of a spring: of the rate at which its length changes [kg/s]

  bool operator==(const Joint&) const = default;
};

/// How a joint is now.
struct JointState {
  double length = 0;     ///< distance of its ends [m]
  double tension = 0;    ///< with which it pulled them together, on the mean of the last step; negative: it pushed [N]
  bool is_taut = false;  ///< rods and springs: always; a cable that is as long as it can be [-]
};

enum class JointEventKind : std::uint8_t {
  came_taut,  ///< a cable that hung loose
  ended,      ///< a projectile at one of its ends left the world
};

struct JointEvent {
  JointEventKind kind = JointEventKind::ended;  ///< [-]
  JointId joint{};                              ///< [-]
  ProjectileId projectile{};                    ///< who left; of a cable that came taut: its first end [-]
  double time = 0;                              ///< the end of the step in which it was [s]
  double speed = 0;                             ///< at which the ends of a cable parted before [m/s]
};

/// How well joints were kept.
struct JointCounts {
  std::size_t joints = 0;      ///< there are now [-]
  std::uint32_t rounds = 0;    ///< most that one net of joints took in the last step [-]
  double residual = 0;         ///< the farthest that a rod or a taut cable was from its length after it [m]
  std::uint64_t unsolved = 0;  ///< nets in a step that were not found within their rounds, since the world was made [-]
};

}  // namespace physim

template <>
struct std::hash<physim::JointId> {
  std::size_t operator()(const physim::JointId& id) const noexcept {
    return std::hash<std::uint64_t>()(id.index | std::uint64_t{id.generation} << 32);
  }
};
