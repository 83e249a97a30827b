#include "terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace physim::cli {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{1000};
constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::size_t kWidth = 30;  // columns of the bar

class Bar {
 public:
  explicit Bar(const std::string& label) : label_(label) {}
  ~Bar() {
    if (is_drawn_) std::fputs("\r\033[K", stderr);
  }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;

  void show(std::size_t done, std::size_t total) {
    if (!is_enabled_ || total == 0 || Clock::now() < next_draw_) return;
    const auto now = Clock::now();
    const double part = std::clamp(static_cast<double>(done) / static_cast<double>(total), 1e-9, 1.0);
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double left = elapsed * (1 - part) / part;
    std::string bar(static_cast<std::size_t>(part * static_cast<double>(kWidth)), '#');
    bar.resize(kWidth, '.');
    std::fprintf(stderr, "\r\033[K%s [%s] %zu/%zu, %.0f s left", label_.c_str(), bar.c_str(), done, total, left);
    std::fflush(stderr);
    is_drawn_ = true;
    next_draw_ = now + kRedraw;
  }

 private:
  std::string label_;
  bool is_enabled_ = is_terminal(stderr), is_drawn_ = false;
  Clock::time_point start_ = Clock::now(), next_draw_ = start_ + kPatience;
};

}  // namespace

bool job_is_there() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1 && !job_is_there(); }

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
  return print([text](const report::Sink& sink) { sink(text); });
}

Status print(const report::Text& text) {
  int error_number = 0;
  const auto note = [&](bool written) { error_number = written || error_number != 0 ? error_number : errno; };
  text([&](std::string_view piece) {
    if (error_number == 0) note(std::fwrite(piece.data(), 1, piece.size(), stdout) == piece.size());
  });
  note(std::fflush(stdout) == 0);
  if (error_number == 0) return {};
  return Error{.message = std::string("cannot write to the standard output: ") + std::strerror(error_number)};
}

Progress progress_bar(const std::string& label) {
  return [bar = std::make_shared<Bar>(label)](std::size_t done, std::size_t total) { bar->show(done, total); };
}

}  // namespace physim::cli
