#include "flight/known_step.hpp"

#include <limits>
#include <utility>

#include "flight/plain_rung.hpp"
#include "solve/judge.hpp"

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
    return is_plain(c, {.gravity = kGravity, .earth = kEarth, .wind = kWind});
  }
  PHYSIM_INLINE static bool is_below_top(const Conditions<double>& c, const Vec3d& place) {
    return !(place.y + c.altitude > c.air.low_top);
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
    k.fidelity.interpolation = c.fidelity.interpolation;
    k.gravity = c.gravity;
    k.radius = c.radius;
    k.altitude = c.altitude;
    k.omega = c.omega;
    copy_numbers(c.air.common.low_density, k.air.common.low_density);
    copy_numbers(c.air.common.low_per_sound, k.air.common.low_per_sound);
    k.air.low_middle = c.air.low_middle;
    k.air.low_scale = c.air.low_scale;
    k.air.low_top = std::numeric_limits<double>::quiet_NaN();  // nothing is above it
    k.air.base[1] = c.air.base[1];
    k.wind.points = 1;
    k.wind.velocity[0] = c.wind.velocity[0];
    k.curve_rows = c.curve_rows;
    return k;
  }
};

// Sums of slopes as step_sum() and weighted_sum() make them, in their order, of places or of velocities; written out
// wherever they are asked for.
using Part = Vec3d State<double>::*;
template <class Weights, Part kPart, int kTerm, bool kBegins>
PHYSIM_INLINE void add_term(Vec3d& sum, const State<double>& slope, double h) {
  constexpr double weight = Weights::at(kTerm);
  if constexpr (weight == 0)
    return;
  else if constexpr (kBegins && kTerm == first_nonzero<Weights>())
    sum = slope.*kPart * (h * weight);
  else
    add_scaled(sum, slope.*kPart, h * weight);
}
/// Over a step of length h; `first` is what the sum begins with, if anything.
template <class Weights, Part kPart, int kCount, class... First>
PHYSIM_INLINE Vec3d sum_of(const State<double>* slope, double h, const First&... first) {
  Vec3d sum{first...};
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA {
    (add_term<Weights, kPart, I, sizeof...(First) == 0>(sum, slope[I], h), ...);
  }
  (std::make_integer_sequence<int, kCount>());
  return sum;
}
template <class Weights, int kCount>
PHYSIM_INLINE State<double> sum_of_slopes(const State<double>* slope, double h) {
  return {sum_of<Weights, &State<double>::x, kCount>(slope, h), sum_of<Weights, &State<double>::v, kCount>(slope, h)};
}

/// The cells of the drag curve that the stages of steps read, guessed before their Mach numbers are known: where the
/// line through the last two places leads. Whether a guess holds is known to the processor before, mostly.
template <class Method>
class StageCells {
 public:
  explicit StageCells(const Body<double>& b, const double* rows) : b_(b), rows_(rows) {}

  /// A step of length h is tried.
  PHYSIM_INLINE void begin(double h) {
    last_ = start_;
    before_ = start_ - rate_ * h;
  }
  template <int kStage>
  PHYSIM_INLINE GuessedCell<double>& guess() {
    constexpr double kGap = kStage < Method::kStages ? Method::c[kStage] - Method::c[kStage - 1] : 0;
    constexpr double kGapBefore = kStage == 1 ? 1 : Method::c[kStage - 1] - Method::c[kStage - 2];
    if constexpr (kGap > 0.05) guess_cell(b_, rows_, last_ + (last_ - before_) * (kGap / kGapBefore), guess_);
    return guess_;
  }
  template <int kStage>
  PHYSIM_INLINE void note() {
    if constexpr (kStage == Method::kStages - kBehind) reference_ = guess_.place;
    before_ = last_, last_ = guess_.place;
  }
  /// A step of length h is over; the next one starts at its end.
  PHYSIM_INLINE void accept(double h) {
    PHYSIM_ASSERT(h > 0);
    rate_ = (last_ - reference_) / (h * (1 - Method::c[Method::kStages - kBehind]));
    start_ = last_;
  }

 private:
  static constexpr int kBehind = Method::kStages == 4 ? 2 : 3;  // stages back from the end, one lies well before it
  static_assert(Method::c[Method::kStages - kBehind] < 0.95);

  const Body<double>& b_;
  const double* rows_;
  GuessedCell<double> guess_{std::numeric_limits<double>::quiet_NaN(), nullptr, 0};  // none: no cell is equal to it
  double last_ = 0, before_ = 0;  // places of the stages taken [cells]
  double start_ = 0, rate_ = 0;   // where the step starts, and how the place changed before that [cells], [1/s]
  double reference_ = 0;
};

/// Weights of the slopes that lead to a stage; the stage behind the last one is the end of the step.
template <class Method, int kStage>
struct StageWeights {
  static constexpr double at(int j) {
    if constexpr (kStage < Method::kStages)
      return Method::a[kStage][j];
    else
      return Method::b[j];
  }
};

/// The stages of a step, one after the other. Each waits for the acceleration of the one before, and goes on from it
/// in as few operations as there are: sums have their last term left then, and the root of the speed is under way
/// before the air is looked at, which depends on the place and is known early.
template <class Rung, class Method>
class KnownStages {
 public:
  PHYSIM_INLINE KnownStages(const Conditions<double>& c, const Body<double>& b, Step<double>& s,
                            StageCells<Method>& cells)
      : c_(c), b_(b), s_(s), cells_(cells) {
    cells.begin(s.h);
    copy_state(s.start, start_);
    State<double> first;
    copy_state(s.slope[0], first);
    lead<1>();
    come<1>(first);
  }

  /// Leaves the slope of a stage.
  template <int kStage>
  PHYSIM_INLINE void take() {
    State<double> slope{state_.v, {}};
    if constexpr (kStage < Method::kStages) lead<kStage + 1>();
    Conditions<double> k = Rung::known(c_);  // made anew each time, or the compiler forgets what is known
    k.guess = &cells_.template guess<kStage>();
    slope.v = acceleration(k, b_, time<kStage>(), state_, air_);
    copy_state(slope, s_.slope[kStage]);
    cells_.template note<kStage>();
    if constexpr (kStage < Method::kStages) come<kStage + 1>(slope);
  }

  [[nodiscard]] PHYSIM_INLINE const State<double>& end() const { return state_; }
  /// Whether the rung is what holds at all stages.
  [[nodiscard]] PHYSIM_INLINE bool holds() const { return holds_; }

 private:
  template <int kStage>
  using SumWeights = StageWeights<Method, kStage>;

  /// A sum but for its last term.
  template <int kStage, Part kPart>
  [[nodiscard]] PHYSIM_INLINE Vec3d lead_of() const {
    if constexpr (kStage == 1)
      return start_.*kPart;
    else if constexpr (kStage < Method::kStages)
      return sum_of<SumWeights<kStage>, kPart, kStage - 1>(s_.slope, s_.h, start_.*kPart);
    else
      return sum_of<SumWeights<kStage>, kPart, kStage - 1>(s_.slope, s_.h);
  }
  template <int kStage, Part kPart>
  [[nodiscard]] PHYSIM_INLINE Vec3d whole(Vec3d sum, const State<double>& last) const {
    add_term<SumWeights<kStage>, kPart, kStage - 1, false>(sum, last, s_.h);
    return kStage < Method::kStages ? sum : start_.*kPart + sum;
  }
  template <int kStage>
  PHYSIM_INLINE void lead() {
    lead_ = lead_of<kStage, &State<double>::v>();
  }
  template <int kStage>
  PHYSIM_INLINE void come(const State<double>& last) {
    const Conditions<double> k = Rung::known(c_);
    state_.v = whole<kStage, &State<double>::v>(lead_, last);
    air_.u = air_velocity(k, b_, time<kStage>(), state_);  // which asks for no place
    air_.speed = length(air_.u);
    state_.x = whole<kStage, &State<double>::x>(lead_of<kStage, &State<double>::x>(), last);
    air_.air = air_state(k, b_, state_.x);
    holds_ &= Rung::is_below_top(c_, state_.x);
  }
  template <int kStage>
  [[nodiscard]] PHYSIM_INLINE double time() const {
    if constexpr (kStage < Method::kStages)
      return s_.t + s_.h * Method::c[kStage];
    else
      return s_.t_end;
  }

  const Conditions<double>& c_;
  const Body<double>& b_;
  Step<double>& s_;
  State<double> start_;
  StageCells<Method>& cells_;
  Vec3d lead_;                   // to the velocity of the stage that comes next
  State<double> state_;          // of the stage at hand, in the end the step's end
  PointInKnownAir<double> air_;  // there
  bool holds_ = true;
};

/// Behind a call: all integrators and models are long, and few steps get above the first layer.
[[gnu::noinline]] void take_any_step(const Conditions<double>& c, Flyer<double>& flyer, double relative,
                                     double absolute) {
  take_step(c, flyer, relative, absolute);
}

template <class Method, class Rung>
PHYSIM_INLINE void take_known(const Conditions<double>& c, Flyer<double>& flyer, double relative, double absolute,
                              StageCells<Method>& cells) {
  PHYSIM_ASSERT(Rung::matches(c));
  Step<double>& s = flyer.step;
  constexpr int kSlopes = Method::kStages + 1;
  KnownStages<Rung, Method> stages(c, flyer.body, s, cells);
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA { (stages.template take<I + 1>(), ...); }
  (std::make_integer_sequence<int, Method::kStages>());
  if (!stages.holds()) return take_any_step(c, flyer, relative, absolute);
  const State<double>& end = stages.end();
  const auto e = squared_errors(sum_of_slopes<Weights<Method::kError>, kSlopes>(s.slope, s.h), end, relative, absolute);
  s.error = worse(e.first, e.second);
  copy_state(end, s.end);
}

template <class Method, class Rung>
void take_known_step(const Conditions<double>& c, Flyer<double>& flyer, double relative, double absolute) {
  StageCells<Method> cells(flyer.body, c.curve_rows);
  take_known<Method, Rung>(c, flyer, relative, absolute, cells);
}

template <class Method>
constexpr Integrator integrator_of() {
  static_assert(std::is_same_v<Method, Tsit5> || std::is_same_v<Method, Rk43>);
  return std::is_same_v<Method, Tsit5> ? Integrator::tsit5 : Integrator::rk43;
}

PHYSIM_INLINE void put_slopes(const Step<double>& step, KeptStep& kept) {
  kept.h = step.h;
  const State<double>* from = step.slope + 1;
  for (State<double>& to : *kept.slopes) copy_state(*from++, to);
}
template <class Method>
PHYSIM_INLINE void keep_end_of(const Step<double>& step, Node& node) {
  PHYSIM_ASSERT(step.t_end > step.t);
  node.t = step.t_end;
  State<double> slope;
  copy_state(step.slope[Method::kStages], slope);
  copy_state(step.end, node.y);
  node.a = slope.v;
}

/// A place at the end of a list, which grows in few steps: what is long already is mostly a long flight's.
template <class T>
PHYSIM_INLINE T& one_more(std::vector<T>& list) {
  PHYSIM_ASSERT(list.capacity() > 0);
  if (list.size() == list.capacity()) list.reserve(4 * list.size());
  return list.emplace_back();
}

template <class Method, class Rung>
bool go_on_known(KnownFlight& f) {
  March<double>& march = f.march;
  const Lanes<double>& l = march.lanes;
  const Course<double>& course = march.course();
  const Conditions<double>& c = *course.conditions;
  PHYSIM_ASSERT(Rung::matches(c) && c.fidelity.integrator == integrator_of<Method>() && !f.nodes.empty());
  if (!f.is_watched) f.quiet->begin(c, course.watch, l);
  StageCells<Method> cells(l.body, c.curve_rows);
  for (f.is_watched = true;;) {
    Conditions<double> k = Rung::known(c);
    k.fidelity.integrator = integrator_of<Method>();
    const auto take = [&](const Conditions<double>& all, Flyer<double>& flyer, double relative, double absolute)
                          PHYSIM_INLINE_LAMBDA { take_known<Method, Rung>(all, flyer, relative, absolute, cells); };
    const bool accepted = march.try_step_by(k, true, take);
    if (march.is_stuck()) return accepted;
    if (!accepted) continue;
    f.is_watched = f.quiet->passes(c, course.watch, l, Method::kStages) && ends_finite(k.fidelity, l.step);
    if (!f.is_watched) return true;
    keep_end_of<Method>(l.step, one_more(f.nodes));
    if constexpr (dense_coefficients_of<Method>() > 0) put_slopes(l.step, one_more(f.kept));
    cells.accept(l.step.h);
    march.accept(k, true);
  }
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
  if (First::matches(c))
    return {take_known_step<Method, First>, go_on_known<Method, First>, interpolation_of<Method>()};
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

void keep_slopes(const Step<double>& step, KeptStep& kept) { put_slopes(step, kept); }
void keep_end(const Step<double>& step, Node& node) { keep_end_of<Tsit5>(step, node); }

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
