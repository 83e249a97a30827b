// Worlds and projectiles that tests share.
#pragma once

#include "support.hpp"

namespace physim {

inline World make_world(const WorldDef& def) { return must(World::create(def)); }
inline World make_world(const WorldDef& def, const Scene& scene) {
  World world = make_world(def);
  EXPECT_TRUE(world.set_scene(scene));
  return world;
}

/// The world that a save of this one makes.
inline World reloaded(const World& world, const LoadOptions& options = {}) {
  return must(World::load(must(world.save()), options));
}

/// Ends the world's recording and replays it: all of it is there, and nothing differs.
inline ReplayReport replayed(World& world, const std::vector<std::byte>& recording, const ReplayOptions& options = {},
                             const std::string& about = "") {
  EXPECT_TRUE(world.stop_recording()) << about;
  ReplayReport report = must(replay(recording, options), about);
  EXPECT_TRUE(report.complete) << about;
  EXPECT_FALSE(report.difference) << about << report.difference->call << ": " << report.difference->what;
  return report;
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
  return {.mass = 0.01134,
          .diameter = 0.00782,
          .drag = {.table = DragTable::g7, .ballistic_coefficient = 170, .damping = 0.9, .k1 = 0.001, .k2 = 0.00002}};
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
