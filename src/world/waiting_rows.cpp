#include "world/waiting_rows.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "base/ieee_mode.hpp"
#include "world/kernels.hpp"
#include "world/registry.hpp"
#include "world/rows.hpp"

namespace physim {
namespace {

std::atomic<bool> is_allowed{true};

}  // namespace

bool rows_may_wait() { return is_allowed.load(std::memory_order_relaxed); }
void let_rows_wait(bool may) { is_allowed.store(may, std::memory_order_relaxed); }

bool may_wait(const WorldCohort& cohort) {
  const CohortKey& key = cohort.key;
  const Fidelity& f = key.fidelity;
  if (f.motion != Motion::closed_form || f.earth != EarthModel::flat || key.still || key.forced) return false;
  const RowLayout& layout = cohort.layout;
  if (!layout.clocked || layout.meeting || layout.carried || layout.turning) return false;
  Features other = key.features;
  other.has_gravity_scale = other.has_frozen = false;
  const WatchList& watch = cohort.course_double.watch;
  const auto is_seen = [](const Watched& watched) { return is_seen_by_watchdog(watched); };
  return other == Features{} && std::all_of(watch.item, watch.item + watch.count, is_seen);
}

void WaitingRows::begin(const WorldCohort& cohort, std::uint32_t now, double dt, std::uint32_t rows) {
  cohort_ = &cohort;
  now_ = now;
  dt_ = dt;
  const std::size_t words = (rows + kRowsPerWord - 1) / kRowsPerWord;
  right_at_.assign(words, now);
  due_.assign(words, 0);
  look_.assign(words, now + kStepsAfterChange);
  reach_.assign(words, kMostReach - 1);
  failed_.assign(words, 0);
  clock_.assign(words, {});
}

bool WaitingRows::any_due(std::uint32_t first, std::uint32_t last) const {
  PHYSIM_ASSERT(last <= due_.size());
  std::uint32_t least = ~0u;
  for (std::uint32_t word = first; word < last; ++word) least = std::min(least, due_[word]);
  return least <= now_;
}

void WaitingRows::forget(std::uint32_t word) {
  PHYSIM_ASSERT(word < due_.size());
  due_[word] = 0;
  look_[word] = std::max(look_[word], now_ + kStepsAfterChange);
  clock_[word] = {};
}

void WaitingRows::join(std::uint32_t word, std::uint32_t other) {
  PHYSIM_ASSERT(right_at(word) == right_at(other));
  due_[word] = std::min(due_[word], due_[other]);
  clock_[word] = {};
}

void WaitingRows::add(std::uint32_t word) {
  if (word == right_at_.size()) {
    right_at_.push_back(0), due_.push_back(0), look_.push_back(0), reach_.push_back(0), failed_.push_back(0);
    clock_.emplace_back();
  }
  PHYSIM_ASSERT(word < right_at_.size());
  right_at_[word] = now_;
  due_[word] = 0;
  look_[word] = now_ + kStepsAfterChange;
  reach_[word] = kMostReach - 1;
  failed_[word] = 0;
  clock_[word] = {};
}

// ------------------------------------------------------------------------------------------- bringing rows up to date
namespace {

/// To find out where rows are after `steps` steps.
template <class S>
WorldJob<S> job_of(const Rows& rows, const WaitingRows& waiting, std::uint32_t steps) {
  PHYSIM_ASSERT(steps > 0);
  WorldJob<S> job{};
  job.course = &waiting.cohort()->course<S>();
  job.columns = rows.columns<S>();
  job.fields = rows.layout().fields.data();
  job.field_masks = rows.field_masks().data();
  job.field_count = static_cast<unsigned>(rows.layout().fields.size());
  job.clocked = true;
  job.clocks = waiting.clocks();
  job.now = static_cast<S>(steps - 1);
  job.h = static_cast<S>(waiting.dt());
  return job;
}

/// Writes where rows are after `steps` steps into the columns of their positions or of their previous ones.
template <class S>
void place(const Rows& rows, const WaitingRows& waiting, std::uint32_t steps, bool previous, std::uint32_t first,
           std::uint32_t last) {
  WorldJob<S> job = job_of<S>(rows, waiting, steps);
  if (!previous) std::ranges::copy(job.columns.position, job.columns.previous);  // kernels write where it says that
  job.velocities = true;
  job.first = first;
  job.last = last;
  place_rows_with(world_kernel(), job);
}

}  // namespace

void Rows::bring_up_words(std::uint32_t first, std::uint32_t last) const {
  const std::uint32_t now = waiting_.now();
  const auto end_of = [this](std::uint32_t word) {
    return std::min(word * static_cast<std::uint32_t>(kRowsPerWord), size_);
  };
  for (std::uint32_t word = first; word < last;) {
    const std::uint32_t since = waiting_.right_at(word);
    std::uint32_t end = word + 1;
    while (end < last && waiting_.right_at(end) == since) ++end;
    if (since < now && end_of(word) < end_of(end)) {
      const auto put = [&](std::uint32_t steps, bool previous) {
        visit([&]<class S>(const RowColumns<S>&) {
          place<S>(*this, waiting_, steps, previous, end_of(word), end_of(end));
        });
      };
      // Positions change places in each step: after one step the previous ones are there already.
      if (since + 1 < now) put(now - 1, true);
      put(now, false);
    }
    if (since < now)
      for (std::uint32_t done = word; done < end; ++done) waiting_.set_right(done, now);
    word = end;
  }
}

/// Rows that were just launched anew stand where they were put, which a closed form meets to rounding alone: only words
/// that wait are computed.
template <class S>
std::array<const S*, 3> Rows::positions(std::uint32_t first, std::uint32_t count, PlacedRows<S>& beside) const {
  PHYSIM_ASSERT(first % kRowsPerWord == 0 && first + count <= size_ && count <= PlacedRows<S>::kMost);
  constexpr auto kWord = static_cast<std::uint32_t>(kRowsPerWord);
  const auto& position = columns<S>().position;
  const auto waits = [&](std::uint32_t row) { return waiting_.is_stale((first + row) / kWord); };
  const auto end_of_run = [&](std::uint32_t begin, bool of_waiting) {
    std::uint32_t end = begin;
    while (end < count && waits(end) == of_waiting) end += kWord;
    return std::min(end, count);
  };
  if (end_of_run(0, false) == count) return {position[0] + first, position[1] + first, position[2] + first};
  WorldJob<S> job = job_of<S>(*this, waiting_, waiting_.now());
  for (const std::uint8_t field : layout_.fields)
    if (field_masks_[field] != 0) job.columns.field[field] += first;
  job.columns.born += first;
  job.columns.offset += first;
  job.clocks += first / kWord;
  std::ranges::copy(beside.position, job.columns.previous);
  while (job.last < count) {
    const std::uint32_t still = end_of_run(job.last, false);
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::copy(position[axis] + first + job.last, position[axis] + first + still, beside.position[axis] + job.last);
    job.first = still;
    job.last = end_of_run(still, true);
    if (job.first < job.last) place_rows_with(world_kernel(), job);
  }
  return {beside.position[0], beside.position[1], beside.position[2]};
}
template std::array<const float*, 3> Rows::positions(std::uint32_t, std::uint32_t, PlacedRows<float>&) const;
template std::array<const double*, 3> Rows::positions(std::uint32_t, std::uint32_t, PlacedRows<double>&) const;

void Rows::bring_up_shared(std::uint32_t first, std::uint32_t last) const {
  const IeeeMode mode;  // whoever reads
  const std::lock_guard lock(waiting_.cohort()->bringing_up);
  bring_up_words(first, last);
}

}  // namespace physim
