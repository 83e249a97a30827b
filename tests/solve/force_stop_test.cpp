// A push that lasts for a time has its exact impulse: its end is a stop of the steps of every integrator, in flights,
// batches and worlds, and what it does to a step that is not cut there, under generators, has that impulse too.
#include "world/force_support.hpp"

namespace physim::solve_force_stop_test {

using test::text;

constexpr double kStep = 1.0 / 60;
constexpr double kLasts[] = {15 * kStep, 0.2531, 0.0031, kStep, 0.5};
constexpr double kPush = 10;  // on 1 kg

constexpr Integrator kFixed[] = {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun,
                                 Integrator::rk4};
constexpr Integrator kSteady[] = {Integrator::heun, Integrator::rk4, Integrator::tsit5, Integrator::dop853};

ProjectileDef pushed(const Fidelity& fidelity, double lasts) {
  ProjectileDef p = ball(fidelity);
  p.force = {kPush, 0, 0};
  p.force_duration = lasts;
  return p;
}
double speed_after(double lasts) { return kPush * lasts; }
double way_after(double lasts, double time) { return 0.5 * kPush * lasts * lasts + kPush * lasts * (time - lasts); }

/// Of steps of a length, and of those that adaptive methods choose.
Tolerance steps_of(Precision precision) {
  const double error = precision == Precision::float64 ? 1e-9 : 2e-6;
  return {error, error, kStep};
}

/// Roundings of some sixty steps.
double bound(Precision precision) { return precision == Precision::float64 ? 1e-12 : 60 * 4 * 0x1p-24; }

template <class F>
void each_rung(std::span<const Integrator> integrators, const F& f) {
  for (const Integrator integrator : integrators)
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      SCOPED_TRACE(text(integrator) + " " + std::string(name(precision)));
      f(rung(integrator, precision));
    }
}

TEST(ForceStop, a_flight_has_the_impulse_of_its_push) {
  each_rung(kFixed, [](const Fidelity& f) {
    for (const double lasts : kLasts) {
      const Flight flight =
          fly(pushed(f, lasts), {}, empty_space().environment, f, steps_of(f.precision), {.ground = {}, .time = 1});
      EXPECT_NEAR(flight.at(1).velocity.x, speed_after(lasts), bound(f.precision)) << lasts;
    }
  });
}

TEST(ForceStop, methods_of_order_two_and_more_have_its_way) {
  each_rung(kSteady, [](const Fidelity& f) {
    for (const double lasts : kLasts) {
      const Flight flight =
          fly(pushed(f, lasts), {}, empty_space().environment, f, steps_of(f.precision), {.ground = {}, .time = 1});
      EXPECT_NEAR(flight.at(1).position.x, way_after(lasts, 1), bound(f.precision)) << lasts;
      EXPECT_EQ(flight.accelerations(0.5 * lasts).applied.x, kPush);
      EXPECT_EQ(flight.accelerations(0.51).applied.x, 0);
    }
  });
}

TEST(ForceStop, shots_of_a_batch_end_as_their_flights) {
  each_rung(kFixed, [](const Fidelity& f) {
    std::vector<Shot> shots;
    for (int i = 0; i < 37; ++i) {
      shots.push_back({pushed(f, 0.01 + 0.0131 * i), {}});
      if (i % 5 == 0) shots.back().projectile.force_duration = kInfinity;
      if (i % 7 == 0) shots.back().projectile.force = {};
    }
    const Environment space = empty_space().environment;
    const Tolerance steps = steps_of(f.precision);
    const Until until{.ground = {}, .time = 1};
    const BatchResult batch = fly_batch(shots, space, f, steps, until);
    for (std::size_t i = 0; i < shots.size(); ++i) {
      const ProjectileDef& p = shots[i].projectile;
      const Flight flight = fly(p, {}, space, f, steps, until);
      EXPECT_EQ(batch.shots[i].velocity, flight.end().velocity) << i;
      EXPECT_EQ(batch.shots[i].position, flight.end().position) << i;
      const double lasts = p.force == Vec3d{} ? 0 : std::min(p.force_duration, 1.0);
      EXPECT_NEAR(batch.shots[i].velocity.x, speed_after(lasts), bound(f.precision)) << i;
    }
  });
}

TEST(ForceStop, rows_of_a_world_have_its_impulse_alone_and_in_packs) {
  each_rung(kFixed, [](const Fidelity& f) {
    World world = make(empty_space());
    std::vector<ProjectileId> ids;
    std::vector<double> lasts;
    for (int i = 0; i < 41; ++i) {
      lasts.push_back(0.0073 * (i + 1));
      ids.push_back(*world.spawn(pushed(f, lasts.back()), {}));
    }
    for (int i = 0; i < 60; ++i) {
      if (i == 20) world = std::move(*World::load(*world.save()));
      world.step(kStep);
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
      EXPECT_NEAR(world[ids[i]].velocity().x, speed_after(lasts[i]), bound(f.precision)) << lasts[i];
      EXPECT_EQ(world[ids[i]].accelerations().applied.x, 0);
    }
  });
}

TEST(ForceStop, a_save_within_and_behind_a_push_goes_on_to_the_bit) {
  each_rung(kSteady, [](const Fidelity& f) {
    World going = make(empty_space()), broken = make(empty_space());
    for (World* world : {&going, &broken}) ASSERT_TRUE(world->spawn(pushed(f, 0.2531), {}));
    for (int i = 0; i < 40; ++i) {
      going.step(kStep), broken.step(kStep);
      broken = std::move(*World::load(*broken.save()));
      ASSERT_EQ(going.hash(), broken.hash()) << i;
    }
  });
}

TEST(ForceStop, beside_generators_its_impulse_is_the_same) {
  each_rung(kFixed, [](const Fidelity& f) {
    for (const double lasts : kLasts) {
      World world = make(empty_space());
      const ProjectileId id = *world.spawn(pushed(f, lasts), {});
      ASSERT_TRUE(world.add_force(force(ConstantForce{{0, 2, 0}}, {.ids = {id}})));
      world.step(0.5 * kStep);
      const Flight ahead = world.predict(id, {.ground = {}, .time = 1});
      for (int i = 0; i < 59; ++i) world.step(kStep);
      EXPECT_NEAR(world[id].velocity().x, speed_after(lasts), bound(f.precision)) << lasts;
      EXPECT_NEAR(ahead.at(0.9).velocity.x, speed_after(lasts), bound(f.precision)) << lasts;
      EXPECT_NEAR(world[id].velocity().y, 2 * 59.5 * kStep, 10 * bound(f.precision));
    }
  });
}

TEST(ForceStop, generators_that_begin_and_end_inside_steps_have_their_impulse) {
  each_rung(kFixed, [](const Fidelity& f) {
    for (const double lasts : kLasts)
      for (const double delay : {0.0, 0.0113, 0.0031}) {
        World world = make(empty_space());
        const ProjectileId id = *world.spawn(ball(f), at({}, {0, 5, 0}));  // what is slow falls asleep
        ForceDef push = force(ConstantForce{{kPush, 0, 0}}, {.ids = {id}});
        push.delay = delay;
        push.duration = lasts;
        ASSERT_TRUE(world.add_force(push));
        for (int i = 0; i < 60; ++i) world.step(kStep);
        EXPECT_NEAR(world[id].velocity().x, speed_after(lasts), bound(f.precision)) << lasts << ' ' << delay;
      }
  });
}

/// A force that grows with time, over an odd part of steps: Simpson's rule over the part has its impulse.
TEST(ForceStop, a_thrust_that_begins_inside_a_step_has_the_impulse_of_its_curve) {
  World world = make(empty_space());
  const ProjectileId id = *world.spawn(ball(rung(Integrator::rk4)), {});
  ForceDef push = force(Thrust{.curve = {{0, 0}, {1, 30}}, .direction = {1, 0, 0}}, {.ids = {id}});
  push.delay = 0.0113;
  push.duration = 0.2531;
  ASSERT_TRUE(world.add_force(push));
  for (int i = 0; i < 60; ++i) world.step(kStep);
  EXPECT_NEAR(world[id].velocity().x, 15 * 0.2531 * 0.2531, 1e-12);
}

}  // namespace physim::solve_force_stop_test
