// The picture of a world's run: its paths from the side and from above, and the wall.
#pragma once

#include "plot.hpp"
#include "world_log.hpp"

namespace physim::cli {

[[nodiscard]] Picture world_picture(const WorldLog& log);

}  // namespace physim::cli
