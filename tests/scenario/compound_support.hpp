// What tests of compounds and materials in scenario files share.
#pragma once

#include <random>

#include "support.hpp"

namespace physim {

inline const std::string kHead = "physim = 1\n[[shot]]\n[world]\n";

/// Segments through a box of 30 m by 4 m by 4 m.
inline std::vector<SceneSegment> random_segments(std::size_t count) {
  std::mt19937_64 random(7);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  std::vector<SceneSegment> segments(count);
  for (SceneSegment& s : segments) {
    s.from = {uniform(-2, 28), uniform(-2, 4), uniform(-3, 3)};
    s.to = {uniform(-2, 28), uniform(-2, 4), uniform(-3, 3)};
  }
  return segments;
}

/// Both are met at the same places, by bits; returns how often something was met.
inline std::size_t expect_same_hits(const Scene& a, const Scene& b) {
  std::size_t met = 0;
  for (const SceneSegment& s : random_segments(20000)) {
    const std::vector<SceneHit> one = a.all_hits(s), two = b.all_hits(s);
    EXPECT_EQ(one.size(), two.size());
    met += one.size();
    for (std::size_t i = 0; i < std::min(one.size(), two.size()); ++i) {
      EXPECT_TRUE(test::same_bits(one[i].part, two[i].part) && test::same_bits(one[i].normal, two[i].normal));
      EXPECT_TRUE(one[i].primitive == two[i].primitive && one[i].instance == two[i].instance);
      EXPECT_EQ(one[i].material, two[i].material);
    }
  }
  return met;
}

}  // namespace physim
