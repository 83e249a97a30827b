#include "progress.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "terminal.hpp"

namespace physim::cli {
namespace {

constexpr std::chrono::milliseconds kPatience{1000};
constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::size_t kWidth = 30;  // columns of the bar

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(std::max<std::size_t>(total, 1)),
      enabled_(is_terminal(stderr)),
      next_draw_(start_ + kPatience) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::advance() {
  ++done_;
  if (enabled_ && Clock::now() >= next_draw_) draw();
}

void Progress::draw() {
  const auto now = Clock::now();
  const double part = std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_));
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = elapsed * (1 - part) / part;
  std::string bar(static_cast<std::size_t>(part * static_cast<double>(kWidth)), '#');
  bar.resize(kWidth, '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %zu/%zu, %.0f s left", label_.c_str(), bar.c_str(), done_, total_, left);
  std::fflush(stderr);
  drawn_ = true;
  next_draw_ = now + kRedraw;
}

}  // namespace physim::cli
