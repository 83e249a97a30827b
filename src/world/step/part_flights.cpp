#include "world/step/part_flights.hpp"

#include <algorithm>
#include <limits>

#include "world/step/drive.hpp"
#include "world/step/forced_step.hpp"
#include "world/step/step_rows.hpp"

namespace physim {
namespace {

/// A first-order step of a rung that is looked up at run time.
struct AnyStep {
  static constexpr bool kFalls = false;
  template <class S>
  static const Conditions<S>& known(const Conditions<S>& c) {
    return c;
  }
  template <class R, class S, class Read>
  static Body<R> read_body(const Conditions<S>& c, const Read& read) {
    Body<R> b{};
    parts_read(c.fidelity, Features{}).runs().each([&](unsigned number) { numbers(b)[number] = read(number); });
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
};

/// The effect of the emitter on a row that starts at `start`, `from` into the step, for `length`; none: no effect.
template <class S>
std::optional<Pushed<S>> push_of(const SettleContext& context, std::uint16_t cohort, std::uint32_t row, double from,
                                 S length, const State<S>& start) {
  Drive drive(*context.registry, *context.state, context.state->rows[cohort].slot(row));
  if (!drive) return std::nullopt;
  const Integrator integrator = context.registry->cohort(cohort).key.fidelity.integrator;
  drive.begin_step(integrator, context.time + from, static_cast<double>(length));
  const Pushed<double> p = drive.at(context.time + from, {vec_cast<double>(start.x), vec_cast<double>(start.v)});
  return Pushed<S>{} + Pushed<S>{vec_cast<S>(p.a), static_cast<S>(p.drag_rate)};  // beside nothing else
}

template <class S>
using PartPack = Pack<S, static_cast<int>(32 / sizeof(S))>;

}  // namespace

template <class Rung, class R, class S>
PHYSIM_FLAT void PartFlights::fly_lanes(const Cohort& cohort, const Conditions<S>& given, const BodyNumbers<S>& body,
                                        FlownParts<S>& n) {
  PHYSIM_ASSERT(n.count <= FlownParts<S>::kLanes);
  const R floor(static_cast<S>(cohort.floor)), slowest(static_cast<S>(cohort.slowest)), zero(S(0));
  n.quiet = 0;
  for (std::size_t i = 0; i < n.count; i += std::size_t{kLanes<R>}) {
    const auto load = [i](const typename FlownParts<S>::Column& of) { return load_lanes<R>(of.data() + i); };
    const auto vector = [&load](const auto& of) { return Vec3<R>{load(of[0]), load(of[1]), load(of[2])}; };
    const Conditions<S>& c = Rung::known(given);
    const State<R> start{vector(n.x), vector(n.v)};
    Body<R> b = Rung::template read_body<R>(c, [&](unsigned number) { return R(body[number]); });
    if constexpr (Rung::kFalls) b.launch = start;
    R rate(S(0));
    if (c.has_applied) {
      hold_push(vector(n.push), b);
      rate = load(n.drag_rate);
    }
    const State<R> end = Rung::end(c, b, start, load(n.length), rate);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      store_lanes(end.x[axis], n.end_x[axis].data() + i);
      store_lanes(end.v[axis], n.end_v[axis].data() + i);
    }
    // As noteworthy() checks for a whole step; and a row may begin below the ground.
    const MaskOf<R> is_high = (height(c, start.x) > floor) & (height(c, end.x) > floor);
    MaskOf<R> quiet = is_high & is_finite(end) & (length_squared(end.v) >= slowest * slowest);
    if (c.has_applied) quiet = quiet & !((climb_rate(c, start) < zero) & (climb_rate(c, end) > zero));
    n.quiet |= lane_bits(quiet) << i;
  }
}

template <class Rung, class S>
void PartFlights::fly_parts(const Cohort& cohort, const Conditions<S>& given, const BodyNumbers<S>& body,
                            FlownParts<S>& n) {
  if (n.count == 1)
    fly_lanes<Rung, S>(cohort, given, body, n);
  else
    fly_lanes<Rung, PartPack<S>>(cohort, given, body, n);
}

template <class S>
void PartFlights::find(const SettleContext& context, std::uint16_t index, Cohort& cohort) {
  const WorldCohort& of = context.registry->cohort(index);
  const Watchdog<S> w = rows_job<S>(context, index).watchdog;
  cohort.floor = static_cast<double>(w.floor);
  cohort.slowest = static_cast<double>(w.slowest);
  const bool simple = of.key.forced ? !w.apex && !w.watched && !w.box && !of.layout.launched : w.simple;
  if (!simple || of.key.still || of.layout.meeting || !steps_with_free(context, index)) return;
  Fly<S>& fly = std::get<Fly<S>>(cohort.fly);
  if (of.steps_plainly()) fly = fly_parts<AnyStep, S>;
  with_static_rung(of.static_rung, [&](auto rung) { fly = fly_parts<StaticRung<rung>, S>; });
}

PartFlights::Cohort& PartFlights::find(const SettleContext& context, std::uint16_t index) {
  PHYSIM_ASSERT(index < context.state->rows.size());
  if (cohorts_.size() <= index) cohorts_.resize(context.state->rows.size());
  Cohort& cohort = cohorts_[index];
  cohort.is_asked = true;
  if (context.state->rows[index].layout().float32)
    find<float>(context, index, cohort);
  else
    find<double>(context, index, cohort);
  return cohort;
}

template <class S>
std::optional<State<double>> PartFlights::fly_row(const SettleContext& context, std::uint16_t index, std::uint32_t row,
                                                  std::optional<double> born, double until) {
  const Rows& rows = context.state->rows[index];
  const RowColumns<S>& columns = rows.columns<S>();
  BodyNumbers<S> body;
  for (const std::uint8_t field : rows.layout().fields) body[field] = columns.field[field][row];
  S length = static_cast<S>(until - born.value_or(0));
  State<S> start;
  if (rows.layout().clocked) {
    // As settling reads a row's clock: what is flown of a step begins with its start.
    for (int axis = 0; axis < 3; ++axis) {
      start.x[axis] = body[kBodyNumber.launch.x[axis]];
      start.v[axis] = body[kBodyNumber.launch.v[axis]];
    }
    const S steps = static_cast<S>(context.now) - columns.born[row], dt = static_cast<S>(context.dt);
    if (!born) length += columns.offset[row] + steps * dt;
    if (!born && until == context.dt) length = columns.offset[row] + (steps + S(1)) * dt;
  } else {
    start = {Rows::numbers_at(columns.position, row), Rows::numbers_at(columns.velocity, row)};
  }
  FlownParts<S> part;
  part.count = 1;
  part.length[0] = length;
  for (std::size_t axis = 0; axis < 3; ++axis) part.x[axis][0] = start.x[axis], part.v[axis][0] = start.v[axis];
  if (context.registry->cohort(index).key.forced) {
    const auto push = push_of(context, index, row, born.value_or(0), length, start);
    if (!push) return std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis) part.push[axis][0] = push->a[axis];
    part.drag_rate[0] = push->drag_rate;
  }
  fly(context, index, body, part);
  if ((part.quiet & 1u) == 0) return std::nullopt;
  const auto first = [](const auto& of) {
    return Vec3d{static_cast<double>(of[0][0]), static_cast<double>(of[1][0]), static_cast<double>(of[2][0])};
  };
  return State<double>{first(part.end_x), first(part.end_v)};
}

std::optional<State<double>> PartFlights::state_after(const SettleContext& context, std::uint16_t index,
                                                      std::uint32_t row, std::optional<double> born, double until) {
  PHYSIM_ASSERT(until <= context.dt && !context.pairs && !context.taken);
  PHYSIM_ASSERT(row < context.state->rows[index].size());
  if (!(until - born.value_or(0) > 0) || !knows(context, index)) return std::nullopt;
  return context.state->rows[index].layout().float32 ? fly_row<float>(context, index, row, born, until)
                                                     : fly_row<double>(context, index, row, born, until);
}

}  // namespace physim
