// The stages of a step on a rung that is known at compile time: the models, the same functions, fold to straight code.
// A single flight waits for its own numbers; here they stay in registers, where going through memory would take as long
// as computing them.
#pragma once

#include <utility>

#include "flight/known_step.hpp"
#include "flight/plain_rung.hpp"
#include "solve/take_step.hpp"

PHYSIM_ISA_BEGIN

/// Number by number: a pair that was stored as two numbers is slow to load as one.
PHYSIM_INLINE void copy_vector(const Vec3<double>& from, Vec3<double>& to) {
  to.x = from.x, to.y = from.y, to.z = from.z;
}

/// A point mass with a drag curve and nothing special about it, in the standard's air below the top of its first layer.
/// Calm air is a wind of zero.
template <GravityModel kGravity, EarthModel kEarth>
struct KnownRung {
  /// The conditions that this rung reads; LowAirOfOne reads the air.
  PHYSIM_INLINE static Conditions<double> known(const Conditions<double>& c) {
    Conditions<double> k;
    k.fidelity.motion = Motion::force;
    k.fidelity.gravity = kGravity;
    k.fidelity.earth = kEarth;
    k.fidelity.drag = DragModel::equation;
    k.fidelity.air = AirModel::isa;
    k.fidelity.wind = WindModel::constant;
    k.fidelity.rotation = RotationModel::none;
    k.fidelity.planar = false;
    k.fidelity.interpolation = c.fidelity.interpolation;
    k.gravity = c.gravity;
    k.radius = c.radius;
    k.altitude = c.altitude;
    k.omega = c.omega;
    k.air.base[1] = c.air.base[1];
    k.wind.points = 0;
    k.wind.velocity = c.wind.velocity;
    k.curve_rows = c.curve_rows;
    return k;
  }
};

// Sums of slopes as step_sum() and weighted_sum() make them, in their order, of places or of velocities; written out
// wherever they are asked for.
template <class Weights, int kTerm, bool kBegins>
PHYSIM_INLINE void add_term(Vec3<double>& sum, const Vec3<double>& slope, double h) {
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
PHYSIM_INLINE Vec3<double> sum_of(const Vec3<double>* slope, double h, const First&... first) {
  Vec3<double> sum{first...};
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA {
    (add_term<Weights, I, sizeof...(First) == 0>(sum, slope[I], h), ...);
  }
  (std::make_integer_sequence<int, kCount>());
  return sum;
}

/// The cells of the drag curve that the stages of steps read, guessed before their Mach numbers are known: where the
/// line through the last two places leads. Whether a guess holds is known to the processor before, mostly.
template <class Method>
class StageCells {
 public:
  PHYSIM_INLINE StageCells(const Body<double>& b, const double* rows, const CurvePlace& from)
      : b_(b), rows_(rows), guess_(from.guess), start_(from.start), rate_(from.rate) {}

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
  [[nodiscard]] PHYSIM_INLINE CurvePlace place() const { return {guess_, start_, rate_}; }

 private:
  static constexpr int kBehind = Method::kStages == 4 ? 2 : 3;  // stages back from the end, one lies well before it
  static_assert(Method::c[Method::kStages - kBehind] < 0.95);

  const Body<double>& b_;
  const double* rows_;
  GuessedCell<double> guess_;
  double last_ = 0, before_ = 0;  // places of the stages taken [cells]
  double start_, rate_;           // as of CurvePlace
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

/// A place on a path: state and acceleration.
struct Standpoint {
  Vec3<double> x, v, a;
};
PHYSIM_INLINE void copy(const Standpoint& from, Standpoint& to) {
  copy_vector(from.x, to.x), copy_vector(from.v, to.v), copy_vector(from.a, to.a);
}
PHYSIM_INLINE Standpoint start_of(const Step<double>& s) {
  Standpoint start;
  copy_vector(s.start.x, start.x), copy_vector(s.start.v, start.v), copy_vector(s.slope[0].v, start.a);
  return start;
}

/// The stages of a step, one after the other. Each waits for the acceleration of the one before, and continues from it
/// in as few operations as there are: sums have their last term left then, and the root of the speed is under way
/// before the air is looked at, which depends on the place and is known early.
template <class Rung, class Method>
class KnownStages {
 public:
  PHYSIM_INLINE KnownStages(const Conditions<double>& c, const LowAirOfOne& low_air, const Body<double>& b, double t,
                            double h, double t_end, const Standpoint& start, StageCells<Method>& cells)
      : c_(c), low_air_(low_air), b_(b), t_(t), h_(h), t_end_(t_end), cells_(cells) {
    cells.begin(h);
    copy_vector(start.x, x_[0]), copy_vector(start.v, v_[0]), copy_vector(start.a, a_[0]);
    lead<1>();
    come<1>();
    [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA { (take<I + 1>(), ...); }
    (std::make_integer_sequence<int, kEnd>());
  }

  /// Whether the rung is what holds at all stages.
  [[nodiscard]] PHYSIM_INLINE bool holds() const { return holds_; }
  [[nodiscard]] PHYSIM_INLINE Standpoint end() const {
    Standpoint end;
    copy_vector(x_[1], end.x), copy_vector(v_[kEnd], end.v), copy_vector(a_[kEnd], end.a);
    return end;
  }
  /// As of embedded_error_squared().
  [[nodiscard]] PHYSIM_INLINE double error(double relative, double absolute) const {
    using Error = Weights<Method::kError>;
    const State<double> sum{sum_of<Error, kEnd + 1>(v_, h_), sum_of<Error, kEnd + 1>(a_, h_)};
    const auto e = squared_errors(sum, State<double>{x_[1], v_[kEnd]}, relative, absolute);
    return worse(e.first, e.second);
  }
  /// Slopes of the stages between both ends.
  PHYSIM_INLINE void put_inner_slopes(State<double>* to) const {
    [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA { (put_slope<I + 1>(to[I]), ...); }
    (std::make_integer_sequence<int, kEnd - 1>());
  }
  /// What a step leaves: its slopes, its end and its error.
  PHYSIM_INLINE void put(double error, Step<double>& s) const {
    put_inner_slopes(s.slope.item + 1);
    put_slope<kEnd>(s.slope[kEnd]);
    copy_vector(x_[1], s.end.x), copy_vector(v_[kEnd], s.end.v);
    s.error = error;
  }

 private:
  static constexpr int kEnd = Method::kStages;  // the slope at the end

  template <int kStage>
  PHYSIM_INLINE void put_slope(State<double>& to) const {
    copy_vector(v_[kStage], to.x), copy_vector(a_[kStage], to.v);
  }

  /// The acceleration at a stage, and the way to the next one.
  template <int kStage>
  PHYSIM_INLINE void take() {
    if constexpr (kStage < kEnd) lead<kStage + 1>();
    Conditions<double> k = Rung::known(c_);  // made again each time, or the compiler forgets what is known
    k.guess = &cells_.template guess<kStage>();
    a_[kStage] = acceleration(k, b_, time<kStage>(), State<double>{x_[1], v_[kStage]}, air_);
    cells_.template note<kStage>();
    if constexpr (kStage < kEnd) come<kStage + 1>();
  }

  /// The sum that leads to a stage, but for its last term.
  template <int kStage>
  [[nodiscard]] PHYSIM_INLINE static Vec3<double> lead_of(const Vec3<double>* slope, double h,
                                                          const Vec3<double>& start) {
    using Sum = StageWeights<Method, kStage>;
    if constexpr (kStage == 1)
      return start;
    else if constexpr (kStage < kEnd)
      return sum_of<Sum, kStage - 1>(slope, h, start);
    else
      return sum_of<Sum, kStage - 1>(slope, h);
  }
  template <int kStage>
  [[nodiscard]] PHYSIM_INLINE static Vec3<double> whole(Vec3<double> sum, const Vec3<double>& last, double h,
                                                        const Vec3<double>& start) {
    add_term<StageWeights<Method, kStage>, kStage - 1, false>(sum, last, h);
    return kStage < kEnd ? sum : start + sum;
  }
  template <int kStage>
  PHYSIM_INLINE void lead() {
    lead_ = lead_of<kStage>(a_, h_, v_[0]);
  }
  template <int kStage>
  PHYSIM_INLINE void come() {
    const Conditions<double> k = Rung::known(c_);
    v_[kStage] = whole<kStage>(lead_, a_[kStage - 1], h_, v_[0]);
    air_.u = air_velocity(k, b_, time<kStage>(), State<double>{{}, v_[kStage]});  // which needs no place
    air_.speed = length(air_.u);
    x_[1] = whole<kStage>(lead_of<kStage>(v_, h_, x_[0]), v_[kStage - 1], h_, x_[0]);
    air_.air = low_air_(altitude(k, x_[1]));
    holds_ &= is_in_low_air(c_, x_[1]);
  }
  template <int kStage>
  [[nodiscard]] PHYSIM_INLINE double time() const {
    if constexpr (kStage < kEnd)
      return t_ + h_ * Method::c[kStage];
    else
      return t_end_;
  }

  const Conditions<double>& c_;
  const LowAirOfOne& low_air_;
  const Body<double>& b_;
  double t_, h_, t_end_;
  StageCells<Method>& cells_;
  Vec3<double> x_[2];                       // at the start, and at the stage at hand
  Vec3<double> v_[kEnd + 1], a_[kEnd + 1];  // at the start, and at the stages
  Vec3<double> lead_;                       // to the velocity of the stage that comes next
  PointInKnownAir<double> air_;             // at the stage at hand
  bool holds_ = true;
};

PHYSIM_ISA_END
