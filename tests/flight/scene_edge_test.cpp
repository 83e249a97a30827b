// Flights that only touch an edge of a thing.
#include "scene_support.hpp"

namespace physim::flight_scene_edge_test {

using namespace test_scene;

/// A shot over the ridge of a roof touches it and goes on, as fast as it was; 0.1 m lower it strikes, 1 nm higher it
/// meets nothing. A sheet that stops whatever is slower than 200 m/s takes sqrt(300^2 - 200^2) m/s from what it lets.
TEST(Seam, a_shot_that_touches_a_ridge_goes_on) {
  const ConvexHullShape roof{{{-5, 0, -9}, {5, 0, -9}, {-5, 0, 9}, {5, 0, 9}, {0, 5, -9}, {0, 5, 9}}};
  MeshShape tent{.vertices = roof.points,
                 .triangles = {{0, 4, 1}, {2, 3, 5}, {0, 2, 4}, {2, 5, 4}, {1, 4, 3}, {3, 4, 5}, {0, 1, 2}, {1, 3, 2}}};
  const ProjectileDef bullet{.mass = 0.01};
  for (const ShapeDef& shape : {ShapeDef(roof), ShapeDef(tent)})
    for (const OnHit on_hit : {OnHit::impact, OnHit::stop, OnHit::bounce, OnHit::stick}) {
      Scene scene;
      put(scene, shape, {});
      Until until = meeting(scene, on_hit);
      until.time = 0.25;
      const auto shot = [&](double y) {
        return fly(bullet, {.position = {-50, y, 0}, .velocity = Vec3d{300, 0, 0}}, vacuum_of(0), rung(Integrator::rk4),
                   {}, until);
      };
      for (const double y : {5.0, 5.0 + 1e-9}) {
        const Flight over = shot(y);
        ASSERT_EQ(over.outcome(), Outcome::time_limit) << int(on_hit) << ' ' << y;
        EXPECT_NEAR(over.at(0.25).position.x, 25, 1e-7);
        EXPECT_EQ(over.at(0.25).velocity.x, 300);
        EXPECT_TRUE(of_kind(over, EventKind::hit).empty());
      }
      const auto hits = of_kind(shot(4.9), EventKind::hit);
      ASSERT_EQ(hits.size(), 1u);
      EXPECT_NEAR(hits[0].position.x, -0.1, 1e-9);
    }
}

}  // namespace physim::flight_scene_edge_test
