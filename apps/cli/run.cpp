// physim run: flies the shots of a scenario, prints them, writes them, and checks its [[expect]] blocks.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "command.hpp"
#include "commands.hpp"
#include "flown.hpp"
#include "output_file.hpp"
#include "output_globe.hpp"
#include "output_paths.hpp"
#include "output_summary.hpp"
#include "output_table.hpp"
#include "output_trajectory.hpp"
#include "physim/names.hpp"
#include "plot_flights.hpp"
#include "progress.hpp"
#include "run_world.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

constexpr std::size_t kMostShotPlots = 50;  // in a folder; each takes about half a second

struct RunOptions {
  ScenarioInput input;
  OutputPaths outputs;
  WorldOptions world;
  std::string folder, interval;
};

Result<std::optional<double>> interval_of(const RunOptions& options) {
  if (options.interval.empty()) return std::optional<double>();
  const Result<double> interval = parse_quantity(options.interval, Quantity::time);
  if (!interval) {
    Error error = interval.error();
    error.place = "--interval";
    return error;
  }
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

OutputMakers makers_of(const FlownScenario& flown, const SampleTimes& times) {
  return {.csv = [&] { return trajectories_csv(flown.shots, times); },
          .json = [&] { return trajectories_json(flown, times); },
          .plot = [&] { return flights_picture(title_of(flown.scenario), flown.shots); },
          .kml = [&] { return globe_kml(flown, times); },
          .czml = [&] { return globe_czml(flown, times); },
          .geojson = [&] { return globe_geojson(flown, times); }};
}

Status write_folder(const RunOptions& options, const FlownScenario& flown, const SampleTimes& times) {
  const std::filesystem::path folder = options.folder;
  const std::string stem = file_part(std::filesystem::path(flown.scenario.file).stem().string());
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  const OutputPaths paths{.csv = path(stem + ".csv"), .json = path(stem + ".json"), .plot = path(stem + ".png")};
  Status status = in_turn([&] { return make_folder(options.folder); }, [&] { return check(paths, options.input.file); },
                          [&] { return write(paths, makers_of(flown, times)); });
  if (!status || flown.shots.size() == 1) return status;
  const std::size_t count = std::min(flown.shots.size(), kMostShotPlots);
  if (count < flown.shots.size())
    print_warning("only the first " + std::to_string(count) + " shots get their own plot");
  Progress progress("drawing", count);
  std::set<std::string> names;
  for (std::size_t i = 0; i < count && status; ++i) {
    std::string name = stem + "_" + file_part(flown.shots[i].name);
    if (!names.insert(name).second) name += "_" + std::to_string(i + 1);
    status = draw(path(name + ".png"), flights_picture(title_of(flown.scenario), {&flown.shots[i], 1}));
    progress.advance();
  }
  return status;
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
    case Outcome::refused: break;
  }
  return {};
}

void warn_of_odd_ends(const std::vector<FlownShot>& shots) {
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
}

void warn_of_missed(const std::vector<Check>& checks) {
  const auto missed = std::ranges::count_if(checks, [](const Check& check) { return !check.met; });
  if (missed > 0)
    print_warning(std::to_string(missed) + " of " + std::to_string(checks.size()) + " checks were missed");
}

// Everything but the exit code of the checks.
Status run(const RunOptions& options, FlownScenario& flown, bool& all_met) {
  if (Status status = check(options.outputs, options.input.file); !status) return status;
  if (!options.folder.empty())
    if (Status status = check_gnuplot(); !status) return status;
  const auto interval = interval_of(options);
  if (!interval) return interval.error();
  Result<Scenario> scenario = load_scenario(options.input.file, options.input.overrides);
  if (!scenario) return scenario.error();
  if (scenario->world.given && options.outputs.has_globe())
    return Error{.message = "KML, CZML and GeoJSON are of single flights", .hint = "take [world] out of the scenario"};
  if (scenario->world.given)
    return run_in_world(std::move(*scenario), options.outputs, options.folder, *interval, options.world, all_met);
  if (const std::string option = options.world.given(options.outputs); !option.empty())
    return Error{.message = "the scenario has no [world]", .place = option, .hint = "it is for worlds only"};
  flown.scenario = std::move(*scenario);
  if (Status status = fly_all(flown); !status) return status;
  all_met = std::ranges::all_of(flown.checks, [](const Check& check) { return check.met; });

  if (options.outputs.has_globe())
    if (Status status = check_round(flown); !status) return status;
  const bool writes_samples = !options.outputs.csv.empty() || !options.outputs.json.empty() ||
                              options.outputs.has_globe() || !options.folder.empty();
  SampleTimes times;
  if (writes_samples) {
    Result<SampleTimes> found = sample_times(flown.shots, *interval);
    if (!found) return found.error();
    times = std::move(*found);
  }
  Status status = in_turn([&] { return options.folder.empty() ? Status() : write_folder(options, flown, times); },
                          [&] { return write(options.outputs, makers_of(flown, times)); });
  if (!status) return status;
  warn_of_odd_ends(flown.shots);
  if (options.outputs.use_stdout()) {
    warn_of_missed(flown.checks);
    return {};
  }
  return print(summary_text(flown, Style(stdout)));
}

int exit_code_of(const RunOptions& options) {
  FlownScenario flown;
  bool all_met = true;
  if (const Status status = run(options, flown, all_met); !status) {
    print_error(status.error());
    return kExitBadInput;
  }
  return all_met ? kExitOk : kExitCheckMissed;
}

}  // namespace

void add_run_command(Command& program) {
  Command command = program.add_command("run", "Fly the shots of a scenario, or run its world; print, write and plot");
  auto options = std::make_shared<RunOptions>();
  add_scenario_options(command, options->input);
  add_output_options(command, options->outputs, "Write the trajectories as CSV; - is the standard output",
                     "Write trajectories, events and all settings as JSON; - as above",
                     "Draw path, speed, and each axis over time");
  add_globe_options(command, options->outputs);
  command.add_option("--out", options->folder, "Write all of these into a directory, with a plot for each shot")
      .type_name("DIR")
      .refuse_empty();
  command
      .add_option("--interval", options->interval,
                  "Time between samples in files, as \"10 ms\"; without it 200 to 500 samples a shot")
      .type_name("TIME")
      .refuse_empty();
  add_world_options(command, options->world, options->outputs);
  command.footer(
      "Exit code 0; 1 where an [[expect]] of the scenario is missed; 2 for bad input.\n\n"
      "Examples:\n"
      "  physim run scenarios/308_168gr_g7.toml\n"
      "  physim run scenarios/308_168gr_g7.toml --set shot.mass=\"175 gr\" --set shot.fidelity=game\n"
      "  physim run scenarios/308_168gr_g7.toml --interval \"1 ms\" --csv - | head\n"
      "  physim run scenarios/308_168gr_g7.toml --out out --plot out/308.svg\n"
      "  physim run scenarios/world_machine_gun.toml --plot out/gun.png --events out/gun.csv\n");
  command.action([options] { return exit_code_of(*options); });
}

}  // namespace physim::cli
