// The batch loop: all lanes step together, each at its own time; a lane whose flight ends takes the next shot.
#pragma once

#include "flight/batch_job.hpp"

PHYSIM_ISA_BEGIN

/// Shots waiting to enter a lane, prepared a pack at a time: the first slopes of a whole pack cost little more than
/// one.
template <class R, class S>
class ReadyShots {
 public:
  explicit ReadyShots(const BatchJob<S>& job) : job_(job) {}

  /// Puts the next shot into a lane; false where none is left.
  bool take(Lanes<R>& into, int lane, std::size_t& shot) {
    if (used_ == filled_ && !refill()) return false;
    copy_lane(into, lane);
    shot = next_ - static_cast<std::size_t>(filled_ - used_);
    ++used_;
    return true;
  }

  /// Fills all lanes at the start.
  std::size_t take_all(Lanes<R>& into, std::size_t* shots) {
    refill();
    into = ready_;
    for (int lane = 0; lane < filled_; ++lane) shots[lane] = static_cast<std::size_t>(lane);
    used_ = filled_;
    return static_cast<std::size_t>(filled_);
  }

 private:
  bool refill() {
    const std::size_t left = job_.count - next_;
    if (left == 0) return false;
    filled_ = left < std::size_t(kLanes<R>) ? static_cast<int>(left) : kLanes<R>;
    // Unused lanes repeat the last shot, so that they hold sound numbers.
    for (int lane = 0; lane < kLanes<R>; ++lane)
      put_lane(ready_.body, lane, job_.bodies[next_ + static_cast<std::size_t>(lane < filled_ ? lane : filled_ - 1)]);
    begin(*job_.course, ready_);
    next_ += static_cast<std::size_t>(filled_);
    used_ = 0;
    return true;
  }

  /// Copies what begin() has set; slopes beyond the first are written before they are read.
  void copy_lane(Lanes<R>& into, int lane) {
    copy_fields(ready_.body, used_, into.body, lane, body_fields());
    copy_fields(ready_.step.start, used_, into.step.start, lane);
    copy_fields(ready_.step.slope[0], used_, into.step.slope[0], lane);
    copy_fields(ready_.control, used_, into.control, lane);
    if (job_.course->corners) copy_fields(ready_.regime, used_, into.regime, lane);
    set_lane(into.step.t, lane, S(0));
    set_lane(into.count, lane, S(0));
    set_lane(into.tries, lane, S(0));
    set_lane(into.cut, lane, S(0));
  }
  template <template <class> class Struct>
  PHYSIM_INLINE static void copy_fields(const Struct<R>& from, int from_lane, Struct<R>& into, int lane,
                                        unsigned count = sizeof(Struct<R>) / sizeof(R)) {
    const auto* source = reinterpret_cast<const S*>(&from) + from_lane;
    auto* to = reinterpret_cast<S*>(&into) + lane;
    for (unsigned i = 0; i < count * unsigned(kLanes<R>); i += unsigned(kLanes<R>)) to[i] = source[i];
  }
  /// Bands come last in a body, and few cohorts have them.
  [[nodiscard]] unsigned body_fields() const {
    return job_.course->conditions->has_bands ? unsigned(kBodyFields<R>) : unsigned(kBodyFields<R>) - 2 * kMaxBands;
  }

  const BatchJob<S>& job_;
  Lanes<R> ready_;
  std::size_t next_ = 0;  // first shot not yet prepared
  int filled_ = 0;
  int used_ = 0;
};

/// Reports what happened in one lane's last step; true when its flight has ended. `at` is working space.
template <class R, class S>
bool settle_lane(const BatchJob<S>& job, const Lanes<R>& l, int lane, bool accepted, std::size_t shot,
                 LaneStep<S>& at) {
  Found found[2 * kMaxWatched];
  const Verdict verdict = judge(*job.course, l, lane, accepted, at, found);
  State<double> last{};
  for (int i = 0; i < verdict.found; ++i) {
    const double time = at.time(found[i].theta);
    last = at.at_time(time);
    job.emit(job.sink, {shot, found[i].index, found[i].rising, time, last});
  }
  if (!verdict.ended) return false;
  RawEnd& end = job.ends[shot];
  end.outcome = verdict.outcome;
  end.steps = static_cast<double>(lane_of(l.count, lane));
  end.tries = static_cast<double>(lane_of(l.tries, lane));
  if (!accepted || verdict.outcome == Outcome::non_finite) {  // the flight stays where this step began
    end.time = static_cast<double>(lane_of(l.step.t, lane));
    get_lane_as_double(l.step.start, lane, end.state);
    return true;
  }
  end.steps += 1;
  end.time = at.time(verdict.theta);
  const bool at_event = verdict.found > 0 && verdict.theta == found[verdict.found - 1].theta;
  end.state = at_event ? last : at.at_time(end.time);
  return true;
}

template <class R, class S>
void fly_lanes(const BatchJob<S>& job) {
  if (job.count == 0) return;
  ReadyShots<R, S> ready(job);
  Lanes<R> lanes{};
  LaneStep<S> at{};
  std::size_t shot[kLanes<R>] = {};
  const std::size_t first = ready.take_all(lanes, shot);
  unsigned flying = static_cast<unsigned>((std::size_t(1) << first) - 1);  // bit i: lane i has a shot
  while (flying != 0) {
    const MaskOf<R> accepted = try_step(*job.course, lanes);
    const MaskOf<R> special = needs_attention(*job.course, lanes, accepted);
    unsigned ended = 0;
    if (any(special)) {
      const unsigned accepted_bits = lane_bits(accepted);
      for (unsigned left = lane_bits(special) & flying; left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        const bool lane_accepted = (accepted_bits >> lane & 1u) != 0;
        if (settle_lane(job, lanes, lane, lane_accepted, shot[lane], at)) ended |= 1u << lane;
      }
    }
    accept(*job.course, lanes, accepted);
    for (; ended != 0; ended &= ended - 1) {
      const int lane = __builtin_ctz(ended);
      if (!ready.take(lanes, lane, shot[lane])) flying &= ~(1u << lane);
    }
  }
}

PHYSIM_ISA_END
