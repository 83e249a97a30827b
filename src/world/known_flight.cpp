#include "world/known_flight.hpp"

#include "world/step_rows.hpp"

namespace physim {
namespace {

/// A part of a row's body.
template <template <class> class Part, class S>
void read_part(const RowColumns<S>& columns, std::uint32_t row, Body<S>& body) {
  constexpr unsigned kFirst = BodyParts::first(BodyParts::index<Part>());
  S* number = numbers(static_cast<Part<S>&>(body));
  for (unsigned i = 0; i < kNumbers<Part>; ++i) number[i] = columns.field[kFirst + i][row];
}

/// A rung of the kernels, for a row alone.
template <DragModel drag, WindModel wind = WindModel::off, AirModel air = AirModel::vacuum>
struct AloneRung : KnownRung<drag, wind, air> {
  template <class S>
  static Body<S> body_of(const RowColumns<S>& columns, std::uint32_t row) {
    Body<S> b;
    if constexpr (drag == DragModel::damping) read_part<DampingPart>(columns, row, b);
    if constexpr (drag == DragModel::linear_quadratic) read_part<QuadraticPart>(columns, row, b);
    if constexpr (drag == DragModel::equation)
      read_part<AreaPart>(columns, row, b), read_part<CurvePart>(columns, row, b);
    return b;
  }
};

}  // namespace

template <class Rung, class S>
std::optional<State<double>> KnownFlights::fly(const Cohort& cohort, const SettleContext& context, std::uint16_t index,
                                               std::uint32_t row, double length) {
  const RowColumns<S>& columns = context.state->rows[index].columns<S>();
  const auto vector = [row](S* const(&of)[3]) { return Vec3<S>{of[0][row], of[1][row], of[2][row]}; };
  const Conditions<S> c = Rung::known(*context.registry->cohort(index).course<S>().conditions);
  const Body<S> b = Rung::body_of(columns, row);
  const State<S> start{vector(columns.position), vector(columns.velocity)};
  const S h = static_cast<S>(length), floor = static_cast<S>(cohort.floor), slowest = static_cast<S>(cohort.slowest);
  State<S> end;
  end.v = start.v + acceleration(c, b, S(0), start) * h;
  end.x = start.x + end.v * h;
  const S speed_squared = length_squared(end.v);
  // As noteworthy() asks of a whole step; and it may have been born below the ground.
  const bool is_high = height(c, start.x) > floor && height(c, end.x) > floor;
  if (!is_high || !is_finite(end) || speed_squared < slowest * slowest) return std::nullopt;
  return State<double>{vec_cast<double>(end.x), vec_cast<double>(end.v)};
}

template <class S>
void KnownFlights::find(const SettleContext& context, std::uint16_t index, Cohort& cohort) {
  const WorldCohort& of = context.registry->cohort(index);
  const RowLayout& layout = of.layout;
  const WorldJob<S> job = rows_job<S>(context, index);
  cohort.floor = static_cast<double>(job.watchdog.floor);
  cohort.slowest = static_cast<double>(job.watchdog.slowest);
  if (!job.watchdog.simple || of.key.forced || layout.clocked || layout.meeting || layout.carried) return;
  const Conditions<S>& c = *job.course->conditions;
  const auto try_rung = [&]<class Rung>(Rung) {
    if (!cohort.fly && Rung::matches(c)) cohort.fly = fly<Rung, S>;
  };
  using enum DragModel;
  constexpr WindModel kCalm = WindModel::off, kWind = WindModel::constant;
  try_rung(AloneRung<off>{});
  try_rung(AloneRung<damping>{});
  try_rung(AloneRung<linear_quadratic>{});
  try_rung(AloneRung<linear_quadratic, kWind>{});
  try_rung(AloneRung<equation, kCalm, AirModel::isa>{});
  try_rung(AloneRung<equation, kWind, AirModel::isa>{});
}

std::optional<State<double>> KnownFlights::state_after(const SettleContext& context, std::uint16_t index,
                                                       std::uint32_t row, double length) {
  PHYSIM_ASSERT(length <= context.dt && !context.pairs && !context.taken);
  PHYSIM_ASSERT(index < context.state->rows.size() && row < context.state->rows[index].size());
  if (!(length > 0)) return std::nullopt;
  if (cohorts_.size() <= index) cohorts_.resize(context.state->rows.size());
  Cohort& cohort = cohorts_[index];
  if (!cohort.is_asked) {
    cohort.is_asked = true;
    if (context.state->rows[index].layout().float32)
      find<float>(context, index, cohort);
    else
      find<double>(context, index, cohort);
  }
  return cohort.fly ? cohort.fly(cohort, context, index, row, length) : std::nullopt;
}

}  // namespace physim
