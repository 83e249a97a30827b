// Steps on the rungs that most single flights stand on, known at compile time: the models, the same functions, fold to
// straight code. A single flight waits for its own numbers; here they stay in registers, where going through memory
// would take as long as computing them.
#pragma once

#include <array>
#include <vector>

#include "solve/march.hpp"

namespace physim {

struct KnownFlight;

/// How steps are taken whose rung and integrator are known.
struct KnownStep {
  /// Takes one, as take_step() does, to the bit: a flyer's slopes, its end and its error.
  void (*take)(const Conditions<double>& c, Flyer<double>& flyer, double relative, double absolute) = nullptr;
  /// Takes steps and keeps them, one after the other, as March does, to the bit; the last one tried, which somebody has
  /// to look at, is neither accepted yet nor kept. Returns whether it is to be accepted.
  bool (*go_on)(KnownFlight& flight) = nullptr;
  /// The coefficients of its interpolant, as dense_sums() makes them, to the bit; none where it is made of both ends.
  void (*interpolate)(const Step<double>& step, State<double>* coefficients) = nullptr;

  explicit operator bool() const { return take != nullptr; }
};

/// What a step of Tsit5 leaves for its interpolant beside the nodes at its ends, which hold the first slope and the
/// last.
struct KeptStep {
  static constexpr int kInner = 5;
  KeptStep() {}  // NOLINT: not set to zero first

  double h;                                           // [s]
  Unset<std::array<State<double>, kInner>> slopes{};  // between them
};

/// What a flight from a launch that meets nothing needs, step by step.
struct KnownFlight {
  March<double>& march;
  std::vector<Node>& nodes;
  std::vector<KeptStep>& kept;  // where interpolants are made of them
  bool is_watched = false;      // the step at hand, by that which follows
  Unset<QuietWatch<double>> quiet{};
};

void keep_slopes(const Step<double>& step, KeptStep& kept);
void keep_end(const Step<double>& step, Node& node);
/// The coefficients of its interpolant, made when they are asked for: as KnownStep::interpolate() makes them.
void interpolate_kept(const KeptStep& kept, const Node& n0, const Node& n1, State<double>* coefficients);

/// The step of what flies under some conditions; none where no known rung matches.
[[nodiscard]] KnownStep known_step(const Conditions<double>& c);

}  // namespace physim
