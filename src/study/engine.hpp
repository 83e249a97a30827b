// Who flies the shards of a study: threads, or the ranks of a job.
#pragma once

#include <functional>

#include "study/part.hpp"

namespace physim {

/// Flies what is missing of the shards before `end` and adds it to the part; false where it was stopped.
using ShardEngine = std::function<bool(StudyPartRecord& part, std::uint64_t end)>;

/// A study from what is there of it to its end, or until its figure is known well enough: who flies changes no bit.
[[nodiscard]] Result<StudyResult> run_study_on(const StudyPlan& plan, const StudyPart& so_far,
                                               const ShardEngine& engine);

}  // namespace physim
