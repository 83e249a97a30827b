// The signature chart: error over cost of every rung of the ladder.
#pragma once

#include "report/ladder.hpp"
#include "report/picture.hpp"

namespace physim::report {

[[nodiscard]] Content ladder_picture(const LadderOfShot& subject);

}  // namespace physim::report
