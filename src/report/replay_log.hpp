// A recording of a world, played to its end: what came out of each call that took steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physim/world.hpp"
#include "report/picture.hpp"
#include "report/records.hpp"
#include "report/style.hpp"

namespace physim::report {

/// The world after a call that took steps.
struct ReplayFrame {
  std::uint64_t step = 0;
  double time = 0;  // [s]
  std::uint64_t projectiles = 0, events = 0;
  std::optional<std::uint64_t> hash;  // the last one compared; none before the first
};

struct ReplayLog {
  std::string file;
  ReplayReport report;
  std::vector<ReplayFrame> frames;
  std::uint64_t born = 0;         // fired by emitters
  double time = 0;                // at the end [s]
  std::uint64_t projectiles = 0;  // at the end
  std::uint64_t hash = 0;         // at the end
};

/// Plays the recording in a file.
[[nodiscard]] Result<ReplayLog> play_recording(const std::string& file, const ReplayOptions& options);

[[nodiscard]] std::string replay_text(const ReplayLog& log, const Style& style);
/// A row for each call that took steps.
[[nodiscard]] Records records_of(const ReplayLog& log);
[[nodiscard]] Content replay_json(const ReplayLog& log);

}  // namespace physim::report
