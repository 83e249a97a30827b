#include "collide/resting.hpp"

namespace physim::collide {

void RestingThings::insert(const Bounds& box, std::uint32_t thing) {
  if (thing >= places_.size()) places_.resize(thing + 1);
  Place& place = places_[thing];
  PHYSIM_ASSERT(!place.there);
  place = {box, static_cast<std::uint32_t>(order_.size()), true};
  if (free_.empty()) {
    order_.push_back(thing);
  } else {
    place.at = free_.back();
    free_.pop_back();
    order_[place.at] = thing;
  }
  ++count_, ++came_;
  constexpr std::size_t kFew = 16;
  const bool has_grown = order_.size() > kFew + built_ + built_ / 16, is_worn = came_ > kFew + built_;
  if (has_grown || is_worn || !tree_.insert(box, place.at)) put_in_order();
}

bool RestingThings::remove(std::uint32_t thing) {
  if (thing >= places_.size() || !places_[thing].there) return false;
  Place& place = places_[thing];
  PHYSIM_ASSERT(order_[place.at] == thing);
  place.there = false;
  order_[place.at] = kNone;
  if (tree_.remove(place.box, place.at)) free_.push_back(place.at);
  if (--count_ < order_.size() / 2 || count_ == 0) put_in_order();
  return true;
}

void RestingThings::put_in_order() {
  std::vector<BvhItem> items;
  for (std::uint32_t thing = 0; thing < places_.size(); ++thing)
    if (places_[thing].there) items.emplace_back(places_[thing].box, thing);
  tree_ = Bvh(items);
  order_.clear();
  for (const BvhItem& item : items) {
    places_[item.number()].at = static_cast<std::uint32_t>(order_.size());
    order_.push_back(item.number());
  }
  free_.clear();
  built_ = order_.size();
  came_ = 0;
  PHYSIM_ASSERT(built_ == count_);
}

}  // namespace physim::collide
