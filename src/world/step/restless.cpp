#include "world/step/restless.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "collide/scene_by_motion.hpp"

namespace physim {
namespace {

using collide::Bounds;

/// A side of a box in a row's number type, rounded outwards.
template <class S>
S outwards(double side, double to) {
  return std::nextafter(static_cast<S>(std::clamp(side, -collide::kFarthest, collide::kFarthest)), static_cast<S>(to));
}
template <class S>
void put_box(RestlessBoxes<S>& into, unsigned at, const Bounds& box) {
  PHYSIM_ASSERT(at < RestlessBoxes<S>::kMost);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    into.low[at][axis] = outwards<S>(box.low[axis], -kInfinity);
    into.high[at][axis] = outwards<S>(box.high[axis], kInfinity);
  }
}

}  // namespace

bool Newcomers::add(std::uint32_t thing, std::uint64_t step) {
  PHYSIM_ASSERT(step >= last_ || things_.empty());  // steps follow each other
  last_ = step;
  is_known_ = false;
  const auto place = std::ranges::lower_bound(things_, thing);
  if (place != things_.end() && *place == thing) return true;
  if (things_.size() >= kMost) return false;
  things_.insert(place, thing);
  return true;
}

const BoxGroups& Newcomers::boxes(const SceneByMotion& scene) {
  if (is_known_) return boxes_;
  std::vector<Bounds> boxes;
  for (const std::uint32_t thing : things_)
    if (const auto box = scene.box_at_rest(thing)) boxes.push_back(*box);
  boxes_ = BoxGroups(std::move(boxes));
  is_known_ = true;
  return boxes_;
}

void Restless::clear() {
  came_ = nullptr;
  float_.count = double_.count = 0;
}

void Restless::find(const Scene& scene, Newcomers& newcomers) {
  clear();
  const SceneByMotion parts(scene);
  if (parts.has_boundless_movers()) return be_everywhere();
  std::vector<Bounds> moving;
  parts.add_boxes_of_movers(moving);
  came_ = &newcomers.boxes(parts);
  put(BoxGroups(std::move(moving)), *came_);
}

void Restless::be_everywhere() {
  clear();
  constexpr Vec3d kCorner{kInfinity, kInfinity, kInfinity};
  put(BoxGroups({{-kCorner, kCorner}}), {});
}

void Restless::put(const BoxGroups& moving, const BoxGroups& came) {
  static_assert(RestlessBoxes<float>::kMost == 2 * BoxGroups::kMost + 1);
  constexpr double kBeside = 1e-4;  // contacts are reported if something is this near, and nearer [m]
  Bounds all;
  unsigned count = 1;  // behind the first one, which holds all
  for (const BoxGroups* some : {&moving, &came})
    for (const BoxGroups::Group& group : some->groups()) {
      Bounds box = group.about;
      box.widen(kBeside);
      all.take(box);
      put_box(float_, count, box);
      put_box(double_, count, box);
      ++count;
    }
  PHYSIM_ASSERT(count <= RestlessBoxes<float>::kMost);
  if (count == 1) return;
  put_box(float_, 0, all);
  put_box(double_, 0, all);
  float_.count = double_.count = count;
}

}  // namespace physim
