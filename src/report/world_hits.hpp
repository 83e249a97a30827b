// Hits of a world's run on things of its scene: the table that people read, and what goes into files.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/records.hpp"
#include "report/world_log.hpp"

namespace physim::report {

inline constexpr std::size_t kShownHits = 40;  // in the table, and kept where no file asks for all

[[nodiscard]] bool has_scene(const Scenario& scenario);
/// A row for each hit; empty where there is none.
[[nodiscard]] std::string hits_table(const WorldLog& log);
[[nodiscard]] Records hit_records(const WorldLog& log);
[[nodiscard]] Content world_hits_csv(const WorldLog& log);
[[nodiscard]] nlohmann::ordered_json hit_json(const WorldLog& log, const ThingHit& hit);

}  // namespace physim::report
