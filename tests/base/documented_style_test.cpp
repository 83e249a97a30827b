// What the documentation writes, compiled with the warnings that users have: a designated initialiser may leave out any
// member of any public struct. `./dev lint` sees that each has a value of its own; the examples are compiled so too.
#if defined(__GNUC__)
#pragma GCC diagnostic error "-Wmissing-field-initializers"
#endif
#include <gtest/gtest.h>

#include "physim/physim.hpp"

namespace physim::base_documented_style_test {

TEST(DocumentedStyle, LeavesOutWhatHasADefault) {
  const ProjectileDef bullet{.mass = 0.01, .drag = {.table = DragTable::g7}, .inertia = {.moments = {1, 2, 3}}};
  const Launch launch{.speed = 100, .sight = {.height = 0.05}, .spin = {.backspin = 1}};
  const Environment environment{.altitude = 10, .atmosphere = {.humidity = 0.5}, .wind = {.velocity = {0, 0, -4}}};
  const Until until{.time = 1, .events = {{.kind = EventKind::apex}}};
  const Flight flight = fly(bullet, launch, environment, {.planar = true}, {.step = 0.01}, until);
  EXPECT_EQ(flight.outcome(), Outcome::landed);

  const Target target{.position = {50, 0, 0}};
  const AimOptions options{.tolerance = 0.1};
  const Purpose purpose{.error = 1};
  const FlightSetting setting{.fidelity = Fidelity::game()};
  EXPECT_FALSE(options.ground || purpose.ground);
  EXPECT_EQ(target.velocity, Vec3d{});
  EXPECT_EQ(setting.tolerance.step, 0);

#pragma GCC diagnostic push  // g++ 12 takes the clean-up behind an exception for a use
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
  const WorldDef def{.ground = {.mode = GroundMode::bounce},
                     .pools = {{.name = "shells"}},
                     .detail = {.rungs = {{.within = 10}, {.within = 20}}}};
#pragma GCC diagnostic pop
  const BodyDef body{.gravity_scale = 0.5, .despawn = {.below = -1}};
  const ForceDef force{.law = Spring{.stiffness = 3}, .target = {.layers = 1}};
  EXPECT_EQ(def.detail.rungs.size(), 2u);
  EXPECT_TRUE(body.label.empty());
  EXPECT_EQ(std::get<Spring>(force.law).other, ProjectileId{});
}

TEST(DocumentedStyle, ResultsArePointedInto) {
  Result<MaxRange> result = MaxRange{.range = 3};
  result->range = 4;  // an operator-> for what may be changed
  const Result<MaxRange>& constant = result;
  EXPECT_EQ(constant->range, 4);
  EXPECT_EQ((*result).range, 4);
}

}  // namespace physim::base_documented_style_test
