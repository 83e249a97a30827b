#include "collide/bvh.hpp"

#include <algorithm>

namespace physim::collide {
inline namespace bvh_building {

constexpr std::uint32_t kLeaf = BvhChild::kMostItems;  // so many items are never parted for their own sake
constexpr std::uint32_t kFew = 4;                      // so many are parted at the best place between any two
constexpr int kMostBins = 16;
constexpr std::uint32_t kSample = 512;  // items, or up to twice as many, that tell where to part more of them
constexpr float kPassing = 1;           // what a node costs, in items
constexpr float kPassingFar = 2;        // where nodes lie beyond the fast caches, as from kMany items on
constexpr std::uint32_t kMany = 1 << 15;
constexpr int kDeepest = 40;  // from where on items are halved: they are in a geometric series
static_assert(kDeepest + std::bit_width(BvhChild::kMostPlaces) < Bvh::kMostLevels);

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

/// A box; the fourth lane means nothing.
struct QuadBox {
  Quad low = Quad(kFloatInfinity), high = Quad(-kFloatInfinity);

  PHYSIM_INLINE void take(const QuadBox& other) {
    low = min(other.low, low);
    high = max(other.high, high);
  }
  PHYSIM_INLINE void take(const Quad& p) {
    low = min(p, low);
    high = max(p, high);
  }
  [[nodiscard]] PHYSIM_INLINE float area() const {
    const Quad d = high - low;
    return d[0] < 0 ? 0 : d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
  /// Twice its middle.
  [[nodiscard]] PHYSIM_INLINE Quad middle() const { return low + high; }
};

PHYSIM_INLINE QuadBox box_of(const BvhItem& item) {
  QuadBox box{Quad::load(item.low), Quad::load(item.high)};
  box.low.set(3, 0);  // the number, which is no float
  return box;
}

}  // namespace bvh_building

/// Parts items until they are few.
class Bvh::Builder {
 public:
  Builder(std::span<BvhItem> items, std::vector<BvhNode>& nodes)
      : items_(items), nodes_(nodes), aside_(items.begin(), items.end()) {}

  Bounds build() {
    nodes_.reserve(items_.size() / 8 + 1);
    Range all{0, static_cast<std::uint32_t>(items_.size()), {}, {}, {}, false, false};
    measure(all);
    nodes_.emplace_back();
    part(0, all, 1);
    nodes_.shrink_to_fit();
    Bounds box;
    box.take(Vec3d{all.box.low[0], all.box.low[1], all.box.low[2]});
    box.take(Vec3d{all.box.high[0], all.box.high[1], all.box.high[2]});
    return box;
  }

 private:
  /// Items go to the left whose bin is not beyond one, or, without bins, whose middle is not.
  struct Cut {
    float cost = kFloatInfinity;
    int axis = 0, bin = 0, bins = 0;
    float middle = 0;
  };
  struct Range {
    std::uint32_t first, count;
    QuadBox box, middles;  // middles: of twice the middles of items
    Cut cut;
    bool decided, leaf;

    PHYSIM_INLINE void take(const QuadBox& item) {
      box.take(item);
      middles.take(item.middle());
    }
  };
  /// Which bin a middle falls into, on each axis.
  struct Bins {
    Quad low, per_width;

    Bins(const Range& range, int bins) : low(range.middles.low) {
      const Quad width = range.middles.high - range.middles.low;
      for (int axis = 0; axis < 3; ++axis) {
        const float per = width[axis] > 0 ? static_cast<float>(bins) * (1 - 0x1p-22f) / width[axis] : 0;
        per_width.set(axis, per < kFloatInfinity ? per : 0);  // middles that are too near for it are one
      }
      per_width.set(3, 0);
    }
    PHYSIM_INLINE Quad of(const QuadBox& box) const { return (box.middle() - low) * per_width; }
  };

  void measure(Range& range) const {
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i) range.take(box_of(items_[i]));
  }

  /// Where parting costs least, in items looked at, and whether it is worth it.
  void decide(Range& range) const {
    range.decided = true;
    range.leaf = range.count == 1;
    if (range.leaf) return;
    range.cut = range.count <= kFew ? best_cut_of_few(range)
                : range.count <= 24 ? best_cut<8>(range)
                                    : best_cut<kMostBins>(range);
    range.leaf = range.count <= kLeaf && range.cut.cost >= static_cast<float>(range.count);
  }
  /// `sum`: of areas, each times its items.
  [[nodiscard]] float cost(float sum, float area, std::uint32_t count) const {
    return passing_ + (area > 0 ? sum / area : static_cast<float>(count) / 2);
  }
  /// Between any two of them, on each axis.
  [[nodiscard]] Cut best_cut_of_few(const Range& range) const {
    QuadBox boxes[kFew];
    for (std::uint32_t i = 0; i < range.count; ++i) boxes[i] = box_of(items_[range.first + i]);
    Cut best;
    const float area = range.box.area();
    for (int axis = 0; axis < 3; ++axis) {
      if (!(range.middles.low[axis] < range.middles.high[axis])) continue;
      const auto middle = [&](std::uint32_t i) { return boxes[i].middle()[axis]; };
      for (std::uint32_t i = 1; i < range.count; ++i)
        for (std::uint32_t k = i; k > 0 && middle(k) < middle(k - 1); --k) std::swap(boxes[k], boxes[k - 1]);
      float right_area[kFew];  // of all from this one on
      QuadBox right, left;
      for (std::uint32_t i = range.count - 1; i > 0; --i) right.take(boxes[i]), right_area[i] = right.area();
      for (std::uint32_t i = 1; i < range.count; ++i) {
        left.take(boxes[i - 1]);
        if (middle(i - 1) == middle(i)) continue;
        const float areas = static_cast<float>(i) * left.area() + static_cast<float>(range.count - i) * right_area[i];
        const float sum = cost(areas, area, range.count);
        if (sum < best.cost) best = {sum, axis, 0, 0, middle(i - 1)};
      }
    }
    return best;
  }
  /// By bins; of many items some tell what all are like.
  template <int kBins>
  [[nodiscard]] Cut best_cut(const Range& range) const {
    QuadBox boxes[3][kBins];
    std::uint32_t counts[3][kBins] = {};
    const Bins bins(range, kBins);
    const std::uint32_t stride = std::max(1u, range.count / kSample), count = (range.count + stride - 1) / stride;
    for (std::uint32_t i = range.first; i < range.first + range.count; i += stride) {
      const QuadBox box = box_of(items_[i]);
      const Quad place = bins.of(box);
      for (int axis = 0; axis < 3; ++axis) {
        const int bin = static_cast<int>(place[axis]);
        PHYSIM_ASSERT(bin >= 0 && bin < kBins);
        boxes[axis][bin].take(box);
        ++counts[axis][bin];
      }
    }
    Cut best;
    const float area = range.box.area();
    for (int axis = 0; axis < 3; ++axis) {
      if (bins.per_width[axis] == 0) continue;
      float right_cost[kBins];  // of all bins from this one on
      QuadBox right, left;
      std::uint32_t on_right = 0, on_left = 0;
      for (int bin = kBins - 1; bin > 0; --bin) {
        right.take(boxes[axis][bin]);
        on_right += counts[axis][bin];
        right_cost[bin] = static_cast<float>(on_right) * right.area();
      }
      for (int bin = 0; bin + 1 < kBins; ++bin) {
        if (counts[axis][bin] == 0) continue;
        left.take(boxes[axis][bin]);
        on_left += counts[axis][bin];
        if (on_left == count) break;
        const float sum = cost(static_cast<float>(on_left) * left.area() + right_cost[bin + 1], area, count);
        if (sum < best.cost) best = {sum, axis, bin, kBins, 0};
      }
    }
    return best;
  }

  /// Cuts a range in two: by its cut, or where there is none, or too deep down, in halves.
  Range part_off(Range& range, int depth) {
    const std::uint32_t first = range.first, end = first + range.count;
    const Cut cut = range.cut;
    Range left{first, 0, {}, {}, {}, false, false}, right = left;
    std::uint32_t middle = first;
    // In their order, without a branch that would be guessed wrong for every second item.
    const auto part_by = [&](const auto& is_left) {
      std::uint32_t on_right = 0;
      for (std::uint32_t i = first; i < end; ++i) {
        const BvhItem item = items_[i];
        const std::uint32_t side = is_left(box_of(item)) ? 0 : 1;
        items_[middle] = item;
        aside_[on_right] = item;
        middle += 1 - side;
        on_right += side;
      }
      std::copy_n(aside_.begin(), on_right, items_.begin() + middle);
    };
    const bool halved = !(cut.cost < kFloatInfinity) || depth > kDeepest;
    if (halved) {
      middle = first + range.count / 2;
    } else if (cut.bins == 0) {
      part_by([&](const QuadBox& box) { return box.middle()[cut.axis] <= cut.middle; });
    } else {
      const Bins bins(range, cut.bins);
      part_by([&](const QuadBox& box) { return static_cast<int>(bins.of(box)[cut.axis]) <= cut.bin; });
    }
    PHYSIM_ASSERT(middle > first && middle < end);
    left.count = middle - first;
    right.first = middle, right.count = end - middle;
    measure(left);
    measure(right);
    range = left;
    return right;
  }

  void part(std::uint32_t node, const Range& whole, int depth) {
    Range ranges[8];
    ranges[0] = whole;
    int count = 1;
    if (!ranges[0].decided) decide(ranges[0]);
    while (count < 8) {
      int largest = -1;
      for (int i = 0; i < count; ++i)
        if (!ranges[i].leaf && (largest < 0 || ranges[i].box.area() > ranges[largest].box.area())) largest = i;
      if (largest < 0) break;
      ranges[count] = part_off(ranges[largest], depth);
      decide(ranges[largest]);
      decide(ranges[count++]);
    }
    BvhNode& n = nodes_[node];
    n = BvhNode::of_none();
    std::uint32_t next = static_cast<std::uint32_t>(nodes_.size());
    for (int i = 0; i < count; ++i) {
      const Range& range = ranges[i];
      n.put(i, Vec3<float>{range.box.low[0], range.box.low[1], range.box.low[2]},
            Vec3<float>{range.box.high[0], range.box.high[1], range.box.high[2]},
            range.leaf ? BvhChild::of_items(range.first, range.count) : BvhChild::of_node(next++));
    }
    std::uint32_t child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(next);
    for (int i = 0; i < count; ++i)
      if (!ranges[i].leaf) part(child++, ranges[i], depth + 1);
  }

  std::span<BvhItem> items_;
  std::vector<BvhNode>& nodes_;
  const float passing_ = items_.size() < kMany ? kPassing : kPassingFar;
  std::vector<BvhItem> aside_;  // items on their way to the right
};

Bvh::Bvh(std::span<BvhItem> items) {
  if (!items.empty()) root_ = Builder(items, nodes_).build();
  extent_ = float_above(root_.extent());
}

}  // namespace physim::collide
