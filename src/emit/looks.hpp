// Looks: how many particles are shown, pack by pack. The result of Emission::look() for one is a pack of one.
#pragma once

#include <array>
#include <cstdint>

#include "emit/emission.hpp"
#include "emit/particle_job.hpp"

namespace physim {

/// Several particles of one emitter, and how they look: each number in a column.
template <std::size_t N>
struct LookPack {
  using Column = std::array<double, N>;
  double time;  // at which they are seen [s]
  std::array<std::uint64_t, N> number;
  Column phase, birth, lifetime, speed;  // as Emission::look() is given them, with births for ages
  std::array<Column, 3> size, rotation;
  std::array<std::uint32_t, N> colour;
};

/// Which columns a caller reads.
struct LookParts {
  bool size = true, rotation = true, colour = true;
};

class Looks {
 public:
  static constexpr std::size_t kPack = kColumn;

  explicit Looks(const Emission& emission) : parts_(*emission.parts_), kernel_(particle_kernel()) {}

  template <std::size_t N>
  void put(LookPack<N>& pack, const LookParts& wanted) const;  // of 1 or kPack
  /// Whether they depend on LookPack::phase.
  [[nodiscard]] bool read_phase() const;

 private:
  template <std::size_t N>
  class Look;

  const Emission::Parts& parts_;
  const ParticleKernel& kernel_;
};

}  // namespace physim
