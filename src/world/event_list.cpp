#include "world/event_list.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "base/spread_sort.hpp"
#include "world/blank_event.hpp"

namespace physim {

const Event kBlankEvent{};

namespace {

/// Events of births, and of ends of lives, come in order already: a few such runs are merged, anything else is sorted.
void sort_by_runs(std::vector<EventKey>& keys, std::vector<EventKey>& spare) {
  constexpr int kMostMerges = 4;
  auto sorted = std::ranges::is_sorted_until(keys);
  for (int merges = 0; sorted != keys.end(); ++merges) {
    if (merges == kMostMerges) return spread_sort(keys, spare, std::mem_fn(&EventKey::time), std::less{});
    const auto end = std::is_sorted_until(sorted, keys.end());
    spare.clear();
    std::merge(keys.begin(), sorted, sorted, end, std::back_inserter(spare));
    std::ranges::copy(spare, keys.begin());
    sorted = end;
  }
}

}  // namespace

void EventList::put_in_order(std::vector<EventKey>& spare, GivenEvents& given) {
  if (std::ranges::is_sorted(keys_)) return;
  leave(given);
  sort_by_runs(keys_, spare);
}

Event EventList::whole_of(const PlainEvent& e, const Vec3d& position, const Vec3d& velocity) {
  Event event = kBlankEvent;
  event.kind = e.kind, event.reason = e.reason, event.id = e.id, event.value = e.value, event.time = e.time;
  event.position = position, event.velocity = velocity;
  return event;
}

Event EventList::event_of(const EventKey& key) const {
  const std::size_t at = key.place / 2;
  if (key.place % 2 != 0) return whole_[at];
  const Brief& b = brief_[at];
  const auto vector = [](const std::array<float, 3>& of) { return Vec3d{double(of[0]), double(of[1]), double(of[2])}; };
  return whole_of({b.kind, b.reason, {key.slot, b.generation}, b.value, key.time}, vector(b.position),
                  vector(b.velocity));
}

std::span<const Event> EventList::all(GivenEvents& given) const {
  PHYSIM_ASSERT(shown_.size() <= keys_.size());
  if (keys_.size() > shown_.capacity()) {
    StepList<Event> larger;
    larger.reserve(std::max(keys_.size(), 2 * shown_.capacity()));
    larger.assign(shown_.begin(), shown_.end());
    leave(given);
    shown_.swap(larger);
  }
  for (std::size_t i = shown_.size(); i < keys_.size(); ++i) shown_.push_back(event_of(keys_[i]));
  return shown_;
}

std::size_t EventList::bytes() const {
  return keys_.capacity() * sizeof(EventKey) + brief_.capacity() * sizeof(Brief) +
         (whole_.capacity() + shown_.capacity()) * sizeof(Event);
}

}  // namespace physim
