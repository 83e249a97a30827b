// physim: the command line.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "commands.hpp"
#include "physim/flight.hpp"
#include "physim/version.hpp"
#include "scenario/suggest.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

constexpr const char* kExamples =
    "Exit codes: 0 all well, 1 a check missed, 2 bad input.\n"
    "Colours are used on a terminal only, and not where NO_COLOR is set.\n\n"
    "Examples:\n"
    "  physim run scenarios/308_168gr_g7.toml                            a range card\n"
    "  physim run scenarios/308_168gr_g7.toml --plot out/308.png         ... and a picture\n"
    "  physim compare scenarios/308_168gr_g7.toml --plot out/ladder.png  error over cost, rung by rung\n"
    "  physim aim scenarios/308_168gr_g7.toml --range \"700 m\"            elevation and azimuth of a hit\n"
    "  physim validate                                                   against published figures\n"
    "  physim list settings                                              everything that can be set\n"
    "\n`physim COMMAND --help` tells more.\n";

// What nobody expected: the first option among it, else the first word; empty where all was expected.
std::string unexpected(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  const auto option = std::ranges::find_if(words, [](const std::string& word) { return word.starts_with("-"); });
  return option != words.end() ? *option : words.empty() ? "" : words.front();
}

// "; did you mean "speed"?" for the nearest of the names, or nothing.
std::string guess(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string_view found = nearest(word, candidates);
  return found.empty() ? "" : "did you mean \"" + std::string(found) + "\"? ";
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// CLI11's message as one of ours: "error: unknown option "--plott"; did you mean "--plot"? see physim run --help".
Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::string words = "physim";
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    words += " " + command->get_name();
  }
  std::vector<std::string> subcommands;
  for (const CLI::App* each : command->get_subcommands([](const CLI::App*) { return true; }))
    subcommands.push_back(each->get_name());

  std::string message = error.what(), hint;
  if (const std::string word = unexpected(app); word.size() > 1 && word.front() == '-') {
    message = "unknown option " + in_quotes(word);
    hint = guess(word.substr(0, word.find('=')), options_of(*command));
  } else if (!word.empty() && !subcommands.empty()) {
    const std::string group = command == &app ? "" : command->get_name() + " ";
    message = "there is no command " + in_quotes(group + word);
    hint = guess(word, subcommands);
  } else if (!word.empty()) {
    message = "unexpected argument " + in_quotes(word);
  }
  if (message.size() > 1 && std::isupper(static_cast<unsigned char>(message[1])) == 0)
    message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  return {.message = message, .hint = hint + "see " + words + " --help"};
}

// The library takes its best kernel where PHYSIM_KERNEL names one that it does not know; who typed it wants to know.
Status check_kernel() {
  const char* wanted = std::getenv("PHYSIM_KERNEL");
  const std::vector<std::string> known = kernels();
  if (wanted == nullptr || *wanted == '\0' || std::ranges::count(known, wanted) > 0) return std::nullopt;
  std::string names;
  for (const std::string& kernel : known) names += (names.empty() ? "" : ", ") + kernel;
  return Error{.message = "unknown kernel " + in_quotes(wanted),
               .place = "PHYSIM_KERNEL",
               .hint = "this build has on this machine: " + names};
}

int run(int argc, char** argv) {
  if (const Status bad = check_kernel()) {
    print_error(*bad);
    return kExitBadInput;
  }
  CLI::App app("PhySim: projectile motion with dynamic accuracy, from arcade to check-case.", "physim");
  int exit_code = kExitOk;
  app.set_version_flag("--version", std::string("physim ") + kVersion);
  app.require_subcommand(1);
  app.footer(kExamples);
  app.get_formatter()->column_width(34);
  add_run_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_table_command(app, exit_code);
  add_aim_command(app, exit_code);
  add_max_range_command(app, exit_code);
  add_danger_space_command(app, exit_code);
  add_fit_command(app, exit_code);
  add_validate_command(app, exit_code);
  add_list_command(app, exit_code);
  add_replay_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    print_error(usage_error(app, error));
    return kExitBadInput;
  }
  return exit_code;
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
