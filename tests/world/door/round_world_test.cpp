// Worlds over the round Earth: the numbers of single flights, and a ground whose normal is the vertical.
#include <gtest/gtest.h>

#include "physim/environment.hpp"
#include "physim/flight.hpp"
#include "physim/world.hpp"

namespace physim::world_round_world_test {

Environment windy_north() {
  return {
      .altitude = 300, .wind = {.velocity = {1, 0.2, -4}}, .earth = {.latitude = 0.8, .longitude = 2, .azimuth = 1}};
}

ProjectileDef ball() { return {.mass = 5, .diameter = 0.1}; }

TEST(RoundWorld, agrees_with_flight_bit_for_bit) {
  constexpr double kStep = 1.0 / 32;
  constexpr int kSteps = 60;
  WorldDef def{.environment = windy_north(), .ground = {.mode = GroundMode::none}};
  for (const EarthModel earth : {EarthModel::sphere, EarthModel::sphere_rotating, EarthModel::ellipsoid})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      ProjectileDef p = ball();
      p.fidelity = {
          .integrator = Integrator::rk4, .gravity = GravityModel::wgs84, .earth = earth, .precision = precision};
      const Launch launch{.position = {5, 100, 3}, .speed = 400, .elevation = 0.3, .azimuth = 0.1};
      World world = std::move(World::create(def).value());
      const ProjectileId id = *world.spawn(p, launch);
      for (int i = 0; i < kSteps; ++i) world.step(kStep);
      const Flight flight = fly(p, launch, def.environment, p.fidelity, {.step = kStep}, {.ground = {}, .time = 10});
      const Sample s = flight.at(kSteps * kStep);
      EXPECT_EQ(world[id].state().position, s.position);
      EXPECT_EQ(world[id].state().velocity, s.velocity);
      const Accelerations a = world[id].accelerations(), b = flight.accelerations(kSteps * kStep);
      EXPECT_EQ(a.coriolis, b.coriolis);
      EXPECT_EQ(a.centrifugal, b.centrifugal);
      // Where a float32 world tells accelerations, it has the projectile's data rounded to floats.
      EXPECT_LT(length(a.total - b.total), precision == Precision::float64 ? 1e-13 : 1e-5);
      EXPECT_EQ(length(a.centrifugal) > 0, earth != EarthModel::sphere);
    }
}

}  // namespace physim::world_round_world_test
