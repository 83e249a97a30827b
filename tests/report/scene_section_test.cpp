// Cuts through scenes, against boxes, planes and sheets of which they are known.
#include "report/scene_section.hpp"
#include "support.hpp"

#include <sstream>

namespace physim::report::report_scene_section_test {

using Row = std::vector<double>;

std::vector<Row> rows_of(const std::string& block) {
  std::vector<Row> rows;
  std::istringstream lines(block);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    Row row;
    for (double number = 0; numbers >> number;) row.push_back(number);
    rows.push_back(row);
  }
  return rows;
}

/// A straight track from the origin, over 20 m, to an azimuth towards z [rad].
std::vector<TrackPlace> track_to(double azimuth) {
  return {{0, 0, 0, 0}, {20, 20 * std::cos(azimuth), 20 * std::sin(azimuth), 2}};
}

TEST(SceneSection, OfABoxIsItsOutline) {
  for (const double azimuth : {0.0, 1.2, 3.0}) {
    Scene scene;
    const Quatd rotation{std::cos(azimuth / 2), 0, -std::sin(azimuth / 2), 0};
    const Vec3d position{10 * std::cos(azimuth), 0.5, 10 * std::sin(azimuth)};
    add_thing(scene, BoxShape{{1, 2, 3}}, {.transform = {.position = position, .rotation = rotation}});
    const Section section = section_along(scene, extended(track_to(azimuth), {-1, 22}), {-5, 5});
    const auto solids = rows_of(section.solids);
    ASSERT_GT(solids.size(), 60u);
    for (const Row& row : solids) {
      EXPECT_TRUE(row[0] >= 9 - 1e-6 && row[0] <= 11 + 1e-6) << row[0];
      EXPECT_NEAR(row[1], -1.5, 1e-6);
      EXPECT_NEAR(row[3], 4, 1e-6);
    }
    std::size_t upright = 0;
    for (const Row& row : rows_of(section.surfaces)) {
      const bool is_side = std::abs(std::abs(row[0] - 10) - 1) < 1e-5,
                 is_end = std::abs(std::abs(row[1] - 0.5) - 2) < 1e-5;
      EXPECT_TRUE(is_side || is_end) << row[0] << " " << row[1];
      upright += is_side;
    }
    EXPECT_GT(upright, 100u);  // both sides
  }
}

TEST(SceneSection, OfAPlaneGoesOnToTheLowerEdge) {
  Scene scene;
  add_thing(scene, PlaneShape{});
  const auto solids = rows_of(section_along(scene, extended(track_to(0), {0, 20}), {-5, 5}).solids);
  ASSERT_GT(solids.size(), 700u);
  for (const Row& row : solids) EXPECT_TRUE(row[1] == -5 && row[3] == 5);
  const auto below = rows_of(section_along(scene, extended(track_to(0), {0, 20}), {-5, -3}).solids);
  for (const Row& row : below) EXPECT_TRUE(row[1] == -5 && row[3] == 2);
  EXPECT_EQ(below.size(), solids.size());
}

TEST(SceneSection, OfASheetHasNoInside) {
  Scene scene;
  HeightFieldShape field{.columns = 2, .rows = 2, .spacing_x = 4, .spacing_z = 4, .heights = {1, 3, 1, 3}};
  add_thing(scene, field, {.transform = {.position = {6, 0, -2}}});
  const Section section = section_along(scene, extended(track_to(0), {0, 20}), {-5, 5});
  EXPECT_EQ(section.solids, "");
  const auto surfaces = rows_of(section.surfaces);
  ASSERT_GT(surfaces.size(), 100u);
  for (const Row& row : surfaces) EXPECT_NEAR(row[1], 1 + (row[0] - 6) / 2, 1e-5);
}

TEST(SceneSection, HasThingsWhereTheyAreWhenTheTrackPasses) {
  Scene scene;
  add_thing(scene, BoxShape{{1, 1, 1}},
            {.transform = {.position = {10, 0, 0}}, .motion = SteadyMotion{.velocity = {0, 1, 0}}});
  for (const Row& row : rows_of(section_along(scene, extended(track_to(0), {0, 20}), {-5, 5}).solids))
    EXPECT_NEAR(row[1], -1 + row[0] / 10, 1e-5);  // it passes x at x / 10
}

TEST(SceneSection, OfATrackThatGoesStraightUpIsThatOfItsFoot) {
  Scene scene;
  add_thing(scene, BoxShape{{1, 1, 1}});
  const std::vector<TrackPlace> track = {{0, 0, 0, 0}, {0, 0, 0, 1}};
  const auto solids = rows_of(section_along(scene, extended(track, {-1, 1}), {-5, 5}).solids);
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[0], (Row{0, -1, 0, 2}));
}

TEST(SceneSection, GoesOnStraightAtBothEnds) {
  const auto track = extended({{1, 1, 0, 3}, {2, 2, 0, 4}, {3, 2, 1, 5}}, {0, 6});
  EXPECT_NEAR(track.front().across, 0, 1e-12);
  EXPECT_NEAR(track.front().x, 0, 1e-12);
  EXPECT_EQ(track.front().time, 3);
  EXPECT_NEAR(track.back().x, 2, 1e-12);
  EXPECT_NEAR(track.back().z, 4, 1e-12);
  EXPECT_EQ(track.back().time, 5);
  for (std::size_t i = 1; i < track.size(); ++i) EXPECT_LT(track[i].across - track[i - 1].across, 6.0 / 799);
}

}  // namespace physim::report::report_scene_section_test
