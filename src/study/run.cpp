// A study flown on threads, to its end or until a figure is known well enough.
#include <algorithm>
#include <mutex>

#include "base/ieee_mode.hpp"
#include "physim/result.hpp"
#include "study/engine.hpp"
#include "study/estimates.hpp"
#include "study/part.hpp"
#include "study/shard.hpp"

namespace physim {
namespace {

StudyPart copy_of(const StudyPartRecord& part) { return StudyPart(std::make_shared<const StudyPartRecord>(part)); }

StudyPartRecord begun(const StudyPlan& plan, const StudyPart& so_far) {
  StudyPartRecord part = so_far.record();
  part.hash = plan.record().hash;
  return part;
}

/// Shards of a study go to any thread that is free; the assignment changes nothing.
class ShardThreads {
 public:
  ShardThreads(const StudyPlan& plan, const StudyOptions& options, StudyPartRecord& part)
      : plan_(plan), options_(options), part_(part) {}

  /// Flies what is missing of the shards before `end`, from `first` on.
  Flown fly(std::uint64_t first, std::uint64_t end, TaskRunner* runner) {
    to_fly_.emplace(plan_.record(), end, options_.time_is_up);
    next_ = first;
    const std::size_t threads = runner ? runner->threads() : 1;
    if (threads <= 1)
      work();
    else
      runner->run(
          threads, [](void* self, std::size_t) { static_cast<ShardThreads*>(self)->work(); }, this);
    return to_fly_->flown(stopped_);
  }

 private:
  void work() {
    const IeeeMode mode;
    ShardFlyer flyer(plan_.record());
    for (std::uint64_t shard = 0; take(shard);) keep(shard, std::make_shared<const ShardSums>(flyer.fly(shard)));
  }
  bool take(std::uint64_t& shard) {
    const std::lock_guard lock(mutex_);
    shard = next_ = part_.missing_from(next_);
    if (!stopped_ && next_ < to_fly_->end()) to_fly_->look_at_time(next_);
    return !stopped_ && next_++ < to_fly_->end();
  }
  void keep(std::uint64_t shard, std::shared_ptr<const ShardSums> sums) {
    const std::lock_guard lock(mutex_);
    PHYSIM_ASSERT(shard < to_fly_->end());
    part_.add(shard, {1, std::move(sums)});
    if (!stopped_ && options_.after_shard && !options_.after_shard(copy_of(part_))) stopped_ = true;
  }

  const StudyPlan& plan_;
  const StudyOptions& options_;
  std::mutex mutex_;
  StudyPartRecord& part_;
  std::optional<ShardsToFly> to_fly_;
  std::uint64_t next_ = 0;
  bool stopped_ = false;
};

/// Shard counts at which a width is judged: 1, 2, 3, 4, 6, 8, 12, ... times the replicates.
std::uint64_t next_judged(std::uint64_t count) {
  PHYSIM_ASSERT(count % kReplicates == 0);
  const std::uint64_t parts = count / kReplicates;
  if (parts < 2) return (parts + 1) * kReplicates;
  std::uint64_t power = 1;
  while (2 * power <= parts) power *= 2;
  return (parts < power + power / 2 ? power + power / 2 : 2 * power) * kReplicates;
}

Status check_same(const StudyPlanRecord& plan, const StudyPart& so_far) {
  if (so_far.shards() == 0 || so_far.record().hash == plan.hash) return {};
  return Error{"what was flown before is of another study", "so_far", "start anew"};
}

}  // namespace

void ShardsToFly::look_at_time(std::uint64_t next) {
  PHYSIM_ASSERT(next < end_);
  if (is_up_ || !time_is_up_ || !time_is_up_()) return;
  is_up_ = true;
  const std::uint64_t rounds = std::max<std::uint64_t>((next + at_once_ - 1) / at_once_, 1);
  end_ = std::min(end_, rounds * at_once_);
}

Flown ShardsToFly::flown(bool stopped) const {
  if (stopped) return Flown::stopped;
  return end_ < asked_ ? Flown::until_time : Flown::all;
}

Result<StudyPart> run_shards(const StudyPlan& plan, std::uint64_t first, std::uint64_t count, TaskRunner* runner,
                             const StudyOptions& options) {
  const IeeeMode mode;
  if (Status status = check_same(plan.record(), options.so_far); !status) return status.error();
  if (first > plan.shards() || count > plan.shards() - first)
    return Error{"the study has " + std::to_string(plan.shards()) + " shards", "count", "ask for fewer"};
  StudyPartRecord part = begun(plan, options.so_far);
  ShardThreads(plan, options, part).fly(first, first + count, runner);
  return copy_of(part);
}

Result<StudyResult> run_study_on(const StudyPlan& plan, const StudyPart& so_far, const ShardEngine& engine) {
  const IeeeMode mode;
  const StudyPlanRecord& record = plan.record();
  if (Status status = check_same(record, so_far); !status) return status.error();
  StudyPartRecord part = begun(plan, so_far);
  const bool judged = record.study.until_width.has_value();
  Flown flown = Flown::all;
  for (std::uint64_t count = 0; count < record.shards;) {
    count = judged ? std::min(next_judged(count), record.shards) : record.shards;
    flown = engine(part, count);
    if (flown != Flown::all) break;
    if (!judged) continue;
    // If more was flown before, the part has no separate sums for fewer shards: they were judged then.
    const auto sums = part.first_shards(count);
    if (!sums || !(width_of(record, **sums) <= record.study.until_width->width)) continue;
    StudyResult result = figures_of(record, **sums);
    result.width_reached = true;
    return result;
  }
  std::uint64_t whole = std::min(part.missing_from(0), record.shards);
  if (flown != Flown::until_time) return result_of(plan, copy_of(part), whole);
  whole -= whole % record.shards_at_once();  // more may have been flown before, and not joined beyond that
  auto result = result_of(plan, copy_of(part), whole);
  if (result) result->time_was_up = true;
  return result;
}

Result<StudyResult> run_study(const StudyPlan& plan, TaskRunner* runner, const StudyOptions& options) {
  return run_study_on(plan, options.so_far, [&](StudyPartRecord& part, std::uint64_t end) {
    return ShardThreads(plan, options, part).fly(0, end, runner);
  });
}

Result<StudyResult> run_study(const Study& study, TaskRunner* runner) {
  const auto plan = plan_study(study);
  if (!plan) return plan.error();
  return run_study(*plan, runner);
}

std::vector<double> draws_of(const StudyPlan& plan, std::uint64_t shot) {
  const IeeeMode mode;
  return drawn_by(plan.record(), shot);
}

std::vector<double> fly_shot_of(const StudyPlan& plan, std::uint64_t shot) {
  const IeeeMode mode;
  const StudyPlanRecord& record = plan.record();
  const std::vector<double> drawn = drawn_by(record, shot);
  std::vector<double> quantities(record.columns());
  std::vector<std::span<const double>> in;
  std::vector<std::span<double>> out;
  for (const double& x : drawn) in.emplace_back(&x, 1);
  for (double& x : quantities) out.emplace_back(&x, 1);
  ModelScratch scratch;
  record.model->evaluate(in, out, scratch);
  quantities.resize(record.study.quantities.size());  // those of places have plans of their own
  return quantities;
}

StudyShots fly_shots_of(const StudyPlan& plan, std::uint64_t shard) {
  const IeeeMode mode;
  return ShardFlyer(plan.record()).shots_of(shard);
}

}  // namespace physim
