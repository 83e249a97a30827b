#include "flight/known_step.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "flight/known_stages.hpp"
#include "solve/dense.hpp"

namespace physim {

namespace {

PHYSIM_INLINE void copy_state(const State<double>& from, State<double>& to) {
  copy_vector(from.x, to.x);
  copy_vector(from.v, to.v);
}

template <class Weights, int kCount>
PHYSIM_INLINE State<double> sum_of_slopes(const State<double>* slope) {
  Vec3<double> x[kCount], v[kCount];
  for (int i = 0; i < kCount; ++i) copy_vector(slope[i].x, x[i]), copy_vector(slope[i].v, v[i]);
  return {sum_of<Weights, kCount>(x, 1), sum_of<Weights, kCount>(v, 1)};
}
template <class Method>
PHYSIM_INLINE void interpolate(const State<double>* slope, double h, State<double>* coefficients) {
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA {
    (copy_state(sum_of_slopes<PolynomialWeights<Method, I>, Method::kStages + 1>(slope) * h, coefficients[I]), ...);
  }
  (std::make_integer_sequence<int, dense_coefficients_of<Method>()>());
}
void interpolate_tsit5(const Step<double>& s, State<double>* coefficients) {
  interpolate<Tsit5>(s.slope.item, s.h, coefficients);
}

}  // namespace

static_assert(KeptStep::kInner == Tsit5::kStages - 1);
static_assert(dense_coefficients_of<Rk43>() == 0);

void keep_slopes(const Step<double>& step, KeptStep& kept) {
  kept.h = step.h;
  const State<double>* from = step.slope.item + 1;
  for (State<double>& to : *kept.slopes) copy_state(*from++, to);
}
void keep_end(const Step<double>& step, Node& node) {
  PHYSIM_ASSERT(step.t_end >= step.t);  // a step that is too short for the clock ends the flight as stalled
  node.t = step.t_end;
  copy_state(step.end, node.y);
  copy_vector(step.slope[Tsit5::kStages].v, node.a);
}

void interpolate_kept(const KeptStep& kept, const Node& n0, const Node& n1, State<double>* coefficients) {
  Unset<std::array<State<double>, KeptStep::kInner + 2>> slopes;
  State<double>* slope = slopes->data();
  copy_state({n0.y.v, n0.a}, *slope++);
  for (const State<double>& inner : *kept.slopes) copy_state(inner, *slope++);
  copy_state({n1.y.v, n1.a}, *slope);
  interpolate<Tsit5>(slopes->data(), kept.h, coefficients);
}

KnownStep known_step(const Conditions<double>& c) {
  const Integrator integrator = c.fidelity.integrator;
  if (integrator != Integrator::tsit5 && integrator != Integrator::rk43) return {};
  const auto rung = std::ranges::find_if(kKnownRungs, [&](const PlainRungs& rungs) { return is_plain(c, rungs); });
  if (rung == std::end(kKnownRungs)) return {};
  PHYSIM_ASSERT(is_calm_without_wind(c));
  KnownStep step = known_step_on(static_cast<int>(rung - kKnownRungs), integrator);
  if (integrator == Integrator::tsit5) step.interpolate = interpolate_tsit5;
  return step;
}

}  // namespace physim
