// Worlds with nothing but the forces that a test brings along.
#pragma once

#include "scene_support.hpp"
#include "support.hpp"

namespace physim {

using test_scene::rung;

inline ProjectileDef ball(const Fidelity& fidelity, double mass = 1) {
  ProjectileDef p;
  p.mass = mass;
  p.diameter = 0.1;
  p.fidelity = fidelity;
  return p;
}

/// Nothing but what the test brings along.
inline WorldDef empty_space(bool gravity = false) {
  WorldDef def;
  def.environment.gravity.model = gravity ? GravityModel::constant : GravityModel::off;
  def.environment.atmosphere.model = AirModel::vacuum;
  def.ground.mode = GroundMode::none;
  return def;
}

inline World make(const WorldDef& def) { return std::move(World::create(def).value()); }

inline Launch at(const Vec3d& position, const Vec3d& velocity = {}) {
  Launch l;
  l.position = position;
  l.velocity = velocity;
  return l;
}

inline ForceDef force(ForceLaw law, ForceTarget target) {
  ForceDef f;
  f.law = std::move(law);
  f.target = std::move(target);
  return f;
}

inline AnchoredSpring spring_to_origin(double stiffness) {
  AnchoredSpring s;
  s.stiffness = stiffness;
  return s;
}

inline void steps(World& world, int count, double dt) {
  for (int i = 0; i < count; ++i) ASSERT_TRUE(world.step(dt));
}

inline std::vector<EventKind> kinds(const World& world) {
  std::vector<EventKind> list;
  for (const Event& e : world.events()) list.push_back(e.kind);
  return list;
}

}  // namespace physim
