// Closed forms: exact flight in vacuum, or with drag linear in the velocity through a constant wind.
//
// What it models: constant gravity g and linear drag of rate k against a wind w.
// When to use it: arcade shots, previews of aim, sparks, rain, slow small particles (creeping flow).
// When it is wrong: drag of anything larger than a grain grows with the square of its speed.
// Symbols: x0, v0 at time 0; t [s]; k [1/s]; z = k t; w [m/s]; g [m/s^2] (a vector here).
// Equations: v = w + (v0 - w) e^-z + g t E1(z),  x = x0 + w t + (v0 - w) t E1(z) + g t^2 E2(z),
//   E1(z) = (1 - e^-z) / z,  E2(z) = (z - 1 + e^-z) / z^2 = (1 - E1(z)) / z; k = 0 gives v0 t + g t^2 / 2.
//   E1 and E2 lose digits for small z; there Taylor's series is used.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), ch. 3 (vacuum); N. de Mestre, The Mathematics of Projectiles
//   in Sport (1990), ch. 2 (drag proportional to velocity).
#pragma once

#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "model/body.hpp"
#include "model/conditions.hpp"

PHYSIM_ISA_BEGIN

/// E2(z) = sum over n of (-z)^n / (n + 2)!; E1(z) = 1 - z E2(z).
template <class R>
PHYSIM_INLINE R second_decay_integral(const R& z) {
  using S = ScalarOf<R>;
  R series(S(0));
  double factorial_inverse = 1.0 / 6402373705728000.0;  // 1 / 18!
  for (int n = 16; n >= 0; --n) {
    series = constant<R>(factorial_inverse) - z * series;
    factorial_inverse *= n + 2;
  }
  const auto small = z < R(S(1));
  const R safe = select(small, R(S(1)), z);
  return select(small, series, (safe - S(1) + exp(-safe)) / (safe * safe));
}

template <class R, class S>
PHYSIM_INLINE State<R> closed_form_of_free(const Conditions<S>& c, const Body<R>& b, const R& t) {
  const State<R>& start = b.launch;
  R g(c.fidelity.gravity == GravityModel::off ? S(0) : -c.gravity);
  if (c.has_gravity_scale) g *= b.gravity_scale;
  const R half = constant<R>(0.5);
  State<R> s;
  if (c.fidelity.drag == DragModel::off) {
    s.x = start.x + start.v * t;
    s.x.y += half * g * t * t;
    s.v = start.v;
    s.v.y += g * t;
    return s;
  }
  const R z = b.damping_rate * t;
  const R e2 = second_decay_integral(z);
  const R decayed = t * (S(1) - z * e2);  // t E1
  const bool windy = c.fidelity.wind != WindModel::off;
  const Vec3<S> w = windy ? c.wind.velocity : Vec3<S>{};
  Vec3<R> air{R(w.x), R(w.y), R(w.z)};
  if (c.has_own_wind) air = b.wind;
  if (c.fidelity.planar) air -= b.plane * dot(b.plane, air);
  const Vec3<R> relative = start.v - air;
  s.x = start.x + air * t + relative * decayed;
  s.x.y += g * t * t * e2;
  s.v = air + relative * exp(-z);
  s.v.y += g * decayed;
  return s;
}

/// The state at time t after launch. Frozen axes stay as they were: the axes do not mix.
template <class R, class S>
PHYSIM_NOINLINE State<R> closed_form(const Conditions<S>& c, const Body<R>& b, const R& t) {
  PHYSIM_ASSERT(c.fidelity.motion == Motion::closed_form);
  State<R> s = closed_form_of_free(c, b, t);
  if (c.has_frozen) {
    s.x = b.launch.x + component_product(s.x - b.launch.x, b.free);
    s.v = component_product(s.v, b.free);
  }
  return s;
}

PHYSIM_ISA_END
