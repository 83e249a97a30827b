// Fetching ahead: what lies at an address is brought near while something else is worked on.
#pragma once

#include <cstddef>

#include "physim/math.hpp"

namespace physim {

// g++ takes functions that do nothing else for pure, and drops calls of them: the empty statements keep them.

/// To be read soon, `offset` bytes behind an address.
PHYSIM_INLINE void prefetch_at(const void* object, std::size_t offset = 0) {
  const void* const address = static_cast<const char*>(object) + offset;
#if defined(__GNUC__)
  __builtin_prefetch(address);
  __asm__ volatile("" : : "r"(address));
#else
  static_cast<void>(address);
#endif
}

/// To be written soon, `offset` bytes behind an address.
PHYSIM_INLINE void prefetch_to_write(const void* object, std::size_t offset = 0) {
  const void* const address = static_cast<const char*>(object) + offset;
#if defined(__GNUC__)
  __builtin_prefetch(address, 1);
  __asm__ volatile("" : : "r"(address));
#else
  static_cast<void>(address);
#endif
}

}  // namespace physim
