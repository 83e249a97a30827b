// Evenly spread numbers for the shots of a study. Each depends on seed, dimension and shot alone.
//
// Random: a number of Philox for each. Latin hypercube: a shard's shots are dealt out to as many equal parts of (0, 1),
// one to each, by a separate permutation in every dimension; within its part a shot lies at random. Sobol: replicate
// r of the scrambled sequence flies the shards r, r + kReplicates, ... and continues from one to the next.
// Source: M. D. McKay, R. J. Beckman, W. J. Conover, "A Comparison of Three Methods for Selecting Values of Input
//   Variables ...", Technometrics 21 (1979) 239; R. A. Fisher, F. Yates, Statistical Tables (1948), for the
//   permutation; study/sobol.hpp.
#pragma once

#include <cstdint>
#include <span>

#include "base/assert.hpp"
#include "math/philox.hpp"
#include "physim/study.hpp"

namespace physim {

/// What numbers are drawn for.
enum class DrawStream : std::uint32_t { draw, permutation, scramble };

/// Errors are estimated from this many independent parts of a study.
inline constexpr std::uint32_t kReplicates = 16;

/// One word of the counters of an input; dimension < 256.
[[nodiscard]] inline std::uint32_t dimension_and_stream(std::uint32_t dimension, DrawStream stream) {
  PHYSIM_ASSERT(dimension < 256);
  return dimension | static_cast<std::uint32_t>(stream) << 8;
}

/// 64 random bits for each of two indices, 2 * pair and the next; replicate < 2^20.
struct BitsPair {
  std::uint64_t even, odd;
};
[[nodiscard]] inline BitsPair philox_pair(std::uint64_t seed, DrawStream stream, std::uint32_t dimension,
                                          std::uint32_t replicate, std::uint64_t pair) {
  PHYSIM_ASSERT(replicate < 1u << 20);
  const PhiloxCounter words = philox({static_cast<std::uint32_t>(pair), static_cast<std::uint32_t>(pair >> 32),
                                      dimension_and_stream(dimension, stream), replicate},
                                     {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  return {words[0] | std::uint64_t{words[1]} << 32, words[2] | std::uint64_t{words[3]} << 32};
}
/// 64 random bits for one index.
[[nodiscard]] inline std::uint64_t philox_bits(std::uint64_t seed, DrawStream stream, std::uint32_t dimension,
                                               std::uint32_t replicate, std::uint64_t index) {
  const BitsPair bits = philox_pair(seed, stream, dimension, replicate, index / 2);
  return index % 2 == 0 ? bits.even : bits.odd;
}

/// The middle of the cell of (0, 1) that 52 binary digits name.
[[nodiscard]] inline double unit_of_digits(std::uint64_t digits) {
  return (static_cast<double>(static_cast<std::int64_t>(digits)) + 0.5) * 0x1p-52;
}

/// How the numbers of a study are drawn.
struct Sampler {
  Sampling sampling = Sampling::random;
  std::uint64_t seed = 1;

  /// One dimension of a shard: `numbers` for its shots, or for the occasions that its shots fall into.
  void fill(unsigned dimension, std::uint64_t shard, std::span<double> numbers) const;
  /// Random numbers of a dimension from an index on, counted through all shards.
  void fill_random(unsigned dimension, std::uint64_t first, std::span<double> numbers) const;
  /// The number that fill() gives one place of a shard of `size` numbers.
  [[nodiscard]] double number(unsigned dimension, std::uint64_t shard, std::size_t size, std::size_t place) const;
};

}  // namespace physim
