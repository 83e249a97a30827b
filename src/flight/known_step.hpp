// Steps on the rungs that most single flights stand on, known at compile time: the models, the same functions, fold to
// straight code. A single flight waits for its own numbers; here they stay in registers, where going through memory
// would take as long as computing them.
#pragma once

#include "solve/lanes.hpp"

namespace physim {

/// How a step is taken whose rung and integrator are known.
struct KnownStep {
  /// Takes one, as take_step() does, to the bit: a flyer's slopes, its end and its error.
  void (*take)(const Conditions<double>& c, Flyer<double>& flyer, double relative, double absolute) = nullptr;
  /// The coefficients of its interpolant, as dense_sums() makes them, to the bit.
  void (*interpolate)(const Step<double>& step, State<double>* coefficients) = nullptr;

  explicit operator bool() const { return take != nullptr; }
};

/// The step of what flies under some conditions; none where no known rung matches.
[[nodiscard]] KnownStep known_step(const Conditions<double>& c);

}  // namespace physim
