// The bytes of recordings, for tests that damage them.
#pragma once

#include <vector>

#include "world/core/recorder.hpp"

namespace physim::test {

using Bytes = std::vector<std::byte>;

struct Places {
  std::vector<std::size_t> frame;  // where each begins
  std::vector<Call> call;
};
inline Places places_of(const Bytes& bytes) {
  Places p;
  for (std::size_t at = 12; at < bytes.size();) {
    std::uint64_t length = 0;
    Reader(std::span(bytes).subspan(at + 1)).number(length, 4);
    p.frame.push_back(at);
    p.call.push_back(static_cast<Call>(bytes[at]));
    at += kFrameHead + length + kCheckSum;
  }
  return p;
}

/// The same bytes with their check sums made right again.
inline void sign(Bytes& bytes) {
  std::uint64_t chained = 0;
  for (std::size_t at = 12; at + kFrameHead + kCheckSum <= bytes.size();) {
    std::uint64_t length = 0;
    Reader(std::span(bytes).subspan(at + 1)).number(length, 4);
    if (bytes.size() - at < kFrameHead + length + kCheckSum) return;
    chained = chain(chained, std::span(bytes).subspan(at, kFrameHead + length));
    at += kFrameHead + length;
    for (std::size_t i = 0; i < kCheckSum; ++i) bytes[at++] = static_cast<std::byte>(check_sum(chained) >> (8 * i));
  }
}

}  // namespace physim::test
