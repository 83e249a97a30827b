// RunState: what changes during a run of a scenario's world, beside the world.
#pragma once

#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim {

/// What is remembered of a projectile.
struct Track {
  std::uint32_t generation = 0;
  Launched launched;
  bool touched = false;  // the ground or the wall
  double since = 0;
  Vec3d from;
  std::size_t hit = 0;  // its last one, in RunState::thing_hits of this step
};

/// What is still to be fired of a group, but for those of emitters.
struct Magazine {
  std::size_t group = 0;
  std::uint64_t fired = 0;
  Volley volley;  // of a shot fired alone: one launch without spread
  Launch launch;  // its bore is known
};

struct RunState {
  std::vector<WorldGroup> groups;
  std::vector<Magazine> magazines;  // not empty yet
  std::vector<Track> tracks;        // by index of the projectile's id
  std::vector<RunEvent> events;
  std::vector<WallHit> hits;
  std::vector<ThingHit> thing_hits;
  std::vector<ProjectileId> lone;  // by shot: of those fired by themselves
  std::uint64_t launches = 0;
  bool is_loaded = false;  // the launches of the next step are made
};

/// A run as bytes: its state and the save of its world, with what its world was made from.
[[nodiscard]] std::vector<std::byte> saved_run(const RunState& state, std::uint64_t scenario,
                                               const std::vector<std::byte>& world);
struct SavedRun {
  RunState state;
  std::uint64_t scenario = 0;    // its hash
  std::vector<std::byte> world;  // World::save()
};
[[nodiscard]] Result<SavedRun> read_run(std::span<const std::byte> save);

}  // namespace physim
