// Corners of the steps of lanes: steps end just behind them (solve/regime.hpp says where corners are).
//
// Where the acceleration only bends, a step is made to end just behind the next kink, where it is expected from the
// acceleration and the jerk at the start. A step that crosses a corner all the same is taken again, cut by its dense
// output. Behind a kink a step may go on for 1e-6 of the step that its error allows: what a kink adds to the error
// falls with the square of that part. Jumps are never passed by more than rounding.
#pragma once

#include <limits>
#include <optional>

#include "solve/dense_lanes.hpp"

PHYSIM_ISA_BEGIN

/// Layers of the air are the only corners, if there are any.
template <class S>
PHYSIM_INLINE bool only_air_has_corners(const Conditions<S>& c) {
  return !(drag_has_corners(c) || has_wind_pieces(c) || c.has_rail || c.has_aero_tables);
}

/// Whether steps end at kinks that are expected. The layers of the standard are not: a flight passes few.
template <class S>
PHYSIM_INLINE bool expects_kinks(const Conditions<S>& c) {
  const bool by_curve = drag_has_corners(c) && c.fidelity.interpolation == Interpolation::linear;
  return steps_itself(c.fidelity) && c.fidelity.motion != Motion::closed_form &&
         (by_curve || c.has_aero_tables || c.has_air_profile || (has_wind_pieces(c) && !c.wind.stepped));
}

/// Places in the first layer of the air, surely: geopotential height is never above geometric height.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> is_in_first_layer(const Conditions<S>& c, const Vec3<R>& x) {
  return altitude(c, x) < R(c.air.base[1]);
}
/// Steps that start there, and are not cut to end behind a corner.
template <class R>
PHYSIM_INLINE MaskOf<R> starts_in_first_layer(const Lanes<R>& l) {
  const R zero(ScalarOf<R>(0));
  return (l.regime.air_layer == zero) & (l.cut == zero);
}

/// The common case: layers of the air are the only corners, and no lane leaves the first one.
template <class R, class S>
PHYSIM_INLINE bool only_below_first_layer(const Conditions<S>& c, const Lanes<R>& l) {
  if (!only_air_has_corners(c)) return false;
  return all(is_in_first_layer(c, l.step.end.x) & starts_in_first_layer(l));
}

/// A state behind a place by this time is surely behind it in its own precision, too [s].
template <class S>
PHYSIM_INLINE double roundings(double t) {
  return 64.0 * std::numeric_limits<S>::epsilon() * t;
}

/// A state drawn back to where its step started by some roundings of S. If it is behind a corner even so, a step that
/// ends there is behind it, too, however its last bits are rounded. Velocities are rounded as the airspeed is.
template <class S>
PHYSIM_INLINE State<double> drawn_back(const State<double>& s, const State<double>& start, double airspeed) {
  constexpr double kRoundings = 4.0 * std::numeric_limits<S>::epsilon();
  PHYSIM_ASSERT(!(airspeed < 0));
  const auto nearer = [](double x, double goal, double size) {
    const double most = kRoundings * size;
    return x + max(-most, min(most, goal - x));
  };
  const auto place = [&](double x, double goal) { return nearer(x, goal, abs(x)); };
  const auto rate = [&, speed = max(length(s.v), airspeed)](double v, double goal) { return nearer(v, goal, speed); };
  return {{place(s.x.x, start.x.x), place(s.x.y, start.x.y), place(s.x.z, start.x.z)},
          {rate(s.v.x, start.v.x), rate(s.v.y, start.v.y), rate(s.v.z, start.v.z)}};
}

/// How long the step of one lane may be to end behind its first corner [s]; nothing where it stands.
template <class R, class S>
std::optional<double> cut_at_corner(const Course<S>& course, const Lanes<R>& l, int lane, bool by_rail, bool jumps) {
  PHYSIM_ASSERT(lane >= 0 && lane < kLanes<R> && course.corners);
  const Conditions<double>& c = *course.conditions_double;
  Lanes<S> alone{};
  copy_step(*course.conditions, l, lane, alone, 0, course.body);
  DenseLanes<S> at;
  dense_lanes(course, alone, at);
  const Body<double> whole_body = at.whole_body();
  const auto rates = [&](double theta) {
    const State<double> s = at(theta);
    return edge_rates(c, whole_body, at.time(theta), s, at.acceleration(theta, s));
  };
  const double h = at.n1.t - at.n0.t;
  // A corner in the first millionth of a step is the one that the last step was cut at, and one within some roundings
  // of the clock is as good as passed: a cut to it would stand still. Others may lie behind it. A rail is never left
  // late.
  const double shortest = roundings<S>(at.n0.t);
  if (shortest >= h) return std::nullopt;
  // So may a kink that lies no farther than the state in float32 is rounded.
  const double soonest = jumps || sizeof(S) == sizeof(double) ? 1e-6 : 1e-4;
  const double before = by_rail ? 0 : max(soonest, shortest / h);
  double cut_h = h * first_corner(c, whole_body, at.turn->rotor, at.n0.t, h, before, at, rates);
  // Some roundings farther the state is surely behind the corner in its own precision, too, where the next step starts.
  const double corner = cut_h;
  cut_h = by_rail ? max(corner, 2 * shortest) : corner + shortest;
  // A flight that starts on a corner and leaves it slowly, from rest, say, moves by less than its state is rounded:
  // cuts to the corner would follow each other without an end.
  const State<double> start = at(0);
  const Regime<double> here = regime(c, whole_body, at.turn->rotor, at.n0.t, start);
  const auto is_behind = [&](double cut) {
    const State<double> s = at(cut / h);
    const State<double> back = drawn_back<S>(s, start, length(air_velocity(c, whole_body, at.n0.t + cut, s)));
    return differ(here, regime(c, whole_body, at.turn->rotor, at.n0.t + cut, back));
  };
  constexpr double kLeast = std::numeric_limits<double>::epsilon();
  for (double more = max(shortest, kLeast * corner); !by_rail && cut_h < h && !is_behind(cut_h); more *= 2)
    cut_h = corner + more;
  if (cut_h >= h || cut_h <= shortest) return std::nullopt;
  return cut_h;
}

/// How far a step may go on behind a kink, of the step that its error allows [-].
inline constexpr double kPastKink = 1e-6;
/// A kink that is expected sooner does not shorten a step, of its length [-]: steps that hardly move the state, as its
/// own precision has it, would follow each other.
inline constexpr double kSoonestKink = 1e-3;

/// Lanes in which the acceleration bends between the regimes, which is expected.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> bends(const Conditions<S>& c, const Regime<R>& a, const Regime<R>& b) {
  MaskOf<R> bend = (a.curve_cell != b.curve_cell) | (a.aero_cell != b.aero_cell);
  if (has_wind_pieces(c) && !c.wind.stepped) bend = bend | (a.wind_piece != b.wind_piece);
  if (c.has_air_profile) bend = bend | (a.air_layer != b.air_layer);
  return bend;
}
/// Lanes in which the acceleration jumps between the regimes.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> jumps(const Conditions<S>& c, const Regime<R>& a, const Regime<R>& b) {
  MaskOf<R> jump = (a.band != b.band) | (a.rail != b.rail);
  if (has_wind_pieces(c) && c.wind.stepped) jump = jump | (a.wind_piece != b.wind_piece);
  return jump;
}

/// Where lanes are expected to be after h, by the acceleration and the jerk at the start of their step.
template <class R>
PHYSIM_INLINE State<R> expected_state(const State<R>& start, const Vec3<R>& a, const Vec3<R>& jerk, const R& h) {
  const Vec3<R> change = a + jerk * (constant<R>(0.5) * h);
  const Vec3<R> way = start.v + (a * constant<R>(0.5) + jerk * (constant<R>(1.0 / 6) * h)) * h;
  return {start.x + way * h, start.v + change * h};
}

/// The part of a step after which the first kink is expected; 1 if there is no kink.
inline double expected_kink(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double t,
                            double h, const State<double>& start, const Vec3d& a, const Vec3d& jerk) {
  PHYSIM_ASSERT(h > 0 && expects_kinks(c));
  const Regime<double> here = regime(c, b, rotor, t, start);
  const auto is_behind = [&](double part) {
    return bends(c, here, regime(c, b, rotor, t + part * h, expected_state(start, a, jerk, part * h)));
  };
  if (!is_behind(1)) return 1;
  double before = 0, behind = 1;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (before + behind);
    (is_behind(middle) ? behind : before) = middle;
  }
  return behind;
}

/// Shortens coming steps to end just behind the next kink, where one is expected in them.
template <class R, class S>
PHYSIM_NOINLINE void end_behind_kinks(const Course<S>& course, Lanes<R>& l) {
  const Conditions<S>& c = *course.conditions;
  PHYSIM_ASSERT(course.corners && course.conditions_double != nullptr);
  const Vec3<R>& a = l.step.slope[0].v;
  const Regime<R> next = regime(c, l.body, *l.rotor, l.step.t_end, expected_state(l.step.start, a, l.jerk, l.step.h));
  for (unsigned left = lane_bits((l.cut == R(S(0))) & bends(c, l.regime, next)); left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    Body<S> narrow;
    Body<double> b;
    copy_lane(l.body, lane, narrow, 0, course.body);
    cast_numbers(narrow, b, course.body);
    Rotor<S> narrow_rotor{};
    Rotor<double> rotor;
    if (turns(c.fidelity)) copy_lane(*l.rotor, lane, narrow_rotor, 0);
    cast_numbers(narrow_rotor, rotor);
    const auto vector = [lane](const Vec3<R>& v) {
      return Vec3d{double(lane_of(v.x, lane)), double(lane_of(v.y, lane)), double(lane_of(v.z, lane))};
    };
    const S t = lane_of(l.step.t, lane), h = lane_of(l.step.h, lane);
    if (!(h > S(0))) continue;  // it is stuck, as March::is_stuck() finds
    const double part = expected_kink(*course.conditions_double, b, rotor, double(t), double(h),
                                      {vector(l.step.start.x), vector(l.step.start.v)}, vector(a), vector(l.jerk));
    if (part < kSoonestKink) continue;
    const S shorter = static_cast<S>(part * double(h) + max(0.3 * kPastKink * double(h), roundings<S>(double(t))));
    if (!(shorter < h)) continue;
    set_lane(l.step.h, lane, shorter);
    set_lane(l.step.t_end, lane, t + shorter);
  }
}

/// Cuts the steps of lanes that would cross a corner; returns lanes in which the step stands.
template <class R, class S>
MaskOf<R> respect_corners(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const R zero(S(0));
  const Conditions<S>& c = *course.conditions;
  if (only_below_first_layer(c, l)) return accepted;
  const Regime<R> next = regime(c, l.body, *l.rotor, l.step.t_end, l.step.end);
  const MaskOf<R> turning =
      turns_back(edge_rates(c, l.body, l.step.t, l.step.start, l.step.slope[0].v),
                 edge_rates(c, l.body, l.step.t_end, l.step.end, l.step.slope[last_slope(c.fidelity)].v));
  const MaskOf<R> crossing = accepted & (l.cut == zero) & (differ(l.regime, next) | turning);
  const MaskOf<R> jumping = jumps(c, l.regime, next);
  R cut = zero;
  for (unsigned left = lane_bits(crossing); left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    const bool by_rail = lane_of(l.regime.rail, lane) != lane_of(next.rail, lane);
    const std::optional<double> cut_h = cut_at_corner(course, l, lane, by_rail, lane_of(jumping, lane));
    if (!cut_h) continue;
    PHYSIM_ASSERT(*cut_h > 0);
    const double past = double(lane_of(l.step.h, lane)) - *cut_h;
    const double rounding = roundings<S>(double(lane_of(l.step.t, lane)));
    const double most = max(kPastKink * double(lane_of(l.control.h, lane)), rounding);
    if (past <= most && !lane_of(jumping, lane)) continue;
    set_lane(cut, lane, lane_of(l.control.h, lane));
    set_lane(l.control.h, lane, static_cast<S>(*cut_h));
  }
  const MaskOf<R> stands = accepted & (cut == zero);
  l.cut = select(stands, zero, select(cut > zero, cut, l.cut));
  l.regime = select(stands, next, l.regime);
  return stands;
}

PHYSIM_ISA_END
