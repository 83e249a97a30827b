// Crossings that are found by heights alone are those that the whole dense output gives, to the bit.
#include "world/step/height_crossings.hpp"

#include "support.hpp"

namespace physim::test::world_height_crossings_test {

constexpr Integrator kByHeights[] = {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun,
                                     Integrator::rk4, Integrator::rk43};

WatchList watch_list(double height, bool by_heights) {
  WatchList watch{};
  const auto add = [&](EventKind kind, double value, Crossing direction, bool terminal) {
    Watched& item = watch.item[watch.count++];
    item.spec.kind = kind;
    item.spec.value = value;
    item.spec.direction = direction;
    item.spec.terminal = terminal;
    item.outcome = terminal ? Outcome::landed : Outcome::event;
  };
  add(EventKind::height, height, Crossing::any, false);
  add(EventKind::apex, 0, Crossing::falling, false);
  if (!by_heights) add(EventKind::speed, 30, Crossing::any, false);
  add(EventKind::height, height + 0.02, Crossing::rising, false);
  add(EventKind::ground, 0, Crossing::falling, true);
  return watch;
}

int skipped = 0;  // steps whose dense output need not be made

/// Counts crossings of a drawn step, which both searches agree on.
template <class S>
int crossings_of_step(const Prepared& p, int number, bool by_heights) {
  const auto drawn = [number](int place, double low, double high) {
    return low + (0.5 + 0.5 * std::sin(12.9898 * (number * 13 + place) + 78.233 * place)) * (high - low);
  };
  Tolerance tolerance;
  const Course<S> course = p.cohort.course<S>(tolerance, 0.01, watch_list(drawn(1, 0, 0.2), by_heights));
  Unset<Lanes<S>> memory;
  Lanes<S>& lanes = *memory;
  lanes.body = {};
  cast_numbers(p.body, lanes.body);
  Step<S>& s = lanes.step;
  s.t = S(0);
  s.h = s.t_end = static_cast<S>(drawn(2, 0.001, 0.2));
  s.start.x = {static_cast<S>(drawn(3, -5, 5)), static_cast<S>(drawn(4, -0.05, 0.3)), S(0)};
  s.start.v = {static_cast<S>(drawn(5, 0, 40)), static_cast<S>(drawn(6, -4, 4)), S(1)};
  set_slope(*course.conditions, lanes, 0);
  take_step(*course.conditions, lanes, S(0), S(0));

  Judgement<S> whole{}, heights{};
  dense_lanes(course, lanes, whole.at);
  dense_lanes(course, lanes, heights.at);
  find_crossings<S>(course, true, whole);
  find_row_crossings(course, heights);
  const CrossingList& a = whole.crossings[0];
  const CrossingList& b = heights.crossings[0];
  EXPECT_EQ(a.count, b.count);
  for (int i = 0; i < std::min(a.count, b.count); ++i) {
    EXPECT_EQ(a.found[i].index, b.found[i].index);
    EXPECT_EQ(a.found[i].rising, b.found[i].rising);
    EXPECT_TRUE(same_bits(a.found[i].theta, b.found[i].theta));
  }
  const bool may = may_cross(course, lanes);
  EXPECT_TRUE(may || a.count == 0);
  EXPECT_TRUE(may || by_heights);
  skipped += !may;
  return a.count;
}

template <class S>
void compare_searches(Integrator integrator) {
  SCOPED_TRACE(text(integrator));
  Fidelity f{.integrator = integrator,
             .air = AirModel::constant,
             .precision = sizeof(S) == 4 ? Precision::float32 : Precision::float64};
  const Prepared p(bullet_308(), {}, constant_gravity(), f);
  ASSERT_TRUE(DenseHeight<S>::holds(p.conditions()));
  int crossings = 0;
  for (int number = 0; number < 2000; ++number) crossings += crossings_of_step<S>(p, number, number % 2 == 0);
  EXPECT_GT(crossings, 500);
  EXPECT_GT(std::exchange(skipped, 0), 200);
}

TEST(HeightCrossings, AreThoseOfTheWholeDenseOutput) {
  for (const Integrator integrator : kByHeights) {
    compare_searches<double>(integrator);
    compare_searches<float>(integrator);
  }
}

TEST(HeightCrossings, AreNotForInterpolantsOfTheirOwnOrARoundEarth) {
  const auto holds = [](Integrator integrator, EarthModel earth = EarthModel::flat) {
    Fidelity f{.integrator = integrator, .earth = earth};
    Conditions<double> c{};
    c.fidelity = f;
    return DenseHeight<double>::holds(c);
  };
  EXPECT_TRUE(holds(Integrator::rk4));
  EXPECT_TRUE(holds(Integrator::rk4, EarthModel::flat_coriolis));
  EXPECT_FALSE(holds(Integrator::rk4, EarthModel::sphere));
  EXPECT_FALSE(holds(Integrator::classic));
  EXPECT_FALSE(holds(Integrator::tsit5));
  EXPECT_FALSE(holds(Integrator::dop853));
}

}  // namespace physim::test::world_height_crossings_test
