// Contradictions in where things and emitters are and how they move.
#pragma once

#include <string>
#include <utility>

#include "scenario/document.hpp"
#include "scenario/scenario.hpp"

namespace physim {

/// `path` and `table`: what is turned, and where the file says it.
[[nodiscard]] inline Status check_rotation(const std::string& path, const ScenarioRotation& rotation,
                                           const Value& table) {
  const bool by_angles = rotation.yaw != 0 || rotation.pitch != 0 || rotation.roll != 0;
  if (rotation.angle != 0 && by_angles)
    return Error{path + ".rotation: given by an angle and by yaw, pitch and roll", place_of(table, {"rotation"}),
                 "give one of them"};
  if (rotation.axis == Vec3d{})
    return Error{path + ".rotation.axis: it has no direction", place_of(table, {"rotation", "axis"}), ""};
  return {};
}

/// A motion said by the members of ScenarioMotion, which the file has in `motion`: `table` itself or a table in it.
template <class Moving>
[[nodiscard]] Status check_motion(const std::string& path, const Moving& moving, const Vec3d& position,
                                  const ScenarioRotation& rotation, const Value& table, const Value& motion) {
  const std::string path_of_motion = &motion == &table ? path : path + ".motion";
  if (Status status = check_rotation(path, rotation, table); !status) return status;
  for (std::size_t i = 0; i < moving.keys.size(); ++i)
    if (Status status = check_rotation(path_of_motion + ".keys", moving.keys[i].rotation, element(motion, "keys", i));
        !status)
      return status;
  if (moving.keys.empty()) return {};
  const auto said_twice = [](const std::string& setting, const Value& where, std::string_view key) {
    return Error{setting + "." + std::string(key) + ": given together with keys", place_of(where, {key}),
                 "the keys say where it is and how it moves"};
  };
  if (moving.velocity != Vec3d{}) return said_twice(path_of_motion, motion, "velocity");
  if (moving.angular_velocity != Vec3d{}) return said_twice(path_of_motion, motion, "angular_velocity");
  if (position != Vec3d{}) return said_twice(path, table, "position");
  const bool is_turned = rotation.angle != 0 || rotation.yaw != 0 || rotation.pitch != 0 || rotation.roll != 0;
  if (is_turned) return said_twice(path, table, "rotation");
  return {};
}

}  // namespace physim
