// The steps of rungs that are known at compile time, one flight at a time. Its numbers are scalars: joining them to
// packs would make them wait (CMakeLists.txt). There is one copy for all instruction sets: with the registers of
// AVX-512 a flight takes 3 to 10 % less, for another 0.2 MB in each program.
#include "flight/known_stages.hpp"
#include "flight/known_step.hpp"
#include "solve/judge.hpp"
#include "solve/quiet_watch.hpp"

PHYSIM_ISA_BEGIN

namespace {

/// A flight under way, in its own variables: of its lanes only the body is read, until it writes its state back to
/// them.
template <class Method, class Rung>
class KnownLoop {
 public:
  PHYSIM_INLINE explicit KnownLoop(KnownFlight& flight)
      : flight_(flight),
        c_(*flight.course.conditions),
        low_air_(c_.air),
        plan_(flight.course.plan),
        now_(start_of(flight.lanes.step)),
        cells_(flight.lanes.body, c_.curve_rows, flight.on_curve),
        control_(flight.lanes.control),
        t_(flight.lanes.step.t),
        tries_(flight.lanes.tries),
        count_(flight.lanes.count) {}

  PHYSIM_INLINE KnownStop run() {
    const Lanes<double>& l = flight_.lanes;
    PHYSIM_ASSERT(may_go_on(flight_.course, l));
    QuietWatch<double> quiet(c_, flight_.course.watch, l);
    while (flight_.node != flight_.end_of_nodes) {
      const double h = control_.h, t_end = t_ + h;
      const KnownStages<Rung, Method> stages(c_, low_air_, l.body, t_, h, t_end, now_, cells_);
      const Standpoint end = stages.end();
      if (!stages.holds() || crosses_corner(end.x)) return leave(KnownEnd::of_another_rung);
      const double error = stages.error(plan_.relative, plan_.absolute);
      tries_ += 1;
      const bool accepted = judge_error(kIntegrator, h, error, true, plan_.max_step, control_);
      const bool stuck = tries_ >= plan_.max_tries || stands_still(t_, h, t_end);
      if (!accepted && !stuck) continue;
      const State<double> there{end.x, end.v};
      const WatchedSet may_cross = quiet.may_cross(Rung::known(c_), l.body, t_end, there, end.a);
      if (stuck || may_cross != 0 || !is_finite(there)) {
        Step<double>& s = flight_.lanes.step;
        s.h = h, s.t_end = t_end;
        stages.put(error, s);
        if (accepted && !stuck) cells_.accept(h);
        return leave(accepted ? KnownEnd::accepted : KnownEnd::rejected, may_cross);
      }
      keep(stages, h, t_end, end);
      cells_.accept(h);
      copy(end, now_);
      t_ = t_end;
      count_ += 1;
    }
    return leave(KnownEnd::out_of_room);
  }

 private:
  static constexpr Integrator kIntegrator = std::is_same_v<Method, Tsit5> ? Integrator::tsit5 : Integrator::rk43;
  static_assert(std::is_same_v<Method, Tsit5> || std::is_same_v<Method, Rk43>);

  PHYSIM_INLINE bool crosses_corner(const Vec3<double>& end) const {
    return flight_.course.corners && !is_in_first_layer(Rung::known(c_), end);
  }
  PHYSIM_INLINE void keep(const KnownStages<Rung, Method>& stages, double h, double t_end, const Standpoint& end) {
    Node& node = *flight_.node++;
    node.t = t_end;
    copy_vector(end.x, node.y.x), copy_vector(end.v, node.y.v), copy_vector(end.a, node.a);
    if constexpr (dense_coefficients_of<Method>() > 0) {
      KeptStep& kept = *flight_.kept++;
      kept.h = h;
      stages.put_inner_slopes(kept.slopes->data());
    }
  }
  PHYSIM_INLINE KnownStop leave(KnownEnd why, WatchedSet may_cross = kAllWatched) const {
    Lanes<double>& l = flight_.lanes;
    l.step.t = t_;
    copy_vector(now_.x, l.step.start.x), copy_vector(now_.v, l.step.start.v);
    copy_vector(now_.v, l.step.slope[0].x), copy_vector(now_.a, l.step.slope[0].v);
    l.control = control_;
    l.tries = tries_;
    l.count = count_;
    flight_.on_curve = cells_.place();
    return {why, may_cross};
  }

  KnownFlight& flight_;
  const Conditions<double>& c_;
  const LowAirOfOne low_air_;
  const StepPlan<double>& plan_;
  Standpoint now_;  // where the step at hand starts
  StageCells<Method> cells_;
  StepControl<double> control_;
  double t_, tries_, count_;
};

template <class Method, class Rung>
KnownStop go_on_known(KnownFlight& flight) {
  return KnownLoop<Method, Rung>(flight).run();
}

template <class Method, int kRung>
constexpr KnownStep step_of() {
  constexpr PlainRungs kRungs = kKnownRungs[kRung];
  using Rung = KnownRung<kRungs.gravity, kRungs.earth>;
  return {go_on_known<Method, Rung>};
}
template <class Method, int... kRung>
KnownStep step_of(int rung, std::integer_sequence<int, kRung...>) {
  static constexpr KnownStep kSteps[] = {step_of<Method, kRung>()...};
  return kSteps[rung];
}

}  // namespace

PHYSIM_ISA_END

namespace physim {

KnownStep known_step_on(int rung, Integrator integrator) {
  constexpr int kRungs = std::size(kKnownRungs);
  constexpr auto kAll = std::make_integer_sequence<int, kRungs>();
  PHYSIM_ASSERT(rung >= 0 && rung < kRungs);
  return integrator == Integrator::tsit5 ? step_of<Tsit5>(rung, kAll) : step_of<Rk43>(rung, kAll);
}

}  // namespace physim
