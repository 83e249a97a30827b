#include "study/sampling.hpp"

#include <bit>
#include <numeric>
#include <vector>

#include "study/draw_job.hpp"
#include "study/sobol.hpp"

namespace physim {
namespace {

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

struct ShardOfPoints {
  std::uint64_t shard;
  std::size_t size;
};
/// Numbers of a shard, from a place of it on.
void fill_sobol(std::uint64_t seed, unsigned dimension, const ShardOfPoints& of, std::size_t place,
                std::span<double> numbers) {
  PHYSIM_ASSERT(place + numbers.size() <= of.size);
  const auto replicate = static_cast<std::uint32_t>(of.shard % kReplicates);
  const std::uint64_t begin = of.shard / kReplicates * of.size;
  const auto bits = static_cast<unsigned>(std::bit_width(begin + of.size - 1));
  fill_sobol(scrambled_dimension(seed, dimension, replicate, bits), begin + place, numbers);
}

}  // namespace

/// Pairs of them in lanes; a pair may have a half before the first number, or behind the last.
void Sampler::fill_random(unsigned dimension, std::uint64_t first, std::span<double> numbers) const {
  PHYSIM_ASSERT(sampling == Sampling::random && !numbers.empty());
  const auto bits_of = [&](std::uint64_t pair) { return philox_pair(seed, DrawStream::draw, dimension, 0, pair); };
  const std::size_t before = first % 2;
  if (before == 1) numbers[0] = unit_of_digits(bits_of(first / 2).odd >> 12);
  const std::size_t pairs = (numbers.size() - before) / 2, drawn = before + 2 * pairs;
  PHYSIM_ASSERT(drawn <= numbers.size() && drawn + 1 >= numbers.size());
  const std::uint32_t stream = dimension_and_stream(dimension, DrawStream::draw);
  draw_kernel().units({seed, stream, 0, (first + before) / 2, pairs, numbers.data() + before});
  if (drawn < numbers.size()) numbers[drawn] = unit_of_digits(bits_of((first + drawn) / 2).even >> 12);
}

void Sampler::fill(unsigned dimension, std::uint64_t shard, std::span<double> numbers) const {
  PHYSIM_ASSERT(!numbers.empty());
  const std::uint64_t first = shard * numbers.size();
  switch (sampling) {
    case Sampling::random: return fill_random(dimension, first, numbers);
    case Sampling::latin_hypercube: return fill_latin(seed, dimension, first, numbers);
    case Sampling::sobol: return fill_sobol(seed, dimension, {shard, numbers.size()}, 0, numbers);
  }
  PHYSIM_UNREACHABLE();
}

double Sampler::number(unsigned dimension, std::uint64_t shard, std::size_t size, std::size_t place) const {
  PHYSIM_ASSERT(place < size);
  switch (sampling) {
    case Sampling::random:
      return unit_of_digits(philox_bits(seed, DrawStream::draw, dimension, 0, shard * size + place) >> 12);
    case Sampling::latin_hypercube: {  // a permutation is known as a whole
      std::vector<double> all(size);
      fill_latin(seed, dimension, shard * size, all);
      return all[place];
    }
    case Sampling::sobol: {
      double one[1];
      fill_sobol(seed, dimension, {shard, size}, place, one);
      return one[0];
    }
  }
  PHYSIM_UNREACHABLE();
}

}  // namespace physim
