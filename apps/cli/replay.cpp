// physim replay: plays a recording of a world and compares hash by hash.
#include <filesystem>
#include <memory>

#include "command.hpp"
#include "commands.hpp"
#include "output_answer.hpp"
#include "output_file.hpp"
#include "output_number.hpp"
#include "output_paths.hpp"
#include "output_table.hpp"
#include "physim/recording_file.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct ReplayCommand {
  std::string file;
  OutputPaths outputs;
  std::optional<std::uint32_t> threads;
};

std::string counted(std::uint64_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

Status check_outputs(const ReplayCommand& command) {
  for (const std::string& path : {command.outputs.csv, command.outputs.json}) {
    std::error_code ignored;
    if (!path.empty() && std::filesystem::equivalent(path, command.file, ignored))
      return Error{.message = "cannot write: it is the recording itself", .place = path};
  }
  return check(command.outputs, "");
}

Result<Replay> open(const ReplayCommand& command) {
  Result<std::vector<std::byte>> bytes = load_recording(command.file);
  if (!bytes) return bytes.error();
  ReplayOptions options;
  options.threading.threads = command.threads.value_or(0);
  Result<Replay> player = Replay::open(std::move(*bytes), options);
  if (player) return player;
  Error error = player.error();
  error.place = command.file + (error.place.empty() ? "" : ": " + error.place);
  return error;
}

/// One row for every call that took steps.
std::string csv_row(const Replay& player) {
  const World& world = player.world();
  const auto hashes = player.hashes();
  return std::to_string(player.report().steps) + ", " + shortest(world.time()) + ", " + std::to_string(world.size()) +
         ", " + std::to_string(world.events().size()) + ", " + (hashes.empty() ? "" : hex(hashes.back())) + "\n";
}

std::string text_of(const ReplayCommand& command, const Replay& player, const Style& style) {
  const ReplayReport& r = player.report();
  const std::string hashes = r.difference   ? std::to_string(r.hashes) + " equal, then a difference"
                             : r.hashes > 0 ? style.good("all " + std::to_string(r.hashes) + " equal")
                                            : "none recorded";
  std::string out = style.bold(one_line(command.file)) + "\n  recorded by  physim " + one_line(r.made_by) +
                    "\n  calls        " + std::to_string(r.calls) + "\n  steps        " + std::to_string(r.steps) +
                    ", to " + readable(player.world().time(), 5) + " s" +
                    (r.restores > 0 ? ", with " + counted(r.restores, "restore") : "") + "\n  projectiles  " +
                    std::to_string(r.spawned) + " spawned, " + std::to_string(player.world().size()) +
                    " at the end\n  hashes       " + hashes + "\n";
  if (!r.difference) return out;
  return out + "  " + style.bad("differs") + "      in step " + std::to_string(r.difference->step) + " at " +
         readable(r.difference->time, 5) + " s, in " + r.difference->call + "(): " + r.difference->what + "\n";
}

Status play(const ReplayCommand& command, bool& equal) {
  if (Status status = check_outputs(command); !status) return status;
  Result<Replay> opened = open(command);
  if (!opened) return opened.error();
  Replay& player = *opened;
  std::string csv = "step, time [s], projectiles, events, hash\n";
  while (player.next_frame()) csv += csv_row(player);
  equal = !player.report().difference;
  if (!player.report().complete)
    print_warning("the recording was cut at byte " + std::to_string(player.report().bytes) +
                  "; it was played as far as it goes");
  const OutputMakers makers{
      .csv = [&] { return csv; }, .json = [&] { return replay_json(command.file, player); }, .plot = nullptr};
  if (Status status = write(command.outputs, makers); !status) return status;
  if (command.outputs.use_stdout()) return {};
  return print(text_of(command, player, Style(stdout)));
}

int exit_code_of(const ReplayCommand& command) {
  bool equal = true;
  if (const Status status = play(command, equal); !status) {
    print_error(status.error());
    return kExitBadInput;
  }
  return equal ? kExitOk : kExitCheckMissed;
}

}  // namespace

void add_replay_command(Command& program) {
  Command command = program.add_command("replay", "Play a recording of a world and compare it step by step");
  auto options = std::make_shared<ReplayCommand>();
  command.add_option("FILE", options->file, "The recording").required();
  command
      .add_option("--csv", options->outputs.csv,
                  "Write a row for each call that took steps as CSV; - is the standard output")
      .type_name("FILE")
      .refuse_empty();
  command.add_option("--json", options->outputs.json, "Write what came out as JSON; - as above")
      .type_name("FILE")
      .refuse_empty();
  command.add_option("--threads", options->threads, "Threads to use; 0: all that the machine has")
      .within(0, 1024)
      .type_name("N");
  command.footer(
      "Exit code 0 where the replay is equal; 1 where it differs; 2 for bad input.\n\n"
      "Examples:\n"
      "  physim replay game.rec\n"
      "  physim replay game.rec --csv - | tail -n 1\n"
      "  PHYSIM_KERNEL=base physim replay game.rec --threads 1\n");
  command.action([options] { return exit_code_of(*options); });
}

}  // namespace physim::cli
