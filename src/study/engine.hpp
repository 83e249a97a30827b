// The engines that fly the shards of a study: threads, or the ranks of a job.
#pragma once

#include <functional>

#include "study/part.hpp"
#include "study/plan.hpp"

namespace physim {

/// How far an engine came.
enum class Flown { all, stopped, until_time };

/// Flies what is missing of the shards before `end` and adds it to the part.
using ShardEngine = std::function<Flown(StudyPartRecord& part, std::uint64_t end)>;

/// Where shards that are handed out in their order end: at a count that was asked for or, once the time is up, where a
/// study may end that has those which were handed out.
class ShardsToFly {
 public:
  ShardsToFly(const StudyPlanRecord& plan, std::uint64_t end, const std::function<bool()>& time_is_up)
      : at_once_(plan.shards_at_once()), asked_(end), end_(end), time_is_up_(time_is_up) {}

  [[nodiscard]] std::uint64_t end() const { return end_; }
  /// Checks the time before a shard is handed out: the first that is not yet.
  void look_at_time(std::uint64_t next);
  /// How far the engine came.
  [[nodiscard]] Flown flown(bool stopped) const;

 private:
  std::uint64_t at_once_, asked_, end_;
  const std::function<bool()>& time_is_up_;
  bool is_up_ = false;
};

/// Completes a study from `so_far` to its end, or until its figure is precise enough: the engine changes no bit.
[[nodiscard]] Result<StudyResult> run_study_on(const StudyPlan& plan, const StudyPart& so_far,
                                               const ShardEngine& engine);

}  // namespace physim
