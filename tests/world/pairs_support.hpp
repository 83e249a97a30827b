// Balls in empty space, for tests of what meets what.
#pragma once

#include "world/world_support.hpp"

namespace physim::test_pairs {

using test::of_kind;

inline WorldDef space(GroundMode ground = GroundMode::none) {
  return {.environment = {.atmosphere = {.model = AirModel::vacuum}}, .ground = {.mode = ground}};
}

inline ProjectileDef mass_of(double mass, Precision precision = Precision::float64) {
  ProjectileDef p = stone();
  p.mass = mass;
  p.fidelity.precision = precision;
  return p;
}

inline BodyDef ball(double radius, double restitution = 1, double friction = 0) {
  return {.gravity_scale = 0,
          .can_sleep = false,
          .restitution = restitution,
          .friction = friction,
          .collision = {.on_hit = OnHit::bounce, .radius = radius, .others = 1}};
}

inline ProjectileId put(World& world, const ProjectileDef& p, const BodyDef& body, const Vec3d& x,
                        const Vec3d& v = {}) {
  return must(world.spawn(p, {.position = x, .velocity = v}, body));
}

}  // namespace physim::test_pairs
