// How things in a scene move: with a steady velocity and turn, or from key to key.
#pragma once

#include <variant>
#include <vector>

#include "physim/quat.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// Stands where its transform puts it.
struct AtRest {
  bool operator==(const AtRest&) const = default;
};

/// Moves and turns steadily, before `start` too; where its transform puts it, it is at `start`.
struct SteadyMotion {
  double start = 0;          ///< within 1e9 s [s]
  Vec3d velocity{};          ///< of its own origin, in W, up to 1e9 m/s [m/s]
  Vec3d angular_velocity{};  ///< about its own origin, in W, up to 1e6 rad/s [rad/s]

  bool operator==(const SteadyMotion&) const = default;
};

/// Where a thing is at a time.
struct MotionKey {
  double time = 0;   ///< later than the key before, within 1e9 s [s]
  Vec3d position{};  ///< of its own origin in W [m]
  Quatd rotation{};  ///< from its own frame to W; of any length but zero [-]
  Vec3d velocity{};  ///< of its own origin, where MotionCurve::smooth asks for it, up to 1e9 m/s [m/s]

  bool operator==(const MotionKey&) const = default;
};

/// Which way a thing takes from one key to the next. It turns at a steady rate, the shorter way round, in either case.
enum class MotionCurve {
  straight,  ///< at a steady velocity
  smooth,    ///< along the cubic (Hermite's) that has the positions and velocities of the keys
};

/// Goes from key to key; stands before the first and after the last one. Of its transform only the scale counts.
struct KeyedMotion {
  std::vector<MotionKey> keys{};              ///< one at least, 1e6 at most [-]
  MotionCurve curve = MotionCurve::straight;  ///< [-]

  bool operator==(const KeyedMotion&) const = default;
};

using SceneMotion = std::variant<AtRest, SteadyMotion, KeyedMotion>;

/// Where a thing is and how it moves at one time.
struct MotionState {
  Vec3d position{};          ///< of its own origin in W [m]
  Quatd rotation{};          ///< from its own frame to W [-]
  Vec3d velocity{};          ///< of its own origin [m/s]
  Vec3d angular_velocity{};  ///< in W [rad/s]
};

/// The velocity of the point of a thing that is at a place in W [m/s].
[[nodiscard]] Vec3d velocity_at(const MotionState& state, const Vec3d& place);

}  // namespace physim
