// Regimes: where on its piecewise data a flight is. An adaptive integrator must not step across a corner of a linear
// drag curve, an edge of a band, a layer of the atmosphere or a point of the wind profile: its error estimate assumes
// smooth derivatives. Steps that would are cut to end just behind the corner. Steps of every integrator are cut where a
// launch rail lets go; what is known by its time, a motor's table or the end of a force, is in solve/stops.hpp.
#pragma once

#include "math/vec3.hpp"
#include "solve/dense.hpp"
#include "solve/stops.hpp"

namespace physim {

/// Index of the piece in each kind of data; whole numbers.
template <class R>
struct Regime {
  R curve_cell;
  R band;
  R air_layer;
  R wind_piece;
  R aero_cell;
  R rail;
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// How many of the borders lie at or below u.
template <class R>
PHYSIM_INLINE R borders_passed(int count, const R& u, const auto& border) {
  using S = ScalarOf<R>;
  PHYSIM_ASSERT(count >= 0);
  R passed(S(0));
  for (int i = 0; i < count; ++i) {
    const auto above = u >= R(border(i));
    if (!any(above)) break;
    passed += select(above, R(S(1)), R(S(0)));
  }
  return passed;
}

template <class S>
PHYSIM_INLINE bool drag_has_corners(const Conditions<S>& c) {
  return c.fidelity.drag == DragModel::equation &&
         (c.has_bands || (c.fidelity.interpolation == Interpolation::linear && c.fidelity.air != AirModel::vacuum));
}

template <class S>
PHYSIM_INLINE bool has_layers(const Conditions<S>& c) {
  return c.fidelity.drag == DragModel::equation && c.fidelity.air == AirModel::isa;
}

template <class R, class S>
PHYSIM_INLINE R curve_cell_index(const Conditions<S>& c, const Body<R>& b, const R& per_sound_speed, const R& speed) {
  R cell = floor_small(curve_position(b, per_sound_speed, speed));
  if (c.has_searched_curves) {
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      const S row = lane_of(b.curve_row, lane);
      if (row < S(0)) {
        PHYSIM_ASSERT(c.searched_curves != nullptr);
        const auto& knots = c.searched_curves[static_cast<int>(S(-1) - row)].knots;
        const double mach = static_cast<double>(lane_of(speed, lane) * lane_of(per_sound_speed, lane));
        int index = 0;
        while (index < static_cast<int>(knots.size()) && mach >= knots[static_cast<unsigned>(index)]) ++index;
        set_lane(cell, lane, static_cast<S>(index));
      }
    }
  }
  return cell;
}

/// Where lanes are. Behind a call: it is long, and flights without corners never come here.
template <class R, class S>
PHYSIM_NOINLINE Regime<R> regime(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                 const State<R>& s) {
  const R zero(S(0));
  Regime<R> r{zero, zero, zero, zero, zero, zero};
  if (c.has_rail) rail_phase(c, b, t, s, r.rail);
  if (!steps_itself(c.fidelity)) return r;  // fixed steps go over what bends in place and speed
  if (drag_has_corners(c)) {
    const R speed = length(air_velocity(c, b, t, s));
    if (c.fidelity.interpolation == Interpolation::linear)
      r.curve_cell = curve_cell_index(c, b, air_state(c, b, s.x).per_sound_speed, speed);
    if (c.has_bands)
      for (int i = 0; i < kMaxBands; ++i) r.band += select(speed >= b.band_above[i], R(S(1)), zero);
  }
  if (has_layers(c)) {
    const R z = altitude(c, s.x);
    const S r0 = static_cast<S>(kGeopotentialRadius);
    const S* bases = c.has_air_profile ? c.air_bases : c.air.base;
    const R h = r0 * z / (r0 + z);
    const int first = layer_below_all(c.air.layers, bases, h);
    r.air_layer =
        R(S(first)) + borders_passed(c.air.layers - 1 - first, h, [&](int i) { return bases[first + i + 1]; });
  }
  if (has_wind_pieces(c))
    r.wind_piece = borders_passed(c.wind.points, c.wind.by_range ? s.x.x : height(c, s.x),
                                  [&](int i) { return c.wind_pieces[i].at; });
  if (c.has_aero_tables)
    r.aero_cell =
        cell_of(c.curve_rows, rotor.mach, length(air_velocity(c, b, t, s)) * air_state(c, b, s.x).per_sound_speed);
  return r;
}

template <class R>
PHYSIM_INLINE MaskOf<R> differ(const Regime<R>& a, const Regime<R>& b) {
  return (a.curve_cell != b.curve_cell) | (a.band != b.band) | (a.air_layer != b.air_layer) |
         (a.wind_piece != b.wind_piece) | (a.aero_cell != b.aero_cell) | (a.rail != b.rail);
}

template <class R, class Mask>
PHYSIM_INLINE Regime<R> select(const Mask& m, const Regime<R>& a, const Regime<R>& b) {
  return {select(m, a.curve_cell, b.curve_cell), select(m, a.band, b.band),
          select(m, a.air_layer, b.air_layer),   select(m, a.wind_piece, b.wind_piece),
          select(m, a.aero_cell, b.aero_cell),   select(m, a.rail, b.rail)};
}

/// Whether any piecewise data is in use, so that smooth flights do not pay.
template <class S>
PHYSIM_INLINE bool has_corners(const Conditions<S>& c) {
  return drag_has_corners(c) || has_layers(c) || has_wind_pieces(c) || c.has_rail || c.has_aero_tables;
}

/// Above all speeds, below the edges of bands that are not used.
inline constexpr double kNoBand = 1e30;

/// The rates of what stepped data goes by. Where one changes its sign inside a step, the flight may pass an edge and
/// come back behind it, which the ends of the step do not show.
template <class R>
struct EdgeRates {
  R place;  // in a profile [m/s]
  R speed;  // through the air, of half its square [m^2/s^3]
};
template <class R, class S>
PHYSIM_INLINE EdgeRates<R> edge_rates(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                      const Vec3<R>& a) {
  EdgeRates<R> rates{R(S(0)), R(S(0))};
  if (!steps_itself(c.fidelity)) return rates;
  if (has_wind_pieces(c) || c.has_air_profile)
    rates.place = has_wind_pieces(c) && c.wind.by_range ? s.v.x : climb_rate(c, s);
  // A projectile without bands must not be cut elsewhere for those of others.
  if (c.has_bands)
    rates.speed = select(b.band_above[0] < constant<R>(kNoBand), dot(air_velocity(c, b, t, s), a), R(S(0)));
  return rates;
}

template <class R>
PHYSIM_INLINE MaskOf<R> turns_back(const EdgeRates<R>& from, const EdgeRates<R>& to) {
  const R zero(ScalarOf<R>(0));
  const auto changes = [&](const R& x, const R& y) { return ((x > zero) & (y <= zero)) | ((x <= zero) & (y > zero)); };
  return changes(from.place, to.place) | changes(from.speed, to.speed);
}

/// The part of a step after which a rate has another sign than at its start; 1 where it keeps it.
double turning_point(const auto& rate) {
  const bool rises = rate(0.0) > 0;
  if ((rate(1.0) > 0) == rises) return 1;
  double before = 0, behind = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (before + behind);
    ((rate(middle) > 0) == rises ? before : behind) = middle;
  }
  return behind;
}

/// The part of a finished step after which the first corner lies just behind, or 1 if there is no corner to respect.
/// `at(theta)` is the dense output, `rates(theta)` its edge_rates(); the search begins `before` some part of the step.
template <class F, class Rates>
double first_corner(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double t, double h,
                    double before, const F& at, const Rates& rates) {
  PHYSIM_ASSERT(h > 0 && before >= 0 && before < 1);
  const Regime<double> here = regime(c, b, rotor, t + before * h, at(before));
  const auto differs = [&](double theta) { return differ(here, regime(c, b, rotor, t + theta * h, at(theta))); };
  const double turn = turning_point([&](double theta) { return rates(theta).place; });
  const double speed_turn = turning_point([&](double theta) { return rates(theta).speed; });
  double behind = min(turn, speed_turn);
  if (!differs(behind)) behind = max(turn, speed_turn);
  if (!differs(behind)) behind = 1;
  if (!differs(behind)) return 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (before + behind);
    (differs(middle) ? behind : before) = middle;
  }
  return behind;
}

PHYSIM_ISA_END
