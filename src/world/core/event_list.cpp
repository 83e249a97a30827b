#include "world/core/event_list.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "base/spread_sort.hpp"
#include "world/core/blank_event.hpp"

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

/// Shows one more, for which there is room.
void EventList::add_shown(const EventKey& key) const {
  if (is_whole(key)) return shown_.push_back(whole_[key.place / 2]);
  put_plain(plain_at(key), add_event(shown_));
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
  for (std::size_t i = shown_.size(); i < keys_.size(); ++i) add_shown(keys_[i]);
  return shown_;
}

std::size_t EventList::bytes() const {
  return keys_.capacity() * sizeof(EventKey) + plain_.capacity() * sizeof(Plain) +
         (whole_.capacity() + shown_.capacity()) * sizeof(Event);
}

}  // namespace physim
