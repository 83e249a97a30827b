// What archives need of a study: its enumerations, and the format of saved parts.
#pragma once

#include "base/archive.hpp"
#include "physim/study.hpp"

namespace physim {

/// Raised whenever the bytes of parts change. Results of shards may differ between versions without it: parts name the
/// version that flew them, and others refuse them.
inline constexpr std::uint32_t kStudyFormat = 5;

}  // namespace physim
