#include "output_paths.hpp"

#include <CLI/CLI.hpp>

#include "output_file.hpp"

namespace physim::cli {

void add_output_options(CLI::App& command, OutputPaths& paths, const char* csv, const char* json, const char* plot) {
  command.add_option("--csv", paths.csv, csv)->type_name("FILE");
  command.add_option("--json", paths.json, json)->type_name("FILE");
  command.add_option("--plot", paths.plot, plot)->type_name("FILE.png|svg");
}

Status check(const OutputPaths& paths) {
  if (!paths.csv.empty() && paths.csv == paths.json)
    return Error{.message = "--csv and --json cannot both go to " + paths.csv};
  return in_turn([&] { return paths.csv.empty() ? std::nullopt : check_writable(paths.csv); },
                 [&] { return paths.json.empty() ? std::nullopt : check_writable(paths.json); },
                 [&] { return paths.plot.empty() ? std::nullopt : check_plot(paths.plot); });
}

Status write(const OutputPaths& paths, const OutputMakers& makers) {
  return in_turn([&] { return paths.plot.empty() ? std::nullopt : draw(paths.plot, makers.plot()); },
                 [&] { return paths.csv.empty() ? std::nullopt : write_output(paths.csv, makers.csv()); },
                 [&] { return paths.json.empty() ? std::nullopt : write_output(paths.json, makers.json()); });
}

}  // namespace physim::cli
