// Drawing many numbers at a time: what the kernels of each instruction set offer, and the choice among them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace physim {

/// Random numbers in (0, 1) of one input, see study/sampling.hpp: two for each counter of Philox.
struct UnitsJob {
  std::uint64_t seed;
  std::uint32_t dimension_and_stream, replicate;  // words of all counters
  std::uint64_t first_pair;
  std::size_t pairs;
  double* numbers;  // twice as many
};

struct NormalScale {
  double mean = 0, deviation = 1;
};

struct DrawKernel {
  const char* name;
  void (*units)(const UnitsJob& job);
  /// mean + deviation z with Phi(z) = p in the place of each p.
  void (*normals)(double* numbers, std::size_t count, const NormalScale& scale);
};

/// That of the instruction set of the batch kernel in use.
[[nodiscard]] const DrawKernel& draw_kernel();

}  // namespace physim
