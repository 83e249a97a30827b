// Steps on the rungs that most single flights stand on, known at compile time (flight/known_stages.hpp).
#pragma once

#include <array>
#include <limits>

#include "base/unset.hpp"
#include "flight/plain_rung.hpp"
#include "solve/corners.hpp"

namespace physim {

/// The rungs that are known.
inline constexpr PlainRungs kKnownRungs[] = {
    {GravityModel::constant, EarthModel::flat},
    {GravityModel::inverse_square, EarthModel::flat_coriolis},
};

/// What a step of Tsit5 leaves for its interpolant beside the nodes at its ends, which hold the first slope and the
/// last.
struct KeptStep {
  static constexpr int kInner = 5;
  KeptStep() {}  // NOLINT: not set to zero first

  double h;                                           // [s]
  Unset<std::array<State<double>, kInner>> slopes{};  // between them
};

/// Where a flight stands on its drag curve: from there the cells are guessed that its next step reads.
struct CurvePlace {
  GuessedCell<double> guess{std::numeric_limits<double>::quiet_NaN(), nullptr, 0};  // none: no cell is equal to it
  double start = 0, rate = 0;  // where the step starts, and how the place changed before that [cells], [1/s]
};

/// What a flight from a launch that meets nothing needs, step by step. It may be begun where may_go_on() says so.
struct KnownFlight {
  const Course<double>& course;
  Lanes<double>& lanes;
  Node* node;  // where the end of the next step is kept
  Node* end_of_nodes;
  KeptStep* kept;        // where what its interpolant needs is kept; as many as nodes, or none
  CurvePlace& on_curve;  // from call to call
};

/// Why steps do not go on.
enum class KnownEnd {
  rejected,         // the last step tried has to be looked at
  accepted,         // it has, and it is to be accepted
  of_another_rung,  // the next step is one that is not known
  out_of_room,      // for nodes
};
/// How a run of known steps ended.
struct KnownStop {
  KnownEnd why;
  WatchedSet may_cross;  // what a step that has to be looked at may have crossed; of others nothing is known: all
};

/// How steps of a known rung and integrator are taken.
struct KnownStep {
  /// Takes steps and keeps them, one after the other, as March does by take_step(), to the bit; the last one tried, if
  /// it needs a closer look, is neither accepted yet nor kept.
  KnownStop (*go_on)(KnownFlight& flight) = nullptr;
  /// The coefficients of its interpolant, as dense_sums() makes them, to the bit; none where it is made of both ends.
  void (*interpolate)(const Step<double>& step, State<double>* coefficients) = nullptr;

  explicit operator bool() const { return go_on != nullptr; }
};

void keep_slopes(const Step<double>& step, KeptStep& kept);
void keep_end(const Step<double>& step, Node& node);
/// The coefficients of its interpolant, made when they are asked for: as KnownStep::interpolate() makes them.
void interpolate_kept(const KeptStep& kept, const Node& n0, const Node& n1, State<double>* coefficients);

/// The step of what flies under some conditions; none where no known rung matches.
[[nodiscard]] KnownStep known_step(const Conditions<double>& c);

/// The step, without its interpolant, of kKnownRungs[rung] by Tsit5 or RK4(3) (flight/known_loop.cpp).
[[nodiscard]] KnownStep known_step_on(int rung, Integrator integrator);

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Whether a flight may go on by known steps: what they know nothing of, corners but those of the air and the air above
/// its first layer, is not at hand.
PHYSIM_INLINE bool may_go_on(const Course<double>& course, const Lanes<double>& l) {
  const Conditions<double>& c = *course.conditions;
  if (course.corners && !(only_air_has_corners(c) && starts_in_first_layer(l))) return false;
  return is_in_low_air(c, l.step.start.x);
}

PHYSIM_ISA_END
