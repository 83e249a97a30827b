// What a scenario says of its scene: shapes, and things that have them. Part of physim_scenario.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "physim/scene.hpp"

namespace physim {

struct Scenario;

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

/// One [[shape]]. A compound, which no file can say, is none yet.
struct ScenarioShape {
  std::string name{};                ///< [-]
  std::string file{};                ///< that its mesh or heights were read from, as the scenario says it [-]
  double low = 0;                    ///< height of black in a file of heights [m]
  double high = 1;                   ///< height of white in a file of heights [m]
  ShapeDef shape = CompoundShape{};  ///< [-]
};

/// Where a thing is at a time.
struct ScenarioKey {
  double time = 0;              ///< of the world [s]
  Vec3d position{};             ///< [m]
  ScenarioRotation rotation{};  ///< [-]
  Vec3d velocity{};             ///< for MotionCurve::smooth [m/s]
};

/// One [[thing]] of the scene. It rests where nothing is said about its motion.
struct ScenarioThing {
  std::string name{};                         ///< in tables [-]
  std::string shape{};                        ///< name of its shape [-]
  std::string material{};                     ///< name of its material; empty: that of every scene [-]
  Vec3d position{};                           ///< [m]
  ScenarioRotation rotation{};                ///< [-]
  double scale = 1;                           ///< along all axes [-]
  std::uint32_t layers = 1;                   ///< bits [-]
  bool sensor = false;                        ///< told of, and passed [-]
  double start = 0;                           ///< at which a steady motion has it at its position [s]
  Vec3d velocity{};                           ///< steady [m/s]
  Vec3d angular_velocity{};                   ///< steady, in W [rad/s]
  std::vector<ScenarioKey> keys{};            ///< instead of a steady motion [-]
  MotionCurve curve = MotionCurve::straight;  ///< from key to key [-]
};

/// The scene of a scenario, its things in their order, each with its index as InstanceDef::user_data. An error names
/// the shape, material or thing that is wrong.
[[nodiscard]] Result<Scene> scene_of(const Scenario& scenario);

}  // namespace physim
