#include "study_progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report/number.hpp"
#include "report/study_answer.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

constexpr double kTerminalSeconds = 0.5;  // s
constexpr std::size_t kBarWidth = 30;     // columns

/// "626 k": three digits of how many.
std::string count_text(double number) {
  const std::pair<double, const char*> units[] = {{1e9, " G "}, {1e6, " M "}, {1e3, " k "}};
  for (const auto& [size, name] : units)
    if (number >= size) return report::significant(number / size, 3) + name;
  return report::significant(number, 3) + " ";
}

std::string bar_text(double part) {
  std::string bar(static_cast<std::size_t>(std::clamp(part, 0.0, 1.0) * double{kBarWidth}), '#');
  bar.resize(kBarWidth, '.');
  return "[" + bar + "] ";
}

}  // namespace

std::string duration_text(double seconds) {
  const std::pair<double, const char*> units[] = {
      {365.25 * 86400, "years"}, {86400, "days"}, {3600, "hours"}, {60, "minutes"}};
  for (const auto& [length, name] : units)
    if (seconds >= 2 * length) return report::readable(seconds / length, 2) + " " + name;
  return std::to_string(std::llround(seconds)) + " s";
}

StudyProgress::StudyProgress(StudyPlan plan, const StudyPart& so_far, double log_every, std::optional<double> seconds)
    : plan_(std::move(plan)),
      before_(so_far.shards()),
      seconds_(seconds),
      is_terminal_(is_terminal(stderr)),
      every_(is_terminal_ ? kTerminalSeconds : log_every),
      next_(start_ + std::chrono::duration_cast<Clock::duration>(is_terminal_ ? 2 * every_ : every_)) {}

StudyProgress::~StudyProgress() {
  if (is_drawn_) std::fputs("\r\033[K", stderr);
}

/// The hit probability of the first target, else the mean of the first quantity, of the shards up to the first that is
/// missing.
std::string StudyProgress::figure(const StudyPart& part) const {
  const auto so_far = result_of(plan_, part, std::min(part.first_missing(), plan_.shards()));
  if (!so_far) return "";
  if (!so_far->hits.empty()) {
    const HitResult& hit = so_far->hits.front();
    const auto percent = [](double p) { return report::significant(100 * p, 4); };
    const std::string head = "; " + hit.name + " " + percent(hit.probability.value) + " %";
    if (!std::isfinite(hit.low)) return head;
    return head + ", 95 % interval " + percent(hit.low) + " .. " + percent(hit.high);
  }
  const QuantityResult& first = so_far->quantities.front();
  const std::string head =
      "; mean " + report::with_unit(first.quantity) + " " + report::significant(first.mean.value, 6);
  return std::isfinite(first.mean.error) ? head + " +- " + report::significant(first.mean.error, 2) : head;
}

std::string StudyProgress::line(const StudyPart& part, double passed) const {
  const std::uint64_t done = part.shards(), all = plan_.shards();
  const double rate = static_cast<double>(done - before_) / std::max(passed, 1e-9);  // shards a second
  const double share = seconds_ ? passed / *seconds_ : static_cast<double>(done) / static_cast<double>(all);
  std::string text = is_terminal_ ? "study " + bar_text(share) : "study: ";
  text += std::to_string(done) + (seconds_ ? " shards" : "/" + std::to_string(all) + " shards");
  text += ", " + count_text(rate * plan_.study().shard_shots) + "shots/s";
  const double left = seconds_ ? *seconds_ - passed : static_cast<double>(all - std::min(all, done)) / rate;
  if (std::isfinite(left)) text += ", " + duration_text(std::max(left, 0.0)) + " left";
  return text + figure(part);
}

void StudyProgress::show(const StudyPart& part) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::duration_cast<Clock::duration>(every_);
  const std::string text = line(part, std::chrono::duration<double>(now - start_).count());
  std::fprintf(stderr, is_terminal_ ? "\r\033[K%s" : "%s\n", text.c_str());
  std::fflush(stderr);
  is_drawn_ = is_terminal_;
}

}  // namespace physim::cli
