// Worlds and projectiles that tests share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "physim/world.hpp"
#include "support.hpp"

namespace physim {

inline World make_world(const WorldDef& def) {
  auto made = World::create(def);
  if (!made) ADD_FAILURE() << made.error().text();
  return made ? std::move(made.value()) : World();
}

inline std::vector<Event> events_of(const World& world, EventKind kind) { return test::of_kind(world.events(), kind); }

/// A stone without drag.
inline ProjectileDef stone() {
  ProjectileDef p;
  p.fidelity = Fidelity::game();
  p.fidelity.drag = DragModel::off;
  p.fidelity.precision = Precision::float64;
  return p;
}

inline ProjectileDef bullet() {
  ProjectileDef p;
  p.mass = 0.01134;
  p.diameter = 0.00782;
  p.drag.table = DragTable::g7;
  p.drag.ballistic_coefficient = 170;
  p.drag.damping = 0.9;
  p.drag.k1 = 0.001;
  p.drag.k2 = 0.00002;
  return p;
}

/// Steps until `seconds` have passed and gathers the events.
inline std::vector<Event> run_for(World& world, double seconds, double step = 1.0 / 64) {
  std::vector<Event> all(world.events().begin(), world.events().end());
  const double end = world.time() + seconds - 0.5 * step;
  while (world.time() < end) {
    world.step(step);
    all.insert(all.end(), world.events().begin(), world.events().end());
  }
  return all;
}

/// Shells that land in the same step.
inline World volley(int count) {
  World world;
  for (int i = 0; i < count; ++i)
    EXPECT_TRUE(world.spawn(stone(), {.position = {double(i), 0.01, 0}, .velocity = Vec3d{0, -5, 0}}));
  return world;
}

}  // namespace physim
