// The files that `run` and `compare` are asked to write.
#pragma once

#include <functional>
#include <string>

#include "physim/result.hpp"
#include "plot.hpp"

namespace physim::cli {

class Command;

/// Empty: not asked for. "-" is the standard output.
struct OutputPaths {
  std::string csv, json, plot;
  std::string kml, czml, geojson;  // for globes; of `run`
  std::string events, record;      // of worlds
  [[nodiscard]] bool use_stdout() const {
    return csv == "-" || json == "-" || kml == "-" || czml == "-" || geojson == "-" || events == "-";
  }
  [[nodiscard]] bool has_globe() const { return !kml.empty() || !czml.empty() || !geojson.empty(); }
};

/// What goes into the files; made only when asked for.
struct OutputMakers {
  std::function<std::string()> csv, json;
  std::function<Picture()> plot;
  std::function<std::string()> kml = {}, czml = {}, geojson = {}, events = {};
};

/// --csv, --json and --plot, each with its help.
void add_output_options(Command& command, OutputPaths& paths, const char* csv, const char* json, const char* plot);

/// --kml, --czml and --geojson.
void add_globe_options(Command& command, OutputPaths& paths);

/// What can be told before there is anything to write: places that cannot be written, the same place asked for twice,
/// and the scenario itself.
[[nodiscard]] Status check(const OutputPaths& paths, const std::string& scenario_file);

[[nodiscard]] Status write(const OutputPaths& paths, const OutputMakers& makers);

}  // namespace physim::cli
