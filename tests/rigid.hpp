// Rigid bodies that several tests fly, and the exact rates of a body without torque.
#pragma once

#include "model/attitude.hpp"
#include "support.hpp"

namespace physim::test {

inline constexpr double kSlugFt2 = 14.5939029372063648 * 0.3048 * 0.3048;  // [kg m^2]

/// The brick of the NASA/NESC check-cases (TM-2015-218675), Iyy about its right axis, which is z here.
inline ProjectileDef nasa_brick() {
  return {.name = "brick",
          .mass = 0.155404754 * 14.5939029372063648,
          .drag = {.coefficient = 0},
          .inertia = {.moments = Vec3d{0.001894220, 0.007194665, 0.006211019} * kSlugFt2}};
}

/// Rates p, q, r about forward, right and down, along body axes x forward, y up, z right.
inline Vec3d body_rates(double p, double q, double r) { return {p, -r, q}; }

/// 10, 20 and 30 deg/s, as NASA case 2 starts.
inline Launch spun_launch() { return {.attitude = {.rates = body_rates(10 * kDegree, 20 * kDegree, 30 * kDegree)}}; }

/// Rigid body in vacuum.
inline Fidelity rigid(Integrator integrator, BodyForm form = BodyForm::automatic) {
  Fidelity f = vacuum(integrator);
  f.rotation = RotationModel::rigid_body;
  f.body_form = form;
  return f;
}

/// Jacobi's sn, cn, dn of argument u and parameter m by descending Landen transformations.
struct Jacobi {
  double sn, cn, dn;
};
inline Jacobi jacobi(double u, double m) {
  double a[20], c[20];
  a[0] = 1;
  double b = std::sqrt(1 - m);
  c[0] = std::sqrt(m);
  int n = 0;
  while (std::abs(c[n]) > 1e-17 && n < 18) {
    a[n + 1] = 0.5 * (a[n] + b);
    c[n + 1] = 0.5 * (a[n] - b);
    b = std::sqrt(a[n] * b);
    ++n;
  }
  double phi = std::ldexp(a[n] * u, n);
  double before = phi;
  for (; n > 0; --n) {
    before = phi;
    phi = 0.5 * (std::asin(c[n] * std::sin(phi) / a[n]) + phi);
  }
  return {std::sin(phi), std::cos(phi), std::cos(phi) / std::cos(before - phi)};
}

/// Rates about the principal axes of a body without torque, moments A < B < C, whose H^2 > 2 E B (it turns about C).
/// `phase` is the argument at time 0 (Landau and Lifshitz, Mechanics (1976), sec. 37).
struct FreeTop {
  double A, B, C, E2, H2;  // twice the energy, the square of the momentum

  FreeTop(const Vec3d& moments, const Vec3d& rates)
      : A(moments.x),
        B(moments.y),
        C(moments.z),
        E2(A * rates.x * rates.x + B * rates.y * rates.y + C * rates.z * rates.z),
        H2(A * A * rates.x * rates.x + B * B * rates.y * rates.y + C * C * rates.z * rates.z) {}

  [[nodiscard]] double parameter() const { return (B - A) * (E2 * C - H2) / ((C - B) * (H2 - E2 * A)); }
  [[nodiscard]] double speed() const { return std::sqrt((C - B) * (H2 - E2 * A) / (A * B * C)); }
  [[nodiscard]] Vec3d at(double argument) const {
    const Jacobi j = jacobi(argument, parameter());
    return {std::sqrt((E2 * C - H2) / (A * (C - A))) * j.cn, std::sqrt((E2 * C - H2) / (B * (C - B))) * j.sn,
            std::sqrt((H2 - E2 * A) / (C * (C - A))) * j.dn};
  }
};

}  // namespace physim::test
