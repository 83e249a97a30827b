// The commands of `physim`. Each add function declares its options on `app` and, when its command was asked for, runs
// it and stores the exit code. Each lives in the file of its name: run.cpp, compare.cpp, ...; max-range and
// danger-space in ranges.cpp.
#pragma once

namespace CLI {
class App;
}

namespace physim::cli {

enum ExitCode : int { kExitOk = 0, kExitCheckMissed = 1, kExitBadInput = 2 };

// The pattern of all:
//   auto* command = app.add_subcommand("run", "...");  auto options = std::make_shared<Options>();
//   command->add_option(...);  command->callback([options, &exit_code] { exit_code = run(*options); });
void add_run_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_validate_command(CLI::App& app, int& exit_code);
void add_list_command(CLI::App& app, int& exit_code);
void add_replay_command(CLI::App& app, int& exit_code);
void add_table_command(CLI::App& app, int& exit_code);
void add_aim_command(CLI::App& app, int& exit_code);
void add_max_range_command(CLI::App& app, int& exit_code);
void add_danger_space_command(CLI::App& app, int& exit_code);
void add_fit_command(CLI::App& app, int& exit_code);

}  // namespace physim::cli
