// Struck rows: those that a step left where they were, settled side by side if most of them do the one thing that
// games have by the thousand: they come down to the ground once and bounce, or end there.
//
// Settling takes any row through anything, alone, and most of that cost is waiting: for the search for the
// ground, a chain of operations each of which needs the last, and for getting ready. A kernel does it for a pack of
// rows at once (world/step/strike_packs.hpp), to the bit, and says for which of them that was all; settling takes the
// others.
#pragma once

#include "base/assert.hpp"
#include "world/step/kernels.hpp"
#include "world/step/settle.hpp"

namespace physim {

/// Calls f with every row that is marked, from `first` on and before `last`; no bit is set from there on.
template <class F>
void each_marked(const std::uint32_t* words, std::uint32_t first, std::uint32_t last, const F& f) {
  PHYSIM_ASSERT(words != nullptr && first % kRowsPerWord == 0);
  for (std::uint32_t word = first / kRowsPerWord; word * kRowsPerWord < last; ++word)
    for (std::uint32_t bits = words[word]; bits != 0; bits &= bits - 1) {
      const auto row =
          static_cast<std::uint32_t>(word * kRowsPerWord) + static_cast<std::uint32_t>(__builtin_ctz(bits));
      PHYSIM_ASSERT(row < last);
      f(row);
    }
}

/// Settles the rows of a chunk that are marked.
void settle_marked(const SettleContext& context, const WorldKernel& kernel, Chunk& chunk, const std::uint32_t* words);

}  // namespace physim
