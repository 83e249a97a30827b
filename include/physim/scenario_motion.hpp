// How a scenario says where things and emitters are, how they are turned and how they move. Part of physim_scenario.
#pragma once

#include <vector>

#include "physim/quat.hpp"
#include "physim/scene_motion.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// How something is turned: about an axis, or by yaw, pitch and roll (quat_from_yaw_pitch_roll()), not by both.
struct ScenarioRotation {
  Vec3d axis{0, 1, 0};  ///< of any length but zero [-]
  double angle = 0;     ///< about the axis, right-handed [rad]
  double yaw = 0;       ///< of its x axis, to the right, first [rad]
  double pitch = 0;     ///< of its x axis, up, second [rad]
  double roll = 0;      ///< about its x axis, right side down, third [rad]

  /// From its own frame to W.
  [[nodiscard]] Quatd quaternion() const;
};

/// Where something is at a time.
struct ScenarioKey {
  double time = 0;              ///< of the world [s]
  Vec3d position{};             ///< [m]
  ScenarioRotation rotation{};  ///< [-]
  Vec3d velocity{};             ///< for MotionCurve::smooth [m/s]
};

/// How something moves: steadily, or from key to key. It rests where nothing is said.
struct ScenarioMotion {
  double start = 0;                           ///< at which a steady motion has it at its position [s]
  Vec3d velocity{};                           ///< steady [m/s]
  Vec3d angular_velocity{};                   ///< steady, in W [rad/s]
  std::vector<ScenarioKey> keys{};            ///< instead of a position and steady motion [-]
  MotionCurve curve = MotionCurve::straight;  ///< from key to key [-]
};

}  // namespace physim
