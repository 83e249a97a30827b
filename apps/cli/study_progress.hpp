// How far a study has come: on a terminal a line that is drawn over itself, in a log a line a minute.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "physim/study.hpp"

namespace physim::cli {

/// "3 hours": two digits of the unit that suits it.
[[nodiscard]] std::string duration_text(double seconds);

class StudyProgress {
 public:
  /// `log_every` [s] is how often a log gets a line; `seconds` [s] how long the study may fly, none: to its end.
  StudyProgress(StudyPlan plan, const StudyPart& so_far, double log_every, std::optional<double> seconds);
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  void show(const StudyPart& part);

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] std::string line(const StudyPart& part, double passed) const;
  [[nodiscard]] std::string figure(const StudyPart& part) const;

  StudyPlan plan_;
  std::uint64_t before_;  // shards that were there
  std::optional<double> seconds_;
  bool is_terminal_, is_drawn_ = false;
  std::chrono::duration<double> every_;
  Clock::time_point start_ = Clock::now(), next_;
};

}  // namespace physim::cli
