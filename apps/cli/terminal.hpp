// What a person at a terminal sees: colour, where the stream is a terminal and NO_COLOR is not set, and error messages.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "physim/result.hpp"

namespace physim::cli {

[[nodiscard]] bool is_terminal(std::FILE* stream);

/// Decorates text for one stream; plain where the stream is no terminal, NO_COLOR is set or TERM is "dumb".
class Style {
 public:
  explicit Style(std::FILE* stream);

  [[nodiscard]] std::string bold(std::string_view text) const { return wrap("1", text); }
  [[nodiscard]] std::string dim(std::string_view text) const { return wrap("2", text); }
  [[nodiscard]] std::string good(std::string_view text) const { return wrap("32", text); }
  [[nodiscard]] std::string bad(std::string_view text) const { return wrap("1;31", text); }
  [[nodiscard]] std::string warn(std::string_view text) const { return wrap("33", text); }

 private:
  [[nodiscard]] std::string wrap(const char* code, std::string_view text) const;
  bool enabled_;
};

/// "place: error: message; hint" to stderr.
void print_error(const Error& error);
/// "warning: text" to stderr.
void print_warning(std::string_view text);
/// Writes to stdout and flushes; an error where that fails, as on a full disk.
[[nodiscard]] Status print(std::string_view text);

}  // namespace physim::cli
