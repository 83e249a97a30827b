#include "terminal.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace physim::cli {

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

report::Style style_of(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool is_unwanted = no_color != nullptr && *no_color != '\0';
  const bool is_unable = terminal == nullptr || std::strcmp(terminal, "dumb") == 0;
  return report::Style(is_terminal(stream) && !is_unwanted && !is_unable);
}

void print_error(const Error& error) {
  const std::string head = error.place.empty() ? "" : error.place + ": ";
  const std::string hint = error.hint.empty() ? "" : "; " + error.hint;
  std::fprintf(stderr, "%s%s %s%s\n", head.c_str(), style_of(stderr).bad("error:").c_str(), error.message.c_str(),
               hint.c_str());
}

void print_warning(std::string_view text) {
  std::fprintf(stderr, "%s %s\n", style_of(stderr).warn("warning:").c_str(), std::string(text).c_str());
}

Status print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return {};
  return Error{.message = std::string("cannot write to the standard output: ") + std::strerror(errno)};
}

}  // namespace physim::cli
