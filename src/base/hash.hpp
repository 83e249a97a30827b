// Hash: 64 bits that distinguish sequences of words. It does not withstand attempts to fool it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/assert.hpp"

namespace physim {

class Hash {
 public:
  Hash() = default;
  explicit Hash(std::uint64_t start) : value_(start) {}

  /// Every bit counts: for a given value before, different words give different values, and the other way round.
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 29;
  }
  void add(std::uint32_t low, std::uint32_t high) { add(low | std::uint64_t{high} << 32); }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(float a, float b) { add(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b)); }
  void add(double a, double b) { add(a), add(b); }
  void add(std::span<const std::byte> bytes) {
    const std::size_t whole = bytes.size() / 8 * 8;
    for (std::size_t i = 0; i < whole; i += 8) add(word_of(bytes.subspan(i, 8)));
    add(word_of(bytes.subspan(whole)) | std::uint64_t{bytes.size() % 8} << 56);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  /// Little-endian; up to 8 bytes.
  static std::uint64_t word_of(std::span<const std::byte> bytes) {
    PHYSIM_ASSERT(bytes.size() <= 8);
    std::uint64_t word = 0;
    if (std::endian::native == std::endian::little && bytes.size() == 8)
      std::memcpy(&word, bytes.data(), 8);
    else
      for (std::size_t i = 0; i < bytes.size(); ++i) word |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    return word;
  }

  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace physim
