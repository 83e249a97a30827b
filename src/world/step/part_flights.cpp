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

/// A row alone has lane 0 of a pack; the others repeat it.
template <class S>
Vec3d first_of(const std::array<typename FlownParts<S>::Column, 3>& of) {
  return {static_cast<double>(of[0][0]), static_cast<double>(of[1][0]), static_cast<double>(of[2][0])};
}
template <class S>
void repeat(S number, typename FlownParts<S>::Column& to) {
  std::fill_n(to.begin(), kLanes<PartPack<S>>, number);
}
template <class S>
void repeat(const Vec3<S>& v, std::array<typename FlownParts<S>::Column, 3>& to) {
  repeat(v.x, to[0]), repeat(v.y, to[1]), repeat(v.z, to[2]);
}

}  // namespace

template <class Rung, class S>
void PartFlights::fly_packs(const Cohort& cohort, const Conditions<S>& given, const BodyNumbers<S>& body,
                            FlownParts<S>& n) {
  PHYSIM_ASSERT(n.count <= FlownParts<S>::kLanes);
  using R = PartPack<S>;
  const R floor(static_cast<S>(cohort.floor)), slowest(static_cast<S>(cohort.slowest)), zero(S(0));
  n.quiet = 0;
  for (std::size_t i = 0; i < n.count; i += std::size_t{kLanes<R>}) {
    const auto load = [i](const std::array<typename FlownParts<S>::Column, 3>& of) {
      return Vec3<R>{R::load(of[0].data() + i), R::load(of[1].data() + i), R::load(of[2].data() + i)};
    };
    const Conditions<S>& c = Rung::known(given);
    const State<R> start{load(n.x), load(n.v)};
    Body<R> b = Rung::template read_body<R>(c, [&](unsigned number) { return R(body[number]); });
    if constexpr (Rung::kFalls) b.launch = start;
    R rate(S(0));
    if (c.has_applied) {
      b.applied = load(n.push);
      b.applied_until = constant<R>(std::numeric_limits<double>::infinity());
      rate = R::load(n.drag_rate.data() + i);
    }
    const State<R> end = Rung::end(c, b, start, R::load(n.length.data() + i), rate);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      end.x[axis].store(n.end_x[axis].data() + i);
      end.v[axis].store(n.end_v[axis].data() + i);
    }
    // As noteworthy() checks for a whole step; and a row may begin below the ground.
    const MaskOf<R> is_high = (height(c, start.x) > floor) & (height(c, end.x) > floor);
    MaskOf<R> quiet = is_high & is_finite(end) & (length_squared(end.v) >= slowest * slowest);
    if (c.has_applied) quiet = quiet & !((climb_rate(c, start) < zero) & (climb_rate(c, end) > zero));
    n.quiet |= lane_bits(quiet) << i;
  }
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
  if (of.steps_plainly()) fly = fly_packs<AnyStep, S>;
  with_static_rung(of.static_rung, [&](auto rung) { fly = fly_packs<StaticRung<rung>, S>; });
}

PartFlights::Cohort& PartFlights::find(const SettleContext& context, std::uint16_t index) {
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

template <class S>
std::optional<State<double>> PartFlights::fly_row(const SettleContext& context, std::uint16_t index, std::uint32_t row,
                                                  std::optional<double> born, double until) {
  const Rows& rows = context.state->rows[index];
  const RowColumns<S>& columns = rows.columns<S>();
  BodyNumbers<S> body;
  for (const std::uint8_t field : rows.layout().fields) body[field] = columns.field[field][row];
  FlownParts<S> part;
  part.count = 1;
  State<S> start{Rows::numbers_at(columns.position, row), Rows::numbers_at(columns.velocity, row)};
  S length = static_cast<S>(until - born.value_or(0));
  if (rows.layout().clocked) {
    // As settling reads a row's clock: what is flown of a step begins with its start.
    for (int axis = 0; axis < 3; ++axis) {
      start.x[axis] = body[kBodyNumber.launch.x[axis]];
      start.v[axis] = body[kBodyNumber.launch.v[axis]];
    }
    const S steps = static_cast<S>(context.now) - columns.born[row], dt = static_cast<S>(context.dt);
    if (!born) length += columns.offset[row] + steps * dt;
    if (!born && until == context.dt) length = columns.offset[row] + (steps + S(1)) * dt;
  }
  repeat(start.x, part.x), repeat(start.v, part.v), repeat(length, part.length);
  if (context.registry->cohort(index).key.forced) {
    const auto push = push_of(context, index, row, born.value_or(0), length, start);
    if (!push) return std::nullopt;
    repeat(push->a, part.push), repeat(push->drag_rate, part.drag_rate);
  }
  fly(context, index, body, part);
  if ((part.quiet & 1u) == 0) return std::nullopt;
  return State<double>{first_of<S>(part.end_x), first_of<S>(part.end_v)};
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
