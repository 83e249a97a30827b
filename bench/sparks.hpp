// Sparks of emitters that the benchmark and the program for profilers (alone/emitters.cpp) have in common.
#pragma once

#include <cstdint>
#include <vector>

#include "physim/emitter.hpp"
#include "physim/world.hpp"

namespace physim::bench {

/// Upwards out of a cone, 5 to 10 m/s.
[[nodiscard]] EmitterDef spray(KindId kind, double per_second, const DrawnNumber& lifetime);
/// No ground.
[[nodiscard]] World empty_world();

/// A million sparks of the game preset in a steady flow, that grow smaller and darker as they grow older: without and
/// with drag over life.
struct SteadySparks {
  static constexpr std::size_t kCount = 1000000;
  static constexpr double kShortest = 1.5, kLongest = 2.5, kMean = 2;  // lives [s]
  static constexpr double kFlow = 1.0 / 60;                            // frame [s]
  static constexpr double kPerSecond = kCount / kMean;
  static constexpr int kFramesBefore = static_cast<int>(1.1 * kLongest / kFlow);  // until the flow is steady

  SteadySparks();
  void step() { world.step(kFlow); }
  void step_driven() { driven.step(kFlow); }
  /// What a renderer reads.
  void read_places() { world.particles(emitter, {.position = position}); }
  void read_looks() { world.particles(emitter, {.position = position, .size = size, .colour = colour}); }

  World world = empty_world(), driven = empty_world();
  EmitterId emitter;
  std::vector<Vec3d> position = std::vector<Vec3d>(kCount + kCount / 16), size = position;
  std::vector<std::uint32_t> colour = std::vector<std::uint32_t>(position.size());
};

}  // namespace physim::bench
