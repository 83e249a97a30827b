#include "report/world_log.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "report/trajectory.hpp"

namespace physim::report {
namespace {

constexpr std::uint64_t kDefaultSamples = 200;  // over the run
constexpr std::uint64_t kPathPoints = 900;      // over the run, of each path
constexpr std::size_t kMostPaths = 400;         // of all groups together
constexpr std::size_t kMostImpacts = 20'000;    // of each group, drawn

class Logger {
 public:
  Logger(WorldRun& run, const LogOptions& options) : run_(run), options_(options) {
    log_.scenario = run.scenario();
    log_.steps = options.steps.value_or(run.steps());
    const std::size_t groups = run.groups().size();
    log_.in_use.resize(groups);
    met_.resize(groups);
    log_.impacts.resize(groups);
    log_.hits.resize(groups);
    paths_left_.assign(groups, std::max<std::size_t>(kMostPaths / std::max<std::size_t>(groups, 1), 1));
    const double dt = run.scenario().world.def.step;
    const auto asked = static_cast<std::uint64_t>(std::llround(std::min(options.interval.value_or(0) / dt, 1e15)));
    sample_every_ = std::max<std::uint64_t>(options.interval ? asked : log_.steps / kDefaultSamples, 1);
    PHYSIM_ASSERT(dt > 0);
    draw_every_ = std::max<std::uint64_t>(log_.steps / kPathPoints, 1);
  }

  Status run(const Progress& progress) {
    take(run_.events());
    if (Status status = sample(); !status) return status;
    for (std::uint64_t step = 1; step <= log_.steps; ++step) {
      const std::size_t launched = step == 1 ? run_.events().size() : 0;  // these are taken already
      run_.step();
      take(run_.events().subspan(launched));
      for (const WallHit& hit : run_.hits()) take(hit);
      if (options_.parts.paths && (step % draw_every_ == 0 || step == log_.steps)) draw();
      if (step % sample_every_ == 0 || step == log_.steps)
        if (Status status = sample(); !status) return status;
      if (progress) progress(step, log_.steps);
    }
    return {};
  }

  WorldLog finish() {
    log_.groups = run_.groups();
    log_.time = run_.world().time();
    log_.hash = run_.world().hash();
    log_.counters = run_.world().counters();
    PHYSIM_ASSERT(log_.groups.size() == log_.hits.size());
    for (const Expectation& expectation : log_.scenario.expect)
      for (const WorldGroup& group : log_.groups)
        if (expectation.shot.empty() || expectation.shot == group.name)
          log_.checks.push_back(judged(expectation, group.name, measure(group, expectation)));
    return std::move(log_);
  }

 private:
  /// The points of the path that a launch draws; null where it draws none.
  std::vector<Vec3d>* path_of(const Launched& launched) {
    const bool draws = launched.number < path_.size() && path_[launched.number] != 0;
    PHYSIM_ASSERT(!draws || log_.paths[path_[launched.number] - 1].group == launched.group);
    return draws ? &log_.paths[path_[launched.number] - 1].points : nullptr;
  }

  void begin(const RunEvent& spawned) {
    const auto& [group, number] = spawned.launched;
    PHYSIM_ASSERT(group < met_.size());
    PHYSIM_ASSERT(number >= path_.size());  // launches are told in their order
    if (!met_[group] && run_.world()[spawned.event.id].is_alive()) {
      log_.in_use[group] = run_.world()[spawned.event.id].fidelity_in_use();
      met_[group] = true;
    }
    if (!options_.parts.paths || paths_left_[group] == 0) return;
    --paths_left_[group];
    log_.paths.push_back({group, {}});
    path_.resize(number + 1);
    path_[number] = log_.paths.size();
  }

  void take(std::span<const RunEvent> events) {
    for (const RunEvent& each : events) {
      const Event& event = each.event;
      if (event.kind == EventKind::spawned) begin(each);
      const bool is_at_wall = event.reason == Reason::despawned;  // its hit is told instead
      if (is_at_wall) continue;
      if (auto* path = path_of(each.launched)) path->push_back(event.position);
      const bool is_impact = event.kind == EventKind::landed || event.kind == EventKind::bounced;
      std::vector<Vec3d>& impacts = log_.impacts[each.launched.group];
      if (options_.parts.paths && is_impact && impacts.size() < kMostImpacts) impacts.push_back(event.position);
      PHYSIM_ASSERT(event.time <= run_.world().time());
      if (options_.parts.events)
        log_.events.push_back(
            {name(event.kind), name(event.reason), each.launched, event.time, {event.position, event.velocity}});
    }
  }

  void take(const WallHit& hit) {
    if (auto* path = path_of(hit.launched)) path->push_back(hit.position);
    std::vector<Vec3d>& hits = log_.hits[hit.launched.group];
    if (options_.parts.paths && hits.size() < kMostImpacts) hits.push_back(hit.position);
    if (options_.parts.events)
      log_.events.push_back({"hit", "wall", hit.launched, hit.time, {hit.position, hit.velocity}});
  }

  void draw() {
    for (const ProjectileId id : run_.world().ids())
      if (const auto launched = run_.launched(id))
        if (auto* path = path_of(*launched)) path->push_back(run_.world()[id].position());
  }

  Status sample() {
    if (!options_.parts.samples) return {};
    for (const ProjectileId id : run_.world().ids())
      if (const auto launched = run_.launched(id))
        log_.samples.push_back({*launched, run_.world().time(), run_.world()[id].state()});
    if (log_.samples.size() <= kMaxSamples) return {};
    return Error{.message = "there are more than " + std::to_string(kMaxSamples) + " samples",
                 .place = "interval",
                 .hint = "take a longer interval"};
  }

  WorldRun& run_;
  const LogOptions& options_;
  WorldLog log_;
  std::vector<std::size_t> path_;        // by number of the launch: 0 for none, or one more than its index
  std::vector<std::size_t> paths_left_;  // by group
  std::vector<bool> met_;                // groups
  std::uint64_t sample_every_ = 1, draw_every_ = 1;
};

}  // namespace

Result<WorldLog> run_world(const Scenario& scenario, const LogOptions& options, const Progress& progress) {
  Result<WorldRun> made = WorldRun::create(scenario, options.record);
  if (!made) return made.error();
  WorldRun& run = *made;
  Logger logger(run, options);
  if (Status status = logger.run(progress); !status) return status.error();
  if (!options.record.empty())
    if (Status status = run.world().stop_recording(); !status) return status.error();
  return logger.finish();
}

}  // namespace physim::report
