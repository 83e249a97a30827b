// physim run: flies the shots of a scenario, prints them, writes them, and checks its [[expect]] blocks.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "asked.hpp"
#include "outputs.hpp"
#include "physim/names.hpp"
#include "report/file.hpp"
#include "report/gnuplot.hpp"
#include "report/number.hpp"
#include "report/pictures.hpp"
#include "report/summary.hpp"
#include "report/table.hpp"
#include "report/world_log.hpp"
#include "scenario/new_file.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

constexpr std::size_t kMostShotPlots = 50;  // in a folder; each takes about half a second

struct RunOptions {
  ScenarioInput input;
  Outputs outputs;
  std::string folder, interval;
  bool with_jerk = false;  // flights only
  // Worlds only:
  std::optional<std::uint64_t> steps;
  std::optional<std::uint32_t> threads;
  std::string load, save, save_at;
};

Result<std::optional<double>> interval_of(const RunOptions& options) {
  if (options.interval.empty()) return std::optional<double>();
  const Result<double> interval = parse_quantity(options.interval, Quantity::time);
  if (!interval) return Error{interval.error().message, "--interval", interval.error().hint};
  if (!std::isfinite(*interval) || *interval <= 0)
    return Error{.message = "the interval must be a positive time", .place = "--interval", .hint = "as in \"10 ms\""};
  return std::optional<double>(*interval);
}

// A name as part of a file name.
std::string file_part(const std::string& name) {
  std::string out = name;
  for (char& c : out)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.') c = '_';
  return out;
}

/// Whether a scenario has what a format shows.
bool has_for(const Format& format, const Scenario& scenario) {
  return format.scenario_has == nullptr || format.scenario_has(scenario);
}

/// The formats that can show these flights, each with a file in the folder.
Outputs outputs_in_folder(const RunOptions& options, const FlownScenario& flown) {
  if (options.folder.empty()) return {};
  const std::string stem = file_part(std::filesystem::path(flown.scenario.file).stem().string());
  Outputs outputs = outputs_in(options.folder, stem, Subject::flights);
  for (const Format* format : outputs.asked())
    if (!has_for(*format, flown.scenario) || (format->check != nullptr && !format->check(flown)))
      outputs.forget(*format);
  return outputs;
}

/// Files in the folder for pictures of single shots, of the first ones where there are several.
std::vector<std::string> shot_plots(const std::string& folder, const FlownScenario& flown) {
  std::vector<std::string> paths;
  if (folder.empty() || flown.shots.size() == 1) return paths;
  const std::string stem = file_part(std::filesystem::path(flown.scenario.file).stem().string());
  std::set<std::string> names;
  for (std::size_t i = 0; i < std::min(flown.shots.size(), kMostShotPlots); ++i) {
    std::string name = stem + "_" + file_part(flown.shots[i].name);
    if (!names.insert(name).second) name += "_" + std::to_string(i + 1);
    paths.push_back((std::filesystem::path(folder) / (name + ".png")).string());
  }
  return paths;
}

Status draw_each(const std::vector<std::string>& paths, const FlownScenario& flown, bool with_jerk) {
  if (!paths.empty() && paths.size() < flown.shots.size())
    print_warning("only the first " + std::to_string(paths.size()) + " shots get their own plot");
  const Progress bar = progress_bar("drawing");
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Picture picture = shots_picture(title_of(flown.scenario), {&flown.shots[i], 1},
                                          flown.scene ? &*flown.scene : nullptr, flown.scenario.expect, with_jerk);
    if (Status status = draw(paths[i], picture); !status) return status;
    bar(i + 1, paths.size());
  }
  return {};
}

Status announce_all(const Outputs& in_folder, const std::vector<std::string>& plots) {
  Status status = announce(in_folder, "--out");
  for (std::size_t i = 0; i < plots.size() && status; ++i) status = announce(plots[i], "--out");
  return status;
}

Status write_all(const RunOptions& options, const FlownScenario& flown, std::optional<double> interval) {
  for (const Format* format : options.outputs.asked())
    if (Status status = format->check != nullptr ? format->check(flown) : Status(); !status)
      return Error{status.error().message, status.error().place, "--set " + status.error().hint};
  const Outputs in_folder = outputs_in_folder(options, flown);
  const std::vector<std::string> plots = shot_plots(options.folder, flown);
  if (Status status = announce_all(in_folder, plots); !status) return status;
  LogParts parts;
  for (const Outputs* each : {&options.outputs, &in_folder})
    for (const Format* format : each->asked()) parts.add(format->world_parts);
  const Result<SampleTimes> times = parts.samples ? sample_times(flown.shots, interval) : SampleTimes{};
  if (!times) return times.error();
  const Flights flights{flown, *times, options.with_jerk};
  const auto make = [&](const Format& format) { return content_of(format, flights); };
  if (!options.folder.empty()) {
    Status status =
        in_turn([&] { return make_folder(options.folder); }, [&] { return check(in_folder); },
                [&] { return write(in_folder, make); }, [&] { return draw_each(plots, flown, options.with_jerk); });
    if (!status) return status;
  }
  return write(options.outputs, make);
}

// Why a flight ended before its time, in words; empty where it did not.
std::string_view odd_end(Outcome outcome) {
  switch (outcome) {
    case Outcome::step_limit: return ", it took tolerance.max_steps steps";
    case Outcome::left_domain: return ", it went where a model does not hold";
    case Outcome::non_finite: return ", its numbers grew beyond all bounds";
    case Outcome::stalled: return ", its steps became too small to go on";
    case Outcome::landed:
    case Outcome::reached_range:
    case Outcome::event:
    case Outcome::time_limit:
    case Outcome::hit:
    case Outcome::refused: break;
  }
  return {};
}

/// How many shots ended before their time; a warning for each of the first.
std::size_t warn_of_odd_ends(const std::vector<FlownShot>& shots) {
  constexpr std::size_t kMostWarnings = 5;
  std::size_t count = 0;
  for (const FlownShot& shot : shots) {
    const Outcome outcome = shot.flight.outcome();
    const std::string_view reason = odd_end(outcome);
    if (reason.empty() || ++count > kMostWarnings) continue;
    print_warning("shot \"" + one_line(shot.name) + "\" ended early: " + std::string(name(outcome)) +
                  std::string(reason));
  }
  if (count > kMostWarnings) print_warning(std::to_string(count - kMostWarnings) + " more shots ended early");
  return count;
}

Result<int> run_flights(const RunOptions& options, Scenario scenario, std::optional<double> interval) {
  FlownScenario flown{.scenario = std::move(scenario), .shots = {}, .checks = {}};
  if (Status status = fly_all(flown, progress_bar("flying")); !status) return status.error();
  if (Status status = write_all(options, flown, interval); !status) return status.error();
  for (const std::string& note : flown.notes) print_warning(note);
  const std::size_t odd_ends = warn_of_odd_ends(flown.shots);
  const auto missed = std::ranges::count(flown.checks, false, &Check::met);
  const int code = missed > 0 || odd_ends > 0 ? kExitCheckMissed : kExitOk;
  if (!options.outputs.use_stdout()) return done(print(summary_text(flown, style_of(stdout))), code);
  if (missed > 0)
    print_warning(std::to_string(missed) + " of " + std::to_string(flown.checks.size()) + " checks were missed");
  return code;
}

void warn_of_refusals(const std::vector<WorldGroup>& groups) {
  for (const WorldGroup& group : groups)
    if (group.refused > 0 && !group.emitter)  // an emitter has a maximum, and its own table says what it refused
      print_warning(std::to_string(group.refused) + " launches of \"" + one_line(group.name) +
                    "\" were refused: " + group.refusal);
  for (const WorldGroup& group : groups)
    if (group.counts.cut > 0)
      print_warning(
          std::to_string(group.counts.cut) + (group.counts.cut == 1 ? " particle" : " particles") + " of \"" +
          one_line(group.name) +
          "\" could not be emitted: more than a million in a step, or sub-emitters without end; an emitter that "
          "fires by itself stops there");
}

/// Warns of rounds that left the air at the default lifetime, which the file does not give.
void warn_of_age(const WorldLog& log) {
  for (const ScenarioEmitter& emitter : log.scenario.emitters) {
    const bool is_unsaid = emitter.def.start.lifetime == ParticleStart{}.lifetime;
    if (!(emitter.def.gun.rounds_per_minute > 0) || !is_unsaid) continue;
    const auto group = std::ranges::find(log.groups, emitter.def.name, &WorldGroup::name);
    if (group == log.groups.end() || group->counts.aged == 0) continue;
    print_warning(std::to_string(group->counts.aged) + " rounds of \"" + one_line(group->name) +
                  "\" left the air at an age of " + significant(emitter.def.start.lifetime.value, 6) +
                  " s: that is emitter.start.lifetime where nothing is said");
  }
}

/// Warns of shots of a world that leave their drag curves. Rounds of emitters have speeds of their own.
void warn_of_curves(const Scenario& scenario) {
  for (const ScenarioShot& shot : scenario.shots)
    if (!emitter_alone_of(scenario, shot.projectile.name)) warn_of_curve(scenario, shot);
}

/// When a run is to be saved.
Status save_time(const RunOptions& options, const Scenario& scenario, LogOptions& into) {
  if (options.save_at.empty()) return {};
  if (options.save.empty()) return Error{"there is no file to save into", "--save-at", "name one with --save FILE"};
  const Result<double> at = parse_quantity(options.save_at, Quantity::time);
  if (!at) return Error{at.error().message, "--save-at", at.error().hint};
  const double end =
      options.steps ? static_cast<double>(*options.steps) * scenario.world.def.step : scenario.world.duration;
  if (!(*at >= 0 && *at <= end))
    return Error{"must lie within the run", "--save-at", "it takes " + significant(end, 6) + " s"};
  into.save_at = *at;
  return {};
}

/// What a crowd will need is told before it starts, not by running out of memory.
void warn_of_size(const Scenario& scenario) {
  constexpr std::int64_t kMany = 5'000'000, kBytesEach = 360;  // as measured, with default outputs
  std::int64_t launches = 0;
  for (const Volley& volley : scenario.volleys) launches += volley.count;
  if (launches >= kMany)
    print_warning(std::to_string(launches) + " launches will take about " +
                  significant(static_cast<double>(launches * kBytesEach) / 1e9, 2) +
                  " GB of memory if all are in the air at once");
}

/// The formats that have something to show of this world, each with a file in the folder.
Outputs world_outputs_in_folder(const RunOptions& options, const Scenario& scenario) {
  if (options.folder.empty()) return {};
  Outputs outputs = outputs_in(options.folder, std::filesystem::path(scenario.file).stem().string(), Subject::world);
  for (const Format* format : outputs.asked())
    if (!has_for(*format, scenario) || (format->check_world != nullptr && !format->check_world(scenario)))
      outputs.forget(*format);
  return outputs;
}

Result<int> run_world(const RunOptions& options, Scenario scenario, std::optional<double> interval) {
  if (options.threads) scenario.world.def.threading.threads = *options.threads;
  warn_of_size(scenario);
  for (const Format* format : options.outputs.asked())
    if (Status status = format->check_world != nullptr ? format->check_world(scenario) : Status(); !status)
      return Error{status.error().message, status.error().place, "--set " + status.error().hint};
  const Outputs in_folder = world_outputs_in_folder(options, scenario);
  if (Status status = announce(in_folder, "--out"); !status) return status.error();
  LogOptions log_options{.parts = {},
                         .interval = interval,
                         .steps = options.steps,
                         .record = options.outputs.record,
                         .load = options.load,
                         .save = options.save};
  if (Status status = save_time(options, scenario, log_options); !status) return status.error();
  for (const Outputs* each : {&options.outputs, &in_folder})
    for (const Format* format : each->asked()) log_options.parts.add(format->world_parts);
  const Result<WorldLog> log = report::run_world(scenario, log_options, progress_bar("stepping"));
  if (!log) return log.error();
  const auto make = [&](const Format& format) { return content_of(format, *log); };
  Status status = in_turn([&] { return options.folder.empty() ? Status() : make_folder(options.folder); },
                          [&] { return check(in_folder); }, [&] { return write(in_folder, make); },
                          [&] { return write(options.outputs, make); });
  if (!status) return status.error();
  for (const std::string& note : log->notes) print_warning(note);
  warn_of_refusals(log->groups);
  warn_of_age(*log);
  warn_of_curves(scenario);
  const int code = std::ranges::count(log->checks, false, &Check::met) > 0 ? kExitCheckMissed : kExitOk;
  if (!options.outputs.use_stdout()) return done(print(world_text(*log, style_of(stdout))), code);
  if (code != kExitOk) print_warning("checks were missed");
  return code;
}

void warn_of_triangles(const Scenario& scenario) {
  for (const ScenarioShape& shape : scenario.shapes)
    if (const std::size_t left_out = degenerate_triangles(shape); left_out > 0)
      print_warning(std::to_string(left_out) + " of " +
                    std::to_string(std::get<MeshShape>(shape.shape).triangles.size()) + " triangles of the shape \"" +
                    one_line(shape.name) + "\" have no area and are left out");
}

constexpr const char* kNoWorld = "the scenario has no [world]";
constexpr const char* kForWorlds = "it is for worlds only";

Result<int> run(const RunOptions& options) {
  if (Status status = check(options.outputs); !status) return status.error();
  if (!options.save.empty())
    if (Status status = check_writable(options.save); !status) return status.error();
  if (!options.folder.empty())
    if (Status status = check_gnuplot(); !status) return status.error();
  const auto interval = interval_of(options);
  if (!interval) return interval.error();
  Result<Scenario> scenario = load(options.input);
  if (!scenario) return scenario.error();
  warn_of_triangles(*scenario);
  const bool is_world = scenario->world.given;
  const Status fitting = is_world ? check_subject(options.outputs, Subject::world, "it is of single flights",
                                                  "take [world] out of the scenario")
                                  : check_subject(options.outputs, Subject::flights, kNoWorld, kForWorlds);
  if (!fitting) return fitting.error();
  if (is_world && options.with_jerk)
    return Error{.message = "it is of single flights", .place = "--jerk", .hint = "take [world] out of the scenario"};
  if (is_world) return run_world(options, std::move(*scenario), *interval);
  const std::string option = !options.outputs.record.empty() ? "--record"
                             : options.steps                 ? "--steps"
                             : options.threads               ? "--threads"
                             : !options.load.empty()         ? "--load"
                             : !options.save.empty()         ? "--save"
                             : !options.save_at.empty()      ? "--save-at"
                                                             : "";
  if (!option.empty()) return Error{.message = kNoWorld, .place = option, .hint = kForWorlds};
  return run_flights(options, std::move(*scenario), *interval);
}

}  // namespace

void add_run_command(Command& program) {
  Command command = program.add_command("run", "Fly the shots of a scenario, or run its world; print, write and plot");
  auto options = std::make_shared<RunOptions>();
  add_scenario_options(command, options->input);
  constexpr Subject kSubjects[] = {Subject::flights, Subject::world};
  add_output_options(command, options->outputs, "the trajectories", kSubjects);
  command.add_output("--out", options->folder, "DIR", "Write all of these into a directory, with a plot for each shot",
                     {.is_folder = true});
  command.add_option("--interval", options->interval, "TIME",
                     "Time between samples in files, as \"10 ms\"; without it 200 to 500 samples a shot");
  command.add_flag("--jerk", options->with_jerk, "Flights: add the jerk to samples and plots");
  command.add_output("--record", options->outputs.record, "FILE", "Worlds: record the run, for physim replay",
                     {.incomplete = kIncomplete});
  command.add_option("--steps", options->steps, "Worlds: take so many steps instead of world.duration")
      .type_name("N")
      .within(1u, 1'000'000'000u);
  command.add_output("--save", options->save, "FILE",
                     "Worlds: save the run, to go on with --load; both may name one file", {.replaces = kSavedRun});
  command.add_option("--save-at", options->save_at, "TIME", "Worlds: save at this time instead of at the end");
  command.add_option("--load", options->load, "FILE", "Worlds: go on with a run of this scenario that was saved");
  command.add_option("--threads", options->threads, "Worlds: instead of world.threads; results do not depend on it")
      .type_name("N")
      .within(0u, 1024u);
  command.footer(
      "Exit code 0; 1 where an [[expect]] of the scenario is missed or a shot ends before its time (non_finite, "
      "left_domain,\nstep_limit, stalled); 2 for bad input.\n\n"
      "Examples:\n"
      "  physim run scenarios/308_168gr_g7.toml\n"
      "  physim run scenarios/308_168gr_g7.toml --set shot.mass=\"175 gr\" --set shot.fidelity=game\n"
      "  physim run scenarios/308_168gr_g7.toml --interval \"1 ms\" --csv - | head\n"
      "  physim run scenarios/308_168gr_g7.toml --out out --plot out/308.svg\n"
      "  physim run scenarios/world_machine_gun.toml --plot out/gun.png --events out/gun.csv\n");
  command.action([options]() -> Result<int> {
    const Result<int> code = run(*options);
    if (code) return code;
    const std::string& place = code.error().place;
    const std::string option = place == "interval" ? "--interval" : place == "save_at" ? "--save-at" : place;
    return Error{code.error().message, option, code.error().hint};
  });
}

}  // namespace physim::cli
