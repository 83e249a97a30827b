// Terrain on the ellipsoid, beside the figure of the Earth.
#include "support.hpp"

namespace physim::collide_terrain_test {

using namespace test;

/// Two degrees about a place, at a height, a point every 36 seconds of arc or so.
GeodeticGrid square_about(double latitude, double longitude, double height) {
  GeodeticGrid grid{.latitude = (latitude - 1) * kDegree,
                    .longitude = (longitude - 1) * kDegree,
                    .latitude_step = 0.01 * kDegree,
                    .longitude_step = 0.01 * kDegree,
                    .columns = 201,
                    .rows = 201,
                    .heights = {}};
  grid.heights.assign(201 * 201, height);
  return grid;
}

TEST(Terrain, falls_away_with_the_earth) {
  Environment environment{.earth = {.latitude = 45 * kDegree, .longitude = 7 * kDegree}};
  for (const double azimuth : {0.0, 180.0, 225.0}) {
    environment.earth.azimuth = azimuth * kDegree;
    const EarthFrames frames(environment, EarthModel::ellipsoid);
    for (const double height : {0.0, 2000.0}) {
      const auto mesh = must(terrain_mesh(square_about(45, 7, height), frames));
      Scene scene;
      ASSERT_TRUE(scene.add({.shape = scene.add_shape(mesh).value()}));
      const SceneHit here = scene.first_hit({{0, 9000, 0}, {0, -9000, 0}});
      EXPECT_NEAR(here.position.y, height, 0.1);
      EXPECT_GT(here.normal.y, 0.999) << "upwards is outwards";
      const SceneHit far = scene.first_hit({{100000, 9000, 0}, {100000, -9000, 0}});
      ASSERT_TRUE(far);
      EXPECT_NEAR(here.position.y - far.position.y, 785, 4) << "d^2 / 2 R";
      // Chords between points that lie 1 km apart sag by a^2 / 8 R.
      const double sag = 1112.0 * 1112 * 2 / 8 / 6.37e6;
      EXPECT_LE(frames.geodetic(far.position).height, height + 1e-6);
      EXPECT_GE(frames.geodetic(far.position).height, height - sag);
    }
  }
}

TEST(Terrain, what_is_no_grid_is_refused) {
  const EarthFrames frames(Environment{}, EarthModel::ellipsoid);
  const auto refusal = [&](auto change) {
    GeodeticGrid grid = square_about(10, 20, 0);
    change(grid);
    const auto mesh = terrain_mesh(grid, frames);
    return mesh ? std::string("none") : mesh.error().place;
  };
  EXPECT_EQ(refusal([](GeodeticGrid&) {}), "none");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.columns = 1; }), "grid.columns");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.rows = 1; }), "grid.rows");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.rows = g.columns = 1u << 20; }), "grid.columns");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.latitude = kNan; }), "grid.latitude");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.latitude = 89 * kDegree; }), "grid.latitude");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.latitude_step = -1; }), "grid.latitude_step");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.longitude_step = 1; }), "grid.longitude_step");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.longitude = 9; }), "grid.longitude");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.heights.pop_back(); }), "grid.heights");
  EXPECT_EQ(refusal([](GeodeticGrid& g) { g.heights[17] = kNan; }), "grid.heights[17]");
}

}  // namespace physim::collide_terrain_test
