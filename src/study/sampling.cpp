#include "study/sampling.hpp"

#include <bit>
#include <numeric>
#include <vector>

#include "study/draw_job.hpp"
#include "study/sobol.hpp"

namespace physim {
namespace {

/// Pairs of them in lanes; a pair may have a half before the first number, or behind the last.
void fill_random(std::uint64_t seed, unsigned dimension, std::uint64_t first, std::span<double> numbers) {
  const auto bits_of = [&](std::uint64_t pair) { return philox_pair(seed, DrawStream::draw, dimension, 0, pair); };
  const std::size_t before = first % 2;
  if (before == 1) numbers[0] = unit_of_digits(bits_of(first / 2).odd >> 12);
  const std::size_t pairs = (numbers.size() - before) / 2, drawn = before + 2 * pairs;
  PHYSIM_ASSERT(drawn <= numbers.size() && drawn + 1 >= numbers.size());
  const std::uint32_t stream = dimension_and_stream(dimension, DrawStream::draw);
  draw_kernel().units({seed, stream, 0, (first + before) / 2, pairs, numbers.data() + before});
  if (drawn < numbers.size()) numbers[drawn] = unit_of_digits(bits_of((first + drawn) / 2).even >> 12);
}

void fill_latin(std::uint64_t seed, unsigned dimension, std::uint64_t first, std::span<double> numbers) {
  const std::size_t n = numbers.size();
  std::vector<std::uint32_t> part(n);
  std::iota(part.begin(), part.end(), 0u);
  for (std::size_t i = n; i-- > 1;) {
    const std::uint64_t bits = philox_bits(seed, DrawStream::permutation, dimension, 0, first + i) >> 32;
    std::swap(part[i], part[static_cast<std::size_t>(bits * (i + 1) >> 32)]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto within = static_cast<std::uint32_t>(philox_bits(seed, DrawStream::draw, dimension, 0, first + i) >> 32);
    numbers[i] = (part[i] + open_unit(within)) / static_cast<double>(n);
  }
}

}  // namespace

void Sampler::fill(unsigned dimension, std::uint64_t shard, std::span<double> numbers) const {
  PHYSIM_ASSERT(!numbers.empty());
  const std::uint64_t first = shard * numbers.size();
  switch (sampling) {
    case Sampling::random: return fill_random(seed, dimension, first, numbers);
    case Sampling::latin_hypercube: return fill_latin(seed, dimension, first, numbers);
    case Sampling::sobol: {
      const auto replicate = static_cast<std::uint32_t>(shard % kReplicates);
      const std::uint64_t begin = shard / kReplicates * numbers.size();
      const auto bits = static_cast<unsigned>(std::bit_width(begin + numbers.size() - 1));
      return fill_sobol(scrambled_dimension(seed, dimension, replicate, bits), begin, numbers);
    }
  }
  PHYSIM_UNREACHABLE();
}

}  // namespace physim
