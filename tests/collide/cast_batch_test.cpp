// Large batches, which are sorted: each segment gets the answer that it gets alone.
#include <limits>

#include "collide/crowd_support.hpp"

namespace physim::collide_cast_batch_test {

using namespace test;
using namespace test_crowd;

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
      SceneHit full{.part = 0.5, .instance = {7, 7}};
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

}  // namespace physim::collide_cast_batch_test
