// Bodies are closed: where two touch, nothing goes between them, and what only touches an edge goes on.
#include <array>

#include "collide/scene_support.hpp"
#include "math/quat.hpp"
#include "support.hpp"

namespace physim::collide_seam_test {

using test::closed_box;
using test::Random;

void put(Scene& scene, const ShapeDef& shape, const Vec3d& position) {
  add_thing(scene, shape, {.transform = {.position = position}});
}
ConvexHullShape hull_box(const Vec3d& half) { return {closed_box(half).vertices}; }

/// A floor of 6 x 6 tiles of 1 m: 0 of its 25 inner corners and of 400 places on seams let a ray through.
TEST(Seam, a_floor_of_tiles_has_no_gap) {
  const Vec3d half{0.5, 0.5, 0.5};
  for (const ShapeDef& shape : {ShapeDef(BoxShape{half}), ShapeDef(hull_box(half)), ShapeDef(closed_box(half))}) {
    Scene floor;
    const ShapeId tile = *floor.add_shape(shape);
    for (int i = -3; i < 3; ++i)
      for (int k = -3; k < 3; ++k)
        ASSERT_TRUE(floor.add({.shape = tile, .transform = {.position = {i + 0.5, -0.5, k + 0.5}}}));
    Random r(3);
    for (int i = 0; i < 425; ++i) {
      const double x = i < 25 ? i % 5 - 2 : r.below(5) - 2, z = i < 25 ? i / 5 - 2 : r.in(-2.9, 2.9);
      const SceneHit hit = floor.first_hit({{x, 10, z}, {x, -10, z}});
      ASSERT_TRUE(hit) << x << ' ' << z;
      EXPECT_NEAR(hit.position.y, 0, 1e-14);
      EXPECT_TRUE(hit.entering && !hit.starts_inside);
    }
  }
}

/// Bodies side by side at random places and turns, at 0, 1 km and 1000 km: their places are rounded, so that there is
/// a gap or an overlap of some ulp between them. A point that comes down there is stopped by the upper side, whose
/// normal is up.
TEST(Seam, what_rounding_takes_apart_has_no_gap) {
  Random r(5);
  for (const double far : {0.0, 1e3, 1e6})
    for (int i = 0; i < 600; ++i) {
      const Quatd turn = i % 3 == 0 ? Quatd{1, 0, 0, 0} : normalized(test::random_transform(r, 1).rotation);
      const Vec3d origin = test::random_vector(r, far);
      const Vec3d one{r.in(0.1, 3), r.in(0.1, 1), r.in(0.5, 2)}, other{r.in(0.1, 3), r.in(0.1, 1), r.in(0.5, 2)};
      Scene scene;
      const auto add = [&](const ShapeDef& shape, const Vec3d& at) {
        add_thing(scene, shape, {.transform = {.position = origin + rotate(turn, at), .rotation = turn}});
      };
      add(i % 2 == 0 ? ShapeDef(BoxShape{one}) : ShapeDef(hull_box(one)), {-one.x, -one.y, 0});
      add(i % 5 == 0 ? ShapeDef(CylinderShape{other.x, other.y}) : ShapeDef(BoxShape{other}), {other.x, -other.y, 0});
      const double slope = r.one_in(2) ? 0 : std::pow(10.0, r.in(-16, 0)) * (r.one_in(2) ? 1 : -1);
      const Vec3d down = rotate(turn, normalized(Vec3d{slope, -1, 0}));
      const Vec3d on_seam = origin + rotate(turn, Vec3d{0, 0, i % 5 == 0 ? 0 : r.in(-0.4, 0.4)});
      const SceneHit hit = scene.first_hit({on_seam - down * 2, on_seam + down * 2});
      ASSERT_TRUE(hit) << far << ' ' << i << ' ' << slope;
      EXPECT_LT(length(hit.position - on_seam), (4e-15 + 3e-12 * (i % 2)) * (5 + far)) << far << ' ' << i;
      EXPECT_GT(dot(hit.normal, rotate(turn, Vec3d{0, 1, 0})), 1 - 1e-9) << far << ' ' << i << ' ' << slope;
    }
}

/// A ball that is smaller than what places are rounded to is stopped as a point is.
TEST(Seam, the_smallest_balls_do_not_pass_faces) {
  Random r(7);
  for (int i = 0; i < 400; ++i) {
    const Quatd turn = normalized(test::random_transform(r, 1).rotation);
    const Vec3d half{r.in(0.1, 3), r.in(0.1, 1), r.in(0.5, 4)};
    HeightFieldShape field{.columns = 3, .rows = 3, .spacing_x = half.x, .spacing_z = half.z};
    field.heights.assign(9, 0);
    const ShapeDef shapes[] = {closed_box(half), hull_box(half), BoxShape{half}, CylinderShape{half.x, half.y}, field};
    const int kind = i % 5;
    const Vec3d middle = kind == 4 ? Vec3d{-half.x, 0, -half.z} : Vec3d{0, -half.y, 0};
    Scene scene;
    add_thing(scene, shapes[kind], {.transform = {.position = rotate(turn, middle), .rotation = turn}});
    for (int k = 0; k < 200; ++k) {
      const double a = r.in(0, 6.28), part = 0.9 * half.x * r.in(0, 1);
      const Vec3d on = rotate(turn, kind == 3 ? Vec3d{part * std::cos(a), 0, part * std::sin(a)}
                                              : Vec3d{part, 0, half.z * r.in(-0.9, 0.9)});
      const Vec3d down = rotate(turn, normalized(Vec3d{r.in(-2, 2), -1, r.in(-2, 2)}));
      const double radius = std::pow(10.0, r.in(-18, -13)), high = r.in(0.01, 3);
      const SceneHit hit = scene.first_hit({on - down * high, on + down * r.in(0.01, 0.05), radius});
      ASSERT_TRUE(hit) << kind << ", radius " << radius;
      ASSERT_NEAR(dot(hit.position, rotate(turn, Vec3d{0, 1, 0})), 0, 2e-13) << kind << ", radius " << radius;
    }
  }
}

/// Cylinders that stand beside each other touch in a line; lying, end to end.
TEST(Seam, cylinders_touch_without_a_gap) {
  Scene scene;
  put(scene, CylinderShape{0.7, 0.5}, {-0.7, -0.5, 0});
  put(scene, CylinderShape{1.3, 0.5}, {1.3, -0.5, 0});
  EXPECT_NEAR(scene.first_hit({{0, 1, 0}, {0, -1, 0}}).position.y, 0, 1e-15);
  Scene pipe;
  const Quatd lies{std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
  const ShapeId part = *pipe.add_shape(CylinderShape{0.3, 1});
  for (const double x : {-1.0, 1.0}) ASSERT_TRUE(pipe.add({.shape = part, .transform = {{x, 0, 0}, lies}}));
  EXPECT_NEAR(pipe.first_hit({{0, 1, 0}, {0, -1, 0}}).position.y, 0.3, 1e-14);
}

/// What goes along a surface that it begins at meets nothing; what comes along it from beside meets the edge, as it
/// does of a mesh.
TEST(Seam, grazing_counts_the_same_in_box_hull_and_mesh) {
  const Vec3d half{1, 1, 1};
  for (const ShapeDef& shape : {ShapeDef(BoxShape{half}), ShapeDef(hull_box(half)), ShapeDef(closed_box(half))}) {
    Scene scene;
    put(scene, shape, {});
    EXPECT_TRUE(scene.first_hit({{-3, 1, 0.2}, {3, 1, 0.2}}));
    EXPECT_TRUE(scene.first_hit({{1, 3, 0.2}, {1, -3, 0.2}}));
    EXPECT_TRUE(scene.first_hit({{0, 2, 0.2}, {2, 0, 0.2}}));
    EXPECT_FALSE(scene.first_hit({{-3, 1 + 1e-9, 0.2}, {3, 1 + 1e-9, 0.2}}));
    EXPECT_FALSE(scene.first_hit({{0, 2 + 1e-9, 0.2}, {2, 1e-9, 0.2}}));
    EXPECT_FALSE(scene.first_hit({{0, 1, 0.2}, {0.5, 1, 0.2}}));
    EXPECT_FALSE(scene.first_hit({{0, 1, 0.2}, {0, 2, 0.2}}));
    EXPECT_TRUE(scene.first_hit({{0, 1, 0.2}, {0, 0.5, 0.2}}));
  }
}

}  // namespace physim::collide_seam_test
