// Hits on things of a scene, in a world's run and in flights: the table that people read, and what goes into files.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/json_stream.hpp"
#include "report/records.hpp"
#include "report/trajectory.hpp"
#include "report/world_log.hpp"

namespace physim::report {

inline constexpr std::size_t kShownHits = 40;  // in the table, and kept if no file wants all

/// Hits, what hit, and how often each was launched.
struct HitList {
  struct Group {
    std::string name;
    std::uint64_t launches;
  };
  const Scenario& scenario;
  const std::deque<ThingHit>& hits;
  std::uint64_t count;  // of all, which may be more
  std::vector<Group> groups;
};
[[nodiscard]] HitList hits_of(const WorldLog& log);
[[nodiscard]] HitList hits_of(const FlownScenario& flown);

[[nodiscard]] bool has_scene(const Scenario& scenario);
/// A row for each hit; empty without hits.
[[nodiscard]] std::string hits_table(const HitList& list);
[[nodiscard]] Content world_hits_csv(const WorldLog& log);
[[nodiscard]] Content flight_hits_csv(const Flights& flights);
/// A list "hits".
void add_hits(JsonStream& out, const HitList& list);

}  // namespace physim::report
