// Philox4x32-10: random numbers by counter. The numbers of a counter and key are always the same, so every projectile
// has its own without a stored state, in any order and on any thread.
// Source: J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, "Parallel Random Numbers: As Easy as 1, 2, 3", SC11
// (2011), sec. 4.3; constants and test vectors of its implementation Random123.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace physim {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// Several counters at a time, word by word, in place.
template <std::size_t N>
constexpr void philox_each(std::array<std::array<std::uint32_t, N>, 4>& counter, PhiloxKey key) {
  for (int round = 0; round < 10; ++round) {
    for (std::size_t i = 0; i < N; ++i) {
      const std::uint64_t a = std::uint64_t{0xD2511F53u} * counter[0][i];
      const std::uint64_t b = std::uint64_t{0xCD9E8D57u} * counter[2][i];
      counter[0][i] = static_cast<std::uint32_t>(b >> 32) ^ counter[1][i] ^ key[0];
      counter[2][i] = static_cast<std::uint32_t>(a >> 32) ^ counter[3][i] ^ key[1];
      counter[1][i] = static_cast<std::uint32_t>(b);
      counter[3][i] = static_cast<std::uint32_t>(a);
    }
    key[0] += 0x9E3779B9u;
    key[1] += 0xBB67AE85u;
  }
}

[[nodiscard]] constexpr PhiloxCounter philox(const PhiloxCounter& counter, const PhiloxKey& key) {
  std::array<std::array<std::uint32_t, 1>, 4> words{{{counter[0]}, {counter[1]}, {counter[2]}, {counter[3]}}};
  philox_each(words, key);
  return {words[0][0], words[1][0], words[2][0], words[3][0]};
}

/// A number between 0 and 1, neither of which it is.
[[nodiscard]] constexpr double open_unit(std::uint32_t bits) { return (bits + 0.5) / 4294967296.0; }

}  // namespace physim
