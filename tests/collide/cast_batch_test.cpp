// Large batches, which are sorted: each segment gets the answer that it gets alone.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collide/scene_support.hpp"
#include "physim/task_runner.hpp"

namespace physim {
namespace {

using namespace test;

constexpr double kSide = 120;  // of the place [m]

HeightFieldShape hills() {
  HeightFieldShape field{.columns = 49, .rows = 41, .spacing_x = 2.5, .spacing_z = 3, .heights = {}};
  for (int i = 0; i < 49 * 41; ++i) field.heights.push_back(3 * std::sin(i * 0.7) + 4 * std::cos(i * 0.01));
  return field;
}

Transform somewhere(Random& r) {
  Transform t = random_transform(r, 0);
  t.position = {r.in(0, kSide), r.in(-3, 8), r.in(0, kSide)};
  return t;
}

/// Hills, large meshes turned and scaled, small ones, a heap, compounds, sensors, a plane
/// and what moves.
Scene crowd(Random& r) {
  Scene scene;
  const ShapeId hill = scene.add_shape(hills()).value(), large = scene.add_shape(ball(24, 0.2)).value();
  const ShapeId small = scene.add_shape(ball(3, 0)).value(), box = scene.add_shape(BoxShape{{1, 2, 0.3}}).value();
  const ShapeId two = scene.add_shape(CompoundShape{{{large, {.position = {1, 0, 0}}}, {box, {}}}}).value();
  const auto add = [&](const InstanceDef& def) { ASSERT_TRUE(scene.add(def)); };
  add({.shape = hill, .layers = 4});
  add({.shape = hill, .transform = {.position = {5, 1, kSide}, .rotation = {1, 0.1, 1, 0.05}, .scale = 0.7}});
  add({.shape = scene.add_shape(PlaneShape{}).value(), .transform = {.position = {0, -9, 0}}});
  for (int i = 0; i < 60; ++i) {
    InstanceDef def{.shape = std::array{large, small, box, two}[static_cast<std::size_t>(i) % 4],
                    .transform = somewhere(r)};
    def.transform.scale *= 3;
    def.layers = 1u << r.below(3);
    def.sensor = r.one_in(5);
    if (r.one_in(6)) def.motion = SteadyMotion{.velocity = r.vector(3)};
    add(def);
  }
  for (int i = 0; i < 40; ++i)
    add({.shape = i % 2 ? small : box, .transform = {.position = Vec3d{60, 5, 60} + r.vector(4)}});
  return scene;
}

void expect_same(const SceneHit& a, const SceneHit& b, std::size_t i) {
  ASSERT_EQ(a.instance, b.instance) << i;
  ASSERT_EQ(a.part, b.part) << i;
  ASSERT_EQ(a.primitive, b.primitive) << i;
  ASSERT_EQ(a.position, b.position) << i;
  ASSERT_EQ(a.normal, b.normal) << i;
  ASSERT_EQ(a.velocity, b.velocity) << i;
  ASSERT_EQ(a.time, b.time) << i;
  ASSERT_EQ(a.material, b.material) << i;
  ASSERT_EQ(a.entering, b.entering) << i;
  ASSERT_EQ(a.starts_inside, b.starts_inside) << i;
}

TEST(SceneBatch, batches_are_as_one_by_one) {
  Random r(31);
  const Scene scene = crowd(r);
  std::vector<SceneSegment> segments;
  for (int i = 0; i < 8000; ++i) {
    const Vec3d from{r.in(-9, kSide), r.in(-4, 12), r.in(-9, kSide)};
    SceneSegment s{from, from + r.vector(r.one_in(50) ? 200 : 8)};
    if (r.one_in(10)) s.to.x = s.from.x;
    if (r.one_in(10)) s.to.z = s.from.z;
    if (r.one_in(20)) s.to = s.from;
    if (r.one_in(3)) s.radius = r.in(0, 1);
    if (r.one_in(3)) s.duration = r.in(0, 2);
    segments.push_back(s);
  }
  segments[40].to.y = std::numeric_limits<double>::infinity();
  segments[41].radius = -1;
  segments[42].to.x = 1e14;
  std::vector<SceneHit> hits(segments.size()), lent(segments.size());
  const auto pool = make_thread_pool(3);
  for (const SceneFilter& filter : {SceneFilter{}, SceneFilter{.layers = 3, .sensors = false}}) {
    scene.first_hits(segments, hits, filter);
    scene.first_hits(segments, lent, filter, pool.get());
    int some = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const SceneHit one = scene.first_hit(segments[i], filter);
      some += one ? 1 : 0;
      expect_same(hits[i], one, i);
      expect_same(lent[i], one, i);
    }
    EXPECT_GT(some, 2000);
  }
}

/// Far from the origin, where a coordinate has few digits below the metre in float.
TEST(SceneBatch, batches_far_from_the_origin_are_as_one_by_one) {
  Random r(32);
  Scene scene;
  const Vec3d far{6.4e6, -2e6, 3e5};
  const ShapeId large = scene.add_shape(ball(40, 0.1)).value();
  for (int i = 0; i < 30; ++i) {
    Transform t = random_transform(r, 20);
    t.position += far;
    ASSERT_TRUE(scene.add({.shape = large, .transform = t}));
  }
  std::vector<SceneSegment> segments;
  for (int i = 0; i < 5000; ++i) segments.push_back(random_segment(r, far, 15));
  std::vector<SceneHit> hits(segments.size());
  scene.first_hits(segments, hits);
  for (std::size_t i = 0; i < segments.size(); ++i) expect_same(hits[i], scene.first_hit(segments[i]), i);
}

/// A land of so many triangles that it does not fit into the fast caches, with holes in it, and what stands on it.
Scene land(Random& r, int things) {
  constexpr std::uint32_t kPoints = 97;
  MeshShape mesh;
  for (std::uint32_t i = 0; i < kPoints * kPoints; ++i) {
    const double x = i % kPoints * 1.25, z = i / kPoints * 1.25;
    mesh.vertices.push_back({x, 4 * std::sin(0.2 * x) * std::cos(0.17 * z) + r.in(-0.3, 0.3), z});
    if (i % kPoints + 1 == kPoints || i + kPoints >= kPoints * kPoints || r.one_in(40)) continue;
    mesh.triangles.push_back({i, i + kPoints, i + 1});
    mesh.triangles.push_back({i + 1, i + kPoints, i + kPoints + 1});
  }
  Scene scene;
  const ShapeId ground = scene.add_shape(mesh).value(), small = scene.add_shape(ball(3, 0)).value();
  const auto add = [&](const InstanceDef& def) { ASSERT_TRUE(scene.add(def)); };
  add({.shape = ground, .layers = 2});
  add({.shape = ground, .transform = {.position = {40, 3, 9}, .rotation = {1, 0.2, 0.3, 0.1}, .scale = 0.4}});
  add({.shape = scene.add_shape(PlaneShape{}).value(), .transform = {.position = {0, -9, 0}}, .layers = 4});
  for (int i = 0; i < things; ++i) {
    InstanceDef def{.shape = i % 9 == 8 ? ground : small, .transform = somewhere(r), .layers = 1u << r.below(3)};
    if (i % 9 == 8) def.transform.scale = 0.05;
    if (r.one_in(9)) def.motion = SteadyMotion{.velocity = r.vector(3)};
    add(def);
  }
  return scene;
}

/// No large mesh, but too much for the fast caches: long batches are sorted.
Scene wide_hills(Random& r) {
  HeightFieldShape field{.columns = 401, .rows = 401, .spacing_x = 0.3, .spacing_z = 0.3, .heights = {}};
  for (int i = 0; i < 401 * 401; ++i)
    field.heights.push_back(3 * std::sin(i % 401 * 0.06) + 2 * std::cos(i * 0.0002) + r.in(-0.05, 0.05));
  Scene scene;
  const ShapeId hill = scene.add_shape(field).value(), small = scene.add_shape(ball(3, 0)).value();
  EXPECT_TRUE(scene.add({.shape = hill}));
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(scene.add({.shape = small, .transform = somewhere(r), .layers = 2}));
  return scene;
}

/// Of any length, as they come and sorted, with segments that come twice, into hits that hold something already, alone
/// and on threads.
TEST(SceneBatch, batches_of_any_length_are_as_one_by_one) {
  Random r(33);
  const auto pool = make_thread_pool(3);
  for (const Scene& scene : {land(r, 0), land(r, 6), land(r, 200), wide_hills(r)}) {
    ASSERT_GT(scene.bytes(), std::size_t{1} << 20);
    std::vector<SceneSegment> all;
    std::vector<SceneHit> alone;
    for (int i = 0; i < 2500; ++i) {
      const Vec3d from{r.in(-5, kSide), r.in(-4, 9), r.in(-5, kSide)};
      SceneSegment s{from, from + r.vector(r.one_in(40) ? 150 : 10)};
      if (r.one_in(4)) s.radius = r.in(0, 0.5);
      if (r.one_in(4)) s.duration = r.in(0, 2);
      if (r.one_in(30)) s.to = s.from;
      if (r.one_in(30)) s.radius = -1;
      all.push_back(s);
      alone.push_back(scene.first_hit(s, {.layers = 3}));
    }
    for (const std::size_t length : {0, 1, 2, 7, 8, 9, 40, 255, 256, 257, 1030, 2047, 2048, 6000}) {
      std::vector<SceneSegment> segments;
      std::vector<std::size_t> numbers;
      for (std::size_t i = 0; i < length; ++i) {
        numbers.push_back(i > 0 && r.one_in(5) ? numbers.back() : r.below(all.size()));
        segments.push_back(all[numbers.back()]);
      }
      SceneHit full;
      full.instance = {7, 7};
      full.part = 0.5;
      std::vector<SceneHit> hits(length + 1, full), lent = hits;
      scene.first_hits(segments, hits, {.layers = 3});
      scene.first_hits(segments, lent, {.layers = 3}, pool.get());
      for (std::size_t i = 0; i < length; ++i) {
        expect_same(hits[i], alone[numbers[i]], i);
        expect_same(lent[i], alone[numbers[i]], i);
      }
      EXPECT_EQ(hits[length].part, 0.5);  // behind the last one
      EXPECT_EQ(lent[length].part, 0.5);
    }
  }
}

}  // namespace
}  // namespace physim
