// Events that are filled in where they are kept.
#pragma once

#include <vector>

#include "physim/event.hpp"

namespace physim {

/// Equal to Event{}. A copy of this one is a few moves; g++ clears an object of this size by a repeated string
/// instruction, which takes longer than all else about an event.
extern const Event kBlankEvent;

/// One more event of a list, to be filled in there: a copy of one that was filled in elsewhere would read in wide
/// pieces what was just written in narrow ones, and wait until it is in the cache.
[[nodiscard]] inline Event& add_event(std::vector<Event>& list) { return list.emplace_back(kBlankEvent); }

}  // namespace physim
