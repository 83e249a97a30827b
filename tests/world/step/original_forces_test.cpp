// Tests 3 and 6 of the original in a world, as their author meant them.
#include "world/force_support.hpp"

namespace physim::world_original_forces_test {

using test::near;

// The numbers are those of scenarios/original_test_*_drag.toml: a push that lasts one second, gravity for ever, and
// drag that grows with speed: m dv/dt = F + m g - (k1 + k2 |v|) v.
struct Original {
  double mass, k1, k2;
  Vec3d push;     // for one second [N]
  Vec3d gravity;  // all the time [m/s^2]

  [[nodiscard]] Vec3d acceleration(const Vec3d& v, bool pushed) const {
    return (pushed ? push * (1 / mass) : Vec3d{}) + gravity - v * ((k1 + k2 * length(v)) / mass);
  }
  /// The velocities at the ends of frames, by the classical Runge-Kutta method with 20 steps in a frame: exact to 1e-9.
  [[nodiscard]] std::vector<Vec3d> velocities(int frames) const {
    constexpr int kSteps = 20;
    constexpr double h = 1.0 / 60 / kSteps;
    std::vector<Vec3d> all(1);
    Vec3d v;
    for (int i = 0; i < frames * kSteps; ++i) {
      const bool pushed = i < 60 * kSteps;
      const Vec3d a = acceleration(v, pushed), b = acceleration(v + a * (h / 2), pushed);
      const Vec3d c = acceleration(v + b * (h / 2), pushed), d = acceleration(v + c * h, pushed);
      v += (a + b * 2 + c * 2 + d) * (h / 6);
      if ((i + 1) % kSteps == 0) all.push_back(v);
    }
    return all;
  }
  [[nodiscard]] double terminal_speed() const {
    return (std::sqrt(k1 * k1 + 4 * k2 * mass * length(gravity)) - k1) / (2 * k2);
  }
};

const Original kTest3{2, 0, 0.4, {0, 0, 20}, {0, -4, 0}};
const Original kTest6{200, 20, 40, {0, 800, 2000}, {0, -4, 0}};

enum class DragBy { rung, generator };

struct OriginalWorld {
  World world = make(empty_space());
  ProjectileId id;

  OriginalWorld(const Original& o, Integrator integrator, DragBy drag) {
    ProjectileDef p = ball(rung(integrator), o.mass);
    if (drag == DragBy::rung) {
      p.fidelity.drag = DragModel::linear_quadratic;
      p.drag.k1 = o.k1;
      p.drag.k2 = o.k2;
    }
    id = *world.spawn(p, at({0, 1.5, 0}));
    world[id].add_force(ConstantForce{o.push}, 1);
    world[id].add_force(GravityForce{o.gravity});
    if (drag == DragBy::generator) world[id].add_force(LinearQuadraticDragForce{o.k1, o.k2, {}});
  }
};

struct OriginalCase {
  Integrator integrator;
  DragBy drag;
  double tolerance;  // [m/s]
};
constexpr OriginalCase kOriginalCases[] = {{Integrator::classic, DragBy::rung, 0.5},  // a frame late
                                           {Integrator::classic, DragBy::generator, 0.5},
                                           {Integrator::rk4, DragBy::rung, 1e-6},
                                           {Integrator::rk4, DragBy::generator, 1e-6},
                                           {Integrator::tsit5, DragBy::generator, 1e-7}};

/// Eight seconds, frame by frame.
void expect_as_meant(const Original& original) {
  const std::vector<Vec3d> meant = original.velocities(480);
  for (const OriginalCase& c : kOriginalCases) {
    OriginalWorld w(original, c.integrator, c.drag);
    for (std::size_t k = 1; k < meant.size(); ++k) {
      w.world.step(1.0 / 60);
      ASSERT_TRUE(near(w.world[w.id].velocity(), meant[k], 0, c.tolerance)) << test::text(c.integrator) << " " << k;
    }
    EXPECT_TRUE(near(w.world[w.id].velocity().y, -original.terminal_speed(), 0, 2e-4 + c.tolerance / 1000));
  }
}

TEST(OriginalForces, the_originals_test_3_as_it_was_meant) {
  expect_as_meant(kTest3);
  // In the words of the evaluation: the speed rises, levels out, and dips below its highest value.
  const std::vector<Vec3d> meant = kTest3.velocities(480);
  std::vector<double> speeds;
  for (const Vec3d& v : meant) speeds.push_back(length(v));
  const auto highest = std::ranges::max_element(speeds), lowest = std::min_element(highest, speeds.end());
  EXPECT_EQ(highest - speeds.begin(), 60) << "the end of the push";
  EXPECT_TRUE(near(*highest, 6.598, 0, 1e-3));
  EXPECT_TRUE(near(*lowest, 4.215, 0, 1e-3));
  EXPECT_LT(*lowest, kTest3.terminal_speed());
  EXPECT_TRUE(near(speeds.back(), std::sqrt(2 * 4 / 0.4), 0, 1e-3));
}

TEST(OriginalForces, the_originals_test_6_as_it_was_meant) {
  expect_as_meant(kTest6);
  const std::vector<Vec3d> meant = kTest6.velocities(480);
  EXPECT_TRUE(near(meant[60].y, 0, 0, 1e-12)) << "the push upwards cancels gravity";
  EXPECT_TRUE(near(-meant.back().y, 4.2291, 0, 1e-3));
}

}  // namespace physim::world_original_forces_test
