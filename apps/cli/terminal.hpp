// What a person at a terminal sees: colour, where the stream is a terminal and NO_COLOR is not set, error messages, and
// a progress bar.
#pragma once

#include <cstdio>
#include <string_view>

#include "physim/result.hpp"
#include "report/style.hpp"
#include "report/text.hpp"

namespace physim::cli {

/// True if this process is a rank of a job: Open MPI's mpirun and Slurm's srun (PMIx, PMI-2) set variables of the
/// environment.
[[nodiscard]] bool job_is_there();
/// True if the stream is a terminal of a person: a launcher gives its ranks a terminal and collects their text.
[[nodiscard]] bool is_terminal(std::FILE* stream);

/// Colours for one stream; none where it is no terminal, NO_COLOR is set or TERM is "dumb".
[[nodiscard]] report::Style style_of(std::FILE* stream);

/// "place: error: message; hint" to stderr.
void print_error(const Error& error);
/// "warning: text" to stderr.
void print_warning(std::string_view text);
/// Writes to stdout and flushes; an error where that fails, as on a full disk.
[[nodiscard]] Status print(const report::Text& text);
[[nodiscard]] Status print(std::string_view text);

/// Draws on stderr how far the work has come, which is described in a word or two: only on a terminal, and only when it
/// takes longer than a second. The bar goes when the last copy of it does.
[[nodiscard]] Progress progress_bar(const std::string& label);

}  // namespace physim::cli
