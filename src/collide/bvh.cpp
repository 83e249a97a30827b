#include "collide/bvh.hpp"

namespace physim::collide {
inline namespace bvh_building {

constexpr std::uint32_t kLeaf = 4;  // so many items are never parted for their own sake
constexpr int kMostBins = 16;
constexpr float kPassing = 1;  // what a node costs, in items
constexpr int kDeepest = 40;   // from where on items are halved: they are in a geometric series

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

/// A box; the fourth lane means nothing.
struct QuadBox {
  Quad low = Quad(kFloatInfinity), high = Quad(-kFloatInfinity);

  PHYSIM_INLINE void take(const QuadBox& other) {
    low = min(other.low, low);
    high = larger(other.high, high);
  }
  PHYSIM_INLINE void take(const Quad& p) {
    low = min(p, low);
    high = larger(p, high);
  }
  [[nodiscard]] PHYSIM_INLINE float area() const {
    const Quad d = high - low;
    return d[0] < 0 ? 0 : d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
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
  Builder(std::span<BvhItem> items, std::vector<Node>& nodes) : items_(items), nodes_(nodes) {}

  Bounds build() {
    nodes_.reserve(items_.size() / 5 + 1);
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
  struct Cut {
    float cost = kFloatInfinity;
    int axis = 0, bin = 0, bins = 0;
  };
  struct Range {
    std::uint32_t first, count;
    QuadBox box, middles;  // middles: sums of low and high sides
    Cut cut;
    bool decided, leaf;
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
    PHYSIM_INLINE Quad of(const QuadBox& box) const { return (box.low + box.high - low) * per_width; }
  };

  void measure(Range& range) const {
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
      const QuadBox box = box_of(items_[i]);
      range.box.take(box);
      range.middles.take(box.low + box.high);
    }
  }

  /// Where parting costs least, in items looked at, and whether it is worth it.
  void decide(Range& range) const {
    range.decided = true;
    range.leaf = range.count == 1;
    if (range.leaf) return;
    range.cut = range.count > 24 ? best_cut<kMostBins>(range) : best_cut<8>(range);
    range.leaf = range.count <= kLeaf && range.cut.cost >= static_cast<float>(range.count);
  }
  template <int kBins>
  [[nodiscard]] Cut best_cut(const Range& range) const {
    QuadBox boxes[3][kBins];
    std::uint32_t counts[3][kBins] = {};
    const Bins bins(range, kBins);
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
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
        if (on_left == range.count) break;
        const float sum = static_cast<float>(on_left) * left.area() + right_cost[bin + 1];
        const float cost = kPassing + (area > 0 ? sum / area : static_cast<float>(range.count) / 2);
        if (cost < best.cost) best = {cost, axis, bin, kBins};
      }
    }
    return best;
  }

  /// Cuts a range in two: by its cut, or where there is none, or too deep down, in halves.
  Range part_off(Range& range, int depth) {
    std::uint32_t middle = range.first + range.count / 2;
    if (range.cut.cost < kFloatInfinity && depth <= kDeepest) {
      const Bins bins(range, range.cut.bins);
      // Written out: libraries differ in the order that they leave.
      middle = range.first;
      for (std::uint32_t end = range.first + range.count; middle < end;) {
        if (static_cast<int>(bins.of(box_of(items_[middle]))[range.cut.axis]) <= range.cut.bin)
          ++middle;
        else
          std::swap(items_[middle], items_[--end]);
      }
    }
    PHYSIM_ASSERT(middle > range.first && middle < range.first + range.count);
    Range right{middle, range.first + range.count - middle, {}, {}, {}, false, false};
    range = {range.first, middle - range.first, {}, {}, {}, false, false};
    measure(range);
    measure(right);
    return right;
  }

  void part(std::uint32_t node, const Range& whole, int depth) {
    Range ranges[4] = {whole, whole, whole, whole};
    int count = 1;
    if (!ranges[0].decided) decide(ranges[0]);
    while (count < 4) {
      int largest = -1;
      for (int i = 0; i < count; ++i)
        if (!ranges[i].leaf && (largest < 0 || ranges[i].box.area() > ranges[largest].box.area())) largest = i;
      if (largest < 0) break;
      ranges[count] = part_off(ranges[largest], depth);
      decide(ranges[largest]);
      decide(ranges[count++]);
    }
    Node& n = nodes_[node];
    std::uint32_t next = static_cast<std::uint32_t>(nodes_.size());
    for (int i = 0; i < 4; ++i) {
      const QuadBox box = i < count ? ranges[i].box : QuadBox{};
      for (int axis = 0; axis < 3; ++axis)
        n.plane[4 * axis + i] = box.low[axis], n.plane[kSides + 4 * axis + i] = box.high[axis];
      const bool leaf = i >= count || ranges[i].leaf;
      n.first[i] = i >= count ? 0 : leaf ? ranges[i].first : next++;
      n.count[i] = static_cast<std::uint8_t>(i < count && leaf ? ranges[i].count : 0);
    }
    std::uint32_t child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(next);
    for (int i = 0; i < count; ++i)
      if (!ranges[i].leaf) part(child++, ranges[i], depth + 1);
  }

  std::span<BvhItem> items_;
  std::vector<Node>& nodes_;
};

Bvh::Bvh(std::span<BvhItem> items) {
  if (!items.empty()) root_ = Builder(items, nodes_).build();
}

}  // namespace physim::collide
