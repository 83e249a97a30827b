// Boost.odeint's dopri5, for files that compile it with different flags.
#pragma once

#include <array>
#include <boost/numeric/odeint.hpp>

#include "peer_rhs.hpp"

namespace physim::bench {
namespace {

/// A type of this file alone makes its templates this file's alone: the linker must not share them between flags.
struct OwnOperations : boost::numeric::odeint::default_operations {};

template <AirBy kAir = AirBy::polynomials>
void fly_dopri5(PeerTask& task) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 6>;
  const PeerModel& model = *task.model;
  std::int64_t evaluations = 0;
  const auto rhs = [&](const State& y, State& slope, double) {
    peer_rhs<kAir>(model, y.data(), slope.data());
    ++evaluations;
  };
  using Stepper =
      odeint::runge_kutta_dopri5<State, double, State, double, odeint::algebra_dispatcher<State>::algebra_type,
                                 OwnOperations, odeint::initially_resizer>;
  auto stepper = odeint::make_dense_output(task.tolerance, task.tolerance, Stepper());
  const double first = peer_first_step(task.tolerance);
  for (std::size_t i = 0; i < task.shots.size(); ++i) {
    State y{};
    peer_launch(task.shots[i], y.data());
    stepper.initialize(y, 0.0, first);
    do {
      stepper.do_step(rhs);
      ++task.steps;
    } while (stepper.current_state()[0] < task.range);
    // Newton's method on the dense output, from the straight line through the step.
    const double x0 = stepper.previous_state()[0];
    const double part = (task.range - x0) / (stepper.current_state()[0] - x0);
    double t = stepper.previous_time() + part * (stepper.current_time() - stepper.previous_time());
    for (int n = 0; n < 10; ++n) {
      stepper.calc_state(t, y);
      const double miss = task.range - y[0];
      if (std::abs(miss) < 1e-10) break;
      t += miss / y[3];
    }
    task.ends[i] = {t, {y[0], y[1], y[2]}};
  }
  task.evaluations += evaluations;
}

}  // namespace

}  // namespace physim::bench
