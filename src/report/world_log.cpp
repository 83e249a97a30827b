#include "report/world_log.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "physim/scenario.hpp"
#include "report/fidelity_text.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/summary.hpp"
#include "report/table.hpp"
#include "report/trajectory.hpp"
#include "report/world_hits.hpp"
#include "scenario/expectation.hpp"
#include "scenario/names.hpp"
#include "scenario/text_file.hpp"
#include "scenario/thing_hits.hpp"

namespace physim::report {
namespace {

constexpr std::uintmax_t kLargestSave = std::uintmax_t{4} << 30;  // [bytes]
constexpr std::uint64_t kSamplesOfRun = 200;                      // over the run
constexpr std::uint64_t kPathPoints = 900;                        // over the run, of each path
constexpr std::size_t kMostPaths = 400;       // of all groups together, evenly out of their launches
constexpr std::size_t kMostImpacts = 20'000;  // of each group, drawn; and of those alive at the end

/// Whether a group has what an expectation asks of groups.
bool has_figure(const Expectation& expectation, const WorldGroup& group) {
  const physim::Figure* figure = find_figure(expectation.quantity);
  return figure == nullptr || !figure->is_of_emitters || group.emitter;
}

class Logger {
 public:
  Logger(WorldRun& run, const LogOptions& options) : run_(&run), options_(options) {
    log_.scenario = run.scenario();
    log_.steps = options.steps.value_or(run.steps());
    const std::size_t groups = run.groups().size();
    log_.in_use.resize(groups);
    log_.joints.resize(log_.scenario.joints.size());
    met_.resize(groups);
    log_.impacts.resize(groups);
    log_.hits.resize(groups);
    log_.alive.resize(groups);
    passages_.resize(groups);
    drawn_.resize(groups);
    most_drawn_ = std::max<std::size_t>(kMostPaths / std::max<std::size_t>(groups, 1), 2);
    const double dt = run.scenario().world.def.step;
    const auto asked = static_cast<std::uint64_t>(std::llround(std::min(options.interval.value_or(0) / dt, 1e15)));
    sample_every_ = std::max<std::uint64_t>(options.interval ? asked : log_.steps / kSamplesOfRun, 1);
    PHYSIM_ASSERT(dt > 0);
    draw_every_ = std::max<std::uint64_t>(log_.steps / kPathPoints, 1);
  }

  /// Steps a run from its present step to the last one.
  Status run(const Progress& progress) {
    const std::uint64_t before = run_->world().counters().steps;
    if (before > 0)
      meet_all();
    else
      take(run_->events());
    if (Status status = sample(); !status) return status;
    if (Status status = save(before); !status) return status;
    return run_on(before, log_.steps, progress);
  }

  /// Flies a run from its start to the step of another one, which was loaded, and continues with that one.
  Status run_up_to(WorldRun& loaded, const Progress& progress) {
    PHYSIM_ASSERT(run_->world().counters().steps == 0);
    const std::uint64_t before = loaded.world().counters().steps;
    take(run_->events());
    if (Status status = sample(); !status) return status;
    is_again_ = true;
    if (Status status = run_on(0, before, progress); !status) return status;
    is_again_ = false;
    if (run_->world().hash() != loaded.world().hash())
      return Error{.message = "what happened before the save cannot be told: flown again, it is another run",
                   .place = options_.load,
                   .hint = "load it without files of events, hits and paths, or fly the whole run"};
    run_ = &loaded;
    if (Status status = save(before); !status) return status;
    return run_on(before, log_.steps, progress);
  }

  WorldLog finish() {
    log_.groups = run_->groups();
    log_.time = run_->world().time();
    log_.hash = run_->world().hash();
    log_.counters = run_->world().counters();
    log_.unsolved_nets = run_->world().joint_counts().unsolved;
    PHYSIM_ASSERT(log_.groups.size() == log_.hits.size());
    if (options_.parts.paths) mark_alive();
    std::erase_if(log_.paths, [](const LoggedPath& path) { return path.points.empty(); });
    add_checks();
    return std::move(log_);
  }

 private:
  /// Which launches of a group draw their path.
  struct Drawn {
    std::uint64_t launches = 0;          // counted up to now
    std::uint64_t every = 1;             // so manyth of them
    std::vector<std::uint64_t> numbers;  // of those that do
  };

  Status run_on(std::uint64_t from, std::uint64_t to, const Progress& progress) {
    for (std::uint64_t step = from + 1; step <= to; ++step) {
      const std::size_t launched = step == 1 ? run_->events().size() : 0;  // these are taken already
      run_->step();
      take(run_->events().subspan(launched), run_->hits());
      take_hits();
      take_joints();
      if (options_.parts.paths && (step % draw_every_ == 0 || step == log_.steps)) draw();
      if (step % sample_every_ == 0 || step == log_.steps)
        if (Status status = sample(); !status) return status;
      if (Status status = is_again_ ? Status() : save(step); !status) return status;
      if (progress) progress(step, log_.steps);
    }
    return {};
  }

  void add_checks() {
    NameIndex names;
    for (const WorldGroup& group : log_.groups) names.add(group.name);
    for (const Expectation& expectation : log_.scenario.expect) {
      const auto check = [&](std::size_t i) {
        const WorldGroup& group = log_.groups[i];
        if (has_figure(expectation, group))
          log_.checks.push_back(judged(expectation, group.name, measure(group, passages_[i], expectation)));
      };
      if (expectation.shot.empty())
        for (std::size_t i = 0; i < log_.groups.size(); ++i) check(i);
      else if (const auto named = names.find(expectation.shot))
        check(*named);
    }
  }

  /// Those that a save brought along.
  void meet_all() {
    for (const ProjectileId id : run_->world().ids())
      if (const auto launched = run_->launched(id); launched && !met_[launched->group]) {
        log_.in_use[launched->group] = run_->world()[id].fidelity_in_use();
        met_[launched->group] = true;
      }
  }

  /// Saves the run after a step, where that is the one to save it after.
  Status save(std::uint64_t step) {
    if (options_.save.empty() || is_saved_) return {};
    const double dt = run_->scenario().world.def.step;
    const double at = options_.save_at ? std::ceil(*options_.save_at / dt - 1e-9) : static_cast<double>(log_.steps);
    if (static_cast<double>(step) > at)
      return Error{"the run that was loaded is later already", "save_at",
                   "it is at " + significant(run_->world().time(), 6) + " s"};
    if (static_cast<double>(step) < at) return {};
    is_saved_ = true;
    const auto bytes = run_->save();
    return bytes ? save_recording(options_.save, *bytes) : Status(bytes.error());
  }

  /// The points of the path that a launch draws; null where it draws none.
  std::vector<Vec3d>* path_of(const Launched& launched) {
    const bool draws = launched.number < path_.size() && path_[launched.number] != 0;
    PHYSIM_ASSERT(!draws || log_.paths[path_[launched.number] - 1].group == launched.group);
    return draws ? &log_.paths[path_[launched.number] - 1].points : nullptr;
  }

  void begin(const RunEvent& spawned) {
    const auto& [group, number] = spawned.launched;
    PHYSIM_ASSERT(group < met_.size());
    PHYSIM_ASSERT(number >= path_.size());  // launches are reported in their order
    if (!met_[group] && run_->world()[spawned.event.id].is_alive()) {
      log_.in_use[group] = run_->world()[spawned.event.id].fidelity_in_use();
      met_[group] = true;
    }
    if (!options_.parts.paths) return;
    Drawn& drawn = drawn_[group];
    const bool is_due = drawn.launches++ % drawn.every == 0;
    if (is_due && drawn.numbers.size() == most_drawn_) thin_out(drawn);
    if ((drawn.launches - 1) % drawn.every != 0) return;
    drawn.numbers.push_back(number);
    log_.paths.push_back({group, {}});
    path_.resize(number + 1);
    path_[number] = log_.paths.size();
  }

  /// Takes every second path of a group away, and draws every second one of those to come.
  void thin_out(Drawn& drawn) {
    drawn.every *= 2;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < drawn.numbers.size(); ++i) {
      std::size_t& path = path_[drawn.numbers[i]];
      PHYSIM_ASSERT(path > 0);
      if (i % 2 == 0) {
        drawn.numbers[kept++] = drawn.numbers[i];
      } else {
        log_.paths[path - 1].points = {};
        path = 0;
      }
    }
    drawn.numbers.resize(kept);
  }

  /// Where the particles of emitters are at the end.
  void mark_alive() {
    for (const ProjectileId id : run_->world().ids())
      if (const auto launched = run_->launched(id); launched && log_.groups[launched->group].emitter)
        if (auto& points = log_.alive[launched->group]; points.size() < kMostImpacts)
          points.push_back(run_->world()[id].position());
  }

  /// Events and hits on the wall of a step, in order of time.
  void take(std::span<const RunEvent> events, std::span<const WallHit> walls = {}) {
    const auto take_walls = [&](double until) {
      for (; !walls.empty() && walls.front().time <= until; walls = walls.subspan(1)) {
        const WallHit& hit = walls.front();
        const WorldSample at{hit.launched, hit.time, {hit.position, hit.velocity}};
        tell({at, EventKind::hit, Reason::none, true}, &log_.hits);
      }
    };
    for (const RunEvent& each : events) {
      const Event& event = each.event;
      take_walls(event.time);
      if (event.kind == EventKind::spawned) begin(each);
      if (event.reason == Reason::despawned) continue;  // at the wall: its hit is counted instead
      const bool is_impact = event.kind == EventKind::landed || event.kind == EventKind::bounced;
      const WorldSample at{each.launched, event.time, {event.position, event.velocity}};
      tell({at, event.kind, event.reason}, is_impact ? &log_.impacts : nullptr);
    }
    take_walls(kInfinity);
  }

  void take_hits() {
    for (const ThingHit& hit : run_->thing_hits()) {
      if (options_.parts.hits || log_.thing_hits.size() < kShownHits) log_.thing_hits.push_back(hit);
      ++log_.thing_hit_count;
      PHYSIM_ASSERT(hit.launched.group < passages_.size());
      count_passage(passages_[hit.launched.group], hit, log_.scenario);
    }
  }

  /// Events of joints of a step, and of calls behind it.
  void take_joints() {
    if (log_.joints.empty()) return;
    const std::span<const JointId> ids = run_->joints();
    PHYSIM_ASSERT(ids.size() == log_.joints.size());
    for (const JointEvent& event : run_->world().joint_events()) {
      const auto at = std::ranges::lower_bound(ids, event.joint.index, {}, &JointId::index);
      PHYSIM_ASSERT(at != ids.end());
      LoggedJoint& joint = log_.joints[static_cast<std::size_t>(at - ids.begin())];
      if (event.kind == JointEventKind::came_taut)
        ++joint.came_taut;
      else
        joint.end = event.kind, joint.end_time = event.time;
    }
    for (std::size_t i = 0; i < ids.size(); ++i)  // a launch of the step may have ended it, by taking a place
      if (LoggedJoint& joint = log_.joints[i]; !joint.end && run_->world().joint(ids[i]) == nullptr)
        joint.end = JointEventKind::ended, joint.end_time = run_->world().time();
  }

  /// `marks`: what the picture marks, by group; null for nothing.
  void tell(const LoggedEvent& event, std::vector<std::vector<Vec3d>>* marks) {
    PHYSIM_ASSERT(event.time < run_->world().time() + log_.scenario.world.def.step);
    if (auto* path = path_of(event.launched)) path->push_back(event.state.position);
    if (options_.parts.paths && marks != nullptr)
      if (auto& points = (*marks)[event.launched.group]; points.size() < kMostImpacts)
        points.push_back(event.state.position);
    if (options_.parts.events || (options_.parts.samples && may_break_path(event.kind))) log_.events.push_back(event);
  }

  void draw() {
    for (const ProjectileId id : run_->world().ids())
      if (const auto launched = run_->launched(id))
        if (auto* path = path_of(*launched)) path->push_back(run_->world()[id].position());
  }

  Status sample() {
    if (!options_.parts.samples) return {};
    for (const ProjectileId id : run_->world().ids())
      if (const auto launched = run_->launched(id))
        log_.samples.push_back({*launched, run_->world().time(), run_->world()[id].state()});
    log_.rounds.push_back({log_.events.size(), log_.samples.size()});
    if (log_.samples.size() <= kMaxSamples) return {};
    return Error{.message = "there are more than " + std::to_string(kMaxSamples) + " samples",
                 .place = "interval",
                 .hint = "take a longer interval"};
  }

  WorldRun* run_;  // the one that is stepped
  const LogOptions& options_;
  WorldLog log_;
  std::vector<std::size_t> path_;  // by number of the launch: 0 for none, or one more than its index
  std::vector<Drawn> drawn_;       // by group
  std::size_t most_drawn_ = 0;     // paths of each group
  std::vector<bool> met_;          // groups
  std::uint64_t sample_every_ = 1, draw_every_ = 1;
  bool is_saved_ = false;
  bool is_again_ = false;           // it flies what was saved
  std::vector<Passages> passages_;  // by group, in the whole run: with things, a loaded run is flown from the start
};

using Json = nlohmann::ordered_json;
constexpr int kTableIndent = 2;

std::string hash_text(std::uint64_t value) { return hex(value).substr(2); }

// -------------------------------------------------------------------------------------------------------- the summary
struct CountColumn {
  std::string_view name;
  std::uint64_t (*of)(const WorldGroup&);
  bool always = false;  // shown where it is zero everywhere, too
};
constexpr CountColumn kCounts[] = {
    {"spawned", [](const WorldGroup& g) { return g.spawned; }, true},
    {"refused", [](const WorldGroup& g) { return g.refused; }},
    {"landed", [](const WorldGroup& g) { return g.landed; }},
    {"hits", [](const WorldGroup& g) { return g.hits; }},
    {"bounces", [](const WorldGroup& g) { return g.bounces; }},
    {"slept", [](const WorldGroup& g) { return g.slept; }},
    {"expired", [](const WorldGroup& g) { return g.expired; }},
    {"retired", [](const WorldGroup& g) { return g.retired; }},
    {"alive", [](const WorldGroup& g) { return g.alive; }, true},
};

// What emitters say of their particles, beside how often these hit and bounced.
constexpr CountColumn kEmitterCounts[] = {
    {"born", [](const WorldGroup& g) { return g.counts.born; }, true},
    {"alive", [](const WorldGroup& g) { return std::uint64_t{g.counts.alive}; }, true},
    {"refused", [](const WorldGroup& g) { return g.counts.refused; }},
    {"aged", [](const WorldGroup& g) { return g.counts.aged; }},
    {"landed", [](const WorldGroup& g) { return g.counts.landed; }},
    {"expired", [](const WorldGroup& g) { return g.counts.expired; }},
    {"replaced", [](const WorldGroup& g) { return g.counts.replaced; }},
    {"taken", [](const WorldGroup& g) { return g.counts.taken; }},
    {"cut", [](const WorldGroup& g) { return g.counts.cut; }},
    {"hits", [](const WorldGroup& g) { return g.hits; }},
    {"bounces", [](const WorldGroup& g) { return g.bounces; }},
    {"slept", [](const WorldGroup& g) { return g.slept; }},
};

// Counts that are zero everywhere are left out.
std::string counts_table(const std::vector<WorldGroup>& all, bool of_emitters, std::span<const CountColumn> counts) {
  std::vector<const WorldGroup*> groups;
  for (const WorldGroup& group : all)
    if (static_cast<bool>(group.emitter) == of_emitters) groups.push_back(&group);
  std::vector<std::string> columns = {of_emitters ? "emitter" : "what"};
  std::vector<CountColumn> shown;
  for (const CountColumn& column : counts) {
    const bool is_zero = std::ranges::all_of(groups, [&](const WorldGroup* g) { return column.of(*g) == 0; });
    if (!column.always && is_zero) continue;
    columns.emplace_back(column.name);
    shown.push_back(column);
  }
  Table table(columns, "l");
  for (const WorldGroup* group : groups) {
    std::vector<std::string> row = {one_line(group->name)};
    for (const CountColumn& column : shown) row.push_back(std::to_string(column.of(*group)));
    table.add_row(std::move(row));
  }
  return table.empty() ? "" : table.text(kTableIndent);
}

/// What was fired as shots or in volleys, then what emitters fired.
std::string counts_tables(const std::vector<WorldGroup>& groups) {
  const std::string fired = counts_table(groups, false, kCounts), emitted = counts_table(groups, true, kEmitterCounts);
  return fired + (fired.empty() || emitted.empty() ? "" : "\n") + emitted;
}

std::string below(const Table& table) { return table.empty() ? "" : "\n" + table.text(kTableIndent); }

std::string impacts_table(const std::vector<WorldGroup>& groups) {
  Table table({"impacts of", "count", "range [m]", "nearest", "farthest", "spread", "time [s]", "from", "to",
               "speed [m/s]", "from", "to"},
              "l");
  for (const WorldGroup& g : groups)
    if (g.range.count > 0)
      table.add_row({one_line(g.name), std::to_string(g.range.count), fixed(g.range.mean, 3), fixed(g.range.low, 3),
                     fixed(g.range.high, 3), fixed(g.range.spread(), 3), fixed(g.time.mean, 4), fixed(g.time.low, 4),
                     fixed(g.time.high, 4), fixed(g.speed.mean, 2), fixed(g.speed.low, 2), fixed(g.speed.high, 2)});
  return below(table);
}

std::string wall_table(const std::vector<WorldGroup>& groups, double wall) {
  Table table(
      {"hits on the wall at " + as_typed(wall) + " m", "count", "height [m]", "spread", "to the right [m]", "spread"},
      "l");
  for (const WorldGroup& g : groups)
    if (g.hit_y.count > 0)
      table.add_row({one_line(g.name), std::to_string(g.hit_y.count), fixed(g.hit_y.mean, 3),
                     fixed(g.hit_y.spread(), 3), fixed(g.hit_z.mean, 3), fixed(g.hit_z.spread(), 3)});
  return below(table);
}

std::string alive_table(const std::vector<WorldGroup>& groups, double time) {
  Table table({"alive at " + as_typed(time) + " s", "count", "x [m]", "y [m]", "z [m]", "speed [m/s]"}, "l");
  for (const WorldGroup& g : groups)
    if (g.alive > 0)
      table.add_row({one_line(g.name), std::to_string(g.alive), fixed(g.position.x, 3), fixed(g.position.y, 3),
                     fixed(g.position.z, 3), fixed(g.mean_speed, 3)});
  return below(table);
}

/// Joints that came taut or are there no more.
std::string joints_table(const WorldLog& log) {
  constexpr std::size_t kShown = 40;
  Table table({"joint", "kind", "came taut", "end", "at [s]"}, "llrl");
  std::size_t all = 0;
  for (std::size_t i = 0; i < log.joints.size(); ++i) {
    const LoggedJoint& joint = log.joints[i];
    if (joint.came_taut == 0 && !joint.end) continue;
    if (++all > kShown) continue;
    table.add_row({one_line(log.scenario.joints[i].name), std::string(name(log.scenario.joints[i].def.kind)),
                   joint.came_taut > 0 ? std::to_string(joint.came_taut) : "",
                   joint.end ? std::string(name(*joint.end)) : "", joint.end ? fixed(joint.end_time, 4) : ""});
  }
  std::string out = below(table);
  if (all > kShown) out += "  and " + std::to_string(all - kShown) + " more, which --json FILE writes\n";
  if (log.unsolved_nets > 0)
    out += "\n  nets of joints not solved in a step, as they contradict themselves or the step is too long for them: " +
           std::to_string(log.unsolved_nets) + "\n";
  return out;
}

// The rungs of each shot; its groups share them.
std::string fidelities(const WorldLog& log, const Style& style) {
  std::string out;
  std::set<std::size_t> told;
  PHYSIM_ASSERT(log.in_use.size() == log.groups.size());
  for (std::size_t i = 0; i < log.groups.size(); ++i) {
    const std::size_t shot = log.groups[i].shot;
    if (log.groups[i].spawned == 0 || !told.insert(shot).second) continue;
    const ProjectileDef& projectile = log.scenario.shots[shot].projectile;
    out += std::string(told.size() == 1 ? "\n" : "") + "  " + style.bold(one_line(projectile.name)) + " " +
           preset_name(projectile.fidelity) + ": " + in_words(log.in_use[i].fidelity) + "\n";
    for (const FidelityNote& note : log.in_use[i].notes)
      out += "    " + style.warn("note") + " " + note_text(note) + "\n";
  }
  return out;
}

// ---------------------------------------------------------------------------------------------------------- the files
/// Records with a state at the end of each row.
using Cells = std::vector<Cell>;
template <class Each, class Head>
Records records_with_states(std::vector<std::string> columns, const Each& each_entry, const Head& head_of) {
  columns.insert(columns.end(), {"x [m]", "y [m]", "z [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]"});
  return {std::move(columns), [each_entry, head_of](const auto& take) {
            each_entry([&](const auto& entry) {
              const auto& [x, v] = entry.state;
              Cells row = head_of(entry);
              row.insert(row.end(), {x.x, x.y, x.z, v.x, v.y, v.z});
              take(row);
            });
          }};
}

std::string_view reason_of(const LoggedEvent& event) { return event.at_wall ? "wall" : name(event.reason); }

Json series_json(const Series& series) {
  if (series.count == 0) return nullptr;
  return {{"count", series.count},
          {"mean", series.mean},
          {"min", series.low},
          {"max", series.high},
          {"spread", series.spread()}};
}

Json group_json(const WorldLog& log, std::size_t index) {
  const WorldGroup& g = log.groups[index];
  PHYSIM_ASSERT(g.shot < log.scenario.shots.size());
  PHYSIM_ASSERT(g.alive <= g.spawned);
  Json out = {{"name", g.name}, {"shot", log.scenario.shots[g.shot].projectile.name}};
  for (const CountColumn& column : kCounts) out[std::string(column.name)] = column.of(g);
  if (g.emitter)
    for (const CountColumn& column : kEmitterCounts) out["emitter"][std::string(column.name)] = column.of(g);
  out["impact_range [m]"] = series_json(g.range);
  out["impact_time [s]"] = series_json(g.time);
  out["impact_speed [m/s]"] = series_json(g.speed);
  out["apex [m]"] = series_json(g.apex);
  out["hit_y [m]"] = series_json(hit_heights(g));
  out["hit_z [m]"] = series_json(hit_sides(g));
  out["fidelity_granted"] = g.spawned > 0 ? Json(in_words(log.in_use[index].fidelity)) : Json();
  return out;
}

Json joint_json(const WorldLog& log, std::size_t index) {
  const ScenarioJoint& of = log.scenario.joints[index];
  const LoggedJoint& joint = log.joints[index];
  return {{"name", of.name},
          {"kind", name(of.def.kind)},
          {"came_taut", joint.came_taut},
          {"end", joint.end ? Json(name(*joint.end)) : Json()},
          {"end_time [s]", joint.end ? Json(joint.end_time) : Json()}};
}

Json event_json(const WorldLog& log, const LoggedEvent& event) {
  return {{"time [s]", event.time},
          {"kind", name(event.kind)},
          {"reason", reason_of(event)},
          {"what", log.groups[event.launched.group].name},
          {"number", event.launched.number},
          {"position [m]", vector_json(event.state.position)},
          {"velocity [m/s]", vector_json(event.state.velocity)}};
}

/// True if a part of the log, or the table of hits or joints, holds what happened since the start.
bool tells_of_past(const LogParts& parts, const Scenario& scenario) {
  return parts.samples || parts.events || parts.paths || parts.hits || has_scene(scenario) || !scenario.joints.empty();
}

}  // namespace

void WorldLog::each_sample(const std::function<void(const WorldSample&, bool is_corner)>& take) const {
  std::vector<const WorldSample*> last;  // by number of the launch
  const auto hand_over = [&](const WorldSample& sample, bool is_corner) {
    const std::uint64_t number = sample.launched.number;
    if (last.size() <= number) last.resize(number + 1);
    const WorldSample* const before = std::exchange(last[number], &sample);
    if (before == nullptr || before->time != sample.time || before->state != sample.state) take(sample, is_corner);
  };
  std::size_t event = 0, sample = 0;
  const auto hand_over_corners = [&](std::size_t until) {
    for (; event < until; ++event)
      if (may_break_path(events[event].kind)) hand_over(events[event], true);
  };
  for (const Round& round : rounds) {
    PHYSIM_ASSERT(round.events >= event && round.samples >= sample);
    hand_over_corners(round.events);
    for (; sample < round.samples; ++sample) hand_over(samples[sample], false);
  }
  hand_over_corners(events.size());
}

Result<WorldLog> run_world(const Scenario& scenario, const LogOptions& options, const Progress& progress) {
  Result<std::vector<std::byte>> saved = std::vector<std::byte>();
  if (!options.load.empty()) saved = read_byte_file(options.load, kLargestSave, kSavedRun);
  if (!saved) return saved.error();
  Result<WorldRun> made = options.load.empty() ? WorldRun::create(scenario, options.record)
                                               : WorldRun::load(scenario, *saved, options.record);
  if (!made) {
    Error error = made.error();
    if (error.place == "save") error.place = options.load;
    return error;
  }
  WorldRun& run = *made;
  if (const std::uint64_t steps = options.steps.value_or(run.steps()); run.world().counters().steps > steps)
    return Error{.message = "the run is at " + significant(run.world().time(), 6) +
                            " s, behind the end of this one at " +
                            significant(static_cast<double>(steps) * scenario.world.def.step, 6) + " s",
                 .place = options.load,
                 .hint = "lengthen world.duration, or take more --steps"};
  std::optional<WorldRun> past;  // what happened before a save is flown again, if something tells of it
  if (!options.load.empty() && tells_of_past(options.parts, scenario)) {
    Result<WorldRun> again = WorldRun::create(scenario);
    if (!again) return again.error();
    past.emplace(std::move(*again));
  }
  std::vector<std::string> notes;
  if (options.load.empty() && run.world().scene())
    notes = notes_of_beginnings(scenario, *run.world().scene(), run.things());
  Logger logger(past ? *past : run, options);
  if (Status status = past ? logger.run_up_to(run, progress) : logger.run(progress); !status) return status.error();
  if (!options.record.empty())
    if (Status status = run.world().stop_recording(); !status) return status.error();
  WorldLog log = logger.finish();
  log.notes = std::move(notes);
  return log;
}

std::string world_text(const WorldLog& log, const Style& style) {
  const double step = log.scenario.world.def.step;
  std::string out = style.bold(one_line(title_of(log.scenario))) + "\n\n";
  out += counts_tables(log.groups) + impacts_table(log.groups);
  if (log.scenario.world.wall) out += wall_table(log.groups, *log.scenario.world.wall);
  out += hits_table(hits_of(log)) + joints_table(log);
  out += alive_table(log.groups, log.time) + fidelities(log, style);
  out += "\n  steps " + std::to_string(log.steps) + " of " + significant(step, 6) + " s, projectile-steps " +
         std::to_string(log.counters.projectile_steps) + ", hash " + hash_text(log.hash) + "\n";
  if (!log.checks.empty()) out += "\n" + checks_text(log.checks, style);
  return out;
}

Records records_of(const WorldLog& log) {
  const auto each = [&log](const auto& take) { log.each_sample([&](const WorldSample& at, bool) { take(at); }); };
  return records_with_states({"what", "number", "t [s]"}, each, [&log](const WorldSample& sample) -> Cells {
    const auto& [group, number] = sample.launched;
    PHYSIM_ASSERT(group < log.groups.size());
    return {log.groups[group].name, number, sample.time};
  });
}

Content world_events_csv(const WorldLog& log) {
  const std::vector<std::string> columns = {"t [s]", "event", "reason", "what", "number"};
  const auto each = [&log](const auto& take) { std::ranges::for_each(log.events, take); };
  return csv_text(records_with_states(columns, each, [&log](const LoggedEvent& event) -> Cells {
    const auto& [group, number] = event.launched;
    PHYSIM_ASSERT(group < log.groups.size());
    return {event.time, name(event.kind), reason_of(event), log.groups[group].name, number};
  }));
}

Content world_json(const WorldLog& log) {
  return [&log](const Sink& sink) {
    JsonStream out(sink);
    out.object();
    add_provenance(out, log.scenario, log.notes);
    out.object("world");
    out.add({{"steps", log.steps},
             {"time [s]", log.time},
             {"projectile_steps", log.counters.projectile_steps},
             {"hash", hash_text(log.hash)}});
    out.list("groups");
    for (std::size_t i = 0; i < log.groups.size(); ++i) out.push(group_json(log, i));
    out.close();
    out.list("events");
    for (const LoggedEvent& event : log.events) out.push(event_json(log, event));
    out.close();
    if (has_scene(log.scenario)) add_hits(out, hits_of(log));
    if (!log.joints.empty()) {
      out.add({{"unsolved_nets", log.unsolved_nets}});
      out.list("joints");
      for (std::size_t i = 0; i < log.joints.size(); ++i) out.push(joint_json(log, i));
      out.close();
    }
    out.object("trajectories");
    add_columns(out, records_of(log));
    out.close();
    out.close();
    add_checks(out, log.checks);
    out.close();
  };
}

}  // namespace physim::report
