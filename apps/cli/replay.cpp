// physim replay: plays a recording of a world and compares hash by hash.
#include <memory>

#include "command.hpp"
#include "outputs.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct ReplayCommand {
  std::string file;
  Outputs outputs;
  std::optional<std::uint32_t> threads;
};

Result<int> play(const ReplayCommand& command) {
  if (Status status = check(command.outputs); !status) return status.error();
  const Result<ReplayLog> log = play_recording(command.file, {.threading = {.threads = command.threads.value_or(0)}});
  if (!log) return log.error();
  if (!log->report.complete)
    print_warning("the recording was cut at byte " + std::to_string(log->report.bytes) +
                  "; it was played as far as it goes");
  Status status = write(command.outputs, [&](const Format& format) { return content_of(format, *log); });
  if (status && !command.outputs.use_stdout()) status = print(replay_text(*log, style_of(stdout)));
  return done(status, log->report.difference ? kExitCheckMissed : kExitOk);
}

}  // namespace

void add_replay_command(Command& program) {
  Command command = program.add_command("replay", "Play a recording of a world and compare it step by step");
  auto options = std::make_shared<ReplayCommand>();
  command.add_option("FILE", options->file, "The recording").required();
  constexpr Subject kSubjects[] = {Subject::replay};
  add_output_options(command, options->outputs, "each call that took steps", kSubjects);
  command.add_option("--threads", options->threads, "Threads to use; 0: all that the machine has")
      .within(0, 1024)
      .type_name("N");
  command.footer(
      "Exit code 0 where the replay is equal; 1 where it differs; 2 for bad input.\n\n"
      "Examples:\n"
      "  physim replay game.rec\n"
      "  physim replay game.rec --csv - | tail -n 1\n"
      "  PHYSIM_KERNEL=base physim replay game.rec --threads 1\n");
  command.action([options] { return play(*options); });
}

}  // namespace physim::cli
