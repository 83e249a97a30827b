#include "collide/resting.hpp"

namespace physim::collide {

void RestingThings::insert(const Bounds& box, std::uint32_t thing) {
  if (thing >= places_.size()) places_.resize(thing + 1);
  Place& place = places_[thing];
  PHYSIM_ASSERT(!place.there);
  place = {box, recent_.insert(box, thing), true, true};
  ++new_;
  constexpr std::size_t kFew = 16;
  if (new_ > kFew + order_.size() / 16) put_in_order();
}

bool RestingThings::remove(std::uint32_t thing) {
  if (thing >= places_.size() || !places_[thing].there) return false;
  Place& place = places_[thing];
  place.there = false;
  if (place.recent) {
    recent_.remove(place.at);
    --new_;
    return true;
  }
  PHYSIM_ASSERT(order_[place.at] == thing);
  order_[place.at] = Tree::kNone;
  if (++gone_ > order_.size() / 2) put_in_order();
  return true;
}

void RestingThings::put_in_order() {
  std::vector<BvhItem> items;
  for (std::uint32_t thing = 0; thing < places_.size(); ++thing)
    if (places_[thing].there) items.emplace_back(places_[thing].box, thing);
  old_ = Bvh(items);
  order_.clear();
  for (const BvhItem& item : items) {
    places_[item.number()].at = static_cast<std::uint32_t>(order_.size());
    places_[item.number()].recent = false;
    order_.push_back(item.number());
  }
  recent_ = {};
  gone_ = new_ = 0;
}

}  // namespace physim::collide
