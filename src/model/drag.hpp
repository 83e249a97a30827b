// Drag.
//
// What it models: `damping`: the velocity through the air decays by a fixed factor per second; `linear_quadratic`: a
//   force linear and quadratic in speed; `equation`: the drag equation with Cd constant, by Mach number or by Reynolds
//   number, the projectile given by its area and mass or by a ballistic coefficient (one, or one per band of speed).
// When to use it: damping for sparks and debris; linear_quadratic where k1 and k2 were tuned by hand; the equation
// else. When it is wrong: drag is taken along the path: no lift, no yaw. A ballistic coefficient holds for the drag
//   function it was measured against, in the range of speeds it was measured in.
// Symbols: u = v - w velocity through the air [m/s]; d part of the velocity kept per second [-], k = -ln d [1/s];
//   k1 [kg/s], k2 [kg/m]; rho density [kg/m^3]; a sound speed [m/s]; M = |u| / a; Cd drag coefficient [-];
//   A = pi D^2 / 4 reference area [m^2]; m mass [kg]; i form factor [-]; BC = m / (i D^2) [kg/m^2].
// Equations: a = -k u;   a = -(k1 + k2 |u|) u / m;   a = -1/2 rho |u| u Cd(M) i A / m = -rho |u| u Cd(M) pi / (8 BC).
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), eq. 5.1-5.3 and 6.31 (ballistic coefficient); I. Millington,
//   Game Physics Engine Development (2010), sec. 3.5 and 5.2.2 (damping, k1 and k2).
#pragma once

#include "math/row_table.hpp"
#include "math/vec3.hpp"
#include "model/air.hpp"
#include "model/sphere_drag.hpp"
#include "model/wind.hpp"

PHYSIM_ISA_BEGIN

/// Cd of curves with points on no equal cells, one lane after the other.
template <class R, class S>
PHYSIM_NOINLINE R searched_cd(const Conditions<S>& c, const Body<R>& b, const R& mach, R cd) {
  PHYSIM_ASSERT(c.searched_curves != nullptr);
  for (int lane = 0; lane < kLanes<R>; ++lane) {
    const S row = lane_of(b.curve_row, lane);
    if (row < S(0))
      set_lane(cd, lane, static_cast<S>(c.searched_curves[static_cast<int>(S(-1) - row)](double(lane_of(mach, lane)))));
  }
  return cd;
}

/// Place of a speed through the air on the lane's curve, in cells from its start, on both sides beyond its ends. The
/// speed comes last in this chain and in that of drag_equation(): its root takes long, and what can be done meanwhile
/// is done.
template <class R>
PHYSIM_INLINE R endless_position(const Body<R>& b, const R& per_sound_speed, const R& speed) {
  const R cells = speed * (per_sound_speed * b.curve_cells);
  if constexpr (std::is_floating_point_v<R>) {
    if (b.curve_first == 0) [[likely]]
      return cells;  // curves mostly begin at Mach 0; no wait for a difference that changes nothing
  }
  return cells - b.curve_first;
}
/// A place on the curve: one beyond an end is that end.
template <class R>
PHYSIM_INLINE R on_curve(const Body<R>& b, const R& place) {
  using S = ScalarOf<R>;
  return clamp(place, R(S(0)), b.curve_last + S(1));
}
template <class R>
PHYSIM_INLINE R curve_position(const Body<R>& b, const R& per_sound_speed, const R& speed) {
  return on_curve(b, endless_position(b, per_sound_speed, speed));
}

/// The cell that a place on a curve lies in. Rounding u - 1/2 is one operation less than the floor of u; on a border
/// either cell gives the same value.
template <class R>
PHYSIM_INLINE R curve_cell(const Body<R>& b, const R& place) {
  return min(round_to_int(place - constant<R>(0.5)), b.curve_last);
}

/// Cd at a place that may lie beyond the curve, by the cell that is guessed, which is right afterwards. If the guess
/// holds, the place lies on the curve: Cd does not wait for a look at both ends.
PHYSIM_INLINE double guessed_cd(const Body<double>& b, const double* rows, double place, GuessedCell<double>& guess) {
  if (round_to_int(place - 0.5) != guess.cell || place < 0) [[unlikely]] {
    place = on_curve(b, place);
    guess.cell = curve_cell(b, place);
    guess.row = row_at(rows, b.curve_row + guess.cell);
  }
  guess.place = place;
  return row_cubic(guess.row, place - guess.cell);
}
/// Guesses the cell of the next look-up by a place near it.
PHYSIM_INLINE void guess_cell(const Body<double>& b, const double* rows, double near, GuessedCell<double>& guess) {
  guess.cell = near > 0 ? curve_cell(b, near) : 0.0;
  PHYSIM_ASSERT(guess.cell >= 0 && guess.cell <= b.curve_last);
  guess.row = row_at(rows, b.curve_row + guess.cell);
}

/// Cd by Mach number, speed over sound speed.
template <class R, class S>
PHYSIM_INLINE R curve_cd(const Conditions<S>& c, const Body<R>& b, const R& per_sound_speed, const R& speed) {
  PHYSIM_ASSERT(c.curve_rows != nullptr);
  if constexpr (std::is_same_v<R, double>) {
    if (c.guess != nullptr) return guessed_cd(b, c.curve_rows, endless_position(b, per_sound_speed, speed), *c.guess);
  }
  const R inside = curve_position(b, per_sound_speed, speed);
  const R cell = curve_cell(b, inside);
  const R row = c.has_searched_curves ? max(b.curve_row, R(S(0))) : b.curve_row;
  const R cd = row_cubic(c.curve_rows, row + cell, inside - cell);
  return c.has_searched_curves ? searched_cd(c, b, speed * per_sound_speed, cd) : cd;
}

/// The drag equation but for Cd and u: -rho |u| A / (2 m).
template <class R>
PHYSIM_INLINE R drag_per_cd(const AirState<R>& air, const R& speed, const R& half_area_per_mass) {
  return speed * -(air.density * half_area_per_mass);
}

/// The drag equation for a velocity through the air u, of length `speed`, in air of a given state.
template <class R, class S>
PHYSIM_INLINE Vec3<R> drag_equation(const Conditions<S>& c, const Body<R>& b, const AirState<R>& air, const Vec3<R>& u,
                                    const R& speed) {
  R cd = curve_cd(c, b, air.per_sound_speed, speed);
  if (c.has_spheres) {
    const R reynolds = air.density * speed * b.reynolds_length / viscosity(temperature(c, b, air));
    R of_sphere;
    sphere_cd(reynolds, of_sphere);
    cd = select(b.reynolds_length > R(S(0)), of_sphere, cd);
  }
  R half_area_per_mass = b.half_area_per_mass;
  if (c.has_bands)
    for (int i = 0; i < kMaxBands; ++i)
      half_area_per_mass = select(speed >= b.band_above[i], b.band_half_area_per_mass[i], half_area_per_mass);
  return u * (drag_per_cd(air, speed, half_area_per_mass) * cd);
}

template <class R, class S>
PHYSIM_INLINE Vec3<R> drag_equation(const Conditions<S>& c, const Body<R>& b, const AirState<R>& air,
                                    const Vec3<R>& u) {
  return drag_equation(c, b, air, u, length(u));
}

/// Drag that reads nothing of the air but its velocity.
template <class R, class S>
PHYSIM_INLINE Vec3<R> simple_drag(const Conditions<S>& c, const Body<R>& b, const Vec3<R>& u) {
  switch (c.fidelity.drag) {
    case DragModel::damping: return u * -b.damping_rate;
    case DragModel::linear_quadratic:
      if (c.fidelity.motion == Motion::closed_form) return u * -b.damping_rate;  // k2 is 0; they are not kept for it
      return u * -(b.k1_per_mass + b.k2_per_mass * length(u));
    case DragModel::off:
    case DragModel::equation: break;
  }
  return {R(S(0)), R(S(0)), R(S(0))};
}

/// Acceleration by drag at a place, of a velocity through the air u [m/s^2].
template <class R, class S>
PHYSIM_INLINE Vec3<R> drag_at(const Conditions<S>& c, const Body<R>& b, const Vec3<R>& x, const Vec3<R>& u) {
  if (c.fidelity.drag == DragModel::equation) return drag_equation(c, b, air_state(c, b, x), u);
  return simple_drag(c, b, u);
}
/// Acceleration by drag [m/s^2].
template <class R, class S>
PHYSIM_INLINE Vec3<R> drag(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  return drag_at(c, b, s.x, air_velocity(c, b, t, s));
}

PHYSIM_ISA_END
