// The command line of simclient.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "physim/result.hpp"

namespace physim::client {

enum ExitCode : int { kExitOk = 0, kExitBadInput = 2 };

struct Options {
  std::string scenario;                // file; empty: the open range
  std::vector<std::string> overrides;  // "shot.mass=170 gr"
  std::string script;                  // actions, or @FILE with them
  int frames = 0;                      // then it leaves; 0: when the script is over, or never
  std::string screenshot;              // of the last frame
  std::string state;                   // file for the state after each frame
  int width = 1280, height = 720;      // [pixels]
  double scale = 0;                    // of letters and lines; 0: as the screen asks
  bool hidden = false;
  bool range = false;  // begins on the open range, without the gallery
};

/// What to run with; or the exit code to leave with at once, where help or a list was printed.
[[nodiscard]] std::variant<Options, int> parse_command_line(int argc, char** argv);

}  // namespace physim::client
