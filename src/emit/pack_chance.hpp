// The random numbers of several particles at a time: the same ones that chance.hpp draws for each, in columns.
#pragma once

#include <array>
#include <cstdint>

#include "emit/chance.hpp"
#include "emit/drawn.hpp"
#include "emit/particle_job.hpp"

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

/// The numbers between 0 and 1 of a pack of particles, drawn when they are asked for; those of a column
/// by a kernel.
template <class What, EmitStream kStream, std::size_t N>
class PackChance {
 public:
  /// A kernel draws those of the first `count` alone.
  PackChance(std::uint64_t seed, const std::array<std::uint64_t, N>& number, const ParticleKernel* kernel = nullptr,
             std::size_t count = N)
      : seed_(seed), number_(number), kernel_(kernel), count_(count) {
    PHYSIM_ASSERT((kernel != nullptr) == kByKernel && count <= N);
    if (count < N) words_ = {};  // columns are read whole
  }

  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const ParticleKernel* kernel() const { return kernel_; }
  [[nodiscard]] const std::array<double, N>& operator()(What what) {
    const std::array<std::uint32_t, N>& of = words(what);
    for (std::size_t i = 0; i < N; ++i) u_[i] = open_unit(of[i]);
    return u_;
  }
  /// What they are made of, by open_unit().
  [[nodiscard]] const std::array<std::uint32_t, N>& words(What what) {
    const auto draw = static_cast<std::uint32_t>(what), block = draw / 4, at = block % kKept;
    if (block != drawn_[at]) put_words(block, words_[at]);
    drawn_[at] = block;
    return words_[at][draw % 4];
  }

 private:
  static constexpr bool kByKernel = N == kColumn;

  void put_words(std::uint32_t block, WordColumns<N>& words) const {
    if constexpr (kByKernel)
      kernel_->words({seed_,
                      static_cast<std::uint32_t>(kStream) | block << 8,
                      count_,
                      number_.data(),
                      {words[0].data(), words[1].data(), words[2].data(), words[3].data()}});
    else
      emit_words_each(seed_, kStream, block, number_, words);
  }

  std::uint64_t seed_;
  const std::array<std::uint64_t, N>& number_;
  const ParticleKernel* kernel_;
  std::size_t count_;
  // Numbers that are drawn together most often share a block, or lie in the next one.
  static constexpr std::uint32_t kKept = 2, kNone = ~0u;
  std::array<std::uint32_t, kKept> drawn_{kNone, kNone};  // the blocks with stored words
  std::array<WordColumns<N>, kKept> words_;
  std::array<double, N> u_;
};

/// A number of each of a pack at places, by draws of their own where it is drawn.
template <class What, EmitStream kStream, std::size_t N>
void draw_each(const EmitNumber& number, const std::array<double, N>& x, std::array<double, N>& y,
               PackChance<What, kStream, N>& chance, What what) {
  if constexpr (N == kColumn)
    chance.kernel()->number(number.job(x.data(), number.is_drawn() ? chance.words(what).data() : nullptr, y.data()));
  else
    number.at_each(
        x, y, [&]() -> const auto& { return chance(what); });
}

}  // namespace physim
