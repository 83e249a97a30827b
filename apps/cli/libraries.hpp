// Kernels and optional libraries of this build.
#pragma once

#include <string>

namespace physim::cli {

/// Returns the lines that `physim --version` prints below the version: the kernels of this machine, each optional
/// library with the feature that it adds, and the command that installs the missing ones. The last line has no line
/// break.
[[nodiscard]] std::string build_text();

}  // namespace physim::cli
