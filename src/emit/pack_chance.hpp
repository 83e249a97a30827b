// The random numbers of several particles at a time: the same ones that chance.hpp draws for each, in columns.
#pragma once

#include <array>
#include <cstdint>

#include "emit/chance.hpp"

namespace physim {

/// Words of emit_words() of each of a pack's numbers, word by word.
template <std::size_t N>
using WordColumns = std::array<std::array<std::uint32_t, N>, 4>;

template <std::size_t N>
void emit_words_each(std::uint64_t seed, EmitStream stream, std::uint32_t index,
                     const std::array<std::uint64_t, N>& number, WordColumns<N>& words) {
  PHYSIM_ASSERT(index < 1u << 24);
  for (std::size_t i = 0; i < N; ++i) {
    words[0][i] = static_cast<std::uint32_t>(number[i]);
    words[1][i] = static_cast<std::uint32_t>(number[i] >> 32);
    words[2][i] = 0;
    words[3][i] = static_cast<std::uint32_t>(stream) | index << 8;
  }
  philox_each(words, {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
}

/// The numbers between 0 and 1 of a pack of particles, drawn when they are asked for.
template <class What, EmitStream kStream, std::size_t N>
class PackChance {
 public:
  PackChance(std::uint64_t seed, const std::array<std::uint64_t, N>& number) : seed_(seed), number_(number) {}

  [[nodiscard]] const std::array<double, N>& operator()(What what) {
    const auto draw = static_cast<std::uint32_t>(what), block = draw / 4;
    if (block != drawn_) emit_words_each(seed_, kStream, block, number_, words_);
    drawn_ = block;
    for (std::size_t i = 0; i < N; ++i) u_[i] = open_unit(words_[draw % 4][i]);
    return u_;
  }

 private:
  std::uint64_t seed_;
  const std::array<std::uint64_t, N>& number_;
  std::uint32_t drawn_ = ~0u;  // the block whose words are there: those drawn together most often share one
  WordColumns<N> words_{};
  std::array<double, N> u_{};
};

}  // namespace physim
