// Wind: the velocity of the air.
//
// What it models: `constant`: one vector everywhere; `profile`: vectors by height above the origin or by downrange
//   distance, straight lines between them or steps; all three components, so that updraughts are included. It blows in
//   air that turns with the Earth; over a round Earth it turns with the vertical (model/earth.hpp), and level wind
//   stays level. Where the environment gives a function of place and time, `profile` is that, in W
//   (model/field_function.hpp). A shot with a wind of its own beside a profile has w_i + m instead of w_i.
// When it is wrong: no turbulence, and but for functions no change in time; horizontal changes only through a profile
//   by range.
// Symbols: w velocity of the air in W [m/s]; u height or downrange distance [m]; u_i places of the profile's points.
// Equation: w(u) = w_0 + sum_i slope_i clamp(u - u_i, 0, u_{i+1} - u_i): straight lines without a search, equal for all
//   lanes; points above all lanes add nothing and are not read.
// Source: linear interpolation; the convention of signs is that of R. L. McCoy, Modern Exterior Ballistics (1999),
//   ch. 7.
#pragma once

#include "base/assert.hpp"
#include "model/earth.hpp"
#include "model/field_function.hpp"

PHYSIM_ISA_BEGIN

/// The wind of a profile as it blows at the origin; `w` comes as that of its first point. With weather of its own all
/// points of the profile are moved. Behind a call: it is long.
template <class R, class S>
PHYSIM_NOINLINE void profile_wind(const Conditions<S>& c, const Body<R>& b, const Vec3<R>& x, Vec3<R>& w) {
  const WindField<S>& field = c.wind;
  const WindPiece<S>* points = c.wind_pieces;
  PHYSIM_ASSERT(field.points >= 2 && points != nullptr);
  const R u = field.by_range ? x.x : height(c, x);
  Vec3<R> here = w;
  w += Vec3<R>{R(S(0)), R(S(0)), R(S(0))};  // -0 becomes 0, to which the zeros of further points change no bit
  for (int i = 0; i + 1 < field.points && any(u > R(points[i].at)); ++i) {
    const Components<S>& velocity = points[i + 1].velocity;
    Vec3<R> next{R(velocity.x), R(velocity.y), R(velocity.z)};
    if (c.has_own_wind) next += b.wind;
    if (field.stepped) {
      const auto past = u >= R(points[i + 1].at);
      w.x = select(past, next.x, w.x);
      w.y = select(past, next.y, w.y);
      w.z = select(past, next.z, w.z);
    } else {
      const R inside = clamp(u - R(points[i].at), R(S(0)), R(points[i + 1].at - points[i].at));
      const Components<S>& slope = points[i].slope;
      // As the slopes of moved points are rounded.
      w += (c.has_own_wind ? (next - here) * R(points[i].per_length) : Vec3<R>{R(slope.x), R(slope.y), R(slope.z)}) *
           inside;
      here = next;
    }
  }
}

/// As it blows at the origin.
template <class R, class S>
PHYSIM_INLINE Vec3<R> wind_at_origin(const Conditions<S>& c, const Body<R>& b, const R& t, const Vec3<R>& x) {
  const WindField<S>& field = c.wind;
  if (c.has_own_wind && field.points == 0) return b.wind;
  Vec3<R> w{R(field.velocity.x), R(field.velocity.y), R(field.velocity.z)};
  if (c.fidelity.wind != WindModel::profile) return w;
  if (c.has_own_wind) w += b.wind;
  if (c.has_wind_function)
    wind_by_function(c, b, t, x, w);
  else if (field.points >= 2)
    profile_wind(c, b, x, w);
  return w;
}

template <class R, class S>
PHYSIM_INLINE Vec3<R> wind(const Conditions<S>& c, const Body<R>& b, const R& t, const Vec3<R>& x) {
  const Vec3<R> w = wind_at_origin(c, b, t, x);
  if (!is_round(c.fidelity.earth) || c.has_wind_function) return w;
  Vec3<R> turned = w;
  turn_with_vertical(c, x, turned);
  return turned;
}

/// Velocity through the air [m/s].
template <class R, class S>
PHYSIM_INLINE Vec3<R> air_velocity(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  return c.fidelity.wind == WindModel::off ? s.v : s.v - wind(c, b, t, s.x);
}

/// Whether the wind has pieces by place.
template <class S>
PHYSIM_INLINE bool has_wind_pieces(const Conditions<S>& c) {
  return c.fidelity.wind == WindModel::profile && !c.has_wind_function;
}

PHYSIM_ISA_END
