// What tests of the things that worlds meet share: worlds of nothing else, and what is thrown at them.
#pragma once

#include "world/world_support.hpp"

namespace physim::test_things {

inline Launch launched(const Vec3d& position, const Vec3d& velocity) {
  return {.position = position, .velocity = velocity};
}

/// Without a ground, in a vacuum.
inline WorldDef nothing_but_things() {
  return {.environment = {.atmosphere = {.model = AirModel::vacuum}}, .ground = {.mode = GroundMode::none}};
}

/// A rifle bullet.
inline ProjectileDef shot(Precision precision = Precision::float64) {
  ProjectileDef p = stone();
  p.mass = 0.0109;
  p.diameter = 0.00782;
  p.fidelity.precision = precision;
  return p;
}

/// Loses nothing by itself, and never sleeps.
inline BodyDef body_that(OnHit on_hit, double radius = 0) {
  BodyDef body;
  body.restitution = body.friction = 1;
  body.rolling_resistance = 0;
  body.can_sleep = false;
  body.collision = {.on_hit = on_hit, .radius = radius};
  return body;
}

}  // namespace physim::test_things
