// physim: the command line.
#include <CLI/CLI.hpp>
#include <cctype>
#include <exception>
#include <string>

#include "commands.hpp"
#include "physim/version.hpp"
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
    "  physim validate                                                   against published figures\n"
    "  physim list settings                                              everything that can be set\n"
    "\n`physim COMMAND --help` tells more.\n";

// CLI11's message as one of ours: "error: the following argument was not expected: --foo; try physim run --help".
Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  std::string message = error.what();
  const auto is_word = [](const std::string& argument) { return !argument.empty() && argument.front() != '-'; };
  const std::vector<std::string> unknown = app.remaining();
  if (app.get_subcommands().empty() && !unknown.empty() && is_word(unknown.front()))
    message = "there is no command \"" + unknown.front() + "\"";
  if (message.size() > 1 && std::isupper(static_cast<unsigned char>(message[1])) == 0)
    message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  std::string help = "physim ";
  for (const CLI::App* command : app.get_subcommands()) help += command->get_name() + " ";
  return {.message = message, .hint = "see " + help + "--help"};
}

int run(int argc, char** argv) {
  CLI::App app("PhySim: projectile motion with dynamic accuracy, from arcade to check-case.", "physim");
  int exit_code = kExitOk;
  app.set_version_flag("--version", std::string("physim ") + kVersion);
  app.require_subcommand(1);
  app.footer(kExamples);
  app.get_formatter()->column_width(34);
  add_run_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_validate_command(app, exit_code);
  add_list_command(app, exit_code);
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
