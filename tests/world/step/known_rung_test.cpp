// Rungs that the world's kernels know at compile time give the bits of the general path and of single flights.
#include <gtest/gtest.h>

#include "physim/names.hpp"
#include "physim/world.hpp"
#include "world/known_rungs.hpp"

namespace physim {
namespace world_known_rung_test {

std::vector<Fidelity> known_rungs() {
  std::vector<Fidelity> list = test::known_rungs();
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    list.push_back(Fidelity::arcade());
    list.back().precision = precision;
  }
  return list;
}

/// Projectiles with different curves, some of which pass from one layer of the air to the next.
ProjectileDef projectile(std::size_t i, const Fidelity& rung) {
  ProjectileDef p;
  p.mass = 0.01 + 0.001 * static_cast<double>(i);
  p.diameter = 0.00782;
  p.drag.table = i % 3 == 0 ? DragTable::g1 : DragTable::g7;
  p.drag.ballistic_coefficient = 150 + static_cast<double>(i);
  p.drag.damping = 0.9;
  p.drag.k1 = 0.001;
  p.drag.k2 = 0.00002;
  p.fidelity = rung;
  return p;
}

Launch launch(std::size_t i) {
  return {.position = {1.0 * static_cast<double>(i), i % 2 == 0 ? 100.0 : 10950.0, 3},
          .speed = 250.0 + 20 * static_cast<double>(i),
          .elevation = -0.3 + 0.03 * static_cast<double>(i),
          .azimuth = 0.1};
}

TEST(KnownRungs, agree_with_any_rung_and_with_flights) {
  constexpr double kStep = 1.0 / 64;
  constexpr int kSteps = 40;
  constexpr std::size_t kCount = 37;
  WorldDef def;
  def.environment.wind.velocity = {1, 0.2, -4};
  def.ground.mode = GroundMode::none;
  WorldDef general = def;
  general.apex_events = true;  // each step looks for more
  Until until;
  until.ground.reset();
  until.time = 10;
  Tolerance tolerance;
  tolerance.step = kStep;
  for (const Fidelity& rung : known_rungs()) {
    World world = std::move(World::create(def).value());
    World other = std::move(World::create(general).value());
    std::vector<ProjectileId> ids;
    for (std::size_t i = 0; i < kCount; ++i) {
      ids.push_back(*world.spawn(projectile(i, rung), launch(i)));
      ASSERT_EQ(*other.spawn(projectile(i, rung), launch(i)), ids.back());
    }
    ASSERT_EQ(world.cohorts().size(), 1u);
    for (int i = 0; i < kSteps; ++i) world.step(kStep), other.step(kStep);
    for (std::size_t i = 0; i < kCount; ++i) {
      const BodyState b = world[ids[i]].state();
      ASSERT_EQ(b, other[ids[i]].state()) << name(rung.drag) << " " << name(rung.wind) << " " << i;
      const Flight flight = fly(projectile(i, rung), launch(i), def.environment, rung, tolerance, until);
      ASSERT_FALSE(flight.error()) << flight.error()->text();
      const Sample s = flight.at(kSteps * kStep);
      ASSERT_EQ(b.position, s.position) << name(rung.drag) << " " << name(rung.wind) << " " << i;
      ASSERT_EQ(b.velocity, s.velocity);
    }
  }
}

}  // namespace world_known_rung_test
}  // namespace physim
