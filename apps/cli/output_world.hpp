// What `physim run` prints and writes of a world.
#pragma once

#include <string>

#include "terminal.hpp"
#include "world_log.hpp"

namespace physim::cli {

[[nodiscard]] std::string world_text(const WorldLog& log, const Style& style);
[[nodiscard]] std::string world_csv(const WorldLog& log);
[[nodiscard]] std::string world_events_csv(const WorldLog& log);
[[nodiscard]] std::string world_json(const WorldLog& log);

}  // namespace physim::cli
