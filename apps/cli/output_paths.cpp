#include "output_paths.hpp"

#include <array>
#include <filesystem>
#include <utility>

#include "command.hpp"
#include "output_file.hpp"

namespace physim::cli {
namespace {
namespace fs = std::filesystem;

// Do two paths lead to one file? A device may well be written to twice.
bool is_same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  if (a == "-" || b == "-") return a == b;
  std::error_code failure;
  const fs::path first = fs::weakly_canonical(fs::absolute(a), failure);
  if (failure || fs::is_character_file(first, failure)) return false;
  const fs::path second = fs::weakly_canonical(fs::absolute(b), failure);
  return first == second || fs::equivalent(first, second, failure);
}

}  // namespace

void add_output_options(Command& command, OutputPaths& paths, const char* csv, const char* json, const char* plot) {
  command.add_option("--csv", paths.csv, csv).type_name("FILE").refuse_empty();
  command.add_option("--json", paths.json, json).type_name("FILE").refuse_empty();
  command.add_option("--plot", paths.plot, plot).type_name("FILE.png|svg").refuse_empty();
}

void add_globe_options(Command& command, OutputPaths& paths) {
  command.add_option("--kml", paths.kml, "Write flights over a round Earth as KML; - as above")
      .type_name("FILE")
      .refuse_empty();
  command.add_option("--czml", paths.czml, "... as CZML, moving in time, for Cesium").type_name("FILE").refuse_empty();
  command.add_option("--geojson", paths.geojson, "... as GeoJSON").type_name("FILE").refuse_empty();
}

Status check(const OutputPaths& paths, const std::string& scenario_file) {
  const std::array<std::pair<const char*, const std::string&>, 8> all = {{{"--csv", paths.csv},
                                                                          {"--json", paths.json},
                                                                          {"--plot", paths.plot},
                                                                          {"--kml", paths.kml},
                                                                          {"--czml", paths.czml},
                                                                          {"--geojson", paths.geojson},
                                                                          {"--events", paths.events},
                                                                          {"--record", paths.record}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [option, path] = all[i];
    if (is_same_file(path, scenario_file))
      return Error{.message = "cannot write: it is the scenario itself", .place = path};
    for (std::size_t k = 0; k < i; ++k)
      if (is_same_file(path, all[k].second))
        return Error{.message = std::string(all[k].first) + " and " + option + " cannot both go to " + path};
  }
  for (const auto& [option, path] : all)
    if (const bool is_text = &path != &paths.plot; is_text && !path.empty())
      if (Status status = check_writable(path); !status) return status;
  return paths.plot.empty() ? Status() : check_plot(paths.plot);
}

Status write(const OutputPaths& paths, const OutputMakers& makers) {
  const auto text = [](const std::string& path, const std::function<std::string()>& make) {
    return path.empty() ? Status() : write_output(path, make());
  };
  return in_turn([&] { return paths.plot.empty() ? Status() : draw(paths.plot, makers.plot()); },
                 [&] { return text(paths.csv, makers.csv); }, [&] { return text(paths.json, makers.json); },
                 [&] { return text(paths.kml, makers.kml); }, [&] { return text(paths.czml, makers.czml); },
                 [&] { return text(paths.geojson, makers.geojson); },
                 [&] { return text(paths.events, makers.events); });
}

}  // namespace physim::cli
