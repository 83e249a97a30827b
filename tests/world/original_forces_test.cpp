// Tests 3 and 6 of the original in a world, as their author meant them.
#include <gtest/gtest.h>

#include <cmath>

#include "world/force_support.hpp"

namespace physim {
namespace world_original_forces_test {

using test::kInfinity;
using test::near;

// The numbers are those of scenarios/original_test_*_drag.toml: forces that last as long as they last, and drag that
// grows with speed. From rest m dv/dt = F - k2 v^2 gives v = v_t tanh(F t / (m v_t)), v_t = sqrt(F / k2); without a
// push v = v_1 / (1 + k2 v_1 (t - t_1) / m).
struct Original {
  double mass, k2;
  Vec3d push;     // for one second
  Vec3d gravity;  // all the time

  [[nodiscard]] double pushed(double t) const {
    const double f = length(push + gravity * mass);
    const double limit = std::sqrt(f / k2);
    return limit * std::tanh(f * t / (mass * limit));
  }
};

enum class DragBy { rung, generator };

struct OriginalWorld {
  World world = make(empty_space());
  ProjectileId id;

  OriginalWorld(const Original& o, Integrator integrator, DragBy drag) {
    ProjectileDef p = ball(rung(integrator), o.mass);
    if (drag == DragBy::rung) {
      p.fidelity.drag = DragModel::linear_quadratic;
      p.drag.k2 = o.k2;
    }
    id = *world.spawn(p, at({0, 1.5, 0}));
    world[id].add_force(ConstantForce{o.push}, 1);
    world[id].add_force(GravityForce{o.gravity});
    if (drag == DragBy::generator) world[id].add_force(LinearQuadraticDragForce{0, o.k2, {}});
  }
  [[nodiscard]] double speed() const { return length(world[id].velocity()); }
};

/// The second of the push: speed as it must be, and an acceleration that falls.
void expect_push(const Original& o, OriginalWorld& w, double tolerance) {
  double before = kInfinity;
  for (int k = 1; k <= 60; ++k) {
    const double acceleration = length(w.world[w.id].accelerations().total);
    EXPECT_LT(acceleration, before + 1e-12) << "falls with speed";
    before = acceleration;
    w.world.step(1.0 / 60);
    ASSERT_TRUE(near(w.speed(), o.pushed(k / 60.0), 0, tolerance)) << k;
  }
}

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

TEST(OriginalForces, the_originals_test_3_as_it_was_meant) {
  const Original test_3{2, 0.4, {0, -8, 20}, {}};
  for (const OriginalCase& c : kOriginalCases) {
    OriginalWorld w(test_3, c.integrator, c.drag);
    expect_push(test_3, w, c.tolerance);
    const double v1 = test_3.pushed(1);
    for (int k = 1; k <= 120; ++k) {
      w.world.step(1.0 / 60);
      ASSERT_TRUE(near(w.speed(), v1 / (1 + 0.4 * v1 * k / 60 / 2), 0, c.tolerance)) << test::text(c.integrator);
    }
  }
}

TEST(OriginalForces, the_originals_test_6_approaches_terminal_velocity) {
  const Original test_6{200, 40, {0, 0, 2000}, {0, -20, 0}};
  for (const OriginalCase& c : kOriginalCases) {
    OriginalWorld w(test_6, c.integrator, c.drag);
    expect_push(test_6, w, c.tolerance);
    steps(w.world, 240, 1.0 / 60);
    EXPECT_TRUE(near(w.world[w.id].velocity().y, -10, 0, 1e-4)) << test::text(c.integrator);
    EXPECT_TRUE(near(w.world[w.id].velocity().z, 0, 0, 0.01));
    EXPECT_LT(w.world[w.id].position().y, -40) << "it falls";
  }
}

}  // namespace world_original_forces_test
}  // namespace physim
