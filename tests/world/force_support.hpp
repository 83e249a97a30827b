// Worlds with nothing but the forces that a test brings along.
#pragma once

#include "scene_support.hpp"

namespace physim {

using test_scene::rung;

inline ProjectileDef ball(const Fidelity& fidelity, double mass = 1) {
  return {.mass = mass, .diameter = 0.1, .fidelity = fidelity};
}

/// Nothing but what the test brings along.
inline WorldDef empty_space(bool gravity = false) {
  return {.environment = {.gravity = {.model = gravity ? GravityModel::constant : GravityModel::off},
                          .atmosphere = {.model = AirModel::vacuum}},
          .ground = {.mode = GroundMode::none}};
}

inline World make(const WorldDef& def) { return std::move(World::create(def).value()); }

inline Launch at(const Vec3d& position, const Vec3d& velocity = {}) {
  return {.position = position, .velocity = velocity};
}

inline ForceDef force(ForceLaw law, ForceTarget target) { return {.law = std::move(law), .target = std::move(target)}; }

inline AnchoredSpring spring_to_origin(double stiffness) { return {.stiffness = stiffness}; }

inline void steps(World& world, int count, double dt) {
  for (int i = 0; i < count; ++i) ASSERT_TRUE(world.step(dt));
}

inline std::vector<EventKind> kinds(const World& world) {
  std::vector<EventKind> list;
  for (const Event& e : world.events()) list.push_back(e.kind);
  return list;
}

}  // namespace physim
