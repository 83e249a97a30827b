// Pictures of studies: where shots end, what moves them, how figures settle, and what becomes of them over range.
#pragma once

#include <span>
#include <vector>

#include "report/picture.hpp"
#include "report/study_answer.hpp"

namespace physim::report {

/// Impacts with ellipses of 1, 2 and 3 deviations on the targets (of one quantity its histogram); what a deviation of
/// each input does; the hit probability of the first target, else the mean distance from the aim, on its way to its
/// end. The impacts are those of the first shard, which is flown again for them.
[[nodiscard]] Picture study_picture(const std::string& title, const FlownStudy& flown);
/// Hit probability of each target with its interval, and how far shots scatter, over range.
[[nodiscard]] Picture ranges_picture(const std::string& title, std::span<const StudyAtRange> list);

/// Hit probability of each target with its interval over each input: those with the most different parts.
[[nodiscard]] Picture over_inputs_picture(const std::string& title, const FlownStudy& flown);

/// Histograms of a study that has some: of its quantities, then of distances, nine at most.
[[nodiscard]] Picture histograms_picture(const std::string& title, const FlownStudy& flown);

/// The closed rims of a target (a thing has none: no points), and of `deviations` deviations about the mean.
[[nodiscard]] std::vector<PlanePoint> rim_of(const StudyTarget& target);
[[nodiscard]] std::vector<PlanePoint> rim_of(const EllipseResult& ellipse, double deviations);

}  // namespace physim::report
