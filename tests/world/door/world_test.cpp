// The world against single flights: same rung, same step, same bits.
#include <random>

#include "world/world_support.hpp"

namespace physim::world_world_test {

Environment windy() { return {.wind = {.velocity = {1, 0.2, -4}}, .earth = {.latitude = 0.8}}; }

std::vector<Fidelity> fixed_rungs() {
  std::vector<Fidelity> rungs{Fidelity::game(), Fidelity::constant_air(), Fidelity::classic(), Fidelity::arcade()};
  rungs[0].integrator = Integrator::semi_implicit_euler;  // which it is in a world
  rungs[1].integrator = Integrator::rk4;
  for (const Integrator i : {Integrator::classic, Integrator::explicit_euler, Integrator::semi_implicit_euler,
                             Integrator::heun, Integrator::rk4}) {
    for (const DragModel d : {DragModel::off, DragModel::damping, DragModel::linear_quadratic, DragModel::equation}) {
      for (const Precision p : {Precision::float32, Precision::float64}) {
        Fidelity f = Fidelity::artillery();
        f.integrator = i;
        f.drag = d;
        f.precision = p;
        rungs.push_back(f);
        f.earth = EarthModel::flat;
        f.gravity = GravityModel::constant;
        f.wind = d == DragModel::equation ? WindModel::off : WindModel::constant;
        f.air = AirModel::constant;
        rungs.push_back(f);
        f.planar = true;
        rungs.push_back(f);
        f.planar = false;
        f.wind = WindModel::off;
        rungs.push_back(f);
        f.motion = Motion::velocity;
        rungs.push_back(f);
      }
    }
  }
  return rungs;
}

TEST(World, agrees_with_flight_bit_for_bit) {
  constexpr double kStep = 1.0 / 64;
  constexpr int kSteps = 40;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-0.5, 0.7);
  WorldDef def{.environment = windy(), .ground = {.mode = GroundMode::none}};
  for (const Fidelity& rung : fixed_rungs()) {
    World world = make_world(def);
    ProjectileDef p = bullet();
    p.fidelity = rung;
    std::vector<Launch> launches;
    std::vector<ProjectileId> ids;
    for (int i = 0; i < 37; ++i) {
      launches.push_back({.position = {1.0 * i, 100, 3},
                          .speed = 300.0 + 10 * i,
                          .elevation = angle(random),
                          .azimuth = angle(random)});
      ids.push_back(*world.spawn(p, launches.back()));
    }
    Until until;
    until.ground.reset();
    until.time = 10;
    Tolerance tolerance{.step = kStep};
    for (int i = 0; i < kSteps; ++i) world.step(kStep);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Flight flight = fly(p, launches[i], def.environment, rung, tolerance, until);
      ASSERT_FALSE(flight.error()) << flight.error()->text();
      const Sample s = flight.at(kSteps * kStep);
      const BodyState b = world[ids[i]].state();
      EXPECT_EQ(b.position, s.position) << name(rung.integrator) << " " << name(rung.drag) << " " << name(rung.motion)
                                        << " " << name(rung.precision) << " " << i;
      EXPECT_EQ(b.velocity, s.velocity);
      if (HasFailure()) return;
    }
  }
}

}  // namespace physim::world_world_test
