#include "progress.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "terminal.hpp"

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

Progress progress_bar(const std::string& label) {
  return [bar = std::make_shared<Bar>(label)](std::size_t done, std::size_t total) { bar->show(done, total); };
}

}  // namespace physim::cli
