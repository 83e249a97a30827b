// The picture of a world's run: its paths from the side and from above, and the wall.
#pragma once

#include "report/picture.hpp"
#include "report/world_log.hpp"

namespace physim::report {

[[nodiscard]] Content world_picture(const WorldLog& log);

}  // namespace physim::report
