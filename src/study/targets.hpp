// Whether an impact lies on a target.
//
// Polygons: a ray to the right of the impact crosses the outline an odd number of times.
// Source: M. Shimrat, "Algorithm 112: Position of Point Relative to Polygon", Comm. ACM 5 (1962) 434.
#pragma once

#include <span>
#include <string>

#include "physim/study.hpp"

namespace physim {

[[nodiscard]] Status check(const StudyTarget& target, const std::string& place);
/// How many impacts lie on it.
[[nodiscard]] std::uint64_t hits_of(const StudyTarget& target, std::span<const double> right,
                                    std::span<const double> up);

}  // namespace physim
