// Equations and symbols: model/rigid_body.hpp.
// Source: geometry.
#include "model/attitude.hpp"

#include <algorithm>
#include <cmath>

#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/quat.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

/// The shortest turn that takes the x axis of W to a unit vector.
Quatd shortest_turn_to(const Vec3d& x) {
  if (x.x <= -1 + 1e-12) return {0, 0, 0, 1};
  return normalized(Quatd{1 + x.x, 0, -x.z, x.y});
}

/// x along a unit vector, z level to its right.
Quatd level_turn_to(const Vec3d& x) {
  const double level = sqrt(x.x * x.x + x.z * x.z);
  return quat_from_yaw_pitch_roll(level == 0 ? 0.0 : atan2(x.z, x.x), atan2(x.y, level), 0.0);
}

Vec3d omega_of_W(const Conditions<double>& c) { return is_turning(c.fidelity.earth) ? c.omega : Vec3d{}; }

}  // namespace

double spin_of(const Fidelity& f, const Rotor<double>& rotor, const Turn<double>& t) {
  PHYSIM_ASSERT(turns(f));
  if (is_in_repose(f) || !is_axis_form(f)) return t.h.x;
  return dot(t.h, normalized(t.u)) * (rotor.moments.y * rotor.inverse_moments.x);
}

Attitude attitude_of(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double time,
                     const State<double>& s, const Turn<double>& t) {
  const Fidelity& f = c.fidelity;
  if (!is_axis_form(f)) return {normalized(Quatd{t.w, t.u.x, t.u.y, t.u.z}), t.h};
  const Vec3d x = nose_of(c, b, rotor, time, s, t);
  const auto half = sincos(0.5 * t.w);
  const Quatd q = normalized(shortest_turn_to(x) * Quatd{half.cos, half.sin, 0, 0});
  Vec3d omega{};
  if (!is_in_repose(f)) omega = rotate(conjugate(q), t.h - x * dot(t.h, x));
  omega.x = spin_of(f, rotor, t);
  return {q, omega};
}

Turn<double> turn_of(const Fidelity& f, const Rotor<double>& rotor, const Attitude& a) {
  const Quatd& q = a.q_WB;
  PHYSIM_ASSERT(turns(f) && !(abs(norm_squared(q) - 1) > 1e-6));
  if (!is_axis_form(f)) return {q.w, {q.x, q.y, q.z}, a.omega};
  const Vec3d x = rotate(q, Vec3d{1, 0, 0});
  const Quatd roll = conjugate(shortest_turn_to(x)) * q;
  if (is_in_repose(f)) return {2 * atan2(roll.x, roll.w), {1, 0, 0}, {a.omega.x, 0, 0}};
  const double part = rotor.moments.x * rotor.inverse_moments.y;
  return {2 * atan2(roll.x, roll.w), x, rotate(q, Vec3d{a.omega.x * part, a.omega.y, a.omega.z})};
}

Attitude launch_attitude(const ProjectileDef& p, const Launch& launch, const Vec3d& velocity, const Vec3d& bore,
                         const Conditions<double>& c) {
  PHYSIM_ASSERT(!(abs(length_squared(bore) - 1) > 1e-9));
  const LaunchAttitude& given = launch.attitude;
  Attitude a;
  const double speed = length(velocity);
  a.q_WB = quat_from_yaw_pitch_roll(given.yaw, given.pitch, given.roll);
  if (given.frame == AttitudeFrame::bore) a.q_WB = level_turn_to(speed > 0 ? velocity * (1 / speed) : bore) * a.q_WB;
  a.omega = given.rates;
  if (p.twist != 0) a.omega.x += 2 * kPi * speed / p.twist;
  if (given.rate_frame == RateFrame::world) a.omega += rotate(conjugate(a.q_WB), omega_of_W(c));
  return a;
}

double angle_between(const Vec3d& a, const Vec3d& b) {
  const double across = length(cross(a, b)), along = dot(a, b);
  return across == 0 && along == 0 ? 0 : atan2(across, along);
}

bool has_inertia(const ProjectileDef& p) { return !(p.inertia == Inertia{}); }

bool is_axisymmetric(const ProjectileDef& p) {
  return p.inertia.moments.y == p.inertia.moments.z && p.inertia.products == Vec3d{};
}

namespace {

/// Symmetric, in units of a power of two, so that its largest moment lies between 1 and 2: its determinant neither
/// overflows nor underflows, and the unit rounds nothing.
struct ScaledInertia {
  Vec3d moments, products;
  double per_unit;

  explicit ScaledInertia(const Inertia& i) {
    per_unit = std::ldexp(1.0, -std::ilogb(std::max({i.moments.x, i.moments.y, i.moments.z})));
    moments = i.moments * per_unit;
    products = i.products * per_unit;
  }
  [[nodiscard]] double determinant() const {
    const auto& [a, b, c] = moments;
    const auto& [xy, xz, yz] = products;
    return a * (b * c - yz * yz) - xy * (xy * c - xz * yz) + xz * (xy * yz - b * xz);
  }
};

}  // namespace

bool is_possible(const Inertia& i) {
  const auto& [a, b, c] = i.moments;
  // Beyond these the inverse is not finite.
  constexpr double kLeast = 1e-300, kMost = 1e300;
  if (!(std::min({a, b, c}) >= kLeast && std::max({a, b, c}) <= kMost)) return false;
  const bool triangle = a <= b + c && b <= a + c && c <= a + b;
  const ScaledInertia scaled(i);
  const double minor = scaled.moments.x * scaled.moments.y - scaled.products.x * scaled.products.x;
  return triangle && minor > 0 && scaled.determinant() > 0;
}

Rotor<double> prepare_rotor(const ProjectileDef& p) {
  Rotor<double> r{};
  r.moments = p.inertia.moments;
  r.products = p.inertia.products;
  const ScaledInertia scaled(p.inertia);
  const auto& [a, b, c] = scaled.moments;
  const auto& [xy, xz, yz] = scaled.products;
  const double determinant = scaled.determinant();
  PHYSIM_ASSERT(determinant > 0);
  const double scale = 1 / determinant;
  r.inverse_moments = Vec3d{b * c - yz * yz, a * c - xz * xz, a * b - xy * xy} * scale * scaled.per_unit;
  r.inverse_products = Vec3d{xz * yz - xy * c, xy * yz - b * xz, xy * xz - a * yz} * scale * scaled.per_unit;
  if (r.products == Vec3d{}) r.inverse_moments = {1 / r.moments.x, 1 / r.moments.y, 1 / r.moments.z};  // not rounded
  return r;
}

}  // namespace physim
