// Rigid body: the attitude of a projectile under moments, with six degrees of freedom.
//
// What it models: Euler's equations of a rigid body of any inertia, in the frame W that may turn with the Earth. Two
//   forms of the same physics: `quaternion` for any body; `axis` for bodies that are symmetric about x and spin fast,
//   with steps that need to resolve the motion of the symmetry axis only, not every turn of the spin.
// When to use it: where the attitude matters: shells that yaw, finned rockets, tumbling bricks, the true drift.
// When it is wrong: bodies that bend, slosh or burn from within; no gravity gradient (satellites over hours).
// Symbols: q = q_WB quaternion [-]; omega angular velocity in I along body axes [rad/s]; I inertia tensor [kg m^2]; M
//   moment [N m]; Omega angular velocity of W in I [rad/s]; x symmetry axis in W [-]; h = H / It angular momentum over
//   the transverse moment of inertia [rad/s]; p = (It / Ix) h.x spin [rad/s]; phi roll angle [rad]; e direction of the
//   x axis of W.
// Equations: quaternion form: omega' = I^-1 (M - omega x (I omega));  q' = 1/2 q (omega - R^T Omega);
//   axis form: h' = M / It - Omega x h;  x' = (h - Omega) x x;  phi' = p - Omega.x + e.(x x x') / (1 + e.x).
//   The roll angle counts from the shortest turn that takes e to x; its rate about x is -e.(x x x') / (1 + e.x);
//   where x points against e it is not defined, and nothing but the roll that is shown depends on it.
//   After every step |q| or |x| is set back to one; within a step only their directions count.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), ch. 9 (vector form); B. L. Stevens, F. L. Lewis,
//   Aircraft Control and Simulation (2003), eq. 1.3-21, 1.4-2 (Euler's equations, quaternion).
#pragma once

#include "math/vec3.hpp"
#include "model/conditions.hpp"
#include "model/earth.hpp"
#include "model/rotor.hpp"

PHYSIM_ISA_BEGIN

// ------------------------------------------------------------------------------------------- the algebra of a Turn
template <class R>
PHYSIM_INLINE Turn<R> operator+(const Turn<R>& a, const Turn<R>& b) {
  return {a.w + b.w, a.u + b.u, a.h + b.h};
}
template <class R>
PHYSIM_INLINE Turn<R> operator-(const Turn<R>& a, const Turn<R>& b) {
  return {a.w - b.w, a.u - b.u, a.h - b.h};
}
template <class R>
PHYSIM_INLINE Turn<R> operator*(const Turn<R>& a, const R& s) {
  return {a.w * s, a.u * s, a.h * s};
}
template <class R>
PHYSIM_INLINE void add_scaled(Turn<R>& sum, const Turn<R>& a, const R& s) {
  sum.w += a.w * s;
  add_scaled(sum.u, a.u, s);
  add_scaled(sum.h, a.h, s);
}

// ------------------------------------------------------------------------------------------- both forms
PHYSIM_INLINE constexpr bool is_axis_form(const Fidelity& f) {
  return f.body_form == BodyForm::axis || is_in_repose(f);
}

/// A symmetric tensor times a vector.
template <class R>
PHYSIM_INLINE Vec3<R> tensor_product(const Vec3<R>& diagonal, const Vec3<R>& products, const Vec3<R>& v) {
  return {diagonal.x * v.x + products.x * v.y + products.y * v.z,
          products.x * v.x + diagonal.y * v.y + products.z * v.z,
          products.y * v.x + products.z * v.y + diagonal.z * v.z};
}

/// v turned by the quaternion (w, u) of any length.
template <class R>
PHYSIM_INLINE Vec3<R> turned_by(const R& w, const Vec3<R>& u, const Vec3<R>& v) {
  using S = ScalarOf<R>;
  const R scale = S(2) / (w * w + length_squared(u));
  const Vec3<R> t = cross(u, v);
  return v + (t * w + cross(u, t)) * scale;
}

/// The x axis of the body in W, a unit vector [-].
template <class R>
PHYSIM_INLINE Vec3<R> forward(const Fidelity& f, const Turn<R>& t) {
  using S = ScalarOf<R>;
  if (is_axis_form(f)) return t.u * (S(1) / length(t.u));
  return turned_by(t.w, t.u, Vec3<R>{R(S(1)), R(S(0)), R(S(0))});
}

/// Sets the length of what stands for a direction back to one.
template <class R>
PHYSIM_INLINE Turn<R> on_unit_length(const Fidelity& f, const Turn<R>& t) {
  using S = ScalarOf<R>;
  const bool axis = is_axis_form(f);
  const R scale = S(1) / sqrt(axis ? length_squared(t.u) : t.w * t.w + length_squared(t.u));
  return {axis ? t.w : t.w * scale, t.u * scale, t.h};
}

template <class R, class S>
PHYSIM_INLINE Turn<R> quaternion_slope(const Conditions<S>& c, const Rotor<R>& b, const Turn<R>& t,
                                       const Vec3<R>& moment) {
  const Vec3<R> momentum = tensor_product(b.moments, b.products, t.h);
  Turn<R> slope;
  slope.h = tensor_product(b.inverse_moments, b.inverse_products, moment - cross(t.h, momentum));
  Vec3<R> rate = t.h;  // of B in W, along body axes
  if (is_turning(c.fidelity.earth)) rate -= turned_by(R(-t.w), t.u, Vec3<R>{R(c.omega.x), R(c.omega.y), R(c.omega.z)});
  rate *= R(S(0.5));
  slope.w = -dot(t.u, rate);
  slope.u = rate * t.w + cross(t.u, rate);
  return slope;
}

template <class R, class S>
PHYSIM_INLINE Turn<R> axis_slope(const Conditions<S>& c, const Rotor<R>& b, const Turn<R>& t, const Vec3<R>& moment) {
  const Vec3<R> x = t.u * (S(1) / length(t.u));
  Turn<R> slope;
  slope.h = moment * b.inverse_moments.y;
  Vec3<R> across = t.h;  // what turns the axis in W
  R roll = dot(t.h, x) * (b.moments.y * b.inverse_moments.x);
  if (is_turning(c.fidelity.earth)) {
    const Vec3<R> omega{R(c.omega.x), R(c.omega.y), R(c.omega.z)};
    slope.h -= cross(omega, t.h);
    across -= omega;
    roll -= dot(omega, x);
  }
  slope.u = cross(across, t.u);
  const R behind = max(x.x + S(1), constant<R>(1e-12));
  slope.w = roll + (x.y * slope.u.z - x.z * slope.u.y) / (length(t.u) * behind);
  return slope;
}

/// The slope of a Turn under a moment [N m]: along body axes in the quaternion form, along W in the axis form.
template <class R, class S>
PHYSIM_INLINE Turn<R> turn_slope(const Conditions<S>& c, const Rotor<R>& b, const Turn<R>& t, const Vec3<R>& moment) {
  return is_axis_form(c.fidelity) ? axis_slope(c, b, t, moment) : quaternion_slope(c, b, t, moment);
}

PHYSIM_ISA_END
