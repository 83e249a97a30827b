#include "run_world.hpp"

#include <algorithm>
#include <filesystem>

#include "command.hpp"
#include "output_file.hpp"
#include "output_table.hpp"
#include "output_world.hpp"
#include "plot_world.hpp"

namespace physim::cli {
namespace {

OutputMakers makers_of(const WorldLog& log) {
  return {.csv = [&] { return world_csv(log); },
          .json = [&] { return world_json(log); },
          .plot = [&] { return world_picture(log); },
          .events = [&] { return world_events_csv(log); }};
}

Status write_folder(const std::string& folder, const WorldLog& log) {
  const std::string stem = std::filesystem::path(log.scenario.file).stem().string();
  const auto path = [&](const char* ending) { return (std::filesystem::path(folder) / (stem + ending)).string(); };
  const OutputPaths paths{
      .csv = path(".csv"), .json = path(".json"), .plot = path(".png"), .events = path("_events.csv")};
  return in_turn([&] { return make_folder(folder); }, [&] { return check(paths, log.scenario.file); },
                 [&] { return write(paths, makers_of(log)); });
}

void warn_of_refusals(const std::vector<WorldGroup>& groups) {
  for (const WorldGroup& group : groups)
    if (group.refused > 0)
      print_warning(std::to_string(group.refused) + " launches of \"" + one_line(group.name) +
                    "\" were refused: " + group.refusal);
}

}  // namespace

std::string WorldOptions::given(const OutputPaths& outputs) const {
  if (steps) return "--steps";
  if (threads) return "--threads";
  if (!outputs.record.empty()) return "--record";
  return outputs.events.empty() ? "" : "--events";
}

void add_world_options(Command& command, WorldOptions& options, OutputPaths& outputs) {
  command.add_option("--events", outputs.events, "Worlds: write what happened as CSV; - as above")
      .type_name("FILE")
      .refuse_empty();
  command.add_option("--record", outputs.record, "Worlds: record the run, for physim replay")
      .type_name("FILE")
      .refuse_empty();
  command.add_option("--steps", options.steps, "Worlds: take so many steps instead of world.duration")
      .type_name("N")
      .within(1u, 1'000'000'000u);
  command.add_option("--threads", options.threads, "Worlds: instead of world.threads; results do not depend on it")
      .type_name("N")
      .within(0u, 1024u);
}

Status run_in_world(Scenario scenario, const OutputPaths& outputs, const std::string& folder,
                    std::optional<double> interval, const WorldOptions& options, bool& all_met) {
  if (options.threads) scenario.world.def.threading.threads = *options.threads;
  const bool all = !folder.empty();
  const LogWishes wishes{.samples = all || !outputs.csv.empty() || !outputs.json.empty(),
                         .events = all || !outputs.events.empty() || !outputs.json.empty(),
                         .paths = all || !outputs.plot.empty(),
                         .interval = interval,
                         .steps = options.steps,
                         .record = outputs.record};
  const Result<WorldLog> log = run_world(scenario, wishes);
  if (!log) return log.error();
  all_met = std::ranges::all_of(log->checks, [](const Check& check) { return check.met; });
  Status status = in_turn([&] { return all ? write_folder(folder, *log) : Status(); },
                          [&] { return write(outputs, makers_of(*log)); });
  if (!status) return status;
  warn_of_refusals(log->groups);
  if (!outputs.use_stdout()) return print(world_text(*log, Style(stdout)));
  if (!all_met) print_warning("checks were missed");
  return {};
}

}  // namespace physim::cli
