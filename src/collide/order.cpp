#include "collide/order.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "collide/bvh.hpp"
#include "collide/question.hpp"

namespace physim::collide {
namespace {

constexpr int kBits = 8;                     // along each axis
constexpr int kDigit = 12;                   // of a key that is sorted by at a time
constexpr double kCells = (1 << kBits) - 1;  // the last of them
static_assert(2 * kDigit == 3 * kBits);

/// A number's bits, two places apart.
constexpr std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 8) & 0x00f00fu;
  x = (x | x << 4) & 0x0c30c3u;
  return (x | x << 2) & 0x249249u;
}
static_assert(spread(0xff) == 0x249249u && spread(0x81) == 0x200001u);

struct Keyed {
  std::uint32_t key, number;
};

/// By twelve bits of their keys; those with the same ones stay as they are.
void sort_by_digit(const std::vector<Keyed>& from, std::vector<Keyed>& into, int shift) {
  constexpr std::uint32_t kMask = (1u << kDigit) - 1;
  std::array<std::uint32_t, kMask + 1> place{};
  for (const Keyed& each : from) ++place[each.key >> shift & kMask];
  std::uint32_t before = 0;
  for (std::uint32_t& p : place) before += std::exchange(p, before);
  PHYSIM_ASSERT(before == from.size());
  for (const Keyed& each : from) into[place[each.key >> shift & kMask]++] = each;
}

}  // namespace

std::vector<std::uint32_t> order_by_place(std::span<const SceneSegment> segments) {
  Bounds about;
  for (const SceneSegment& s : segments)
    if (is_near(s.from)) about.take(s.from);
  const Vec3d size = about.high - about.low;
  const double most = std::max({size.x, size.y, size.z}), per_cell = most > 0 ? kCells / most : 0;
  const auto cell = [&](double from, double low) {
    return spread(static_cast<std::uint32_t>(std::clamp((from - low) * per_cell, 0.0, kCells)));
  };
  std::vector<Keyed> keyed(segments.size()), other(segments.size());
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const Vec3d& p = segments[i].from;
    keyed[i] = {0, i};  // those that stand nowhere come first
    if (is_near(p)) keyed[i].key = cell(p.x, about.low.x) | cell(p.y, about.low.y) << 1 | cell(p.z, about.low.z) << 2;
  }
  sort_by_digit(keyed, other, 0);
  sort_by_digit(other, keyed, kDigit);
  std::vector<std::uint32_t> order(segments.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].number;
  return order;
}

}  // namespace physim::collide
