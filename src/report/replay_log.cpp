#include "report/replay_log.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "physim/result.hpp"
#include "physim/scenario.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

ReplayFrame frame_of(const Replay& player) {
  const World& world = player.world();
  const auto hashes = player.hashes();
  return {player.report().steps, world.time(), world.size(), world.events().size(),
          hashes.empty() ? std::nullopt : std::optional(hashes.back())};
}

std::string counted(std::uint64_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

}  // namespace

Result<ReplayLog> play_recording(const std::string& file, const ReplayOptions& options) {
  Result<std::vector<std::byte>> bytes = load_recording(file);
  if (!bytes) return bytes.error();
  Result<Replay> opened = Replay::open(std::move(*bytes), options);
  if (!opened) {
    Error error = opened.error();
    error.place = file + (error.place.empty() ? "" : ": " + error.place);
    return error;
  }
  Replay& player = *opened;
  ReplayLog log{.file = file};
  std::map<EmitterId, std::uint64_t> born;  // those of emitters that are gone, too
  while (player.next_frame()) {
    log.frames.push_back(frame_of(player));
    for (const EmitterId emitter : player.world().emitters())
      born[emitter] = player.world().emitter_counts(emitter).born;
  }
  for (const auto& [emitter, count] : born) log.born += count;
  log.report = player.report();
  PHYSIM_ASSERT(log.frames.empty() || log.frames.back().step <= log.report.steps);
  log.time = player.world().time();
  log.projectiles = player.world().size();
  log.hash = player.world().hash();
  return log;
}

std::string replay_text(const ReplayLog& log, const Style& style) {
  const ReplayReport& r = log.report;
  const std::string hashes = r.difference   ? std::to_string(r.hashes) + " equal, then a difference"
                             : r.hashes > 0 ? style.good("all " + std::to_string(r.hashes) + " equal")
                                            : "none recorded";
  std::string out = style.bold(one_line(log.file)) + "\n  recorded by  physim " + one_line(r.made_by) +
                    "\n  calls        " + std::to_string(r.calls) + "\n  steps        " + std::to_string(r.steps) +
                    ", to " + readable(log.time, 5) + " s" +
                    (r.restores > 0 ? ", with " + counted(r.restores, "restore") : "") + "\n  projectiles  " +
                    std::to_string(r.spawned + log.born) + " spawned, " +
                    (log.born > 0 ? std::to_string(log.born) + " of them by emitters, " : "") +
                    std::to_string(log.projectiles) + " at the end\n  hashes       " + hashes + "\n";
  if (!r.difference) return out;
  return out + "  " + style.bad("differs") + "      in step " + std::to_string(r.difference->step) + " at " +
         readable(r.difference->time, 5) + " s, in " + r.difference->call + "(): " + r.difference->what + "\n";
}

Records records_of(const ReplayLog& log) {
  const auto rows = [&log](const auto& take) {
    for (const ReplayFrame& frame : log.frames) {
      const std::string hash = frame.hash ? hex(*frame.hash) : "";
      const Cell row[] = {frame.step, frame.time, frame.projectiles, frame.events, hash};
      take(row);
    }
  };
  return {{"step", "time [s]", "projectiles", "events", "hash"}, rows};
}

Content replay_json(const ReplayLog& log) {
  const ReplayReport& r = log.report;
  nlohmann::ordered_json out = {{"version", kVersion},
                                {"recording", log.file},
                                {"made_by", r.made_by},
                                {"complete", r.complete},
                                {"bytes", r.bytes},
                                {"calls", r.calls},
                                {"steps", r.steps},
                                {"hashes", r.hashes},
                                {"restores", r.restores},
                                {"time [s]", log.time},
                                {"spawned", r.spawned + log.born},
                                {"born", log.born},
                                {"projectiles", log.projectiles},
                                {"hash", hex(log.hash)},
                                {"equal", !r.difference},
                                {"difference", nullptr}};
  if (r.difference)
    out["difference"] = {{"step", r.difference->step},
                         {"time [s]", r.difference->time},
                         {"call", r.difference->call},
                         {"what", r.difference->what},
                         {"recorded", hex(r.difference->recorded_hash)},
                         {"replayed", hex(r.difference->replayed_hash)},
                         {"byte", r.difference->place}};
  return as_text(json_text(out));
}

}  // namespace physim::report
