// A run of a world: the summary that people read, and what goes into files.
#pragma once

#include <string>

#include "report/picture.hpp"
#include "report/records.hpp"
#include "report/style.hpp"
#include "report/world_log.hpp"

namespace physim::report {

[[nodiscard]] std::string world_text(const WorldLog& log, const Style& style);
/// A row for each sample.
[[nodiscard]] Records records_of(const WorldLog& log);
[[nodiscard]] Content world_events_csv(const WorldLog& log);
[[nodiscard]] Content world_json(const WorldLog& log);

}  // namespace physim::report
