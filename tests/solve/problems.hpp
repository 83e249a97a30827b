// Smooth problems with known solutions, and a driver that takes fixed steps with any integrator.
#pragma once

#include <functional>

#include "solve/dense.hpp"
#include "support.hpp"

namespace physim::test {

/// Fall from rest against quadratic drag, in units of terminal speed and gravity: v = -tanh t, y = -ln cosh t.
inline State<double> tanh_fall(double t) { return {{0, -std::log(std::cosh(t)), 0}, {0, -std::tanh(t), 0}}; }

inline Prepared prepare_tanh_fall(Integrator integrator) {
  ProjectileDef p{.drag = {.k2 = 1}};
  Environment e = constant_gravity();
  e.gravity.acceleration = 1;
  Fidelity f = vacuum(integrator);
  f.drag = DragModel::linear_quadratic;
  return Prepared(p, {}, e, f);
}

inline constexpr double kEccentricity = 0.3;

/// An orbit with GM = 1 and periapsis at distance 1 above the origin, `t` after it (Kepler's equation by Newton).
inline State<double> kepler(double t) {
  const double e = kEccentricity, a = 1 / (1 - e), n = std::sqrt(1 / (a * a * a)), b = a * std::sqrt(1 - e * e);
  double anomaly = n * t;
  for (int i = 0; i < 50; ++i) anomaly -= (anomaly - e * std::sin(anomaly) - n * t) / (1 - e * std::cos(anomaly));
  const double rate = n / (1 - e * std::cos(anomaly));
  return {{b * std::sin(anomaly), a * (std::cos(anomaly) - e) - 1, 0},
          {b * rate * std::cos(anomaly), -a * rate * std::sin(anomaly), 0}};
}

/// Newton's law round an Earth of radius 1, from the state at time `start`.
inline Prepared prepare_kepler(Integrator integrator, double start) {
  Environment e{.gravity = {.acceleration = 1, .radius = 1}};
  Fidelity f = vacuum(integrator);
  f.gravity = GravityModel::inverse_square;
  f.earth = EarthModel::sphere;
  const State<double> s = kepler(start);
  return Prepared({}, {.position = s.x, .velocity = s.v}, e, f);
}

/// A finished step and its dense output.
struct DenseStep {
  Integrator integrator;
  Node n0, n1;
  State<double> coefficient[kMaxDenseCoefficients];

  [[nodiscard]] State<double> at(double theta) const { return dense_state(integrator, n0, n1, coefficient, theta); }
};

inline Step<double> first_step_of(const Prepared& p) {
  Step<double> s{};
  s.start = p.body.launch;
  // The original loop feels no force in its first frame.
  const bool classic = p.conditions().fidelity.integrator == Integrator::classic;
  s.slope[0] = {s.start.v, classic ? Vec3d{} : p.acceleration(0, s.start)};
  return s;
}

/// Takes s.h from s.start.
inline DenseStep step_once(const Prepared& p, Step<double>& s) {
  const Integrator integrator = p.conditions().fidelity.integrator;
  s.t_end = s.t + s.h;
  Flyer<double> flyer;
  flyer.body = p.body;
  *flyer.rotor = p.rotor;
  flyer.step = s;
  take_step(p.conditions(), flyer, 1e-9, 1e-9);
  s = flyer.step;
  DenseStep out{integrator, {s.t, s.start, s.slope[0].v}, {s.t_end, s.end, s.slope[end_slope(integrator)].v}, {}};
  dense_coefficients(
      integrator, s, [&](double t, const State<double>& y) { return p.acceleration(t, y); }, out.coefficient);
  return out;
}

/// n equal steps over `duration`; `visit` sees each. Returns the end.
inline State<double> steps(const Prepared& p, double duration, int n,
                           const std::function<void(const DenseStep&)>& visit = {}) {
  Step<double> s = first_step_of(p);
  s.h = duration / n;
  for (int i = 0; i < n; ++i) {
    s.t = i * s.h;
    const DenseStep taken = step_once(p, s);
    if (visit) visit(taken);
    s.start = s.end;
    s.slope[0] = s.slope[end_slope(p.conditions().fidelity.integrator)];
  }
  return s.start;
}

inline double distance(const State<double>& a, const State<double>& b) { return length(a.x - b.x) + length(a.v - b.v); }

/// The exponent of an error that behaves like h^order, from errors at n and at n * factor steps.
inline double observed_order(double coarse, double fine, double factor) {
  return std::log(coarse / fine) / std::log(factor);
}

}  // namespace physim::test
