// Whether impacts lie on targets.
//
// Polygons: a ray to the right of the impact crosses the outline an odd number of times.
// Source: M. Shimrat, "Algorithm 112: Position of Point Relative to Polygon", Comm. ACM 5 (1962) 434.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "physim/event.hpp"
#include "physim/study.hpp"

namespace physim {

[[nodiscard]] Status check(const StudyTarget& target, const std::string& place);
/// Marks by 1 or 0 whether impacts of some shots lie on it; a thing is no part of the plane.
void mark_covered(const StudyTarget& target, std::span<const std::uint32_t> shots, std::span<const double> right,
                  std::span<const double> up, std::span<std::uint8_t> marks);

/// The things of the scene that each target names, in order; none for a part of the plane.
using ThingsOfTargets = std::vector<std::vector<InstanceId>>;
[[nodiscard]] ThingsOfTargets things_of(const Study& study);
/// Whether a study can have its scene and targets.
[[nodiscard]] Status check_things(const Study& study, bool of_flights);

}  // namespace physim
