// One flight has one acceleration: flights, their samples and worlds tell the same, and it is the register of the
// original's loop on `classic`, the force over the mass elsewhere.
#include "world/world_support.hpp"

namespace physim::world_acceleration_doors_test {

constexpr double kStep = 1.0 / 60;

struct Doors {
  Flight flight;
  World world;
  ProjectileId id;
};

Doors doors_of(ProjectileDef p, const Fidelity& fidelity) {
  const Launch launch{.position = {0, 1.5, 0}, .velocity = Vec3d{40, 4, 0}};
  p.fidelity = fidelity;
  Doors doors{fly(p, launch, {}, fidelity, {.step = kStep}, {.ground = std::nullopt, .time = 1}),
              make_world({.ground = {.mode = GroundMode::none}}),
              {}};
  doors.id = *doors.world.spawn(p, launch);
  return doors;
}

TEST(AccelerationDoors, flights_samples_and_worlds_agree_on_damping) {
  Fidelity forced = Fidelity::classic();
  forced.motion = Motion::force;
  Fidelity quadratic = forced;
  quadratic.drag = DragModel::linear_quadratic;
  Fidelity adaptive = Fidelity::constant_air();
  adaptive.drag = DragModel::damping;
  Fidelity game = Fidelity::game();
  game.motion = Motion::velocity;
  game.drag = DragModel::damping;
  Fidelity closed = Fidelity::arcade();
  closed.drag = DragModel::damping;
  for (const Fidelity& f : {Fidelity::classic(), forced, quadratic, adaptive, game, closed}) {
    Doors d = doors_of(presets::artillery().projectile, f);
    ASSERT_FALSE(d.flight.error());
    // Frames of float32 begin a rounding off their time: a flight of frames is asked just behind.
    const double behind = f.integrator == Integrator::classic ? 1e-4 : 0;
    for (int frame = 0; frame <= 40; ++frame) {
      const double t = frame * kStep + behind;
      const Vec3d of_world = d.world[d.id].accelerations().total, of_flight = d.flight.accelerations(t).total;
      EXPECT_EQ(d.flight.at(t).acceleration, of_flight);
      EXPECT_TRUE(test::near(of_world, of_flight, 1e-5, 1e-6))
          << frame << " " << name(f.integrator) << " " << name(f.motion) << " " << name(f.drag);
      EXPECT_TRUE(test::near(d.world[d.id].resultant_force(), of_flight * 200, 1e-5, 1e-3));
      d.world.step(kStep);
    }
  }
}

/// Test 5 of the original: (-20, 0), whatever the damping; by any other integrator the damping is a force.
TEST(AccelerationDoors, the_register_holds_no_damping_and_every_other_sum_does) {
  Doors original = doors_of(presets::artillery().projectile, Fidelity::classic());
  Fidelity exact = Fidelity::reference();
  exact.drag = DragModel::damping;
  exact.gravity = GravityModel::constant, exact.earth = EarthModel::flat;
  Doors other = doors_of(presets::artillery().projectile, exact);
  for (int frame = 0; frame < 30; ++frame) original.world.step(kStep), other.world.step(kStep);
  EXPECT_TRUE(test::near(original.world[original.id].accelerations().total, {0, -20, 0}, 1e-7));
  EXPECT_TRUE(test::near(original.flight.at(0.5).acceleration, {0, -20, 0}, 1e-7));
  const Vec3d v = other.flight.at(0.5).velocity;
  const Vec3d wanted = Vec3d{0, -20, 0} + v * std::log(0.9);
  EXPECT_TRUE(test::near(other.flight.at(0.5).acceleration, wanted, 1e-6));
  EXPECT_TRUE(test::near(other.world[other.id].accelerations().total, wanted, 1e-6));
  // Both tell what the damping does.
  EXPECT_TRUE(
      test::near(original.flight.accelerations(0.5).drag, original.flight.at(0.5).velocity * std::log(0.9), 1e-5));
}

}  // namespace physim::world_acceleration_doors_test
