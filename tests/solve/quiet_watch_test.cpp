// QuietWatch against detect(): what it lets pass crosses nothing, and what stays away from all that is watched passes.
#include "solve/quiet_watch.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <random>

namespace physim::solve_quiet_watch_test {

void watch_for(WatchList& watch, EventKind kind, double value, Crossing direction = Crossing::any) {
  watch.item[watch.count++] = {{kind, value, direction, false}, Outcome::event};
}
WatchList everything() {
  WatchList watch;
  for (const double value : {-1.0, 0.0, 1.0}) {
    watch_for(watch, EventKind::height, value);
    watch_for(watch, EventKind::range, value, Crossing::rising);
  }
  watch_for(watch, EventKind::ground, -2, Crossing::falling);
  watch_for(watch, EventKind::apex, 0, Crossing::falling);
  watch_for(watch, EventKind::speed, 1.5);
  watch_for(watch, EventKind::time, 3);
  watch_for(watch, EventKind::time, 7);
  return watch;
}

/// One lane over flat ground, whose line of sight is level.
struct Lane {
  Conditions<double> c{};
  Flyer<double> flyer;

  Lane() {
    c.fidelity.earth = EarthModel::flat;
    flyer.body = {};
    flyer.body.sight = {1, 0, 0};
  }
  void start(double t, const State<double>& s, const Vec3d& a) {
    flyer.step.t = t, flyer.step.start = s, flyer.step.slope[0].v = a;
  }
  void end(double t, const State<double>& s) { flyer.step.t_end = t, flyer.step.end = s; }
};

/// Numbers that often lie on what is watched, or next to it.
State<double> somewhere(std::mt19937_64& random) {
  const auto number = [&] {
    constexpr double kNear = std::numeric_limits<double>::epsilon();
    const double whole = static_cast<double>(random() % 5) - 2;
    return whole * (1 + kNear * (static_cast<double>(random() % 3) - 1));
  };
  return {{number(), number(), 0}, {number(), number(), 0}};
}

TEST(QuietWatch, lets_nothing_pass_that_crosses_something) {
  std::mt19937_64 random(20);
  const WatchList watch = everything();
  Lane lane;
  int passed = 0;
  for (int flight = 0; flight < 4000; ++flight) {
    double t = static_cast<double>(random() % 9);
    State<double> s = somewhere(random);
    Vec3d a = somewhere(random).v;
    lane.start(t, s, a);
    std::optional<QuietWatch<double>> quiet(std::in_place, lane.c, watch, lane.flyer);
    for (int step = 0; step < 4; ++step) {
      const State<double> next =
          random() % 2 == 0 ? somewhere(random) : State<double>{s.x + s.v * 1e-3, s.v + a * 1e-3};
      const Vec3d next_a = somewhere(random).v;
      const double next_t = t + (random() % 2 == 0 ? 1 : 1e-3);
      lane.start(t, s, a);
      lane.end(next_t, next);
      const WatchedSet some = quiet->may_cross(lane.c, lane.flyer.body, next_t, next, next_a);
      for (int i = 0; i < watch.count; ++i) {
        const Detected d = detect(lane.c, lane.flyer.body, watch, lane.flyer.step, a, next_a, WatchedSet(1) << i);
        EXPECT_TRUE(d.some == 0 || contains(some, i)) << i << " in flight " << flight;
      }
      t = next_t, s = next, a = next_a;
      passed += some == 0;
      lane.start(t, s, a);
      if (some != 0) quiet.emplace(lane.c, watch, lane.flyer);
    }
  }
  EXPECT_GT(passed, 100);
}

TEST(QuietWatch, what_stays_on_its_side_passes) {
  const WatchList watch = everything();
  Lane lane;
  lane.start(0, {{0.1, 0.1, 0}, {1, 0.5, 0}}, {0, -1, 0});
  QuietWatch<double> quiet(lane.c, watch, lane.flyer);
  const auto may_cross = [&](double t, const Vec3d& x, const Vec3d& v) {
    return quiet.may_cross(lane.c, lane.flyer.body, t, {x, v}, {0, -1, 0});
  };
  EXPECT_EQ(may_cross(1, {0.5, 0.4, 9}, {1, 0.3, 0}), 0u);
  EXPECT_EQ(may_cross(2.9, {0.9, 0.9, 9}, {1, 0.1, 0}), 0u);
  EXPECT_NE(may_cross(3, {0.9, 0.9, 9}, {1, 0.1, 0}), 0u);     // a time
  EXPECT_NE(may_cross(2.9, {1, 0.9, 9}, {1, 0.1, 0}), 0u);     // a range
  EXPECT_NE(may_cross(2.9, {0.9, 1, 9}, {1, 0.1, 0}), 0u);     // a height
  EXPECT_NE(may_cross(2.9, {0.9, 0.9, 9}, {1, 0, 0}), 0u);     // the apex
  EXPECT_NE(may_cross(2.9, {0.9, 0.9, 9}, {-1, 0.1, 0}), 0u);  // it came back
}

TEST(QuietWatch, what_is_no_number_does_not_pass) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const WatchList watch = everything();
  Lane lane;
  lane.start(0, {{0.1, 0.1, 0}, {1, 0.5, 0}}, {0, -1, 0});
  QuietWatch<double> quiet(lane.c, watch, lane.flyer);
  EXPECT_NE(quiet.may_cross(lane.c, lane.flyer.body, 1, {{nan, 0.1, 0}, {1, 0.4, 0}}, {0, -1, 0}), 0u);
  EXPECT_NE(quiet.may_cross(lane.c, lane.flyer.body, 1, {{0.2, nan, 0}, {1, 0.4, 0}}, {0, -1, 0}), 0u);
  EXPECT_NE(quiet.may_cross(lane.c, lane.flyer.body, nan, {{0.2, 0.1, 0}, {1, 0.4, 0}}, {0, -1, 0}), 0u);
}

}  // namespace physim::solve_quiet_watch_test
