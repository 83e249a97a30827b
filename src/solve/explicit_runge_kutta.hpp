// Explicit Runge-Kutta methods from their tableaus, and the one loop that runs them all.
//
// A tableau is a[i][j] (stage i from slope j), b (the step), c (stage times); the loops are unrolled at compile time
// and zeros cost nothing. Every effect is evaluated in every stage: freezing density or Cd over a step would make any
// of these methods first order.
//
// Sources: J. C. Butcher, Numerical Methods for Ordinary Differential Equations (2008), sec. 23 (Heun, RK4);
//   C. Tsitouras, "Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying assumption", Computers
//   & Mathematics with Applications 62 (2011) 770-775, table 1 and sec. 4 (dense output);
//   M. Sofroniou, G. Spaletta, "Construction of explicit Runge-Kutta pairs with stiffness detection", Mathematical and
//   Computer Modelling 40 (2004) 1157-1169 (the pair 4(3)); E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary
//   Differential Equations I (1993), sec. II.5, II.6 and the coefficients of their code DOP853 (8(5,3) pair of Dormand
//   and Prince, dense output of order 7).
#pragma once

#include <utility>

#include "base/assert.hpp"
#include "physim/fidelity.hpp"
#include "solve/step.hpp"

PHYSIM_ISA_BEGIN

/// The original frame loop and semi-implicit Euler have no tableau: one slope, and ends of their own
/// (solve/take_step.hpp).
struct OneSlope {
  static constexpr int kStages = 1;
  static constexpr int kOrder = 1;
  static constexpr double c[1] = {0};
};
struct ClassicLoop : OneSlope {};
struct SemiImplicitEuler : OneSlope {};

struct ExplicitEuler : OneSlope {
  static constexpr double a[1][1] = {{}};
  static constexpr double b[1] = {1};
};

struct Heun {
  static constexpr int kStages = 2;
  static constexpr int kOrder = 2;
  static constexpr double a[2][2] = {{}, {1}};
  static constexpr double b[2] = {0.5, 0.5};
  static constexpr double c[2] = {0, 1};
};

struct Rk4 {
  static constexpr int kStages = 4;
  static constexpr int kOrder = 4;
  static constexpr double a[4][4] = {{}, {0.5}, {0, 0.5}, {0, 0, 1}};
  static constexpr double b[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  static constexpr double c[4] = {0, 0.5, 0.5, 1};
};

struct Rk43 {
  static constexpr int kStages = 4;
  static constexpr int kOrder = 4;
  static constexpr double a[4][4] = {{}, {2.0 / 5}, {-3.0 / 20, 3.0 / 4}, {19.0 / 44, -15.0 / 44, 10.0 / 11}};
  static constexpr double b[4] = {11.0 / 72, 25.0 / 72, 25.0 / 72, 11.0 / 72};
  static constexpr double c[4] = {0, 2.0 / 5, 3.0 / 5, 1};
  /// Order 3 minus order 4, on the four stages and the slope at the end.
  static constexpr double kError[5] = {1251515.0 / 8970912 - b[0], 3710105.0 / 8970912 - b[1],
                                       2519695.0 / 8970912 - b[2], 61105.0 / 8970912 - b[3], 119041.0 / 747576};
};

struct Tsit5 {
  static constexpr int kStages = 6;
  static constexpr int kOrder = 5;
  static constexpr double a[6][6] = {
      {},
      {0.161},
      {-0.008480655492356989, 0.335480655492357},
      {2.8971530571054935, -6.359448489975075, 4.3622954328695815},
      {5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525},
      {5.86145544294642, -12.92096931784711, 8.159367898576159, -0.071584973281401, -0.028269050394068383}};
  static constexpr double b[6] = {0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.290069515436081,
                                  2.324710524099774};
  static constexpr double c[6] = {0, 0.161, 0.327, 0.9, 0.9800255409045097, 1};
  /// Order 4 minus order 5, on the six stages and the slope at the end.
  static constexpr double kError[7] = {-0.00178001105222577714,
                                       -0.0008164344596567469,
                                       0.007880878010261995,
                                       -0.1447110071732629,
                                       0.5823571654525552,
                                       -0.45808210592918697,
                                       1.0 / 66};
  /// Dense output: weight of slope i is theta (p[i][0] + theta (p[i][1] + theta (p[i][2] + theta p[i][3]))).
  static constexpr double kDense[7][4] = {{1, -2.763706197274826, 2.9132554618219126, -1.0530884977290216},
                                          {0, 0.13169999999999998, -0.2234, 0.1017},
                                          {0, 3.9302962368947516, -5.941033872131505, 2.490627285651253},
                                          {0, -12.411077166933676, 30.33818863028232, -16.548102889244902},
                                          {0, 37.50931341651104, -88.1789048947664, 47.37952196281928},
                                          {0, -27.896526289197286, 65.09189467479366, -34.87065786149661},
                                          {0, 1.5, -4, 2.5}};
};

// clang-format off
struct Dop853 {
  static constexpr int kStages = 12;
  static constexpr int kOrder = 8;
  static constexpr int kDenseStages = 16;  // row 12 is the slope at the end, rows 13 to 15 serve dense output only
  static constexpr double c[16] = {0.0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274,
      0.2816496580927726, 0.3333333333333333, 0.25, 0.3076923076923077, 0.6512820512820513, 0.6,
      0.8571428571428571, 1.0, 1.0, 0.1, 0.2, 0.7777777777777778};
  static constexpr double b[12] = {0.054293734116568765, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003,
      -5.801203960010585, 0.3111643669578199, -0.1521609496625161, 0.20136540080403034, 0.04471061572777259};
  static constexpr double a[16][16] = {
      {},
      {0.05260015195876773},
      {0.0197250569845379, 0.0591751709536137},
      {0.02958758547680685, 0, 0.08876275643042054},
      {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792},
      {0.037037037037037035, 0, 0, 0.17082860872947386, 0.12546768756682242},
      {0.037109375, 0, 0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
      {0.03709200011850479, 0, 0, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402,
       0.008273789163814023},
      {0.6241109587160757, 0, 0, -3.3608926294469414, -0.868219346841726, 27.59209969944671,
       20.154067550477894, -43.48988418106996},
      {0.47766253643826434, 0, 0, -2.4881146199716677, -0.590290826836843, 21.230051448181193,
       15.279233632882423, -33.28821096898486, -0.020331201708508627},
      {-0.9371424300859873, 0, 0, 5.186372428844064, 1.0914373489967295, -8.149787010746927,
       -18.52006565999696, 22.739487099350505, 2.4936055526796523, -3.0467644718982196},
      {2.273310147516538, 0, 0, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996,
       -2.8589982771350235, -8.87285693353063, 12.360567175794303, 0.6433927460157636},
      {0.054293734116568765, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585,
       0.3111643669578199, -0.1521609496625161, 0.20136540080403034, 0.04471061572777259},
      {0.056167502283047954, 0, 0, 0, 0, 0, 0.25350021021662483, -0.2462390374708025, -0.12419142326381637,
       0.15329179827876568, 0.00820105229563469, 0.007567897660545699, -0.008298},
      {0.03183464816350214, 0, 0, 0, 0, 0.028300909672366776, 0.053541988307438566, -0.05492374857139099, 0, 0,
       -0.00010834732869724932, 0.0003825710908356584, -0.00034046500868740456, 0.1413124436746325},
      {-0.42889630158379194, 0, 0, 0, 0, -4.697621415361164, 7.683421196062599, 4.06898981839711,
       0.3567271874552811, 0, 0, 0, -0.0013990241651590145, 2.9475147891527724, -9.15095847217987}};
  /// Orders 5 and 3 minus order 8.
  static constexpr double kError5[12] = {0.01312004499419488, 0, 0, 0, 0, -1.2251564463762044,
      -0.4957589496572502, 1.6643771824549864, -0.35032884874997366, 0.3341791187130175, 0.08192320648511571,
      -0.022355307863886294};
  static constexpr double kError3[12] = {-0.18980075407240762, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003,
      -5.801203960010585, -0.4226823213237919, -0.1521609496625161, 0.20136540080403034, 0.02265179219836082};
  static constexpr double kDense[4][16] = {
      {-8.428938276109013, 0, 0, 0, 0, 0.5667149535193777, -3.0689499459498917, 2.38466765651207,
       2.117034582445028, -0.871391583777973, 2.2404374302607883, 0.6315787787694688, -0.08899033645133331,
       18.148505520854727, -9.194632392478356, -4.436036387594894},
      {10.427508642579134, 0, 0, 0, 0, 242.28349177525817, 165.20045171727028, -374.5467547226902,
       -22.113666853125306, 7.733432668472264, -30.674084731089398, -9.332130526430229, 15.697238121770845,
       -31.139403219565178, -9.35292435884448, 35.81684148639408},
      {19.985053242002433, 0, 0, 0, 0, -387.0373087493518, -189.17813819516758, 527.8081592054236,
       -11.57390253995963, 6.8812326946963, -1.0006050966910838, 0.7777137798053443, -2.778205752353508,
       -60.19669523126412, 84.32040550667716, 11.99229113618279},
      {-25.69393346270375, 0, 0, 0, 0, -154.18974869023643, -231.5293791760455, 357.6391179106141,
       93.40532418362432, -37.45832313645163, 104.0996495089623, 29.8402934266605, -43.53345659001114,
       96.32455395918828, -39.17726167561544, -149.72683625798564}};
};
// clang-format on

// What a method is follows from what its tableau has.

template <class Method>
concept RungeKutta = requires {
  Method::b;
};
/// An embedded method of one lower order: kError is its difference, over all slopes and that at the end.
template <class Method>
concept HasErrorWeights = requires {
  Method::kError;
};
/// Two estimates over the stages, combined as in DOP853.
template <class Method>
concept HasTwoErrors = requires {
  Method::kError5;
  Method::kError3;
};
template <class Method>
concept Adaptive = HasErrorWeights<Method> || HasTwoErrors<Method>;
/// DOP853's interpolant, with its own slopes.
template <class Method>
concept HasDenseStages = requires {
  Method::kDenseStages;
};
/// An interpolant with polynomials as weights, over all slopes and that at the end.
template <class Method>
concept HasDensePolynomials = requires {
  Method::kDense;
}
&&!HasDenseStages<Method>;

/// Calls f with the method of an integrator, a type: the one place that says which tableau belongs to which name.
PHYSIM_INLINE_ALWAYS auto with_method(Integrator integrator, const auto& f) {
  switch (integrator) {
    case Integrator::classic: return f(ClassicLoop{});
    case Integrator::explicit_euler: return f(ExplicitEuler{});
    case Integrator::semi_implicit_euler: return f(SemiImplicitEuler{});
    case Integrator::heun: return f(Heun{});
    case Integrator::rk4: return f(Rk4{});
    case Integrator::rk43: return f(Rk43{});
    case Integrator::tsit5: return f(Tsit5{});
    case Integrator::dop853: return f(Dop853{});
    case Integrator::automatic:
    case Integrator::adaptive: break;  // granted as one of the others
  }
  PHYSIM_UNREACHABLE();
}

/// Number of the slope at the end of a step, which is the first slope of the next one.
PHYSIM_INLINE_ALWAYS int end_slope(Integrator integrator) {
  return with_method(integrator, [](auto method) PHYSIM_INLINE_LAMBDA { return method.kStages; });
}

/// The error of a flight falls with this power of a fixed step, and the estimate of an adaptive step's error with this
/// power of its length.
PHYSIM_INLINE_ALWAYS int order_of(Integrator integrator) {
  return with_method(integrator, [](auto method) PHYSIM_INLINE_LAMBDA { return method.kOrder; });
}

PHYSIM_INLINE_ALWAYS bool is_adaptive(Integrator integrator) {
  return with_method(integrator, [](auto method) PHYSIM_INLINE_LAMBDA { return Adaptive<decltype(method)>; });
}

/// Calls f with 0, 1, ... N - 1 as compile-time constants.
template <int N, class F>
PHYSIM_INLINE_ALWAYS void static_for(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) PHYSIM_INLINE_LAMBDA { (f(std::integral_constant<int, I>{}), ...); }
  (std::make_integer_sequence<int, N>{});
}

template <class Weights>
constexpr int first_nonzero() {
  int j = 0;
  while (Weights::at(j) == 0) ++j;
  return j;
}

/// sum over j < N of weight(j) * slope[j], without the terms of weight zero. `Weights::at(j)` is constexpr. Y is State
/// or Turn.
template <class Weights, int N, template <class> class Y, class R>
PHYSIM_INLINE_ALWAYS Y<R> weighted_sum(const Y<R>* slope) {
  Y<R> sum{};
  static_for<N>([&](auto j) PHYSIM_INLINE_LAMBDA {
    constexpr double w = Weights::at(j);
    if constexpr (w != 0) {
      const R weight = constant<R>(w);
      if constexpr (j == first_nonzero<Weights>()) {
        sum = slope[j] * weight;
      } else {
        add_scaled(sum, slope[j], weight);
      }
    }
  });
  return sum;
}

/// h times that, with h in the weights: the way from the last slope is a product and a sum shorter. `first` is what the
/// sum begins with, if anything.
template <class Weights, int N, template <class> class Y, class R, class... First>
PHYSIM_INLINE_ALWAYS Y<R> step_sum(const Y<R>* slope, const R& h, const First&... first) {
  Y<R> sum{};
  static_for<N>([&](auto j) PHYSIM_INLINE_LAMBDA {
    constexpr double w = Weights::at(j);
    if constexpr (w != 0) {
      const R weight = h * constant<R>(w);
      if constexpr (j == first_nonzero<Weights>()) {
        sum = (first + ... + (slope[j] * weight));
      } else {
        add_scaled(sum, slope[j], weight);
      }
    }
  });
  return sum;
}

/// The weights in an array of a tableau, or in a row of one.
template <const auto& kWeights>
struct Weights {
  static constexpr double at(int j) { return kWeights[j]; }
};
template <const auto& kRows, int Row>
struct RowWeights {
  static constexpr double at(int j) { return kRows[Row][j]; }
};

/// The state of stage `Stage` from the slopes of those before it; `s` is a Step or its TurnStep. A rounding for each
/// slope, of which the step's end, summed up before it is added, feels only what the slopes do.
template <class Tableau, int Stage, class AnyStep, class R>
PHYSIM_INLINE_ALWAYS auto stage_state(const AnyStep& s, const R& h) {
  return step_sum<RowWeights<Tableau::a, Stage>, Stage>(s.slope.item, h, s.start);
}
/// The state at the end from the slopes of all stages.
template <class Tableau, class AnyStep, class R>
PHYSIM_INLINE_ALWAYS auto end_state(const AnyStep& s, const R& h) {
  return s.start + step_sum<Weights<Tableau::b>, Tableau::kStages>(s.slope.item, h);
}

/// Runs the stages of some steps side by side and goes to their ends; slope[0] of each is given. `f(i, t, y, a)` puts
/// step i's acceleration into `a`; where they turn, f(i, t, y, turn, a, slope) receives the Turn too and gives its
/// slope beside it. (Where packs are returned, g++ sets their place to zero first, by `rep stos`, and copies them.)
///
/// A stage waits for the one before: for a square root, a table look-up, and a chain of sums. The steps do not wait for
/// each other, so the processor fills one's waiting with the other's work.
template <class Tableau, bool kTurns, class R, class F>
PHYSIM_INLINE_ALWAYS void runge_kutta_ends(Step<R>* const* steps, int count, const F& f) {
  static_assert(Tableau::kStages < kMaxSlopes, "a Step has no room for the slopes of this method");
  static_for<Tableau::kStages - 1>([&](auto before) {
    constexpr int stage = before + 1;
    for (int i = 0; i < count; ++i) {
      Step<R>& s = *steps[i];
      const State<R> y = stage_state<Tableau, stage>(s, s.h);
      const R t = s.t + s.h * constant<R>(Tableau::c[stage]);
      s.slope[stage].x = y.v;
      if constexpr (kTurns)
        f(i, t, y, stage_state<Tableau, stage>(*s.turn, s.h), s.slope[stage].v, s.turn->slope[stage]);
      else
        f(i, t, y, s.slope[stage].v);
    }
  });
  for (int i = 0; i < count; ++i) {
    Step<R>& s = *steps[i];
    s.end = end_state<Tableau>(s, s.h);
    if constexpr (kTurns) s.turn->end = end_state<Tableau>(*s.turn, s.h);
  }
}

PHYSIM_ISA_END
