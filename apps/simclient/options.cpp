#include "simclient/options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "physim/result.hpp"
#include "simclient/core/actions.hpp"

namespace physim::client {
namespace {

constexpr const char* kFooter =
    "Exit codes: 0 all well, 2 bad input or no display.\n\n"
    "Examples:\n"
    "  simclient                                                     the gallery of scenarios\n"
    "  simclient scenarios/308_168gr_g7.toml                         the shots of a scenario\n"
    "  simclient --hidden --script \"fire; wait 60\" --screenshot a.png  without a person\n"
    "\nWhere there is no screen: xvfb-run -a simclient --hidden ...\n";

std::string parse_size(const std::string& text, Options& options) {
  int width = 0, height = 0, used = 0;
  const bool good = std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) == 2 &&
                    used == static_cast<int>(text.size()) && width >= 320 && height >= 240 && width <= 8192 &&
                    height <= 8192;
  if (!good) return "a size is WIDTHxHEIGHT with 320x240 to 8192x8192 pixels, such as 1280x720";
  options.width = width, options.height = height;
  return "";
}

}  // namespace

std::variant<Options, int> parse_command_line(int argc, char** argv) {
  Options o;
  std::string size;
  bool lists_actions = false;
  CLI::App app("SimClient: fires projectiles, and shows how they fly.", "simclient");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("simclient ") + kVersion);
  app.add_option("--scenario,scenario", o.scenario, "scenario (.toml) or recording (.rec) to open");
  app.add_option("--set", o.overrides, "PATH=VALUE: changes a setting of the scenario")->type_name("PATH=VALUE");
  app.add_option("--script", o.script, "actions parted by \";\", or @FILE with them")->type_name("ACTIONS");
  app.add_option("--frames", o.frames, "leaves after so many frames")->check(CLI::Range(1, 100'000'000));
  app.add_option("--screenshot", o.screenshot, "writes a picture of the last frame")->type_name("OUT.png");
  app.add_option("--state", o.state, "writes the state after each frame, a line of JSON each")->type_name("OUT.jsonl");
  app.add_option("--size", size, "of the window in pixels")->type_name("WIDTHxHEIGHT");
  app.add_option("--scale", o.scale, "of letters and lines; 2 for fine screens")->check(CLI::Range(0.5, 4.0));
  app.add_flag("--hidden", o.hidden, "shows no window; every frame is 1/60 s of simulation");
  app.add_flag("--range", o.range, "begins on the open range, without the gallery");
  app.add_flag("--list-actions", lists_actions, "prints all actions and keys");
  try {
    app.parse(argc, argv);
    if (const std::string bad = size.empty() ? "" : parse_size(size, o); !bad.empty())
      throw CLI::ValidationError("--size", bad);
  } catch (const CLI::ParseError& error) {
    const int exit_code = error.get_exit_code() == 0 ? app.exit(error) : kExitBadInput;
    if (exit_code != 0) std::fprintf(stderr, "error: %s; see simclient --help\n", error.what());
    return exit_code;
  }
  if (!lists_actions) return o;
  std::fputs(actions_table().c_str(), stdout);
  return kExitOk;
}

}  // namespace physim::client
