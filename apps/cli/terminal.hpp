// What a person at a terminal sees: colour, where the stream is a terminal and NO_COLOR is not set, and error messages.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "physim/result.hpp"
#include "report/style.hpp"

namespace physim::cli {

[[nodiscard]] bool is_terminal(std::FILE* stream);

/// Colours for one stream; none where it is no terminal, NO_COLOR is set or TERM is "dumb".
[[nodiscard]] report::Style style_of(std::FILE* stream);

/// "place: error: message; hint" to stderr.
void print_error(const Error& error);
/// "warning: text" to stderr.
void print_warning(std::string_view text);
/// Writes to stdout and flushes; an error where that fails, as on a full disk.
[[nodiscard]] Status print(std::string_view text);

}  // namespace physim::cli
