// Appending to lists in places where many items are appended.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "physim/math.hpp"

namespace physim {

/// Reserves room for `more` items; lists double.
template <class List>
PHYSIM_INLINE void make_room(List& list, std::size_t more) {
  if (list.capacity() - list.size() < more) [[unlikely]]
    list.reserve(std::max({list.size() + more, 2 * list.capacity(), std::size_t{16}}));
}

/// Appends an item, not one of the list, as push_back() does. If compilers know that there is room, they write it in
/// place. A copy reads in wide pieces what was just written in narrow ones, and such a read waits until all of them are
/// in the cache.
template <class List>
PHYSIM_INLINE_ALWAYS void append(List& list, const typename List::value_type& item) {
  make_room(list, 1);
  if (list.size() == list.capacity()) __builtin_unreachable();
  list.push_back(item);
}

}  // namespace physim
