// Recordings: every call that changed a world, to be made again. Replay: makes them, and compares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physim/world.hpp"

namespace physim {

inline constexpr char kRecordingMagic[8] = {'P', 'H', 'Y', 'S', 'I', 'M', 'R', '\n'};
/// The format of a recording's bytes; others are refused.
inline constexpr std::uint32_t kRecordingFormat = 13;

/// Keeps a recording in memory: world.record(record_into(bytes)). The bytes must outlive the recording.
[[nodiscard]] RecordSink record_into(std::vector<std::byte>& bytes);

/// Where a replay first did something else than the recording tells.
struct ReplayDifference {
  std::uint64_t step = 0;  ///< the step in which it was seen, from 1; of a call between steps: the last one before [-]
  double time = 0;         ///< of the replayed world [s]
  std::string call{};      ///< the call that was made, "advance" [-]
  std::string what{};      ///< one sentence [-]
  std::uint64_t recorded_hash = 0;  ///< where hashes differ [-]
  std::uint64_t replayed_hash = 0;  ///< where hashes differ [-]
  std::uint64_t place = 0;          ///< in the recording [bytes]
};

/// How far a replay is, and whether it agrees.
struct ReplayReport {
  std::string made_by{};       ///< version of the library that recorded [-]
  bool complete = false;       ///< the recording has its end; else it was cut [-]
  std::uint64_t bytes = 0;     ///< of the recording that are used: all, or up to where it was cut [bytes]
  std::uint64_t calls = 0;     ///< made [-]
  std::uint64_t steps = 0;     ///< taken, also those that restore() took back [-]
  std::uint64_t hashes = 0;    ///< compared, and equal [-]
  std::uint64_t restores = 0;  ///< made [-]
  std::uint64_t spawned = 0;   ///< projectiles handed out [-]
  std::optional<ReplayDifference> difference{};  ///< the first; the replay stops there [-]
};

/// Functions are those of the save that the recording begins with, or those of WorldDef::environment, then those that
/// came while it was recorded: of each call that gives an environment anew. What a HitFunction said is recorded.
using ReplayOptions = LoadOptions;

/// A recording played call by call, for those who look at the world in between.
class Replay {
 public:
  /// Checks all of the recording before anything is played. One that was cut, as by a crash, is played as far as it
  /// goes; one that is damaged, of another format, or lacks functions is refused. Errors name the byte.
  [[nodiscard]] static Result<Replay> open(std::vector<std::byte> recording, const ReplayOptions& options = {});
  Replay(Replay&&) noexcept;
  Replay& operator=(Replay&&) noexcept;
  ~Replay();

  /// Makes the next call; false at the end, and at the first difference.
  bool next();
  /// Makes calls up to and with the next one that took steps; false where there is none.
  bool next_frame();
  [[nodiscard]] const World& world() const;
  [[nodiscard]] const ReplayReport& report() const;
  /// The hash after every step of the last call, as far as the recording has them.
  [[nodiscard]] std::span<const std::uint64_t> hashes() const;

 private:
  struct Impl;
  explicit Replay(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Plays all of a recording.
[[nodiscard]] Result<ReplayReport> replay(std::span<const std::byte> recording, const ReplayOptions& options = {});

}  // namespace physim
