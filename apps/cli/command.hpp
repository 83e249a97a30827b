// Commands and their options, which CLI11 reads. Its header takes seconds to compile: only command.cpp includes it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physim/result.hpp"

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
  Option& one_of(const std::vector<std::string>& words);
  /// Takes whole numbers in this range; help calls them INT or UINT, as the limits are.
  Option& within(int low, int high);
  Option& within(unsigned low, unsigned high);
  /// A list grows by one value each time that the option is given: what comes behind the value is not of the list.
  Option& one_value_each();

 private:
  CLI::Option& option_;
};

/// Properties of an output option that differ from those of a plain result file.
struct OutputKind {
  const char* replaces = "";    ///< the kind of input that it may replace, as of a run that is gone on with
  const char* incomplete = "";  ///< ending of its name until it is complete
  bool is_folder = false;       ///< a directory that files are written into
};

/// A command, or the program itself. Values are stored where the references lead, before the action is called.
class Command {
 public:
  Command(CLI::App& app, int& exit_code);

  Command add_command(const char* name, const char* doc);
  /// A name without dashes is that of an argument, which is known by its position.
  Option add_option(const char* name, std::string& value, const char* doc);
  Option add_option(const char* name, std::vector<std::string>& values, const char* doc);
  /// With what help shows for the value; refuses an empty one, as from a shell variable that is not set.
  Option add_option(const char* name, std::string& value, const char* type, const char* doc);
  Option add_option(const char* name, std::vector<std::string>& values, const char* type, const char* doc);
  /// A file that the command writes; `type` begins with FILE or DIR. Before the action is called, a directory in its
  /// place is refused, and a file that another output option names. From then on each file that is read is compared
  /// with it: the reader refuses what would be replaced.
  Option add_output(const char* name, std::string& path, const char* type, const char* doc,
                    const OutputKind& kind = {});
  Option add_option(const char* name, std::optional<std::uint32_t>& value, const char* doc);
  Option add_option(const char* name, std::optional<std::uint64_t>& value, const char* doc);
  void add_flag(const char* name, bool& value, const char* doc);
  /// One of the commands below this one has to be given.
  void require_command();
  /// What help ends with.
  void footer(const char* text);
  /// What the command does; it gives the exit code, or an error, which is printed.
  void action(std::function<Result<int>()> run);

 private:
  struct Outputs;

  CLI::App& app_;
  int& exit_code_;
  std::shared_ptr<Outputs> outputs_;
};

enum ExitCode : int { kExitOk = 0, kExitCheckMissed = 1, kExitBadInput = 2 };

struct Program {
  const char* name;
  const char* doc;
  std::string (*version)();  // called if it is asked for
  const char* footer;
  void (*add_commands)(Command& program);
};

/// The exit code of a command whose last step succeeded.
[[nodiscard]] Result<int> done(const Status& last, int code = kExitOk);

/// Reads the command line and calls the action that it asks for; prints help, or what is wrong. Gives the exit code.
int run_program(const Program& program, int argc, char** argv);

// The commands of `physim`. Each function adds a command to the program, with its options and with what it does when it
// is asked for. Each lives in the file of its name: run.cpp, compare.cpp, ...; max-range and danger-space in
// ranges.cpp. The pattern of all:
//   Command command = program.add_command("run", "...");  auto options = std::make_shared<Options>();
//   command.add_option(...);  command.action([options] { return run(*options); });
void add_run_command(Command& program);
void add_compare_command(Command& program);
void add_validate_command(Command& program);
void add_list_command(Command& program);
void add_replay_command(Command& program);
void add_table_command(Command& program);
void add_aim_command(Command& program);
void add_max_range_command(Command& program);
void add_danger_space_command(Command& program);
void add_fit_command(Command& program);
void add_study_command(Command& program);
void add_suvat_command(Command& program);

}  // namespace physim::cli
