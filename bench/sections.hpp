// The sections of the benchmark's report.
#pragma once

#include "contenders.hpp"
#include "report.hpp"
#include "timing.hpp"

namespace physim::bench {

struct Options {
  bool quick = false;
  Clock clock = Clock::wall;
  std::size_t flights = 20000;  // of a batch
  int rounds = 21;
  double slice = 0.02;  // a peer's turn [s]
  int per_decade = 16;  // tolerances tried in calibration
  std::string rockets;  // a folder of scenario files; empty: none
};

/// All contenders on the .308 shot at one achieved error. `tolerance` gets what the Tsit5 packs were calibrated to.
[[nodiscard]] Section equal_error_section(const Options& options, double target, double* tolerance);
/// Mixed projectiles against equal ones, at the tolerance of the uniform shot.
[[nodiscard]] Section mixed_section(const Options& options, double tolerance);
[[nodiscard]] Section allocation_section(const Options& options);
/// Batches on two threads beside two processes.
[[nodiscard]] Section threads_section(const Options& options);
/// Studies beside flights of which nothing is uncertain.
[[nodiscard]] Section study_section(const Options& options);
[[nodiscard]] Section micro_section(const Options& options);
/// How many trajectories aim() takes, and whether its solutions hit.
[[nodiscard]] Section aim_section(const Options& options);
/// Rigid bodies.
[[nodiscard]] Section rotation_section(const Options& options);
/// Single flights of rockets: a smooth one, and those of a folder.
[[nodiscard]] Section rockets_section(const Options& options);
/// Segments cast into scenes beside Embree and Bullet.
[[nodiscard]] Section casts_section(const Options& options);
/// How long a mesh takes to be added, and what it takes in memory.
[[nodiscard]] Section build_section(const Options& options);
/// Worlds of bullets near the things of a scene and far from them.
[[nodiscard]] Section scene_worlds_section(const Options& options);
/// Worlds beside the original loop and Bullet; their rungs; what each operation costs; emitters.
[[nodiscard]] std::vector<Section> world_sections(const Options& options);
/// Worlds of many rungs beside worlds of one.
[[nodiscard]] Section switches_section(const Options& options);
/// What each effect of a bullet costs in a step, and how far off it is without.
[[nodiscard]] Section effects_section(const Options& options);
/// Laws that games invent.
[[nodiscard]] Section arcade_section(const Options& options);
/// One shot by the rules of other engines, by Cyclone and Bullet, and on PhySim's rungs: error and cost.
[[nodiscard]] Section engines_section(const Options& options);

}  // namespace physim::bench
