// Worlds in the golden hash.
#pragma once

#include <cstdint>

namespace physim::test {

/// Runs random worlds; false where kernels or threads change a bit.
bool add_worlds(std::uint64_t& hash);

}  // namespace physim::test
