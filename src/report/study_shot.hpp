// One shot of a study, by its number: what it drew and where it ended.
#pragma once

#include <cstdint>

#include "physim/study.hpp"
#include "report/answer.hpp"

namespace physim::report {

/// Flies the shot's shard again; the numbers of shots and threads do not change the result.
[[nodiscard]] Answer study_shot_answer(const AskedShot& asked, const StudyPlan& plan, std::uint64_t shot,
                                       const Style& style);

}  // namespace physim::report
