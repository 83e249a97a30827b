#include "output_paths.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <utility>

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

void refuse_empty(CLI::Option& option) {
  option.check([](const std::string& value) { return std::string(value.empty() ? "the value is empty" : ""); });
}

void add_output_options(CLI::App& command, OutputPaths& paths, const char* csv, const char* json, const char* plot) {
  refuse_empty(*command.add_option("--csv", paths.csv, csv)->type_name("FILE"));
  refuse_empty(*command.add_option("--json", paths.json, json)->type_name("FILE"));
  refuse_empty(*command.add_option("--plot", paths.plot, plot)->type_name("FILE.png|svg"));
}

Status check(const OutputPaths& paths, const std::string& scenario_file) {
  const std::array<std::pair<const char*, const std::string&>, 4> all = {
      {{"--csv", paths.csv}, {"--json", paths.json}, {"--plot", paths.plot}, {"--events", paths.events}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [option, path] = all[i];
    if (is_same_file(path, scenario_file))
      return Error{.message = "cannot write: it is the scenario itself", .place = path};
    for (std::size_t k = 0; k < i; ++k)
      if (is_same_file(path, all[k].second))
        return Error{.message = std::string(all[k].first) + " and " + option + " cannot both go to " + path};
  }
  return in_turn([&] { return paths.csv.empty() ? std::nullopt : check_writable(paths.csv); },
                 [&] { return paths.json.empty() ? std::nullopt : check_writable(paths.json); },
                 [&] { return paths.events.empty() ? std::nullopt : check_writable(paths.events); },
                 [&] { return paths.plot.empty() ? std::nullopt : check_plot(paths.plot); });
}

Status write(const OutputPaths& paths, const OutputMakers& makers) {
  return in_turn([&] { return paths.plot.empty() ? std::nullopt : draw(paths.plot, makers.plot()); },
                 [&] { return paths.csv.empty() ? std::nullopt : write_output(paths.csv, makers.csv()); },
                 [&] { return paths.json.empty() ? std::nullopt : write_output(paths.json, makers.json()); },
                 [&] { return paths.events.empty() ? std::nullopt : write_output(paths.events, makers.events()); });
}

}  // namespace physim::cli
