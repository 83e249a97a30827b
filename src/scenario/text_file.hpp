// Files of text: read whole, every way in which that can fail is named.
#pragma once

#include <cstdint>
#include <string>

#include "physim/result.hpp"

namespace physim {

/// The text of a file of at most so many bytes; `kind` names what it should be: "scenario file".
[[nodiscard]] Result<std::string> read_text_file(const std::string& file, std::uintmax_t most_bytes,
                                                 const std::string& kind);

}  // namespace physim
