// A scenario's world, run to its end: what outputs need of it, the summary that people read, and what goes into files.
#pragma once

#include <deque>
#include <functional>

#include "report/flown.hpp"
#include "report/picture.hpp"
#include "report/records.hpp"
#include "report/style.hpp"
#include "scenario/world_run.hpp"

namespace physim::report {

/// The kind of file that a run is saved in, in errors.
inline constexpr const char* kSavedRun = "save";

/// What is kept of a run.
struct LogParts {
  bool samples = false, events = false, paths = false, hits = false;
  void add(const LogParts& more) {
    samples = samples || more.samples;
    events = events || more.events;
    paths = paths || more.paths;
    hits = hits || more.hits;
  }
};

/// How a run is logged.
struct LogOptions {
  LogParts parts;
  std::optional<double> interval;      // between samples [s]
  std::optional<std::uint64_t> steps;  // instead of the scenario's duration
  std::string record = {};             // into this file; empty: nowhere
  std::string load = {};               // continues from this save; empty: from the start
  std::string save = {};               // into this file; empty: nowhere
  std::optional<double> save_at = {};  // instead of at the end [s]
};

struct WorldSample {
  Launched launched;
  double time = 0;
  BodyState state;
};

struct LoggedEvent : WorldSample {
  EventKind kind;
  Reason reason = Reason::none;
  bool at_wall = false;  // a hit on the wall of the world, which is the reason
};

/// The way of one projectile, corners at bounces included.
struct LoggedPath {
  std::size_t group = 0;
  std::vector<Vec3d> points;
};

/// Fate of a joint.
struct LoggedJoint {
  std::uint64_t came_taut = 0;        // times, of a cable
  std::optional<JointEventKind> end;  // ended or broke; none: it holds
  double end_time = 0;                // [s]
};

struct WorldLog {
  Scenario scenario;
  std::vector<WorldGroup> groups;
  std::vector<FidelityInUse> in_use;  // by group; of the first projectile
  std::uint64_t steps = 0;
  double time = 0;
  std::uint64_t hash = 0;
  WorldCounters counters;
  std::vector<Check> checks;
  std::vector<std::string> notes;  // about how shots begin; none of a run that goes on

  /// The numbers of events and samples after a round of samples.
  struct Round {
    std::size_t events, samples;
  };
  std::deque<WorldSample> samples;  // those of rounds; of very many, a longer list must not need the room of two
  std::deque<LoggedEvent> events;   // all, or corners alone for samples
  std::vector<Round> rounds;
  std::deque<ThingHit> thing_hits;    // the first, if no part of the log needs all
  std::uint64_t thing_hit_count = 0;  // of all
  std::vector<LoggedJoint> joints;    // by Scenario::joints
  std::uint64_t unsolved_nets = 0;    // of joints, in steps
  std::vector<LoggedPath> paths;
  std::vector<std::vector<Vec3d>> impacts;  // by group
  std::vector<std::vector<Vec3d>> hits;     // by group
  std::vector<std::vector<Vec3d>> alive;    // by group, where it is an emitter: those at the end

  /// Calls take() for all samples, of rounds and of corners, in their order, but for samples that repeat the last one
  /// of their projectile. The path, or its slope, may jump at a corner.
  void each_sample(const std::function<void(const WorldSample&, bool is_corner)>& take) const;
};

/// Runs a scenario that has a [world]. An error with the place "interval" where there are too many samples.
[[nodiscard]] Result<WorldLog> run_world(const Scenario& scenario, const LogOptions& options,
                                         const Progress& progress = {});

[[nodiscard]] std::string world_text(const WorldLog& log, const Style& style);
/// A row for each sample.
[[nodiscard]] Records records_of(const WorldLog& log);
[[nodiscard]] Content world_events_csv(const WorldLog& log);
[[nodiscard]] Content world_json(const WorldLog& log);

}  // namespace physim::report
