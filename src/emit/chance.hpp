// Chance: the random numbers of an emitter. Each follows from the seed, its purpose and its particle,
// by Philox: no state is kept, no draw shifts another, and what is constant draws nothing.
#pragma once

#include <array>
#include <cstdint>

#include "base/assert.hpp"
#include "math/philox.hpp"

namespace physim {

/// What is drawn for a particle. New ones go to the end, so that those before keep their numbers; those that are drawn
/// together most often share a block of four, which costs one call of Philox.
enum class Draw : std::uint8_t {
  arc,
  depth,
  lifetime,
  speed,

  along,
  side,
  gravity,
  off,

  about,
  up,
  right,
  flipped,

  size,
  size_y,
  size_z,
  colour,

  rotation,
  rotation_y,
  rotation_z,
  life_size,

  life_turn,
  life_colour,
};

/// What is drawn for what acts on its flight, and only there.
enum class FlightDraw : std::uint8_t {
  drag,
  gravity,
  limit,
  noise,

  velocity_x,
  velocity_y,
  velocity_z,
  unused,

  force_x,
  force_y,
  force_z,
};

/// The last word of the counter: projectiles' hits and volleys draw from streams 0 and 1.
enum class EmitStream : std::uint32_t {
  particle = 2,
  delay = 3,
  rate = 4,
  burst = 5,
  sub = 6,
  flight = 7,
  noise = 8,
  rain = 9
};

/// Four random words of the nth event of a number in a stream. `index`, below 2^24: the block, burst or sub-emitter.
[[nodiscard]] inline PhiloxCounter emit_words(std::uint64_t seed, EmitStream stream, std::uint32_t index,
                                              std::uint64_t number, std::uint64_t nth) {
  PHYSIM_ASSERT(index < 1u << 24 && static_cast<std::uint32_t>(stream) < 256);
  const PhiloxKey key{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
  return philox({static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32),
                 static_cast<std::uint32_t>(nth), static_cast<std::uint32_t>(stream) | index << 8},
                key);
}

/// The numbers between 0 and 1 of one particle, drawn when they are asked for.
template <class What, EmitStream kStream, What kLast>
class ChanceOf {
 public:
  ChanceOf(std::uint64_t seed, std::uint64_t number) : seed_(seed), number_(number) {}

  [[nodiscard]] double operator()(What what) {
    const auto i = static_cast<std::uint32_t>(what), block = i / 4;
    PHYSIM_ASSERT(block < kBlocks);
    if ((drawn_ >> block & 1) == 0) {
      words_[block] = emit_words(seed_, kStream, block, number_, 0);
      drawn_ |= 1u << block;
    }
    return open_unit(words_[block][i % 4]);
  }

 private:
  static constexpr std::uint32_t kBlocks = static_cast<std::uint32_t>(kLast) / 4 + 1;

  std::uint64_t seed_, number_;
  std::uint32_t drawn_ = 0;                     // a bit for each block
  std::array<PhiloxCounter, kBlocks> words_{};  // none is read before it is drawn, but compilers do not see that
};
using ParticleChance = ChanceOf<Draw, EmitStream::particle, Draw::life_colour>;
using FlightChance = ChanceOf<FlightDraw, EmitStream::flight, FlightDraw::force_z>;

}  // namespace physim
