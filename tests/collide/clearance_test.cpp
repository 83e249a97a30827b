// Clearance: a bound below the distance of whatever there is, which the exact answers must not undercut.
#include "collide/scene_support.hpp"
#include "support.hpp"

namespace physim::collide_clearance_test {

using namespace test;

HeightFieldShape hills(std::uint32_t columns, std::uint32_t rows) {
  HeightFieldShape field{.columns = columns, .rows = rows, .spacing_x = 0.5, .spacing_z = 0.7, .heights = {}};
  Random r(8);
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column)
      field.heights.push_back(3 * std::sin(0.2 * column) * std::cos(0.15 * row) + r.in(0, 0.3));
  return field;
}

/// A scene with some of everything, at rest.
Scene crowded(Random& r) {
  Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{{0.3, 0.6, 0.2}}).value();
  const ShapeId shapes[] = {
      box,
      scene.add_shape(SphereShape{0.5}).value(),
      scene.add_shape(CapsuleShape{0.2, 0.5}).value(),
      scene.add_shape(CylinderShape{0.4, 0.5}).value(),
      scene.add_shape(ball(8, 0.2)).value(),
      scene.add_shape(hills(37, 22)).value(),
      scene.add_shape(CompoundShape{{{box, random_transform(r, 1)}, {box, random_transform(r, 1)}}}).value()};
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(scene.add({.shape = shapes[i % 7], .transform = random_transform(r, 30)}));
  return scene;
}

TEST(SceneClearance, is_a_bound_between_half_of_the_distance_and_all_of_it) {
  Random r(41);
  const Scene scene = crowded(r);
  for (int i = 0; i < 4000; ++i) {
    const Vec3d p = r.vector(i % 2 == 0 ? 30 : 300);
    const double distance = scene.nearest(p).distance, bound = scene.clearance(p, kInfinity);
    ASSERT_LE(bound, distance) << i;
    ASSERT_GE(bound, 0.5 * distance * (1 - 1e-6) - 1e-12) << i;
    const double reach = r.in(0, 20);
    ASSERT_EQ(scene.clearance(p, reach), std::min(bound, reach)) << i;
    if (bound == 0) continue;
    // Nothing is met by what goes less far, in whatever direction.
    const Vec3d way = normalized(r.vector(1)) * (bound * (1 - 1e-9));
    ASSERT_FALSE(scene.any_hit({p, p + way})) << i;
  }
}

/// Spheres about a segment's points, near things and far from them.
TEST(SceneClearance, a_clear_part_ends_before_the_first_touch) {
  Random r(43);
  const Scene scene = crowded(r);
  int met = 0, close = 0;
  for (int i = 0; i < 50000; ++i) {
    SceneSegment s = random_segment(r, r.vector(30), 6);
    s.radius = r.one_in(4) ? 0 : r.one_in(2) ? r.in(0, 0.05) : r.in(0, 2);
    const double part = scene.clear_part(s);
    ASSERT_GE(part, 0) << i;
    ASSERT_LE(part, 1) << i;
    const SceneHit hit = scene.first_hit(s);
    if (!hit) continue;
    ASSERT_LE(part, hit.part) << i;
    ++met;
    // Beside an edge spheres count as larger than they are.
    if ((hit.part - part) * length(s.to - s.from) <= 2 * s.radius + 1e-9) ++close;
    if (part == 0) continue;
    SceneSegment before = s;
    before.to = s.from + (s.to - s.from) * (part * (1 - 1e-9));
    ASSERT_FALSE(scene.any_hit(before)) << i;
  }
  EXPECT_GT(met, 4000);
  EXPECT_GT(close, 0.9 * met);
}

TEST(SceneClearance, a_segment_that_touches_nothing_is_clear_all_along) {
  Random r(44);
  const Scene scene = crowded(r);
  int clear = 0, known = 0;
  for (int i = 0; i < 20000; ++i) {
    SceneSegment s = random_segment(r, r.vector(30), 6);
    s.radius = r.in(0, 0.1);
    if (scene.any_hit({s.from, s.to, 3 * s.radius + 0.1})) continue;
    ++clear;
    known += scene.clear_part(s) == 1;
  }
  EXPECT_GT(clear, 4000);
  EXPECT_GT(known, 0.99 * clear);
}

TEST(SceneClearance, a_clear_part_keeps_off_the_way_of_what_moves) {
  Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{{0.5, 0.5, 0.5}}).value();
  ASSERT_TRUE(scene.add({.shape = box,
                         .transform = {.position = {0, -10, 0}},
                         .layers = 2,
                         .motion = SteadyMotion{.velocity = {0, 5, 0}}}));
  const SceneSegment way{{-10, 0, 0}, {10, 0, 0}, 0.25};
  const auto clear = [&](double time, double duration, std::uint32_t layers = 2) {
    SceneSegment s = way;
    s.time = time, s.duration = duration;
    return scene.clear_part(s, {.layers = layers});
  };
  EXPECT_EQ(clear(0, 1.8), 1);
  EXPECT_NEAR(clear(0, 1.9), (10 - 0.75) / 20, 1e-12);  // it comes into the way when it has gone 9.25 m
  EXPECT_NEAR(clear(1.9, 0), (10 - 0.75) / 20, 1e-12);
  EXPECT_EQ(clear(0, 1.9, 1), 1);
  EXPECT_EQ(clear(2.2, 1), 1);
  EXPECT_EQ(scene.clear_part({{kNan, 0, 0}, {1, 0, 0}}), 0);
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(PlaneShape{}).value(), .layers = 2}));
  EXPECT_EQ(clear(0, 1), 0);  // it goes along the plane, nearer than its radius
}

TEST(SceneClearance, planes_and_filters_count) {
  Scene scene;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(PlaneShape{}).value(), .layers = 2}));
  EXPECT_NEAR(scene.clearance({3, 50, 0}, 1000), 50, 1e-11);
  EXPECT_LE(scene.clearance({3, 50, 0}, 1000), 50);
  EXPECT_EQ(scene.clearance({3, 50, 0}, 20), 20);
  EXPECT_EQ(scene.clearance({3, -1, 0}, 20), 0) << "inside";
  EXPECT_EQ(scene.clearance({3, 50, 0}, 1000, {.layers = 1}), 1000);
  EXPECT_EQ(scene.clearance({kNan, 0, 0}, 10), 0) << "nobody knows";
  EXPECT_EQ(scene.clearance({0, 5, 0}, kNan), 0);
  EXPECT_EQ(scene.clearance({0, 5, 0}, -1), 0);
  EXPECT_EQ(scene.clearance({0, 5, 0}, 10, {}, 2, 1), 0);
  EXPECT_EQ(scene.clearance({0, 5, 0}, 10, {}, kNan, kNan), 0);
  EXPECT_EQ(Scene().clearance({0, 5, 0}, 10), 10);
}

/// Of what moves: at no time between the two is anything nearer.
TEST(SceneClearance, holds_while_things_move) {
  Random r(43);
  Scene scene, covered;
  for (Scene* each : {&scene, &covered}) {
    Random same(44);
    const ShapeId shapes[] = {each->add_shape(BoxShape{{0.3, 0.6, 2}}).value(), each->add_shape(ball(5, 0.2)).value()};
    for (int i = 0; i < 12; ++i)
      ASSERT_TRUE(each->add({.shape = shapes[i % 2],
                             .transform = random_transform(same, 10),
                             .motion = SteadyMotion{0, same.vector(10), same.vector(i % 3 == 0 ? 0.0 : 5.0)}}));
    ASSERT_TRUE(each->add({.shape = each->add_shape(PlaneShape{}).value(),
                           .transform = {.position = {0, -20, 0}},
                           .motion = SteadyMotion{0, {0, 3, 0}, {0.3, 0, 0}}}));
  }
  int near = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = r.vector(20);
    const double from = r.in(-1, 1), to = from + (r.one_in(3) ? 0 : r.in(0, 0.5));
    const double bound = scene.clearance(p, 100, {}, from, to);
    ASSERT_TRUE(covered.cover(from - r.in(0, 1), to + r.in(0, 1)));
    ASSERT_EQ(covered.clearance(p, 100, {}, from, to), bound) << i;
    near += bound > 0 ? 1 : 0;
    for (int k = 0; k <= 40; ++k)
      ASSERT_GE(scene.nearest(p, kInfinity, {}, from + (to - from) * k / 40).distance, bound) << i;
    if (from == to) {
      ASSERT_GE(bound, 0.5 * scene.nearest(p, kInfinity, {}, from).distance * (1 - 1e-6) - 1e-12);
    }
  }
  EXPECT_GT(near, 400);
}

/// What came, went and moved before does not show.
TEST(SceneClearance, does_not_depend_on_how_the_scene_came_to_be) {
  Random r(45);
  Scene one, other;
  std::vector<Transform> places;
  for (int i = 0; i < 50; ++i) places.push_back(random_transform(r, 20));
  const ShapeId shape = one.add_shape(ball(4, 0.1)).value(), same = other.add_shape(ball(4, 0.1)).value();
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(one.add({.shape = shape, .transform = places[static_cast<std::size_t>(i)]}));
  std::vector<InstanceId> ids;
  for (int i = 49; i >= 0; --i) ids.push_back(*other.add({.shape = same, .transform = random_transform(r, 20)}));
  for (int i = 49; i >= 0; --i)
    ASSERT_TRUE(other.move(ids[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(i)]));
  for (int i = 0; i < 3000; ++i) {
    const Vec3d p = r.vector(40);
    ASSERT_EQ(one.clearance(p, 100), other.clearance(p, 100)) << i;
  }
}

}  // namespace physim::collide_clearance_test
