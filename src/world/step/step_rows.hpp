// The world's loop over rows, pack by pack.
#pragma once

#include "base/assert.hpp"
#include "solve/judge.hpp"
#include "world/step/world_job.hpp"

PHYSIM_ISA_BEGIN

template <class R, class S>
PHYSIM_INLINE R load(const S* column, std::uint32_t row) {
  return R::load(column + row);
}
template <class R, class S>
PHYSIM_INLINE Vec3<R> load_vector(S* const (&column)[3], std::uint32_t row) {
  return {load<R>(column[0], row), load<R>(column[1], row), load<R>(column[2], row)};
}
template <class R, class S>
PHYSIM_INLINE void store_vector(const Vec3<R>& v, S* const (&column)[3], std::uint32_t row) {
  v.x.store(column[0] + row), v.y.store(column[1] + row), v.z.store(column[2] + row);
}
template <class R, class S>
PHYSIM_INLINE void stream_vector(const Vec3<R>& v, S* const (&column)[3], std::uint32_t row) {
  v.x.stream(column[0] + row), v.y.stream(column[1] + row), v.z.stream(column[2] + row);
}
/// The new positions of a pack of rows; finish_streams() where they are streamed.
template <class R, class S>
PHYSIM_INLINE void put_positions(const WorldJob<S>& job, const Vec3<R>& x, std::uint32_t row) {
  if (job.stream)
    stream_vector(x, job.columns.previous, row);
  else
    store_vector(x, job.columns.previous, row);
}

template <class R, class S>
PHYSIM_INLINE State<R> load_state(const WorldJob<S>& job, std::uint32_t row) {
  return {load_vector<R>(job.columns.position, row), load_vector<R>(job.columns.velocity, row)};
}

/// Lanes that hold rows, as bits.
template <class R>
PHYSIM_INLINE unsigned filled_lanes(std::uint32_t rows) {
  return rows >= unsigned(kLanes<R>) ? ~0u : (1u << rows) - 1;
}

/// The velocity of a pack of rows of which the horizontal part stays as it stands.
template <class R, class S>
PHYSIM_INLINE void put_vertical(const WorldJob<S>& job, const Vec3<R>& v, std::uint32_t row) {
  PHYSIM_ASSERT(
      (lane_bits((load<R>(job.columns.velocity[0], row) != v.x) | (load<R>(job.columns.velocity[2], row) != v.z)) &
       filled_lanes<R>(job.last - row)) == 0);
  v.y.store(job.columns.velocity[1] + row);
}

/// 0, 1, 2, ...
template <class R>
PHYSIM_INLINE R lane_numbers() {
  R numbers;
  for (int lane = 0; lane < kLanes<R>; ++lane) set_lane(numbers, lane, static_cast<ScalarOf<R>>(lane));
  return numbers;
}

/// What a step did to a pack of rows.
template <class R>
struct Moved {
  State<R> start;
  State<R> end;
  Vec3<R> carried;  // the original loop's accelerations for the next step
  MaskOf<R> lost;   // lanes that did not get through
};

/// What the clocks of rows show at the end of the step [s].
template <class R, class S>
PHYSIM_INLINE R end_on_clock(const WorldJob<S>& job, std::uint32_t row) {
  PHYSIM_ASSERT(job.clocked);
  const R steps = R(job.now) - load<R>(job.columns.born, row);
  return load<R>(job.columns.offset, row) + (steps + S(1)) * job.h;
}

/// Rows on a rail, and rows with a force or a piece of a motor's table that ends in this step.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> stop_here(const WorldJob<S>& job, const Conditions<S>& c, std::uint32_t row) {
  const auto field = [&](unsigned number) { return load<R>(job.columns.field[number], row); };
  const R t_end = end_on_clock<R>(job, row);
  MaskOf<R> stops = t_end != t_end;
  if (c.has_force_end) stops = field(kBodyNumber.applied_until) <= t_end;
  if (!c.has_motor && !c.has_rail) return stops;
  return stops | (field(kBodyNumber.burn.end) <= t_end) | (field(kBodyNumber.rail_phase) < constant<R>(kOffRail));
}

/// Rows in which any other watched number crosses its value from the start of the step to its end. Behind a call: few
/// worlds watch some.
template <class R, class S>
PHYSIM_NOINLINE void crosses_watched(const WorldJob<S>& job, const Conditions<S>& c, const State<R>& start,
                                     const State<R>& end, MaskOf<R>& found) {
  const Body<R> none{};  // numbers of worlds are those of the state
  const R t(S(0));
  const WatchList& watch = job.course->watch;
  for (int i = 0; i < watch.count; ++i) {
    if (is_seen_by_watchdog(watch.item[i])) continue;
    const EventSpec& spec = watch.item[i].spec;
    found =
        found | crosses(spec.direction, watched_value(c, none, spec, t, start), watched_value(c, none, spec, t, end));
  }
}

/// Rows that may have come near a thing of the scene: they have flown as far as was clear about them. Nothing of a step
/// is farther from its start than its end is, as rounded, and what its velocity changes by takes it, where that changes
/// one way.
template <class S, class M>
PHYSIM_INLINE auto comes_near(const WorldJob<S>& job, const M& m, std::uint32_t row) {
  using R = decltype(m.end.x.x);
  const Vec3<R> change = m.end.v - m.start.v;
  const R flown = length(m.end.x - m.start.x) + (abs(change.x) + abs(change.y) + abs(change.z)) * (S(1.5) * job.h);
  const R clear = load<R>(job.columns.clear, row) - flown;
  clear.store(job.columns.clear + row);
  return !(clear > R(S(0)));
}

/// Rows that may come to where something restless is: the box about their ends, larger by their radius, by as much
/// as the path may be beside its chord, and by what places are rounded to. Behind a call: few worlds have such things.
template <class R, class S>
PHYSIM_NOINLINE void meets_restless(const WorldJob<S>& job, const State<R>& start, const State<R>& end,
                                    MaskOf<R>& found) {
  constexpr S kRounding = 16 * std::numeric_limits<S>::epsilon();
  const auto sum_of = [](const Vec3<R>& v) PHYSIM_INLINE_LAMBDA { return abs(v.x) + abs(v.y) + abs(v.z); };
  const R beside = beside_chord(start.x, start.v, end.x, end.v, job.h);
  const R off = (beside + R(job.radius)) * R(S(1) + kRounding) + (sum_of(start.x) + sum_of(end.x)) * R(kRounding);
  const Vec3<R> about{off, off, off};
  const Vec3<R> low = Vec3<R>{min(start.x.x, end.x.x), min(start.x.y, end.x.y), min(start.x.z, end.x.z)} - about;
  const Vec3<R> high = Vec3<R>{max(start.x.x, end.x.x), max(start.x.y, end.x.y), max(start.x.z, end.x.z)} + about;
  const RestlessBoxes<S>& boxes = *job.restless;
  // A step with a NaN is away from nothing.
  const auto is_away = [&](unsigned i) PHYSIM_INLINE_LAMBDA {
    const Vec3<S>&from = boxes.low[i], &to = boxes.high[i];
    const MaskOf<R> x = (low.x > R(to.x)) | (high.x < R(from.x)), y = (low.y > R(to.y)) | (high.y < R(from.y));
    const MaskOf<R> z = (low.z > R(to.z)) | (high.z < R(from.z));
    return x | y | z;
  };
  MaskOf<R> away = is_away(0);
  if (all(away)) return;
  MaskOf<R> of_each = is_away(1);
  for (unsigned i = 2; i < boxes.count; ++i) of_each = of_each & is_away(i);
  found = found | !(away | of_each);
}

/// Rows that need a closer look where the watchdog is a simple one: low, slow, or no numbers.
template <class S, class M>
PHYSIM_INLINE auto plainly_noteworthy(const Watchdog<S>& w, const Conditions<S>& c, const M& m) {
  using R = decltype(m.end.x.x);
  const R speed_squared = length_squared(m.end.v);
  // What is not finite somewhere is not finite in this sum.
  const R sum = (m.end.x.x + m.end.x.y) + (m.end.x.z + speed_squared);
  return (!(height(c, m.end.x) > R(w.floor))) | (!is_finite(sum)) | (speed_squared < R(w.slowest * w.slowest));
}

/// What may have happened to rows beside that: they came down and rose again, were at their highest, or left where they
/// may be. Further watched numbers and stops are not looked at.
template <class S, class M>
PHYSIM_INLINE auto further_noteworthy(const WorldJob<S>& job, const Conditions<S>& c, const M& m, std::uint32_t row) {
  using R = decltype(m.end.x.x);
  const Watchdog<S>& w = job.watchdog;
  const R zero(S(0));
  const R climb = climb_rate(c, m.start);
  const R climb_later = climb_rate(c, m.end);
  // A step that sinks and rises again may have touched the ground in between; one that does not rise from where the
  // ground is touches it as it begins.
  const MaskOf<R> is_low = !(height(c, m.start.x) > R(w.floor));
  MaskOf<R> found = ((climb < zero) & (climb_later > zero)) | ((climb <= zero) & is_low);
  if (w.apex) found = found | ((climb > zero) & (climb_later <= zero));
  if (job.launched)
    found = found | (length_squared(m.end.x - load_vector<R>(job.columns.launch, row)) > R(w.farthest * w.farthest));
  if (w.box)
    found = found | (m.end.x.x < R(w.low.x)) | (m.end.x.x > R(w.high.x)) | (m.end.x.y < R(w.low.y)) |
            (m.end.x.y > R(w.high.y)) | (m.end.x.z < R(w.low.z)) | (m.end.x.z > R(w.high.z));
  return found;
}

/// Rows that need a closer look: something may have happened to them inside the step. `m` has a start and an end. A
/// closer look at a row to which nothing happened changes nothing, so the tests are as few as can be.
template <class S, class M>
PHYSIM_INLINE auto noteworthy(const WorldJob<S>& job, const Conditions<S>& c, const M& m, std::uint32_t row) {
  using R = decltype(m.end.x.x);
  const Watchdog<S>& w = job.watchdog;
  MaskOf<R> found = plainly_noteworthy(w, c, m);
  if (has_stops(c)) found = found | stop_here<R>(job, c, row);
  if (w.simple) return found;
  if (w.watched) crosses_watched(job, *job.course->conditions, State<R>(m.start), State<R>(m.end), found);
  return found | further_noteworthy(job, c, m, row);
}

/// One of a body's numbers.
template <class R, class S>
PHYSIM_INLINE R load_field(const WorldJob<S>& job, std::size_t field, std::uint32_t row) {
  return load<R>(job.columns.field[field], row & job.field_masks[field]);
}
template <class R, class S>
PHYSIM_INLINE void load_body(const WorldJob<S>& job, std::uint32_t row, Body<R>& b) {
  PHYSIM_ASSERT(job.field_count <= kNumbers<Body>);
  R* number = numbers(b);
  for (unsigned i = 0; i < job.field_count; ++i) number[job.fields[i]] = load_field<R>(job, job.fields[i], row);
}

/// A part of a body, each number given by `read`; unrolled so that it stays in registers.
template <template <class> class Part, class R, class Read>
PHYSIM_INLINE void read_part(const Read& read, Body<R>& b) {
  constexpr unsigned kFirst = BodyParts::first(BodyParts::index<Part>());
  R* number = numbers(static_cast<Part<R>&>(b));
  const auto read_each = [&]<unsigned... I>(std::integer_sequence<unsigned, I...>) PHYSIM_INLINE_LAMBDA {
    ((number[I] = read(kFirst + I)), ...);
  };
  read_each(std::make_integer_sequence<unsigned, kNumbers<Part>>());
}

/// A structure of a pack of rows, from its columns or into them.
template <template <class> class Struct, class R, class S, std::size_t N>
PHYSIM_INLINE void load_numbers(S* const (&columns)[N], std::uint32_t row, Struct<R>& into) {
  static_assert(N == kNumbers<Struct>);
  for (std::size_t i = 0; i < N; ++i) numbers(into)[i] = load<R>(columns[i], row);
}
template <template <class> class Struct, class R, class S, std::size_t N>
PHYSIM_INLINE void store_numbers(const Struct<R>& from, S* const (&columns)[N], std::uint32_t row) {
  static_assert(N == kNumbers<Struct>);
  for (std::size_t i = 0; i < N; ++i) numbers(from)[i].store(columns[i] + row);
}
/// Lets a pack of bodies feel the pushes of emitters for the whole step; returns the rate of the drag in them [1/s].
template <class R, class S>
PHYSIM_INLINE R push_rows(const WorldJob<S>& job, std::uint32_t row, Body<R>& b) {
  const RowPush<S>& push = job.push;
  const std::uint32_t i = row - job.first;
  if (push.drag == nullptr) {
    hold_push({R::load(push.a[0] + i), R::load(push.a[1] + i), R::load(push.a[2] + i)}, b);
    return R::load(push.drag_rate + i);
  }
  using W = Cast<double, R>;
  const W wide = W::load(push.drag + i);
  const auto along = [&](int axis) PHYSIM_INLINE_LAMBDA {
    return cast<S>(W(0.0) - cast<double>(load<R>(job.columns.velocity[axis], row)) * wide);
  };
  hold_push({along(0), along(1), along(2)}, b);
  return cast<S>(wide);
}

/// What a rung that turns reads beside the body: the rotor, and the Turn at the start of the step.
template <class R, class S>
PHYSIM_INLINE void load_turn(const WorldJob<S>& job, std::uint32_t row, Flyer<R>& flyer) {
  if (job.columns.turn[0] == nullptr) return;
  load_numbers<RotorConstants>(job.columns.rotor, row, *flyer.rotor);
  load_numbers(job.columns.turn, row, flyer.step.turn->start);
}

/// Lanes with a NaN in their Turn, if there is one, at the end of the step; noteworthy() checks the state.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> turned_bad(const Conditions<S>& c, const Flyer<R>& flyer) {
  MaskOf<R> bad = R(S(0)) != R(S(0));
  for_rotors(
      c.fidelity, [&](const auto&) { bad = !is_finite(flyer.step.turn->end); }, flyer);
  return bad;
}

template <class R, class S>
PHYSIM_INLINE void load_clock(const WorldJob<S>& job, std::uint32_t row, Step<R>& s) {
  s.h = R(job.h);
  s.t = R(S(0));
  s.t_end = s.h;
  if (!job.clocked) return;
  const R offset = load<R>(job.columns.offset, row);
  const R steps = R(job.now) - load<R>(job.columns.born, row);
  s.t = offset + steps * job.h;
  s.t_end = offset + (steps + S(1)) * job.h;
}

/// Lanes behind the last row repeat the pack's first one: what they find in memory may name a place in a table that is
/// not there, such as a piece of another motor.
template <class R>
PHYSIM_NOINLINE void fill_lanes(std::uint32_t rows, R* numbers, unsigned count) {
  for (unsigned i = 0; i < count; ++i)
    for (int lane = static_cast<int>(rows); lane < kLanes<R>; ++lane)
      set_lane(numbers[i], lane, lane_of(numbers[i], 0));
}

/// Marks the rows of a pack.
PHYSIM_INLINE void mark(std::uint32_t* words, std::uint32_t row, unsigned bits) {
  const unsigned shift = row % kRowsPerWord;
  std::uint32_t& word = words[row / kRowsPerWord];
  word = shift == 0 ? bits : word | bits << shift;
}

/// Rows that leave the tube about them that is known to be clear in their step. Behind a call: most worlds
/// have few rows near anything.
template <class R, class S>
PHYSIM_NOINLINE void leaves_tube(const WorldJob<S>& job, const Moved<R>& m, std::uint32_t row, MaskOf<R>& near) {
  ClearTube<R> tube;
  load_numbers(job.columns.tube, row, tube);
  near = near & !stays_inside(tube, m.start.x, m.start.v, m.end.x, m.end.v, job.h);
}

/// Marks rows that came near, or leaves them where they were, if rows that have moved on are not looked at. Calls get
/// copies of the step, and the job as given: what is passed by address lies in memory.
template <class R, class S>
PHYSIM_INLINE void look_for_near(const WorldJob<S>& given, const WorldJob<S>& job, const Moved<R> m, std::uint32_t row,
                                 MaskOf<R>& left) {
  MaskOf<R> near = comes_near(job, m, row);
  if (any(near)) leaves_tube(given, m, row, near);
  if (job.restless != nullptr) meets_restless<R>(given, m.start, m.end, near);
  if (job.near == nullptr) {
    left = left | near;
    return;
  }
  const unsigned bits = lane_bits(near & !left) & filled_lanes<R>(job.last - row);
  mark(job.near, row, bits);
  if (bits != 0) store_vector(m.start.v, job.columns.started, row);
}

/// Steps packs of rows. `frame(row)` says where a pack gets to, and `frame.noteworthy(m, row)` which rows of it want a
/// closer look.
template <class R, class S, class Frame>
PHYSIM_INLINE bool step_packs(const WorldJob<S>& given, const Frame& frame) {
  const WorldJob<S> job = given;  // a copy stays in registers: nothing that is stored to a column can change it
  constexpr unsigned kN = unsigned(kLanes<R>);
  PHYSIM_ASSERT(job.first % kRowsPerWord == 0 && kRowsPerWord % kN == 0);  // a pack's marks lie in one word
  bool attention = false;
  for (std::uint32_t row = job.first; row < job.last; row += kN) {
    Moved<R> m = frame(row);
    MaskOf<R> left = m.lost | frame.noteworthy(m, row);
    if (Frame::kMeets && job.columns.clear != nullptr) look_for_near(given, job, m, row, left);
    const unsigned bits = lane_bits(left) & filled_lanes<R>(job.last - row);
    mark(job.attention, row, bits);
    if (bits != 0) {
      attention = true;
      if (!Frame::kReadsStart) m.start = load_state<R>(job, row);
      m.end = select(left, m.start, m.end);
      if (Frame::kCarries && job.columns.carried[0])
        m.carried = select(left, load_vector<R>(job.columns.carried, row), m.carried);
    }
    put_positions(job, m.end.x, row);
    if constexpr (Frame::kKeepsHorizontal)
      put_vertical(job, m.end.v, row);
    else
      store_vector(m.end.v, job.columns.velocity, row);
    if (Frame::kCarries && job.columns.carried[0]) store_vector(m.carried, job.columns.carried, row);
    frame.finish(row, left);
  }
  if (job.stream) finish_streams();
  return attention;
}

/// Any rung: the switches are inside, the same way for all lanes.
template <class R, class S>
struct AnyRung {
  static constexpr bool kCarries = true;
  static constexpr bool kMeets = true;
  static constexpr bool kReadsStart = true;
  static constexpr bool kKeepsHorizontal = false;
  const WorldJob<S>& job;
  March<R>& march;
  R lane_number;
  bool classic, stops, turning;

  PHYSIM_INLINE Moved<R> operator()(std::uint32_t row) const {
    Lanes<R>& l = march.lanes;
    load_body(job, row, l.body);
    load_clock(job, row, l.step);
    if (turning) load_turn(job, row, l);
    if (job.push.is_there()) l.drag_rate = push_rows(job, row, l.body);
    const State<R> start = load_state<R>(job, row);
    l.step.start = start;
    if (classic) l.step.slope[0].v = load_vector<R>(job.columns.carried, row);
    if (stops && job.last - row < unsigned(kLanes<R>)) {
      fill_lanes(job.last - row, numbers(l.body), kNumbers<Body>);
      fill_lanes(job.last - row, &l.step.t, 1);
      fill_lanes(job.last - row, &l.step.t_end, 1);
    }
    MaskOf<R> asked = lane_number < R(static_cast<S>(job.last - row));
    if (stops) asked = asked & !stop_here<R>(job, *job.course->conditions, row);  // noteworthy, so it is settled anyway
    MaskOf<R> lost = march.take_frame(l.step.t_end, R(job.h), asked);
    if (turning) lost = lost | (asked & !is_finite(l.step.turn->end));
    return {start, l.step.end, l.step.slope[1].v, lost};
  }
  PHYSIM_INLINE MaskOf<R> noteworthy(const Moved<R>& m, std::uint32_t row) const {
    return physim::noteworthy(job, *job.course->conditions, m, row);
  }
  /// Keeps what Moved does not hold.
  PHYSIM_INLINE void finish(std::uint32_t row, const MaskOf<R>& left) const {
    if (!turning) return;
    Turn<R> start;
    load_numbers(job.columns.turn, row, start);
    const Turn<R> end = select(left, start, march.lanes.step.turn->end);
    store_numbers(end, job.columns.turn, row);
  }
};

template <class R, class S>
bool step_any(const WorldJob<S>& job) {
  const Conditions<S>& c = *job.course->conditions;
  March<R> march(*job.course);
  return step_packs<R>(job, AnyRung<R, S>{job, march, lane_numbers<R>(), is_classic(c.fidelity), has_stops(c),
                                          job.columns.turn[0] != nullptr});
}

/// A step of a static rung. `c` has to be known() conditions, made right before: compilers forget what they know of
/// others.
template <int kRung>
struct StaticRung {
  static constexpr StaticRungSpec kSpec = kStaticRungs[kRung];
  static constexpr DragModel kDrag = kSpec.drag;
  static constexpr bool kFalls = kSpec.motion == Motion::closed_form;
  static constexpr bool kCurve = kDrag == DragModel::equation;  // else the air is not read

  /// The conditions that this rung reads.
  template <class S>
  PHYSIM_INLINE static Conditions<S> known(const Conditions<S>& c) {
    Conditions<S> k;
    k.fidelity.motion = kSpec.motion;
    k.fidelity.integrator = Integrator::semi_implicit_euler;
    k.fidelity.gravity = GravityModel::constant;
    k.fidelity.earth = EarthModel::flat;
    k.fidelity.drag = kDrag;
    k.fidelity.wind = kSpec.wind;
    k.fidelity.air = kSpec.air;
    k.fidelity.planar = false;
    k.fidelity.rotation = RotationModel::none;
    k.gravity = c.gravity;
    k.wind.points = 0;
    k.wind.velocity = c.wind.velocity;
    if (kCurve) k.altitude = c.altitude, k.air = c.air, k.curve_rows = c.curve_rows;
    if (!kFalls) k.has_applied = c.has_applied;  // by emitters, for the whole step
    return k;
  }
  /// The numbers of a body that this rung reads, each given by `read`.
  template <class R, class S, class Read>
  PHYSIM_INLINE static Body<R> read_body(const Conditions<S>&, const Read& read) {
    Body<R> b;
    if constexpr (kFalls) read_part<LaunchPart>(read, b);
    if constexpr (kDrag == DragModel::damping) read_part<DampingPart>(read, b);
    if constexpr (kDrag == DragModel::linear_quadratic) read_part<QuadraticPart>(read, b);
    if constexpr (kCurve) read_part<AreaPart>(read, b), read_part<CurvePart>(read, b);
    return b;
  }
  template <class R, class S>
  PHYSIM_INLINE static Body<R> load_body(const WorldJob<S>& job, std::uint32_t row) {
    return read_body<R>(*job.course->conditions,
                        [&](unsigned number) PHYSIM_INLINE_LAMBDA { return load_field<R>(job, number, row); });
  }
  /// End of a step of length h; of a fall, its state at a time h behind its launch. `rate` is that of the drag in
  /// what pushes the body.
  template <class R, class S>
  PHYSIM_INLINE static State<R> end(const Conditions<S>& c, const Body<R>& b, const State<R>& start, const R& h,
                                    const R& rate) {
    if constexpr (kFalls)
      return closed_form_of_free(c, b, h);
    else
      return semi_implicit_end(start, acceleration_over(c, b, R(S(0)), start, {h, rate}), h);
  }

  /// The rows of a job. Of most jobs no row is pushed, comes near a thing, or may do anything but fall down: kPlain.
  template <class R, class S, bool kPlain>
  struct Frame {
    static constexpr bool kCarries = false;
    static constexpr bool kMeets = !kPlain;
    static constexpr bool kReadsStart = !(kFalls && kPlain);  // of where rows are a fall reads what stays behind
    static constexpr bool kKeepsHorizontal = kFalls;          // its velocity
    const WorldJob<S> job;                                    // a copy, as in step_packs()
    const Conditions<S>& given;

    PHYSIM_INLINE Conditions<S> conditions() const {
      Conditions<S> c = known(given);
      if (kPlain) c.has_applied = false;
      return c;
    }
    PHYSIM_INLINE Moved<R> operator()(std::uint32_t row) const {
      Body<R> b = load_body<R>(job, row);
      R rate(S(0));
      if (!kPlain && !kFalls && job.push.is_there()) rate = push_rows(job, row, b);
      Moved<R> m;
      if (kReadsStart) m.start = load_state<R>(job, row);
      R h(job.h);
      if constexpr (kFalls) h = end_on_clock<R>(job, row);
      m.end = end(conditions(), b, m.start, h, rate);
      m.lost = R(S(0)) != R(S(0));
      return m;
    }
    PHYSIM_INLINE MaskOf<R> noteworthy(const Moved<R>& m, std::uint32_t row) const {
      if constexpr (kPlain) return plainly_noteworthy(job.watchdog, conditions(), m);
      return physim::noteworthy(job, conditions(), m, row);
    }
    PHYSIM_INLINE void finish(std::uint32_t, const MaskOf<R>&) const {}
  };
  template <class R, class S>
  static bool step(const WorldJob<S>& given) {
    const Conditions<S>& c = *given.course->conditions;
    const bool plain = given.watchdog.simple && given.columns.clear == nullptr && !given.push.is_there();
    return plain ? step_packs<R>(given, Frame<R, S, true>{given, c})
                 : step_packs<R>(given, Frame<R, S, false>{given, c});
  }
};

/// Static rungs are known; of others the switches are inside.
template <class R, class S>
bool step_packs_of(const WorldJob<S>& job) {
  if constexpr (PHYSIM_KNOWS_RUNGS) {
    bool attention = false;
    with_static_rung(job.static_rung,
                     [&](auto rung) PHYSIM_INLINE_LAMBDA { attention = StaticRung<rung>::template step<R>(job); });
    if (job.static_rung != kNoStaticRung) return attention;
  }
  return step_any<R>(job);
}

PHYSIM_ISA_END
