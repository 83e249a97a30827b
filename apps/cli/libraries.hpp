// What this build has beside the core: kernels, and optional libraries.
#pragma once

#include <string>

namespace physim::cli {

/// What `physim --version` prints below the version: the kernels of this machine, each optional library with what it
/// adds, and the command that gets the missing ones. Lines without a line break at the end.
[[nodiscard]] std::string build_text();

}  // namespace physim::cli
