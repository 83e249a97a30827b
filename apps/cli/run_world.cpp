#include "run_world.hpp"

#include <algorithm>
#include <filesystem>

#include "command.hpp"
#include "progress.hpp"
#include "report/file.hpp"
#include "report/table.hpp"
#include "report/world.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

void warn_of_refusals(const std::vector<WorldGroup>& groups) {
  for (const WorldGroup& group : groups)
    if (group.refused > 0)
      print_warning(std::to_string(group.refused) + " launches of \"" + one_line(group.name) +
                    "\" were refused: " + group.refusal);
}

}  // namespace

std::string WorldOptions::given() const { return steps ? "--steps" : threads ? "--threads" : ""; }

void add_world_options(Command& command, WorldOptions& options, Outputs& outputs) {
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

Status run_in_world(Scenario scenario, const Outputs& outputs, const std::string& folder,
                    std::optional<double> interval, const WorldOptions& options, bool& all_met) {
  if (options.threads) scenario.world.def.threading.threads = *options.threads;
  const std::string stem = std::filesystem::path(scenario.file).stem().string();
  const Outputs in_folder = folder.empty() ? Outputs{} : outputs_in(folder, stem, Subject::world);
  LogOptions log_options{.parts = {}, .interval = interval, .steps = options.steps, .record = outputs.record};
  for (const Outputs* each : {&outputs, &in_folder})
    for (const Format* format : each->asked()) log_options.parts.add(format->world_parts);
  const Result<WorldLog> log = run_world(scenario, log_options, progress_bar("stepping"));
  if (!log) return log.error();
  all_met = std::ranges::all_of(log->checks, [](const Check& check) { return check.met; });
  const auto make = [&](const Format& format) { return content_of(format, *log); };
  Status status = in_turn([&] { return folder.empty() ? Status() : make_folder(folder); },
                          [&] { return check(in_folder, "the scenario", scenario.file); },
                          [&] { return write(in_folder, make); }, [&] { return write(outputs, make); });
  if (!status) return status;
  warn_of_refusals(log->groups);
  if (!outputs.use_stdout()) return print(world_text(*log, style_of(stdout)));
  if (!all_met) print_warning("checks were missed");
  return {};
}

}  // namespace physim::cli
