// Where the shots of a study come down, as a map for globes.
#pragma once

#include "report/study_answer.hpp"

namespace physim::report {

/// KML: launch, mean impact, ellipses of 1, 2 and 3 deviations, the safety zone, targets and a thousand shots, all on
/// the ground. An error where shots end elsewhere, or the Earth is flat.
[[nodiscard]] Result<Text> study_kml(const AskedShot& asked, const FlownStudy& flown);

}  // namespace physim::report
