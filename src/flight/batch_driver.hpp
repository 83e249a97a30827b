// The batch loop: all lanes step together, each at its own time; a lane takes the next shot when its flight ends.
#pragma once

#include "base/assert.hpp"
#include "flight/known_pack_steps.hpp"
#include "flight/lane_launches.hpp"

PHYSIM_ISA_BEGIN

/// The shots of a job as they enter lanes, in their order.
template <class R, class S>
class ShotsToFly {
 public:
  explicit ShotsToFly(const BatchJob<S>& job) : job_(job) {}

  [[nodiscard]] bool are_left() const { return next_ < job_.count; }
  /// What shots have in common, in lanes that will launch some.
  void put_common(Body<R>& body) const {
    const double* common = numbers(*job_.common);
    R* to = numbers(body);
    job_.course->body.each([common, to](unsigned i) { to[i] = R(static_cast<S>(common[i])); });
  }
  /// Launches the next shots, as many as there are lanes, and sets `first` to the first of them; returns their number.
  int launch(March<R>& march, StandingWatch<R>& watch, std::size_t& first) {
    PHYSIM_ASSERT(next_ <= job_.count);
    const std::size_t left = job_.count - next_;
    if (left == 0) return 0;
    Lanes<R>& lanes = march.lanes;
    const Conditions<S>& c = *job_.course->conditions;
    const int filled = left < std::size_t(kLanes<R>) ? static_cast<int>(left) : kLanes<R>;
    // Unused lanes repeat the last shot, so that they hold sound numbers.
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      const std::size_t shot = next_ + static_cast<std::size_t>(lane < filled ? lane : filled - 1);
      if (job_.launches == nullptr) put_lane(job_.own_numbers + shot * job_.own_stride, lanes.body, lane, job_.own);
      const auto take_rotor = [&](auto& rotor) { put_lane(job_.rotors[shot], rotor, lane); };
      for_rotors(c.fidelity, take_rotor, lanes);
    }
    if (job_.launches != nullptr) put_launches(*job_.launches, next_, filled, lanes.body);
    if (job_.launches != nullptr && job_.launches->weather != nullptr)
      put_weather(*job_.launches->weather, c, next_, filled, lanes.body);
    march.launch();
    watch.begin(c, job_.course->watch, lanes);
    first = next_;
    next_ += static_cast<std::size_t>(filled);
    return filled;
  }

 private:
  const BatchJob<S>& job_;
  std::size_t next_ = 0;  // not yet launched
};

/// Shots waiting to enter a lane each, launched a pack at a time: the first slopes of a whole pack cost little more
/// than one.
template <class R, class S>
class ReadyShots {
 public:
  ReadyShots(const BatchJob<S>& job, ShotsToFly<R, S>& shots) : job_(job), shots_(shots), march_(*job.course) {
    shots.put_common(march_.lanes.body);
  }

  /// Puts the next shot into a lane; false where none is left.
  bool take(Lanes<R>& into, StandingWatch<R>& watch, int lane, std::size_t& shot) {
    PHYSIM_ASSERT(used_ <= filled_ && filled_ <= kLanes<R>);
    if (used_ == filled_) filled_ = shots_.launch(march_, watch_, first_), used_ = 0;
    if (filled_ == 0) return false;
    copy_start(*job_.course, march_.lanes, used_, into, lane, job_.own);  // what all have in common is there
    watch.take(watch_, used_, lane);
    shot = first_ + static_cast<std::size_t>(used_++);
    PHYSIM_ASSERT(shot < job_.count);
    return true;
  }

 private:
  const BatchJob<S>& job_;
  ShotsToFly<R, S>& shots_;
  March<R> march_;
  StandingWatch<R> watch_;  // at their launch
  std::size_t first_ = 0;   // in the first lane
  int filled_ = 0;
  int used_ = 0;
};

/// Decides what the last steps of lanes mean for their flights, and reports it. Finding a crossing costs a pack of
/// lanes little more than one.
template <class R, class S>
class StepJudge {
 public:
  explicit StepJudge(const BatchJob<S>& job) : job_(job) {}

  /// Reports crossings and ends of the steps of some lanes with sound numbers; returns those in which the flight ends.
  unsigned judge(const Lanes<R>& steps, unsigned lanes, unsigned accepted, const std::size_t* shots) {
    PHYSIM_ASSERT(lanes != 0 && (lanes & ~kAllLanes<R>) == 0 && (accepted & ~lanes) == 0);
    steps_ = &steps, lanes_ = lanes, accepted_ = accepted, shots_ = shots;
    const StepMarks<R> marks = step_marks(*job_.course, steps);
    dense_lanes(*job_.course, steps, judgement_.at);
    find_crossings<R>(*job_.course, mask_of_lanes<R>(lanes & accepted) & marks.finite, judgement_);
    const R taken = steps.count + steps.parts;
    unsigned ended = 0;
    each([&](int i) {
      verdict_[i] = verdict_on(*job_.course, steps, marks, i, is_accepted(i), judgement_.crossings[i]);
      if (!verdict_[i].ended) return;
      ended |= 1u << i;
      begin_end(i, static_cast<std::int64_t>(lane_of(taken, i)));
    });
    report_crossings();
    report_ends();
    return ended;
  }

 private:
  using W = Cast<double, R>;

  /// Calls f with each lane.
  PHYSIM_INLINE void each(const auto& f) const {
    for (unsigned left = lanes_; left != 0; left &= left - 1) f(__builtin_ctz(left));
  }
  [[nodiscard]] const Conditions<S>& conditions() const { return *job_.course->conditions; }
  [[nodiscard]] bool is_accepted(int i) const { return (accepted_ >> i & 1u) != 0; }

  /// A flight stays where a step began that was refused or went bad; else it continues to the verdict's place.
  [[nodiscard]] bool stays(int i) const { return !is_accepted(i) || verdict_[i].outcome == Outcome::non_finite; }

  [[nodiscard]] ShotResult& result_of(int i) const {
    return job_.results[job_.places == nullptr ? shots_[i] : job_.places[shots_[i]]];
  }

  void begin_end(int i, std::int64_t steps) {
    ShotResult& result = result_of(i);
    steps += stays(i) ? 0 : 1;
    const auto tries = static_cast<std::int64_t>(lane_of(steps_->tries, i));
    result.outcome = verdict_[i].outcome;
    PHYSIM_ASSERT(steps >= 0 && steps <= tries);
    result.cost = {steps, tries - steps, evaluations(conditions().fidelity, tries)};
  }

  /// Takes each number from the lanes. A State that has just been written in single numbers is copied in pairs, and
  /// such a read waits until both are in the cache.
  template <class P>
  void put_end(int i, const P& time, const State<P>& state) {
    const auto number = [i](const P& lanes) { return static_cast<double>(lane_of(lanes, i)); };
    const auto vector = [&](const Vec3<P>& lanes) { return Vec3d{number(lanes.x), number(lanes.y), number(lanes.z)}; };
    ShotResult& result = result_of(i);
    result.time = number(time);
    result.position = vector(state.x);
    result.velocity = vector(state.v);
  }

  /// The first crossing of every lane, the second, ...
  void report_crossings() {
    for (int rank = 0;; ++rank) {
      W theta(0.0);
      bool some = false;
      each([&](int i) {
        if (rank >= judgement_.crossings[i].count) return;
        set_lane(theta, i, judgement_.crossings[i].found[rank].theta);
        some = true;
      });
      if (!some) return;
      const W time = judgement_.at.time(theta);
      const State<W> state = judgement_.at.at_time(time);
      PHYSIM_ASSERT((job_.turns != nullptr) == turns(conditions().fidelity));
      const bool turning = job_.turns != nullptr;
      Turn<W> turned{};
      if (turning) turned = judgement_.at.turn_at_time(time);
      each([&](int i) {
        if (rank >= judgement_.crossings[i].count) return;
        const Found& found = judgement_.crossings[i].found[rank];
        RawEvent unwanted;
        RawEvent& event = job_.next_event != nullptr ? job_.next_event(job_.sink) : unwanted;
        event.shot = static_cast<std::uint32_t>(shots_[i]);
        event.index = static_cast<std::int16_t>(found.index);
        event.rising = found.rising;
        event.time = lane_of(time, i);
        copy_lane(state, i, event.state, 0);
        if (!verdict_[i].ended) return;
        put_end(i, time, state);  // of the last crossing, where the flight ends with one
        if (turning) copy_lane(turned, i, job_.turns[shots_[i]], 0);
      });
    }
  }

  void report_ends() {
    each([&](int i) {
      if (!verdict_[i].ended) return;
      const CrossingList& crossings = judgement_.crossings[i];
      const bool at_crossing = crossings.count > 0 && crossings.found[crossings.count - 1].theta == verdict_[i].theta;
      if (at_crossing && !stays(i)) return;
      const bool at_start = stays(i);  // else the verdict lets it take the whole step
      const Step<R>& step = steps_->step;
      put_end(i, at_start ? step.t : step.t_end, at_start ? step.start : step.end);
      if (job_.turns == nullptr) return;
      Turn<S> turn;
      copy_lane(at_start ? step.turn->start : step.turn->end, i, turn, 0);
      cast_numbers(turn, job_.turns[shots_[i]]);
    });
  }

  const BatchJob<S>& job_;
  Judgement<R> judgement_;
  Verdict verdict_[kLanes<R>];
  const Lanes<R>* steps_ = nullptr;
  unsigned lanes_ = 0, accepted_ = 0;
  const std::size_t* shots_ = nullptr;
};

/// Steps that need judging, copied from the lanes that took them: lanes with a fate that is known before wait here
/// until a pack has gathered.
template <class R, class S>
class JudgedSteps {
 public:
  JudgedSteps(const BatchJob<S>& job, StepJudge<R, S>& judge) : job_(job), judge_(judge) {}

  /// Takes in a lane's last step; one at a time of each flight, so that its crossings are reported in order.
  void add(const Lanes<R>& from, int lane, bool accepted, bool ends, std::size_t shot) {
    PHYSIM_ASSERT(lane >= 0 && lane < kLanes<R> && shot < job_.count);
    if (filled_ == kLanes<R> || (some_go_on_ && waits(shot))) settle();
    some_go_on_ = some_go_on_ || !ends;
    copy_step(*job_.course->conditions, from, lane, steps_, filled_,
              filled_ < touched_ ? job_.judged : job_.course->body);
    accepted_ |= (accepted ? 1u : 0u) << filled_;
    shot_[filled_] = shot;
    ++filled_;
  }

  /// Reports crossings and ends of all steps taken in; true when the flight of the latest has ended.
  bool settle() {
    if (filled_ == 0) return false;
    fill_untouched();
    const unsigned ended = judge_.judge(steps_, first_lanes(filled_), accepted_, shot_);
    const bool latest = (ended >> (filled_ - 1) & 1u) != 0;
    filled_ = 0;
    accepted_ = 0;
    some_go_on_ = false;
    return latest;
  }
  /// Reports what flights that continue have crossed.
  void settle_those_that_go_on() {
    if (some_go_on_) settle();
  }

 private:
  [[nodiscard]] bool waits(std::size_t shot) const {
    for (int i = 0; i < filled_; ++i)
      if (shot_[i] == shot) return true;
    return false;
  }

  /// Lanes that never held a step repeat one, so that they hold sound numbers: what of them tables are read by.
  void fill_untouched() {
    for (; touched_ < kLanes<R>; ++touched_)
      if (touched_ >= filled_) copy_step(*job_.course->conditions, steps_, 0, steps_, touched_, job_.course->body);
  }

  const BatchJob<S>& job_;
  StepJudge<R, S>& judge_;
  Lanes<R> steps_{};
  std::size_t shot_[kLanes<R>];
  unsigned accepted_ = 0;  // bit i: lane i's step was
  int filled_ = 0;
  bool some_go_on_ = false;  // some step here is of a flight that continues: its shot may come again
  int touched_ = 0;          // lanes before it have held a step
};

/// How long lanes wait for the others of their set after their flights end. Flights that take about as many steps are
/// launched and judged as whole packs; where too much waiting comes of it, each lane takes the next shot at once.
class Patience {
 public:
  explicit Patience(bool lasts) : left_(lasts ? kAtFirst : -1) {}
  [[nodiscard]] PHYSIM_INLINE bool lasts() const { return left_ >= 0; }
  /// Counts a step: `flying` lanes flew it, and `waiting` lanes waited.
  PHYSIM_INLINE void pass(int flying, int waiting) {
    if (lasts()) left_ = std::min(left_ + flying - kFlyingForEach * waiting, kMost);
  }

 private:
  // Moving a single flight in and out of a lane takes as long as one or two of its steps.
  static constexpr int kFlyingForEach = 12;  // lanes for one that waits
  static constexpr int kAtFirst = 32 * kFlyingForEach;
  static constexpr int kMost = 1 << 20;  // the most that flying without waiting counts: it is spent within a part
  int left_;
};

/// What the sets of lanes of a job share.
template <class R, class S>
struct Flights {
  explicit Flights(const BatchJob<S>& job)
      // Behind a stop a lane does not take the step again that it has taken.
      : shots(job), ready(job, shots), judge(job), judged(job, judge), patience(!has_stops(*job.course->conditions)) {}

  ShotsToFly<R, S> shots;
  ReadyShots<R, S> ready;
  StepJudge<R, S> judge;
  JudgedSteps<R, S> judged;
  Patience patience;
};

/// Flights in a set of lanes.
template <class R, class S>
class LaneSet {
 public:
  /// False where no shot is left.
  bool begin(const BatchJob<S>& job, Flights<R, S>& all) {
    job_ = &job;
    march.set_course(*job.course);
    all.shots.put_common(march.lanes.body);
    return launch(all);
  }

  /// Continues from a step tried: flights that end make room for the next shots. False when all have ended.
  bool go_on(const MaskOf<R>& accepted, Flights<R, S>& all) {
    const Conditions<S>& c = *job_->course->conditions;
    const WatchList& watch = job_->course->watch;
    const unsigned accepts = lane_bits(accepted);
    const Detected found = watch_.pass(c, watch, march.lanes, last_slope(c.fidelity), accepts);
    const Attention attention = needs_attention(*job_->course, march.lanes, accepts, found);
    if ((attention.special & flying_) != 0) hand_over(attention, accepts, all);
    if (flying_ == 0 && all.patience.lasts()) {
      judge_waiting(all);
      return launch(all);
    }
    march.accept(flying_ == kAllLanes<R> ? accepted : accepted & mask_of_lanes<R>(flying_));
    if (has_stops(c)) watch_.begin(c, watch, march.lanes);  // behind a stop a body and its forces are others
    if (all.shots.are_left()) all.patience.pass(__builtin_popcount(flying_), __builtin_popcount(idle_));
    if (idle_ != 0 && !all.patience.lasts()) take_each(all);
    if (flying_ != kAllLanes<R>) hold_still();
    return flying_ != 0;
  }

  March<R> march;

 private:
  /// Begins with the next shots in all lanes; false where none is left.
  bool launch(Flights<R, S>& all) {
    PHYSIM_ASSERT(flying_ == 0 && waiting_ == 0);
    std::size_t first = 0;
    const int filled = all.shots.launch(march, watch_, first);
    for (int lane = 0; lane < filled; ++lane) shot_[lane] = first + static_cast<std::size_t>(lane);
    flying_ = first_lanes(filled);
    idle_ = 0;
    return filled > 0;
  }

  /// Idle lanes take the next shots, each alone.
  void take_each(Flights<R, S>& all) {
    PHYSIM_ASSERT((idle_ & flying_) == 0 && (waiting_ & ~idle_) == 0);
    judge_waiting(all);
    for (; idle_ != 0; idle_ &= idle_ - 1) {
      const int lane = __builtin_ctz(idle_);
      if (all.ready.take(march.lanes, watch_, lane, shot_[lane])) flying_ |= 1u << lane;
    }
  }

  /// Hands steps over for judgement. Steps may stay where they are if the flight surely ends; what is not sure before
  /// is judged at once.
  void hand_over(const Attention& attention, unsigned accepted, Flights<R, S>& all) {
    PHYSIM_ASSERT(job_ != nullptr && flying_ != 0);
    unsigned ended = attention.surely_ends & flying_;
    const unsigned sure = ended | attention.surely_goes_on;
    unsigned left = attention.special & flying_;
    if (all.patience.lasts()) waiting_ |= ended, left &= ~ended;
    for (; left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      all.judged.add(march.lanes, lane, (accepted >> lane & 1u) != 0, (ended >> lane & 1u) != 0, shot_[lane]);
      if ((sure >> lane & 1u) == 0 && all.judged.settle()) ended |= 1u << lane;
    }
    flying_ &= ~ended;
    idle_ |= ended;
  }

  /// Judges the last steps of the lanes that wait.
  void judge_waiting(Flights<R, S>& all) {
    if (waiting_ == 0) return;
    all.judged.settle_those_that_go_on();
    const unsigned ended = all.judge.judge(march.lanes, waiting_, waiting_, shot_);
    PHYSIM_ASSERT(ended == waiting_);
    static_cast<void>(ended);
    waiting_ = 0;
  }

  /// Lanes that do not fly take their last step once more when the others take the next one: it stays unchanged.
  void hold_still() {
    PHYSIM_ASSERT(flying_ != kAllLanes<R>);
    Lanes<R>& l = march.lanes;
    const MaskOf<R> still = mask_of_lanes<R>(~flying_);
    l.control.h = select(still, l.step.h, l.control.h);
    if (steps_itself(job_->course->conditions->fidelity)) l.cut = select(still, l.step.h, l.cut);
    l.tries = select(still, l.tries - R(S(1)), l.tries);
  }

  const BatchJob<S>* job_ = nullptr;
  StandingWatch<R> watch_;
  std::size_t shot_[kLanes<R>] = {};
  unsigned flying_ = 0;   // bit i: lane i has a shot
  unsigned idle_ = 0;     // lane i's flight is over, and it may take the next one
  unsigned waiting_ = 0;  // lane i's flight is over, and its last step is to be judged
};

/// Whether some lane's step may have read air above the lowest layer. Its density is NaN then, and so are the step's
/// end, its error or its last slope. Above the first border steps are cut by what lies behind it.
template <class R, class S>
PHYSIM_INLINE bool some_left_low_air(const Conditions<S>& c, const Lanes<R>& l) {
  const Step<R>& s = l.step;
  const Vec3<R>& slope = s.slope[last_slope(c.fidelity)].v;
  auto stays = is_finite(s.end) & is_finite(slope.x + (slope.y + slope.z)) & (altitude(c, s.end.x) < R(c.air.base[1]));
  if (steps_itself(c.fidelity)) stays = stays & (s.error == s.error);
  return !all(stays);
}

/// Flies all shots of a job in up to kSets sets of lanes side by side.
template <class R, int kSets, class S>
void fly_lanes(const BatchJob<S>& job) {
  static_assert(kSets <= kMostSets);
  PHYSIM_ASSERT(job.course != nullptr && job.results != nullptr);
  Flights<R, S> all(job);
  const TakeSteps<R, S> take = steps_of<R>(*job.course->conditions);
  LaneSet<R, S> sets[kSets];
  LaneSet<R, S>* flying[kSets];
  int count = 0;
  for (LaneSet<R, S>& set : sets)
    if (set.begin(job, all)) flying[count++] = &set;
  while (count > 0) {
    March<R>* marches[kSets];
    MaskOf<R> accepted[kSets];
    for (int i = 0; i < count; ++i) marches[i] = &flying[i]->march;
    bool stayed_low = false;
    const auto take_here = [&](const Conditions<S>& c, const FlyerSet<R>& w, S relative, S absolute)
                               PHYSIM_INLINE_LAMBDA { stayed_low = take(c, w, relative, absolute); };
    March<R>::try_steps(marches, count, accepted, take_here);
    for (int i = 0; i < count && job.left_low_air != nullptr && !stayed_low; ++i)
      if (some_left_low_air(*job.course->conditions, marches[i]->lanes)) return void(*job.left_low_air = true);
    int left = 0;
    for (int i = 0; i < count; ++i)
      if (flying[i]->go_on(accepted[i], all)) flying[left++] = flying[i];
    count = left;
  }
  all.judged.settle();
}

PHYSIM_ISA_END
