// Commands and their options, which CLI11 reads. Its header takes seconds to compile: only command.cpp includes it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace physim::cli {

/// An option that was added to a command; each call says more about it.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(option) {}

  /// What help shows for the value.
  Option& type_name(const char* name);
  Option& required();
  /// Refuses an empty value, as from a shell variable that is not set.
  Option& refuse_empty();
  Option& one_of(const std::vector<std::string>& words);
  /// Takes whole numbers in this range; help calls them INT or UINT, as the limits are.
  Option& within(int low, int high);
  Option& within(unsigned low, unsigned high);
  /// A list grows by one value each time that the option is given: what comes behind the value is not of the list.
  Option& one_value_each();

 private:
  CLI::Option& option_;
};

/// A command, or the program itself. Values are stored where the references lead, before the action is called.
class Command {
 public:
  Command(CLI::App& app, int& exit_code) : app_(app), exit_code_(exit_code) {}

  Command add_command(const char* name, const char* doc);
  /// A name without dashes is that of an argument, which is known by its position.
  Option add_option(const char* name, std::string& value, const char* doc);
  Option add_option(const char* name, std::vector<std::string>& values, const char* doc);
  Option add_option(const char* name, std::optional<std::uint32_t>& value, const char* doc);
  Option add_option(const char* name, std::optional<std::uint64_t>& value, const char* doc);
  void add_flag(const char* name, bool& value, const char* doc);
  /// One of the commands below this one has to be given.
  void require_command();
  /// What help ends with.
  void footer(const char* text);
  /// What the command does; the exit code is what it gives.
  void action(std::function<int()> run);

 private:
  CLI::App& app_;
  int& exit_code_;
};

struct Program {
  const char* name;
  const char* doc;
  const char* version;
  const char* footer;
  void (*add_commands)(Command& program);
};

/// Reads the command line and calls the action that it asks for; prints help, or what is wrong. Gives the exit code.
int run_program(const Program& program, int argc, char** argv);

}  // namespace physim::cli
