// A progress bar on stderr: only on a terminal, and only when the work takes longer than a second.
#pragma once

#include <string>

#include "physim/progress.hpp"

namespace physim::cli {

/// Draws how far the work has come, which is described in a word or two; the bar goes when the last copy of it does.
[[nodiscard]] Progress progress_bar(const std::string& label);

}  // namespace physim::cli
