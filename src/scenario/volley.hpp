// How the launches of a volley scatter.
#pragma once

#include "scenario/scenario.hpp"

namespace physim {

/// Launch `index` of a volley, scattered about a launch without a zero range. Always the same for a seed.
[[nodiscard]] Launch scattered(const Launch& launch, const Volley& volley, std::uint64_t index);

}  // namespace physim
