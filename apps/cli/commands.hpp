// The commands of `physim`. Each add function adds a command to the program, with its options and with what it does
// when it is asked for. Each lives in the file of its name: run.cpp, compare.cpp, ...; max-range and danger-space in
// ranges.cpp.
#pragma once

namespace physim::cli {

class Command;

enum ExitCode : int { kExitOk = 0, kExitCheckMissed = 1, kExitBadInput = 2 };

// The pattern of all:
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

}  // namespace physim::cli
