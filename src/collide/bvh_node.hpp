// A node of a tree of boxes, for the tree itself and for the kernels that walk many segments through trees.
#pragma once

#include "base/prefetch.hpp"
#include "collide/eight_boxes.hpp"

namespace physim::collide {

/// What a child is: another node, or one to four items side by side.
class BvhChild {
 public:
  static constexpr std::uint32_t kItems = 0x80000000;  // the bit that says so
  static constexpr std::uint32_t kMostItems = 4;
  static constexpr std::uint32_t kMostPlaces = 1u << 29;  // of items in a tree

  BvhChild() = default;
  PHYSIM_INLINE explicit BvhChild(std::uint32_t bits) : bits_(bits) {}
  [[nodiscard]] static BvhChild of_node(std::uint32_t number) {
    PHYSIM_ASSERT(number < kItems);
    return BvhChild(number);
  }
  [[nodiscard]] static BvhChild of_items(std::uint32_t first, std::uint32_t count) {
    PHYSIM_ASSERT(count >= 1 && count <= kMostItems && first < kMostPlaces);
    return BvhChild(kItems | (count - 1) << 29 | first);
  }

  [[nodiscard]] std::uint32_t bits() const { return bits_; }
  [[nodiscard]] PHYSIM_INLINE bool has_items() const { return (bits_ & kItems) != 0; }
  [[nodiscard]] PHYSIM_INLINE std::uint32_t node() const {
    PHYSIM_ASSERT(!has_items());
    return bits_;
  }
  /// The places of its items.
  [[nodiscard]] PHYSIM_INLINE std::uint32_t first() const {
    PHYSIM_ASSERT(has_items());
    return bits_ & (kMostPlaces - 1);
  }
  [[nodiscard]] PHYSIM_INLINE std::uint32_t end() const { return first() + (bits_ >> 29 & 3) + 1; }

 private:
  std::uint32_t bits_;
};

/// Eight children, or fewer: boxes beyond are empty.
struct alignas(32) BvhNode : EightBoxes {
  std::uint32_t child[8];  // bits of BvhChild

  /// Empty boxes, which nothing meets.
  [[nodiscard]] static BvhNode of_none() {
    BvhNode node;
    for (int lane = 0; lane < 8; ++lane) node.clear(lane);
    return node;
  }
  void clear(int lane) {
    const Bounds none;
    put(lane, none.low, none.high, BvhChild::of_items(0, 1));
  }
  /// Corners are of floats.
  template <class Corner>
  void put(int lane, const Corner& low, const Corner& high, BvhChild what) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      side[axis][lane] = static_cast<float>(low[axis]);
      side[3 + axis][lane] = static_cast<float>(high[axis]);
    }
    child[lane] = what.bits();
  }
  [[nodiscard]] bool is_empty(int lane) const { return side[0][lane] > side[3][lane]; }
  /// About all of its boxes.
  [[nodiscard]] Bounds about() const {
    Bounds all;
    for (int lane = 0; lane < 8; ++lane) all.take(box(lane));
    return all;
  }

  /// Has it brought from memory.
  PHYSIM_INLINE void prefetch() const {
    for (std::size_t line = 0; line < 256; line += 64) prefetch_at(this, line);
  }
};
static_assert(sizeof(BvhNode) == 224);  // four lines of the cache, wherever it begins

}  // namespace physim::collide
