// What archives must know of a study: its enumerations, and the format of saved parts.
#pragma once

#include "base/archive.hpp"
#include "physim/study.hpp"

namespace physim {

/// Raised whenever the results of shards, or the bytes of parts, change.
inline constexpr std::uint32_t kStudyFormat = 2;
/// The format of parts that have hits over inputs behind all else, as they were once written.
inline constexpr std::uint32_t kStudyFormatOverInputs = 3;
/// The format of parts that have more behind all else: hits over inputs, distances of replicates, places.
inline constexpr std::uint32_t kStudyFormatMore = 4;

}  // namespace physim
