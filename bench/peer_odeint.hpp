// Boost.odeint's dopri5, for files that compile it with different flags.
#pragma once

#include <array>
#include <boost/numeric/odeint.hpp>

#include "peer_rhs.hpp"

namespace physim::bench {
namespace {

/// A type of this file alone makes its templates this file's alone: the linker must not share them between flags.
struct OwnOperations : boost::numeric::odeint::default_operations {};

/// Whether the highest point is found too, as fly() does without having been asked.
enum class ApexToo { no, yes };

/// The time of the highest point in the step just taken, by the secant method on the dense output.
template <class Stepper>
double apex_in_step(Stepper& stepper) {
  double t0 = stepper.previous_time(), climb0 = stepper.previous_state()[4];
  double t = stepper.current_time(), climb = stepper.current_state()[4];
  auto y = stepper.current_state();
  for (int n = 0; n < 10 && std::abs(climb) > 1e-10; ++n) {
    const double next = t - climb * (t - t0) / (climb - climb0);
    t0 = t, climb0 = climb, t = next;
    stepper.calc_state(t, y);
    climb = y[4];
  }
  return t;
}

template <AirBy kAir = AirBy::polynomials, ApexToo kApex = ApexToo::no>
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
      if (kApex == ApexToo::yes && stepper.previous_state()[4] > 0 && stepper.current_state()[4] <= 0)
        task.ends[i].apex = apex_in_step(stepper);
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
    task.ends[i].time = t;
    std::copy_n(y.begin(), 3, task.ends[i].position);
  }
  task.evaluations += evaluations;
}

}  // namespace

}  // namespace physim::bench
