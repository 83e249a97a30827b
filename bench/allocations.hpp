// Counts what `new` is asked for in this program.
#pragma once

#include <cstdint>

namespace physim::bench {

/// Calls of operator new on any thread since the program started.
[[nodiscard]] std::int64_t allocations();

}  // namespace physim::bench
