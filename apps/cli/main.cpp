// physim: the command line.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "command.hpp"
#include "libraries.hpp"
#include "physim/flight.hpp"
#include "physim/result.hpp"
#include "scenario/suggest.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

constexpr const char* kExamples =
    "Exit codes: 0 all well, 1 a check missed or a shot that ended before its time, 2 bad input.\n"
    "Colours are used on a terminal only, and not where NO_COLOR is set.\n\n"
    "Examples:\n"
    "  physim run scenarios/308_168gr_g7.toml                            a range card\n"
    "  physim run scenarios/308_168gr_g7.toml --plot out/308.png         ... and a picture\n"
    "  physim compare scenarios/308_168gr_g7.toml --plot out/ladder.png  error over cost, rung by rung\n"
    "  physim aim scenarios/308_168gr_g7.toml --range \"700 m\"            elevation and azimuth of a hit\n"
    "  physim validate                                                   against published figures\n"
    "  physim list settings                                              everything that can be set\n"
    "\n`physim COMMAND --help` tells more.\n";

// The library takes its best kernel where PHYSIM_KERNEL names one that it does not know; who typed it wants to know.
Status check_kernel() {
  const char* wanted = std::getenv("PHYSIM_KERNEL");
  const std::vector<std::string> known = kernels();
  if (wanted == nullptr || *wanted == '\0' || std::ranges::count(known, wanted) > 0) return {};
  std::string names;
  for (const std::string& kernel : known) names += (names.empty() ? "" : ", ") + kernel;
  return Error{.message = "unknown kernel " + in_quotes(wanted),
               .place = "PHYSIM_KERNEL",
               .hint = "this build has on this machine: " + names};
}

std::string version() { return std::string("physim ") + kVersion + "\n" + build_text(); }

void add_commands(Command& program) {
  add_run_command(program);
  add_compare_command(program);
  add_table_command(program);
  add_aim_command(program);
  add_max_range_command(program);
  add_danger_space_command(program);
  add_fit_command(program);
  add_study_command(program);
  add_suvat_command(program);
  add_validate_command(program);
  add_list_command(program);
  add_replay_command(program);
}

int run(int argc, char** argv) {
  if (const Status status = check_kernel(); !status) {
    print_error(status.error());
    return kExitBadInput;
  }
  return run_program({.name = "physim",
                      .doc = "PhySim: projectile motion with dynamic accuracy, from arcade to check-case.",
                      .version = version,
                      .footer = kExamples,
                      .add_commands = add_commands},
                     argc, argv);
}

}  // namespace
}  // namespace physim::cli

int main(int argc, char** argv) {
  try {
    return physim::cli::run(argc, argv);
  } catch (const std::exception& error) {
    physim::cli::print_error({.message = error.what()});
  } catch (...) {
    physim::cli::print_error({.message = "something unknown went wrong"});
  }
  return physim::cli::kExitBadInput;
}
