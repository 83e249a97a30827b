// Notes on a sound scenario: settings without effect, and unlikely numbers.
#pragma once

#include "scenario/document.hpp"
#include "scenario/scenario.hpp"

namespace physim {

/// Adds a note for each setting that another one overrules, and for each number far from what is usual, with its place.
void add_notes(Scenario& scenario, const Value& document);

}  // namespace physim
