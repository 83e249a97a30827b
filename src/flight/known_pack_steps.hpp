// Steps of packs on the rungs that most batches fly on, known at compile time: the models, the same functions, fold to
// straight code, and of stages what the models do not read is not computed.
//
// An evaluation is two chains: the air by the height, and the speed, which needs a root, a place on the drag curve and
// the row there. What the second waits for is asked of all packs before any of them continues with it: the processor
// does not look far enough ahead to find the work of the next pack behind all that waits.
#pragma once

#include "base/assert.hpp"
#include "base/isa.hpp"
#include "flight/plain_rung.hpp"
#include "solve/take_step.hpp"

PHYSIM_ISA_BEGIN

/// Takes steps as take_steps() does, to the bit; returns whether surely none read air above the first border of layers.
template <class R, class S>
using TakeSteps = bool (*)(const Conditions<S>& c, const FlyerSet<R>& flyers, S relative, S absolute);

/// A point mass with a drag curve in the standard's air over a flat Earth, and nothing special about it but perhaps
/// its own weather.
template <bool kOwnWeather>
struct PlainRung {
  template <class S>
  PHYSIM_INLINE static bool matches(const Conditions<S>& c) {
    return is_plain(c, {.features = {.has_own_air = kOwnWeather, .has_own_wind = kOwnWeather}});
  }
  /// Said right before conditions are read, or the compiler forgets it.
  template <class S>
  PHYSIM_INLINE static void assume(const Conditions<S>& c) {
    if (!matches(c)) __builtin_unreachable();
  }
  template <class R, class S>
  PHYSIM_INLINE static AirState<R> air(const Conditions<S>& c, const Body<R>& b, const R& z) {
    if constexpr (kOwnWeather)
      return low_air(c.air, b.air, z);
    else
      return low_air(c.air, c.air.common, z);
  }
};

/// An evaluation on its way: all but Cd.
template <class R>
struct Evaluation {
  R per_cd;                                // of the drag
  R part;                                  // of the cell on the drag curve
  Components<R> through_air;               // velocity
  UnsignedOf<ScalarOf<R>> row[kLanes<R>];  // where it begins
};

template <class Method, class Rung, class R, class S>
class KnownSteps {
 public:
  KnownSteps(const Conditions<S>& c, const FlyerSet<R>& w) : c_(c), w_(w) {}

  /// All slopes and the end; false if some lane needs air above the first border, and then nothing holds.
  PHYSIM_INLINE bool take() {
    bool all = true;
    static_for<Method::kStages>([&](auto before) PHYSIM_INLINE_LAMBDA {
      constexpr int stage = before + 1;
      for (int i = 0; all && i < w_.count; ++i) all = begin<stage>(i);
      for (int i = 0; all && i < w_.count; ++i) finish(i, w_.steps[i]->slope[stage]);
    });
    return all;
  }

 private:
  template <int stage>
  PHYSIM_INLINE bool begin(int i) {
    PHYSIM_ASSERT(i >= 0 && i < w_.count && w_.count <= kMostSets);
    Step<R>& s = *w_.steps[i];
    const Body<R>& b = w_.flyer[i]->body;
    State<R> y;
    if constexpr (stage == Method::kStages)
      s.end = y = end_state<Method>(s, s.h);
    else
      y = stage_state<Method, stage>(s, s.h);
    s.slope[stage].x = y.v;
    Rung::assume(c_);
    const R z = altitude(c_, y.x);
    if (lanes_at_least(z, R(c_.air.base[1])) != 0) return false;  // below the top of the lowest layer
    const AirState<R> air = Rung::air(c_, b, z);
    const Vec3<R> through_air = y.v - wind(c_, b, s.t, y.x);
    const R speed = length(through_air);
    const R place = curve_position(b, air.per_sound_speed, speed), cell = curve_cell(b, place);
    Evaluation<R>& e = under_way_[i];
    e.per_cd = drag_per_cd(air, speed, b.half_area_per_mass);
    e.part = place - cell;
    e.through_air = through_air;
    row_offsets(b.curve_row + cell, e.row);
    return true;
  }

  PHYSIM_INLINE void finish(int i, State<R>& slope) const {
    const Evaluation<R>& e = under_way_[i];
    const Body<R>& b = w_.flyer[i]->body;
    Rung::assume(c_);
    const R cd = row_cubic_at(c_.curve_rows, e.row, e.part);
    Sum<R> sum;
    sum.begin(&Accelerations::gravity, weight_per_mass(c_, b, slope.x));  // constant: it needs no place
    sum.add(&Accelerations::drag, Vec3<R>(e.through_air) * (e.per_cd * cd));
    slope.v = sum.total;
  }

  const Conditions<S>& c_;
  const FlyerSet<R>& w_;
  Evaluation<R> under_way_[kMostSets];
};

template <class R, class S>
PHYSIM_NOINLINE bool take_any_steps(const Conditions<S>& c, const FlyerSet<R>& w, S relative, S absolute) {
  take_steps(c, w, relative, absolute);
  return false;
}

template <class Method, class Rung, class R, class S>
PHYSIM_NOINLINE bool take_known_steps(const Conditions<S>& c, const FlyerSet<R>& w, S relative, S absolute) {
  PHYSIM_ASSERT(Rung::matches(c));
  KnownSteps<Method, Rung, R, S> steps(c, w);
  if (!steps.take()) return take_any_steps(c, w, relative, absolute);
  if constexpr (HasErrorWeights<Method>)
    for (int i = 0; i < w.count; ++i)
      w.steps[i]->error = embedded_error_squared<Method>(*w.steps[i], w.steps[i]->h, relative, absolute);
  return true;
}

template <class Method, class R, class S>
TakeSteps<R, S> steps_by(const Conditions<S>& c) {
  using SameWeather = PlainRung<false>;
  using OwnWeather = PlainRung<true>;
  PHYSIM_ASSERT(is_calm_without_wind(c));
  if (SameWeather::matches(c)) return take_known_steps<Method, SameWeather, R, S>;
  if (OwnWeather::matches(c)) return take_known_steps<Method, OwnWeather, R, S>;
  return take_any_steps<R, S>;
}

/// What takes the steps of a cohort.
template <class R, class S>
TakeSteps<R, S> steps_of(const Conditions<S>& c) {
  if constexpr (kLanes < R >> 1 && PHYSIM_KNOWS_RUNGS) {
    if (c.fidelity.integrator == Integrator::rk4) return steps_by<Rk4, R>(c);
    if (c.fidelity.integrator == Integrator::rk43) return steps_by<Rk43, R>(c);
    if (c.fidelity.integrator == Integrator::tsit5) return steps_by<Tsit5, R>(c);
  }
  return take_any_steps<R, S>;
}

PHYSIM_ISA_END
