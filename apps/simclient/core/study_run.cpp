#include "simclient/core/study_run.hpp"

#include <algorithm>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

#include "base/assert.hpp"
#include "physim/result.hpp"

namespace physim::client {
namespace {

std::size_t count_of(const StudyShots& shots) { return shots.quantities.empty() ? 0 : shots.quantities[0].size(); }

/// One of the machine's threads draws frames.
unsigned threads_beside_frames() { return std::max(std::thread::hardware_concurrency(), 2U) - 1; }

template <class Column>
void append(std::vector<Column>& to, const std::vector<Column>& from) {
  to.resize(std::max(to.size(), from.size()));
  for (std::size_t i = 0; i < from.size(); ++i) to[i].insert(to[i].end(), from[i].begin(), from[i].end());
}
void append(StudyShots& to, const StudyShots& from) {
  append(to.inputs, from.inputs);
  append(to.quantities, from.quantities);
  append(to.hits, from.hits);
  to.at.resize(std::max(to.at.size(), from.at.size()));
  for (std::size_t i = 0; i < from.at.size(); ++i) append(to.at[i], from.at[i]);
}

}  // namespace

/// What a frame sees of a flight: all shards, the shots that are new one by one, and the end where it has come.
struct StudyRun::Seen {
  StudyPart part;
  StudyShots dots;
  std::optional<Result<StudyResult>> end;
};

/// run_study() on a thread of its own. What it tells after each shard waits here for the next frame.
class StudyRun::Flyer {
 public:
  /// No more than `allowed` shards are there until wait_for() lets more come.
  Flyer(StudyPlan plan, StudyPart so_far, std::size_t dots, unsigned threads, std::uint64_t allowed)
      : plan_(std::move(plan)), part_(std::move(so_far)), dots_(dots), allowed_(allowed) {
    thread_ = std::thread([this, threads] { fly(threads); });
  }
  ~Flyer() { stop(); }
  Flyer(const Flyer&) = delete;
  Flyer& operator=(const Flyer&) = delete;

  /// What is there now, with the dots that are new.
  [[nodiscard]] Seen look() {
    const std::lock_guard lock(mutex_);
    return {part_, std::exchange(new_dots_, {}), end_};
  }
  /// Lets so many of the first shards come, and waits for them or for the end.
  void wait_for(std::uint64_t shards) {
    std::unique_lock lock(mutex_);
    allowed_ = shards;
    changed_.notify_all();
    changed_.wait(lock, [&] { return end_ || part_.first_missing() >= shards; });
  }
  /// Shards under way are flown to their end, and are there then.
  void stop() {
    if (!thread_.joinable()) return;
    {
      const std::lock_guard lock(mutex_);
      stops_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

 private:
  void fly(unsigned threads) {
    const auto pool = make_thread_pool(threads);
    const StudyOptions options{.so_far = part_, .after_shard = [this](const StudyPart& part) { return take(part); }};
    auto end = run_study(plan_, pool.get(), options);
    const std::lock_guard lock(mutex_);
    if (!stops_) end_ = std::move(end);
    changed_.notify_all();
  }
  /// Called by one thread at a time.
  bool take(const StudyPart& part) {
    const std::uint32_t each = plan_.study().shard_shots;
    StudyShots more;
    for (; dots_ < kMostDots && dots_ / each < part.first_missing(); dots_ += each)
      append(more, fly_shots_of(plan_, dots_ / each));
    std::unique_lock lock(mutex_);
    part_ = part;
    append(new_dots_, more);
    changed_.notify_all();
    changed_.wait(lock, [this] { return stops_ || part_.first_missing() < allowed_; });
    return !stops_;
  }

  const StudyPlan plan_;
  std::mutex mutex_;
  std::condition_variable changed_;
  StudyPart part_;
  StudyShots new_dots_;
  std::uint64_t dots_;  // kept, before and now
  std::uint64_t allowed_;
  std::optional<Result<StudyResult>> end_;
  bool stops_ = false;
  std::thread thread_;
};

StudyRun::StudyRun() = default;
StudyRun::~StudyRun() = default;
StudyRun::StudyRun(StudyRun&&) noexcept = default;
StudyRun& StudyRun::operator=(StudyRun&&) noexcept = default;

Status StudyRun::begin(const Study& study) {
  const Result<StudyPlan> plan = plan_study(study);
  if (!plan) return plan.error();
  clear();
  const auto tell = [this](const StudyPlan& there) {
    const Result<LinearResult> linear = propagate_linearly(there);
    told_.push_back({there, linear ? std::optional(*linear) : std::nullopt});
  };
  tell(*plan);
  for (const StudyPlan& place : plan->places()) tell(place);
  state_ = State::running;
  return {};
}

StudyTold StudyRun::told(std::optional<std::size_t> place) const {
  PHYSIM_ASSERT(result_ && (!place || (*place < result_->at.size() && *place < dots_.at.size())));
  const Told& there = told_[place ? 1 + *place : 0];
  return {there.plan.study(), place ? result_->at[*place] : *result_, there.linear ? &*there.linear : nullptr,
          place ? dots_.at[*place] : dots_, dots_shown_};
}

void StudyRun::clear() { *this = StudyRun(); }

void StudyRun::pause() {
  if (state_ != State::running) return;
  state_ = State::paused;
  if (!flyer_) return;
  flyer_->stop();
  take(flyer_->look());
  flyer_.reset();
}

void StudyRun::go_on() {
  if (state_ == State::paused) state_ = State::running;
}

void StudyRun::advance(bool one_by_one) {
  if (state_ == State::running) {
    const std::uint64_t allowed = one_by_one ? part_.first_missing() : std::numeric_limits<std::uint64_t>::max();
    if (!flyer_)
      flyer_ =
          std::make_unique<Flyer>(*plan(), part_, count_of(dots_), one_by_one ? 1 : threads_beside_frames(), allowed);
    if (one_by_one) flyer_->wait_for(shards_ + 1);
    take(flyer_->look());
  }
  if (state_ == State::running || state_ == State::done)
    dots_shown_ = std::min(count_of(dots_), dots_shown_ + 4 + dots_shown_ / 24);
}

void StudyRun::take(Seen seen) {
  PHYSIM_ASSERT(plan() && flyer_);
  append(dots_, seen.dots);
  part_ = std::move(seen.part);
  if (seen.end) {
    state_ = State::done;
    flyer_.reset();
    if (!*seen.end) {
      problem_ = seen.end->error().text();
      return;
    }
    result_ = **std::move(seen.end);
    shards_ = result_->shards;
    return;
  }
  const std::uint64_t shards = std::min(part_.first_missing(), plan()->shards());
  if (shards == shards_) return;
  Result<StudyResult> result = result_of(*plan(), part_, shards);
  if (!result) return;
  result_ = *std::move(result);
  shards_ = shards;
}

}  // namespace physim::client
