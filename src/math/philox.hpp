// Philox4x32-10: random numbers by counter. The numbers of a counter and key are always the same, so every projectile
// has its own without anybody keeping a state, in any order and on any thread.
// Source: J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, "Parallel Random Numbers: As Easy as 1, 2, 3", SC11
// (2011), sec. 4.3; constants and test vectors of its implementation Random123.
#pragma once

#include <array>
#include <cstdint>

namespace physim {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

[[nodiscard]] constexpr PhiloxCounter philox(PhiloxCounter counter, PhiloxKey key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53u} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57u} * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9u;
    key[1] += 0xBB67AE85u;
  }
  return counter;
}

/// A number between 0 and 1, neither of which it is.
[[nodiscard]] constexpr double open_unit(std::uint32_t bits) { return (bits + 0.5) / 4294967296.0; }

}  // namespace physim
