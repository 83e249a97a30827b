#include "flight/known_step.hpp"

#include <limits>
#include <utility>

#include "solve/dense.hpp"

namespace physim {
namespace {

template <int kCount>
PHYSIM_INLINE void copy_numbers(const double (&from)[kCount], double (&to)[kCount]) {
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA { ((to[I] = from[I]), ...); }
  (std::make_integer_sequence<int, kCount>());
}
/// Number by number: a pair that was stored as two numbers is slow to load as one.
PHYSIM_INLINE void copy_state(const State<double>& from, State<double>& to) {
  to.x.x = from.x.x, to.x.y = from.x.y, to.x.z = from.x.z;
  to.v.x = from.v.x, to.v.y = from.v.y, to.v.z = from.v.z;
}

/// A point mass with a drag curve and nothing special about it, in the standard's air below the top of its first layer.
template <GravityModel kGravity, EarthModel kEarth, WindModel kWind>
struct PlainRung {
  static bool matches(const Conditions<double>& c) {
    const Fidelity& f = c.fidelity;
    return f.motion == Motion::force && f.gravity == kGravity && f.earth == kEarth && f.drag == DragModel::equation &&
           f.air == AirModel::isa && f.wind == kWind && !f.planar && !turns(f) && !spins(f) &&
           static_cast<const Features&>(c) == Features{};
  }
  PHYSIM_INLINE static bool is_below_top(const Conditions<double>& c, const State<double>& y) {
    return !(y.x.y + c.altitude > c.air.low_top);
  }
  /// The conditions that this rung reads.
  PHYSIM_INLINE static Conditions<double> known(const Conditions<double>& c) {
    Conditions<double> k;
    k.fidelity.motion = Motion::force;
    k.fidelity.gravity = kGravity;
    k.fidelity.earth = kEarth;
    k.fidelity.drag = DragModel::equation;
    k.fidelity.air = AirModel::isa;
    k.fidelity.wind = kWind;
    k.fidelity.rotation = RotationModel::none;
    k.fidelity.planar = false;
    k.gravity = c.gravity;
    k.radius = c.radius;
    k.altitude = c.altitude;
    k.omega = c.omega;
    copy_numbers(c.air.common.low_density, k.air.common.low_density);
    copy_numbers(c.air.common.low_per_sound, k.air.common.low_per_sound);
    k.air.low_middle = c.air.low_middle;
    k.air.low_scale = c.air.low_scale;
    k.air.low_top = std::numeric_limits<double>::quiet_NaN();  // nothing is above it
    k.wind.points = 1;
    k.wind.velocity[0] = c.wind.velocity[0];
    k.curve_rows = c.curve_rows;
    return k;
  }
};

// Sums of slopes as step_sum() and weighted_sum() make them, in their order; written out wherever they are asked for.
template <class Weights, int kTerm, bool kBegins>
PHYSIM_INLINE void add_term(State<double>& sum, const State<double>& slope, double h) {
  constexpr double weight = Weights::at(kTerm);
  if constexpr (weight == 0)
    return;
  else if constexpr (kBegins && kTerm == first_nonzero<Weights>())
    sum = slope * (h * weight);
  else
    add_scaled(sum, slope, h * weight);
}
/// Over a step of length h; `first` is what the sum begins with, if anything.
template <class Weights, int kCount, class... First>
PHYSIM_INLINE State<double> sum_of_slopes(const State<double>* slope, double h, const First&... first) {
  State<double> sum{first...};
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA {
    (add_term<Weights, I, sizeof...(First) == 0>(sum, slope[I], h), ...);
  }
  (std::make_integer_sequence<int, kCount>());
  return sum;
}

/// The cells of the drag curve that the stages of a step read, guessed before their Mach numbers are known: the last
/// stage's, or after a wide gap between stages where the last two come to lie on one line. The first stage guesses
/// wrong and waits: whether a guess holds is known to the processor before, stage by stage.
template <class Method>
class StageCells {
 public:
  explicit StageCells(const Body<double>& b, const double* rows) : b_(b), rows_(rows) {}

  template <int kStage>
  PHYSIM_INLINE GuessedCell<double>& guess() {
    if constexpr (kStage >= 3 && kStage < Method::kStages) {
      constexpr double kGap = Method::c[kStage] - Method::c[kStage - 1];
      if constexpr (kGap > 0.3)
        guess_cell(b_, rows_, last_ + (last_ - before_) * (kGap / (Method::c[kStage - 1] - Method::c[kStage - 2])),
                   guess_);
    }
    return guess_;
  }
  PHYSIM_INLINE void note() { before_ = last_, last_ = guess_.place; }

 private:
  const Body<double>& b_;
  const double* rows_;
  GuessedCell<double> guess_{-1, nullptr, 0};
  double last_ = 0, before_ = 0;  // places of the stages taken [cells]
};

template <class Rung, class Method>
struct KnownSlope {
  const Conditions<double>& c;
  const Body<double>& b;
  StageCells<Method> cells{b, c.curve_rows};

  /// Returns whether the rung is what holds there.
  template <int kStage>
  PHYSIM_INLINE bool put(double t, const State<double>& y, State<double>& slope) {
    Conditions<double> k = Rung::known(c);  // made anew each time, or the compiler forgets what is known
    k.guess = &cells.template guess<kStage>();
    const Vec3d a = acceleration(k, b, t, y);
    copy_state({y.v, a}, slope);
    cells.note();
    return Rung::is_below_top(c, y);
  }
};

template <class Method, int kStage, class Slope>
PHYSIM_INLINE bool take_stage(Step<double>& s, const State<double>& start, Slope& slope) {
  const State<double> y = sum_of_slopes<RowWeights<Method::a, kStage>, kStage>(s.slope, s.h, start);
  return slope.template put<kStage>(s.t + s.h * Method::c[kStage], y, s.slope[kStage]);
}

/// Behind a call: all integrators and models are long, and few steps get above the first layer.
[[gnu::noinline]] void take_any_step(const Conditions<double>& c, Flyer<double>& flyer, double relative,
                                     double absolute) {
  take_step(c, flyer, relative, absolute);
}

template <class Method, class Rung>
void take_known_step(const Conditions<double>& c, Flyer<double>& flyer, double relative, double absolute) {
  PHYSIM_ASSERT(Rung::matches(c));
  Step<double>& s = flyer.step;
  constexpr int kSlopes = Method::kStages + 1;
  KnownSlope<Rung, Method> slope{c, flyer.body};
  State<double> start;
  copy_state(s.start, start);
  bool holds = true;
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA {
    ((holds &= take_stage<Method, I + 1>(s, start, slope)), ...);
  }
  (std::make_integer_sequence<int, Method::kStages - 1>());
  const State<double> end = start + sum_of_slopes<Weights<Method::b>, Method::kStages>(s.slope, s.h);
  holds &= slope.template put<Method::kStages>(s.t_end, end, s.slope[Method::kStages]);
  if (!holds) return take_any_step(c, flyer, relative, absolute);
  const auto e = squared_errors(sum_of_slopes<Weights<Method::kError>, kSlopes>(s.slope, s.h), end, relative, absolute);
  s.error = worse(e.first, e.second);
  copy_state(end, s.end);
}

template <class Method>
PHYSIM_INLINE void interpolate(const State<double>* slope, double h, State<double>* coefficients) {
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA {
    (copy_state(sum_of_slopes<PolynomialWeights<Method, I>, Method::kStages + 1>(slope, 1) * h, coefficients[I]), ...);
  }
  (std::make_integer_sequence<int, dense_coefficients_of<Method>()>());
}
template <class Method>
void interpolate_known_step(const Step<double>& s, State<double>* coefficients) {
  interpolate<Method>(s.slope, s.h, coefficients);
}

template <class Method>
constexpr auto interpolation_of() {
  return dense_coefficients_of<Method>() > 0 ? interpolate_known_step<Method> : nullptr;
}

template <class Method, class First, class... Rest>
KnownStep step_of_rungs(const Conditions<double>& c) {
  if (First::matches(c)) return {take_known_step<Method, First>, interpolation_of<Method>()};
  if constexpr (sizeof...(Rest) > 0)
    return step_of_rungs<Method, Rest...>(c);
  else
    return {};
}
template <class Method>
KnownStep step_of(const Conditions<double>& c) {
  using enum GravityModel;
  using enum EarthModel;
  constexpr WindModel kCalm = WindModel::off;
  constexpr WindModel kWind = WindModel::constant;
  return step_of_rungs<Method, PlainRung<constant, flat, kCalm>, PlainRung<constant, flat, kWind>,
                       PlainRung<inverse_square, flat_coriolis, kCalm>,
                       PlainRung<inverse_square, flat_coriolis, kWind>>(c);
}

}  // namespace

static_assert(KeptStep::kInner == Tsit5::kStages - 1);

void keep_slopes(const Step<double>& step, KeptStep& kept) {
  kept.h = step.h;
  const State<double>* from = step.slope + 1;
  for (State<double>& to : *kept.slopes) copy_state(*from++, to);
}

void keep_end(const Step<double>& step, Node& node) {
  PHYSIM_ASSERT(step.t_end > step.t);
  node.t = step.t_end;
  State<double> slope;
  copy_state(step.slope[Tsit5::kStages], slope);
  copy_state(step.end, node.y);
  node.a = slope.v;
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
  if (c.fidelity.integrator == Integrator::tsit5) return step_of<Tsit5>(c);
  if (c.fidelity.integrator == Integrator::rk43) return step_of<Rk43>(c);
  return {};
}

}  // namespace physim
