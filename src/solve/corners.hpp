// Corners of the steps of lanes: steps that would cross one are cut to end just behind it (solve/regime.hpp says where
// corners are).
#pragma once

#include <limits>
#include <optional>

#include "solve/dense_lanes.hpp"

PHYSIM_ISA_BEGIN

/// Layers of the air are the only corners, if there are any.
template <class S>
PHYSIM_INLINE bool only_air_has_corners(const Conditions<S>& c) {
  return !(drag_has_corners(c) || has_wind_pieces(c) || c.has_applied || c.has_rail || c.has_aero_tables);
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

/// How long the step of one lane may be to end behind its first corner [s]; nothing where it stands.
template <class R, class S>
std::optional<double> cut_at_corner(const Course<S>& course, const Lanes<R>& l, int lane, bool by_rail) {
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
  const double shortest = 64.0 * std::numeric_limits<S>::epsilon() * at.n0.t;
  if (shortest >= h) return std::nullopt;
  const double before = by_rail ? 0 : max(1e-6, shortest / h);
  double cut_h = h * first_corner(c, whole_body, at.turn->rotor, at.n0.t, h, before, at, rates);
  // Some roundings farther the state is surely behind the corner in its own precision, too, where the next step starts.
  cut_h = by_rail ? max(cut_h, 2 * shortest) : cut_h + shortest;
  if (cut_h >= h || cut_h <= shortest) return std::nullopt;
  return cut_h;
}

/// Cuts the steps of lanes that would cross a corner; returns lanes whose step stands.
template <class R, class S>
MaskOf<R> respect_corners(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const R one(S(1));
  const R zero(S(0));
  const Conditions<S>& c = *course.conditions;
  if (only_below_first_layer(c, l)) return accepted;
  const Regime<R> next = regime(c, l.body, *l.rotor, l.step.t_end, l.step.end);
  const MaskOf<R> turning =
      turns_back(edge_rates(c, l.body, l.step.t, l.step.start, l.step.slope[0].v),
                 edge_rates(c, l.body, l.step.t_end, l.step.end, l.step.slope[last_slope(c.fidelity)].v));
  const MaskOf<R> crossing = accepted & (l.cut == zero) & (differ(l.regime, next) | turning);
  R cut = zero;
  for (unsigned left = lane_bits(crossing); left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    const bool by_rail = lane_of(l.regime.rail, lane) != lane_of(next.rail, lane);
    const std::optional<double> cut_h = cut_at_corner(course, l, lane, by_rail);
    if (!cut_h) continue;
    set_lane(l.control.h, lane, static_cast<S>(*cut_h));
    set_lane(cut, lane, S(1));
  }
  const MaskOf<R> stands = accepted & (cut == zero);
  l.cut = select(stands, zero, select(cut == one, one, l.cut));
  l.regime = select(stands, next, l.regime);
  return stands;
}

PHYSIM_ISA_END
