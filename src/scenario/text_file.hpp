// Files that are read whole; errors name every way in which that can fail. Where the files that are written lead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "physim/result.hpp"

namespace physim {

/// The text of a file of at most so many bytes; `kind` names what it should be: "scenario file".
[[nodiscard]] Result<std::string> read_text_file(const std::string& file, std::uintmax_t most_bytes,
                                                 const std::string& kind);
/// The bytes of such a file.
[[nodiscard]] Result<std::vector<std::byte>> read_bytes(const std::string& file, std::uintmax_t most_bytes,
                                                        const std::string& kind);

/// Where a path leads: the file itself behind symbolic links, so that a link is kept and its target replaced.
[[nodiscard]] std::string target_of(const std::string& path);
/// A device or a pipe is written to; it must never be replaced by a file.
[[nodiscard]] bool is_special(const std::string& path);

}  // namespace physim
