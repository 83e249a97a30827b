// The batch loop: all lanes step together, each at its own time; a lane whose flight ends takes the next shot.
#pragma once

#include "base/assert.hpp"
#include "flight/batch_job.hpp"
#include "model/sight.hpp"

PHYSIM_ISA_BEGIN

/// A column's numbers of the shots from `first` on; lanes without a shot repeat the last one.
template <class W>
PHYSIM_INLINE W take_column(const NumberColumn& column, std::size_t first, int filled) {
  if (column.of_shots == nullptr) return W(column.common);
  const double* from = column.of_shots + first;
  if constexpr (kLanes<W> == 1) {
    return *from;
  } else {
    if (filled == kLanes<W>) return W::load(from);
    double padded[kLanes<W>];
    for (int lane = 0; lane < kLanes<W>; ++lane) padded[lane] = from[lane < filled ? lane : filled - 1];
    return W::load(padded);
  }
}

/// put_launch() (prepare/launch.hpp) for a pack of launches without rail and spin.
template <class R>
void put_launches(const LaunchSource& from, std::size_t first, int filled, Body<R>& into) {
  using W = Cast<double, R>;
  using S = ScalarOf<R>;
  const auto take = [&](const NumberColumn& column) { return take_column<W>(column, first, filled); };
  const SightAxes<W> axes(sincos_of(take(from.azimuth)), sincos_of(W(from.look_angle)), sincos_of(W(from.cant)));
  const Vec3<W> v = axes.bore(sincos_of(take(from.elevation) - W(from.look_angle))) * take(from.speed);
  into.launch.x = {cast<S>(take(from.x)), cast<S>(take(from.y)), cast<S>(take(from.z))};
  cast_numbers(v, into.launch.v);
  cast_numbers(axes.right, into.plane);
  cast_numbers(axes.forward, into.sight);
  if (from.half_areas) into.half_area_per_mass = cast<S>(take({from.half_areas, 0}));
}

/// What prepare_air_numbers() (model/standard_atmosphere.hpp) gives, for a pack of shots with air of their own.
template <class W>
PHYSIM_NOINLINE void put_air(const WeatherSource& from, std::size_t first, int filled, AirNumbers<W>& air) {
  const auto take = [&](const NumberColumn& column) { return take_column<W>(column, first, filled); };
  if (!from.has_station || from.place.model != AirModel::isa) {
    const double* no_station = numbers(*from.no_station);
    for (unsigned i = 0; i < kNumbers<AirNumbers>; ++i) numbers(air)[i] = W(no_station[i]);
  }
  if (from.has_station)
    put_air(from.place, Readings<W>{take(from.temperature), take(from.pressure), take(from.humidity)}, air);
  if (from.has_density) air.density = take(from.density);
  if (from.has_sound_speed) air.per_sound_speed = W(from.per_sound_speed);
}

template <class R, class S>
void put_weather(const WeatherSource& from, const Conditions<S>& c, std::size_t first, int filled, Body<R>& into) {
  using W = Cast<double, R>;
  const auto take = [&](const NumberColumn& column) { return cast<S>(take_column<W>(column, first, filled)); };
  if (c.has_own_wind) into.wind = {take(from.wind_x), take(from.wind_y), take(from.wind_z)};
  if (!c.has_own_air) return;
  if constexpr (std::is_same_v<W, R>) {
    put_air(from, first, filled, into.air);
  } else {
    AirNumbers<W> air;
    put_air(from, first, filled, air);
    constexpr unsigned kLow = kBodyNumber.air.lapse[0] - kBodyNumber.air.density;
    NumberRuns wanted;  // layers that are not stay what the batch has in their place: no numbers
    wanted.add(0, from.place.layers == kAirLayers ? kNumbers<AirNumbers> : kLow);
    cast_numbers(air, into.air, wanted);
  }
}

/// Shots waiting to enter a lane, prepared a pack at a time: the first slopes of a whole pack cost little more than
/// one.
template <class R, class S>
class ReadyShots {
 public:
  explicit ReadyShots(const BatchJob<S>& job) : job_(job), march_(*job.course) {
    for (int lane = 0; lane < kLanes<R>; ++lane) put_lane(numbers(*job.common), ready_.body, lane, job.course->body);
  }

  /// Puts the next shot into a lane; false where none is left.
  bool take(Lanes<R>& into, StandingWatch<R>& watch, int lane, std::size_t& shot) {
    PHYSIM_ASSERT(used_ <= filled_ && filled_ <= kLanes<R>);
    if (used_ == filled_ && !refill()) return false;
    copy_start(*job_.course, ready_, used_, into, lane,
               job_.own);  // what shots have in common is there since take_all()
    watch.take(watch_, used_, lane);
    shot = next_ - static_cast<std::size_t>(filled_ - used_);
    PHYSIM_ASSERT(shot < job_.count);
    ++used_;
    return true;
  }

  /// Fills all lanes at the start; bit i of the result: lane i has a shot.
  unsigned take_all(Lanes<R>& into, StandingWatch<R>& watch, std::size_t* shots) {
    const std::size_t first = next_;
    if (!refill()) return 0;
    into = ready_;
    watch = watch_;
    for (int lane = 0; lane < filled_; ++lane) shots[lane] = first + static_cast<std::size_t>(lane);
    used_ = filled_;
    return static_cast<unsigned>((std::size_t(1) << filled_) - 1);
  }

 private:
  bool refill() {
    PHYSIM_ASSERT(next_ <= job_.count && used_ == filled_);
    const std::size_t left = job_.count - next_;
    if (left == 0) return false;
    filled_ = left < std::size_t(kLanes<R>) ? static_cast<int>(left) : kLanes<R>;
    // Unused lanes repeat the last shot, so that they hold sound numbers.
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      const std::size_t shot = next_ + static_cast<std::size_t>(lane < filled_ ? lane : filled_ - 1);
      if (job_.launches == nullptr) put_lane(job_.own_numbers + shot * job_.own_stride, ready_.body, lane, job_.own);
      const auto take_rotor = [&](auto& rotor) { put_lane(job_.rotors[shot], rotor, lane); };
      for_rotors(job_.course->conditions->fidelity, take_rotor, ready_);
    }
    if (job_.launches != nullptr) put_launches(*job_.launches, next_, filled_, ready_.body);
    if (job_.launches != nullptr && job_.launches->weather != nullptr)
      put_weather(*job_.launches->weather, *job_.course->conditions, next_, filled_, ready_.body);
    march_.launch();
    watch_.begin(*job_.course->conditions, job_.course->watch, ready_);
    next_ += static_cast<std::size_t>(filled_);
    used_ = 0;
    return true;
  }

  const BatchJob<S>& job_;
  March<R> march_;
  Lanes<R>& ready_ = march_.lanes;
  StandingWatch<R> watch_;  // at their launch
  std::size_t next_ = 0;    // first shot not yet prepared
  int filled_ = 0;
  int used_ = 0;
};

/// Steps that need judging, copied from the lanes that took them. Finding a crossing costs a pack of lanes little more
/// than one, so lanes whose fate is known before wait here until a pack has gathered.
template <class R, class S>
class JudgedSteps {
 public:
  explicit JudgedSteps(const BatchJob<S>& job) : job_(job) {}

  /// Takes in a lane's last step; one at a time of each flight, so that its crossings are reported in order.
  void add(const Lanes<R>& from, int lane, bool accepted, bool ends, std::size_t shot) {
    PHYSIM_ASSERT(lane >= 0 && lane < kLanes<R> && shot < job_.count);
    if (filled_ == kLanes<R> || (some_go_on_ && waits(shot))) settle();
    some_go_on_ = some_go_on_ || !ends;
    copy_step(conditions(), from, lane, steps_, filled_, filled_ < touched_ ? job_.judged : job_.course->body);
    accepted_[filled_] = accepted;
    shot_[filled_] = shot;
    ++filled_;
  }

  /// Reports crossings and ends of all steps taken in; true when the flight of the latest has ended.
  bool settle() {
    if (filled_ == 0) return false;
    fill_untouched();
    const R zero(S(0)), one(S(1));
    R sound = zero;
    for (int i = 0; i < filled_; ++i) set_lane(sound, i, accepted_[i] ? S(1) : S(0));
    const StepMarks<R> marks = step_marks(*job_.course, steps_);
    dense_lanes(*job_.course, steps_, judgement_.at);
    find_crossings<R>(*job_.course, (sound == one) & marks.finite, judgement_);
    bool ended = false;
    for (int i = 0; i < filled_; ++i) {
      verdict_[i] = verdict_on(*job_.course, steps_, marks, i, accepted_[i], judgement_.crossings[i]);
      ended = verdict_[i].ended;
      if (ended) begin_end(i);
    }
    report_crossings();
    report_ends();
    filled_ = 0;
    some_go_on_ = false;
    return ended;
  }

 private:
  using W = Cast<double, R>;

  [[nodiscard]] const Conditions<S>& conditions() const { return *job_.course->conditions; }

  [[nodiscard]] bool waits(std::size_t shot) const {
    for (int i = 0; i < filled_; ++i)
      if (shot_[i] == shot) return true;
    return false;
  }

  /// Lanes that never held a step repeat one, so that they hold sound numbers: what of them tables are read by.
  void fill_untouched() {
    for (; touched_ < kLanes<R>; ++touched_)
      if (touched_ >= filled_) copy_step(conditions(), steps_, 0, steps_, touched_, job_.course->body);
  }

  /// A flight stays where a step began that was refused or went bad; else it goes on to the verdict's place.
  [[nodiscard]] bool stays(int i) const { return !accepted_[i] || verdict_[i].outcome == Outcome::non_finite; }

  [[nodiscard]] ShotResult& result_of(int i) const {
    return job_.results[job_.places == nullptr ? shot_[i] : job_.places[shot_[i]]];
  }

  void begin_end(int i) {
    ShotResult& result = result_of(i);
    const auto steps = static_cast<std::int64_t>(lane_of(steps_.count + steps_.parts, i)) + (stays(i) ? 0 : 1);
    const auto tries = static_cast<std::int64_t>(lane_of(steps_.tries, i));
    result.outcome = verdict_[i].outcome;
    PHYSIM_ASSERT(steps >= 0 && steps <= tries);
    result.cost = {steps, tries - steps, evaluations(conditions().fidelity, tries)};
  }

  void put_end(int i, double time, const State<double>& state) {
    ShotResult& result = result_of(i);
    result.time = time;
    result.position = state.x;
    result.velocity = state.v;
  }

  /// The first crossing of every lane, the second, ...
  void report_crossings() {
    for (int rank = 0;; ++rank) {
      W theta(0.0);
      bool some = false;
      for (int i = 0; i < filled_; ++i) {
        if (rank >= judgement_.crossings[i].count) continue;
        set_lane(theta, i, judgement_.crossings[i].found[rank].theta);
        some = true;
      }
      if (!some) return;
      const W time = judgement_.at.time(theta);
      const State<W> state = judgement_.at.at_time(time);
      PHYSIM_ASSERT((job_.turns != nullptr) == turns(conditions().fidelity));
      const bool turning = job_.turns != nullptr;
      Turn<W> turned{};
      if (turning) turned = judgement_.at.turn_at_time(time);
      for (int i = 0; i < filled_; ++i) {
        if (rank >= judgement_.crossings[i].count) continue;
        const Found& found = judgement_.crossings[i].found[rank];
        RawEvent event{std::uint32_t(shot_[i]), std::int16_t(found.index), found.rising, lane_of(time, i), {}};
        copy_lane(state, i, event.state, 0);
        if (job_.emit != nullptr) job_.emit(job_.sink, event);
        if (!verdict_[i].ended) continue;
        put_end(i, event.time, event.state);  // of the last crossing, where the flight ends with one
        if (turning) copy_lane(turned, i, job_.turns[shot_[i]], 0);
      }
    }
  }

  void report_ends() {
    for (int i = 0; i < filled_; ++i) {
      if (!verdict_[i].ended) continue;
      const CrossingList& crossings = judgement_.crossings[i];
      const bool at_crossing = crossings.count > 0 && crossings.found[crossings.count - 1].theta == verdict_[i].theta;
      if (at_crossing && !stays(i)) continue;
      const bool at_start = stays(i);  // else the verdict lets it take the whole step
      const double time = static_cast<double>(lane_of(at_start ? steps_.step.t : steps_.step.t_end, i));
      State<S> state;
      copy_lane(at_start ? steps_.step.start : steps_.step.end, i, state, 0);
      put_end(i, time, {vec_cast<double>(state.x), vec_cast<double>(state.v)});
      if (job_.turns == nullptr) continue;
      Turn<S> turn;
      copy_lane(at_start ? steps_.step.turn->start : steps_.step.turn->end, i, turn, 0);
      cast_numbers(turn, job_.turns[shot_[i]]);
    }
  }

  const BatchJob<S>& job_;
  Lanes<R> steps_{};
  Judgement<R> judgement_;
  bool accepted_[kLanes<R>];
  std::size_t shot_[kLanes<R>];
  Verdict verdict_[kLanes<R>];
  int filled_ = 0;
  bool some_go_on_ = false;  // some step here is of a flight that goes on: its shot may come again
  int touched_ = 0;          // lanes before it have held a step
};

/// Flights in a set of lanes.
template <class R, class S>
class LaneSet {
 public:
  /// False where no shot is left.
  bool begin(const BatchJob<S>& job, ReadyShots<R, S>& ready) {
    job_ = &job;
    march = March<R>(*job.course);
    flying_ = ready.take_all(march.lanes, watch_, shot_);
    return flying_ != 0;
  }

  /// Goes on from a step tried: flights that end make room for the next shots. False when all have ended.
  bool go_on(const MaskOf<R>& accepted, ReadyShots<R, S>& ready, JudgedSteps<R, S>& judged) {
    const Conditions<S>& c = *job_->course->conditions;
    const WatchList& watch = job_->course->watch;
    const unsigned accepts = lane_bits(accepted);
    const Detected found = watch_.pass(c, watch, march.lanes, last_slope(c.fidelity), accepts);
    const Attention attention = needs_attention(*job_->course, march.lanes, accepts, found);
    unsigned ended = 0;
    if (attention.special != 0) ended = hand_over(attention, accepts, judged);
    march.accept(accepted);
    if (has_stops(c)) watch_.begin(c, watch, march.lanes);  // behind a stop a body and its forces are others
    for (; ended != 0; ended &= ended - 1) {
      const int lane = __builtin_ctz(ended);
      if (!ready.take(march.lanes, watch_, lane, shot_[lane])) flying_ &= ~(1u << lane);
    }
    return flying_ != 0;
  }

  March<R> march;

 private:
  /// Hands steps over for judgement; returns the lanes whose flight ends. What is not sure before is judged at once.
  unsigned hand_over(const Attention& attention, unsigned accepted, JudgedSteps<R, S>& judged) {
    PHYSIM_ASSERT(job_ != nullptr && flying_ != 0);
    unsigned ended = attention.surely_ends & flying_;
    const unsigned sure = ended | attention.surely_goes_on;
    for (unsigned left = attention.special & flying_; left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      judged.add(march.lanes, lane, (accepted >> lane & 1u) != 0, (ended >> lane & 1u) != 0, shot_[lane]);
      if ((sure >> lane & 1u) == 0 && judged.settle()) ended |= 1u << lane;
    }
    return ended;
  }

  const BatchJob<S>* job_ = nullptr;
  StandingWatch<R> watch_;
  std::size_t shot_[kLanes<R>] = {};
  unsigned flying_ = 0;  // bit i: lane i has a shot
};

/// Whether some lane's step may have asked for air above the lowest layer, whose density is no number then: so are the
/// step's end, its error or its last slope. Above the first border steps are cut by what lies behind it.
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
  ReadyShots<R, S> ready(job);
  JudgedSteps<R, S> judged(job);
  LaneSet<R, S> sets[kSets];
  LaneSet<R, S>* flying[kSets];
  int count = 0;
  for (LaneSet<R, S>& set : sets)
    if (set.begin(job, ready)) flying[count++] = &set;
  while (count > 0) {
    March<R>* marches[kSets];
    MaskOf<R> accepted[kSets];
    for (int i = 0; i < count; ++i) marches[i] = &flying[i]->march;
    March<R>::try_steps(marches, count, accepted);
    for (int i = 0; i < count && job.left_low_air != nullptr; ++i)
      if (some_left_low_air(*job.course->conditions, marches[i]->lanes)) return void(*job.left_low_air = true);
    int left = 0;
    for (int i = 0; i < count; ++i)
      if (flying[i]->go_on(accepted[i], ready, judged)) flying[left++] = flying[i];
    count = left;
  }
  judged.settle();
}

PHYSIM_ISA_END
