// Steps of packs on known rungs are those of all rungs, to the bit.
#include "flight/known_pack_steps.hpp"

#include <vector>

#include "plain_bullet.hpp"
#include "random_shots.hpp"
#include "support.hpp"

namespace physim::test {
namespace flight_known_pack_steps_test {

struct Rung {
  const char* name;
  WindModel wind;
  bool own_weather;
};
constexpr Rung kRungs[] = {{"calm", WindModel::off, false},
                           {"in one wind", WindModel::constant, false},
                           {"in weather of their own", WindModel::constant, true}};
constexpr Integrator kKnown[] = {Integrator::rk4, Integrator::rk43, Integrator::tsit5};

/// Flights of a bullet on a rung.
class Cohorts {
 public:
  Cohorts(const Rung& rung, Integrator integrator, Precision precision)
      : prepared_(plain_bullet(), {}, windy(), fidelity_of(rung, integrator, precision)) {
    Cohort& cohort = prepared_.cohort;
    cohort.conditions.has_own_air = cohort.conditions.has_own_wind = rung.own_weather;
    cohort.finish();
  }
  template <class S>
  [[nodiscard]] const Conditions<S>& in() const {
    return prepared_.cohort.conditions_in<S>();
  }

  /// Lanes at the start of a step, some of them up to `top` high.
  template <class R>
  [[nodiscard]] Flyer<R> start(Random& r, double top) const {
    using S = ScalarOf<R>;
    Flyer<R> flyer{};
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      Body<double> body = prepared_.body;
      body.air = prepared_.conditions().air.common;
      body.air.low_density[0] *= r.in(0.9, 1.1), body.air.layer[0].base_density *= r.in(0.9, 1.1);
      body.wind = r.vector(10);
      put_lane(body, flyer.body, lane);
      const State<double> at{{r.in(-50, 5000), r.in(-1000, r.one_in(8) ? top : 9000), r.in(-300, 300)},
                             {r.in(-100, 1200), r.in(-500, 500), r.in(-50, 50)}};
      put_lane(at, flyer.step.start, lane);
      set_lane(flyer.step.t, lane, S(r.in(0, 20)));
      set_lane(flyer.step.h, lane, S(r.in(1e-3, 0.5)));
    }
    flyer.step.t_end = flyer.step.t + flyer.step.h;
    set_slope(in<S>(), flyer, 0);
    return flyer;
  }

 private:
  static Environment windy() {
    Environment e;
    e.gravity.model = GravityModel::constant;
    e.altitude = 300;
    e.wind.velocity = {3, 0.5, -7};
    return e;
  }
  static Fidelity fidelity_of(const Rung& rung, Integrator integrator, Precision precision) {
    Fidelity f;
    f.integrator = integrator;
    f.precision = precision;
    f.gravity = GravityModel::constant;
    f.wind = rung.wind;
    f.interpolation = Interpolation::cubic;
    return f;
  }

  Prepared prepared_;
};

template <class R>
void expect_same(const R& a, const R& b) {
  for (int lane = 0; lane < kLanes<R>; ++lane) EXPECT_TRUE(same_bits(lane_of(a, lane), lane_of(b, lane))) << lane;
}
template <class R>
void expect_same(const State<R>& a, const State<R>& b) {
  for (unsigned i = 0; i < kNumbers<State>; ++i) expect_same(numbers(a)[i], numbers(b)[i]);
}

/// Takes a step of some packs side by side, by what knows the rung and by what knows none.
template <class R>
void expect_same_steps(const Cohorts& cohorts, std::uint64_t seed, int count, double top) {
  using S = ScalarOf<R>;
  const Conditions<S>& c = cohorts.in<S>();
  const TakeSteps<R, S> known = steps_of<R>(c);
  ASSERT_NE(known, (take_any_steps<R, S>));
  Random r(seed);
  std::vector<Flyer<R>> flyers;
  for (int i = 0; i < count; ++i) flyers.push_back(cohorts.start<R>(r, top));
  std::vector<Flyer<R>> others = flyers;
  FlyerSet<R> set, other_set;
  for (auto& flyer : flyers) set.add(flyer);
  for (auto& flyer : others) other_set.add(flyer);
  known(c, set, S(1e-5), S(1e-5));
  take_any_steps<R>(c, other_set, S(1e-5), S(1e-5));
  for (std::size_t i = 0; i < flyers.size(); ++i) {
    const Step<R>&a = flyers[i].step, &b = others[i].step;
    for (int k = 0; k <= end_slope(c.fidelity.integrator); ++k) expect_same(a.slope[k], b.slope[k]);
    expect_same(a.end, b.end);
    if (is_adaptive(c.fidelity.integrator)) expect_same(a.error, b.error);
  }
}

TEST(KnownPackSteps, are_those_of_all_rungs_to_the_bit) {
  for (const Rung& rung : kRungs) {
    for (const Integrator integrator : kKnown) {
      SCOPED_TRACE(rung.name);
      const Cohorts wide(rung, integrator, Precision::float64), narrow(rung, integrator, Precision::float32);
      for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        const double top = i % 2 == 0 ? 9000 : 15000;  // within the lowest layer of the air, and beyond
        expect_same_steps<Pack<double, 4>>(wide, seed, 1 + i % kMostSets, top);
        expect_same_steps<Pack<float, 8>>(narrow, seed, 1 + i % kMostSets, top);
      }
    }
  }
}

TEST(KnownPackSteps, are_not_for_what_is_special) {
  using R = Pack<double, 4>;
  const Cohorts cohorts(kRungs[1], Integrator::rk4, Precision::float64);
  const auto knows = [&](const auto& change) {
    auto c = std::make_unique<Conditions<double>>(cohorts.in<double>());
    change(*c);
    return steps_of<R>(*c) != take_any_steps<R, double>;
  };
  EXPECT_TRUE(knows([](auto&) {}));
  EXPECT_FALSE(knows([](auto& c) { c.has_motor = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.has_bands = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.has_searched_curves = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.has_own_air = true; })) << "without wind of its own";
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.planar = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.wind = WindModel::profile; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.air = AirModel::exponential; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.gravity = GravityModel::inverse_square; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.earth = EarthModel::flat_coriolis; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.integrator = Integrator::heun; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.rotation = RotationModel::magnus; }));
  EXPECT_EQ(steps_of<double>(cohorts.in<double>()), (take_any_steps<double, double>)) << "a number alone waits anyway";
}

}  // namespace flight_known_pack_steps_test
}  // namespace physim::test
