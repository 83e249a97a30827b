// Going back and on: moments of a session that are remembered, and what is known behind the one at hand.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/assert.hpp"
#include "simclient/core/session.hpp"
#include "simclient/core/thinning.hpp"

namespace physim::client {
namespace {

constexpr double kMomentTime = 1.0 / 60;           // moments that can be gone back to are no nearer [s]
constexpr std::size_t kMomentMemory = 256u << 20;  // for all moments that can be gone back to [bytes]
constexpr std::size_t kLeastMoments = 4, kMostMoments = 3600;
constexpr double kSameTime = 1e-9;        // times nearer than this are the same [s]
constexpr std::size_t kRunMemory = 4096;  // of a run's own counts, about [bytes]

}  // namespace

// ------------------------------------------------------------------------------------------------------------- seeking
void Session::go_to(std::uint64_t step) {
  paused_ = true;
  leftover_ = 0;
  target_ = std::max(step, first_step());
}

void Session::show_at(double time) {
  const double steps = std::floor((time - this->time()) / step_length() + 1e-6) + static_cast<double>(step_);
  go_to(steps > 0 ? static_cast<std::uint64_t>(steps) : 0);
  seek(std::numeric_limits<double>::infinity());
  leftover_ = std::clamp(time - this->time(), 0.0, step_length());
}

bool Session::step_back() {
  if (step_ <= first_step()) return paused_ = true, false;
  go_to(step_ - 1);
  seek(std::numeric_limits<double>::infinity());
  return true;
}

std::uint64_t Session::first_step() const { return moments_.empty() ? 0 : moments_.front().step; }

int Session::seek(double patience) {
  PHYSIM_ASSERT(target_.has_value());
  const auto start = std::chrono::steady_clock::now();
  const auto is_late = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > patience;
  };
  const std::uint64_t target = *target_;
  if (is_replay()) {
    if (target < step_ && !begin_replay()) return target_.reset(), 0;
  } else {
    jump_towards(target);
  }
  int steps = 0;
  for (; step_ < target && !over_ && (steps == 0 || !is_late()); ++steps) take_step();
  show_known();
  follow_flights();
  if (step_ == target || over_) target_.reset();
  return steps;
}

/// To the last moment that is remembered up to a step, unless steps from the one at hand are fewer.
void Session::jump_towards(std::uint64_t target) {
  PHYSIM_ASSERT(!moments_.empty() && moments_.front().step <= target);
  const auto later = std::ranges::upper_bound(moments_, target, {}, &Moment::step);
  const Moment& there = *std::prev(later);
  if (target >= step_ && there.step <= step_) return;
  if (!ahead_) ahead_ = Ahead{tracks_, hits_, step_, world().size() > 0};
  run_->restore(there.run);
  step_ = there.step;
  if (step_ == ahead_->step) end_of_known();
}

/// A step was taken where the steps are known already. What was changed by hand there is in the moment behind it.
void Session::follow_known() {
  PHYSIM_ASSERT(ahead_ && step_ <= ahead_->step);
  const auto there = std::ranges::lower_bound(moments_, step_, {}, &Moment::step);
  if (there != moments_.end() && there->step == step_ && there->changed) run_->restore(there->run);
  if (step_ == ahead_->step) end_of_known();
}

void Session::end_of_known() {
  tracks_ = std::move(ahead_->tracks);
  hits_ = std::move(ahead_->hits);
  ahead_.reset();
}

/// Tracks and hits up to the moment at hand, out of what is known.
void Session::show_known() {
  if (!ahead_) return;
  tracks_ = ahead_->tracks;
  hits_ = ahead_->hits;
  forget_after(world().time());
}

/// Something was changed by hand at the moment at hand: what came behind it does not come again.
void Session::begin_change() {
  target_.reset();
  ahead_.reset();
  while (!moments_.empty() && moments_.back().step > step_) forget_moment(false);
}

void Session::forget_after(double time) {
  const double late = time + kSameTime;
  hits_.forget_after(late);
  std::erase_if(tracks_, [&](const Track& track) {
    const bool is_of_now = !track.whole && track.born > time - kSameTime;  // it may come with the next step
    return track.born > late || (is_of_now && !world()[track.id].is_alive());
  });
  for (Track& track : tracks_) {
    const auto is_late = [&](const TrackSample& s) { return track.born + s.time > late; };
    while (track.samples.size() > 1 && is_late(track.samples.back())) track.samples.pop_back();
    track.thinned = std::min(track.thinned, track.samples.size() - 1);
    if (track.apex && is_late(*track.apex)) track.apex.reset();
    if (track.impact && is_late(*track.impact)) track.impact.reset();
    if (!track.whole) {
      const LifeStatus then = world()[track.id].status();
      // The world forgets projectiles that have left, and their tracks know.
      if (then != LifeStatus::unknown || track.is_flying()) track.status = then;
      if (track.is_flying()) add_later(track, sample(track));  // it may have been thinned out
    } else if (late < track.born + track.whole->duration()) {
      track.status = LifeStatus::in_flight;
      while (track.passed > 1 && is_late((*track.path)[track.passed - 1])) --track.passed;
    }
  }
  follow_flights();
}

// ------------------------------------------------------------------------------------------------------------- moments
void Session::remember_moment(bool changed) {
  const std::size_t last = moments_.empty() ? 0 : moments_.back().memory;
  const double steps_apart = std::clamp(std::round(kMomentTime / step_length()), 1.0, 1e6);
  constexpr double kStillApart = 60;  // steps in which nothing moves are soon taken again
  const double apart = std::clamp(static_cast<double>(last >> 18), cost_.moved > 0 ? 1.0 : kStillApart, kStillApart);
  const auto every = static_cast<std::uint64_t>(apart * steps_apart);
  const bool is_soon = !moments_.empty() && step_ > moments_.back().step && step_ - moments_.back().step < every;
  if (is_soon && !changed) return;
  if (!moments_.empty() && moments_.back().step == step_) {
    changed |= moments_.back().changed;
    forget_moment(false);
  }
  // A copy of the world's state is no larger than the world, and that of the run is small beside it.
  const std::size_t memory = run_->world().memory() + sizeof(Moment) + kRunMemory;
  moments_.push_back({step_, run_->snapshot(), memory, changed});
  moment_memory_ += memory;
  while (moments_.size() > kLeastMoments && (moment_memory_ > kMomentMemory || moments_.size() > kMostMoments))
    thin_moments();
}

/// Forgets every second one of those that steps from the one before lead to again; the first where there is none.
void Session::thin_moments() {
  std::deque<Moment> kept;
  bool is_second = false;
  for (std::size_t i = 0; i < moments_.size(); ++i) {
    Moment& each = moments_[i];
    const bool stays = i == 0 || i + 1 == moments_.size() || each.changed || !(is_second = !is_second);
    if (stays)
      kept.push_back(std::move(each));
    else
      moment_memory_ -= each.memory;
  }
  const bool has_thinned = kept.size() < moments_.size();
  moments_ = std::move(kept);
  if (!has_thinned) forget_moment(true);
}

/// The first or the last one.
void Session::forget_moment(bool first) {
  PHYSIM_ASSERT(!moments_.empty() && moment_memory_ >= moments_.front().memory);
  moment_memory_ -= first ? moments_.front().memory : moments_.back().memory;
  if (first)
    moments_.pop_front();
  else
    moments_.pop_back();
}

void Session::forget_moments() {
  moments_.clear();
  moment_memory_ = 0;
}

}  // namespace physim::client
