// The signature chart: error over cost of every rung of the ladder.
#pragma once

#include <string>

#include "ladder.hpp"
#include "plot.hpp"

namespace physim::cli {

[[nodiscard]] Picture ladder_picture(const std::string& title, const Ladder& ladder);

}  // namespace physim::cli
