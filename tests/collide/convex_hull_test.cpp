// Convex hulls, beside all triangles of all points, and their casts beside a signed distance made of those.
#include <array>

#include "collide/quickhull.hpp"
#include "collide/reference.hpp"
#include "collide/scene_support.hpp"
#include "support.hpp"

namespace physim::collide_convex_hull_test {

using namespace test;
using collide::GridPoint;
using collide::HullTriangle;
using collide::kGridBits;
using collide::quickhull;

/// Faces by their definition: triangles of points that no point lies above.
struct AllTriangles {
  struct Face {
    Point at, normal;
    SignedDistance distance;
  };
  std::vector<Face> faces;

  explicit AllTriangles(const std::vector<Vec3d>& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j)
        for (std::size_t k = j + 1; k < points.size(); ++k) {
          const Point a = point(points[i]), b = point(points[j]), c = point(points[k]);
          const Point n = outer(b - a, c - a);
          if (norm(n) < 1e-9L) continue;
          for (const Real side : {1.0L, -1.0L}) {
            const Point normal = n * (side / norm(n));
            if (std::ranges::all_of(points, [&](const Vec3d& p) { return inner(normal, point(p) - a) < 1e-11L; }))
              faces.push_back({a, normal, distance_of_triangle(a, b, c)});
          }
        }
  }
  [[nodiscard]] Real signed_distance(const Point& p) const {
    Real above = -1e30L, least = 1e30L;
    for (const Face& face : faces) {
      above = std::max(above, inner(face.normal, p - face.at));
      least = std::min(least, face.distance(p));
    }
    return above <= 0 ? above : least;
  }
};

std::vector<Vec3d> random_points(Random& r, int kind) {
  std::vector<Vec3d> points;
  for (int i = 4 + r.below(8); i > 0; --i) {
    Vec3d p = r.vector(1);
    if (kind == 1) p = {double(r.below(3)), double(r.below(3)), double(r.below(3))};  // many in a plane, some twice
    if (kind == 2) p = normalized(p);
    points.push_back(p);
  }
  if (kind == 3)
    for (int i = 0; i < 5; ++i) points.push_back(points[0] + (points[1] - points[0]) * r.in(0, 1));
  return points;
}

TEST(ConvexHull, casts_agree_with_all_triangles_of_all_points) {
  Random r(51);
  int hits = 0, refused = 0;
  for (int round = 0; round < 120 && !HasFailure(); ++round) {
    const std::vector<Vec3d> points = random_points(r, round % 4);
    const AllTriangles reference(points);
    Scene scene;
    const auto shape = scene.add_shape(ConvexHullShape{points});
    if (!shape) {
      ++refused;
      EXPECT_EQ(shape.error().place, "shape.points");
      continue;
    }
    ASSERT_TRUE(scene.add({.shape = *shape}));
    for (int i = 0; i < 40; ++i) {
      SceneSegment s = random_segment(r, points[0], 1);
      s.radius = r.one_in(2) ? 0 : r.in(0.01, 0.5);
      const Point from = point(s.from), along = point(s.to) - from;
      const auto gap = [&](Real t) { return reference.signed_distance(from + along * t) - s.radius; };
      const Met met = first_zero(gap, norm(along));
      const SceneHit hit = scene.first_hit(s);
      if (static_cast<bool>(hit) != met.hit) {
        EXPECT_LT(std::fabs(met.least), 1e-11L) << round << " " << i;
        continue;
      }
      const double distance = scene.nearest(s.from).distance;
      EXPECT_NEAR(distance, std::max(0.0, static_cast<double>(reference.signed_distance(from))), 1e-11);
      EXPECT_EQ(scene.overlaps(s.from, distance * (1 + 1e-9) + 1e-9).size(), 1u);
      EXPECT_TRUE(distance < 1e-9 || scene.overlaps(s.from, distance * (1 - 1e-9)).empty());
      EXPECT_LE(scene.clearance(s.from, 1e9), distance);
      if (!hit || met.part == 0) continue;
      ++hits;
      EXPECT_LT(std::fabs(gap(hit.part)), 2e-11L) << round << " " << i;
      EXPECT_NEAR(length(hit.normal), 1, 1e-12);
      if (s.radius > 0) continue;
      const auto all = scene.all_hits(s);
      ASSERT_GE(all.size(), 1u);
      EXPECT_TRUE(all[0].entering);
      if (all.size() < 2) continue;
      EXPECT_FALSE(all[1].entering);
      EXPECT_LT(std::fabs(gap(all[1].part)), 2e-11L) << "it leaves at the surface";
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_LT(refused, 20);
}

/// Corners, edges and triangles of a closed surface of genus 0; no point lies above any triangle.
void expect_hull(const std::vector<GridPoint>& points, const std::vector<HullTriangle>& triangles) {
  std::vector<bool> corner(points.size(), false);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      corner[triangles[i].corner[edge]] = true;
      const HullTriangle& beyond = triangles[triangles[i].neighbour[edge]];
      bool joined = false;
      for (std::size_t other = 0; other < 3; ++other)
        joined =
            joined || (beyond.neighbour[other] == i && beyond.corner[other] == triangles[i].corner[(edge + 1) % 3] &&
                       beyond.corner[(other + 1) % 3] == triangles[i].corner[edge]);
      ASSERT_TRUE(joined) << i;
    }
    for (const GridPoint& p : points) ASSERT_LE(height_above(triangles[i], points, p), 0) << i;
  }
  const auto corners = std::ranges::count(corner, true);
  EXPECT_EQ(
      corners + static_cast<std::ptrdiff_t>(triangles.size()) - static_cast<std::ptrdiff_t>(triangles.size()) * 3 / 2,
      2);
}

TEST(ConvexHull, is_exact_on_its_grid) {
  Random r(53);
  for (int round = 0; round < 200 && !HasFailure(); ++round) {
    std::vector<GridPoint> points;
    const std::int64_t most = round % 2 == 0 ? 3 : (std::int64_t{1} << kGridBits) - 1;
    for (int i = 0; i < 5 + round; ++i) {
      GridPoint p;
      for (std::int64_t& x : p)
        x = std::clamp(static_cast<std::int64_t>(r.in(-1, 1) * (static_cast<double>(most) + 0.5)), -most, most);
      if (round % 3 == 0) p[2] = p[0] / 2 + (i == 0 ? 1 : 0);  // all but one nearly in a plane
      points.push_back(p);
    }
    const auto triangles = quickhull(points);
    if (!triangles) continue;
    expect_hull(points, *triangles);
  }
  std::vector<GridPoint> grid;  // a cube of points: its corners alone remain
  for (int i = 0; i < 1000; ++i) grid.push_back({i % 10, i / 10 % 10, i / 100});
  const auto cube = must(quickhull(grid));
  EXPECT_EQ(cube.size(), 12u);
  EXPECT_FALSE(quickhull(std::vector<GridPoint>(9, GridPoint{1, 2, 3})));
}

/// Tetrahedra of a sixth of a cell, the least that a grid has: their edges are columns of matrices of determinant 1.
TEST(ConvexHull, the_smallest_bodies_of_its_grid_are_held) {
  Random r(59);
  for (int round = 0; round < 200 && !HasFailure(); ++round) {
    std::vector<GridPoint> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int shear = 0; shear < round / 20; ++shear) {
      const auto to = static_cast<std::size_t>(r.below(3)), from = (to + 1 + static_cast<std::size_t>(r.below(2))) % 3;
      const std::int64_t by = r.below(7) - 3;
      for (GridPoint& p : points) p[to] += by * p[from];
    }
    for (std::size_t i = 3; i > 0; --i) std::swap(points[i], points[static_cast<std::size_t>(r.below(int(i) + 1))]);
    const auto triangles = must(quickhull(points), round);
    EXPECT_EQ(triangles.size(), 4u);
    expect_hull(points, triangles);
  }
}

TEST(ConvexHull, a_box_of_corners_is_met_as_a_box) {
  Random r(55);
  Scene hulls, boxes;
  ConvexHullShape corners;
  for (int i = 0; i < 8; ++i) corners.points.push_back({i & 1 ? 0.5 : -0.5, i & 2 ? 0.25 : -0.25, i & 4 ? 2.0 : -2.0});
  corners.points.push_back({0.1, 0.2, -0.3});
  corners.points.push_back(corners.points[3]);
  const auto hull = hulls.add_shape(corners), box = boxes.add_shape(BoxShape{{0.5, 0.25, 2}});
  ASSERT_TRUE(hull && box);
  EXPECT_EQ(hulls.info(*hull)->triangles, 12u);
  ASSERT_TRUE(hulls.add({.shape = *hull}));
  ASSERT_TRUE(boxes.add({.shape = *box}));
  for (int i = 0; i < 5000; ++i) {
    SceneSegment s = random_segment(r, {}, 1);
    s.radius = r.one_in(2) ? 0 : r.in(0, 0.4);
    const SceneHit a = hulls.first_hit(s), b = boxes.first_hit(s);
    ASSERT_EQ(static_cast<bool>(a), static_cast<bool>(b)) << i;
    EXPECT_NEAR(a.part, b.part, 1e-13) << i;
    EXPECT_TRUE(near(a.normal, b.normal, 1e-9, 1e-9)) << i;
    EXPECT_EQ(hulls.all_hits(s).size(), boxes.all_hits(s).size());
  }
}

TEST(ConvexHull, many_points_far_from_the_origin_are_held) {
  Random r(57);
  ConvexHullShape shape;
  for (int i = 0; i < 3000; ++i) shape.points.push_back(Vec3d{1e6, -2e6, 3e6} + normalized(r.vector(1)) * 5);
  Scene scene;
  const auto hull = must(scene.add_shape(shape));
  EXPECT_GT(scene.info(hull)->triangles, 5000u) << "nearly all of a ball's points are corners";
  ASSERT_TRUE(scene.add({.shape = hull}));
  for (int i = 0; i < 300; ++i) EXPECT_LT(scene.nearest(shape.points[static_cast<std::size_t>(i)]).distance, 1e-8);
}

TEST(ConvexHull, what_is_none_is_refused) {
  Scene scene;
  const auto place = [&](std::vector<Vec3d> points) {
    const auto id = scene.add_shape(ConvexHullShape{std::move(points)});
    return id ? std::string("none") : id.error().place;
  };
  EXPECT_EQ(place({}), "shape.points");
  EXPECT_EQ(place({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "shape.points");
  EXPECT_EQ(place({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}}), "shape.points") << "a plane";
  EXPECT_EQ(place({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), "shape.points") << "a line";
  EXPECT_EQ(place(std::vector<Vec3d>(7, {1, 2, 3})), "shape.points") << "a place";
  EXPECT_EQ(place({{0, 0, 0}, {1, 0, 0}, {0, kNan, 0}, {0, 0, 1}}), "shape.points[2]");
  EXPECT_EQ(place({{0, 0, 0}, {1, 0, 0}, {0, 1e16, 0}, {0, 0, 1}}), "shape.points[2]");
  EXPECT_EQ(place({{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}, {0, 0, 1e-300}}), "shape.points");
  EXPECT_EQ(place({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-9}}), "none") << "thin, and a body";
}

}  // namespace physim::collide_convex_hull_test
