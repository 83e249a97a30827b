// Recordings as files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "physim/recording.hpp"
#include "physim/result.hpp"

namespace physim {

/// Records a world into a file, as World::record() does. What there is goes to `path`.part before every step, so that
/// a program that dies leaves a recording of all that it did; stop_recording(), or the end of the world, completes it
/// and gives it its name. What stood there before is replaced only then.
[[nodiscard]] Status record_to_file(World& world, const std::string& path, const RecordOptions& options = {});

/// Writes a recording whole or not at all.
[[nodiscard]] Status save_recording(const std::string& path, std::span<const std::byte> recording);

/// The bytes of a file, for Replay::open(), which looks whether they are a recording.
[[nodiscard]] Result<std::vector<std::byte>> load_recording(const std::string& path);

}  // namespace physim
