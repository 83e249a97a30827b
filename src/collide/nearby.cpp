#include "collide/nearby.hpp"

namespace physim::collide {

constexpr std::uint32_t kLarge = 64;  // triangles, from which on a part of a mesh is looked for

Nearby::Nearby(const SceneContent& scene, const SceneFilter& filter, const Bounds& box) : scene_(scene) {
  if (box.low.x > box.high.x) return;
  // More than any coordinate is rounded to on its way.
  Bounds wide = box;
  wide.widen(kFloatSlack * box.extent());
  scene.resting.overlapping(wide, [&](std::uint32_t index) {
    if (!is_crowded_ && scene.instances[index].is_asked(filter)) add(index, wide);
  });
  for (int i = count_; i % 4 != 0; ++i) boxes_[i / 4].set(i % 4, {});
}

void Nearby::add(std::uint32_t index, const Bounds& box) {
  is_crowded_ = count_ == kMost;
  if (is_crowded_) return;
  const SceneContent::InstanceSlot& slot = scene_.instances[index];
  PHYSIM_ASSERT(slot.alive && !slot.path && count_ < kMost);
  Thing& thing = things_[count_];
  thing.index = index;
  const auto* mesh = std::get_if<Mesh>(slot.shape.get());
  thing.has_start = mesh && mesh->size() >= kLarge;
  if (thing.has_start) {
    thing.start = mesh->start(slot.placement.inside(box));
    if (!thing.start.some()) return;
  }
  const Bounds& own = scene_.resting.box(index);
  boxes_[count_ / 4].set(count_ % 4, own);
  extent_ = std::max(extent_, own.extent());
  ++count_;
  is_alone_ = count_ == 1 && (thing.has_start || std::holds_alternative<HeightField>(*slot.shape));
}

}  // namespace physim::collide
