#include "world/step/known_flight.hpp"

#include "world/step/drive.hpp"
#include "world/step/forced_rows.hpp"

namespace physim {
namespace {

/// A part of a body, its numbers read one by one.
template <template <class> class Part, class R, class Read>
void read_part(Body<R>& body, const Read& read) {
  constexpr unsigned kFirst = BodyParts::first(BodyParts::index<Part>());
  R* number = numbers(static_cast<Part<R>&>(body));
  for (unsigned i = 0; i < kNumbers<Part>; ++i) number[i] = R(read(kFirst + i));
}

/// A step of a rung of the kernels, for a row alone or for newborns.
template <DragModel drag, WindModel wind = WindModel::off, AirModel air = AirModel::vacuum>
struct ShortStep : KnownRung<drag, wind, air> {
  static constexpr bool kPushed = false;
  template <class R, class S, class Read>
  static Body<R> body_of(const Conditions<S>&, const State<R>&, const Read& read) {
    Body<R> b;
    if constexpr (drag == DragModel::damping) read_part<DampingPart>(b, read);
    if constexpr (drag == DragModel::linear_quadratic) read_part<QuadraticPart>(b, read);
    if constexpr (drag == DragModel::equation) read_part<AreaPart>(b, read), read_part<CurvePart>(b, read);
    return b;
  }
  /// After `h`; the launch is forgotten.
  template <class R, class S>
  PHYSIM_INLINE static State<R> end(const Conditions<S>& c, const Body<R>& b, const State<R>& start, const R& h,
                                    const R& rate) {
    return semi_implicit_end(start, acceleration_over(c, b, R(S(0)), start, {h, rate}), h);
  }
  template <class S>
  static S length_of(const RowColumns<S>&, const SettleContext&, std::uint32_t, double length) {
    return static_cast<S>(length);
  }
};

/// A step of one stage of other rungs: their properties are looked up at run time.
struct AnyShortStep {
  static constexpr bool kPushed = false;
  template <class S>
  static bool matches(const Conditions<S>& c) {
    const Fidelity& f = c.fidelity;
    const bool one_stage =
        f.integrator == Integrator::explicit_euler || f.integrator == Integrator::semi_implicit_euler;
    const bool plain_pull = f.gravity == GravityModel::constant || f.gravity == GravityModel::inverse_square;
    const bool plain_air = f.drag != DragModel::equation || f.air == AirModel::isa;
    const bool plain_wind = f.wind == WindModel::off || f.wind == WindModel::constant;
    return f.motion != Motion::closed_form && one_stage && plain_pull && plain_air && plain_wind &&
           f.earth == EarthModel::flat && !f.planar && f.rotation == RotationModel::none &&
           static_cast<const Features&>(c) == Features{};
  }
  template <class S>
  static const Conditions<S>& known(const Conditions<S>& c) {
    return c;
  }
  template <class R, class S, class Read>
  static Body<R> body_of(const Conditions<S>& c, const State<R>&, const Read& read) {
    Body<R> b{};
    const DragModel drag = c.fidelity.drag;
    if (drag == DragModel::damping) read_part<DampingPart>(b, read);
    if (drag == DragModel::linear_quadratic) read_part<QuadraticPart>(b, read);
    if (drag == DragModel::equation) read_part<AreaPart>(b, read), read_part<CurvePart>(b, read);
    return b;
  }
  template <class R, class S>
  static State<R> end(const Conditions<S>& c, const Body<R>& b, const State<R>& start, const R& h, const R& rate) {
    Vec3<R> a;
    evaluate(c, b, R(S(0)), start, {h, rate}, a);
    State<R> end = semi_implicit_end(start, a, h);
    if (c.fidelity.integrator == Integrator::explicit_euler) end.x = start.x + start.v * h;
    return end;
  }
  template <class S>
  static S length_of(const RowColumns<S>&, const SettleContext&, std::uint32_t, double length) {
    return static_cast<S>(length);
  }
};

/// The closed form of the kernels. Its length is the time since the launch that is its start.
struct ShortFall : KnownFall {
  static constexpr bool kPushed = false;
  /// Newborns are launched where they start.
  template <class R>
  static Body<R> body_of(const State<R>& start) {
    Body<R> b;
    b.launch = start;
    return b;
  }
  template <class R, class S, class Read>
  static Body<R> body_of(const Conditions<S>&, const State<R>& start, const Read& read) {
    Body<R> b = body_of(start);
    read_part<LaunchPart>(b, read);
    return b;
  }
  template <class R, class S>
  static State<R> end(const Conditions<S>& c, const Body<R>& b, const State<R>&, const R& t, const R&) {
    return closed_form_of_free(c, b, t);
  }
  /// As settling reads a row's clock: what is flown of a step begins with its start.
  template <class S>
  static S length_of(const RowColumns<S>& columns, const SettleContext& context, std::uint32_t row, double length) {
    const S steps = static_cast<S>(context.now) - columns.born[row], dt = static_cast<S>(context.dt);
    if (length == context.dt) return columns.offset[row] + (steps + S(1)) * dt;
    return columns.offset[row] + steps * dt + static_cast<S>(length);
  }
};

/// A step of a rung with rows that feel the effect of their emitter, and no generator.
template <class Rung>
struct PushedStep : Rung {
  static constexpr bool kPushed = true;
  template <class S>
  static bool matches(const Conditions<S>& c) {
    return PushedRung<Rung>::matches(c);
  }
  template <class S>
  static Conditions<S> known(const Conditions<S>& c) {
    return PushedRung<Rung>::known(c);
  }
};

/// What is pushed up again may touch the ground between.
template <class R, class S>
MaskOf<R> touches_between(const Conditions<S>& c, const State<R>& start, const State<R>& end) {
  const R zero(S(0));
  return (climb_rate(c, start) < zero) & (climb_rate(c, end) > zero);
}

/// The effect of the emitter on a row that starts at `start`, `from` into the step, for `length`; none: no effect.
template <class S>
std::optional<Pushed<S>> push_of(const SettleContext& context, std::uint16_t cohort, std::uint32_t row, double from,
                                 S length, const State<S>& start) {
  Drive drive(*context.registry, *context.state, context.state->rows[cohort].slot(row));
  if (!drive) return std::nullopt;
  drive.begin_step(Integrator::semi_implicit_euler, context.time + from, static_cast<double>(length));
  const Pushed<double> p = drive.at(context.time + from, {vec_cast<double>(start.x), vec_cast<double>(start.v)});
  return Pushed<S>{} + Pushed<S>{vec_cast<S>(p.a), static_cast<S>(p.drag_rate)};  // beside nothing else
}

}  // namespace

template <class Rung, class S>
std::optional<State<double>> KnownFlights::fly_alone(const Cohort& cohort, const SettleContext& context,
                                                     const Part& part) {
  const std::uint32_t row = part.row;
  const RowColumns<S>& columns = context.state->rows[part.cohort].columns<S>();
  const auto vector = [row](S* const(&of)[3]) { return Vec3<S>{of[0][row], of[1][row], of[2][row]}; };
  const Conditions<S>& c = Rung::known(*context.registry->cohort(part.cohort).course<S>().conditions);
  const State<S> start{vector(columns.position), vector(columns.velocity)};
  Body<S> b = Rung::body_of(c, start, [&](unsigned field) { return columns.field[field][row]; });
  const S length =
      part.born ? static_cast<S>(part.until - *part.born) : Rung::length_of(columns, context, row, part.until);
  S rate = 0;
  if constexpr (Rung::kPushed) {
    const auto push = push_of(context, part.cohort, row, part.born.value_or(0), length, start);
    if (!push) return std::nullopt;
    put_push(push->a, b);
    rate = push->drag_rate;
  }
  const State<S> end = Rung::end(c, b, start, length, rate);
  const S floor = static_cast<S>(cohort.floor), slowest = static_cast<S>(cohort.slowest);
  // As noteworthy() checks for a whole step; and a row may begin below the ground.
  const bool is_high = height(c, start.x) > floor && height(c, end.x) > floor;
  if (!is_high || !is_finite(end) || length_squared(end.v) < slowest * slowest) return std::nullopt;
  if (Rung::kPushed && touches_between(c, start, end)) return std::nullopt;
  return State<double>{vec_cast<double>(end.x), vec_cast<double>(end.v)};
}

template <class Rung, class S>
void KnownFlights::fly_together(const Cohort& cohort, const SettleContext& context, std::uint16_t index,
                                const Body<double>& body, NewbornFlights<S>& n) {
  PHYSIM_ASSERT(n.count <= NewbornFlights<S>::kLanes);
  using R = Pack<S, static_cast<int>(32 / sizeof(S))>;
  const R floor(static_cast<S>(cohort.floor)), slowest(static_cast<S>(cohort.slowest));
  const Conditions<S>& given = *context.registry->cohort(index).course<S>().conditions;
  const double* const number = numbers(body);
  n.known = 0;
  for (std::size_t i = 0; i < n.count; i += std::size_t{kLanes<R>}) {
    const auto load = [i](const std::array<typename NewbornFlights<S>::Column, 3>& of) {
      return Vec3<R>{R::load(of[0].data() + i), R::load(of[1].data() + i), R::load(of[2].data() + i)};
    };
    const Conditions<S>& c = Rung::known(given);
    const State<R> start{load(n.x), load(n.v)};
    Body<R> b;
    if constexpr (std::is_same_v<Rung, ShortFall>)
      b = Rung::body_of(start);
    else
      b = Rung::body_of(c, start, [number](unsigned field) { return static_cast<S>(number[field]); });
    R rate(S(0));
    if constexpr (Rung::kPushed) put_push(load(n.push), b), rate = R::load(n.drag_rate.data() + i);
    const State<R> end = Rung::end(c, b, start, R::load(n.length.data() + i), rate);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      end.x[axis].store(n.end_x[axis].data() + i);
      end.v[axis].store(n.end_v[axis].data() + i);
    }
    const MaskOf<R> is_high = (height(c, start.x) > floor) & (height(c, end.x) > floor);
    MaskOf<R> known = is_high & is_finite(end) & (length_squared(end.v) >= slowest * slowest);
    if (Rung::kPushed) known = known & !touches_between(c, start, end);
    n.known |= lane_bits(known) << i;
  }
}

template <class S>
void KnownFlights::find(const SettleContext& context, std::uint16_t index, Cohort& cohort) {
  const WorldCohort& of = context.registry->cohort(index);
  const RowLayout& layout = of.layout;
  const WorldJob<S> job = rows_job<S>(context, index);
  cohort.floor = static_cast<double>(job.watchdog.floor);
  cohort.slowest = static_cast<double>(job.watchdog.slowest);
  const Watchdog<S>& w = job.watchdog;
  const bool forced = of.key.forced;
  const bool simple = forced ? !w.apex && !w.watched && !w.box && !layout.launched : w.simple;
  if (!simple || of.key.still || layout.meeting || layout.carried) return;
  if (forced && (layout.clocked || !context.state->generators.empty())) return;
  const Conditions<S>& c = *job.course->conditions;
  const auto try_one = [&]<class Rung>(Rung) {
    if (cohort.fly || !Rung::matches(c)) return;
    cohort.fly = fly_alone<Rung, S>;
    std::get<FlyEach<S>>(cohort.fly_each) = fly_together<Rung, S>;
  };
  const auto try_rung = [&]<class Rung>(Rung rung) {
    if (forced)
      try_one(PushedStep<Rung>{});
    else
      try_one(rung);
  };
  if (layout.clocked) return try_one(ShortFall{});
  each_known_rung<ShortStep>(try_rung);
  if (!forced) try_one(AnyShortStep{});
}

KnownFlights::Cohort& KnownFlights::find(const SettleContext& context, std::uint16_t index) {
  PHYSIM_ASSERT(index < context.state->rows.size());
  if (cohorts_.size() <= index) cohorts_.resize(context.state->rows.size());
  Cohort& cohort = cohorts_[index];
  if (cohort.is_asked) return cohort;
  cohort.is_asked = true;
  if (context.state->rows[index].layout().float32)
    find<float>(context, index, cohort);
  else
    find<double>(context, index, cohort);
  return cohort;
}

std::optional<State<double>> KnownFlights::state_after(const SettleContext& context, std::uint16_t index,
                                                       std::uint32_t row, std::optional<double> born, double until) {
  PHYSIM_ASSERT(until <= context.dt && !context.pairs && !context.taken);
  PHYSIM_ASSERT(row < context.state->rows[index].size());
  if (!(until - born.value_or(0) > 0)) return std::nullopt;
  const Cohort& cohort = find(context, index);
  return cohort.fly ? cohort.fly(cohort, context, {index, row, born, until}) : std::nullopt;
}

}  // namespace physim
